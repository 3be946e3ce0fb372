/* Comparison of a golden table with the table of a candidate.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant of a finished comparison: rows = agree + wrong + undecided + missing, and every tally
 * adds up to the rows that have a value for it.
 */
#ifndef GRAZE_COMPARE_COMPARE_H
#define GRAZE_COMPARE_COMPARE_H

#include "output/compare/comparison.h"

/** Open both tables, match their rows, judge them. `out` is zeroed by the caller and cleared by
 * comparison_clear in either case. */
graze_status comparison_make(graze_comparison *out, graze_context *context, const char *golden,
                             const char *candidate, const graze_compare_options *options);

#endif
