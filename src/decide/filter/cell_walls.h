/* Planes that cut a part out of a cell, and a test for simplices that never reach the part.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_CELL_WALLS_H
#define GRAZE_FILTER_CELL_WALLS_H

#include <flint/fmpq.h>
#include "decide/filter/curve.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"

/** The points of a cell that are strictly on one side of each plane n x + d = 0. */
typedef struct cell_walls {
    int count;
    const fmpq *plane; /* four numbers each */
    unsigned sides;    /* bit k: the part is where plane k is positive */
} cell_walls;

/** Are some corners of a moved simplex outside one of the planes at all times of a span
 * (proofs/judging.md C123)? Exact.
 * @param motion of a sweep
 * @param part   of one piece; of degree 0: its beginning alone
 * @param mask   the corners, some */
int walls_hold_out(const cell_walls *walls, const graze_motion *motion, const graze_solid *solid,
                   const span *part, uint32_t simplex, unsigned mask);

#endif
