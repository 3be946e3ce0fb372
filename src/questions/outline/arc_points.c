/* Points at which boundary pieces end: which are one point (proofs/outline.md C136).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/order.h"
#include "questions/outline/arc_complex.h"

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

/* The coordinate of a slanted line beside its parameter, from the form of its conjugates. */
static graze_status slant_coordinate(algebraic *out, const graze_outline *o, graze_context *context,
                                     outline_curve *c, algebraic *s) {
    const fmpz_mpoly_ctx_struct *ring = o->ring_of_forms;
    int found = 0;
    LOCAL(fmpz_poly, p);
    LOCAL(fmpz_poly, common);
    IN_RING(fmpz_mpoly, at, ring);
    IN_RING(fmpz_mpoly, rest, ring);
    number_minimal(p, s);
    form_add(at, p, c->axis, 0, 0, 1, ring);
    TRY(form_eliminate(rest, context, o->equation[c->equation].form, at, c->axis, ring));
    form_to_poly(p, rest, 1 - c->axis, ring);
    fmpz_poly_derivative(common, p);
    fmpz_poly_gcd(common, common, p);
    fmpz_poly_div(p, p, common);
    HELD(point_place, here);
    for (ulong places = 64; !found; places *= 2) {
        TRY(outline_curve_place(here.xy, context, c, s, places));
        TRY(number_in_bracket(&found, out, context, p, &here.xy[1 - c->axis], places));
    }
    number_reduce(out);
    return GRAZE_OK;
}

graze_status outline_point_make(const graze_outline *o, graze_context *context, outline_point *p) {
    outline_curve *c = &o->curve[p->curve];
    algebraic *s = c->cut[p->cut];
    if (p->made)
        return GRAZE_OK;
    for (int k = 0; k < 2; k++)
        if (!c->slant) {
            TRY(image_number(&p->coordinate[k], context, &c->x[k], &c->x[2], s));
        } else if (k != c->axis) {
            TRY(slant_coordinate(&p->coordinate[k], o, context, c, s));
        } else {
            algebraic_set(&p->coordinate[k], s);
            number_reduce(&p->coordinate[k]);
        }
    p->made = 1;
    return GRAZE_OK;
}

/* A finder of the points; entry start[c] + k of `known` is 1 + the number of the point at cut k of
 * curve c, or 0. */
typedef struct point_finder {
    graze_outline *o;
    graze_context *context;
    size_t *start, *known;
} point_finder;

static graze_status append_point(point_finder *f, size_t curve, size_t cut) {
    graze_outline *o = f->o;
    TRY(array_grow(f->context, &o->point, &o->point_capacity, o->point_count + 1, sizeof *o->point,
                   "the points of an outline"));
    outline_point *p = &o->point[o->point_count];
    memset(p, 0, sizeof *p);
    p->curve = curve;
    p->cut = cut;
    p->vertex = o->point_count++;
    for (int k = 0; k < 2; k++) {
        algebraic_init(&p->coordinate[k]);
        bracket_init(&p->place[k]);
    }
    outline_curve *c = &o->curve[curve];
    return outline_curve_place(p->place, f->context, c, c->cut[cut], POINT_PLACES);
}

static graze_status add_ends(point_finder *f, outline_piece *p) {
    for (size_t end = 0; end < 2; end++) {
        size_t *known = &f->known[f->start[p->curve] + p->cut + end];
        if (!*known) {
            number_reduce(piece_end(f->o, p, (int)end));
            TRY(append_point(f, p->curve, p->cut + end));
            *known = f->o->point_count;
        }
        p->end[end] = *known - 1;
    }
    return GRAZE_OK;
}

graze_status points_equal(int *out, graze_outline *o, graze_context *context, outline_point *a,
                          outline_point *b) {
    int order = 0;
    *out = 0;
    TRY(outline_point_make(o, context, a));
    TRY(outline_point_make(o, context, b));
    for (int k = 0; k < 2; k++) {
        TRY(algebraic_compare(&order, context, &a->coordinate[k], &b->coordinate[k]));
        if (order)
            return GRAZE_OK;
    }
    *out = 1;
    return GRAZE_OK;
}

/* An entry of the sorted list of points. */
typedef struct sorted_point {
    const fmpz *low;
    size_t number;
} sorted_point;

static int compare_lows(const void *left, const void *right) {
    const sorted_point *a = left, *b = right;
    int order = fmpz_cmp(a->low, b->low);
    return order ? order : a->number < b->number ? -1 : a->number > b->number;
}

/* Join point b to point a: both have one number from now on. */
static void join_points(graze_outline *o, size_t a, size_t b) {
    size_t from = o->point[b].vertex, to = o->point[a].vertex;
    for (size_t k = 0; k < o->point_count; k++)
        if (o->point[k].vertex == from)
            o->point[k].vertex = to;
}

static graze_status find_equal(point_finder *f, const sorted_point *sorted) {
    graze_outline *o = f->o;
    for (size_t i = 0; i < o->point_count; i++)
        for (size_t j = i + 1; j < o->point_count; j++) {
            size_t a = sorted[i].number, b = sorted[j].number;
            outline_point *p = &o->point[a], *q = &o->point[b];
            int same = 0;
            if (fmpz_cmp(sorted[j].low, p->place[0].high) > 0)
                break;
            if (p->vertex == q->vertex || !bracket_meets(&p->place[1], &q->place[1]))
                continue;
            TRY(points_equal(&same, o, f->context, p, q));
            if (same)
                join_points(o, a, b);
        }
    return GRAZE_OK;
}

static graze_status find_points(point_finder *f) {
    graze_outline *o = f->o;
    for (size_t k = 0; k < o->piece_count; k++)
        if (o->piece[k].turn || o->piece[k].lower == 1)
            TRY(add_ends(f, &o->piece[k]));
    FREED(sorted_point, sorted, malloc((o->point_count + 1) * sizeof *sorted));
    if (!sorted)
        return context_fail(f->context, GRAZE_ESYSTEM, "out of memory for an outline");
    for (size_t k = 0; k < o->point_count; k++)
        sorted[k] = (sorted_point){o->point[k].place[0].low, k};
    qsort(sorted, o->point_count, sizeof *sorted, compare_lows);
    TRY(find_equal(f, sorted));
    for (size_t k = 0; k < o->piece_count; k++)
        for (int end = 0; end < 2 && (o->piece[k].turn || o->piece[k].lower == 1); end++)
            o->piece[k].end[end] = o->point[o->piece[k].end[end]].vertex;
    return GRAZE_OK;
}

graze_status outline_points(graze_outline *o, graze_context *context) {
    size_t total = 0;
    for (size_t k = 0; k < o->curve_count; k++)
        total += o->curve[k].cut_count;
    FREED(size_t, start, malloc((o->curve_count + 1) * sizeof *start));
    FREED(size_t, known, calloc(total + 1, sizeof *known));
    if (!start || !known)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    point_finder f = {o, context, start, known};
    total = 0;
    for (size_t k = 0; k < o->curve_count; k++) {
        start[k] = total;
        total += o->curve[k].cut_count;
    }
    return find_points(&f);
}
