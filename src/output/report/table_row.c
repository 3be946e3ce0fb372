/* Answers points for rows. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/table_row.h"

#include "questions/distance/clearance.h"
#include "questions/topo/topo.h"

trace_detail row_detail(const graze_row_options *shown) {
    if (shown->format == GRAZE_FORMAT_JSONL || shown->sdf > 0 || shown->moments)
        return TRACE_CONTACTS;
    return shown->columns == GRAZE_COLUMNS_PMC ? TRACE_PMC : TRACE_WORD;
}

graze_status row_answer(row *out, graze_context *context, const graze_scene *scene,
                        const graze_row_options *shown, const fmpq *point,
                        const graze_trace *trace) {
    graze_status status = GRAZE_OK;
    *out = (row){.scene = scene, .shown = shown, .point = point, .trace = trace};
    finding_init(&out->topo);
    finding_init(&out->regular);
    if (shown->topo)
        status = topo_decide(&out->topo, context, scene, point, trace);
    if (!status && shown->regular)
        status = topo_regular(&out->regular, context, scene, point, trace);
    if (!status && shown->sdf > 0)
        status = distance_find(&out->space, context, scene, point, trace, shown->sdf);
    if (!status && shown->boundary)
        status = distance_to_boundary(&out->boundary, context, scene, point, trace->verdict.pmc,
                                      &out->space);
    if (!status && (shown->format == GRAZE_FORMAT_JSONL || shown->sdf > 0))
        status = trace_canonicalise(trace, context);
    if (!status && shown->moments)
        status = inside_find(&out->inside, context, scene->motion, trace);
    return status;
}

void row_clear(row *r) {
    finding_clear(&r->topo);
    finding_clear(&r->regular);
}
