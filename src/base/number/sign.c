/* The sign of a polynomial at a real algebraic number, by refinement, and by a gcd if it is 0.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/algebraic.h"

#include "base/context/scope.h"
#include "base/number/bernstein.h"
#include "base/number/modular.h"
#include "base/number/simplest.h"

/* Binary places of an interval's ends up to which Bernstein coefficients are cheap. */
enum { COARSE = 63 };
/* From degree LONG_DEGREE on the costs of the two ways to a sign are compared; SLOPE_WORK is a
 * measured ratio of costs. */
enum { LONG_DEGREE = 64, SLOPE_WORK = 32 };
/* Binary places that the first secant is to gain in an interval around a guess. */
enum { GUESS_GAIN = 32 };

/* Sign of q on the interval if its value at the lower end is more than q can change by on the way
 * to the upper one, else 0 (proofs/claims.md C31). The value is known to two binary places more
 * than the interval's ends have. */
static int sign_by_slope(const fmpz_poly_t q, const dyadic_interval *where) {
    slong degree = fmpz_poly_degree(q);
    ulong reach = FLINT_MAX(fmpz_bits(where->low), fmpz_bits(where->high));
    reach = reach > where->exponent ? reach - where->exponent : 0;
    LOCAL(fmpz, value);
    LOCAL(fmpz, error);
    LOCAL(fmpz, change);
    LOCAL(fmpz, term);
    for (slong i = 1; i <= degree; i++) {
        fmpz_mul_ui(term, q->coeffs + i, (ulong)i);
        fmpz_abs(term, term);
        fmpz_mul_2exp(term, term, reach * (ulong)(i - 1));
        fmpz_add(change, change, term);
    }
    fmpz_sub(term, where->high, where->low);
    fmpz_mul(change, change, term);
    fmpz_mul_2exp(change, change, 2);
    dyadic_approximate(value, error, q, where->low, where->exponent, where->exponent + 2);
    fmpz_add(change, change, error);
    return fmpz_cmpabs(value, change) > 0 ? fmpz_sgn(value) : 0;
}

/* Bernstein coefficients of degree n take n^2 sums of numbers that are n times as long as the
 * interval's ends. If q's own coefficients are much shorter, it is faster to narrow the interval
 * until the slope decides. */
static int slope_is_cheaper(const fmpz_poly_t q, const dyadic_interval *where) {
    ulong n = (ulong)fmpz_poly_degree(q), bits = (ulong)FLINT_ABS(fmpz_poly_max_bits(q));
    ulong words = bits / FLINT_BITS + 1;
    return n >= LONG_DEGREE &&
           n * ((bits + n * where->exponent) / FLINT_BITS) > SLOPE_WORK * words * words;
}

/* Sign of q at an irrational x if the interval decides it, else 0. */
static int sign_on_interval(const fmpz_poly_t q, const algebraic *x) {
    if (x->where.exponent > COARSE)
        return sign_by_slope(q, &x->where);
    if (slope_is_cheaper(q, &x->where))
        return sign_by_slope(q, &x->where);
    HELD(bernstein_form, form, q, fmpz_poly_degree(q), &x->where);
    return bernstein_one_sign(&form);
}

/* Whether q vanishes at the irrational x; if so, x's polynomial becomes its common factor with q.
 */
static int vanishes_at(const fmpz_poly_t q, algebraic *x) {
    LOCAL(fmpz_poly, g);
    common_factor(g, x->poly, q);
    int low_sign = algebraic_sign_before(g, &x->where);
    if (low_sign != 0) {
        fmpz_poly_swap(x->poly, g);
        x->low_sign = low_sign;
    }
    return low_sign != 0;
}

/* Take a short interval around a guess of the irrational x, if x's polynomial changes its sign
 * there and the limit on places allows it. */
static int narrow_by_guess(graze_context *context, algebraic *x) {
    HELD(dyadic_interval, part);
    int changes = guess_interval(&part, x->poly, &x->where) &&
                  (!context || part.exponent < context->limits[GRAZE_LIMIT_BITS]) &&
                  dyadic_sign(x->poly, part.low, part.exponent) == x->low_sign &&
                  dyadic_sign(x->poly, part.high, part.exponent) == -x->low_sign;
    if (changes)
        dyadic_interval_swap(&x->where, &part);
    return changes;
}

graze_status algebraic_sign_at(int *out, graze_context *context, const fmpz_poly_t q,
                               algebraic *x) {
    slong degree = fmpz_poly_degree(q);
    *out = degree < 0 ? 0 : fmpz_sgn(q->coeffs);
    if (degree <= 0)
        return GRAZE_OK;
    ulong gain = FIRST_GAIN;
    int step = 0;
    while (!algebraic_is_rational(x)) {
        *out = sign_on_interval(q, x);
        if (*out != 0)
            return GRAZE_OK;
        if (step == CHEAP_HALVINGS) {
            TRY(common_factor_work(context, q, x->poly));
            if (vanishes_at(q, x))
                return GRAZE_OK;
        }
        if (step == 0 && narrow_by_guess(context, x)) {
            step = CHEAP_HALVINGS;
            gain = GUESS_GAIN;
        } else {
            TRY(algebraic_narrow(context, x, step++, &gain));
        }
    }
    *out = rational_sign(q, x->value);
    return GRAZE_OK;
}
