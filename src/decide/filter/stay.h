/* Stretches of time between certain crossings.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_STAY_H
#define GRAZE_FILTER_STAY_H

#include "decide/filter/findings.h"

/** A time of a piece, in [0, 1]. */
typedef struct stay {
    uint32_t piece;
    double at;
} stay;

/** As many as are looked for. */
enum { STAYS_MOST = 2 };

/**
 * Find times in the longest stretches in which the point of a search is certainly inside, or with
 * `outside` certainly outside (proofs/cells.md C76).
 * @param found of filter_search
 * @return how many there are; 0 also where some finding is not certain, or there is no crossing
 */
int stays_find(stay out[STAYS_MOST], const findings *found, size_t piece_count, int outside);

#endif
