/* Sites as rows of a table or lines of JSON (src/program/cli/formats.md, Contact points).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_SITE_ROWS_H
#define GRAZE_REPORT_SITE_ROWS_H

#include "base/number/text.h"
#include "questions/contact/site.h"

/** A cell: `face 3`, `edge 1-2`, `vertex 5`; nothing for kind 0. */
void report_put_cell(text *t, const graze_cell *cell);

/** Head of the table. @param notes, columns may be NULL */
graze_status report_contact_header(char **out, graze_context *context, const graze_scene *scene,
                                   const char *notes, const char *columns);
/** A row, from canonical times. @param rest further columns, or NULL */
void report_contact_csv(text *out, const graze_site *site, const char *rest);
void report_contact_json(text *out, const graze_site *site);

#endif
