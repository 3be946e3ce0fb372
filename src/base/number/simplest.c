/* The fraction of least denominator in an interval, by Euclid's algorithm on its ends, and whether
 * a polynomial vanishes there, by Horner's scheme in integers: nothing is taken for a root that is
 * none; guesses, and intervals without a root, by doubles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/simplest.h"

#include <math.h>
#include "base/context/scope.h"

/* Interval ends have fewer than LONGEST binary digits and fewer than LONGEST places; the ends
 * around a guess have GUESS_PLACES. Guesses are made up to GUESS_DEGREE, in GUESS_STEPS steps at
 * most. */
enum { LONGEST = 60, GUESS_PLACES = 45, GUESS_DEGREE = 24, GUESS_STEPS = 20 };

/* Polynomials of higher degree are not decided by doubles. Interval ends of up to PLACES binary
 * places are exact as doubles. */
enum { ROOTLESS_DEGREE = 16, PLACES = 50, LEAST_EXPONENT = -900 };

/* The fraction p / q of least denominator with a / b <= p / q <= c / d, all of them at least 0: the
 * least integer in there if there is one; else both ends have the integral part n, and p / q is n +
 * 1 / x, where x is the fraction of least denominator between d / (c - n d) and b / (a - n b). */
static void simplest_between(slong *p, slong *q, slong a, slong b, slong c, slong d) {
    slong n = a / b, rest = a % b;
    if (rest == 0 || n < c / d) {
        *p = n + (rest != 0);
        *q = 1;
        return;
    }
    simplest_between(q, p, d, c - n * d, b, rest);
    *p += n * *q;
}

/* Divide p by b x - a, with a and b coprime. Returns 1 if it divides p, and then the quotient has
 * integer coefficients; else 0. */
static int divide_linear(fmpz_poly_t out, const fmpz_poly_t p, slong a, slong b) {
    slong n = fmpz_poly_degree(p);
    const fmpz numerator[] = {a};
    LOCAL(fmpz, rest);
    fmpz_set(rest, fmpz_poly_lead(p));
    fmpz_poly_fit_length(out, n);
    int divides = 1;
    for (slong i = n - 1; i >= 0 && divides; i--) {
        divides = b == 1 || fmpz_divisible_si(rest, b);
        if (divides) {
            fmpz_divexact_si(out->coeffs + i, rest, b);
            fmpz_set(rest, p->coeffs + i);
            fmpz_addmul(rest, out->coeffs + i, numerator);
        }
    }
    divides = divides && fmpz_is_zero(rest);
    _fmpz_poly_set_length(out, divides ? n : 0);
    return divides;
}

/* The coefficient divided by 2^top, at most 1 in absolute value; 0 if that is below
 * 2^LEAST_EXPONENT. */
static double scaled_coefficient(const fmpz_t coefficient, slong top) {
    slong exponent;
    double mantissa = fmpz_get_d_2exp(&exponent, coefficient);
    exponent -= top;
    return exponent < LEAST_EXPONENT ? 0 : ldexp(mantissa, (int)exponent);
}

/* p has no root if its value at the middle exceeds the most by which p can change from the middle
 * to an end plus a bound of the rounding errors. */
int certainly_rootless(const fmpz_poly_t p, const dyadic_interval *interval) {
    slong n = fmpz_poly_degree(p), top = FLINT_ABS(fmpz_poly_max_bits(p));
    if (n > ROOTLESS_DEGREE || interval->exponent > PLACES || fmpz_sgn(interval->low) < 0 ||
        fmpz_cmp_ui(interval->high, (ulong)1 << interval->exponent) > 0)
        return 0;
    double unit = ldexp(1, -(int)interval->exponent);
    double low = fmpz_get_d(interval->low) * unit, high = fmpz_get_d(interval->high) * unit;
    double middle = 0.5 * (low + high), reach = 0.5 * (high - low) + 0x1p-50;
    double value = 0, slope = 0, sum = 0;
    for (slong i = n; i >= 0; i--) {
        double c = scaled_coefficient(p->coeffs + i, top);
        value = value * middle + c;
        slope += (double)i * fabs(c);
        sum += fabs(c);
    }
    return fabs(value) > 1.001 * reach * slope + 0x1p-40 * sum;
}

int divide_by_simplest(fmpq_t root, fmpz_poly_t rest, int *empty, const fmpz_poly_t p,
                       const dyadic_interval *interval) {
    slong a, b;
    *empty = 0;
    if (interval->exponent >= LONGEST || fmpz_sgn(interval->low) < 0 ||
        fmpz_bits(interval->high) >= LONGEST)
        return 0;
    slong unit = (slong)1 << interval->exponent;
    simplest_between(&a, &b, fmpz_get_si(interval->low), unit, fmpz_get_si(interval->high), unit);
    LOCAL(fmpz_poly, next);
    int divided = 0;
    while (divide_linear(next, divided ? rest : p, a, b)) {
        fmpz_poly_swap(rest, next);
        divided = 1;
        *empty = certainly_rootless(rest, interval);
        if (*empty)
            break;
    }
    if (divided)
        fmpq_set_si(root, a, (ulong)b);
    return divided;
}

/* Newton's method in doubles from the middle of [low, high]; a step past an end stops there. */
static double near_root(const fmpz_poly_t p, double low, double high) {
    double c[GUESS_DEGREE + 1] = {0}, x = 0.5 * (low + high);
    slong n = fmpz_poly_degree(p), top = FLINT_ABS(fmpz_poly_max_bits(p));
    for (slong i = 0; i <= n; i++)
        c[i] = scaled_coefficient(p->coeffs + i, top);
    for (int step = 0; step < GUESS_STEPS; step++) {
        double value = c[n], slope = 0, last = x;
        for (slong i = n - 1; i >= 0; i--) {
            slope = slope * x + value;
            value = value * x + c[i];
        }
        if (slope != 0)
            x = fmin(fmax(x - value / slope, low), high);
        if (!(fabs(x - last) > 0x1p-50))
            break;
    }
    return x;
}

int guess_interval(dyadic_interval *out, const fmpz_poly_t p, const dyadic_interval *interval) {
    slong n = fmpz_poly_degree(p);
    if (n < 1 || n > GUESS_DEGREE || interval->exponent > GUESS_PLACES ||
        fmpz_bits(interval->low) >= LONGEST || fmpz_bits(interval->high) >= LONGEST)
        return 0;
    double unit = ldexp(1, -(int)interval->exponent);
    double x = near_root(p, fmpz_get_d(interval->low) * unit, fmpz_get_d(interval->high) * unit);
    LOCAL(fmpz, end);
    out->exponent = GUESS_PLACES;
    fmpz_set_d(out->low, floor(ldexp(x, GUESS_PLACES)) - 2);
    fmpz_add_ui(out->high, out->low, 5);
    fmpz_mul_2exp(end, interval->low, GUESS_PLACES - interval->exponent);
    if (fmpz_cmp(out->low, end) < 0)
        fmpz_set(out->low, end);
    fmpz_mul_2exp(end, interval->high, GUESS_PLACES - interval->exponent);
    if (fmpz_cmp(out->high, end) > 0)
        fmpz_set(out->high, end);
    return fmpz_cmp(out->low, out->high) < 0;
}
