/* Explains the answer for one point to a person.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_EXPLAIN_H
#define GRAZE_REPORT_EXPLAIN_H

#include "output/report/table_row.h"

/** Write the whole explanation; the times of the row's trace are canonical. */
graze_status report_explain(char **out, graze_context *context, const row *r);

#endif
