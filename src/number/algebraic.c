/* Real algebraic numbers: comparison and signs by refinement, equality by gcd.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "number/algebraic.h"

#include <flint/fmpz_vec.h>

/* Halvings tried before a gcd is asked whether refinement would ever end. */
enum { CHEAP_HALVINGS = 4 };

void algebraic_init(algebraic *x) {
    fmpq_init(x->value);
    fmpz_poly_init(x->poly);
    dyadic_interval_init(&x->where);
}

void algebraic_clear(algebraic *x) {
    fmpq_clear(x->value);
    fmpz_poly_clear(x->poly);
    dyadic_interval_clear(&x->where);
}

void algebraic_set(algebraic *x, const algebraic *y) {
    fmpq_set(x->value, y->value);
    fmpz_poly_set(x->poly, y->poly);
    dyadic_interval_set(&x->where, &y->where);
}

void algebraic_set_rational(algebraic *x, const fmpq_t value) {
    fmpq_set(x->value, value);
    fmpz_poly_zero(x->poly);
}

int algebraic_is_rational(const algebraic *x) {
    return fmpz_poly_is_zero(x->poly);
}

void algebraic_set_dyadic(algebraic *x, const fmpz_t numerator, ulong exponent) {
    dyadic_value(x->value, numerator, exponent);
    fmpz_poly_zero(x->poly);
}

void algebraic_refine(algebraic *x) {
    if (algebraic_is_rational(x))
        return;
    dyadic_interval left, right;
    dyadic_interval_init(&left);
    dyadic_interval_init(&right);
    dyadic_interval_halves(&left, &right, &x->where);
    int middle = dyadic_sign(x->poly, left.high, left.exponent);
    if (middle == 0)
        algebraic_set_dyadic(x, left.high, left.exponent);
    else if (middle == dyadic_sign(x->poly, left.low, left.exponent))
        dyadic_interval_swap(&x->where, &right);
    else
        dyadic_interval_swap(&x->where, &left);
    dyadic_interval_clear(&left);
    dyadic_interval_clear(&right);
}

/* Bring two dyadic intervals to one exponent, so that their ends compare as integers. */
static void align(dyadic_interval *a, dyadic_interval *b) {
    if (a->exponent > b->exponent) {
        align(b, a);
        return;
    }
    ulong shift = b->exponent - a->exponent;
    fmpz_mul_2exp(a->low, a->low, shift);
    fmpz_mul_2exp(a->high, a->high, shift);
    a->exponent = b->exponent;
}

/* Whether g, which divides the polynomial of a number isolated in an interval whose ends are no
 * roots of g, vanishes at the number: it has at most that one root there, and a simple one. */
static int vanishes_within(const fmpz_poly_t g, const dyadic_interval *interval) {
    return fmpz_poly_degree(g) > 0 && dyadic_sign(g, interval->low, interval->exponent) !=
                                          dyadic_sign(g, interval->high, interval->exponent);
}

static int compare_with_rational(algebraic *x, const fmpq_t r) {
    fmpq_t low, high;
    fmpq_init(low);
    fmpq_init(high);
    algebraic_bounds(low, high, x);
    int result;
    if (fmpq_cmp(r, low) <= 0) {
        result = 1;
    } else if (fmpq_cmp(r, high) >= 0) {
        result = -1;
    } else {
        fmpq_t at;
        fmpq_init(at);
        fmpz_poly_evaluate_fmpq(at, x->poly, r);
        int sign = fmpq_sgn(at);
        result = sign == 0                                                       ? 0
                 : sign == dyadic_sign(x->poly, x->where.low, x->where.exponent) ? 1
                                                                                 : -1;
        if (sign == 0)
            algebraic_set_rational(x, r);
        fmpq_clear(at);
    }
    fmpq_clear(low);
    fmpq_clear(high);
    return result;
}

/* If the two irrational numbers, isolated in overlapping intervals, are equal, let them share their
 * common factor and the overlap. */
static int unite_if_equal(algebraic *x, algebraic *y) {
    fmpz_poly_t g;
    dyadic_interval overlap;
    fmpz_poly_init(g);
    dyadic_interval_init(&overlap);
    fmpz_poly_gcd(g, x->poly, y->poly);
    align(&x->where, &y->where);
    overlap.exponent = x->where.exponent;
    fmpz_set(overlap.low, fmpz_cmp(x->where.low, y->where.low) > 0 ? x->where.low : y->where.low);
    fmpz_set(overlap.high,
             fmpz_cmp(x->where.high, y->where.high) < 0 ? x->where.high : y->where.high);
    int equal = vanishes_within(g, &overlap);
    if (equal) {
        fmpz_poly_set(x->poly, g);
        fmpz_poly_swap(y->poly, g);
        dyadic_interval_set(&x->where, &overlap);
        dyadic_interval_swap(&y->where, &overlap);
    }
    fmpz_poly_clear(g);
    dyadic_interval_clear(&overlap);
    return equal;
}

/* Both irrational, in intervals of one exponent, and given by the same data. */
static int is_same(const algebraic *x, const algebraic *y) {
    return fmpz_equal(x->where.low, y->where.low) && fmpz_equal(x->where.high, y->where.high) &&
           fmpz_poly_equal(x->poly, y->poly);
}

int algebraic_compare(algebraic *x, algebraic *y) {
    for (int halvings = 0;; halvings++) {
        if (algebraic_is_rational(x) && algebraic_is_rational(y))
            return fmpq_cmp(x->value, y->value) > 0 ? 1 : -(fmpq_cmp(x->value, y->value) < 0);
        if (algebraic_is_rational(y))
            return compare_with_rational(x, y->value);
        if (algebraic_is_rational(x))
            return -compare_with_rational(y, x->value);
        align(&x->where, &y->where);
        if (fmpz_cmp(x->where.high, y->where.low) <= 0)
            return -1;
        if (fmpz_cmp(y->where.high, x->where.low) <= 0)
            return 1;
        if (is_same(x, y) || (halvings == CHEAP_HALVINGS && unite_if_equal(x, y)))
            return 0;
        algebraic_refine(x);
        algebraic_refine(y);
    }
}

/* Sign of q at an irrational x if its Bernstein coefficients on the interval tell, else 0. */
static int sign_on_interval(const fmpz_poly_t q, const algebraic *x) {
    slong degree = fmpz_poly_degree(q);
    fmpz *c = _fmpz_vec_init(degree + 1);
    bernstein_from_poly(c, q, degree, &x->where);
    int sign = bernstein_one_sign(c, degree);
    _fmpz_vec_clear(c, degree + 1);
    return sign;
}

/* If q vanishes at the irrational x, reduce x's polynomial to the common factor. */
static int vanishes_at(const fmpz_poly_t q, algebraic *x) {
    fmpz_poly_t g;
    fmpz_poly_init(g);
    fmpz_poly_gcd(g, x->poly, q);
    int zero = vanishes_within(g, &x->where);
    if (zero)
        fmpz_poly_swap(x->poly, g);
    fmpz_poly_clear(g);
    return zero;
}

int algebraic_sign_at(const fmpz_poly_t q, algebraic *x) {
    if (fmpz_poly_is_zero(q))
        return 0;
    for (int halvings = 0; !algebraic_is_rational(x); halvings++) {
        int sign = sign_on_interval(q, x);
        if (sign != 0)
            return sign;
        if (halvings == CHEAP_HALVINGS && vanishes_at(q, x))
            return 0;
        algebraic_refine(x);
    }
    fmpq_t at;
    fmpq_init(at);
    fmpz_poly_evaluate_fmpq(at, q, x->value);
    int sign = fmpq_sgn(at);
    fmpq_clear(at);
    return sign;
}

void algebraic_bounds(fmpq_t low, fmpq_t high, const algebraic *x) {
    if (algebraic_is_rational(x)) {
        fmpq_set(low, x->value);
        fmpq_set(high, x->value);
        return;
    }
    dyadic_value(low, x->where.low, x->where.exponent);
    dyadic_value(high, x->where.high, x->where.exponent);
}

/* The dyadic number with the least exponent strictly between two rationals a < b. */
static void simplest_dyadic(fmpq_t out, const fmpq_t a, const fmpq_t b) {
    fmpq_t scaled;
    fmpz_t integer;
    fmpq_init(scaled);
    fmpz_init(integer);
    for (ulong exponent = 0;; exponent++) {
        fmpq_mul_2exp(scaled, a, exponent);
        fmpz_fdiv_q(integer, fmpq_numref(scaled), fmpq_denref(scaled));
        fmpz_add_ui(integer, integer, 1);
        fmpq_mul_2exp(scaled, b, exponent);
        if (fmpq_cmp_fmpz(scaled, integer) > 0) {
            dyadic_value(out, integer, exponent);
            break;
        }
    }
    fmpq_clear(scaled);
    fmpz_clear(integer);
}

void algebraic_between(fmpq_t out, algebraic *x, algebraic *y) {
    fmpq_t low, below, above, high;
    fmpq_init(low);
    fmpq_init(below);
    fmpq_init(above);
    fmpq_init(high);
    for (;;) {
        algebraic_bounds(low, below, x);
        algebraic_bounds(above, high, y);
        if (fmpq_cmp(below, above) < 0)
            break;
        algebraic_refine(x);
        algebraic_refine(y);
    }
    simplest_dyadic(out, below, above);
    fmpq_clear(low);
    fmpq_clear(below);
    fmpq_clear(above);
    fmpq_clear(high);
}

void algebraic_list_init(algebraic_list *list) {
    list->count = list->capacity = 0;
    list->item = NULL;
}

void algebraic_list_clear(algebraic_list *list) {
    for (size_t k = 0; k < list->capacity; k++)
        algebraic_clear(&list->item[k]);
    flint_free(list->item);
    algebraic_list_init(list);
}

algebraic *algebraic_list_append(algebraic_list *list) {
    if (list->count == list->capacity) {
        size_t capacity = list->capacity ? 2 * list->capacity : 4;
        list->item = flint_realloc(list->item, capacity * sizeof *list->item);
        for (size_t k = list->capacity; k < capacity; k++)
            algebraic_init(&list->item[k]);
        list->capacity = capacity;
    }
    return &list->item[list->count++];
}
