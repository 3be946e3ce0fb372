/* A binary tree of boxes over the simplices of a boundary; a search leaves out what cannot meet.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SOLID_TREE_H
#define GRAZE_SOLID_TREE_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/** A closed box around a simplex, a node or a curve; in E^2 the third coordinate is [0, 0]. */
typedef struct box {
    double low[3], high[3];
} box;

/** Inner nodes have their children at `child` and `child` + 1, and the number of a slab
 * (input/solid/slabs.h). A leaf has child 0 and one simplex. */
typedef struct tree_node {
    box box;
    uint32_t child;
    union {
        uint32_t simplex;
        uint32_t slab;
    };
} tree_node;

/** Node 0 is the root; 2 * simplices - 1 nodes. */
typedef struct tree {
    size_t node_count;
    tree_node *node;
} tree;

/** Build a tree over n >= 1 boxes; returns 0, or -1 without memory. */
int tree_build(tree *out, const box *boxes, size_t n);
void tree_clear(tree *t);

/** 1 if the closed boxes have a point in common. */
int box_meets(const box *a, const box *b);

/** The longest side of a box. */
static inline double box_extent(const box *b) {
    return fmax(b->high[0] - b->low[0], fmax(b->high[1] - b->low[1], b->high[2] - b->low[2]));
}

#endif
