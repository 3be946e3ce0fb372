/* What all comparisons count and keep, whether their rows are read or asked for.
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

/** Room for one more disagreement, zeroed; *out is NULL where as many as wanted are kept, or on
 * failure. GRAZE_ESYSTEM. */
graze_status comparison_keep(disagreement **out, graze_comparison *c, graze_context *context);

/** Measure the wrong rows in the scene of the options, if there is one; a limit that distances meet
 * leaves them unmeasured. */
graze_status comparison_measure(graze_comparison *c, graze_context *context);

/** GRAZE_ESYSTEM. */
graze_status comparison_no_memory(graze_context *context);

#endif
