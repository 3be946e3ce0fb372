/* Narrowing the interval of a real algebraic number: by halves, and by secants once the polynomial
 * is nearly straight on it (proofs/claims.md C30). SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/algebraic.h"

#include "base/context/scope.h"

void algebraic_refine(algebraic *x) {
    if (algebraic_is_rational(x))
        return;
    LOCAL(fmpz, middle);
    dyadic_interval *where = &x->where;
    fmpz_add(middle, where->low, where->high);
    where->exponent++;
    int sign = dyadic_sign(x->poly, middle, where->exponent);
    if (sign == 0) {
        algebraic_set_dyadic(x, middle, where->exponent);
    } else if (sign == x->low_sign) {
        fmpz_swap(where->low, middle);
        fmpz_mul_2exp(where->high, where->high, 1);
    } else {
        fmpz_mul_2exp(where->low, where->low, 1);
        fmpz_swap(where->high, middle);
    }
}

/* |p| at the lower end and the sum of |p| at both, with enough places for `kept` significant bits
 * of the sum. */
static void secant_values(fmpz_t low, fmpz_t sum, const algebraic *x, ulong kept) {
    const dyadic_interval *where = &x->where;
    LOCAL(fmpz, error);
    LOCAL(fmpz, other);
    for (ulong places = where->exponent + kept;; places *= 2) {
        dyadic_approximate(low, error, x->poly, where->low, where->exponent, places);
        dyadic_approximate(sum, other, x->poly, where->high, where->exponent, places);
        fmpz_add(error, error, other);
        fmpz_sub(sum, low, sum);
        if (fmpz_bits(sum) > fmpz_bits(error) + kept)
            break;
    }
    fmpz_abs(low, low);
    fmpz_abs(sum, sum);
}

/* The place of the secant's root among 2^gain equal parts of the interval: the nearest of the
 * points 0 ... 2^gain of division. It is a guess, so the values are cut to the digits that matter.
 */
static void secant_point(fmpz_t out, const algebraic *x, ulong gain) {
    LOCAL(fmpz, low);
    LOCAL(fmpz, sum);
    ulong kept = gain + 8;
    secant_values(low, sum, x, kept);
    ulong bits = fmpz_bits(sum);
    fmpz_fdiv_q_2exp(low, low, bits - kept);
    fmpz_fdiv_q_2exp(sum, sum, bits - kept);
    fmpz_mul_2exp(low, low, gain + 1);
    fmpz_add(low, low, sum);
    fmpz_mul_2exp(sum, sum, 1);
    fmpz_fdiv_q(out, low, sum);
}

/* Try the point of division nearest to the secant's root, then the part beside it, on the side on
 * which the root lies by the sign at the point. Returns 1 if the root is found, and x becomes the
 * point or the part; 0 if not, and x is unchanged. The part exists: a point with the sign of the
 * lower end is not the upper end, and one with the sign of the upper end is not the lower. */
static int follow_secant(algebraic *x, ulong gain) {
    HELD(dyadic_interval, part);
    LOCAL(fmpz, point);
    LOCAL(fmpz, width);
    part.exponent = x->where.exponent + gain;
    secant_point(point, x, gain);
    fmpz_sub(width, x->where.high, x->where.low);
    fmpz_mul(point, point, width);
    fmpz_mul_2exp(part.low, x->where.low, gain);
    fmpz_add(part.low, part.low, point);
    fmpz_set(part.high, part.low);
    int sign = dyadic_sign(x->poly, part.low, part.exponent), beyond = 0;
    fmpz *end = sign == x->low_sign ? part.high : part.low;
    if (sign != 0) {
        if (sign == x->low_sign)
            fmpz_add(end, end, width);
        else
            fmpz_sub(end, end, width);
        beyond = dyadic_sign(x->poly, end, part.exponent);
    }
    int found = sign == 0 || beyond != sign;
    if (sign == 0 || beyond == 0)
        algebraic_set_dyadic(x, end, part.exponent);
    else if (found)
        dyadic_interval_swap(&x->where, &part);
    return found;
}

void algebraic_refine_quadratically(algebraic *x, ulong *gain) {
    if (algebraic_is_rational(x))
        return;
    if (follow_secant(x, *gain)) {
        *gain *= 2;
        return;
    }
    algebraic_refine(x);
    *gain = *gain > 1 ? *gain / 2 : 1;
}

graze_status algebraic_bits_limit(graze_context *context) {
    return context_limit(context, GRAZE_LIMIT_BITS,
                         "the binary places of an interval around a root");
}

graze_status algebraic_may_narrow(graze_context *context, const dyadic_interval *interval) {
    if (context && interval->exponent >= context->limits[GRAZE_LIMIT_BITS])
        return algebraic_bits_limit(context);
    return GRAZE_OK;
}

graze_status algebraic_narrow(graze_context *context, algebraic *x, int halvings, ulong *gain) {
    if (algebraic_is_rational(x))
        return GRAZE_OK;
    ulong limbs = x->where.exponent / FLINT_BITS + 1;
    TRY(algebraic_may_narrow(context, &x->where));
    TRY(context_work(context, (ulong)fmpz_poly_length(x->poly) * limbs * limbs));
    if (halvings < CHEAP_HALVINGS)
        algebraic_refine(x);
    else
        algebraic_refine_quadratically(x, gain);
    return GRAZE_OK;
}
