/* Bernstein coefficients of integer polynomials on dyadic intervals, integers throughout.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "number/bernstein.h"

#include <flint/fmpz_vec.h>

void dyadic_interval_init(dyadic_interval *interval) {
    fmpz_init(interval->low);
    fmpz_init(interval->high);
    interval->exponent = 0;
}

void dyadic_interval_clear(dyadic_interval *interval) {
    fmpz_clear(interval->low);
    fmpz_clear(interval->high);
}

void dyadic_interval_set(dyadic_interval *interval, const dyadic_interval *other) {
    fmpz_set(interval->low, other->low);
    fmpz_set(interval->high, other->high);
    interval->exponent = other->exponent;
}

void dyadic_interval_swap(dyadic_interval *interval, dyadic_interval *other) {
    fmpz_swap(interval->low, other->low);
    fmpz_swap(interval->high, other->high);
    ulong exponent = interval->exponent;
    interval->exponent = other->exponent;
    other->exponent = exponent;
}

void dyadic_interval_set_si(dyadic_interval *interval, slong low, slong high) {
    fmpz_set_si(interval->low, low);
    fmpz_set_si(interval->high, high);
    interval->exponent = 0;
}

void dyadic_interval_halves(dyadic_interval *left, dyadic_interval *right,
                            const dyadic_interval *interval) {
    fmpz_t low, middle, high;
    fmpz_init(low);
    fmpz_init(middle);
    fmpz_init(high);
    fmpz_mul_2exp(low, interval->low, 1);
    fmpz_add(middle, interval->low, interval->high);
    fmpz_mul_2exp(high, interval->high, 1);
    left->exponent = right->exponent = interval->exponent + 1;
    fmpz_swap(left->low, low);
    fmpz_set(left->high, middle);
    fmpz_swap(right->low, middle);
    fmpz_swap(right->high, high);
    fmpz_clear(low);
    fmpz_clear(middle);
    fmpz_clear(high);
}

void dyadic_value(fmpq_t out, const fmpz_t numerator, ulong exponent) {
    fmpz_t denominator;
    fmpz_init(denominator);
    fmpz_one_2exp(denominator, exponent);
    fmpq_set_fmpz_frac(out, numerator, denominator);
    fmpz_clear(denominator);
}

/* Horner's scheme on sum p_i n^i 2^(e (degree - i)), which has the sign of p(n / 2^e). */
int dyadic_sign(const fmpz_poly_t p, const fmpz_t numerator, ulong exponent) {
    slong degree = fmpz_poly_degree(p);
    if (degree < 0)
        return 0;
    fmpz_t value, term;
    fmpz_init_set(value, p->coeffs + degree);
    fmpz_init(term);
    for (slong i = degree - 1; i >= 0; i--) {
        fmpz_mul(value, value, numerator);
        fmpz_mul_2exp(term, p->coeffs + i, exponent * (ulong)(degree - i));
        fmpz_add(value, value, term);
    }
    int sign = fmpz_sgn(value);
    fmpz_clear(value);
    fmpz_clear(term);
    return sign;
}

/* Coefficients 0 ... n of 2^(e n) p((low + (high - low) v) / 2^e) in powers of v. */
static void pull_to_unit(fmpz_poly_t out, const fmpz_poly_t p, slong n,
                         const dyadic_interval *interval) {
    fmpz_poly_set(out, p);
    if (interval->exponent)
        for (slong i = 0; i < fmpz_poly_length(out); i++)
            fmpz_mul_2exp(out->coeffs + i, out->coeffs + i, interval->exponent * (ulong)(n - i));
    if (!fmpz_is_zero(interval->low))
        fmpz_poly_taylor_shift(out, out, interval->low);
    fmpz_t width, power;
    fmpz_init(width);
    fmpz_sub(width, interval->high, interval->low);
    if (!fmpz_is_one(width)) {
        fmpz_init_set(power, width);
        for (slong i = 1; i < fmpz_poly_length(out); i++) {
            fmpz_mul(out->coeffs + i, out->coeffs + i, power);
            fmpz_mul(power, power, width);
        }
        fmpz_clear(power);
    }
    fmpz_clear(width);
}

/* b_j = sum_{i <= j} C(j, i) a_i / C(n, i): divide by the binomials under a common multiple of
 * theirs, then add up Pascal's triangle. */
void bernstein_from_poly(fmpz *out, const fmpz_poly_t p, slong n, const dyadic_interval *interval) {
    fmpz_poly_t unit;
    fmpz_poly_init2(unit, n + 1);
    pull_to_unit(unit, p, n, interval);
    fmpz_t common, binomial, factor;
    fmpz_init_set_ui(common, 1);
    fmpz_init(binomial);
    fmpz_init(factor);
    for (slong i = 1; 2 * i <= n; i++) {
        fmpz_bin_uiui(binomial, (ulong)n, (ulong)i);
        fmpz_lcm(common, common, binomial);
    }
    _fmpz_vec_zero(out, n + 1);
    for (slong i = 0; i < fmpz_poly_length(unit); i++) {
        fmpz_bin_uiui(binomial, (ulong)n, (ulong)i);
        fmpz_divexact(factor, common, binomial);
        fmpz_mul(out + i, unit->coeffs + i, factor);
    }
    for (slong level = 1; level <= n; level++)
        for (slong i = n; i >= level; i--)
            fmpz_add(out + i, out + i, out + i - 1);
    fmpz_clear(common);
    fmpz_clear(binomial);
    fmpz_clear(factor);
    fmpz_poly_clear(unit);
}

/* Without the halvings of de Casteljau's averages: entry i of level k is 2^k times too large, so
 * the left half's coefficient k is scaled by 2^(n - k), the right half's coefficient n - k too. */
void bernstein_split(fmpz *left, fmpz *right, const fmpz *c, slong degree) {
    _fmpz_vec_set(right, c, degree + 1);
    fmpz_mul_2exp(left, right, (ulong)degree);
    for (slong level = 1; level <= degree; level++) {
        for (slong i = 0; i <= degree - level; i++)
            fmpz_add(right + i, right + i, right + i + 1);
        fmpz_mul_2exp(left + level, right, (ulong)(degree - level));
    }
    for (slong i = 0; i <= degree; i++)
        fmpz_mul_2exp(right + i, right + i, (ulong)i);
}

slong bernstein_variations(const fmpz *c, slong degree) {
    slong variations = 0;
    int last = 0;
    for (slong i = 0; i <= degree; i++) {
        int sign = fmpz_sgn(c + i);
        if (sign == 0)
            continue;
        if (last != 0 && sign != last)
            variations++;
        last = sign;
    }
    return variations;
}

int bernstein_one_sign(const fmpz *c, slong degree) {
    int one = 0;
    for (slong i = 0; i <= degree; i++) {
        int sign = fmpz_sgn(c + i);
        if (sign == 0)
            continue;
        if (one != 0 && sign != one)
            return 0;
        one = sign;
    }
    return one;
}
