/* Where patches begin and end, and how they are joined.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_ENVELOPE_PATCH_ENDS_H
#define GRAZE_QUESTIONS_ENVELOPE_PATCH_ENDS_H

#include "questions/envelope/sign_events.h"

/* The times at which something may change, in order: ends of the motion, breaks, events. */

/** @param[out] out uninitialised; moments_clear in any case */
graze_status moments_make(moment_list *out, graze_context *context, const graze_envelope *e);
void moments_clear(moment_list *list);

/** A rational time between two moments, from < to, at which the motion is smooth. */
graze_status moments_between(fmpq_t out, graze_context *context, const moment_list *list,
                             size_t from, size_t to);

/* Connected parts of a curve. */

/** Set chain and form of all parts (E^3). */
graze_status chains_find(graze_curve *c, graze_context *context, const cell_complex *cells);

/* Makes the cells of a boundary. */

/** @param[out] out uninitialised; complex_clear in any case */
graze_status complex_make(cell_complex *out, graze_context *context, const graze_solid *solid);
void complex_clear(cell_complex *c);

/**
 * The curve at a time of the motion that is neither an end nor a break.
 * Its parts have no verdict and no chain.
 * @param[out] out uninitialised; contact_curve_clear after GRAZE_OK
 * @return GRAZE_EINPUT the time is not such a one
 */
graze_status contact_curve_find(graze_curve *out, graze_context *context, const graze_envelope *e,
                                const fmpq_t t);

/* Conditions for an envelope to decompose (proofs/events.md C81 to C83). */

static const graze_cell NO_CELL = {0, 0, 0};

/** Would a finding with this reason take the place of the one that decides so far? */
int judge_wants(const graze_envelope *e, graze_decomposable_reason reason);

/** A finding at a point of a piece's parameter. @param facet, cell borrowed */
graze_status judge_find(graze_envelope *e, graze_context *context, graze_decomposable_reason reason,
                        const graze_cell *facet, const graze_cell *cell, size_t piece,
                        const algebraic *u);
/** A finding before point k of an axis. */
graze_status judge_find_before(graze_envelope *e, graze_context *context,
                               graze_decomposable_reason reason, const graze_cell *facet,
                               const graze_cell *cell, size_t piece, const axis *x, size_t k);

/** Is point k of an axis a time before and after which the motion is one function? */
int judge_is_inner(const graze_envelope *e, size_t piece, const axis *x, size_t k);
/** Is it the common end of two different pieces? */
int judge_is_break(const graze_envelope *e, size_t piece, const axis *x, size_t k);

/** Does g of a facet vanish on all of it, on all of the motion? */
int judge_is_still(const graze_envelope *e, size_t facet);

/* The edges of a boundary by position, cut where parts touch. */

/** Fill `edge` but for names and kinds, and append crossings of edges to the vertices' positions.
 * Facets, corners and positions of the solid's vertices are there. */
graze_status edges_find(cell_complex *c, graze_context *context);

/* Events and findings of facets, edges and vertices, each by the speeds at its ends. */

/** `reach` at a vertex of a facet, and `cusp` where the slice ends at it all the time. */
graze_status gather_corner(graze_envelope *e, graze_context *context, size_t facet, size_t vertex);
/** `theta` and `turn` where the slice of a facet ends on an edge in it; in E^2 the slice itself. */
graze_status gather_slice(graze_envelope *e, graze_context *context, size_t facet, size_t edge);
/** `meet` of two facets of an edge; whether a slice of either crosses it, if it is reflex. */
graze_status gather_meet(graze_envelope *e, graze_context *context, size_t edge, size_t first,
                         size_t second);

/* Patches that meet, where and when. */

/** Find the joints of patches that are complete (proofs/events.md C85). */
graze_status joints_find(graze_patches *p, graze_context *context);

/* Where patches end: vertices, and points of edges where g of a facet vanishes. */

/** A place where a patch ends: a vertex; a point within an edge where g of `facet` vanishes; or,
 * with the facet SIZE_MAX, all of an edge. */
typedef struct patch_place {
    int is_edge;
    size_t cell, facet, patch;
} patch_place;

/** Vertices before edges, both by number, then patches; each pair of place and patch once. */
typedef struct place_list {
    size_t count, capacity;
    patch_place *item;
} place_list;

/** @param[out] out zeros; place_list_clear in any case */
graze_status places_make(place_list *out, graze_context *context, const graze_patches *p);
void place_list_clear(place_list *list);
/** The index of the first place of a cell, or where it would stand. */
size_t places_first(const place_list *list, int is_edge, size_t cell);

/** Add a patch to those that meet. */
graze_status members_add(numbers *set, graze_context *context, size_t patch);

/** Add a joint of the patches in a set, which is in order. */
graze_status joint_add(graze_patches *p, graze_context *context, const graze_cell *cell,
                       graze_chain_form form, size_t from, size_t to, const numbers *set);

/* Patches that meet at a moment. */

/** Add the joints at moments within the motion: of patches that begin or end then, by the limits of
 * the places where they end, with those that go on there (proofs/events.md C85). */
graze_status limits_find(graze_patches *p, graze_context *context, const place_list *places);

/* Velocities of all points of the body at one time. */

/** c' and c'' of the trajectory through y are matrices of d rows and d + 1 columns applied to (y,
 * 1), times positive numbers. */
typedef struct snapshot {
    const graze_envelope *e;
    int dimension;
    fmpq_t t;
    fmpq *velocity, *bend;
} snapshot;

/** @param[out] out uninitialised; snapshot_clear in any case
 * @return GRAZE_EINPUT the time is not within the motion, or is a break of it */
graze_status snapshot_make(snapshot *out, graze_context *context, const graze_envelope *e,
                           const fmpq_t t);
void snapshot_clear(snapshot *s);

/** g of a facet at a point of the body times a positive number, the same for all points. */
void snapshot_g(fmpq_t out, const snapshot *s, size_t facet, const fmpq *y);
int snapshot_g_sign(const snapshot *s, size_t facet, const fmpq *y);
/** The sign of theta. */
int snapshot_theta_sign(const snapshot *s, size_t facet, const fmpq *y);

/** Where a function that is `a` at p and `b` at q, of different signs, vanishes between them. */
void snapshot_zero(fmpq *out, const fmpq_t a, const fmpq_t b, const fmpq *p, const fmpq *q, int d);

/* The contact points of facets, edges and vertices at one time, cell by cell. */

/** Add the slice of a facet within its relative interior; or the whole facet, if g = 0 on it. */
graze_status parts_of_facet(graze_curve *c, graze_context *context, const snapshot *s,
                            size_t facet);
/** Add the runs of an edge and the single contacts in its relative interior (E^3). */
graze_status parts_of_edge(graze_curve *c, graze_context *context, const snapshot *s, size_t edge);
/** Add a vertex if it is a contact. */
graze_status parts_add_vertex(graze_curve *c, graze_context *context, const snapshot *s,
                              size_t vertex);
/** Add a vertex if it is a contact and no end of a part that is there. */
graze_status parts_of_vertex(graze_curve *c, graze_context *context, const snapshot *s,
                             size_t vertex);

/** Classify the middle of a part at time t.
 * @param[out] body d rationals: the middle
 * @param[out] world as many: its place among the query points; or NULL */
graze_status parts_look_at_middle(graze_trim *trim, graze_orientation *orientation, fmpq *body,
                                  fmpq *world, graze_context *context, const graze_envelope *e,
                                  const curve_part *part, const fmpq_t t);

/** Is a point in the facet, its border included? */
int parts_facet_holds(const cell_complex *c, size_t facet, const fmpq *at);
/** Is a point of a simplex's plane, d + 1 homogeneous integers, in the simplex? `plane`: of
 * solid_plane. */
int parts_simplex_holds(const cell_complex *c, size_t simplex, const fmpz *plane, const fmpz *x);
/** Have two triangles of a facet both of these vertices as corners: a side within the facet? */
int parts_side_is_inner(const cell_complex *c, size_t facet, size_t a, size_t b);

#endif
