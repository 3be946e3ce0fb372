/* Compares real algebraic numbers, by refinement, and equal ones by a gcd; finds dyadic numbers
 * between two.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/algebraic.h"

#include "base/context/scope.h"
#include "base/number/modular.h"

/* Sign of a / 2^e - b / 2^f. */
static int compare_dyadics(const fmpz_t a, ulong e, const fmpz_t b, ulong f) {
    ulong exponent = FLINT_MAX(e, f);
    LOCAL(fmpz, left);
    LOCAL(fmpz, right);
    fmpz_mul_2exp(left, a, exponent - e);
    fmpz_mul_2exp(right, b, exponent - f);
    return fmpz_cmp(left, right);
}

static int compare_with_rational(algebraic *x, const fmpq_t r) {
    if (dyadic_compare(x->where.low, x->where.exponent, r) >= 0)
        return 1;
    if (dyadic_compare(x->where.high, x->where.exponent, r) <= 0)
        return -1;
    int sign = rational_sign(x->poly, r);
    if (sign == 0)
        algebraic_set_rational(x, r);
    return sign == 0 ? 0 : sign == x->low_sign ? 1 : -1;
}

/* The intersection of two intervals, which is not empty. */
static void intersect(dyadic_interval *out, const dyadic_interval *a, const dyadic_interval *b) {
    ulong exponent = FLINT_MAX(a->exponent, b->exponent);
    int low = compare_dyadics(a->low, a->exponent, b->low, b->exponent) > 0;
    int high = compare_dyadics(a->high, a->exponent, b->high, b->exponent) < 0;
    fmpz_mul_2exp(out->low, low ? a->low : b->low, exponent - (low ? a : b)->exponent);
    fmpz_mul_2exp(out->high, high ? a->high : b->high, exponent - (high ? a : b)->exponent);
    out->exponent = exponent;
}

/* If the two irrational numbers, isolated in overlapping intervals, are equal, let them share their
 * common factor and the overlap. */
static int unite_if_equal(algebraic *x, algebraic *y) {
    LOCAL(fmpz_poly, g);
    int equal = 0;
    if (common_factor(g, x->poly, y->poly) > 0) {
        HELD(dyadic_interval, overlap);
        intersect(&overlap, &x->where, &y->where);
        int low_sign = algebraic_sign_before(g, &overlap);
        equal = low_sign != 0;
        if (equal) {
            fmpz_poly_swap(x->poly, g);
            dyadic_interval_swap(&x->where, &overlap);
            x->low_sign = low_sign;
            algebraic_set(y, x);
        }
    }
    return equal;
}

/* Whether two irrational numbers have one polynomial and one interval. */
static int is_same(const algebraic *x, const algebraic *y) {
    return x->where.exponent == y->where.exponent && fmpz_equal(x->where.low, y->where.low) &&
           fmpz_equal(x->where.high, y->where.high) && fmpz_poly_equal(x->poly, y->poly);
}

/* Whether the intervals, or rational values, decide the order; if so, *out is the order. A number
 * found equal to a rational one becomes rational. */
static int order_is_known(int *out, algebraic *x, algebraic *y) {
    const dyadic_interval *a = &x->where, *b = &y->where;
    *out = 0;
    if (algebraic_is_rational(x) && algebraic_is_rational(y))
        *out = fmpq_cmp(x->value, y->value) > 0 ? 1 : -(fmpq_cmp(x->value, y->value) < 0);
    else if (algebraic_is_rational(y))
        *out = compare_with_rational(x, y->value);
    else if (algebraic_is_rational(x))
        *out = -compare_with_rational(y, x->value);
    else if (compare_dyadics(a->high, a->exponent, b->low, b->exponent) <= 0)
        *out = -1;
    else if (compare_dyadics(b->high, b->exponent, a->low, a->exponent) <= 0)
        *out = 1;
    return *out != 0 || algebraic_is_rational(x) || is_same(x, y);
}

/* The integer e for which the interval's width is at least 2^(e - 1) and less than 2^e; WORD_MIN
 * for a rational number. */
static slong width_exponent(const algebraic *x) {
    if (algebraic_is_rational(x))
        return WORD_MIN;
    LOCAL(fmpz, width);
    fmpz_sub(width, x->where.high, x->where.low);
    return (slong)fmpz_bits(width) - (slong)x->where.exponent;
}

/* Narrow the wider one of two intervals, so that both shrink to nothing. If both were narrowed each
 * time, one interval would become far too short while the other is still halved. */
static graze_status narrow_wider(graze_context *context, algebraic *x, algebraic *y, int step,
                                 ulong *gain) {
    int second = width_exponent(y) > width_exponent(x);
    return algebraic_narrow(context, second ? y : x, step, &gain[second]);
}

graze_status algebraic_compare(int *out, graze_context *context, algebraic *x, algebraic *y) {
    ulong gain[] = {FIRST_GAIN, FIRST_GAIN};
    for (int steps = 0;; steps++) {
        if (order_is_known(out, x, y))
            return GRAZE_OK;
        if (steps == 2 * CHEAP_HALVINGS) {
            TRY(common_factor_work(context, x->poly, y->poly));
            if (unite_if_equal(x, y)) {
                *out = 0;
                return GRAZE_OK;
            }
        }
        TRY(narrow_wider(context, x, y, steps / 2, gain));
    }
}

/* The dyadic number with the least exponent strictly between two rationals a < b, the least of them
 * if it is an integer. For any e with multiples of 2^-e between a and b, it is the one of them that
 * ends in the most zero bits. The highest bit in which the last multiple up to a and the last one
 * below b differ tells how many. */
static void simplest_dyadic(fmpq_t out, const fmpq_t a, const fmpq_t b) {
    LOCAL(fmpq, scaled);
    LOCAL(fmpz, before);
    LOCAL(fmpz, last);
    LOCAL(fmpz, differ);
    fmpq_sub(scaled, b, a);
    ulong top = fmpz_bits(fmpq_numref(scaled)), bottom = fmpz_bits(fmpq_denref(scaled));
    ulong exponent = bottom >= top ? bottom - top + 2 : 0;
    fmpq_mul_2exp(scaled, a, exponent);
    fmpz_fdiv_q(before, fmpq_numref(scaled), fmpq_denref(scaled));
    fmpq_mul_2exp(scaled, b, exponent);
    fmpz_cdiv_q(last, fmpq_numref(scaled), fmpq_denref(scaled));
    fmpz_sub_ui(last, last, 1);
    fmpz_xor(differ, before, last);
    ulong zeros = fmpz_sgn(differ) < 0 ? exponent : fmpz_bits(differ) - 1;
    zeros = FLINT_MIN(zeros, exponent);
    fmpz_fdiv_q_2exp(before, before, zeros);
    fmpz_add_ui(before, before, 1);
    dyadic_value(out, before, exponent - zeros);
}

graze_status algebraic_between(fmpq_t out, graze_context *context, algebraic *x, algebraic *y) {
    LOCAL_VEC(fmpq, low, 4);
    fmpq *below = low + 1, *above = low + 2, *high = low + 3;
    ulong gain[] = {1, 1};
    for (;;) {
        algebraic_bounds(low, below, x);
        algebraic_bounds(above, high, y);
        if (fmpq_cmp(below, above) < 0)
            break;
        TRY(narrow_wider(context, x, y, CHEAP_HALVINGS, gain));
    }
    simplest_dyadic(out, below, above);
    return GRAZE_OK;
}

/* Narrow the intervals until the dyadic number of least exponent between their outer ends lies in
 * neither: then no simpler one lies between x and y. It is not x or y, which are irrational. */
graze_status algebraic_places_between(ulong *out, graze_context *context, algebraic *x,
                                      algebraic *y) {
    LOCAL_VEC(fmpq, low, 5);
    fmpq *below = low + 1, *above = low + 2, *high = low + 3, *between = low + 4;
    ulong gain[] = {FIRST_GAIN, FIRST_GAIN};
    for (;;) {
        algebraic_bounds(low, below, x);
        algebraic_bounds(above, high, y);
        simplest_dyadic(between, low, high);
        int in_x = fmpq_cmp(between, below)<0, in_y = fmpq_cmp(between, above)> 0;
        if (!in_x && !in_y)
            break;
        TRY(algebraic_narrow(context, in_x ? x : y, CHEAP_HALVINGS, &gain[in_y]));
    }
    *out = fmpz_val2(fmpq_denref(between));
    return GRAZE_OK;
}

/* Merge order[0 ... middle - 1] and order[middle ... count - 1]; `spare` has room for the first
 * run. */
static graze_status merge_runs(algebraic **order, size_t middle, size_t count, algebraic **spare,
                               graze_context *context) {
    size_t i = 0, j = middle, k = 0;
    for (size_t m = 0; m < middle; m++)
        spare[m] = order[m];
    while (i < middle && j < count) {
        int sign;
        TRY(algebraic_compare(&sign, context, spare[i], order[j]));
        order[k++] = sign <= 0 ? spare[i++] : order[j++];
    }
    while (i < middle)
        order[k++] = spare[i++];
    return GRAZE_OK;
}

static graze_status sort_run(algebraic **order, size_t count, algebraic **spare,
                             graze_context *context) {
    size_t middle = count / 2;
    if (count < 2)
        return GRAZE_OK;
    TRY(sort_run(order, middle, spare, context));
    TRY(sort_run(order + middle, count - middle, spare, context));
    return merge_runs(order, middle, count, spare, context);
}

graze_status algebraic_sort(algebraic **order, size_t count, graze_context *context) {
    algebraic **spare = flint_malloc((count / 2 + 1) * sizeof *spare);
    graze_status status = sort_run(order, count, spare, context);
    flint_free(spare);
    return status;
}

graze_status algebraic_sort_once(algebraic **order, size_t *count, graze_context *context,
                                 const algebraic *first, size_t *rank_of) {
    size_t kept = 0;
    graze_status status = algebraic_sort(order, *count, context);
    for (size_t k = 0; k < *count && !status; k++) {
        int differ = 1;
        if (kept > 0)
            status = algebraic_compare(&differ, context, order[kept - 1], order[k]);
        if (rank_of)
            rank_of[order[k] - first] = kept - (differ == 0);
        if (differ)
            order[kept++] = order[k];
    }
    *count = kept;
    return status;
}
