/* The pipeline from a scene and a point to the point's trace and verdict.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VERDICT_CLASSIFY_H
#define GRAZE_VERDICT_CLASSIFY_H

#include "decide/trace/trace.h"

/**
 * Trace a point through the scene and decide its verdict ([EI] Definitions 3-11), with the meaning
 * of proofs/claims.md C18.
 * @param[out] out uninitialised; on success it holds the verdict too and is cleared by trace_clear
 * @param detail   how much of the trace is wanted besides the verdict
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL
 */
graze_status classify_point(graze_trace *out, graze_context *context, const graze_scene *scene,
                            query_point point, trace_detail detail);

/** The verdict alone; TRACE_PMC gives only its pmc. On failure `out` is as it was. */
graze_status classify_answer(graze_verdict *out, graze_context *context, const graze_scene *scene,
                             query_point point, trace_detail detail);
/** The whole verdict alone; on failure `out` is as it was. */
graze_status classify_verdict(graze_verdict *out, graze_context *context, const graze_scene *scene,
                              query_point point);

#endif
