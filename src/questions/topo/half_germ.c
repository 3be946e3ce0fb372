/* Forms on a plane's directions, in the charts of these. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "base/number/sign.h"
#include "questions/topo/cover.h"

void half_germ_init(half_germ *half) {
    fmpq_poly_init(half->form);
    fmpq_poly_init(half->reach);
    fmpq_poly_init(half->turn);
    half->has_reach = half->has_turn = 0;
}

void half_germ_clear(half_germ *half) {
    fmpq_poly_clear(half->form);
    fmpq_poly_clear(half->reach);
    fmpq_poly_clear(half->turn);
}

void half_in_chart(fmpz_poly_t out, const fmpq_poly_t form, slong degree, direction_chart chart) {
    LOCAL(fmpq_poly, p);
    fmpq_poly_set(p, form);
    if (chart.swapped)
        fmpq_poly_reverse(p, p, degree + 1);
    fmpq_poly_get_numerator(out, p);
    if (chart.opposite && degree % 2 == 1)
        fmpz_poly_neg(out, out);
}

graze_status half_is_valid(int *out, const half_germ *half, graze_context *context,
                           direction_chart chart, algebraic *at) {
    int sign = 0;
    LOCAL(fmpz_poly, p);
    *out = 1;
    if (half->has_reach) {
        half_in_chart(p, half->reach, 1, chart);
        TRY(algebraic_sign_at(&sign, context, p, at));
        *out = sign > 0;
    }
    if (half->has_turn && *out) {
        half_in_chart(p, half->turn, 1, chart);
        TRY(algebraic_sign_at(&sign, context, p, at));
        *out = sign >= 0;
    }
    return GRAZE_OK;
}
