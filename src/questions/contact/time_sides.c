/* Pieces beside a time. Two pieces of one rational function, as where a motion was cut, make no
 * break.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/contact/contact.h"

#include <flint/fmpq_poly.h>
#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "input/motion/motion.h"
#include "questions/contact/nearby.h"

static void set_side(site_side *side, const graze_motion *motion, size_t piece, const fmpq_t t) {
    side->present = 1;
    side->piece = piece;
    motion_parameter_at(side->u, &motion->piece[piece], t);
}

/* first(u) second_weight(shift(u)) = second(shift(u)) first_weight(u) */
static int is_same_quotient(const fmpz_poly_struct *first, const fmpz_poly_struct *first_weight,
                            const fmpz_poly_struct *second, const fmpz_poly_struct *second_weight,
                            const fmpq_poly_t shift) {
    LOCAL(fmpq_poly, a);
    LOCAL(fmpq_poly, b);
    LOCAL(fmpq_poly, c);
    fmpq_poly_set_fmpz_poly(a, second_weight);
    fmpq_poly_compose(a, a, shift);
    fmpq_poly_set_fmpz_poly(c, first);
    fmpq_poly_mul(a, a, c);
    fmpq_poly_set_fmpz_poly(b, second);
    fmpq_poly_compose(b, b, shift);
    fmpq_poly_set_fmpz_poly(c, first_weight);
    fmpq_poly_mul(b, b, c);
    return fmpq_poly_equal(a, b);
}

/* Do a piece and the next one continue each other as one rational function? */
static int is_one_function(const motion_piece *first, const motion_piece *second) {
    int d = first->forward.dimension, same = 1;
    LOCAL_VEC(fmpq, at_zero, 2);
    fmpq *at_one = at_zero + 1;
    LOCAL(fmpq_poly, shift);
    motion_parameter_at(at_zero, second, first->lo);
    motion_parameter_at(at_one, second, first->hi);
    fmpq_poly_set_coeff_fmpq(shift, 0, at_zero);
    fmpq_sub(at_one, at_one, at_zero);
    fmpq_poly_set_coeff_fmpq(shift, 1, at_one);
    for (int k = 0; k < d * (d + 1) && same; k++)
        same = is_same_quotient(&first->forward.entry[k], first->forward.weight,
                                &second->forward.entry[k], second->forward.weight, shift);
    return same;
}

static graze_status refuse_time(graze_context *context, const graze_motion *motion) {
    char *low = rational_text(motion->piece[0].lo);
    char *high = rational_text(motion->piece[motion->piece_count - 1].hi);
    graze_status status =
        low && high
            ? context_fail(context, GRAZE_EINPUT,
                           "the motion has no such time; expected one from %s to %s", low, high)
            : context_fail(context, GRAZE_ESYSTEM, "out of memory for a message");
    free(low);
    free(high);
    return status;
}

graze_status sides_find(site_side side[2], graze_context *context, const graze_motion *motion,
                        const fmpq_t t) {
    side[0].present = side[1].present = 0;
    for (size_t k = 0; k < motion->piece_count; k++) {
        const motion_piece *piece = &motion->piece[k];
        int from = fmpq_cmp(t, piece->lo), to = fmpq_cmp(t, piece->hi);
        if (from > 0 && to <= 0)
            set_side(&side[0], motion, k, t);
        if (from >= 0 && to < 0)
            set_side(&side[1], motion, k, t);
    }
    return side[0].present || side[1].present ? GRAZE_OK : refuse_time(context, motion);
}

int sides_break(const site_side side[2], const graze_motion *motion) {
    return side[0].present && side[1].present && side[0].piece != side[1].piece &&
           !is_one_function(&motion->piece[side[0].piece], &motion->piece[side[1].piece]);
}
