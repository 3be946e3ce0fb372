/* Roots that are simple fractions, divided out of a polynomial; intervals without roots.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_SIMPLEST_H
#define GRAZE_NUMBER_SIMPLEST_H

#include "base/number/dyadic.h"

/**
 * If the fraction of least denominator in an interval is a root, divide by its linear factor to its
 * full multiplicity. Intervals with a negative end, or long ends, are not looked at.
 * @param[out] root the fraction
 * @param[out] rest the quotient, which does not vanish there
 * @param[out] empty 1 if the quotient certainly has no root in the interval, else 0
 * @param p         of degree 1 or more
 * @return 1 if p was divided; else 0, and `root` and `rest` are not set
 */
int divide_by_simplest(fmpq_t root, fmpz_poly_t rest, int *empty, const fmpz_poly_t p,
                       const dyadic_interval *interval);

/** Set `out` to a short part of an interval that may hold a root, by a guess in doubles. Returns 0
 * if no guess is made.
 */
int guess_interval(dyadic_interval *out, const fmpz_poly_t p, const dyadic_interval *interval);

/** 1 if p, not zero, certainly has no root in the interval (proofs/roots.md C92); 0 says nothing,
 * and is the answer for an interval that is not in [0, 1]. Any rounding mode may be set. */
int certainly_rootless(const fmpz_poly_t p, const dyadic_interval *interval);

#endif
