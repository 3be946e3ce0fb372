/* Real algebraic numbers: comparison and signs by refinement, equality by gcd.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "number/algebraic.h"

#include "number/modular.h"

/* Halvings tried before a gcd is asked whether refinement would ever end; digits of an interval's
 * ends up to which Bernstein coefficients are cheap; digits that a secant is first asked for. */
enum { CHEAP_HALVINGS = 4, COARSE = 63, FIRST_GAIN = 4 };

void algebraic_init(algebraic *x) {
    fmpq_init(x->value);
    fmpz_poly_init(x->poly);
    dyadic_interval_init(&x->where);
    x->low_sign = 0;
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
    x->low_sign = y->low_sign;
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

/* The sign at the lower end of an interval of a polynomial g that divides that of a number isolated
 * there, if g vanishes at the number, else 0. The ends are no roots of g, and it has at most that
 * one root there, and a simple one. */
static int sign_before_root(const fmpz_poly_t g, const dyadic_interval *interval) {
    if (fmpz_poly_degree(g) <= 0)
        return 0;
    int low = dyadic_sign(g, interval->low, interval->exponent);
    return low != dyadic_sign(g, interval->high, interval->exponent) ? low : 0;
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

/* If the two irrational numbers, isolated in overlapping intervals of one exponent, are equal, let
 * them share their common factor and the overlap. */
static int unite_if_equal(algebraic *x, algebraic *y) {
    fmpz_poly_t g;
    fmpz_poly_init(g);
    int equal = 0;
    if (common_factor(g, x->poly, y->poly) > 0) {
        const dyadic_interval *a = &x->where, *b = &y->where;
        dyadic_interval overlap;
        dyadic_interval_init(&overlap);
        overlap.exponent = a->exponent;
        fmpz_set(overlap.low, fmpz_cmp(a->low, b->low) > 0 ? a->low : b->low);
        fmpz_set(overlap.high, fmpz_cmp(a->high, b->high) < 0 ? a->high : b->high);
        int low_sign = sign_before_root(g, &overlap);
        equal = low_sign != 0;
        if (equal) {
            fmpz_poly_swap(x->poly, g);
            dyadic_interval_swap(&x->where, &overlap);
            x->low_sign = low_sign;
            algebraic_set(y, x);
        }
        dyadic_interval_clear(&overlap);
    }
    fmpz_poly_clear(g);
    return equal;
}

/* Both irrational, in intervals of one exponent, and given by the same data. */
static int is_same(const algebraic *x, const algebraic *y) {
    return fmpz_equal(x->where.low, y->where.low) && fmpz_equal(x->where.high, y->where.high) &&
           fmpz_poly_equal(x->poly, y->poly);
}

int algebraic_compare(algebraic *x, algebraic *y) {
    ulong gain[] = {FIRST_GAIN, FIRST_GAIN};
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
        if (halvings < CHEAP_HALVINGS) {
            algebraic_refine(x);
            algebraic_refine(y);
        } else {
            algebraic_refine_quadratically(x, &gain[0]);
            algebraic_refine_quadratically(y, &gain[1]);
        }
    }
}

/* Sign of q on the interval if its value at the lower end is more than q can change by on the way
 * to the upper one, else 0 (proofs/claims.md C31). */
static int sign_by_slope(const fmpz_poly_t q, const dyadic_interval *where) {
    slong degree = fmpz_poly_degree(q);
    ulong reach = FLINT_MAX(fmpz_bits(where->low), fmpz_bits(where->high));
    reach = reach > where->exponent ? reach - where->exponent : 0;
    fmpz_t value, change, term;
    fmpz_init(value);
    fmpz_init(change);
    fmpz_init(term);
    for (slong i = 1; i <= degree; i++) {
        fmpz_mul_ui(term, q->coeffs + i, (ulong)i);
        fmpz_abs(term, term);
        fmpz_mul_2exp(term, term, reach * (ulong)(i - 1));
        fmpz_add(change, change, term);
    }
    fmpz_sub(term, where->high, where->low);
    fmpz_mul(change, change, term);
    if (degree > 0)
        fmpz_mul_2exp(change, change, where->exponent * (ulong)(degree - 1));
    dyadic_evaluate(value, q, where->low, where->exponent);
    int sign = fmpz_cmpabs(value, change) > 0 ? fmpz_sgn(value) : 0;
    fmpz_clear(value);
    fmpz_clear(change);
    fmpz_clear(term);
    return sign;
}

/* Sign of q at an irrational x if the interval tells, else 0. */
static int sign_on_interval(const fmpz_poly_t q, const algebraic *x) {
    if (x->where.exponent > COARSE)
        return sign_by_slope(q, &x->where);
    bernstein_form form;
    bernstein_form_init(&form, q, fmpz_poly_degree(q), &x->where);
    int sign = bernstein_one_sign(&form);
    bernstein_form_clear(&form);
    return sign;
}

/* If q vanishes at the irrational x, reduce x's polynomial to the common factor. */
static int vanishes_at(const fmpz_poly_t q, algebraic *x) {
    fmpz_poly_t g;
    fmpz_poly_init(g);
    common_factor(g, x->poly, q);
    int low_sign = sign_before_root(g, &x->where);
    if (low_sign != 0) {
        fmpz_poly_swap(x->poly, g);
        x->low_sign = low_sign;
    }
    fmpz_poly_clear(g);
    return low_sign != 0;
}

int algebraic_sign_at(const fmpz_poly_t q, algebraic *x) {
    if (fmpz_poly_degree(q) <= 0)
        return fmpz_poly_is_zero(q) ? 0 : fmpz_sgn(q->coeffs);
    ulong gain = FIRST_GAIN;
    for (int halvings = 0; !algebraic_is_rational(x); halvings++) {
        int sign = sign_on_interval(q, x);
        if (sign != 0)
            return sign;
        if (halvings == CHEAP_HALVINGS && vanishes_at(q, x))
            return 0;
        if (halvings < CHEAP_HALVINGS)
            algebraic_refine(x);
        else
            algebraic_refine_quadratically(x, &gain);
    }
    return rational_sign(q, x->value);
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
    ulong gain[] = {1, 1};
    for (;;) {
        algebraic_bounds(low, below, x);
        algebraic_bounds(above, high, y);
        if (fmpq_cmp(below, above) < 0)
            break;
        algebraic_refine_quadratically(x, &gain[0]);
        algebraic_refine_quadratically(y, &gain[1]);
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
