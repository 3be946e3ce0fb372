/* Real algebraic numbers: roots of integer polynomials, compared and evaluated exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_ALGEBRAIC_H
#define GRAZE_NUMBER_ALGEBRAIC_H

#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>
#include "base/context/context.h"
#include "base/number/dyadic.h"

/**
 * A real number. Invariant: if `poly` is zero the number is `value`. Otherwise it is the one root
 * of `poly` in the closed interval `where`, a simple root, no end of the interval is a root of
 * `poly`, and `low_sign` is the sign of `poly` at the lower end. Functions that take a number
 * without const may narrow the interval, replace `poly` by a factor, or find the number rational;
 * its value never changes.
 */
typedef struct algebraic {
    fmpq_t value;
    fmpz_poly_t poly;
    dyadic_interval where;
    int low_sign;
} algebraic;

/** Zero. */
void algebraic_init(algebraic *x);
void algebraic_clear(algebraic *x);
void algebraic_set(algebraic *x, const algebraic *y);
void algebraic_set_rational(algebraic *x, const fmpq_t value);

void algebraic_set_dyadic(algebraic *x, const fmpz_t numerator, ulong exponent);

/** 1 if the number is known to be rational and stands in `value`; 0 says nothing. */
int algebraic_is_rational(const algebraic *x);

/** The sign of g at the interval's lower end if g vanishes at the number isolated there, else 0. g
 * divides the number's polynomial, does not vanish at the ends and has at most this one root
 * between them, a simple one. */
int algebraic_sign_before(const fmpz_poly_t g, const dyadic_interval *interval);

/** low <= x <= high. */
void algebraic_bounds(fmpq_t low, fmpq_t high, const algebraic *x);

/** A list of numbers. The items up to `capacity` are initialised; the first `count` are in use. */
typedef struct algebraic_list {
    size_t count, capacity;
    algebraic *item;
} algebraic_list;

void algebraic_list_init(algebraic_list *list);
void algebraic_list_clear(algebraic_list *list);
/** Append a number, which the caller sets; the pointer is valid until the next append. */
algebraic *algebraic_list_append(algebraic_list *list);

#endif
