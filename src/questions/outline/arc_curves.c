/* Candidate curves: memory, reduction, boxes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <flint/fmpz_vec.h>
#include <math.h>
#include <string.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/bernstein.h"
#include "base/number/order.h"
#include "base/number/rounding.h"
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

void outline_curve_drop_last(graze_outline *o) {
    outline_curve_clear(&o->curve[--o->curve_count]);
}

slong outline_curve_degree(const outline_curve *c) {
    slong degree = 0;
    for (int k = 0; k < 3; k++)
        degree = FLINT_MAX(degree, fmpz_poly_degree(&c->x[k]));
    return degree;
}

int outline_curve_reduce(outline_curve *c) {
    LOCAL(fmpz_poly, common);
    fmpz_poly_gcd(common, &c->x[0], &c->x[1]);
    fmpz_poly_gcd(common, common, &c->x[2]);
    for (int k = 0; k < 3; k++)
        fmpz_poly_div(&c->x[k], &c->x[k], common);
    return outline_curve_degree(c) == 0;
}

void interval_of(dyadic_interval *out, const algebraic *from, const algebraic *to) {
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    LOCAL(fmpq, other);
    algebraic_bounds(low, other, from);
    algebraic_bounds(other, high, to);
    /* Sixty-four places more than the shorter interval's length has. */
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

/* Binary places to which ends of parts are known. */
enum { END_PLACES = 80 };

/* Widen a box to hold a place of a curve. */
static graze_status box_add_place(box *out, graze_context *context, outline_curve *c,
                                  algebraic *s) {
    HELD(point_place, here);
    LOCAL(fmpq, end);
    double low, high;
    TRY(outline_curve_place(here.xy, context, c, s, END_PLACES));
    for (int k = 0; k < 2; k++) {
        bracket_low(end, &here.xy[k], END_PLACES);
        rational_bounds(&low, &high, end);
        out->low[k] = fmin(out->low[k], low);
        bracket_high(end, &here.xy[k], END_PLACES);
        rational_bounds(&low, &high, end);
        out->high[k] = fmax(out->high[k], high);
    }
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

graze_status outline_curve_box(box *out, graze_context *context, outline_curve *c, algebraic *from,
                               algebraic *to) {
    enum { HALVINGS = 10 };
    *out = (box){{INFINITY, INFINITY, 0}, {-INFINITY, -INFINITY, 0}};
    if (!c->slant && outline_curve_degree(c) > 1)
        return box_of_part(out, context, c, from, to, HALVINGS);
    TRY(box_add_place(out, context, c, from)); /* straight and without turns */
    return box_add_place(out, context, c, to);
}
