/* Pairs of boundary cells that meet at a time. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_COLLIDE_CELL_PAIRS_H
#define GRAZE_COLLIDE_CELL_PAIRS_H

#include "graze/pair.h"
#include "questions/collide/common_points.h"

typedef struct cell_pairs {
    size_t count, capacity;
    graze_cell_pair *item; /* sorted, each once */
} cell_pairs;

/**
 * All pairs of relatively open cells that have a point in common at the placing's time, at which no
 * edge of one solid passes through the other (proofs/collision.md C109).
 * @param near all pairs of simplices that meet then, perhaps others
 */
void cell_pairs_find(cell_pairs *out, placing *p, const near_list *near);

#endif
