/* Polynomials that certainly have no root in an interval, by one value in doubles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/rootless.h"

#include <math.h>

/* Polynomials of higher degree are left undecided. Interval ends of up to PLACES binary places are
 * exact as doubles.
 */
enum { ROOTLESS_DEGREE = 16, PLACES = 50, LEAST_EXPONENT = -900 };

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
