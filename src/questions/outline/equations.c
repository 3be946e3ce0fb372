/* Equations of the candidate curves, and which curves have one in common
 * (proofs/outline.md C135).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/outline/arcs.h"

/* form += p(s) times FORM_X or FORM_Y or, for `variable` 2, 1. */
static void add_to_form(fmpz_mpoly_t form, const fmpz_poly_t p, int variable,
                        const fmpz_mpoly_ctx_t ring) {
    IN_RING(fmpz_mpoly, term, ring);
    IN_RING(fmpz_mpoly, x, ring);
    fmpz_mpoly_set_fmpz_poly(term, p, FORM_S, ring);
    if (variable < 2) {
        fmpz_mpoly_gen(x, variable, ring);
        fmpz_mpoly_mul(term, term, x, ring);
    }
    fmpz_mpoly_add(form, form, term, ring);
}

/* Set the form to the resultant of W x - X and W y - Y, or of a line and the polynomial of its
 * time. A constant coordinate is its own equation. */
static graze_status find_resultant(fmpz_mpoly_t form, graze_context *context,
                                   const outline_curve *c, const fmpz_mpoly_ctx_t ring) {
    IN_RING(fmpz_mpoly, first, ring);
    IN_RING(fmpz_mpoly, second, ring);
    LOCAL(fmpz_poly, minimal);
    if (c->slant) {
        number_minimal(minimal, &c->at);
        add_to_form(first, minimal, 2, ring);
    }
    for (int k = 0; k < 3 && c->slant; k++)
        add_to_form(second, &c->x[k], k, ring);
    for (int k = 0; k < 2 && !c->slant; k++) {
        fmpz_mpoly_struct *side = k ? second : first;
        add_to_form(side, &c->x[k], 2, ring);
        fmpz_mpoly_neg(side, side, ring);
        add_to_form(side, &c->x[2], k, ring);
    }
    return form_eliminate(form, context, first, second, FORM_S, ring);
}

/* Replace a power of an irreducible form by that form, primitive and with a positive leading
 * coefficient. */
static graze_status find_root_form(fmpz_mpoly_t form, graze_context *context,
                                   const fmpz_mpoly_ctx_t ring) {
    IN_RING(fmpz_mpoly_factor, factors, ring);
    slong found = -1;
    if (!fmpz_mpoly_factor_squarefree(factors, form, ring))
        return context_fail(context, GRAZE_EINTERNAL, "an equation of a curve has no factors");
    for (slong k = 0; k < fmpz_mpoly_factor_length(factors, ring); k++)
        if (!fmpz_mpoly_is_fmpz(factors->poly + k, ring)) {
            if (found >= 0)
                return context_fail(context, GRAZE_EINTERNAL, "a curve has two equations");
            found = k;
        }
    if (found < 0)
        return context_fail(context, GRAZE_EINTERNAL, "a curve has no equation");
    LOCAL(fmpz, lead);
    fmpz_mpoly_set(form, factors->poly + found, ring);
    fmpz_mpoly_get_term_coeff_fmpz(lead, form, 0, ring);
    if (fmpz_sgn(lead) < 0)
        fmpz_mpoly_neg(form, form, ring);
    return context_poll(context);
}

/* The line a x + b y + c = 0 that an edge at an irrational time lies on is rational: its coordinate
 * along `axis` remains the parameter. */
static void make_rational_line(outline_curve *c, const fmpz_mpoly_t form,
                               const fmpz_mpoly_ctx_t ring) {
    LOCAL_VEC(fmpz, v, 3);
    for (int k = 0; k < 3; k++) {
        ulong power[FORM_VARIABLES] = {k == 0, k == 1, 0};
        fmpz_mpoly_get_coeff_fmpz_ui(v + k, form, power, ring);
        fmpz_poly_zero(&c->x[k]);
    }
    int s = c->axis, other = 1 - s;
    fmpz_poly_set_coeff_fmpz(&c->x[s], 1, v + other);
    fmpz_poly_set_fmpz(&c->x[2], v + other);
    fmpz_poly_set_coeff_fmpz(&c->x[other], 0, v + 2);
    fmpz_poly_set_coeff_fmpz(&c->x[other], 1, v + s);
    fmpz_poly_neg(&c->x[other], &c->x[other]);
    c->slant = 0;
}

static graze_status append_equation(graze_outline *o, graze_context *context,
                                    const fmpz_mpoly_t form) {
    TRY(array_grow(context, &o->equation, &o->equation_capacity, o->equation_count + 1,
                   sizeof *o->equation, "the equations of an outline"));
    outline_equation *e = &o->equation[o->equation_count++];
    memset(e, 0, sizeof *e);
    fmpz_mpoly_init(e->form, o->ring_of_forms);
    fmpz_mpoly_set(e->form, form, o->ring_of_forms);
    e->degree = fmpz_mpoly_total_degree_si(form, o->ring_of_forms);
    e->axis = fmpz_mpoly_degree_si(form, FORM_Y, o->ring_of_forms) == 0 ? 1 : 0;
    return GRAZE_OK;
}

/* Find the equation of a curve among the known ones, or append it. */
static graze_status number_equation(graze_outline *o, graze_context *context, outline_curve *c) {
    IN_RING(fmpz_mpoly, form, o->ring_of_forms);
    TRY(find_resultant(form, context, c, o->ring_of_forms));
    TRY(find_root_form(form, context, o->ring_of_forms));
    if (c->slant && fmpz_mpoly_total_degree_si(form, o->ring_of_forms) == 1)
        make_rational_line(c, form, o->ring_of_forms);
    c->equation = 0;
    while (c->equation < o->equation_count &&
           !fmpz_mpoly_equal(o->equation[c->equation].form, form, o->ring_of_forms))
        c->equation++;
    if (c->equation == o->equation_count)
        TRY(append_equation(o, context, form));
    outline_equation *e = &o->equation[c->equation];
    c->proper = c->slant || outline_curve_degree(c) == e->degree;
    e->curve_count++;
    return GRAZE_OK;
}

/* Join curves of one equation whose boxes meet, directly or by others, to groups: a group is the
 * least number of its curves. */
static void group_curves(graze_outline *o) {
    for (size_t k = 0; k < o->curve_count; k++) {
        outline_curve *c = &o->curve[k];
        c->group = k;
        for (size_t i = 0; i < k; i++) {
            outline_curve *other = &o->curve[i];
            if (other->equation != c->equation || other->group == c->group ||
                !box_meets(&other->box, &c->box))
                continue;
            size_t from = FLINT_MAX(other->group, c->group), to = FLINT_MIN(other->group, c->group);
            for (size_t j = 0; j <= k; j++)
                if (o->curve[j].group == from)
                    o->curve[j].group = to;
        }
    }
}

graze_status outline_equations(graze_outline *o, graze_context *context) {
    for (size_t k = 0; k < o->curve_count; k++) {
        outline_curve *c = &o->curve[k];
        TRY(number_equation(o, context, c));
        TRY(outline_curve_box(&c->box, context, c, &c->from, &c->to));
    }
    group_curves(o);
    return GRAZE_OK;
}
