/* Results of the filter's search: certain crossings, and candidates for the exact path.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_FINDINGS_H
#define GRAZE_FILTER_FINDINGS_H

#include <stddef.h>
#include <stdint.h>
#include "decide/filter/span_pullback.h"

/** The trajectory may meet the simplex within the closed window, in units of 2^-WINDOW_LEVELS. */
typedef struct candidate {
    uint32_t piece, simplex;
    uint32_t from, to;
} candidate;

typedef struct candidates {
    size_t count, capacity;
    candidate *item;
} candidates;

/** The part [start, start + 2^(WINDOW_LEVELS - level)] of a piece, in units of 2^-WINDOW_LEVELS. */
typedef struct time_part {
    uint32_t piece, start;
    int level;
} time_part;

/** Convert a window of a part's parameter to the piece's parameter, rounded outward. */
candidate candidate_in(time_part part, uint32_t simplex, const meet_window *w);

/** Append a candidate; 0 if memory runs out. */
int candidates_append(candidates *list, candidate item);

/** Sort by piece, simplex and time, and join windows of one simplex that touch. */
void candidates_join(candidates *list);

/** A certain crossing: once, at some time of the window, which is in units of a piece, the curve
 * goes through the relative interior of the simplex; `enters`: from outside to inside. */
typedef struct crossing {
    double from, to;
    uint32_t piece, simplex;
    int enters;
} crossing;

/** A crossing in a window of a part's own parameter. */
crossing crossing_in(time_part part, uint32_t simplex, const meet_window *w);

/** Candidates first ... first + count - 1 with overlapping windows: the exact path answers for all
 * of [from, to] at once. */
typedef struct exact_window {
    uint32_t piece, from, to;
    size_t first, count;
} exact_window;

/** The crossings and the windows in order of time, disjoint within each piece; and, in order, the
 * pieces for which the filter cannot be used. At all other times the trajectory is off the
 * boundary. */
typedef struct findings {
    size_t crossing_count, crossing_capacity;
    crossing *crossing;
    candidates asked;
    size_t window_count, window_capacity;
    exact_window *window;
    size_t lost_count, lost_capacity;
    uint32_t *lost;
} findings;

int findings_add_crossing(findings *found, crossing item);
int findings_add_window(findings *found, exact_window item);
int findings_lose(findings *found, uint32_t piece);
void findings_clear(findings *found);

#endif
