/* Real algebraic numbers: roots of integer polynomials, compared and evaluated exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_ALGEBRAIC_H
#define GRAZE_NUMBER_ALGEBRAIC_H

#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>
#include "context/context.h"
#include "number/bernstein.h"

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

/** Halvings tried before a gcd is asked whether refinement would ever end; digits that a secant is
 * first asked for. */
enum { CHEAP_HALVINGS = 4, FIRST_GAIN = 4 };

/** Zero. */
void algebraic_init(algebraic *x);
void algebraic_clear(algebraic *x);
void algebraic_set(algebraic *x, const algebraic *y);
void algebraic_set_rational(algebraic *x, const fmpq_t value);

void algebraic_set_dyadic(algebraic *x, const fmpz_t numerator, ulong exponent);

/** 1 if the number is known to be rational and stands in `value`; 0 says nothing. */
int algebraic_is_rational(const algebraic *x);

/** Halve the interval. */
void algebraic_refine(algebraic *x);

/**
 * Narrow the interval by the secant through its ends (proofs/claims.md C30): by 2^*gain where the
 * secant points close enough to the root, and then *gain is doubled; else halve the interval, and
 * *gain is halved. Repeated, it doubles the number of known digits each time in the end.
 * @param[in,out] gain at least 1; 4 to start with
 */
void algebraic_refine_quadratically(algebraic *x, ulong *gain);

/* What takes many steps asks the context's callback now and then and narrows no interval past the
 * limit `bits`: these functions return GRAZE_OK, GRAZE_ECANCELED or GRAZE_ELIMIT. The context may
 * be NULL, for neither. Without GRAZE_OK the numbers keep their values, and *out is not set. */

/** GRAZE_ELIMIT if the interval has as many binary places as are allowed. */
graze_status algebraic_may_narrow(graze_context *context, const dyadic_interval *interval);

/** Narrow the interval: by halves for the first steps, which are numbered from 0, then by secants.
 * @param[in,out] gain as above, FIRST_GAIN to start with */
graze_status algebraic_narrow(graze_context *context, algebraic *x, int step, ulong *gain);

/** *out: sign of x - y: -1, 0, 1 (proofs/claims.md C26). Equal numbers share interval and
 * polynomial afterwards. */
graze_status algebraic_compare(int *out, graze_context *context, algebraic *x, algebraic *y);

/** *out: sign of q at x: -1, 0, 1 (proofs/claims.md C27). */
graze_status algebraic_sign_at(int *out, graze_context *context, const fmpz_poly_t q, algebraic *x);

/** A dyadic number strictly between x and y, x < y. */
graze_status algebraic_between(fmpq_t out, graze_context *context, algebraic *x, algebraic *y);

/** The least m for which a multiple of 2^-m lies strictly between x and y, x < y, both irrational
 * and in intervals that have at most an end in common. */
graze_status algebraic_places_between(ulong *out, graze_context *context, algebraic *x,
                                      algebraic *y);

/** Order pointers to numbers ascending, equal ones as they came. */
graze_status algebraic_sort(algebraic **order, size_t count, graze_context *context);

/** low <= x <= high. */
void algebraic_bounds(fmpq_t low, fmpq_t high, const algebraic *x);

/** A list of numbers. Each item is initialised up to `capacity`; `count` are in use. */
typedef struct algebraic_list {
    size_t count, capacity;
    algebraic *item;
} algebraic_list;

void algebraic_list_init(algebraic_list *list);
void algebraic_list_clear(algebraic_list *list);
/** One more number at the end; the pointer lives until the next append. */
algebraic *algebraic_list_append(algebraic_list *list);

/**
 * Append all real roots of q in a closed interval, each once, ascending (proofs/claims.md C24,
 * C25). Without GRAZE_OK some may be missing.
 * @param q not zero
 */
graze_status algebraic_roots(algebraic_list *list, graze_context *context, const fmpz_poly_t q,
                             const dyadic_interval *interval);

#endif
