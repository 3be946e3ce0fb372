/* Answers points for rows. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/row_parts.h"

#include "base/context/scope.h"

trace_detail row_detail(const graze_row_options *shown) {
    trace_detail detail = shown->columns == GRAZE_COLUMNS_PMC   ? TRACE_PMC
                          : shown->format == GRAZE_FORMAT_JSONL ? TRACE_CONTACTS
                                                                : TRACE_WORD;
    for (const column_set *set = NULL; (set = columns_next(set, shown));)
        detail = set->needs == NEEDS_CONTACTS ? TRACE_CONTACTS : detail;
    return detail;
}

graze_status row_answer(row *out, graze_context *context, const graze_scene *scene,
                        const graze_row_options *shown, const fmpq *point,
                        const graze_trace *trace) {
    *out = (row){.scene = scene, .shown = shown, .point = point, .trace = trace};
    finding_init(&out->topo);
    finding_init(&out->regular);
    for (const column_set *set = NULL; (set = columns_next(set, shown));)
        if (set->find)
            TRY(set->find(out, context));
    return !shown->at_rest && (shown->format == GRAZE_FORMAT_JSONL || shown->sdf > 0)
               ? trace_canonicalise(trace, context)
               : GRAZE_OK;
}

void row_clear(row *r) {
    finding_clear(&r->topo);
    finding_clear(&r->regular);
}

int row_is_undecided(const row *r) {
    int is = r->shown->columns == GRAZE_COLUMNS_PMC ? r->trace->verdict.pmc == GRAZE_PMC_UNDECIDED
                                                    : r->trace->undecided != NULL;
    for (const column_set *set = NULL; (set = columns_next(set, r->shown));)
        is |= set->undecided && strcmp(set->word(r), "undecided") == 0;
    return is;
}
