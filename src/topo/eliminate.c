/* Values at integers, and the polynomial through them: each value is quick, and between two the
 * caller may cancel. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "topo/eliminate.h"

#include <flint/fmpz_vec.h>
#include <stdlib.h>

void sliced_init(sliced_curve *out, const fmpz_mpoly_t g, int variable, const curve_list *list) {
    int other = variable == RING_X ? RING_Y : RING_X;
    fmpz_t c;
    fmpz_init(c);
    out->degree = fmpz_mpoly_degree_si(g, variable, list->ring);
    out->total = fmpz_mpoly_total_degree_si(g, list->ring);
    out->coefficient = flint_malloc((size_t)(out->degree + 1) * sizeof *out->coefficient);
    for (slong k = 0; k <= out->degree; k++)
        fmpz_poly_init(out->coefficient + k);
    for (slong k = 0; k < fmpz_mpoly_length(g, list->ring); k++) {
        ulong e[RING_VARIABLES];
        fmpz_mpoly_get_term_exp_ui(e, g, k, list->ring);
        fmpz_mpoly_get_term_coeff_fmpz(c, g, k, list->ring);
        fmpz_poly_set_coeff_fmpz(out->coefficient + e[variable], (slong)e[other], c);
    }
    fmpz_clear(c);
}

void sliced_clear(sliced_curve *s) {
    for (slong k = 0; k <= s->degree; k++)
        fmpz_poly_clear(s->coefficient + k);
    flint_free(s->coefficient);
}

/* The curve where the other variable is `at`; 0 if the degree drops there. */
static int slice_at(fmpz_poly_t out, const sliced_curve *s, const fmpz_t at) {
    fmpz_t value;
    fmpz_init(value);
    fmpz_poly_zero(out);
    for (slong k = 0; k <= s->degree; k++) {
        fmpz_poly_evaluate_fmpz(value, s->coefficient + k, at);
        fmpz_poly_set_coeff_fmpz(out, k, value);
    }
    fmpz_clear(value);
    return fmpz_poly_degree(out) == s->degree;
}

static int value_at(fmpz_t out, const sliced_curve *a, const sliced_curve *b, const fmpz_t at) {
    fmpz_poly_t f, g;
    fmpz_poly_init(f);
    fmpz_poly_init(g);
    int whole = slice_at(f, a, at) && (!b || slice_at(g, b, at));
    if (whole && b)
        fmpz_poly_resultant(out, f, g);
    else if (whole)
        fmpz_poly_discriminant(out, f);
    fmpz_poly_clear(f);
    fmpz_poly_clear(g);
    return whole;
}

static slong degree_bound(const sliced_curve *a, const sliced_curve *b) {
    if (!b)
        return (2 * a->degree - 2) * a->total - a->degree * (a->degree - 1);
    return a->total * b->degree + b->total * a->degree - a->degree * b->degree;
}

graze_status eliminate(fmpz_poly_t out, graze_context *context, const sliced_curve *a,
                       const sliced_curve *b) {
    slong n = degree_bound(a, b) + 1, k = 0;
    fmpz *at = _fmpz_vec_init(n), *value = _fmpz_vec_init(n);
    graze_status status = GRAZE_OK;
    for (slong j = 0; k < n && !status; j++) { /* 0, 1, -1, 2, -2, ... */
        fmpz_set_si(at + k, j % 2 ? (j + 1) / 2 : -j / 2);
        k += value_at(value + k, a, b, at + k);
        status = context_poll(context);
    }
    if (!status)
        fmpz_poly_interpolate_fmpz_vec(out, at, value, n);
    _fmpz_vec_clear(at, n);
    _fmpz_vec_clear(value, n);
    return status;
}
