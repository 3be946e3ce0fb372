/* Integer polynomials in the Bernstein basis of a dyadic interval.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_NUMBER_BERNSTEIN_H
#define GRAZE_NUMBER_BERNSTEIN_H

#include <flint/fmpz_poly.h>
#include "base/number/dyadic.h"

/** `count` signed integers modulo 2^(64 limbs) in two's complement, of `limbs` limbs each, lowest
 * limb first, one after another. */
typedef struct wide_vector {
    slong count, limbs;
    mp_limb_t *limb;
} wide_vector;

static inline mp_limb_t *wide_entry(const wide_vector *v, slong i) {
    return v->limb + i * v->limbs;
}

/** Sign of an entry: -1, 0, 1. */
static inline int wide_sign(const wide_vector *v, slong i) {
    const mp_limb_t *entry = wide_entry(v, i);
    if (entry[v->limbs - 1] >> (FLINT_BITS - 1))
        return -1;
    return !mpn_zero_p(entry, v->limbs);
}

void wide_get_fmpz(fmpz_t out, const wide_vector *v, slong i);

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

/** Bernstein coefficients with one number of limbs; each is less than 2^bits in absolute value. */
typedef struct bernstein_form {
    wide_vector c;
    ulong bits;
} bernstein_form;

/** A new form with the coefficients of bernstein_from_poly. */
void bernstein_form_init(bernstein_form *out, const fmpz_poly_t p, slong degree,
                         const dyadic_interval *interval);
void bernstein_form_clear(bernstein_form *form);

/** Replace a form by that of the left half and make `right` a new form for the right half, both
 * multiplied by one positive integer. */
void bernstein_form_split(bernstein_form *form, bernstein_form *right);

/**
 * Bernstein coefficients on the halves of the interval, multiplied by one positive integer, by de
 * Casteljau's scheme. `left` may be `c`; `right` may not.
 */
void bernstein_split(fmpz *left, fmpz *right, const fmpz *c, slong degree);

/** The number of sign changes in the sequence of coefficients, zeros left out. */
slong bernstein_variations(const bernstein_form *form);

/** If all coefficients other than 0 have one sign, return this sign, which p then has on the open
 * interval; else return 0. p is not zero. */
int bernstein_one_sign(const bernstein_form *form);

#endif
