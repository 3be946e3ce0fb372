/* Whether the trajectories of all points of a box miss the boundary together.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_POINT_BOX_H
#define GRAZE_FILTER_POINT_BOX_H

#include "decide/filter/filter.h"
#include "decide/filter/certain_times.h"

/** A box of query points: coordinate i of each differs from the centre's by at most half[i]. */
typedef struct point_box {
    double centre[3]; /* exact */
    double half[3];
} point_box;

/** At that time, some place of the box is in the state that decides a membership
 * (proofs/bricks.md C87). */
typedef struct anchor {
    piece_time when;
    box around;
} anchor;

/**
 * Set the memory of one thread to a cell's centre, which all below ask for: `memory` is that of the
 * same cell.
 * @return 0 if the filter cannot be used for it, or without memory
 */
int point_box_begin(curve *memory, const filter *f, const point_box *points);

/**
 * Whether certainly no point of the cell meets the boundary, at any time of the motion
 * (proofs/cells.md C76).
 * @return 0 if that is not certain
 */
int point_box_is_clear(curve *memory, const filter *f, const point_box *points);

/**
 * An anchor where the cell's centre is at a time at which it is in that state.
 * @return 0 if there is no bound
 */
int point_box_anchor(anchor *out, curve *memory, const filter *f, const piece_time *when);

/**
 * Whether at the time of the anchor nothing of the boundary can be between it and any point of the
 * cell, which are then in its state too (proofs/bricks.md C87).
 * @return 0 if that is not certain
 */
int point_box_joins(curve *memory, const filter *f, const point_box *points, const anchor *to);

/**
 * Whether all points of the cell are at one time together in the state that decides their
 * membership (proofs/bricks.md C86).
 * @param[in,out] hint which time is looked at first; 0 for the first cell
 * @return 0 if that is not certain
 */
int point_box_is_settled(curve *memory, const filter *f, const point_box *points, size_t *hint);

/** How far the trajectory of a point of the cell can be from the centre's in a part of it; 0 if
 * there is no bound. */
int point_box_spread(double spread[3], const curve *memory, const point_box *points,
                     const span *part);

/** A box of the places of the cell's points at a time, or of the centre's alone where `half` is
 * NULL; 0 if there is none. */
int point_box_places(box *out, curve *memory, const filter *f, const piece_time *when,
                     const double *half);

/** A box, larger by the spread: a span as thick as that meets a box where the span meets this. */
box box_around(const box *b, const double *spread);

/** Whether a node's slab misses a span as thick as the spread makes it. */
int point_box_misses_slab(const filter *f, const span *part, const tree_node *node,
                          const double *spread);

/** The span as thick as the spread makes it. */
span point_box_widen(const span *part, const double *spread);

#endif
