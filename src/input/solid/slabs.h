/* Slabs around the simplices below a node of a solid's tree, about parallel to them where they are
 * about flat: there a slab is much thinner than a box.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SOLID_SLABS_H
#define GRAZE_SOLID_SLABS_H

#include "input/solid/corners.h"
#include "input/solid/tree.h"

/** For all places x of the simplices low <= normal . x <= high, and |normal[i]| <= 1
 * (proofs/slabs.md C93). */
typedef struct slab {
    double normal[3], low, high;
} slab;

/** Number 0 has no bounds, and is that of nodes with very few or with many simplices. `item` is
 * NULL where corners.at is. */
typedef struct slabs {
    slab *item;
} slabs;

/** The slab of an inner node. */
static inline const slab *slab_below(const slabs *s, const tree_node *node) {
    return &s->item[node->slab];
}

/** Make and number those of a tree over simplices with these corners; 0 without memory. */
int slabs_make(slabs *out, tree *boxes, const corners *corners, int dimension);
void slabs_clear(slabs *s);

#endif
