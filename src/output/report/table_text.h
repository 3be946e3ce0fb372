/* The table of a scene and its points (src/program/cli/formats.md, Tables).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_TABLE_TEXT_H
#define GRAZE_REPORT_TABLE_TEXT_H

#include "output/report/table_row.h"

/** Write the head of a table of another kind: `#` lines and names.
 * @param notes further `# key value` lines, or NULL.
 * @param further names behind `names`, comma-joined, or NULL */
graze_status table_head(char **out, graze_context *context, const graze_scene *scene,
                        const char *notes, const char *names, const char *further);

/** Write the head of a table of points; `notes` as above.
 * @param columns names of further columns, or NULL */
graze_status report_header(char **out, graze_context *context, const graze_scene *scene,
                           const char *notes, const char *columns, const graze_row_options *shown);
/** Append the names of that table's columns. */
void table_columns(text *out, const graze_scene *scene, const char *columns,
                   const graze_row_options *shown);

/** Add one row of the table. */
void report_csv(text *out, const row *r);

/** Add one row of values (output/table/row_values.h). GRAZE_EINPUT: a coordinate is past binary64.
 */
graze_status report_values(text *out, graze_context *context, const row *r);

#endif
