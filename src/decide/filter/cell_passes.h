/* Tests whether the trajectories of all points of a box cross the boundary, and none only touches
 * it. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_CELL_PASSES_H
#define GRAZE_FILTER_CELL_PASSES_H

#include "decide/filter/cell_walls.h"
#include "decide/filter/point_box.h"

/** Results about the trajectories of a cell's points (proofs/judging.md C116). */
typedef enum cell_passage {
    CELL_DOUBTFUL, /* nothing is certain */
    CELL_PASSES,   /* no point of the cell is `on`, so all have one membership */
    CELL_PIERCED /* a facet crosses the whole cell: all points are `in` a sweep, `out` of an unsweep
                  */
} cell_passage;

/**
 * @param memory set to the cell (point_box_begin)
 * @param walls  NULL, or the part of the cell that is asked about (proofs/judging.md C123)
 * @param motion of the sweep; used with walls */
cell_passage cell_passes(curve *memory, const filter *f, const point_box *points,
                         const cell_walls *walls, const graze_motion *motion);

#endif
