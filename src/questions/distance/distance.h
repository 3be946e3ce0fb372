/* distance: an enclosure of a point's signed distance to the sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_DISTANCE_H
#define GRAZE_QUESTIONS_DISTANCE_H

#include "decide/bounds/bounds.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"

/* The signed distance of a point to the sweep or unsweep, enclosed (proofs/semantics.md 8). */

/** low <= s <= high for the signed distance s; the bounds have the sign of the point's exact answer
 * (proofs/distance.md C66, C67). */
typedef struct distance {
    double low, high;
    int wide; /* high - low is more than was asked for */
    /* A time that proves one of the bounds: parameter from + length v of the piece, exactly; or, if
     * not NULL, `at`, a contact's time, borrowed from the trace: of the first contact of an `on`
     * point, or of a contact that ends a visit in which no double is certain to lie. */
    size_t piece;
    double from, length, v;
    const graze_time *at;
} distance;

/**
 * Enclose the signed distance of a point.
 * @param point d rationals
 * @param trace of the point, with its contacts' times
 * @param tolerance positive and finite: the width that is wanted
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
graze_status distance_find(distance *out, graze_context *context, const graze_scene *scene,
                           const fmpq *point, const graze_trace *trace, double tolerance);

/** Classify a point, and enclose its signed distance as distance_find does; `out->at` is NULL. */
graze_status distance_at(distance *out, graze_pmc *pmc, graze_context *context,
                         const graze_scene *scene, const fmpq *point, double tolerance);

/** 1 if every motion within `motion_error` of this one gives the point the same answer
 * (proofs/distance.md C73). */
int distance_is_certain(const distance *found, double motion_error);

/** The time from + length v of an `in` or `out` point, in the motion's parameter; `at` must be
 * NULL. */
void distance_time(fmpq_t out, const distance *found, const graze_motion *motion);

/** A rational near a contact's time: the time itself if it is rational, else a number at most 2^-60
 * of its piece's length from it. */
graze_status distance_contact_time(fmpq_t out, graze_context *context, const graze_time *time);

/** The double nearest to the time of a distance, of an `on` point too, in the motion's parameter.
 */
graze_status distance_time_near(double *out, graze_context *context, const distance *found,
                                const graze_motion *motion);

/* Data of a scene for distances, beside its filter: the maps that place the solid, in doubles, and
 * which pieces are rigid. */

/**
 * A part of a piece on which no weight varies much, so that rounding errors are small everywhere:
 * of most motions the whole piece. The arc's parameter v runs from 0 to 1, the piece's parameter is
 * from + length v, with `from` and `length` dyadic and exact.
 */
typedef struct arc {
    size_t piece;
    double from, length;
    int rigid; /* 1: the map from the space of query points to the solid's space keeps distances */
    carrier tracing; /* the tracing map on the arc; empty if the arc is the whole piece: the filter
                        has its map */
    carrier placing; /* the map of motion_placing on the arc; set only if not rigid */
} arc;

/** The arcs of a scene, which owns them; immutable once made, but for the tree. */
typedef struct arc_maps {
    const graze_scene *scene;
    const course *whole; /* the filter's */
    size_t arc_count, arc_capacity;
    arc *arc;         /* in the order of time */
    size_t *first;    /* by piece: the index of its first arc; at the end the number of arcs */
    ulong deepest;    /* the shortest arc is 2^-deepest of its piece */
    scene_memo *tree; /* the arc_tree, made at the first call of arc_tree_of */
} arc_maps;

/* A point's trajectory on an interval of an arc, in Bernstein form with a bound of its errors. */

/** Room for the coefficients of one polynomial, and for the polynomials of a map. */
enum { WINDOW_ROOM = CARRIER_DEGREE + 1, WINDOW_MAPS = POINT_MAP_ENTRIES + 1 };

/** The trajectory of a query point on one arc: the coefficients of X_0 ... X_(d-1), W on [0, 1].
 * Those of X are within error_x of the exact ones and at most size_x in absolute value, those of W
 * within error_w and at most size_w. */
typedef struct point_arc {
    const arc_maps *base;
    size_t arc;
    int dimension, degree, rigid;
    double point[3], point_error; /* the point in doubles, each coordinate within point_error */
    double x[4][WINDOW_ROOM];
    double error_x, size_x, error_w, size_w;
} point_arc;

/**
 * The trajectory c = X / W on [from, to], and where the piece is not rigid the maps themselves.
 * Degree 0 and from = to: an instant. Bounds: proofs/distance.md C68.
 */
typedef struct window {
    const point_arc *of;
    double from, to;
    int degree;
    double x[4][WINDOW_ROOM];
    double most_w; /* bound of the errors of W's coefficients */
    double least;  /* W is at least this; positive */
    double stray; /* X - q W errs by at most this in each coordinate, for a place q that is known up
                     to the corners' error and rounding */
    int place_degree;              /* this and all below: only for a piece that is not rigid */
    double linear[9][WINDOW_ROOM]; /* the linear part of the tracing map, times W */
    double place[WINDOW_MAPS][WINDOW_ROOM]; /* the placing map, its weight last */
    double place_stray, place_least, place_most_w, linear_stray;
} window;

/* How far a point is at least from where the membership changes. */

/**
 * A lower bound of a point's distance from the boundary of the sweep: all points that are nearer to
 * the point than `low` have its membership. 0 where no bound is proved, and for an `on` point
 * (proofs/judging.md C120).
 * @param found the distance of the point, whose answer is `pmc`
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
graze_status distance_to_boundary(double *low, graze_context *context, const graze_scene *scene,
                                  const fmpq *point, graze_pmc pmc, const distance *found);

/* The size of a scene, which relative tolerances are relative to. */

/** The diagonal of the box around the solid at the motion's start, rounded down.
 * @return GRAZE_ELIMIT the diagonal is not from 2^-300 to 2^300; GRAZE_ECANCELED */
graze_status distance_diagonal(double *out, graze_context *context, const graze_scene *scene);

/* The place of a simplex nearest to the query point at an instant, and the direction between them:
 * good guesses, which the bounds of gap.h make certain. */

/** The solid at an instant, seen from the query point. */
typedef struct stance {
    window at;   /* the instant */
    double c[3]; /* the trajectory */
    int rigid, dimension;
    double linear[9]; /* the placing map's linear part, if not rigid */
} stance;

typedef struct foot {
    double q[3]; /* about the place nearest to the query point, in the solid's space: it is within
                    the corners' error and rounding of a place of the simplex */
    double m[3]; /* covector of the direction from q to the query point, in the solid's space */
    int inner;   /* 1: q is in the relative interior of the simplex */
} foot;

/** Find the place nearest to the query point of the simplex with d corners. */
void foot_find(foot *out, const stance *s, const double *corner);

/** The squared distance of the trajectory from a box, in the solid's space; g is the vector from
 * the box to the trajectory. */
double foot_of_box(double *g, const stance *s, const box *b);

/* The distance of the query point to the boundary at one instant. */

/** State of a place, a node of the solid's tree, in a window of time. */
typedef enum place_state {
    PLACE_NEW,  /* not looked at in this window: its bound is from a longer window */
    PLACE_SEEN, /* the distance at the window's middle has been asked; the bound is from a longer
                   window or a larger place */
    PLACE_BOUNDED,
    PLACE_SMALL /* bounded, and a leaf or no larger than the trajectory's way in the window */
} place_state;

/** A node of the solid's tree; no simplex below the node is nearer than `low` at the times looked
 * at. */
typedef struct place {
    uint32_t node;
    place_state state;
    double low;
} place;

#endif
