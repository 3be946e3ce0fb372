/* The trace of a point through a curved solid (proofs/curved.md).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_CURVED_H
#define GRAZE_CURVED_CURVED_H

#include "decide/trace/trace.h"

/** Trace a point as trace_point does, through a curved solid. If no rule decides a state the trace
 * is undecided, and its word has a `?`.
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL */
graze_status curved_trace(graze_trace *out, graze_context *context, const graze_scene *scene,
                          query_point point, trace_detail detail);

#endif
