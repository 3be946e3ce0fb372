/* Real algebraic numbers and lists of them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/algebraic.h"

#include "base/context/scope.h"

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

int algebraic_factor(fmpz_poly_t out, const fmpz_poly_t p, const dyadic_interval *interval) {
    LOCAL(fmpz_poly_factor, factors);
    fmpz_poly_factor(factors, p);
    slong k = factors->num - 1;
    while (k > 0 && !algebraic_sign_before(factors->p + k, interval))
        k--;
    fmpz_poly_set(out, factors->p + k);
    return algebraic_sign_before(out, interval);
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

void cross_terms(fmpz_poly_t out, const fmpz_poly_t a, const fmpz_poly_t b, const fmpz_poly_t c,
                 const fmpz_poly_t d) {
    LOCAL(fmpz_poly, product);
    fmpz_poly_mul(product, b, c);
    fmpz_poly_mul(out, a, d);
    fmpz_poly_sub(out, out, product);
}

void wronskian(fmpz_poly_t out, const fmpz_poly_t x, const fmpz_poly_t y) {
    LOCAL_VEC(fmpz_poly, slope, 2);
    fmpz_poly_derivative(slope, x);
    fmpz_poly_derivative(slope + 1, y);
    cross_terms(out, x, slope, y, slope + 1);
}
