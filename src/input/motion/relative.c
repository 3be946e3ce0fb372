/* One motion relative to another, by drafts of both over their common times.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "input/motion/motion.h"

#include "base/context/scope.h"
#include "input/motion/affine.h"
#include "input/motion/draft.h"

/* Append a piece, with the forward map's entries as quotients. */
static graze_status add_copy(draft *out, graze_context *context, const motion_piece *piece) {
    draft_piece *made;
    TRY(draft_append(&made, context, out, 0));
    for (int k = 0; k < out->dimension * (out->dimension + 1); k++) {
        fmpz_poly_set(fmpz_poly_q_numref(made->map.entry[k]), &piece->forward.entry[k]);
        fmpz_poly_set(fmpz_poly_q_denref(made->map.entry[k]), piece->forward.weight);
        quotient_reduce(made->map.entry[k]);
    }
    fmpq_set(made->lo, piece->lo);
    fmpq_set(made->hi, piece->hi);
    made->row = piece->row;
    return GRAZE_OK;
}

/* Append the pieces of a motion that run within the times of another one. */
static graze_status copy_common(draft *out, graze_context *context, const graze_motion *motion,
                                const graze_motion *other) {
    const fmpq *lo = other->piece[0].lo, *hi = other->piece[other->piece_count - 1].hi;
    for (size_t k = 0; k < motion->piece_count; k++)
        if (fmpq_cmp(motion->piece[k].lo, hi) < 0 && fmpq_cmp(motion->piece[k].hi, lo) > 0)
            TRY(add_copy(out, context, &motion->piece[k]));
    return GRAZE_OK;
}

graze_status motion_relative(graze_motion **out, graze_context *context, const graze_motion *moving,
                             const graze_motion *frame) {
    *out = NULL;
    if (moving->dimension != frame->dimension)
        return context_fail(context, GRAZE_EILLEGAL,
                            "the motions have dimensions %d and %d; expected one dimension",
                            moving->dimension, frame->dimension);
    HELD(draft, a, moving->dimension);
    HELD(draft, b, moving->dimension);
    HELD(draft, relative, moving->dimension);
    TRY(copy_common(&a, context, moving, frame));
    if (a.count == 0)
        return context_fail(context, GRAZE_EILLEGAL,
                            "the motions have no interval of time in common");
    TRY(copy_common(&b, context, frame, moving));
    TRY(draft_relative(&relative, context, &a, &b));
    return draft_finish(out, context, &relative);
}
