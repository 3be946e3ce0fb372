/* Integer polynomials.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_POLY_H
#define CHECK_POLY_H

#include "base.h"

/** c[0] + c[1] t + ... + c[n-1] t^(n-1), c[n-1] not 0; n = 0 is zero. `room` are initialised. */
typedef struct poly {
    size_t n, room;
    mpz_t *c;
} poly;

void poly_clear(poly *p); /* a poly begins as {0} */
/** At least n coefficients, new ones 0; poly_trim restores the invariant once they are written. */
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
/** a /= b, which is not zero, if that is exact in Z[t]; 1 or 0. If b is primitive it is exact in
 * Z[t] if it is so over the rationals (Gauss). */
int poly_divide(poly *a, const poly *b);
/** A common divisor. That it is the greatest matters to no proof: it shortens. */
void poly_common(poly *out, const poly *a, const poly *b);

/**
 * Scaled Bernstein coefficients C(n, k) b_k of p on [a, b], to degree n, all times one positive
 * integer that depends on n, a and b alone. `out` are n + 1.
 */
void bernstein(mpz_t *out, const poly *p, size_t n, const mpq_t a, const mpq_t b);

/** Signs of one or more coefficients: the first, the last, the least, the greatest, and the number
 * of sign variations, zeros left out. */
typedef struct signs {
    int first, last, least, most;
    size_t changes;
} signs;

signs signs_of(mpz_t *c, size_t count);
/** Signs of the Bernstein coefficients of p on [a, b], to its own degree; p is not zero. */
signs poly_signs(const poly *p, const mpq_t a, const mpq_t b);
/** 1 or -1 if all have this sign, else 0. */
int strict_sign(signs s);

#endif
