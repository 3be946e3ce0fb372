/* Points that differ from all before them, and strata that have no others.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_DISTINCT_H
#define GRAZE_RUN_DISTINCT_H

#include <graze.h>
#include "base/context/slots.h"

/** Zeroed: of no points; distinct_clear at last. */
typedef struct distinct {
    slots seen;
    unsigned idle;         /* points in a row that were no new ones */
    unsigned spent;        /* strata that gave too many of these, as a set of 1 << graze_stratum */
    int is_wanted, failed; /* failed: memory has run short */
    graze_stratum wanted;  /* that of the last point, which was no new one */
    unsigned tries;        /* at another one of this stratum */
    unsigned passed;       /* points of others meanwhile */
} distinct;

/** Whether a point is to be looked at: after one that repeats all but those of its stratum are
 * passed over, up to a number, so that each stratum keeps its share. */
int distinct_wants(distinct *d, graze_stratum stratum);
/** Whether a point of a stratum is none of those before. Points are as they are written; of 2^64
 * hashes an equal one counts as an equal point. */
int distinct_add(distinct *d, graze_stratum stratum, const char *point, size_t length);
/** Whether the last points were all repeated, so that trying on is of no use. */
int distinct_is_over(const distinct *d);
void distinct_clear(distinct *d);

#endif
