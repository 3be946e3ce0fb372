/* Whether all trajectories of a box of points go through the boundary, and none only touches it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_CELL_PASSES_H
#define GRAZE_FILTER_CELL_PASSES_H

#include "decide/filter/cell_walls.h"
#include "decide/filter/point_box.h"

/** Passages of trajectories from a cell that are certain (proofs/judging.md C116). */
typedef enum cell_passage {
    CELL_DOUBTFUL, /* nothing */
    CELL_PASSES,   /* no point of it is `on`, so all of them have one membership */
    CELL_PIERCED   /* a facet goes through the whole cell: of a sweep all of them are `in`, of an
                      unsweep `out` */
} cell_passage;

/**
 * @param memory set to the cell (point_box_begin)
 * @param walls  NULL, or the part of it that counts (proofs/judging.md C123)
 * @param motion of the sweep; used with walls
 */
cell_passage cell_passes(curve *memory, const filter *f, const point_box *points,
                         const cell_walls *walls, const graze_motion *motion);

#endif
