/* Isolation of the real roots of an integer polynomial in a closed interval, by bisection with
 * Descartes' rule on Bernstein coefficients (theory K1; proofs/claims.md C24, C25, C29).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "number/algebraic.h"

#include "number/modular.h"

/* What the recursion carries besides interval and coefficients. `poly` has only simple roots in the
 * open interval whenever a branch goes on with two sign changes or more. */
typedef struct search {
    algebraic_list *list;
    const fmpz_poly_struct *poly;
} search;

static void append_isolated(const search *s, const dyadic_interval *interval, int low_sign) {
    algebraic *x = algebraic_list_append(s->list);
    fmpz_poly_set(x->poly, s->poly);
    dyadic_interval_set(&x->where, interval);
    x->low_sign = low_sign;
}

/* Roots in the open interval, ascending. The form is that of the interval; it is spent. */
static void roots_inside(const search *s, bernstein_form *form, const dyadic_interval *interval) {
    slong variations = bernstein_variations(form);
    if (variations == 0)
        return;
    int low = wide_sign(&form->c, 0), high = wide_sign(&form->c, form->c.count - 1);
    if (variations == 1 && low != 0 && high != 0) {
        append_isolated(s, interval, low);
        return;
    }
    dyadic_interval left, right;
    bernstein_form upper;
    dyadic_interval_init(&left);
    dyadic_interval_init(&right);
    dyadic_interval_halves(&left, &right, interval);
    bernstein_form_split(form, &upper);
    roots_inside(s, form, &left);
    if (wide_sign(&upper.c, 0) == 0)
        algebraic_set_dyadic(algebraic_list_append(s->list), left.high, left.exponent);
    roots_inside(s, &upper, &right);
    bernstein_form_clear(&upper);
    dyadic_interval_clear(&left);
    dyadic_interval_clear(&right);
}

/* Roots of a polynomial of degree two or more whose form has at most one sign change or that has no
 * repeated factor. */
static void append_roots(const search *s, bernstein_form *form, const dyadic_interval *interval) {
    int low_is_root = wide_sign(&form->c, 0) == 0;
    int high_is_root = wide_sign(&form->c, form->c.count - 1) == 0;
    if (low_is_root)
        algebraic_set_dyadic(algebraic_list_append(s->list), interval->low, interval->exponent);
    roots_inside(s, form, interval);
    if (high_is_root)
        algebraic_set_dyadic(algebraic_list_append(s->list), interval->high, interval->exponent);
}

/* A linear polynomial's root is rational and is kept as such. */
static void append_linear_root(algebraic_list *list, const fmpz_poly_t p,
                               const dyadic_interval *interval) {
    int low = dyadic_sign(p, interval->low, interval->exponent);
    if (low != 0 && low == dyadic_sign(p, interval->high, interval->exponent))
        return;
    algebraic *x = algebraic_list_append(list);
    fmpz_poly_zero(x->poly);
    fmpq_set_fmpz_frac(x->value, p->coeffs, p->coeffs + 1);
    fmpq_neg(x->value, x->value);
}

/* Roots of p / g, which has no repeated factor. */
static void append_roots_of_quotient(algebraic_list *list, const fmpz_poly_t p, const fmpz_poly_t g,
                                     const dyadic_interval *interval) {
    fmpz_poly_t squarefree;
    fmpz_poly_init(squarefree);
    fmpz_poly_div(squarefree, p, g);
    algebraic_roots(list, squarefree, interval);
    fmpz_poly_clear(squarefree);
}

void algebraic_roots(algebraic_list *list, const fmpz_poly_t p, const dyadic_interval *interval) {
    slong n = fmpz_poly_degree(p);
    if (n == 1)
        append_linear_root(list, p, interval);
    if (n <= 1)
        return;
    bernstein_form form;
    fmpz_poly_t derivative, g;
    bernstein_form_init(&form, p, n, interval);
    fmpz_poly_init(derivative);
    fmpz_poly_init(g);
    int repeated = 0;
    if (bernstein_variations(&form) > 1) {
        fmpz_poly_derivative(derivative, p);
        repeated = common_factor(g, p, derivative) > 0;
    }
    if (repeated)
        append_roots_of_quotient(list, p, g, interval);
    else
        append_roots(&(search){list, p}, &form, interval);
    bernstein_form_clear(&form);
    fmpz_poly_clear(derivative);
    fmpz_poly_clear(g);
}
