/* The numbers by which a moment of a trajectory is decided: polynomials in the local time u, modulo
 * the minimal polynomial of an exact time, or as functions on a gap between two times.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_MOMENT_FIELD_H
#define GRAZE_CURVED_MOMENT_FIELD_H

#include <flint/fmpq_poly.h>
#include "base/number/algebraic.h"

/** An element: a polynomial in u, reduced by the modulus. */
typedef fmpq_poly_struct value;

/**
 * A time, or a gap with one time in it as a sample. On a gap an element is zero iff it is the zero
 * polynomial, its sign is that at the sample, and each polynomial that is no constant and whose
 * sign was asked for is kept: between their roots no answer changes (proofs/curved.md C101).
 */
typedef struct moment_field {
    graze_context *context;
    algebraic *time;
    fmpq_poly_t modulus; /* irreducible, with the root `time`; zero on a gap */
    fmpz_poly_struct *asked;
    size_t asked_count, asked_capacity;
    unsigned long *work; /* words of products so far, of all fields of a point */
    graze_status
        status; /* the first failure, after which nothing is computed and no answer counts */
} moment_field;

/** The field of a time; the time's polynomial may become a factor of itself. */
void field_init(moment_field *f, graze_context *context, algebraic *time, int on_gap,
                unsigned long *work);
void field_clear(moment_field *f);

/** The element that an integer polynomial in u is. */
void field_set(value *out, const moment_field *f, const fmpz_poly_t p);
void field_mul(value *out, moment_field *f, const value *a, const value *b);
/** Count products of words, so that the caller can cancel every few milliseconds, and words of
 * results, which the limit `work` bounds: past it the status is GRAZE_ELIMIT, without a message. */
void field_charge(moment_field *f, unsigned long products, unsigned long words);
/** out += a b, out -= a b */
void field_addmul(value *out, moment_field *f, const value *a, const value *b);
void field_submul(value *out, moment_field *f, const value *a, const value *b);
/** -1, 0 or 1; 0 after a failure. */
int field_sign(moment_field *f, const value *a);

/** `count` zeros, as one block; NULL without memory, which is recorded. */
value *field_vector(moment_field *f, size_t count);
/** NULL is harmless. */
void field_vector_clear(value *vector, size_t count);

#endif
