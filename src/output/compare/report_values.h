/* The part of a comparison's report that has the errors of values.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_REPORT_VALUES_H
#define GRAZE_COMPARE_REPORT_VALUES_H

#include "base/number/json.h"
#include "output/compare/comparison.h"

/** The question, and the errors of all values. */
void put_values(text *out, const graze_comparison *c);
/** The errors by stratum, k and distance. */
void put_values_by(text *out, const graze_comparison *c);

/** Both as members of a JSON object, in one call. */
void put_json_values(json_writer *w, const graze_comparison *c);

#endif
