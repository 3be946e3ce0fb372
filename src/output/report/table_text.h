/* The table of a scene and its points (src/program/cli/formats.md, Tables).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_TABLE_TEXT_H
#define GRAZE_REPORT_TABLE_TEXT_H

#include "base/number/text.h"
#include "decide/trace/trace.h"
#include "questions/distance/distance.h"
#include "questions/topo/finding.h"

/** Add the `#` lines of a head. `notes`: further `# key value` lines, or NULL. */
void table_notes(text *out, graze_context *context, const graze_scene *scene, const char *notes);

/** The `#` lines and the column line. `notes` as above. */
graze_status report_header(char **out, graze_context *context, const graze_scene *scene,
                           const char *notes, const char *columns);

/** Add one row of the table. `rest`: further columns as they were, or NULL; `topo`: the
 * position for the last column, or NULL. */
void report_csv(text *out, const graze_scene *scene, const fmpq *point, const graze_trace *trace,
                const char *rest, const topo_finding *topo, const distance *found);

#endif
