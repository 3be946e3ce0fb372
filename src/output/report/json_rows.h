/* Answers as lines of JSON (src/program/cli/formats.md, JSON Lines).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_JSON_ROWS_H
#define GRAZE_REPORT_JSON_ROWS_H

#include "base/number/text.h"
#include "decide/trace/trace.h"
#include "questions/distance/distance.h"
#include "questions/topo/finding.h"

/** Add one line of JSON. `topo`: the position, or NULL; `found`: the
 * distance, or NULL. */
void report_json(text *out, const graze_scene *scene, const fmpq *point, const graze_trace *trace,
                 const topo_finding *topo, const distance *found);

#endif
