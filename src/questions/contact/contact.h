/* contact: a boundary point of the solid at a time, its role for the envelope, and its trajectory.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_CONTACT_H
#define GRAZE_QUESTIONS_CONTACT_H

#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "graze/contact.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"

/* A boundary point of a solid: the facets that contain it, by position, and what the solid is like
 * near it. */

/** Kinds of the solid's local cone at a point (proofs/envelope.md C57): a half-space; else convex;
 * with a convex complement; none of these. */
typedef enum place_kind { PLACE_FACET, PLACE_CONVEX, PLACE_REFLEX, PLACE_OTHER } place_kind;

/** A facet that contains the point; a facet that is not planar counts once for each of its planes
 * through the point. */
typedef struct place_facet {
    graze_cell name; /* a face; in E^2 an edge */
    size_t simplex;  /* a simplex of the facet, in this plane, that contains the point */
    fmpz *form;   /* the plane's form, positive on the outer side: d + 1 coprime integers, room 4 */
    fmpz *normal; /* the form's first d coefficients, divided by their common divisor, room 3 */
} place_facet;

/** A boundary point's neighborhood. `cell` is the cell of the least dimension that contains the
 * point; among several, that with the least numbers. */
typedef struct neighborhood {
    int dimension;
    place_kind kind;
    graze_cell cell;
    size_t count, capacity;
    place_facet *facet; /* in the order of names */
} neighborhood;

/** Find the neighborhood of a point of d rationals. `count` is 0 if the point is not on the
 * boundary.
 * @param[out] out uninitialised; the caller calls neighborhood_clear in any case */
graze_status neighborhood_locate(neighborhood *out, graze_context *context,
                                 const graze_solid *solid, const fmpq *point);
void neighborhood_clear(neighborhood *p);

/* Derivatives of trajectories at a rational time, from those of the motion. */

/**
 * For M = A x + b and a body point y, by the motion's parameter t: with V = A'y + b', `w` is -A^-1
 * V, which is c' for the trajectory c of the point P = M(t) y, `bend` is c'', and `drift` is the
 * derivative of A^-1 V at fixed y. Each is an affine map of y: d rows of d + 1 integers, and
 * behind these their common denominator, positive. `orientation` is the sign of det A.
 */
typedef struct flow {
    int dimension, orientation;
    fmpz *w, *bend, *drift;
} flow;

/** The derivative of a point map of the given order at u, times a power of u's denominator that is
 * one for all orders: (d + 1) * (d + 1) integers, the weight's row last. */
void map_rows(fmpz *out, const point_map *map, const fmpq_t u, int order);
/** out = a b; the rows of all three are `size` long, and of those of a `inner` entries count. */
void rows_multiply(fmpz *out, const fmpz *a, const fmpz *b, int rows, int inner, int size);

/** Make the flow at the parameter u of a piece (proofs/envelope.md C58). */
void flow_init(flow *out, const motion_piece *piece, const fmpq_t u);
/** Clear a flow; one of zeros is left. */
void flow_clear(flow *f);

/** The inner product of an integer normal and the value of a flow's map at y. */
void flow_along(fmpq_t out, const fmpz *normal, const fmpz *map, const fmpq *y, int dimension);

/* Record of a site. */

/** A side of the time t: the motion's piece there, and the parameter u of t in it. `present` is 0
 * for a side beyond an end of the motion. If one piece is on both sides, only the side after t has
 * its flow made, which holds for both. */
typedef struct site_side {
    int present;
    size_t piece;
    fmpq *u;
    flow flow;
} site_side;

/** A facet through y on one side of t, with its primitive outward normal: `speed` is g, `drift` is
 * g's derivative by t at fixed y, `theta` the second derivative by t of the pullback of its plane.
 * `order` is that of the pullback's zero at t, `sign` the pullback's sign next to t on the side; if
 * it vanishes identically, GRAZE_ORDER_VANISHES and 0. */
typedef struct site_germ {
    size_t facet; /* its index in place.facet */
    int side;     /* -1 before t, +1 after it */
    fmpq_t speed, drift, theta;
    int order, sign;
} site_germ;

/** Sides before and after t. Germs stand facet by facet, before t first. `is_break`: two different
 * pieces meet at t. `near` and `near_in` are the times of graze_site_near and graze_site_near_in:
 * NULL, `itself` or a time of the trace. `shift` is set if `snapped` and not `missed`. If `missed`,
 * the cell in `facts` has no contact at t, and besides that cell only t, y, world and the sides are
 * set. */
struct graze_site {
    const graze_scene *scene;
    int dimension, is_break;
    neighborhood place;
    site_side side[2];
    fmpq_t t;
    fmpq *y, *world; /* the u of both sides stand behind these */
    size_t germ_count;
    site_germ *germ;
    graze_trace trace;
    graze_time *itself;
    const graze_time *near, *near_in;
    graze_site_facts facts;
    int snapped, missed;
    fmpq_t shift;
};

/* A site: a boundary point y of the solid at a rational time t, and what it is for the envelope. */

/**
 * Make the site at a body point y and a time t (proofs/envelope.md C59 to C63).
 * @param[out] out uninitialised; site_clear after GRAZE_OK
 * @param y d rationals
 * @return GRAZE_EINPUT t is not a time of the motion, or y is not on the boundary; GRAZE_ELIMIT;
 * GRAZE_ECANCELED; GRAZE_ESYSTEM; GRAZE_EINTERNAL
 */
graze_status site_make(graze_site *out, graze_context *context, const graze_scene *scene,
                       const fmpq_t t, const fmpq *y);
/** Parts of a site that a caller asks for: all; its role; trim, orientation and the states beside
 * t. */
typedef enum site_question { SITE_ALL, SITE_ROLE, SITE_TRIM } site_question;

/** As site_make, but only the place, the sides, the germs, the point in the world and the part
 * asked for are sure to be set. site_clear after GRAZE_OK. */
graze_status site_make_for(graze_site *out, graze_context *context, const graze_scene *scene,
                           const fmpq_t t, const fmpq *y, site_question asked);

/**
 * Make the site at the point of a cell's contact set that is nearest to y (proofs/snap.md C75).
 * @param[out] out uninitialised; site_clear after GRAZE_OK; `missed` if the cell has no contact at
 * t
 * @return as site_make and snap_find; y need not be on the boundary
 */
graze_status site_snap(graze_site *out, graze_context *context, const graze_scene *scene,
                       const fmpq_t t, const fmpq *y, const graze_cell *cell);
/** Carry a point P of d rationals to M(t)^-1 P, in place. GRAZE_EINPUT: t is not a time of the
 * motion. */
graze_status site_to_body(fmpq *point, graze_context *context, const graze_scene *scene,
                          const fmpq_t t);

void site_clear(graze_site *site);

/* The sides of a rational time of a motion. */

/** Do two different pieces meet between the sides? Pieces of one rational function count as one. */
int sides_break(const site_side side[2], const graze_motion *motion);

#endif
