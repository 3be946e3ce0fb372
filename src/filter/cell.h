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

/** At that time, some place of the box is in the state that decides a membership
 * (proofs/bricks.md C87). */
typedef struct anchor {
    stay when;
    box around;
} anchor;

/**
 * Whether certainly no point of the cell meets the boundary, at any time of the motion
 * (proofs/cells.md C76).
 * @param memory of one thread
 * @return 0 if that is not certain
 */
int cell_is_clear(curve *memory, const filter *f, const cell *points);

/**
 * An anchor where the cell's centre is at a time at which it is in that state.
 * @return 0 if there is no bound
 */
int cell_anchor(anchor *out, curve *memory, const filter *f, const cell *points, const stay *when);

/**
 * Whether at the time of the anchor nothing of the boundary can be between it and any point of the
 * cell, which are then in its state too (proofs/bricks.md C87).
 * @return 0 if that is not certain
 */
int cell_joins(curve *memory, const filter *f, const cell *points, const anchor *to);

/**
 * Whether all points of the cell are at one time together in the state that decides their
 * membership (proofs/bricks.md C86).
 * @param[in,out] hint which time is looked at first; 0 for the first cell
 * @return 0 if that is not certain
 */
int cell_is_settled(curve *memory, const filter *f, const cell *points, size_t *hint);

#endif
