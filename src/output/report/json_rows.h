/* Answers as lines of JSON (src/program/cli/formats.md, JSON Lines).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_JSON_ROWS_H
#define GRAZE_REPORT_JSON_ROWS_H

#include "output/report/table_row.h"

/** Add one line of JSON. */
void report_json(text *out, const row *r);

#endif
