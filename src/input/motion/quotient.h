/* Rational functions of one variable over Q, with the limits acting at every step.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Values are FLINT's fmpz_poly_q: numerator and denominator coprime in Z[u], leading coefficient of
 * the denominator positive. Two values within the limits make a result of at most about twice their
 * size, so it is enough that every result is looked at.
 *
 * The cost of a motion in time and memory is the product of its pieces, their degree and the digits
 * of their coefficients, and no limit on one of the three bounds it. So the work of all results is
 * counted as they are made: w + w^2/64 for a coefficient of w words of 64 bits, and a constant for
 * the operation. A unit of it then takes about 100 ns at most, whatever the three are.
 */
#ifndef GRAZE_MOTION_QUOTIENT_H
#define GRAZE_MOTION_QUOTIENT_H

#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_q.h>
#include "base/context/context.h"

/** A calculation: after the first failure its operations do nothing and `status` keeps the cause.
 */
typedef struct calculation {
    graze_context *context;
    graze_status status;
} calculation;

void quotient_add(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_poly_q_t b);
void quotient_sub(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_poly_q_t b);
void quotient_mul(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_poly_q_t b);
/** GRAZE_EINPUT when b is the zero function. */
void quotient_div(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_poly_q_t b);
/** a^n for any integer n, a^0 = 1; GRAZE_EINPUT for a negative power of zero. */
void quotient_power(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_t n);

/** Bring a quotient of polynomials into lowest terms, the denominator's leading coefficient
 * positive; most are seen to be coprime modulo a prime (proofs/claims.md C29). */
void quotient_reduce(fmpz_poly_q_t a);
/** common = lcm(common, other), but for the sign; neither is zero. */
void polynomial_widen(fmpz_poly_t common, const fmpz_poly_t other);
/** g = gcd(g, p) in Z[u], but for the sign. */
void polynomial_narrow(fmpz_poly_t g, const fmpz_poly_t p);
/** out = p / divisor, which divides p, not zero. */
void polynomial_divide(fmpz_poly_t out, const fmpz_poly_t p, const fmpz_poly_t divisor);
/** The numerator of a over a common denominator, a multiple of its own. */
void quotient_over(fmpz_poly_t out, const fmpz_poly_q_t a, const fmpz_poly_t common);

void quotient_set_rational(fmpz_poly_q_t out, const fmpq_t value);
/** low + (high - low) u. */
void quotient_set_line(fmpz_poly_q_t out, const fmpq_t low, const fmpq_t high);
/** The value at a place that is no pole. */
void quotient_at(fmpq_t out, const fmpz_poly_q_t a, const fmpq_t u);
/** out(u) = a(line(u)), where the denominator of `line` is a constant. `out` is not `a`. */
void quotient_substitute(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a,
                         const fmpz_poly_q_t line);
/** 1 and one of the two roots if a is a square in Q(u), else 0. */
int quotient_square_root(fmpz_poly_q_t out, const fmpz_poly_q_t a);

/** GRAZE_ELIMIT in the calculation if degree or digits of a are past the limits, or the work done
 * for the motion, making a included. */
void quotient_check(calculation *c, const fmpz_poly_q_t a);

/** quotient_check for a polynomial. */
void polynomial_check(calculation *c, const fmpz_poly_t p);

/** Count work; GRAZE_ELIMIT past the limit `work`. */
void calculation_spend(calculation *c, unsigned long work);
/** The work of making a polynomial, taking all coefficients to be as long as the longest. */
unsigned long polynomial_work(const fmpz_poly_t p);

/**
 * Has p, not zero, a root in [0, 1]? If so *found is 1, and low <= the first one <= high, equal
 * when it is seen to be rational.
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED
 */
graze_status polynomial_root(int *found, fmpq_t low, fmpq_t high, graze_context *context,
                             const fmpz_poly_t p);

#endif
