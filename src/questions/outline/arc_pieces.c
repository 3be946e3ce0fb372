/* Pieces of the candidate curves between cuts, and which of them are one point set
 * (proofs/outline.md C134).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <flint/fmpq_vec.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "base/number/order.h"
#include "questions/outline/arc_complex.h"

algebraic *piece_end(const graze_outline *o, const outline_piece *p, int end) {
    return o->curve[p->curve].cut[p->cut + (size_t)end];
}

graze_status piece_middle(fmpq_t s, graze_context *context, const graze_outline *o,
                          const outline_piece *p) {
    return algebraic_between(s, context, piece_end(o, p, 0), piece_end(o, p, 1));
}

void outline_curve_at(fmpq *point, const outline_curve *c, const fmpq_t s) {
    LOCAL(fmpq, weight);
    fmpz_poly_evaluate_fmpq(weight, &c->x[2], s);
    for (int i = 0; i < 2; i++) {
        fmpz_poly_evaluate_fmpq(point + i, &c->x[i], s);
        fmpq_div(point + i, point + i, weight);
    }
}

static graze_status append_arc_piece(graze_outline *o, graze_context *context, size_t curve,
                                     size_t cut) {
    outline_curve *c = &o->curve[curve];
    TRY(array_grow(context, &o->piece, &o->piece_capacity, o->piece_count + 1, sizeof *o->piece,
                   "the pieces of an outline"));
    outline_piece *p = &o->piece[o->piece_count];
    memset(p, 0, sizeof *p);
    p->curve = curve;
    p->cut = cut;
    p->same = o->piece_count++;
    p->next_same = OUTLINE_NONE;
    for (int k = 0; k < 4; k++)
        fmpq_init(&p->sample[k]);
    TRY(outline_curve_box(&p->box, context, c, c->cut[cut], c->cut[cut + 1]));
    for (int k = 0; k < 2; k++) {
        p->box.low[k] = fmax(p->box.low[k], c->box.low[k]);
        p->box.high[k] = fmin(p->box.high[k], c->box.high[k]);
    }
    return context_work(context, 10000);
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

/* Does a piece that is not slanted pass a point, within? */
static graze_status piece_passes(int *out, graze_context *context, const graze_outline *o,
                                 const outline_piece *p, const fmpq *point) {
    LOCAL(fmpz_poly, at_point);
    HELD(dyadic_interval, range);
    HELD(algebraic_list, roots);
    *out = 0;
    outline_curve_at_point(at_point, &o->curve[p->curve], point);
    if (fmpz_poly_degree(at_point) < 1)
        return GRAZE_OK;
    interval_of(&range, piece_end(o, p, 0), piece_end(o, p, 1));
    TRY(algebraic_roots(&roots, context, at_point, &range));
    for (size_t k = 0; k < roots.count && !*out; k++)
        TRY(number_between(out, context, piece_end(o, p, 0), &roots.item[k], piece_end(o, p, 1)));
    return GRAZE_OK;
}

void slant_section(fmpz_poly_t out, const graze_outline *o, const outline_curve *c,
                   const fmpq_t s) {
    const outline_equation *e = &o->equation[c->equation];
    LOCAL_VEC(fmpz_poly, x, 3);
    fmpz_poly_set_fmpz(x + c->axis, fmpq_numref(s));
    fmpz_poly_set_coeff_fmpz(x + 1 - c->axis, 1, fmpq_denref(s));
    fmpz_poly_set_fmpz(x + 2, fmpq_denref(s));
    form_pullback(out, e->form, e->degree, x, o->ring_of_forms);
}

graze_status slant_other(bracket *out, graze_context *context, outline_curve *c, const fmpq_t s,
                         ulong places) {
    HELD(algebraic, at);
    algebraic_set_rational(&at, s);
    HELD(point_place, here);
    TRY(outline_curve_place(here.xy, context, c, &at, places));
    bracket_set(out, &here.xy[1 - c->axis]);
    return GRAZE_OK;
}

/* Do two slanted curves of one equation meet where their parameter is s? There all lines of the
 * equation are apart, so one root in the hull of both places means one line. */
static graze_status lines_meet(int *out, graze_context *context, const graze_outline *o,
                               outline_curve *a, outline_curve *b, const fmpq_t s) {
    HELD(bracket, x);
    HELD(bracket, y);
    HELD(algebraic, root);
    LOCAL(fmpz_poly, section);
    slant_section(section, o, a, s);
    *out = 0;
    for (ulong places = 64; !*out; places *= 2) {
        TRY(slant_other(&x, context, a, s, places));
        TRY(slant_other(&y, context, b, s, places));
        if (!bracket_meets(&x, &y))
            return GRAZE_OK;
        bracket_join(&x, &y);
        TRY(number_in_bracket(out, &root, context, section, &x, places));
    }
    return GRAZE_OK;
}

static graze_status slants_are_same(int *out, graze_context *context, const graze_outline *o,
                                    const outline_piece *p, const outline_piece *q) {
    HELD(algebraic, s);
    TRY(piece_middle(s.value, context, o, p));
    TRY(number_between(out, context, piece_end(o, q, 0), &s, piece_end(o, q, 1)));
    return *out ? lines_meet(out, context, o, &o->curve[p->curve], &o->curve[q->curve], s.value)
                : GRAZE_OK;
}

/* Find the later pieces of one equation, from entry `first` of `order` on, that are the piece
 * `first`. */
static graze_status find_same(graze_outline *o, graze_context *context, const size_t *order,
                              size_t first, size_t end) {
    outline_piece *p = &o->piece[order[first]];
    LOCAL(fmpq, s);
    LOCAL_VEC(fmpq, point, 2);
    int is_slant = o->curve[p->curve].slant;
    if (p->same != order[first])
        return GRAZE_OK;
    if (!is_slant) {
        TRY(piece_middle(s, context, o, p));
        outline_curve_at(point, &o->curve[p->curve], s);
    }
    size_t *tail = &p->next_same;
    for (size_t k = first + 1; k < end; k++) {
        outline_piece *q = &o->piece[order[k]];
        int same = 0;
        if (q->same != order[k] || !box_meets(&p->box, &q->box))
            continue;
        TRY(is_slant ? slants_are_same(&same, context, o, p, q)
                     : piece_passes(&same, context, o, q, point));
        if (same) {
            q->same = order[first];
            *tail = order[k];
            tail = &q->next_same;
        }
    }
    return context_work(context, 1000 + end - first);
}

/* Number the pieces of an equation; several curves or one curve that is not proper may cover a
 * piece more than once. */
static graze_status find_same_of_equation(graze_outline *o, graze_context *context, size_t equation,
                                          size_t *order) {
    size_t count = 0;
    int is_proper = 1;
    for (size_t k = 0; k < o->piece_count; k++)
        if (o->curve[o->piece[k].curve].equation == equation) {
            is_proper = is_proper && o->curve[o->piece[k].curve].proper;
            order[count++] = k;
        }
    if (o->equation[equation].curve_count == 1 && is_proper)
        return GRAZE_OK;
    for (size_t k = 0; k < count; k++)
        TRY(find_same(o, context, order, k, count));
    return GRAZE_OK;
}

graze_status outline_pieces(graze_outline *o, graze_context *context) {
    for (size_t k = 0; k < o->curve_count; k++)
        for (size_t cut = 0; cut + 1 < o->curve[k].cut_count; cut++)
            TRY(append_arc_piece(o, context, k, cut));
    FREED(size_t, order, malloc((o->piece_count + 1) * sizeof *order));
    if (!order)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    for (size_t k = 0; k < o->equation_count; k++)
        TRY(find_same_of_equation(o, context, k, order));
    return GRAZE_OK;
}
