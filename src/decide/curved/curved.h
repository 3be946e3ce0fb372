/* The trace of a point through a curved solid (proofs/curved.md).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_CURVED_H
#define GRAZE_CURVED_CURVED_H

#include "decide/trace/trace.h"

/**
 * As trace_point, in a scene whose solid is curved. A state that no rule decides makes the trace
 * undecided: then the word has a `?`.
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL
 */
graze_status curved_trace(graze_trace *out, graze_context *context, const graze_scene *scene,
                          query_point point, trace_detail detail);

#endif
