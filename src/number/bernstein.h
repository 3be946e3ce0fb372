/* Integer polynomials in the Bernstein basis of a dyadic interval (proofs: Descartes' rule on
 * Bernstein coefficients). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_BERNSTEIN_H
#define GRAZE_NUMBER_BERNSTEIN_H

#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>
#include "number/wide.h"

/** A closed interval [low / 2^exponent, high / 2^exponent], low <= high. */
typedef struct dyadic_interval {
    fmpz_t low, high;
    ulong exponent;
} dyadic_interval;

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

/** p(numerator / 2^exponent) 2^(exponent degree(p)), an integer; 0 if p is zero. */
void dyadic_evaluate(fmpz_t out, const fmpz_poly_t p, const fmpz_t numerator, ulong exponent);

/**
 * 2^places p(numerator / 2^exponent), within `error` of it (proofs/separation.md C40).
 * @param[out] out, error initialised, neither the numerator
 */
void dyadic_approximate(fmpz_t out, fmpz_t error, const fmpz_poly_t p, const fmpz_t numerator,
                        ulong exponent, ulong places);

/** Sign of p at numerator / 2^exponent. */
int dyadic_sign(const fmpz_poly_t p, const fmpz_t numerator, ulong exponent);

/** Sign of p at a rational. */
int rational_sign(const fmpz_poly_t p, const fmpq_t x);

/** Sign of numerator / 2^exponent - x. */
int dyadic_compare(const fmpz_t numerator, ulong exponent, const fmpq_t x);

/** The least common multiple of the binomials C(n, 0) ... C(n, n), n >= 0. */
void common_binomial(fmpz_t out, slong n);

/**
 * Bernstein coefficients of p on an interval, all multiplied by one positive integer that depends
 * on the degree and the interval alone.
 * @param[out] out degree + 1 initialised integers
 * @param degree at least the degree of p and at least 0
 */
void bernstein_from_poly(fmpz *out, const fmpz_poly_t p, slong degree,
                         const dyadic_interval *interval);

/** Bernstein coefficients that share a width; every one is less than 2^bits in size. */
typedef struct bernstein_form {
    wide_vector c;
    ulong bits;
} bernstein_form;

/** What bernstein_from_poly makes, in a new form. */
void bernstein_form_init(bernstein_form *out, const fmpz_poly_t p, slong degree,
                         const dyadic_interval *interval);
void bernstein_form_clear(bernstein_form *form);

/** The form becomes that of the left half, `right` a new one for the right half, both multiplied by
 * one positive integer. */
void bernstein_form_split(bernstein_form *form, bernstein_form *right);

/**
 * Bernstein coefficients on the halves of the interval, multiplied by one positive integer, by de
 * Casteljau's scheme. `left` may be `c`; `right` may not.
 */
void bernstein_split(fmpz *left, fmpz *right, const fmpz *c, slong degree);

/** Sign changes in the sequence, zeros left out. */
slong bernstein_variations(const bernstein_form *form);

/** The one sign that p has on the open interval if no coefficient contradicts it, else 0. p not
 * zero. */
int bernstein_one_sign(const bernstein_form *form);

#endif
