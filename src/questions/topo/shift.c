/* Shifts of plane curves, one variable after the other; the caller can cancel between two rows.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * With P = (a / c, b / c) and D the degree, c^D g(P + (x, y)) is the sum of g_ij c^(D - i - j)
 * (X + a)^i (Y + b)^j with X = c x, Y = c y.
 */
#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include "base/context/scope.h"
#include "questions/topo/cover.h"
#include "questions/topo/eliminate.h"

/* Multiply each g_ij by c^(D - i - j) or, with `back`, by c^(i + j). */
static void scale_terms(sliced_curve *s, const fmpz_t c, int back) {
    LOCAL(fmpz, power);
    for (slong j = 0; j <= s->degree; j++)
        for (slong i = 0; i < fmpz_poly_length(s->coefficient + j); i++) {
            fmpz_pow_ui(power, c, (ulong)(back ? i + j : s->total - i - j));
            fmpz_mul(fmpz_poly_get_coeff_ptr(s->coefficient + j, i),
                     fmpz_poly_get_coeff_ptr(s->coefficient + j, i), power);
        }
}

/* Replace X by X + a in each coefficient. */
static graze_status shift_coefficients(sliced_curve *s, graze_context *context, const fmpz_t a) {
    for (slong k = 0; k <= s->degree; k++) {
        fmpz_poly_taylor_shift(s->coefficient + k, s->coefficient + k, a);
        TRY(context_poll(context));
    }
    return GRAZE_OK;
}

static void content_of(fmpz_t out, const sliced_curve *s) {
    LOCAL(fmpz, content);
    fmpz_zero(out);
    for (slong k = 0; k <= s->degree; k++) {
        fmpz_poly_content(content, s->coefficient + k);
        fmpz_gcd(out, out, content);
    }
}

/* Convert to a polynomial, divided by its content. */
static void to_polynomial(fmpz_mpoly_t out, const sliced_curve *s, int variable,
                          const fmpz_mpoly_ctx_t ring) {
    LOCAL_VEC(fmpz, content, 2);
    fmpz *c = content + 1;
    content_of(content, s);
    fmpz_mpoly_zero(out, ring);
    for (slong k = 0; k <= s->degree; k++)
        for (slong i = 0; i < fmpz_poly_length(s->coefficient + k); i++) {
            ulong e[RING_VARIABLES];
            e[variable] = (ulong)k;
            e[1 - variable] = (ulong)i;
            fmpz_divexact(c, fmpz_poly_get_coeff_ptr(s->coefficient + k, i), content);
            if (!fmpz_is_zero(c))
                fmpz_mpoly_push_term_fmpz_ui(out, c, e, ring);
        }
    fmpz_mpoly_sort_terms(out, ring);
}

graze_status shift_curve(fmpz_mpoly_t out, graze_context *context, const fmpz_mpoly_t curve,
                         const fmpq *point, const fmpz_mpoly_ctx_t ring) {
    LOCAL_VEC(fmpz, place, 3); /* a, b, c */
    _fmpq_vec_get_fmpz_vec_fmpz(place, place + 2, point, 2);
    HELD(sliced_curve, rows, curve, RING_Y, ring);
    scale_terms(&rows, place + 2, 0);
    TRY(shift_coefficients(&rows, context, place));
    to_polynomial(out, &rows, RING_Y, ring);
    HELD(sliced_curve, columns, out, RING_X, ring);
    TRY(shift_coefficients(&columns, context, place + 1));
    scale_terms(&columns, place + 2, 1);
    to_polynomial(out, &columns, RING_X, ring);
    return GRAZE_OK;
}
