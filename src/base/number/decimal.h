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
 * The finite decimal of a number with all its digits, laid out as by decimal_of_rational,
 * malloc'ed; NULL if the number has none or memory is short.
 * @param[out] finite 1 if there is one: the denominator divides a power of 10
 */
char *decimal_finite(int *finite, const fmpq_t value);

/** The number 0.DIGITS * 10^exponent, laid out as by decimal_of_rational, without trailing zeros if
 * `strip`; malloc'ed, NULL when out of memory. */
char *decimal_layout(int negative, const char *digits, size_t count, slong exponent, int strip);

#endif
