/* Whether the trajectories of all points of a box miss the boundary together.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_CELL_H
#define GRAZE_FILTER_CELL_H

#include "filter/filter.h"
#include "filter/stay.h"

/** A box of query points: coordinate i of each differs from the centre's by at most half[i]. */
typedef struct cell {
    double centre[3]; /* exact */
    double half[3];
} cell;

/**
 * Whether certainly no point of the cell meets the boundary, at any time of the motion or, with
 * `during`, of that part of it (proofs/cells.md C76).
 * @param memory of one thread
 * @return 0 if that is not certain
 */
int cell_is_clear(curve *memory, const filter *f, const cell *points, const stay *during);

/**
 * Whether all points of the cell are at one time together in the state that decides their
 * membership (proofs/bricks.md C86).
 * @param[in,out] hint which time is looked at first; 0 for the first cell
 * @return 0 if that is not certain
 */
int cell_is_settled(curve *memory, const filter *f, const cell *points, size_t *hint);

#endif
