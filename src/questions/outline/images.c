/* Numbers that are images of algebraic numbers, by resultants that are interpolated.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/outline/arcs.h"

#include <flint/fmpz_poly_factor.h>
#include <flint/fmpz_vec.h>
#include "base/context/scope.h"
#include "base/number/isolate.h"

void slope_product(fmpz_poly_t out, const fmpz_poly_t x, const fmpz_poly_t y) {
    LOCAL(fmpz_poly, slope);
    LOCAL(fmpz_poly, product);
    fmpz_poly_derivative(slope, x);
    fmpz_poly_mul(product, slope, y);
    fmpz_poly_derivative(slope, y);
    fmpz_poly_mul(slope, slope, x);
    fmpz_poly_sub(out, slope, product);
}

void number_minimal(fmpz_poly_t out, const algebraic *x) {
    fmpz_poly_zero(out);
    if (algebraic_is_rational(x)) {
        fmpz_poly_set_coeff_fmpz(out, 0, fmpq_numref(x->value));
        fmpz_poly_neg(out, out);
        fmpz_poly_set_coeff_fmpz(out, 1, fmpq_denref(x->value));
        return;
    }
    LOCAL(fmpz_poly_factor, factors);
    fmpz_poly_factor(factors, x->poly);
    for (slong k = 0; k < factors->num; k++)
        if (algebraic_sign_before(factors->p + k, &x->where))
            fmpz_poly_set(out, factors->p + k);
    if (fmpz_sgn(fmpz_poly_lead(out)) < 0)
        fmpz_poly_neg(out, out);
}

/* At x = k the value is the resultant of q and k den - num, which has the degree of q in x. Where
 * the second polynomial loses degree, the leading coefficient of q makes up for it. */
void image_polynomial(fmpz_poly_t out, const fmpz_poly_t q, const fmpz_poly_t num,
                      const fmpz_poly_t den) {
    slong n = fmpz_poly_degree(q);
    slong most = FLINT_MAX(fmpz_poly_degree(num), fmpz_poly_degree(den));
    LOCAL_VEC(fmpz, at, 2 * n + 2);
    fmpz *value = at + n + 1;
    LOCAL(fmpz_poly, p);
    LOCAL(fmpz, power);
    for (slong k = 0; k <= n; k++) {
        fmpz_set_si(at + k, k);
        fmpz_poly_scalar_mul_si(p, den, k);
        fmpz_poly_sub(p, p, num);
        if (fmpz_poly_is_zero(p))
            continue;
        fmpz_poly_resultant(value + k, q, p);
        fmpz_pow_ui(power, fmpz_poly_lead(q), (ulong)(most - fmpz_poly_degree(p)));
        fmpz_mul(value + k, value + k, power);
    }
    fmpz_poly_interpolate_fmpz_vec(out, at, value, n + 1);
}

graze_status number_in_bracket(int *found, algebraic *out, graze_context *context,
                               const fmpz_poly_t p, const bracket *where, ulong places) {
    HELD(dyadic_interval, interval);
    HELD(algebraic_list, roots);
    fmpz_set(interval.low, where->low);
    fmpz_set(interval.high, where->high);
    if (fmpz_equal(interval.low, interval.high))
        fmpz_add_ui(interval.high, interval.high, 1);
    interval.exponent = places;
    TRY(algebraic_roots(&roots, context, p, &interval));
    *found = roots.count == 1;
    if (*found)
        algebraic_set(out, &roots.item[0]);
    return GRAZE_OK;
}

/* The quotient of two values at a bracket; 0 where too few places are kept. */
static int bracket_quotient(bracket *out, const fmpz_poly_t num, const fmpz_poly_t den,
                            const bracket *at, ulong places) {
    HELD(bracket, below);
    bracket_evaluate(&below, den, at, places);
    bracket_evaluate(out, num, at, places);
    return bracket_div(out, out, &below, places);
}

graze_status image_number(algebraic *out, graze_context *context, const fmpz_poly_t num,
                          const fmpz_poly_t den, algebraic *x) {
    LOCAL(fmpz_poly, q);
    LOCAL(fmpz_poly, p);
    if (algebraic_is_rational(x)) {
        LOCAL_VEC(fmpq, value, 2);
        fmpz_poly_evaluate_fmpq(value, num, x->value);
        fmpz_poly_evaluate_fmpq(value + 1, den, x->value);
        fmpq_div(value, value, value + 1);
        algebraic_set_rational(out, value);
        return GRAZE_OK;
    }
    number_minimal(q, x);
    image_polynomial(p, q, num, den);
    /* q is irreducible, so p is a power of an irreducible polynomial. */
    fmpz_poly_derivative(q, p);
    fmpz_poly_gcd(q, q, p);
    fmpz_poly_div(p, p, q);
    fmpz_poly_primitive_part(p, p);
    HELD(bracket, at);
    int found = 0;
    for (ulong places = 64; !found; places *= 2) {
        TRY(bracket_of_number(&at, context, x, places));
        if (bracket_quotient(&at, num, den, &at, places))
            TRY(number_in_bracket(&found, out, context, p, &at, places));
    }
    return GRAZE_OK;
}
