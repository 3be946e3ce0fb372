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

/** Set `out` to the irreducible factor of p that vanishes at the number isolated there; returns its
 * sign at the interval's lower end. p is as g above, but for the first condition; `out` may be p.
 */
int algebraic_factor(fmpz_poly_t out, const fmpz_poly_t p, const dyadic_interval *interval);

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

/* Narrowing the interval. */

/** CHEAP_HALVINGS are made before a gcd decides whether refinement would ever end; FIRST_GAIN is
 * the number of binary places that the first secant is to gain. */
enum { CHEAP_HALVINGS = 4, FIRST_GAIN = 4 };

/* Functions that take many steps ask the context's callback now and then and narrow no interval
 * past the limit `bits`: they return GRAZE_OK, GRAZE_ECANCELED or GRAZE_ELIMIT. A context of NULL
 * has neither callback nor limit. After a failure the numbers have their values still, and *out has
 * no meaning. */

/** Halve the interval. */
void algebraic_refine(algebraic *x);

/**
 * Narrow the interval by the secant through its ends (proofs/claims.md C30): by the factor 2^*gain
 * if the secant points close enough to the root, and then *gain is doubled; else halve the
 * interval, and *gain is halved. Repeated calls in the end double the number of known digits each
 * time.
 * @param[in,out] gain at least 1; FIRST_GAIN at the first call
 */
void algebraic_refine_quadratically(algebraic *x, ulong *gain);

/** Fail with GRAZE_ELIMIT and a message: the ends of an interval have reached the limit `bits`. */
graze_status algebraic_bits_limit(graze_context *context);

/** GRAZE_ELIMIT, with a message, if the interval's ends have reached the limit `bits`, else
 * GRAZE_OK. */
graze_status algebraic_may_narrow(graze_context *context, const dyadic_interval *interval);

/** Narrow the interval: halve it in steps 0 to CHEAP_HALVINGS - 1, then use secants.
 * @param[in,out] gain as for algebraic_refine_quadratically */
graze_status algebraic_narrow(graze_context *context, algebraic *x, int step, ulong *gain);

/** out = a d - b c, which may be one of these. */
void cross_terms(fmpz_poly_t out, const fmpz_poly_t a, const fmpz_poly_t b, const fmpz_poly_t c,
                 const fmpz_poly_t d);

/** The Wronskian x y' - x' y. */
void wronskian(fmpz_poly_t out, const fmpz_poly_t x, const fmpz_poly_t y);

/* Signs and order. */

/** Set *out to the sign of q at x: -1, 0, 1 (proofs/claims.md C27). */
graze_status algebraic_sign_at(int *out, graze_context *context, const fmpz_poly_t q, algebraic *x);

/** Set *out to the sign of x - y: -1, 0, 1 (proofs/claims.md C26). Equal numbers share interval and
 * polynomial afterwards. */
graze_status algebraic_compare(int *out, graze_context *context, algebraic *x, algebraic *y);

/** Set `out` to a dyadic number strictly between x and y, x < y. */
graze_status algebraic_between(fmpq_t out, graze_context *context, algebraic *x, algebraic *y);

/** Set *out to the least m for which a multiple of 2^-m lies strictly between x and y, x < y, both
 * irrational and in intervals that have at most an end in common. */
graze_status algebraic_places_between(ulong *out, graze_context *context, algebraic *x,
                                      algebraic *y);

/** Sort pointers to numbers ascending; equal numbers keep their order. */
graze_status algebraic_sort(algebraic **order, size_t count, graze_context *context);

/**
 * Sort, and keep one pointer for equal numbers; *count becomes the number of different ones.
 * @param[out] rank_of its entry k becomes the rank of the number first[k]; NULL, with `first` NULL,
 * for no ranks
 */
graze_status algebraic_sort_once(algebraic **order, size_t *count, graze_context *context,
                                 const algebraic *first, size_t *rank_of);

#endif
