/* Answers as lines of JSON (src/cli/formats.md, JSON Lines).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_JSON_H
#define GRAZE_REPORT_JSON_H

#include "distance/distance.h"
#include "number/text.h"
#include "topo/finding.h"
#include "trace/trace.h"

/** Add one line of JSON. `topo`: the position, or NULL; `found`: the
 * distance, or NULL. */
void report_json(text *out, const graze_scene *scene, const fmpq *point, const graze_trace *trace,
                 const topo_finding *topo, const distance *found);

#endif
