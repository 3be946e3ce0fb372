/* A box against the solid's tree: against boxes by comparisons, against simplices as a span.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/filter/search.h"

typedef struct emptiness {
    const graze_solid *solid;
    const box *space;
    curve shape; /* dimension and corners alone */
    span all;
    size_t *tests;
} emptiness;

/* Is it certain that no simplex below a node meets the box? */
static int is_empty(const emptiness *e, uint32_t index) {
    const tree_node *node = &e->solid->boxes.node[index];
    if (flip(FLIP_BOX, !box_meets(&node->box, e->space)))
        return 1;
    if (node->child && !chord_meets_slab(&e->all, e->all.wide, slab_below(&e->solid->slabs, node)))
        return 1;
    if (node->child)
        return is_empty(e, node->child) && is_empty(e, node->child + 1);
    if (*e->tests == 0)
        return 0;
    --*e->tests;
    const corners *corners = &e->solid->corners;
    size_t d = (size_t)e->shape.dimension;
    return chord_meets(&e->shape, &e->all, corners->at + node->simplex * d * d, corners->error) ==
           CHORD_MISSES;
}

int box_is_empty(const graze_solid *solid, const box *b, size_t *tests) {
    emptiness e = {.solid = solid, .space = b, .tests = tests};
    e.shape.dimension = solid->input.dimension;
    e.shape.corners = &solid->corners;
    span_of_box(&e.all, &e.shape, b);
    return is_empty(&e, 0);
}
