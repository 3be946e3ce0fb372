/* Rows of points that were traced, for the public functions of other files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_API_TRACE_H
#define GRAZE_API_TRACE_H

#include "api/api.h"
#include "base/number/text.h"
#include "decide/trace/trace.h"

/** GRAZE_EUSE: there is no such form of a row, or not of this scene. */
graze_status api_check_format(graze_context *context, const char *function,
                              const graze_scene *scene, graze_format format);

/** Add the row of a point that was traced; for JSON Lines with its contacts. `totals` are counted
 * on, unless they are NULL. */
graze_status api_trace_row(text *out, graze_row_totals *totals, graze_context *context,
                           const graze_scene *scene, const fmpq *point, const graze_trace *trace,
                           graze_format format, const char *rest);

#endif
