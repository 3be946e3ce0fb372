/* Answers as lines of JSON (src/cli/formats.md, JSON Lines).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_JSON_H
#define GRAZE_REPORT_JSON_H

#include "number/text.h"
#include "trace/trace.h"

/** Add one line of JSON. */
void report_json(text *out, const graze_scene *scene, const fmpq *point, const graze_trace *trace);

#endif
