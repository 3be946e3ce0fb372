/* Parts that graze validate and its reports share.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_VALIDATION_REPORT_H
#define GRAZE_CLI_VALIDATION_REPORT_H

#include "program/cli/validation.h"

/** How many points are made, and their seed, with the defaults. */
unsigned long validated_count(const validate_options *o);
unsigned long long validated_seed(const validate_options *o);

/** One text behind another, malloc'ed; NULL when out of memory. */
char *joined_texts(const char *a, const char *b);

/** Write the reports asked for. Returns an exit status: EXIT_NO where the tables differ. */
int validation_report(const validation *v, const validate_options *o);

#endif
