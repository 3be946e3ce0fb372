/* Isolation of the real roots of an integer polynomial in a closed interval, by bisection with
 * Descartes' rule on Bernstein coefficients (proofs/claims.md C24, C25, C29). The first halvings
 * are made with exact coefficients; the intervals left go to cluster.c.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/isolate.h"

#include "base/context/scope.h"
#include "base/number/bernstein.h"
#include "base/number/cluster.h"
#include "base/number/modular.h"
#include "base/number/simplest.h"

static graze_status roots_inside(const root_search *s, bernstein_form *form,
                                 const dyadic_interval *interval);

/* Approximate coefficients, unlike exact ones, do not reveal a repeated root at an end of the
 * interval. The search is certain to end without repeated factors (C42), so these are divided out.
 */
static graze_status search_cluster(const root_search *s, const dyadic_interval *interval, int low,
                                   int high) {
    LOCAL(fmpz_poly, derivative);
    LOCAL(fmpz_poly, g);
    fmpz_poly_derivative(derivative, s->poly);
    TRY(common_factor_work(s->context, s->poly, derivative));
    if (common_factor(g, s->poly, derivative) <= 0)
        return root_search_cluster(s, interval, low, high);
    LOCAL(fmpz_poly, squarefree);
    fmpz_poly_div(squarefree, s->poly, g);
    root_search of = {s->list, s->context, squarefree, s->whole};
    return root_search_cluster(&of, interval,
                               dyadic_sign(squarefree, interval->low, interval->exponent),
                               dyadic_sign(squarefree, interval->high, interval->exponent));
}

/* Append the roots in both halves and at the point between them, ascending. The form of an empty
 * right half is freed before the left one is searched. `form` is the interval's and is overwritten.
 */
static graze_status roots_in_halves(const root_search *s, bernstein_form *form,
                                    const dyadic_interval *interval) {
    TRY(algebraic_may_narrow(s->context, interval));
    bernstein_form upper;
    HELD(dyadic_interval, left);
    HELD(dyadic_interval, right);
    dyadic_interval_halves(&left, &right, interval);
    bernstein_form_split(form, &upper);
    int middle_is_root = wide_sign(&upper.c, 0) == 0, searched = bernstein_variations(&upper) > 0;
    if (!searched)
        bernstein_form_clear(&upper);
    graze_status status = roots_inside(s, form, &left);
    if (status == GRAZE_OK && middle_is_root)
        algebraic_set_dyadic(algebraic_list_append(s->list), left.high, left.exponent);
    if (status == GRAZE_OK && searched)
        status = roots_inside(s, &upper, &right);
    if (searched)
        bernstein_form_clear(&upper);
    return status;
}

/* Append the roots in the open interval, ascending. `form` is the interval's and is overwritten. */
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
    TRY(context_work(s->context, (ulong)n * (ulong)n * (ulong)form->c.limbs));
    return roots_in_halves(s, form, interval);
}

/* Append the roots in the closed interval. The polynomial, of degree two or more, has a form with
 * at most one sign change, or no repeated factor. */
static graze_status append_roots(const root_search *s, bernstein_form *form) {
    const dyadic_interval *whole = s->whole;
    int low_is_root = wide_sign(&form->c, 0) == 0;
    int high_is_root = wide_sign(&form->c, form->c.count - 1) == 0;
    if (low_is_root)
        algebraic_set_dyadic(algebraic_list_append(s->list), whole->low, whole->exponent);
    TRY(roots_inside(s, form, whole));
    if (high_is_root)
        algebraic_set_dyadic(algebraic_list_append(s->list), whole->high, whole->exponent);
    return GRAZE_OK;
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

/* Narrow the interval of x until it does not contain r; *behind becomes 1 if x > r, else 0. */
static graze_status exclude(int *behind, graze_context *context, algebraic *x, const fmpq_t r) {
    ulong gain = FIRST_GAIN;
    for (int step = 0; !algebraic_is_rational(x); step++) {
        *behind = dyadic_compare(x->where.low, x->where.exponent, r) > 0;
        if (*behind || dyadic_compare(x->where.high, x->where.exponent, r) < 0)
            return GRAZE_OK;
        TRY(algebraic_narrow(context, x, step, &gain));
    }
    *behind = fmpq_cmp(x->value, r) > 0;
    return GRAZE_OK;
}

/* Insert a rational root in order among the roots of the list from index `first` on, and narrow
 * their intervals until none contains it. */
static graze_status insert_root(algebraic_list *list, graze_context *context, size_t first,
                                const fmpq_t root) {
    size_t place = list->count;
    int behind;
    for (size_t k = list->count; k > first; k--) {
        TRY(exclude(&behind, context, &list->item[k - 1], root));
        place -= (size_t)behind;
    }
    algebraic_set_rational(algebraic_list_append(list), root);
    for (size_t k = list->count - 1; k > place; k--) {
        algebraic swap = list->item[k];
        list->item[k] = list->item[k - 1];
        list->item[k - 1] = swap;
    }
    return GRAZE_OK;
}

/* If the fraction of least denominator in `part` is a root, append it and all other roots in the
 * interval; *done becomes 1 then, else 0. */
static graze_status roots_beside_fraction(int *done, algebraic_list *list, graze_context *context,
                                          const fmpz_poly_t p, const dyadic_interval *interval,
                                          const dyadic_interval *part) {
    size_t first = list->count;
    int empty;
    LOCAL(fmpq, root);
    LOCAL(fmpz_poly, rest);
    *done = divide_by_simplest(root, rest, &empty, p, part);
    if (*done && !(empty && part == interval))
        TRY(algebraic_roots(list, context, rest, interval));
    if (*done)
        TRY(insert_root(list, context, first, root));
    return GRAZE_OK;
}

/* Append the roots of a polynomial that may have repeated factors. A repeated root is a root of the
 * derivative too: if it can be guessed as a fraction, no common factor is computed. */
static graze_status repeated_roots(algebraic_list *list, graze_context *context,
                                   const fmpz_poly_t p, const dyadic_interval *interval,
                                   bernstein_form *form) {
    int done = 0;
    LOCAL(fmpz_poly, derivative);
    LOCAL(fmpz_poly, g);
    HELD(dyadic_interval, part);
    fmpz_poly_derivative(derivative, p);
    TRY(common_factor_work(context, p, derivative));
    int coprime = polynomials_certainly_coprime(p, derivative);
    if (!coprime && guess_interval(&part, derivative, interval))
        TRY(roots_beside_fraction(&done, list, context, p, interval, &part));
    if (done)
        return GRAZE_OK;
    if (coprime || common_factor(g, p, derivative) <= 0)
        return append_roots(&(root_search){list, context, p, interval}, form);
    LOCAL(fmpz_poly, squarefree);
    fmpz_poly_div(squarefree, p, g);
    return algebraic_roots(list, context, squarefree, interval);
}

/* Append the roots of a polynomial of degree two or more. */
static graze_status isolate_roots(algebraic_list *list, graze_context *context, const fmpz_poly_t p,
                                  const dyadic_interval *interval) {
    HELD(bernstein_form, form, p, fmpz_poly_degree(p), interval);
    return bernstein_variations(&form) > 1
               ? repeated_roots(list, context, p, interval, &form)
               : append_roots(&(root_search){list, context, p, interval}, &form);
}

graze_status algebraic_roots(algebraic_list *list, graze_context *context, const fmpz_poly_t p,
                             const dyadic_interval *interval) {
    int done;
    if (fmpz_poly_degree(p) == 1)
        append_linear_root(list, p, interval);
    if (fmpz_poly_degree(p) <= 1)
        return GRAZE_OK;
    TRY(roots_beside_fraction(&done, list, context, p, interval, interval));
    return done ? GRAZE_OK : isolate_roots(list, context, p, interval);
}
