/* Boxes of the world that hold the solid during arcs, in a tree over the arcs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A search begins with the arcs whose boxes are nearer than a distance that is reached
 * (proofs/distance.md C71). The tree is a function of the scene alone, and so is an answer.
 */
#ifndef GRAZE_DISTANCE_ARC_TREE_H
#define GRAZE_DISTANCE_ARC_TREE_H

#include "questions/distance/arc_maps.h"

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

/** The tree of these maps, made at the first call. @return GRAZE_ESYSTEM */
graze_status arc_tree_of(const arc_tree **out, graze_context *context, const arc_maps *base);

/** No place of S during the arcs of a node is nearer than this to a point of a box of d
 * coordinates. */
double arc_node_distance(const arc_node *n, const double *low, const double *high, int d);

#endif
