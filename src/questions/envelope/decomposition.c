/* Findings. SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

int judge_wants(const graze_envelope *e, graze_decomposable_reason reason) {
    return reason < e->found.reason;
}

graze_status judge_find(graze_envelope *e, graze_context *context, graze_decomposable_reason reason,
                        const graze_cell *facet, const graze_cell *cell, size_t piece,
                        const algebraic *u) {
    if (!judge_wants(e, reason))
        return GRAZE_OK;
    graze_time *time = time_create(e->scene->motion, piece, u);
    if (!time)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a time of a motion");
    time_destroy(e->found.time);
    e->found = (finding){reason, *facet, *cell, time};
    return GRAZE_OK;
}

graze_status judge_find_before(graze_envelope *e, graze_context *context,
                               graze_decomposable_reason reason, const graze_cell *facet,
                               const graze_cell *cell, size_t piece, const axis *x, size_t k) {
    HELD(algebraic, u);
    algebraic_set_rational(&u, x->sample + k);
    return judge_find(e, context, reason, facet, cell, piece, &u);
}

int judge_is_break(const graze_envelope *e, size_t piece, const axis *x, size_t k) {
    return (k == 0 && e->is_break[piece]) ||
           (k + 1 == x->count && piece + 1 < e->piece_count && e->is_break[piece + 1]);
}

int judge_is_inner(const graze_envelope *e, size_t piece, const axis *x, size_t k) {
    int is_end = (k == 0 && piece == 0) || (k + 1 == x->count && piece + 1 == e->piece_count);
    return !is_end && !judge_is_break(e, piece, x, k);
}

int judge_is_still(const graze_envelope *e, size_t facet) {
    for (size_t piece = 0; piece < e->piece_count; piece++)
        if (!e->still[piece * e->cells.facet_count + facet])
            return 0;
    return 1;
}
