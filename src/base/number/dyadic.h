/* Intervals with dyadic ends, and integer polynomials at dyadic numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_DYADIC_H
#define GRAZE_NUMBER_DYADIC_H

#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>

/** A closed interval [low / 2^exponent, high / 2^exponent], low <= high. */
typedef struct dyadic_interval {
    fmpz_t low, high;
    ulong exponent;
} dyadic_interval;

/** [0, 1]. */
extern const dyadic_interval unit_interval;

void dyadic_interval_init(dyadic_interval *interval);
void dyadic_interval_clear(dyadic_interval *interval);
void dyadic_interval_set(dyadic_interval *interval, const dyadic_interval *other);
void dyadic_interval_swap(dyadic_interval *interval, dyadic_interval *other);
/** The interval [low, high] of integers. */
void dyadic_interval_set_si(dyadic_interval *interval, slong low, slong high);
/** Both halves; either may be the interval itself, but not both. */
void dyadic_interval_halves(dyadic_interval *left, dyadic_interval *right,
                            const dyadic_interval *interval);

/** The rational numerator / 2^exponent in lowest terms. */
void dyadic_value(fmpq_t out, const fmpz_t numerator, ulong exponent);

/** Multiply by 2^places, a negative number of places too. */
void rational_shift(fmpq_t x, slong places);

/** Set `out` to 2^(e n) p((low + (high - low) v) / 2^e), in powers of v, for the degree n of p and
 * an interval with exponent e. */
void dyadic_pull(fmpz_poly_t out, const fmpz_poly_t p, const dyadic_interval *interval);

/**
 * Set `out` to within `error` of 2^places p(numerator / 2^exponent) (proofs/separation.md C40).
 * @param[out] out, error initialised; neither is the numerator
 */
void dyadic_approximate(fmpz_t out, fmpz_t error, const fmpz_poly_t p, const fmpz_t numerator,
                        ulong exponent, ulong places);

/** Sign of p at numerator / 2^exponent. */
int dyadic_sign(const fmpz_poly_t p, const fmpz_t numerator, ulong exponent);

/** Sign of p at a rational. */
int rational_sign(const fmpz_poly_t p, const fmpq_t x);

/** Sign of numerator / 2^exponent - x. */
int dyadic_compare(const fmpz_t numerator, ulong exponent, const fmpq_t x);

#endif
