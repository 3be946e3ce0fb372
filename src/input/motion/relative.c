/* One motion relative to another, by drafts of both over their common times.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "input/motion/motion.h"

#include <flint/fmpq_vec.h>
#include "base/context/scope.h"
#include "input/motion/affine.h"
#include "input/motion/draft.h"

/* The interval common to both: the later start and the earlier end. */
static void common_interval(fmpq_t lo, fmpq_t hi, const graze_motion *a, const graze_motion *b) {
    const fmpq *a_hi = a->piece[a->piece_count - 1].hi, *b_hi = b->piece[b->piece_count - 1].hi;
    fmpq_set(lo, fmpq_cmp(a->piece[0].lo, b->piece[0].lo) > 0 ? a->piece[0].lo : b->piece[0].lo);
    fmpq_set(hi, fmpq_cmp(a_hi, b_hi) < 0 ? a_hi : b_hi);
}

/* Append the part of a piece between two of its times, with the forward map's entries as quotients.
 */
static graze_status add_cut(draft *out, graze_context *context, const motion_piece *piece,
                            const fmpq_t lo, const fmpq_t hi) {
    draft_piece *made;
    calculation c = {context, GRAZE_OK};
    graze_status status = draft_append(&made, context, out);
    if (status)
        return status;
    LOCAL_VEC(fmpq, from, 2);
    fmpq *to = from + 1;
    HELD(affine, whole, out->dimension);
    for (int k = 0; k < out->dimension * (out->dimension + 1); k++) {
        fmpz_poly_set(fmpz_poly_q_numref(whole.entry[k]), &piece->forward.entry[k]);
        fmpz_poly_set(fmpz_poly_q_denref(whole.entry[k]), piece->forward.weight);
        quotient_reduce(whole.entry[k]);
    }
    motion_parameter_at(from, piece, lo);
    motion_parameter_at(to, piece, hi);
    affine_substitute(&c, &made->map, &whole, from, to);
    fmpq_set(made->lo, lo);
    fmpq_set(made->hi, hi);
    made->row = piece->row;
    return c.status;
}

/* Append the parts of a motion's pieces between two of its times. */
static graze_status cut_out(draft *out, graze_context *context, const graze_motion *motion,
                            const fmpq_t lo, const fmpq_t hi) {
    for (size_t k = 0; k < motion->piece_count; k++) {
        const motion_piece *piece = &motion->piece[k];
        const fmpq *from = fmpq_cmp(piece->lo, lo) > 0 ? piece->lo : lo;
        const fmpq *to = fmpq_cmp(piece->hi, hi) < 0 ? piece->hi : hi;
        if (fmpq_cmp(from, to) < 0)
            TRY(add_cut(out, context, piece, from, to));
    }
    return GRAZE_OK;
}

graze_status motion_relative(graze_motion **out, graze_context *context, const graze_motion *moving,
                             const graze_motion *frame) {
    *out = NULL;
    if (moving->dimension != frame->dimension)
        return context_fail(context, GRAZE_EILLEGAL,
                            "the motions have dimensions %d and %d; expected one dimension",
                            moving->dimension, frame->dimension);
    LOCAL_VEC(fmpq, lo, 2);
    fmpq *hi = lo + 1;
    HELD(draft, a, moving->dimension);
    HELD(draft, b, moving->dimension);
    HELD(draft, relative, moving->dimension);
    common_interval(lo, hi, moving, frame);
    if (fmpq_cmp(lo, hi) >= 0)
        return context_fail(context, GRAZE_EILLEGAL,
                            "the motions have no interval of time in common");
    TRY(cut_out(&a, context, moving, lo, hi));
    TRY(cut_out(&b, context, frame, lo, hi));
    TRY(draft_relative(&relative, context, &a, &b));
    return draft_finish(out, context, &relative);
}
