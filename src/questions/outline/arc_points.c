/* Points at which boundary pieces end: which are one point (proofs/outline.md C139).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/outline/arc_complex.h"

graze_status outline_point_make(const graze_outline *o, graze_context *context, outline_point *p) {
    outline_curve *c = &o->curve[p->curve];
    if (p->made)
        return GRAZE_OK;
    for (int k = 0; k < 2; k++)
        TRY(outline_coordinate(&p->coordinate[k], o, context, c, c->cut[p->cut], k));
    p->made = 1;
    return GRAZE_OK;
}

void outline_point_init(outline_point *p, size_t curve, size_t cut) {
    *p = (outline_point){.curve = curve, .cut = cut};
    for (int k = 0; k < 2; k++) {
        algebraic_init(&p->coordinate[k]);
        bracket_init(&p->place[k]);
    }
}

void outline_point_clear(outline_point *p) {
    for (int k = 0; k < 2; k++) {
        algebraic_clear(&p->coordinate[k]);
        bracket_clear(&p->place[k]);
    }
}

/* Append the point at an end of a piece, or take that of the piece before, which ends there. */
static graze_status append_point(graze_outline *o, graze_context *context, outline_piece *p,
                                 int end) {
    algebraic *s = piece_end(o, p, end);
    size_t cut = p->cut + (size_t)end, before = o->point_count;
    p->end[end] = before;
    if (before && o->point[before - 1].curve == p->curve && o->point[before - 1].cut == cut) {
        p->end[end]--;
        return GRAZE_OK;
    }
    TRY(array_grow(context, &o->point, &o->point_capacity, o->point_count + 1, sizeof *o->point,
                   "the points of an outline"));
    outline_point *made = &o->point[o->point_count];
    outline_point_init(made, p->curve, cut);
    made->vertex = o->point_count++;
    number_reduce(s);
    return outline_curve_place(made->place, context, &o->curve[p->curve], s, POINT_PLACES);
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

static graze_status find_equal(graze_outline *o, graze_context *context,
                               const sorted_point *sorted) {
    for (size_t i = 0; i < o->point_count; i++)
        for (size_t j = i + 1; j < o->point_count; j++) {
            size_t a = sorted[i].number, b = sorted[j].number;
            outline_point *p = &o->point[a], *q = &o->point[b];
            int same = 0;
            if (fmpz_cmp(sorted[j].low, p->place[0].high) > 0)
                break;
            if (p->vertex == q->vertex || !bracket_meets(&p->place[1], &q->place[1]))
                continue;
            TRY(points_equal(&same, o, context, p, q));
            if (same)
                join_points(o, a, b);
        }
    return GRAZE_OK;
}

graze_status outline_points(graze_outline *o, graze_context *context) {
    for (size_t k = 0; k < o->piece_count; k++)
        for (int end = 0; end < 2 && piece_has_ends(&o->piece[k]); end++)
            TRY(append_point(o, context, &o->piece[k], end));
    FREED(sorted_point, sorted, malloc((o->point_count + 1) * sizeof *sorted));
    if (!sorted)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    for (size_t k = 0; k < o->point_count; k++)
        sorted[k] = (sorted_point){o->point[k].place[0].low, k};
    qsort(sorted, o->point_count, sizeof *sorted, compare_lows);
    TRY(find_equal(o, context, sorted));
    for (size_t k = 0; k < o->piece_count; k++)
        for (int end = 0; end < 2 && piece_has_ends(&o->piece[k]); end++)
            o->piece[k].end[end] = o->point[o->piece[k].end[end]].vertex;
    return GRAZE_OK;
}
