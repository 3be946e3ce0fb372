/* Strata that get fewer points than their weights ask for, and what is said of them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_LOST_STRATA_H
#define GRAZE_RUN_LOST_STRATA_H

#include "program/run/load.h"

/** Strata with a weight that get fewer points than it asks for, as sets of 1 << graze_stratum:
 * none, as the scene has none, or none whose coordinates a binary64 holds; and those spent, in
 * which no further points were found. */
typedef struct lost_strata {
    unsigned absent, unrepresentable, spent;
    int replaced;   /* 1: the stratum `rounded` has the weight of the unrepresentable ones */
    int has_dyadic; /* 1: the motion that `motion dyadic` makes has some of these */
} lost_strata;

/** Set has_dyadic where the dyadic motion near the scene's has points of the unrepresentable
 * strata.
 * @return GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status lost_strata_dyadic(lost_strata *lost, const loaded *l, const scene_options *o,
                                unsigned long long seed, const unsigned long *weights);

/** A line for each such stratum, `between` between them; an empty text for none. malloc'ed, NULL
 * when out of memory. */
char *lost_strata_text(const lost_strata *lost, const char *between);

#endif
