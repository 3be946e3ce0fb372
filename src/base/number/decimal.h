/* Correctly rounded decimals of rationals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_NUMBER_DECIMAL_H
#define GRAZE_NUMBER_DECIMAL_H

#include <flint/fmpq.h>

/**
 * A number rounded to nearest (ties to even) at `digits` significant decimal digits, malloc'ed;
 * NULL when out of memory. Positional from 10^-5 up to 10^digits, else with an exponent (`1.5e-9`).
 * Trailing zeros are left out where the decimal is the number itself.
 * @param[out] exact 1 if the decimal is the number itself, else 0; may be NULL
 */
char *decimal_of_rational(int *exact, const fmpq_t value, int digits);

/**
 * The finite decimal of a number in that form, all of its digits and no more, malloc'ed; NULL when
 * it has none or memory is out.
 * @param[out] finite 1 if it has one: the denominator divides a power of 10
 */
char *decimal_finite(int *finite, const fmpq_t value);

/** 0.DIGITS * 10^exponent in this form, without trailing zeros if `strip`; malloc'ed, NULL when out
 * of memory. */
char *decimal_layout(int negative, const char *digits, size_t count, slong exponent, int strip);

#endif
