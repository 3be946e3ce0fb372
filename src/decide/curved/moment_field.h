/* The field of numbers that decide a moment of a trajectory: polynomials in the local time u,
 * modulo the minimal polynomial of an exact time, or as functions on a gap between two times.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_MOMENT_FIELD_H
#define GRAZE_CURVED_MOMENT_FIELD_H

#include <flint/fmpq_poly.h>
#include "base/number/algebraic.h"

/** An element: a polynomial in u, reduced by the modulus. */
typedef fmpq_poly_struct value;

/** A moment: a time, or a gap with a sample time. On a gap an element is zero iff it is the zero
 * polynomial, and its sign is that at the sample. Each non-constant polynomial whose sign was asked
 * for is kept: between the roots of these no answer changes (proofs/curved.md C101). */
typedef struct moment_field {
    graze_context *context;
    algebraic *time;
    fmpq_poly_t modulus; /* irreducible, with the root `time`; zero on a gap */
    fmpz_poly_struct *asked;
    size_t asked_count, asked_capacity;
    unsigned long *work; /* words of products so far, in all fields of a point */
    graze_status
        status; /* the first failure: after it nothing is computed, and answers are invalid */
} moment_field;

/** Make the field of a time; the time's polynomial may be replaced by a factor of it. */
void field_init(moment_field *f, graze_context *context, algebraic *time, int on_gap,
                unsigned long *work);
void field_clear(moment_field *f);

/** Set an element to an integer polynomial in u. */
void field_set(value *out, const moment_field *f, const fmpz_poly_t p);
void field_mul(value *out, moment_field *f, const value *a, const value *b);
/** Count products of words, so that the caller can cancel every few milliseconds, and words of
 * results; beyond the limit `work` of these the status is GRAZE_ELIMIT, without a message. */
void field_charge(moment_field *f, unsigned long products, unsigned long words);
/** out += a b, out -= a b */
void field_addmul(value *out, moment_field *f, const value *a, const value *b);
void field_submul(value *out, moment_field *f, const value *a, const value *b);
/** The sign of an element: -1, 0 or 1; 0 after a failure. */
int field_sign(moment_field *f, const value *a);

/** Allocate `count` zeros as one block; NULL if memory runs out, which becomes the status. */
value *field_vector(moment_field *f, size_t count);
/** Free a vector, which may be NULL. */
void field_vector_clear(value *vector, size_t count);

#endif
