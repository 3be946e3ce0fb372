/* Cuts of the candidate curves, each by the roots of polynomials of its parameter alone
 * (proofs/outline.md C136).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "base/number/order.h"
#include "questions/outline/arcs.h"

/* A curve that is being cut; `range` holds its interval of parameters. */
typedef struct cutter {
    graze_outline *o;
    graze_context *context;
    outline_curve *curve;
    const outline_equation *equation;
    dyadic_interval range;
} cutter;

static void cutter_init(cutter *k, graze_outline *o, graze_context *context, outline_curve *c) {
    *k = (cutter){.o = o, .context = context, .curve = c};
    k->equation = &o->equation[c->equation];
    dyadic_interval_init(&k->range);
    interval_of(&k->range, &c->from, &c->to);
}

static void cutter_clear(cutter *k) {
    dyadic_interval_clear(&k->range);
}

/* Cut at all roots of a polynomial in the curve's range. */
static graze_status cut_at_zeros(cutter *k, const fmpz_poly_t p) {
    if (fmpz_poly_is_zero(p))
        return context_fail(k->context, GRAZE_EINTERNAL, "a curve is cut by its own equation");
    return algebraic_roots(&k->curve->cut_number, k->context, p, &k->range);
}

/* Mark the folds and cusps: the common roots of both velocities. */
static graze_status mark_folds(graze_outline *o, graze_context *context, outline_curve *c) {
    if (c->slant || outline_curve_degree(c) == 1)
        return GRAZE_OK;
    HELD(cutter, k, o, context, c);
    LOCAL_VEC(fmpz_poly, v, 2);
    for (int i = 0; i < 2; i++)
        slope_product(v + i, &c->x[2], &c->x[i]);
    fmpz_poly_gcd(v, v, v + 1);
    return algebraic_roots(&c->mark, context, v, &k.range);
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

static graze_status store_cuts(graze_outline *o, graze_context *context, outline_curve *c) {
    const outline_equation *e = &o->equation[c->equation];
    if (e->curve_count == 1 && c->proper)
        return GRAZE_OK;
    TRY(keep_point(o, context, c, &c->from));
    TRY(keep_point(o, context, c, &c->to));
    for (size_t k = 0; k < c->mark.count; k++)
        TRY(keep_point(o, context, c, &c->mark.item[k]));
    return GRAZE_OK;
}

/* Cut at the points whose coordinate is a root of p. */
static graze_status cut_at_points(cutter *k, const fmpz_poly_t p) {
    const outline_curve *c = k->curve;
    if (c->slant)
        return cut_at_zeros(k, p);
    LOCAL(fmpz_poly, sum);
    LOCAL(fmpz_poly, power);
    LOCAL(fmpz_poly, term);
    fmpz_poly_one(power);
    for (slong i = fmpz_poly_degree(p); i >= 0; i--) {
        fmpz_poly_mul(sum, sum, &c->x[k->equation->axis]);
        fmpz_poly_scalar_mul_fmpz(term, power, fmpz_poly_get_coeff_ptr(p, i));
        fmpz_poly_add(sum, sum, term);
        fmpz_poly_mul(power, power, &c->x[2]);
    }
    return cut_at_zeros(k, sum);
}

/* Cut a slanted line where another form vanishes. */
static graze_status cut_slant(cutter *k, const fmpz_mpoly_t form) {
    const fmpz_mpoly_ctx_struct *ring = k->o->ring_of_forms;
    int axis = k->curve->axis, other = 1 - axis;
    IN_RING(fmpz_mpoly, rest, ring);
    LOCAL(fmpz_poly, p);
    TRY(form_eliminate(rest, k->context, form, k->equation->form, other, ring));
    form_to_poly(p, rest, axis, ring);
    return cut_at_zeros(k, p);
}

/* Cut where the curve's own equation is singular. */
static graze_status cut_singular(cutter *k) {
    const outline_equation *e = k->equation;
    const fmpz_mpoly_ctx_struct *ring = k->o->ring_of_forms;
    if (e->degree < 2)
        return GRAZE_OK;
    IN_RING(fmpz_mpoly, slope, ring);
    LOCAL_VEC(fmpz_poly, p, 2);
    if (k->curve->slant) {
        fmpz_mpoly_derivative(slope, e->form, 1 - k->curve->axis, ring);
        return cut_slant(k, slope);
    }
    for (int i = 0; i < 2; i++) {
        fmpz_mpoly_derivative(slope, e->form, i, ring);
        form_pullback(p + i, slope, e->degree - 1, k->curve->x, ring);
    }
    fmpz_poly_gcd(p, p, p + 1);
    return cut_at_zeros(k, p);
}

static graze_status cut_by_other(cutter *k, const outline_equation *other) {
    if (k->curve->slant)
        return cut_slant(k, other->form);
    LOCAL(fmpz_poly, p);
    form_pullback(p, other->form, other->degree, k->curve->x, k->o->ring_of_forms);
    return cut_at_zeros(k, p);
}

/* Cut where the curve piece_passes a point of two rationals. */
static graze_status cut_at_fixed(cutter *k, const fmpq *point) {
    outline_curve *c = k->curve;
    LOCAL_VEC(fmpz_poly, p, 3);
    LOCAL_VEC(fmpz, v, 3);
    _fmpq_vec_get_fmpz_vec_fmpz(v, v + 2, point, 2);
    for (int i = 0; i < 3; i++)
        fmpz_poly_set_fmpz(p + i, v + i);
    form_pullback(p, k->equation->form, k->equation->degree, p, k->o->ring_of_forms);
    if (!fmpz_poly_is_zero(p))
        return GRAZE_OK;
    if (c->slant) {
        algebraic_set_rational(algebraic_list_append(&c->cut_number), point + c->axis);
        return GRAZE_OK;
    }
    outline_curve_at_point(p, c, point);
    return fmpz_poly_degree(p) > 0 ? cut_at_zeros(k, p) : GRAZE_OK;
}

void outline_curve_level(fmpz_poly_t out, const outline_curve *c, int coordinate, const fmpq_t at) {
    fmpz_poly_scalar_mul_fmpz(out, &c->x[coordinate], fmpq_denref(at));
    fmpz_poly_scalar_submul_fmpz(out, &c->x[2], fmpq_numref(at));
}

void outline_curve_at_point(fmpz_poly_t out, const outline_curve *c, const fmpq *point) {
    LOCAL_VEC(fmpz_poly, p, 2);
    for (int i = 0; i < 2; i++)
        outline_curve_level(p + i, c, i, point + i);
    fmpz_poly_gcd(out, p, p + 1);
}

/* Sort the cuts and keep those from one end of the curve to the other. */
static graze_status order_cuts(cutter *k) {
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

static void append_cut(outline_curve *c, const algebraic *s) {
    algebraic_set(algebraic_list_append(&c->cut_number), s);
}

static graze_status cut_curve(graze_outline *o, graze_context *context, outline_curve *c,
                              const unsigned char *is_near) {
    HELD(cutter, k, o, context, c);
    append_cut(c, &c->from);
    append_cut(c, &c->to);
    for (size_t i = 0; i < c->mark.count; i++)
        append_cut(c, &c->mark.item[i]);
    TRY(cut_singular(&k));
    for (size_t i = 0; i < o->equation_count; i++)
        if (is_near[i] && i != c->equation) {
            TRY(cut_by_other(&k, &o->equation[i]));
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
    for (size_t i = 0; i < o->equation_count; i++)
        is_near[i] = 0;
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
        TRY(mark_folds(o, context, &o->curve[k]));
    for (size_t k = 0; k < o->curve_count; k++)
        TRY(store_cuts(o, context, &o->curve[k]));
    for (size_t k = 0; k < o->curve_count; k++)
        if (o->curve[k].group == k)
            TRY(cut_group(o, context, k, is_near));
    return GRAZE_OK;
}
