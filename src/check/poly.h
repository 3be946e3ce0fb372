/* Integer polynomials, and quotients of them.
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

void poly_init(poly *p);
void poly_clear(poly *p);
/** Set to n coefficients that are zero and may be written; poly_trim restores the invariant. */
void poly_zeros(poly *p, size_t n);
void poly_trim(poly *p);
/** One more coefficient behind the last, 0 until it is written; then poly_trim. */
mpz_t *poly_next(poly *p);
void poly_set(poly *out, const poly *p);
void poly_set_z(poly *out, const mpz_t value);
void poly_add(poly *out, const poly *a, const poly *b);
void poly_sub(poly *out, const poly *a, const poly *b);
void poly_mul(poly *out, const poly *a, const poly *b);
/** out += a z */
void poly_add_scaled(poly *out, const poly *a, const mpz_t z);
void poly_scale(poly *p, const mpz_t z);
/** Divide by the greatest common divisor of the coefficients. */
void poly_make_primitive(poly *p);
/** out = a / b if that is exact in Z[t]; 1 or 0. If b is primitive it is exact in Z[t] if it is so
 * over the rationals (Gauss). */
int poly_divide(poly *out, const poly *a, const poly *b);
/** A common divisor. That it is the greatest matters to no proof: it shortens. */
void poly_common(poly *out, const poly *a, const poly *b);
/** out = p(x) */
void poly_value(mpq_t out, const poly *p, const mpq_t x);

/** num / den, den not zero. */
typedef struct fraction {
    poly num, den;
} fraction;

void fraction_init(fraction *f); /* zero */
void fraction_clear(fraction *f);
void fraction_set(fraction *out, const fraction *f);
void fraction_set_q(fraction *out, const mpq_t value);
/** out = a OP b, OP one of + - * /; out may be a or b. Gives up on a division by zero and past the
 * caps. */
void fraction_apply(fraction *out, char op, const fraction *a, const fraction *b);
/** out = f(a + b t) */
void fraction_shift(fraction *out, const fraction *f, const mpq_t a, const mpq_t b);
/** The value at x; 0 where the denominator vanishes. */
int fraction_value(mpq_t out, const fraction *f, const mpq_t x);
/** 1 and the value if it is a constant. */
int fraction_constant(mpq_t out, const fraction *f);

#endif
