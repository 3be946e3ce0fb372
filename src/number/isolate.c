/* Isolation of the real roots of an integer polynomial in a closed interval, by bisection with
 * Descartes' rule on Bernstein coefficients (proofs/claims.md C24, C25, C29). The first
 * halvings are made with exact coefficients; what they leave goes to cluster.c.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "number/isolate.h"

#include "number/bernstein.h"
#include "number/cluster.h"
#include "number/modular.h"
#include "number/refine.h"

static graze_status roots_inside(const root_search *s, bernstein_form *form,
                                 const dyadic_interval *interval);

/* The roots of p / g, g being the common factor of p and its derivative. */
static graze_status cluster_of_quotient(const root_search *s, const dyadic_interval *interval,
                                        const fmpz_poly_t g) {
    fmpz_poly_t squarefree;
    fmpz_poly_init(squarefree);
    fmpz_poly_div(squarefree, s->poly, g);
    root_search of = {s->list, s->context, squarefree, s->whole};
    graze_status status = root_search_cluster(
        &of, interval, dyadic_sign(squarefree, interval->low, interval->exponent),
        dyadic_sign(squarefree, interval->high, interval->exponent));
    fmpz_poly_clear(squarefree);
    return status;
}

/* Coefficients that are known to some places do not show a repeated root at an end of the
 * interval, which exact ones leave out: without repeated factors C42 ends. */
static graze_status search_cluster(const root_search *s, const dyadic_interval *interval, int low,
                                   int high) {
    fmpz_poly_t derivative, g;
    fmpz_poly_init(derivative);
    fmpz_poly_init(g);
    fmpz_poly_derivative(derivative, s->poly);
    graze_status status = common_factor_work(s->context, s->poly, derivative);
    if (status == GRAZE_OK)
        status = common_factor(g, s->poly, derivative) > 0
                     ? cluster_of_quotient(s, interval, g)
                     : root_search_cluster(s, interval, low, high);
    fmpz_poly_clear(derivative);
    fmpz_poly_clear(g);
    return status;
}

/* Both halves and the point between them. Nothing of an empty half is kept while the other one is
 * searched. The form is that of the interval; it is spent. */
static graze_status roots_in_halves(const root_search *s, bernstein_form *form,
                                    const dyadic_interval *interval) {
    graze_status status = algebraic_may_narrow(s->context, interval);
    if (status != GRAZE_OK)
        return status;
    dyadic_interval left, right;
    bernstein_form upper;
    dyadic_interval_init(&left);
    dyadic_interval_init(&right);
    dyadic_interval_halves(&left, &right, interval);
    bernstein_form_split(form, &upper);
    int middle_is_root = wide_sign(&upper.c, 0) == 0, searched = bernstein_variations(&upper) > 0;
    if (!searched)
        bernstein_form_clear(&upper);
    status = roots_inside(s, form, &left);
    if (status == GRAZE_OK && middle_is_root)
        algebraic_set_dyadic(algebraic_list_append(s->list), left.high, left.exponent);
    if (status == GRAZE_OK && searched)
        status = roots_inside(s, &upper, &right);
    if (searched)
        bernstein_form_clear(&upper);
    dyadic_interval_clear(&left);
    dyadic_interval_clear(&right);
    return status;
}

/* Roots in the open interval, ascending. The form is that of the interval; it is spent. */
static graze_status roots_inside(const root_search *s, bernstein_form *form,
                                 const dyadic_interval *interval) {
    slong n = form->c.count - 1, variations = bernstein_variations(form);
    if (variations == 0)
        return GRAZE_OK;
    int low = wide_sign(&form->c, 0), high = wide_sign(&form->c, n);
    if (variations == 1 && low != 0 && high != 0) {
        root_search_append(s, interval, low);
        return GRAZE_OK;
    }
    if (interval->exponent >= s->whole->exponent + EXACT_HALVINGS)
        return search_cluster(s, interval, low, high);
    graze_status status = context_work(s->context, (ulong)n * (ulong)n * (ulong)form->c.limbs);
    return status == GRAZE_OK ? roots_in_halves(s, form, interval) : status;
}

/* Roots of a polynomial of degree two or more whose form has at most one sign change or that has no
 * repeated factor. */
static graze_status append_roots(const root_search *s, bernstein_form *form) {
    const dyadic_interval *whole = s->whole;
    int low_is_root = wide_sign(&form->c, 0) == 0;
    int high_is_root = wide_sign(&form->c, form->c.count - 1) == 0;
    if (low_is_root)
        algebraic_set_dyadic(algebraic_list_append(s->list), whole->low, whole->exponent);
    graze_status status = roots_inside(s, form, whole);
    if (status == GRAZE_OK && high_is_root)
        algebraic_set_dyadic(algebraic_list_append(s->list), whole->high, whole->exponent);
    return status;
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
static graze_status append_roots_of_quotient(algebraic_list *list, graze_context *context,
                                             const fmpz_poly_t p, const fmpz_poly_t g,
                                             const dyadic_interval *interval) {
    fmpz_poly_t squarefree;
    fmpz_poly_init(squarefree);
    fmpz_poly_div(squarefree, p, g);
    graze_status status = algebraic_roots(list, context, squarefree, interval);
    fmpz_poly_clear(squarefree);
    return status;
}

graze_status algebraic_roots(algebraic_list *list, graze_context *context, const fmpz_poly_t p,
                             const dyadic_interval *interval) {
    slong n = fmpz_poly_degree(p);
    if (n == 1)
        append_linear_root(list, p, interval);
    if (n <= 1)
        return GRAZE_OK;
    bernstein_form form;
    fmpz_poly_t derivative, g;
    graze_status status = GRAZE_OK;
    bernstein_form_init(&form, p, n, interval);
    fmpz_poly_init(derivative);
    fmpz_poly_init(g);
    int repeated = 0;
    if (bernstein_variations(&form) > 1) {
        fmpz_poly_derivative(derivative, p);
        status = common_factor_work(context, p, derivative);
        repeated = status == GRAZE_OK && common_factor(g, p, derivative) > 0;
    }
    if (status == GRAZE_OK && repeated)
        status = append_roots_of_quotient(list, context, p, g, interval);
    else if (status == GRAZE_OK)
        status = append_roots(&(root_search){list, context, p, interval}, &form);
    bernstein_form_clear(&form);
    fmpz_poly_clear(derivative);
    fmpz_poly_clear(g);
    return status;
}
