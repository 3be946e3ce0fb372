/* A point's trajectory on an interval of an arc, in Bernstein form with a bound of its errors.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_WINDOW_H
#define GRAZE_DISTANCE_WINDOW_H

#include "questions/distance/arc_maps.h"

/** Coefficients of one polynomial, at most. */
enum { WINDOW_ROOM = CARRIER_DEGREE + 1, WINDOW_MAPS = POINT_MAP_ENTRIES + 1 };

/** A query point on one arc: the coefficients of X_0 ... X_(d-1), W on [0, 1], each of X within
 * error_x of the exact one and at most size_x, and error_w, size_w for W. */
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
    double most_w;    /* what W's coefficients may be off by */
    double least;     /* W is at least this; positive */
    double stray;     /* X - q W errs by at most this in each coordinate, for places q of the solid
                         that are within the corners' error and rounding */
    int place_degree; /* of a piece that is not rigid: */
    double linear[9][WINDOW_ROOM];          /* the linear part of the tracing map, times W */
    double place[WINDOW_MAPS][WINDOW_ROOM]; /* the placing map, its weight last */
    double place_stray, place_least, place_most_w, linear_stray;
} window;

/** Coordinates of the point; fails with GRAZE_ELIMIT past the range. */
graze_status point_arc_make(point_arc *out, graze_context *context, const arc_maps *base,
                            size_t index, const double *low, const double *high);

/** The window [from, to] of a path, 0 <= from <= to <= 1; 0 if W is not certainly positive. */
int window_make(window *out, const point_arc *of, double from, double to);

/** c at the middle of a window's control polygon, near enough for guesses. */
void window_trajectory(double *out, const window *w);

#endif
