/* A comparison as JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_REPORT_JSON_H
#define GRAZE_COMPARE_REPORT_JSON_H

#include "output/compare/comparison.h"

/** The report as JSON. */
graze_status comparison_json(char **out, graze_context *context, const graze_comparison *c);

#endif
