/* Bernstein coefficients on short intervals: Taylor coefficients at the lower end by repeated
 * division, rounded down at every step.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/local.h"

#include <flint/fmpz_vec.h>
#include "base/context/scope.h"
#include "base/number/bernstein.h"

void local_interval_init(local_interval *x) {
    fmpz_init(x->low);
    fmpz_init(x->width);
    x->places = 0;
}

void local_interval_clear(local_interval *x) {
    fmpz_clear(x->low);
    fmpz_clear(x->width);
}

void local_interval_set(local_interval *x, const local_interval *other) {
    fmpz_set(x->low, other->low);
    fmpz_set(x->width, other->width);
    x->places = other->places;
}

void local_interval_high(fmpz_t out, const local_interval *x) {
    fmpz_add(out, x->low, x->width);
}

void local_form_init(local_form *form, slong degree) {
    form->degree = degree;
    form->b = _fmpz_vec_init(degree + 1);
    fmpz_init(form->error);
}

void local_form_clear(local_form *form) {
    _fmpz_vec_clear(form->b, form->degree + 1);
    fmpz_clear(form->error);
}

/* The index of the last Taylor coefficient that matters: the terms behind it add up to less than
 * one unit of the precision (C41). The width is less than 2^-narrow. */
static slong last_term(const fmpz_poly_t q, ulong narrow, ulong precision) {
    slong n = fmpz_poly_degree(q);
    ulong size = (ulong)FLINT_ABS(fmpz_poly_max_bits(q)) + FLINT_BIT_COUNT(n + 1);
    ulong step = narrow - FLINT_BIT_COUNT(n), terms = (precision + size + 1) / step + 1;
    return terms < (ulong)n ? (slong)terms : n;
}

/* s[0] ... s[last] become 2^precision times Taylor coefficients at the lower end: in round k, s[n]
 * ... s[k] are the values of Horner's scheme for the quotient that round k - 1 has left. */
static graze_status taylor(fmpz *s, graze_context *context, slong n, slong last,
                           const local_interval *x) {
    LOCAL(fmpz, product);
    for (slong k = 0; k <= last; k++)
        for (slong i = n - 1; i >= k; i--) {
            fmpz_mul(product, s + i + 1, x->low);
            TRY(context_work(context, fmpz_size(product) * (fmpz_size(x->low) + 1)));
            fmpz_fdiv_q_2exp(product, product, x->places);
            fmpz_add(s + i, s + i, product);
        }
    return GRAZE_OK;
}

/* s[i] becomes the i-th difference of the first i + 1 Bernstein coefficients, which all get the
 * factor `common`. */
static void take_differences(fmpz *s, slong n, slong last, const local_interval *x,
                             const fmpz_t common) {
    LOCAL(fmpz, power);
    fmpz_set_ui(power, 1);
    LOCAL(fmpz, binomial);
    fmpz_set_ui(binomial, 1);
    LOCAL(fmpz, factor);
    for (slong i = 0; i <= last; i++) {
        fmpz_mul(s + i, s + i, power);
        fmpz_fdiv_q_2exp(s + i, s + i, x->places * (ulong)i);
        fmpz_divexact(factor, common, binomial);
        fmpz_mul(s + i, s + i, factor);
        fmpz_mul(power, power, x->width);
        fmpz_mul_ui(binomial, binomial, (ulong)(n - i));
        fmpz_divexact_ui(binomial, binomial, (ulong)(i + 1));
    }
}

/* By C41 rounding costs 2 (n + 1) units in the Taylor coefficients and at most n + 1 with the
 * powers of the width, and the terms left out cost one. */
graze_status local_form_set(local_form *form, graze_context *context, const fmpz_poly_t q,
                            const local_interval *x, ulong precision) {
    slong n = form->degree;
    slong last = last_term(q, x->places - fmpz_bits(x->width), precision);
    LOCAL_VEC(fmpz, s, n + 1);
    LOCAL(fmpz, common);
    _fmpz_vec_scalar_mul_2exp(s, q->coeffs, n + 1, precision);
    TRY(taylor(s, context, n, last, x));
    common_binomial(common, n);
    take_differences(s, n, last, x, common);
    for (slong j = 0; j <= n; j++) {
        fmpz_set(form->b + j, s);
        for (slong i = 0; i < last; i++)
            fmpz_add(s + i, s + i, s + i + 1);
    }
    fmpz_mul_ui(form->error, common, 3 * (ulong)n + 4);
    return GRAZE_OK;
}

int local_form_is_sharp(const local_form *form, ulong bits) {
    return (ulong)FLINT_ABS(_fmpz_vec_max_bits(form->b, form->degree + 1)) >
           fmpz_bits(form->error) + bits;
}

/* best[s] is the most changes with which the signs so far can end in - (s = 0) or + (s = 1). A
 * coefficient whose sign is not known may have either sign; if it is zero, the count does not
 * change. */
slong local_form_variations(const local_form *form, int first, int last) {
    slong n = form->degree, never = -(n + 2), best[2] = {never, never};
    int any = 0;
    for (slong j = 0; j <= n; j++) {
        int end = j == 0 || j == n, sign = j == 0 ? first : last;
        if (!end)
            sign = fmpz_cmpabs(form->b + j, form->error) > 0 ? fmpz_sgn(form->b + j) : 0;
        if (end && sign == 0)
            continue;
        slong minus = any ? FLINT_MAX(best[0], best[1] + 1) : 0;
        slong plus = any ? FLINT_MAX(best[1], best[0] + 1) : 0;
        best[0] = sign > 0 ? never : minus;
        best[1] = sign < 0 ? never : plus;
        any = 1;
    }
    return any ? FLINT_MAX(best[0], best[1]) : 0;
}

void local_form_center(fmpz_t out, const local_form *form, slong order, ulong gain) {
    slong n = form->degree;
    LOCAL_VEC(fmpz, d, n + 1);
    LOCAL(fmpz, down);
    _fmpz_vec_set(d, form->b, n + 1);
    for (slong k = 0; k < order; k++)
        for (slong j = 0; j < n - k; j++)
            fmpz_sub(d + j, d + j + 1, d + j);
    fmpz_sub(down, d, d + n - order);
    fmpz_mul_2exp(out, d, gain + 1);
    fmpz_add(out, out, down);
    fmpz_mul_2exp(down, down, 1);
    if (fmpz_is_zero(down))
        fmpz_zero(out);
    else
        fmpz_fdiv_q(out, out, down);
    fmpz_set_ui(d, 1);
    fmpz_mul_2exp(d, d, gain);
    if (fmpz_sgn(out) < 0)
        fmpz_zero(out);
    else if (fmpz_cmp(out, d) > 0)
        fmpz_set(out, d);
}
