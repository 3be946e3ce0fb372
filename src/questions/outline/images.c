/* Forms at points, and coordinates of points of curves as algebraic numbers, by resultants.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/outline/arcs.h"

#include "base/context/scope.h"
#include "base/number/isolate.h"

void form_pullback(fmpz_poly_t out, const fmpz_mpoly_t form, slong degree,
                   const fmpz_poly_struct *x, const fmpz_mpoly_ctx_t ring) {
    LOCAL_VEC(fmpz_poly, power, 3 * (degree + 1));
    LOCAL(fmpz_poly, term);
    LOCAL(fmpz, c);
    for (slong k = 0; k < 3 * (degree + 1); k++)
        if (k % (degree + 1) == 0)
            fmpz_poly_one(power + k);
        else
            fmpz_poly_mul(power + k, power + k - 1, x + k / (degree + 1));
    fmpz_poly_zero(out);
    for (slong k = 0; k < fmpz_mpoly_length(form, ring); k++) {
        ulong e[FORM_VARIABLES];
        fmpz_mpoly_get_term_exp_ui(e, form, k, ring);
        fmpz_mpoly_get_term_coeff_fmpz(c, form, k, ring);
        fmpz_poly_mul(term, power + e[0], power + degree + 1 + e[1]);
        fmpz_poly_mul(term, term, power + 2 * (degree + 1) + degree - (slong)(e[0] + e[1]));
        fmpz_poly_scalar_addmul_fmpz(out, term, c);
    }
}

void form_on_line(fmpz_poly_t out, const graze_outline *o, const outline_equation *e,
                  const fmpq *point, int axis) {
    LOCAL_VEC(fmpz_poly, x, 3);
    LOCAL_VEC(fmpz, v, 3);
    _fmpq_vec_get_fmpz_vec_fmpz(v, v + 2, point, 2);
    for (int i = 0; i < 3; i++)
        fmpz_poly_set_fmpz(x + i, v + i);
    fmpz_poly_set_coeff_fmpz(x + axis, 1, v + 2);
    form_pullback(out, e->form, e->degree, x, o->ring_of_forms);
}

graze_status form_eliminate(fmpz_mpoly_t out, graze_context *context, const fmpz_mpoly_t a,
                            const fmpz_mpoly_t b, int variable, const fmpz_mpoly_ctx_t ring) {
    if (fmpz_mpoly_degree_si(a, variable, ring) == 0)
        fmpz_mpoly_set(out, a, ring);
    else if (fmpz_mpoly_degree_si(b, variable, ring) == 0)
        fmpz_mpoly_set(out, b, ring);
    else if (!fmpz_mpoly_resultant(out, a, b, variable, ring))
        return context_fail(context, GRAZE_EINTERNAL, "a resultant of curves is not found");
    return context_poll(context);
}

void number_minimal(fmpz_poly_t out, const algebraic *x) {
    fmpz_poly_zero(out);
    if (algebraic_is_rational(x)) {
        fmpz_poly_set_coeff_fmpz(out, 0, fmpq_numref(x->value));
        fmpz_poly_neg(out, out);
        fmpz_poly_set_coeff_fmpz(out, 1, fmpq_denref(x->value));
        return;
    }
    LOCAL(fmpz_poly_factor, factors);
    fmpz_poly_factor(factors, x->poly);
    for (slong k = 0; k < factors->num; k++)
        if (algebraic_sign_before(factors->p + k, &x->where))
            fmpz_poly_set(out, factors->p + k);
}

void number_reduce(algebraic *x) {
    LOCAL(fmpz_poly, p);
    LOCAL(fmpq, value);
    if (algebraic_is_rational(x))
        return;
    number_minimal(p, x);
    if (fmpz_poly_degree(p) == 1) {
        fmpq_set_fmpz_frac(value, p->coeffs, p->coeffs + 1);
        fmpq_neg(value, value);
        algebraic_set_rational(x, value);
        return;
    }
    fmpz_poly_swap(x->poly, p);
    x->low_sign = dyadic_sign(x->poly, x->where.low, x->where.exponent);
}

/* At x = k the value is the resultant of q and k den - num, which has the degree of q in x. Where
 * the second polynomial loses degree, the leading coefficient of q makes up for it. */
void image_polynomial(fmpz_poly_t out, const fmpz_poly_t q, const fmpz_poly_t num,
                      const fmpz_poly_t den) {
    slong n = fmpz_poly_degree(q);
    slong most = FLINT_MAX(fmpz_poly_degree(num), fmpz_poly_degree(den));
    LOCAL_VEC(fmpz, at, 2 * n + 2);
    fmpz *value = at + n + 1;
    LOCAL(fmpz_poly, p);
    LOCAL(fmpz, power);
    for (slong k = 0; k <= n; k++) {
        fmpz_set_si(at + k, k);
        fmpz_poly_scalar_mul_si(p, den, k);
        fmpz_poly_sub(p, p, num);
        if (fmpz_poly_is_zero(p))
            continue;
        fmpz_poly_resultant(value + k, q, p);
        fmpz_pow_ui(power, fmpz_poly_lead(q), (ulong)(most - fmpz_poly_degree(p)));
        fmpz_mul(value + k, value + k, power);
    }
    fmpz_poly_interpolate_fmpz_vec(out, at, value, n + 1);
}

/* If the bracket holds exactly one root of p, set the number to it; p has no repeated root. */
static graze_status number_in_bracket(int *found, algebraic *out, graze_context *context,
                                      const fmpz_poly_t p, const bracket *where, ulong places) {
    HELD(dyadic_interval, interval);
    HELD(algebraic_list, roots);
    fmpz_set(interval.low, where->low);
    fmpz_set(interval.high, where->high);
    if (fmpz_equal(interval.low, interval.high))
        fmpz_add_ui(interval.high, interval.high, 1);
    interval.exponent = places;
    TRY(algebraic_roots(&roots, context, p, &interval));
    *found = roots.count == 1;
    if (*found)
        algebraic_set(out, &roots.item[0]);
    return GRAZE_OK;
}

/* A polynomial that vanishes at the coordinate: on a slanted line from the form of its conjugates.
 */
static graze_status coordinate_polynomial(fmpz_poly_t out, const graze_outline *o,
                                          graze_context *context, const outline_curve *c,
                                          const algebraic *s, int axis) {
    const fmpz_mpoly_ctx_struct *ring = o->ring_of_forms;
    LOCAL(fmpz_poly, q);
    number_minimal(q, s);
    if (!c->slant) {
        image_polynomial(out, q, &c->x[axis], &c->x[2]);
        return GRAZE_OK;
    }
    IN_RING(fmpz_mpoly, at, ring);
    IN_RING(fmpz_mpoly, rest, ring);
    fmpz_mpoly_set_fmpz_poly(at, q, c->axis, ring);
    TRY(form_eliminate(rest, context, o->equation[c->equation].form, at, c->axis, ring));
    (void)fmpz_mpoly_get_fmpz_poly(out, rest, axis, ring);
    return GRAZE_OK;
}

graze_status outline_coordinate(algebraic *out, const graze_outline *o, graze_context *context,
                                outline_curve *c, algebraic *s, int axis) {
    LOCAL(fmpz_poly, p);
    LOCAL(fmpz_poly, common);
    HELD(point_place, here);
    int found = c->slant && axis == c->axis;
    if (found) {
        algebraic_set(out, s);
    } else if (!c->slant && algebraic_is_rational(s)) {
        LOCAL_VEC(fmpq, point, 2);
        outline_curve_at(point, c, s->value);
        algebraic_set_rational(out, point + axis);
        return GRAZE_OK;
    } else {
        TRY(coordinate_polynomial(p, o, context, c, s, axis));
        fmpz_poly_derivative(common, p);
        fmpz_poly_gcd(common, common, p);
        fmpz_poly_div(p, p, common);
        fmpz_poly_primitive_part(p, p);
    }
    for (ulong places = 64; !found; places *= 2) {
        TRY(outline_curve_place(here.xy, context, c, s, places));
        TRY(number_in_bracket(&found, out, context, p, &here.xy[axis], places));
    }
    if (c->slant)
        number_reduce(out);
    return GRAZE_OK;
}

graze_status outline_line_crossing(algebraic *out, const graze_outline *o, graze_context *context,
                                   outline_curve *c, const fmpq_t value) {
    HELD(algebraic, at);
    algebraic_set_rational(&at, value);
    c->axis = 1; /* a line that is not level has y for a parameter too */
    graze_status status = outline_coordinate(out, o, context, c, &at, 0);
    c->axis = 0;
    return status;
}
