/* Cuts of the candidate curves, each by the roots of polynomials of its parameter alone
 * (proofs/outline.md C136).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/outline/arcs.h"

/* A curve that is being cut. */
typedef struct cutter {
    graze_outline *o;
    graze_context *context;
    outline_curve *curve;
    const outline_equation *equation;
} cutter;

/* Cut at all roots of a polynomial in the curve's range. */
static graze_status cut_at_zeros(const cutter *k, const fmpz_poly_t p) {
    outline_curve *c = k->curve;
    if (fmpz_poly_is_zero(p))
        return context_fail(k->context, GRAZE_EINTERNAL, "a curve is cut by its own equation");
    return roots_about(&c->cut_number, k->context, p, &c->from, &c->to);
}

/* Mark the folds and cusps: the common roots of both velocities. */
static graze_status mark_folds(graze_context *context, outline_curve *c) {
    if (c->slant)
        return GRAZE_OK;
    LOCAL_VEC(fmpz_poly, v, 2);
    for (int i = 0; i < 2; i++)
        wronskian(v + i, &c->x[2], &c->x[i]);
    fmpz_poly_gcd(v, v, v + 1);
    return roots_about(&c->mark, context, v, &c->from, &c->to);
}

/* Keep a polynomial whose roots hold the coordinate of a curve's point at s. */
static graze_status keep_point(graze_outline *o, graze_context *context, const outline_curve *c,
                               const algebraic *s) {
    outline_equation *e = &o->equation[c->equation];
    LOCAL(fmpz_poly, minimal);
    LOCAL(fmpz_poly, p);
    number_minimal(minimal, s);
    if (c->slant)
        fmpz_poly_set(p, minimal);
    else
        image_polynomial(p, minimal, &c->x[e->axis], &c->x[2]);
    fmpz_poly_primitive_part(p, p);
    for (size_t k = 0; k < e->point_count; k++)
        if (fmpz_poly_equal(&e->point[k], p))
            return GRAZE_OK;
    TRY(array_grow(context, &e->point, &e->point_capacity, e->point_count + 1, sizeof *e->point,
                   "the points of an outline"));
    fmpz_poly_init(&e->point[e->point_count]);
    fmpz_poly_set(&e->point[e->point_count++], p);
    return GRAZE_OK;
}

static void append_cut(outline_curve *c, const algebraic *s) {
    algebraic_set(algebraic_list_append(&c->cut_number), s);
}

/* Cut at the ends and the marks; if others may cover the curve, they are cut there too. */
static graze_status begin_cuts(graze_outline *o, graze_context *context, outline_curve *c) {
    append_cut(c, &c->from);
    append_cut(c, &c->to);
    for (size_t i = 0; i < c->mark.count; i++)
        append_cut(c, &c->mark.item[i]);
    if (o->equation[c->equation].curve_count == 1 && c->proper)
        return GRAZE_OK;
    for (size_t i = 0; i < c->cut_number.count; i++)
        TRY(keep_point(o, context, c, &c->cut_number.item[i]));
    return GRAZE_OK;
}

/* Cut where a form of the degree vanishes; a slanted line at the coordinate of such points of its
 * conjugates. */
static graze_status cut_by_form(const cutter *k, const fmpz_mpoly_t form, slong degree) {
    const outline_curve *c = k->curve;
    const fmpz_mpoly_ctx_struct *ring = k->o->ring_of_forms;
    LOCAL(fmpz_poly, p);
    if (c->slant) {
        IN_RING(fmpz_mpoly, rest, ring);
        TRY(form_eliminate(rest, k->context, form, k->equation->form, 1 - c->axis, ring));
        (void)fmpz_mpoly_get_fmpz_poly(p, rest, c->axis, ring);
    } else {
        form_pullback(p, form, degree, c->x, ring);
    }
    return cut_at_zeros(k, p);
}

/* Cut where the curve's own equation is singular. */
static graze_status cut_singular(const cutter *k) {
    const outline_equation *e = k->equation;
    const fmpz_mpoly_ctx_struct *ring = k->o->ring_of_forms;
    if (e->degree < 2)
        return GRAZE_OK;
    IN_RING(fmpz_mpoly, slope, ring);
    LOCAL_VEC(fmpz_poly, p, 2);
    if (k->curve->slant) {
        fmpz_mpoly_derivative(slope, e->form, 1 - k->curve->axis, ring);
        return cut_by_form(k, slope, e->degree);
    }
    for (int i = 0; i < 2; i++) {
        fmpz_mpoly_derivative(slope, e->form, i, ring);
        form_pullback(p + i, slope, e->degree, k->curve->x, ring); /* times a weight */
    }
    fmpz_poly_gcd(p, p, p + 1);
    return cut_at_zeros(k, p);
}

/* Cut at the points whose coordinate is a root of p. */
static graze_status cut_at_points(const cutter *k, const fmpz_poly_t p) {
    IN_RING(fmpz_mpoly, form, k->o->ring_of_forms);
    fmpz_mpoly_set_fmpz_poly(form, p, k->equation->axis, k->o->ring_of_forms);
    return cut_by_form(k, form, fmpz_poly_degree(p));
}

/* Cut where the curve, or a conjugate of a slanted line, passes a point of two rationals. */
static graze_status cut_at_fixed(const cutter *k, const fmpq *point) {
    outline_curve *c = k->curve;
    LOCAL(fmpz_poly, p);
    LOCAL(fmpq, zero);
    if (!c->slant) {
        outline_curve_at_point(p, c, point);
        return fmpz_poly_degree(p) > 0 ? cut_at_zeros(k, p) : GRAZE_OK;
    }
    form_on_line(p, k->o, k->equation, point, c->axis);
    if (rational_sign(p, zero) == 0)
        algebraic_set_rational(algebraic_list_append(&c->cut_number), point + c->axis);
    return GRAZE_OK;
}

/* Sort the cuts and keep those from one end of the curve to the other. */
static graze_status order_cuts(const cutter *k) {
    outline_curve *c = k->curve;
    size_t count = c->cut_number.count, first = 0, last = 0;
    c->cut = flint_malloc(count * sizeof *c->cut);
    for (size_t i = 0; i < count; i++)
        c->cut[i] = &c->cut_number.item[i];
    TRY(algebraic_sort_once(c->cut, &count, k->context, NULL, NULL));
    for (size_t i = 0; i < count; i++) {
        first = c->cut[i] == &c->cut_number.item[0] ? i : first;
        last = c->cut[i] == &c->cut_number.item[1] ? i : last;
    }
    c->cut_count = last - first + 1;
    for (size_t i = 0; i < c->cut_count; i++)
        c->cut[i] = c->cut[first + i];
    k->o->all_cuts += c->cut_count;
    return k->o->all_cuts > k->context->limits[GRAZE_LIMIT_ARCS]
               ? context_limit(k->context, GRAZE_LIMIT_ARCS, "the pieces of curves of an outline")
               : GRAZE_OK;
}

static graze_status cut_curve(graze_outline *o, graze_context *context, outline_curve *c,
                              const unsigned char *is_near) {
    const cutter k = {o, context, c, &o->equation[c->equation]};
    TRY(cut_singular(&k));
    for (size_t i = 0; i < o->equation_count; i++)
        if (is_near[i] && i != c->equation) {
            TRY(cut_by_form(&k, o->equation[i].form, o->equation[i].degree));
            TRY(context_work(context, 1000));
        }
    for (size_t i = 0; i < k.equation->point_count; i++)
        TRY(cut_at_points(&k, &k.equation->point[i]));
    for (size_t i = 0; i < o->fixed_count; i++)
        TRY(cut_at_fixed(&k, o->fixed + 2 * i));
    return order_cuts(&k);
}

/* Cut the curves of a group by the equations of all curves whose boxes meet a box of the group, so
 * that curves of the group are cut alike. */
static graze_status cut_group(graze_outline *o, graze_context *context, size_t group,
                              unsigned char *is_near) {
    memset(is_near, 0, o->equation_count);
    for (size_t i = group; i < o->curve_count; i++)
        for (size_t j = 0; j < o->curve_count && o->curve[i].group == group; j++)
            if (box_meets(&o->curve[i].box, &o->curve[j].box))
                is_near[o->curve[j].equation] = 1;
    for (size_t i = group; i < o->curve_count; i++)
        if (o->curve[i].group == group)
            TRY(cut_curve(o, context, &o->curve[i], is_near));
    return GRAZE_OK;
}

graze_status outline_cuts(graze_outline *o, graze_context *context) {
    FREED(unsigned char, is_near, malloc(o->equation_count + 1));
    if (!is_near)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    for (size_t k = 0; k < o->curve_count; k++)
        TRY(mark_folds(context, &o->curve[k]));
    for (size_t k = 0; k < o->curve_count; k++)
        TRY(begin_cuts(o, context, &o->curve[k]));
    for (size_t k = 0; k < o->curve_count; k++)
        if (o->curve[k].group == k)
            TRY(cut_group(o, context, k, is_near));
    return GRAZE_OK;
}
