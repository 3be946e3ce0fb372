/* Real algebraic numbers: the sign of a polynomial at one by refinement, a zero by gcd; and lists.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "number/modular.h"
#include "number/search.h"

/* Digits of an interval's ends up to which Bernstein coefficients are cheap. */
enum { COARSE = 63 };

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

int algebraic_sign_before(const fmpz_poly_t g, const dyadic_interval *interval) {
    if (fmpz_poly_degree(g) <= 0)
        return 0;
    int low = dyadic_sign(g, interval->low, interval->exponent);
    return low != dyadic_sign(g, interval->high, interval->exponent) ? low : 0;
}

/* Sign of q on the interval if its value at the lower end is more than q can change by on the way
 * to the upper one, else 0 (proofs/claims.md C31). The value is known to two binary places more
 * than the interval's ends have. */
static int sign_by_slope(const fmpz_poly_t q, const dyadic_interval *where) {
    slong degree = fmpz_poly_degree(q);
    ulong reach = FLINT_MAX(fmpz_bits(where->low), fmpz_bits(where->high));
    reach = reach > where->exponent ? reach - where->exponent : 0;
    fmpz_t value, error, change, term;
    fmpz_init(value);
    fmpz_init(error);
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
    fmpz_mul_2exp(change, change, 2);
    dyadic_approximate(value, error, q, where->low, where->exponent, where->exponent + 2);
    fmpz_add(change, change, error);
    int sign = fmpz_cmpabs(value, change) > 0 ? fmpz_sgn(value) : 0;
    fmpz_clear(value);
    fmpz_clear(error);
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
    int low_sign = algebraic_sign_before(g, &x->where);
    if (low_sign != 0) {
        fmpz_poly_swap(x->poly, g);
        x->low_sign = low_sign;
    }
    fmpz_poly_clear(g);
    return low_sign != 0;
}

graze_status algebraic_sign_at(int *out, graze_context *context, const fmpz_poly_t q,
                               algebraic *x) {
    slong degree = fmpz_poly_degree(q);
    *out = degree < 0 ? 0 : fmpz_sgn(q->coeffs);
    if (degree <= 0)
        return GRAZE_OK;
    ulong gain = FIRST_GAIN;
    graze_status status = GRAZE_OK;
    for (int halvings = 0; !algebraic_is_rational(x) && status == GRAZE_OK; halvings++) {
        *out = sign_on_interval(q, x);
        if (*out != 0)
            return GRAZE_OK;
        if (halvings == CHEAP_HALVINGS) {
            status = common_factor_work(context, q, x->poly);
            if (status == GRAZE_OK && vanishes_at(q, x))
                return GRAZE_OK;
        }
        if (status == GRAZE_OK)
            status = algebraic_narrow(context, x, halvings, &gain);
    }
    if (status == GRAZE_OK)
        *out = rational_sign(q, x->value);
    return status;
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
