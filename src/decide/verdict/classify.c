/* Traces points and decides them. SPDX-License-Identifier: GPL-3.0-or-later */
#include "decide/verdict/verdict.h"

#include "base/context/scope.h"
#include "decide/curved/curved.h"

graze_status classify_point(graze_trace *out, graze_context *context, const graze_scene *scene,
                            query_point point, trace_detail detail) {
    TRY(scene->solid->curved ? curved_trace(out, context, scene, point, detail)
                             : trace_point(out, context, scene, point, detail));
    verdict_decide(out, &scene->options);
    return GRAZE_OK;
}

graze_status classify_answer(graze_verdict *out, graze_context *context, const graze_scene *scene,
                             query_point point, trace_detail detail) {
    graze_trace trace;
    TRY(classify_point(&trace, context, scene, point, detail));
    *out = (graze_verdict){.pmc = trace.verdict.pmc};
    if (detail < TRACE_PMC)
        *out = trace.verdict;
    trace_clear(&trace);
    return GRAZE_OK;
}

graze_status classify_verdict(graze_verdict *out, graze_context *context, const graze_scene *scene,
                              query_point point) {
    return classify_answer(out, context, scene, point, TRACE_WORD);
}
