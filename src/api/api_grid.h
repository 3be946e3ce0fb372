/* Grids, for the public functions of other files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_API_GRID_H
#define GRAZE_API_GRID_H

#include "decide/lattice/bricks.h"
#include "decide/lattice/grid_rows.h"

/** Answers that are computed when they are first asked for; under locks of their own. */
typedef struct grid_memory {
    bricks bricks;
    axis_texts texts;
} grid_memory;

struct graze_grid {
    lattice lattice;
    grid_memory *memory;
};

#endif
