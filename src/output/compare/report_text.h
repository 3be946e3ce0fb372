/* A comparison as text.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_REPORT_TEXT_H
#define GRAZE_COMPARE_REPORT_TEXT_H

#include "output/compare/comparison.h"

/** A likely reason where many rows have no counterpart; NULL if nothing points to one. Static. */
const char *comparison_hint(const graze_comparison *c);

/** The command that explains a disagreement, malloc'ed; NULL when out of memory. */
char *explain_command(const graze_comparison *c, const disagreement *d);

/** The report as Markdown. */
graze_status comparison_text(char **out, graze_context *context, const graze_comparison *c);

#endif
