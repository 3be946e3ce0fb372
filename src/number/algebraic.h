/* Real algebraic numbers in [0, 1]: roots of integer polynomials, compared and evaluated exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_ALGEBRAIC_H
#define GRAZE_NUMBER_ALGEBRAIC_H

#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>

/**
 * A real number, rational or a root of `poly`. Invariant: if poly is zero the number is `low`, and
 * high = low. Otherwise poly is squarefree of degree >= 2, low < number < high are dyadic, poly has
 * exactly one root in [low, high], and it is not an end point. Refining narrows low and high and
 * changes no other thing.
 */
typedef struct algebraic {
    fmpq_t low, high;
    fmpz_poly_t poly;
} algebraic;

void algebraic_init(algebraic *x);
void algebraic_clear(algebraic *x);
void algebraic_set(algebraic *x, const algebraic *y);
void algebraic_set_rational(algebraic *x, const fmpq_t value);
int algebraic_is_rational_known(const algebraic *x);

/** Halve the isolating interval; a root met at the middle makes the number rational. */
void algebraic_refine(algebraic *x);

/** Sign of x - y: -1, 0, 1. Refines both. (theory K3, K4) */
int algebraic_compare(algebraic *x, algebraic *y);

/** Sign of q at x: -1, 0, 1. Refines x. (theory K2) */
int algebraic_sign_at(const fmpz_poly_t q, algebraic *x);

/** A rational strictly between x < y, with a small denominator. Refines both. */
void algebraic_between(fmpq_t out, algebraic *x, algebraic *y);

/** A list of numbers, ascending. */
typedef struct algebraic_list {
    size_t count, capacity;
    algebraic *item;
} algebraic_list;

void algebraic_list_init(algebraic_list *list);
void algebraic_list_clear(algebraic_list *list);
/** A new number at the end, uninitialised value 0; the pointer lives until the next append. */
algebraic *algebraic_list_append(algebraic_list *list);

/** All real roots of q (not zero) in the closed interval [a, b], each once, ascending, appended.
 * (theory K1) */
void algebraic_roots(algebraic_list *list, const fmpz_poly_t q, const fmpq_t a, const fmpq_t b);

#endif
