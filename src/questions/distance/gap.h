/* Bounds of the gap over a window of time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_DISTANCE_GAP_H
#define GRAZE_QUESTIONS_DISTANCE_GAP_H

#include "questions/distance/distance.h"

/* Data of a scene for distances, beside its filter: the maps that place the solid, in doubles, and
 * which pieces are rigid. */

/**
 * Give the maps of a scene, made at the first call.
 * @return GRAZE_ESYSTEM; GRAZE_ECANCELED; GRAZE_ELIMIT a number of solid or motion is beyond
 * doubles, a weight varies too much, or a degree is beyond CARRIER_DEGREE or, on a piece that is
 * not rigid, beyond SQUARED
 */
graze_status arc_maps_of(const arc_maps **out, graze_context *context, const graze_scene *scene);

/** The tracing map of an arc. */
const carrier *arc_maps_tracing(const arc_maps *g, size_t index);

/* A point's trajectory on an interval of an arc, in Bernstein form with a bound of its errors. */

/** Make the trajectory of a point, with coordinates from `low` to `high`, on an arc.
 * @return GRAZE_ELIMIT a coordinate is beyond CARRIER_REACH */
graze_status point_arc_make(point_arc *out, graze_context *context, const arc_maps *base,
                            size_t index, const double *low, const double *high);

/** Make the window [from, to] of a trajectory, 0 <= from <= to <= 1; returns 0 if a weight is not
 * certainly positive. */
int window_make(window *out, const point_arc *of, double from, double to);

/** Set the middle point of the control polygon of c, near enough to c for guesses. */
void window_trajectory(double *out, const window *w);

/* Boxes of the world that hold the solid during arcs, in a tree over the arcs.
 *
 * A search begins with the arcs whose boxes are nearer than a distance that is reached
 * (proofs/distance.md C71). The tree depends on the scene alone, so answers do not depend on
 * earlier questions. */

/** Arcs [first, last): S is in the box during all of them. An inner node has its children at
 * `child` and `child` + 1; a leaf, one arc, has child 0. */
typedef struct arc_node {
    box world;
    uint32_t first, last, child;
} arc_node;

/** Node 0 is the root. */
typedef struct arc_tree {
    arc_node *node;
    size_t count;
} arc_tree;

/** Give the tree over the arcs of `base`, borrowed; the first call makes it. @return GRAZE_ESYSTEM
 */
graze_status arc_tree_of(const arc_tree **out, graze_context *context, const arc_maps *base);

/** A lower bound of the distance between S during the arcs of a node and the box from `low` to
 * `high`, of d coordinates. */
double arc_node_distance(const arc_node *n, const double *low, const double *high, int d);

/* Bernstein coefficients of squares and products. */

/** Products are taken of polynomials up to the degree SQUARED, and SQUARED + 1 along a moving
 * place. */
enum { SQUARED = 20, SQUARE_ROOM = 2 * SQUARED + 5 };

/** A computed coefficient of a product errs by at most this times the greatest coefficient of each
 * factor (proofs/distance.md C69). */
#define SQUARE_ERROR (128 * UNIT_ROUNDING)

/** Factors that change a number by more than the rounding errors of a short chain of operations. */
#define ROUNDED_DOWN (1 - 0x1p-48)
#define ROUNDED_UP (1 + 0x1p-48)

/** The 2n + 1 coefficients of the square of a polynomial, of |.|^2 of a vector function, and of a
 * scalar product; n <= SQUARED + 1. */
void square_numbers(double *out, const double *c, int n);
void square_vectors(double *out, const double (*c)[3], int n);
void product_vectors(double *out, const double (*a)[3], const double (*c)[3], int n);

/* Bounds of the distance between the query point and places of the moving solid over a window
 * (proofs/distance.md C69, C70). */

/** A lower bound of the distance to all places of a simplex during the window, by a place of the
 * simplex that moves linearly from q0 to q1 in the solid's frame. It is close if that place is the
 * nearest one at all times of the window.
 */
double gap_about(const window *w, const double *q0, const double *q1, const double *corner,
                 int count);

/** An upper bound, during the window, of the distance to the place that moves linearly from q0 to
 * q1 in the solid's frame. */
double gap_most(const window *w, const double *q0, const double *q1);

#endif
