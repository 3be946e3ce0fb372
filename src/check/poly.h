/* Integer polynomials.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_POLY_H
#define CHECK_POLY_H

#include "base.h"

/** c[0] + c[1] t + ... + c[n-1] t^(n-1), c[n-1] not 0; n = 0: the zero polynomial. `room`
 * coefficients are initialised. */
typedef struct poly {
    size_t n, room;
    mpz_t *c;
} poly;

void poly_clear(poly *p); /* a poly begins as {0} */
/** Extend p to at least n coefficients, the new ones 0. After writing them the caller restores the
 * invariant by poly_trim. */
void poly_extend(poly *p, size_t n);
void poly_trim(poly *p);
void poly_set(poly *out, const poly *p);
/** out += a b, or out -= a b for a negative sign; out is neither a nor b. */
void poly_add_product(poly *out, const poly *a, const poly *b, int sign);
/** out += a z */
void poly_add_scaled(poly *out, const poly *a, const mpz_t z);
void poly_scale(poly *p, const mpz_t z);
/** Divide by the greatest common divisor of the coefficients. */
void poly_make_primitive(poly *p);
/** Divide a by b, not zero, if that is exact in Z[t], and return 1; else return 0 and leave a. If b
 * is primitive, a division that is exact over the rationals is exact in Z[t] (Gauss). */
int poly_divide(poly *a, const poly *b);
/** Set `out` to the greatest common divisor of a and b. Proofs use only that it divides both. */
void poly_common(poly *out, const poly *a, const poly *b);

/**
 * Set n + 1 integers to the scaled Bernstein coefficients C(n, k) b_k of p on [a, b], for degree n,
 * all times one positive integer that depends only on n, a and b.
 */
void bernstein(mpz_t *out, const poly *p, size_t n, const mpq_t a, const mpq_t b);

/** Signs of a sequence of coefficients: of the first, of the last, the least and the greatest sign,
 * and the number of sign changes, zeros left out. */
typedef struct signs {
    int first, last, least, most;
    size_t changes;
} signs;

signs signs_of(mpz_t *c, size_t count);
/** Signs of the Bernstein coefficients of p, not zero, on [a, b], for the degree of p. */
signs poly_signs(const poly *p, const mpq_t a, const mpq_t b);
/** 1 or -1 if all coefficients have this sign, else 0. */
int strict_sign(signs s);

#endif
