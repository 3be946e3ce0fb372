/* Roots that are simple fractions, divided out of a polynomial.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_SIMPLEST_H
#define GRAZE_NUMBER_SIMPLEST_H

#include "base/number/dyadic.h"

/**
 * If the fraction of least denominator in an interval is a root, divide by its linear factor to its
 * full multiplicity. Intervals below 0, or with long ends, are not looked at.
 * @param[out] root the fraction
 * @param[out] rest the quotient, which does not vanish there
 * @param[out] empty the quotient certainly has no root in the interval
 * @param p         of degree 1 or more
 * @return 1; or 0, and neither is set
 */
int divide_by_simplest(fmpq_t root, fmpz_poly_t rest, int *empty, const fmpz_poly_t p,
                       const dyadic_interval *interval);

/** A short part of an interval in which a root may be, by a guess in doubles; 0 if there is none.
 */
int guess_interval(dyadic_interval *out, const fmpz_poly_t p, const dyadic_interval *interval);

#endif
