/* The search of a trajectory's crossings, and of bricks that prove a state.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_DECIDE_FILTER_SEARCH_H
#define GRAZE_DECIDE_FILTER_SEARCH_H

#include <flint/fmpq.h>
#include <stddef.h>
#include <stdint.h>
#include "decide/filter/filter.h"

/* Results of the filter's search: certain crossings, and candidates for the exact path. */

/** The part [start, start + 2^(WINDOW_LEVELS - level)] of a piece, in units of 2^-WINDOW_LEVELS. */
typedef struct time_part {
    uint32_t piece, start;
    int level;
} time_part;

/** Convert a window of a part's parameter to the piece's parameter, rounded outward. */
candidate candidate_in(time_part part, uint32_t simplex, const meet_window *w);

/** Make a crossing from a window of a part's parameter, rounded outward. */
crossing crossing_in(time_part part, uint32_t simplex, const meet_window *w);

/* The next three functions append to a list of the findings; 0 if memory runs out. */
int findings_add_crossing(findings *found, crossing item);
int findings_add_window(findings *found, exact_window item);
int findings_lose(findings *found, uint32_t piece);
void findings_clear(findings *found);

/* Bricks of space that are certainly inside the solid, or certainly outside it. */

/** Finds the state of a block of bricks that no simplex meets, by its middle; ABSENT: not certain.
 */
typedef graze_state locate_function(void *data, const double middle[3]);

/** Lay some bricks for each simplex, within fixed bounds, over the solid's box, and find their
 * states. No state is found if the solid's numbers are beyond the filter.
 * @param locate the state at a place in doubles, or ABSENT
 * @return 0 if memory runs out */
int interior_make(interior *out, const graze_solid *solid, locate_function *locate, void *data);
void interior_clear(interior *m);

/** The state of all places of a box, or ABSENT if it is not certain (proofs/bricks.md C86). */
graze_state interior_state(const interior *m, const box *b);

/* Tests a span of a curve against a simplex: certainly no contact, one certain crossing, or a
 * question for the exact path. */

typedef enum meeting {
    MEET_NONE,     /* at no time of the closed span is the curve on the closed simplex */
    MEET_CROSSING, /* at just one time the curve is on it, and crosses its relative interior */
    MEET_ASK,      /* not certain; all times at which the curve is on it lie in the window */
    MEET_CUT       /* as MEET_ASK, but halves of the span may decide */
} meeting;

/**
 * @param corner d corners of d coordinates, outward oriented (validate.h)
 * @param corner_error each coordinate of `corner` is within this of the exact one */
meeting meet_simplex(meet_window *out, const curve *c, const span *piece, const double *corner,
                     double corner_error);

/* Tests whether a certain crossing is the only contact at its time: then the point is inside just
 * before or just after that time. */

/** Is it certain that no other simplex is met at the time of a certain crossing? Then the curve is
 * outside just before or after that time, and inside on the other side (proofs/membership.md C56).
 * @param at the window of the span in which meet_simplex found the crossing of `simplex`
 * @return 0 if that is not certain */
int crossing_is_alone(const curve *c, const span *piece, const graze_solid *solid, uint32_t simplex,
                      const meet_window *at);

/* Planes that cut a part out of a cell, and a test for simplices that never reach the part. */

/** Is there a plane of the walls on or beyond which all corners in `mask` of a moved simplex stay
 * at all times of a span? Then their convex hull misses the part that the walls cut out
 * (proofs/judging.md C123). Exact.
 * @param motion of a sweep
 * @param part   a span of one piece; with degree 0 its beginning alone
 * @param mask   bit k: corner k of the simplex; not 0 */
int walls_hold_out(const cell_walls *walls, const graze_motion *motion, const graze_solid *solid,
                   const span *part, uint32_t simplex, unsigned mask);

/** Uses of a part of the time for a slab: it can be cut, or it cannot; or its beginning alone. */
typedef enum part_use { PART_CUT, PART_LAST, PART_INSTANT } part_use;

/**
 * Let the slab grow over all points of its cube that are at corners of a simplex, or between them,
 * at a time of a part. A part that can be cut must make it hardly thicker.
 * @param memory the trajectory of the cube's centre
 * @param part   of one piece, widened by the cube
 * @param mask   as of walls_hold_out
 * @return 0 if the slab would be too thick, or all of the cube, or there is no bound
 */
int cell_slab_takes(cell_slab *s, const curve *memory, const span *part, part_use use,
                    uint32_t simplex, unsigned mask);

/** Bound, by coordinates, the distance of the trajectory of any point of a cell from the centre's
 * during a span; 0 if there is no bound. */
int point_box_spread(double spread[3], const curve *memory, const point_box *points,
                     const span *part);

/** Enlarge a box by the spread: a span meets this box if the span, widened by the spread, meets the
 * given one. */
box box_around(const box *b, const double *spread);

/** Does a node's slab certainly miss a span widened by the spread? */
int point_box_misses_slab(const filter *f, const span *part, const tree_node *node,
                          const double *spread);

/** Widen a span by the spread. */
span point_box_widen(const span *part, const double *spread);

/* Tests whether a box of space is free of the boundary. */

/**
 * @param[in,out] tests bound of the number of simplices to test; what remains of it
 * @return 0 if some simplex may meet the box, or `tests` do not suffice (proofs/bricks.md C87) */
int box_is_empty(const graze_solid *solid, const box *b, size_t *tests);

/* The descent of a curve's spans through a solid's tree. */

/** Conditions that end a search early: a time at which the curve is certainly in `state`, or a
 * certain crossing that is alone at its time, for the curve is inside on one side of that time and
 * outside on the other (proofs/membership.md C56, proofs/bricks.md C86). */
typedef struct early_end {
    const interior *bricks; /* NULL: crossings alone */
    graze_state state;
    int met;
} early_end;

/** Find all certain crossings and candidates of a curve, unsorted.
 * @param early NULL: the search is complete; else `met` is set to 1 if the search ends early
 * @return 0 if memory runs out
 */
int search_curve(findings *out, early_end *early, curve *c, const graze_solid *solid);

/* Disjoint windows from the findings of a search. */

/** Turn crossings and candidates, in any order, into disjoint windows and crossings in order of
 * time: findings not certainly apart in time are put into one window (proofs/filter.md C37). 0 if
 * memory runs out. */
int findings_settle(findings *found);

/** Locate a place in the solid by rays: I or O, or ABSENT if that is not certain.
 * @param at, error d + 1 homogeneous coordinates, the last one positive, each within its error
 */
graze_state ray_locate(filter_workspace *w, const graze_solid *solid, const double *at,
                       const double *error);

#endif
