/* Tests of the trajectories of all points of a box at once against the boundary.
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

/** A time and a box of places; at that time some place of the box is in the state that decides a
 * membership (proofs/bricks.md C87). */
typedef struct anchor {
    piece_time when;
    box around;
} anchor;

/** Set a thread's memory to a cell's centre. All functions below take the memory of the cell they
 * ask about.
 * @return 0 if the filter cannot be used for it, or if memory runs out */
int point_box_begin(curve *memory, const filter *f, const point_box *points);

/** Is it certain that no point of the cell meets the boundary at any time (proofs/cells.md C76)?
 * @return 0 if that is not certain */
int point_box_is_clear(curve *memory, const filter *f, const point_box *points);

/** Make an anchor around the place of the cell's centre, at a time at which the centre is in the
 * deciding state.
 * @return 0 if there is no bound */
int point_box_anchor(anchor *out, curve *memory, const filter *f, const piece_time *when);

/** Is it certain that at the anchor's time the boundary does not separate the anchor from any point
 * of the cell? Then all points of the cell have the anchor's state (proofs/bricks.md C87).
 * @return 0 if that is not certain */
int point_box_joins(curve *memory, const filter *f, const point_box *points, const anchor *to);

/** Is it certain that at some time all points of the cell are in the state that decides their
 * membership (proofs/bricks.md C86)?
 * @param[in,out] hint the time that is tried first; 0 for the first cell
 * @return 0 if that is not certain */
int point_box_is_settled(curve *memory, const filter *f, const point_box *points, size_t *hint);

/** Bound, by coordinates, the distance of a point's trajectory from the centre's during a span; 0
 * if there is no bound. */
int point_box_spread(double spread[3], const curve *memory, const point_box *points,
                     const span *part);

/** Find a box around the places of the cell's points at a time; if `half` is NULL, around the
 * centre's. 0 if there is none. */
int point_box_places(box *out, curve *memory, const filter *f, const piece_time *when,
                     const double *half);

/** Enlarge a box by the spread: a span meets this box if the span, widened by the spread, meets the
 * given one. */
box box_around(const box *b, const double *spread);

/** Does a node's slab certainly miss a span widened by the spread? */
int point_box_misses_slab(const filter *f, const span *part, const tree_node *node,
                          const double *spread);

/** Widen a span by the spread. */
span point_box_widen(const span *part, const double *spread);

#endif
