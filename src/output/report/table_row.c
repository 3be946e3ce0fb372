/* Answers points for rows. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/report.h"

#include "base/context/scope.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "output/report/row_parts.h"
#include "questions/distance/distance.h"
#include "questions/topo/topo.h"

trace_detail row_detail(const graze_row_options *shown) {
    if (shown->format == GRAZE_FORMAT_JSONL || shown->sdf > 0 || shown->moments)
        return TRACE_CONTACTS;
    return shown->columns == GRAZE_COLUMNS_PMC ? TRACE_PMC : TRACE_WORD;
}

graze_status row_answer(row *out, graze_context *context, const graze_scene *scene,
                        const graze_row_options *shown, const fmpq *point,
                        const graze_trace *trace) {
    *out = (row){.scene = scene, .shown = shown, .point = point, .trace = trace};
    finding_init(&out->topo);
    finding_init(&out->regular);
    if (shown->topo)
        TRY(topo_decide(&out->topo, context, scene, point, trace));
    if (shown->regular)
        TRY(topo_regular(&out->regular, context, scene, point, trace));
    if (shown->sdf > 0)
        TRY(distance_find(&out->space, context, scene, point, trace, shown->sdf));
    if (shown->boundary)
        TRY(distance_to_boundary(&out->boundary, context, scene, point, trace->verdict.pmc,
                                 &out->space));
    if (shown->format == GRAZE_FORMAT_JSONL || shown->sdf > 0)
        TRY(trace_canonicalise(trace, context));
    if (shown->moments)
        TRY(inside_find(&out->inside, context, scene->motion, trace));
    return GRAZE_OK;
}

void row_clear(row *r) {
    finding_clear(&r->topo);
    finding_clear(&r->regular);
}
