/* Values and signs of integer polynomials at dyadic numbers. A value that would be long is computed
 * to a few binary places first, then to more (proofs/separation.md C40).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/dyadic.h"

#include "base/context/scope.h"

/* An exact value of up to SHORT_VALUE bits costs less than approximations; these begin with
 * FIRST_PLACES binary places. */
enum { SHORT_VALUE = 8192, FIRST_PLACES = 64 };

void dyadic_value(fmpq_t out, const fmpz_t numerator, ulong exponent) {
    LOCAL(fmpz, denominator);
    fmpz_one_2exp(denominator, exponent);
    fmpq_set_fmpz_frac(out, numerator, denominator);
}

void rational_shift(fmpq_t x, slong places) {
    (places < 0 ? fmpq_div_2exp : fmpq_mul_2exp)(x, x, (ulong)FLINT_ABS(places));
}

/* The least r >= 0 with |numerator / 2^exponent| <= 2^r, or one more. */
static ulong reach_of(const fmpz_t numerator, ulong exponent) {
    ulong bits = fmpz_bits(numerator);
    return bits > exponent ? bits - exponent : 0;
}

/* Each step of Horner's scheme rounds down once, and multiplies the error so far by x. */
void dyadic_approximate(fmpz_t out, fmpz_t error, const fmpz_poly_t p, const fmpz_t numerator,
                        ulong exponent, ulong places) {
    slong degree = fmpz_poly_degree(p);
    LOCAL(fmpz, value);
    LOCAL(fmpz, term);
    for (slong i = degree; i >= 0; i--) {
        fmpz_mul(value, value, numerator);
        fmpz_fdiv_q_2exp(value, value, exponent);
        fmpz_mul_2exp(term, p->coeffs + i, places);
        fmpz_add(value, value, term);
    }
    fmpz_swap(out, value);
    fmpz_set_si(error, degree > 0 ? degree : 0);
    if (degree > 0)
        fmpz_mul_2exp(error, error, reach_of(numerator, exponent) * (ulong)(degree - 1));
}

/* The sign of p at numerator / 2^exponent, which is not a root of p. */
static int sign_by_places(const fmpz_poly_t p, const fmpz_t numerator, ulong exponent) {
    ulong lost = reach_of(numerator, exponent) * (ulong)fmpz_poly_degree(p);
    LOCAL(fmpz, value);
    LOCAL(fmpz, error);
    for (ulong places = FIRST_PLACES;; places *= 2) {
        dyadic_approximate(value, error, p, numerator, exponent, places + lost);
        if (fmpz_cmpabs(value, error) > 0)
            break;
    }
    return fmpz_sgn(value);
}

/* Horner's scheme on sum p_i n^i 2^(e (degree - i)), which has the sign of p(n / 2^e), unless that
 * is long. A root m / 2^e in lowest terms has 2^e dividing the leading coefficient, so a number
 * with a longer denominator is not a root. */
int dyadic_sign(const fmpz_poly_t p, const fmpz_t numerator, ulong exponent) {
    slong degree = fmpz_poly_degree(p);
    if (degree <= 0 || fmpz_is_zero(numerator))
        return degree < 0 ? 0 : fmpz_sgn(p->coeffs);
    ulong shared = fmpz_val2(numerator), own = exponent > shared ? exponent - shared : 0;
    if (exponent > SHORT_VALUE / (ulong)degree && own > fmpz_val2(fmpz_poly_lead(p)))
        return sign_by_places(p, numerator, exponent);
    LOCAL(fmpz, value);
    LOCAL(fmpz, term);
    for (slong i = degree; i >= 0; i--) {
        fmpz_mul(value, value, numerator);
        fmpz_mul_2exp(term, p->coeffs + i, exponent * (ulong)(degree - i));
        fmpz_add(value, value, term);
    }
    return fmpz_sgn(value);
}

/* Horner's scheme on sum p_i n^i d^(degree - i), without a division. */
int rational_sign(const fmpz_poly_t p, const fmpq_t x) {
    const fmpz *denominator = fmpq_denref(x);
    ulong exponent = fmpz_val2(denominator);
    if (fmpz_bits(denominator) == exponent + 1)
        return dyadic_sign(p, fmpq_numref(x), exponent);
    slong degree = fmpz_poly_degree(p);
    LOCAL(fmpz, value);
    LOCAL(fmpz, power);
    fmpz_set_ui(power, 1);
    for (slong i = degree; i >= 0; i--) {
        fmpz_mul(value, value, fmpq_numref(x));
        fmpz_addmul(value, p->coeffs + i, power);
        if (i > 0)
            fmpz_mul(power, power, denominator);
    }
    return fmpz_sgn(value);
}

int dyadic_compare(const fmpz_t numerator, ulong exponent, const fmpq_t x) {
    LOCAL(fmpz, a);
    LOCAL(fmpz, b);
    fmpz_mul(a, numerator, fmpq_denref(x));
    fmpz_mul_2exp(b, fmpq_numref(x), exponent);
    int order = fmpz_cmp(a, b);
    return order > 0 ? 1 : -(order < 0);
}

void dyadic_pull(fmpz_poly_t out, const fmpz_poly_t p, const dyadic_interval *interval) {
    slong n = fmpz_poly_degree(p);
    LOCAL(fmpz, width);
    LOCAL(fmpz, power);
    fmpz_set_ui(power, 1);
    fmpz_sub(width, interval->high, interval->low);
    fmpz_poly_set(out, p);
    for (slong i = 0; i <= n; i++)
        fmpz_mul_2exp(out->coeffs + i, out->coeffs + i, interval->exponent * (ulong)(n - i));
    fmpz_poly_taylor_shift(out, out, interval->low);
    for (slong i = 0; i <= n; i++) {
        fmpz_mul(out->coeffs + i, out->coeffs + i, power);
        fmpz_mul(power, power, width);
    }
}

const dyadic_interval unit_interval = {.high = {1}};

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
    LOCAL(fmpz, low);
    LOCAL(fmpz, middle);
    LOCAL(fmpz, high);
    fmpz_mul_2exp(low, interval->low, 1);
    fmpz_add(middle, interval->low, interval->high);
    fmpz_mul_2exp(high, interval->high, 1);
    left->exponent = right->exponent = interval->exponent + 1;
    fmpz_swap(left->low, low);
    fmpz_set(left->high, middle);
    fmpz_swap(right->low, middle);
    fmpz_swap(right->high, high);
}
