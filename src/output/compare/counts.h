/* Counts and rows that every comparison keeps, whether its rows are read or asked for.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_COUNTS_H
#define GRAZE_COMPARE_COUNTS_H

#include "output/compare/judgement.h"

/** Fill a comparison that is all zero with options and names. 0 without memory; comparison_clear in
 * either case. */
int comparison_begin(graze_comparison *c, const graze_context *context, const char *golden,
                     const char *candidate, const graze_compare_options *options);

void comparison_clear(graze_comparison *c);

/** Count a golden row. `answered`: the candidate has it.
 * @return what became of it, as tally_add takes it */
char comparison_count(graze_comparison *c, const judgement *j, int answered);

/** Room for one more disagreement, zeroed but for `pmc`, which is that of a wrong row, else -1;
 * *out is NULL where it is not to be shown, or on failure. GRAZE_ESYSTEM. */
graze_status comparison_keep(disagreement **out, graze_comparison *c, graze_context *context,
                             int pmc);

/** Measure the wrong rows in the scene of the options, if there is one, and leave those to show:
 * the deepest wrong rows, at most MOST_OF_STRATUM of a stratum, then rows missing or extra; in the
 * order of the tables where depths are not known, or where a limit leaves them unmeasured. */
graze_status comparison_finish(graze_comparison *c, graze_context *context);

/** GRAZE_ESYSTEM. */
graze_status comparison_no_memory(graze_context *context);

#endif
