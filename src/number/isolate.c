/* Isolation of the real roots of an integer polynomial in a closed interval, by bisection with
 * Descartes' rule on Bernstein coefficients (theory K1; proofs/claims.md C24, C25).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "number/algebraic.h"

#include <flint/fmpz_vec.h>

/* What the recursion carries besides interval and coefficients. `poly` has only simple roots in the
 * open interval whenever a branch goes on with two sign changes or more. */
typedef struct search {
    algebraic_list *list;
    const fmpz_poly_struct *poly;
    slong degree;
} search;

/* A linear polynomial's root is rational and is kept as such. */
static void append_isolated(const search *s, const dyadic_interval *interval) {
    algebraic *x = algebraic_list_append(s->list);
    if (s->degree == 1) {
        fmpq_set_fmpz_frac(x->value, s->poly->coeffs, s->poly->coeffs + 1);
        fmpq_neg(x->value, x->value);
        fmpz_poly_zero(x->poly);
        return;
    }
    fmpz_poly_set(x->poly, s->poly);
    dyadic_interval_set(&x->where, interval);
}

/* Roots in the open interval, ascending. c are the coefficients there; they are spent. */
static void roots_inside(const search *s, fmpz *c, const dyadic_interval *interval) {
    slong n = s->degree, variations = bernstein_variations(c, n);
    if (variations == 0)
        return;
    int ends_free = !fmpz_is_zero(c) && !fmpz_is_zero(c + n);
    if (variations == 1 && (ends_free || n == 1)) {
        append_isolated(s, interval);
        return;
    }
    dyadic_interval left, right;
    dyadic_interval_init(&left);
    dyadic_interval_init(&right);
    dyadic_interval_halves(&left, &right, interval);
    fmpz *upper = _fmpz_vec_init(n + 1);
    bernstein_split(c, upper, c, n);
    int middle_is_root = fmpz_is_zero(upper);
    roots_inside(s, c, &left);
    if (middle_is_root)
        algebraic_set_dyadic(algebraic_list_append(s->list), left.high, left.exponent);
    roots_inside(s, upper, &right);
    _fmpz_vec_clear(upper, n + 1);
    dyadic_interval_clear(&left);
    dyadic_interval_clear(&right);
}

/* p without repeated factors. */
static void squarefree_part(fmpz_poly_t out, const fmpz_poly_t p) {
    fmpz_poly_t derivative, g;
    fmpz_poly_init(derivative);
    fmpz_poly_init(g);
    fmpz_poly_derivative(derivative, p);
    fmpz_poly_gcd(g, p, derivative);
    fmpz_poly_div(out, p, g);
    fmpz_poly_clear(derivative);
    fmpz_poly_clear(g);
}

void algebraic_roots(algebraic_list *list, const fmpz_poly_t q, const dyadic_interval *interval) {
    fmpz_poly_t p;
    fmpz_poly_init(p);
    fmpz_poly_primitive_part(p, q);
    slong n = fmpz_poly_degree(p);
    fmpz *c = _fmpz_vec_init(n + 1);
    bernstein_from_poly(c, p, n, interval);
    if (bernstein_variations(c, n) > 1) {
        squarefree_part(p, p);
        n = fmpz_poly_degree(p);
        bernstein_from_poly(c, p, n, interval);
    }
    int low_is_root = fmpz_is_zero(c), high_is_root = fmpz_is_zero(c + n);
    search s = {list, p, n};
    if (low_is_root)
        algebraic_set_dyadic(algebraic_list_append(list), interval->low, interval->exponent);
    roots_inside(&s, c, interval);
    if (high_is_root && n > 0)
        algebraic_set_dyadic(algebraic_list_append(list), interval->high, interval->exponent);
    _fmpz_vec_clear(c, fmpz_poly_degree(q) + 1);
    fmpz_poly_clear(p);
}
