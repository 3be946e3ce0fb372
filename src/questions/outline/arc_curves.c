/* Candidate curves: memory, reduction, boxes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/bernstein.h"
#include "base/number/isolate.h"
#include "base/number/rounding.h"
#include "base/number/vector.h"
#include "decide/trace/trace.h"
#include "questions/outline/arcs.h"

graze_status outline_curve_append(outline_curve **out, graze_outline *o, graze_context *context) {
    TRY(array_grow(context, &o->curve, &o->curve_capacity, o->curve_count + 1, sizeof *o->curve,
                   "the curves of an outline"));
    outline_curve *c = &o->curve[o->curve_count++];
    memset(c, 0, sizeof *c);
    c->axis = -1;
    algebraic_init(&c->at);
    algebraic_init(&c->from);
    algebraic_init(&c->to);
    algebraic_list_init(&c->mark);
    algebraic_list_init(&c->cut_number);
    for (int k = 0; k < 3; k++)
        fmpz_poly_init(&c->x[k]);
    *out = c;
    return GRAZE_OK;
}

void outline_curve_clear(outline_curve *c) {
    algebraic_clear(&c->at);
    algebraic_clear(&c->from);
    algebraic_clear(&c->to);
    algebraic_list_clear(&c->mark);
    algebraic_list_clear(&c->cut_number);
    flint_free(c->cut);
    for (int k = 0; k < 3; k++)
        fmpz_poly_clear(&c->x[k]);
}

graze_status outline_keep_point(fmpq **list, size_t *count, size_t *capacity,
                                graze_context *context, const fmpq *point) {
    size_t before = *capacity;
    TRY(array_grow(context, list, capacity, *count + 1, 2 * sizeof **list,
                   "the points of an outline"));
    for (size_t k = 2 * before; k < 2 * *capacity; k++)
        fmpq_init(*list + k);
    vector_set(*list + 2 * (*count)++, point, 2);
    return GRAZE_OK;
}

slong outline_curve_degree(const outline_curve *c) {
    slong degree = 0;
    for (int k = 0; k < 3; k++)
        degree = FLINT_MAX(degree, fmpz_poly_degree(&c->x[k]));
    return degree;
}

void outline_curve_at(fmpq *point, const outline_curve *c, const fmpq_t s) {
    LOCAL(fmpq, weight);
    fmpz_poly_evaluate_fmpq(weight, &c->x[2], s);
    for (int i = 0; i < 2; i++) {
        fmpz_poly_evaluate_fmpq(point + i, &c->x[i], s);
        fmpq_div(point + i, point + i, weight);
    }
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

/* A dyadic interval that holds both numbers. */
static void interval_of(dyadic_interval *out, const algebraic *from, const algebraic *to) {
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    LOCAL(fmpq, other);
    algebraic_bounds(low, other, from);
    algebraic_bounds(other, high, to);
    /* Sixteen places more than the interval's length has. */
    fmpq_sub(other, high, low);
    slong bits = (slong)fmpz_bits(fmpq_denref(other)) - (slong)fmpz_bits(fmpq_numref(other));
    out->exponent = (ulong)FLINT_MAX(bits, 0) + 16;
    fmpz_mul_2exp(out->low, fmpq_numref(low), out->exponent);
    fmpz_fdiv_q(out->low, out->low, fmpq_denref(low));
    fmpz_mul_2exp(out->high, fmpq_numref(high), out->exponent);
    fmpz_cdiv_q(out->high, out->high, fmpq_denref(high));
    if (fmpz_equal(out->low, out->high))
        fmpz_add_ui(out->high, out->high, 1);
}

graze_status roots_about(algebraic_list *list, graze_context *context, const fmpz_poly_t p,
                         const algebraic *from, const algebraic *to) {
    HELD(dyadic_interval, range);
    interval_of(&range, from, to);
    return algebraic_roots(list, context, p, &range);
}

graze_status number_between(int *out, graze_context *context, algebraic *low, algebraic *x,
                            algebraic *high) {
    int order = 0;
    TRY(algebraic_compare(&order, context, low, x));
    *out = order < 0;
    if (*out)
        TRY(algebraic_compare(&order, context, x, high));
    *out = *out && order < 0;
    return GRAZE_OK;
}

graze_status roots_between(algebraic_list *list, graze_context *context, const fmpz_poly_t p,
                           algebraic *from, algebraic *to) {
    HELD(algebraic_list, roots);
    TRY(roots_about(&roots, context, p, from, to));
    for (size_t k = 0; k < roots.count; k++) {
        int inside = 0;
        TRY(number_between(&inside, context, from, &roots.item[k], to));
        if (inside)
            algebraic_set(algebraic_list_append(list), &roots.item[k]);
    }
    return GRAZE_OK;
}

graze_status outline_curve_corners(fmpq *corner, graze_context *context, outline_curve *c,
                                   algebraic *s, ulong places) {
    HELD(point_place, here);
    TRY(outline_curve_place(here.xy, context, c, s, places));
    for (int k = 0; k < 2; k++) {
        bracket_low(corner + k, &here.xy[k], places);
        bracket_high(corner + 2 + k, &here.xy[k], places);
    }
    return GRAZE_OK;
}

void box_empty(box *out) {
    *out = (box){{INFINITY, INFINITY, 0}, {-INFINITY, -INFINITY, 0}};
}

void box_add_point(box *out, const fmpq *point) {
    double low, high;
    for (int k = 0; k < 2; k++) {
        rational_bounds(&low, &high, point + k);
        out->low[k] = fmin(out->low[k], low);
        out->high[k] = fmax(out->high[k], high);
    }
}

/* Binary places to which ends of parts are known. */
enum { END_PLACES = 80 };

/* Widen a box to hold a place of a curve. */
static graze_status box_add_place(box *out, graze_context *context, outline_curve *c,
                                  algebraic *s) {
    LOCAL_VEC(fmpq, corner, 4);
    if (!c->slant && algebraic_is_rational(s)) {
        outline_curve_at(corner, c, s->value);
        box_add_point(out, corner);
        return GRAZE_OK;
    }
    TRY(outline_curve_corners(corner, context, c, s, END_PLACES));
    box_add_point(out, corner);
    box_add_point(out, corner + 2);
    return GRAZE_OK;
}

static graze_status box_of_part(box *out, graze_context *context, outline_curve *c, algebraic *from,
                                algebraic *to, int depth) {
    slong n = outline_curve_degree(c) + 1;
    LOCAL_VEC(fmpz, b, 3 * n);
    HELD(dyadic_interval, part);
    HELD(bracket, end);
    trajectory t = {.dimension = 2, .degree = n - 1};
    TRY(bracket_of_number(&end, context, from, END_PLACES));
    TRY(bracket_of_number(&end, context, to, END_PLACES));
    interval_of(&part, from, to);
    for (int k = 0; k < 3; k++) {
        t.x[k] = c->x[k]; /* borrowed */
        bernstein_from_poly(b + k * n, &c->x[k], n - 1, &part);
    }
    if (fmpz_sgn(b + 2 * n) < 0)
        _fmpz_vec_neg(b, b, 3 * n);
    if (trajectory_bound(out, &t, b) || depth == 0)
        return GRAZE_OK;
    HELD(algebraic, middle);
    box right;
    TRY(algebraic_between(middle.value, context, from, to));
    TRY(box_of_part(out, context, c, from, &middle, depth - 1));
    TRY(box_of_part(&right, context, c, &middle, to, depth - 1));
    for (int k = 0; k < 2; k++) {
        out->low[k] = fmin(out->low[k], right.low[k]);
        out->high[k] = fmax(out->high[k], right.high[k]);
    }
    return GRAZE_OK;
}

graze_status outline_place_box(box *out, graze_context *context, outline_curve *c, algebraic *s) {
    box_empty(out);
    return box_add_place(out, context, c, s);
}

graze_status outline_curve_box(box *out, graze_context *context, outline_curve *c, algebraic *from,
                               algebraic *to) {
    enum { HALVINGS = 10 };
    if (!c->slant && outline_curve_degree(c) > 1)
        return box_of_part(out, context, c, from, to, HALVINGS);
    TRY(outline_place_box(out, context, c, from)); /* straight and without turns */
    return box_add_place(out, context, c, to);
}
