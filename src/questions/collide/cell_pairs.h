/* Pairs of boundary cells, one of each solid, that meet at a time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_CELL_PAIRS_H
#define GRAZE_COLLIDE_CELL_PAIRS_H

#include "graze/pair.h"
#include "questions/collide/common_points.h"

typedef struct cell_pairs {
    size_t count, capacity;
    graze_cell_pair *item; /* sorted, without duplicates */
} cell_pairs;

/** Find all pairs of relatively open cells with a common point at the placing's time
 * (proofs/collision.md C109). At that time no edge of one solid passes through the other.
 * @param near all pairs of simplices that meet then, and perhaps others */
void cell_pairs_find(cell_pairs *out, placing *p, const near_list *near);

#endif
