/* The expression of a curved solid as a tree, updated by one change of sign at a time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_EXPRESSION_TREE_H
#define GRAZE_FILTER_EXPRESSION_TREE_H

#include "input/csg/csg.h"

/** The tree, with the parent of each node and the nodes of each surface; truths are for all
 * surfaces positive. */
typedef struct expression_tree {
    const csg *solid;       /* borrowed */
    uint32_t *first, *node; /* of surface k: node[first[k]] ... node[first[k + 1] - 1] */
    uint32_t *parent;       /* UINT32_MAX of the root */
    uint32_t *count;        /* true operands */
    unsigned char *is_true; /* by node */
} expression_tree;

/** The truths of the nodes in one thread, and the surfaces' signs. */
typedef struct truths {
    size_t node_room, sign_room;
    uint32_t *count;
    unsigned char *is_true;
    signed char *sign; /* by surface: 1, -1 */
} truths;

/** Make the tree; 0 if memory runs out. The caller calls expression_tree_clear in either case. */
int expression_tree_make(expression_tree *out, const csg *solid);
void expression_tree_clear(expression_tree *t);

/** Begin with all surfaces positive; 0 if memory runs out. */
int truths_begin(truths *m, const expression_tree *t);
void truths_clear(truths *m);

/** Change the sign of a surface. */
void truths_flip(truths *m, const expression_tree *t, size_t surface);

/** Is the expression true? */
int truths_all(const truths *m, const expression_tree *t);

#endif
