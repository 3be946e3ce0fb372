/* Times at which the state of a trajectory is certain from its certain crossings.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_CERTAIN_TIMES_H
#define GRAZE_FILTER_CERTAIN_TIMES_H

#include "decide/filter/findings.h"

/** A time: the motion's piece and the piece's parameter, in [0, 1]. */
typedef struct piece_time {
    uint32_t piece;
    double at;
} piece_time;

/** Bound of the number of times that a call finds. */
enum { CERTAIN_TIMES_MOST = 2 };

/** Find the middles of the longest stretches of time in which the point of a search is certainly
 * inside, with `outside` certainly outside (proofs/cells.md C76).
 * @param found the findings of filter_search
 * @return the number of times found; 0 also if a finding is not certain, or there is no crossing */
int certain_times_find(piece_time out[CERTAIN_TIMES_MOST], const findings *found,
                       size_t piece_count, int outside);

#endif
