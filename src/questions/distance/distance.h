/* distance: an enclosure of a point's signed distance to the sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_DISTANCE_H
#define GRAZE_QUESTIONS_DISTANCE_H

#include "decide/bounds/bounds.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"

/* The distance of a point to the sweep or unsweep, enclosed (proofs/semantics.md 8). */

/** low <= s <= high, with the sign of the point's exact answer (proofs/distance.md C66, C67). */
typedef struct distance {
    double low, high;
    int wide; /* high - low is more than was asked for */
    /* A time at which the bound is met: parameter from + length v of the piece, exactly; or `at`, a
     * contact's time, borrowed from the trace: that of the first contact of an `on` point, or of
     * one at the end of a visit in which no double is certain to lie. */
    size_t piece;
    double from, length, v;
    const graze_time *at;
} distance;

/**
 * @param point     d rationals
 * @param trace     of the point, with its contacts' times
 * @param tolerance positive and finite: the width that is wanted
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
graze_status distance_find(distance *out, graze_context *context, const graze_scene *scene,
                           const fmpq *point, const graze_trace *trace, double tolerance);

/** 1 if every motion within the error has the same answer (proofs/distance.md C73). */
int distance_is_certain(const distance *found, double motion_error);

/** The time at which the bound is met, for an `in` or `out` point, in the motion's parameter. */
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
 * A part of a piece on which no weight varies much, so that its rounding is small everywhere: the
 * whole piece, of most motions. Its own parameter v runs from 0 to 1, the piece's is from +
 * length v, with `from` and `length` dyadic and exact.
 */
typedef struct arc {
    size_t piece;
    double from, length;
    int rigid;       /* distances of the space of query points are those of the solid's */
    carrier tracing; /* of a part; unset where the arc is the piece, whose map the filter has */
    carrier placing; /* motion_placing; set only if not rigid */
} arc;

/** Immutable once made; belongs to the scene. */
typedef struct arc_maps {
    const graze_scene *scene;
    const course *whole; /* the filter's */
    size_t arc_count, arc_capacity;
    arc *arc;         /* in the order of time */
    size_t *first;    /* by piece: its first arc; behind the last piece the number of arcs */
    ulong deepest;    /* the shortest arc is 2^-deepest of its piece */
    scene_memo *tree; /* the arc_tree, made at need */
} arc_maps;

/* A point's trajectory on an interval of an arc, in Bernstein form with a bound of its errors. */

/** Coefficients of one polynomial, at most. */
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
    double most_w;    /* bound of the errors of W's coefficients */
    double least;     /* W is at least this; positive */
    double stray;     /* X - q W errs by at most this in each coordinate, for places q of the solid
                         that are within the corners' error and rounding */
    int place_degree; /* of a piece that is not rigid: */
    double linear[9][WINDOW_ROOM];          /* the linear part of the tracing map, times W */
    double place[WINDOW_MAPS][WINDOW_ROOM]; /* the placing map, its weight last */
    double place_stray, place_least, place_most_w, linear_stray;
} window;

/* How far a point is at least from where the membership changes. */

/**
 * A lower bound of the distance from the boundary of the sweep: all points that are nearer than it
 * have the membership of the point. 0 where none is proved, and of points `on` (proofs/judging.md
 * C120).
 * @param found of the point, whose answer is `pmc`
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
graze_status distance_to_boundary(double *low, graze_context *context, const graze_scene *scene,
                                  const fmpq *point, graze_pmc pmc, const distance *found);

/* The size of a scene, which relative tolerances are relative to. */

/** The diagonal of the box of S^0's corners, rounded down.
 * @return GRAZE_ELIMIT beyond 2^-300 to 2^300, GRAZE_ECANCELED */
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
    double q[3]; /* nearest place, in the solid: within the corners' error and rounding of one */
    double m[3]; /* covector of the direction from there to the point, in the solid */
    int inner;   /* in the relative interior of the simplex */
} foot;

/** @param corner the simplex's d corners */
void foot_find(foot *out, const stance *s, const double *corner);

/** The squared distance of the trajectory to a box, in the solid; g points from the box to it. */
double foot_of_box(double *g, const stance *s, const box *b);

/* The distance of the query point to the boundary at one instant. */

/** State of a place in a window of time. */
typedef enum place_state {
    PLACE_NEW,  /* not looked at: its bound is that of a longer window */
    PLACE_SEEN, /* the middle of the window has been asked; the bound is that of a larger place */
    PLACE_BOUNDED,
    PLACE_SMALL /* bounded, and no larger than the window */
} place_state;

/** A node of the solid's tree; no simplex below it is nearer than low at the times looked at. */
typedef struct place {
    uint32_t node;
    place_state state;
    double low;
} place;

#endif
