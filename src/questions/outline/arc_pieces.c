/* Pieces of the candidate curves between cuts, and which of them are one point set
 * (proofs/outline.md C137).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/outline/arc_complex.h"

algebraic *piece_end(const graze_outline *o, const outline_piece *p, int end) {
    return o->curve[p->curve].cut[p->cut + (size_t)end];
}

graze_status piece_middle(fmpq_t s, graze_context *context, const graze_outline *o,
                          const outline_piece *p) {
    return algebraic_between(s, context, piece_end(o, p, 0), piece_end(o, p, 1));
}

/* The crossings on a slanted line: at most one, and that where the ends are on both sides. */
static graze_status cross_slant(algebraic_list *out, const graze_outline *o, graze_context *context,
                                outline_curve *c, algebraic *from, algebraic *to, int axis,
                                const fmpq_t value) {
    int side[2] = {0};
    TRY(outline_side(&side[0], o, context, c, from, axis, value));
    TRY(outline_side(&side[1], o, context, c, to, axis, value));
    if (side[0] * side[1] >= 0)
        return GRAZE_OK;
    algebraic *at = algebraic_list_append(out);
    if (axis != c->axis)
        return outline_line_crossing(at, o, context, c, value);
    algebraic_set_rational(at, value);
    return GRAZE_OK;
}

graze_status outline_crossings(algebraic_list *out, const graze_outline *o, graze_context *context,
                               outline_curve *c, algebraic *from, algebraic *to, int axis,
                               const fmpq_t value) {
    LOCAL(fmpz_poly, level);
    LOCAL(fmpz_poly_factor, factors);
    if (c->slant)
        return cross_slant(out, o, context, c, from, to, axis, value);
    outline_curve_level(level, c, axis, value);
    if (fmpz_poly_degree(level) > 0)
        fmpz_poly_factor_squarefree(factors, level);
    for (slong k = 0; k < factors->num; k++)
        if (factors->exp[k] % 2) /* an even root touches the line */
            TRY(roots_between(out, context, factors->p + k, from, to));
    return GRAZE_OK;
}

graze_status outline_side(int *out, const graze_outline *o, graze_context *context,
                          outline_curve *c, algebraic *s, int axis, const fmpq_t value) {
    if (c->slant) {
        HELD(algebraic, x);
        HELD(algebraic, y);
        algebraic_set_rational(&y, value);
        TRY(outline_coordinate(&x, o, context, c, s, axis));
        return algebraic_compare(out, context, &x, &y);
    }
    int weight = 0;
    LOCAL(fmpz_poly, level);
    outline_curve_level(level, c, axis, value);
    TRY(algebraic_sign_at(&weight, context, &c->x[2], s));
    TRY(algebraic_sign_at(out, context, level, s));
    *out *= weight;
    return GRAZE_OK;
}

static graze_status append_arc_piece(graze_outline *o, graze_context *context, size_t curve,
                                     size_t cut) {
    outline_curve *c = &o->curve[curve];
    box around;
    TRY(outline_curve_box(&around, context, c, c->cut[cut], c->cut[cut + 1]));
    for (int k = 0; k < 2; k++) {
        around.low[k] = fmax(around.low[k], c->box.low[k]);
        around.high[k] = fmin(around.high[k], c->box.high[k]);
    }
    if (outline_covers(o, &around, c->piece))
        return context_work(context, 10000);
    TRY(array_grow(context, &o->piece, &o->piece_capacity, o->piece_count + 1, sizeof *o->piece,
                   "the pieces of an outline"));
    outline_piece *p = &o->piece[o->piece_count];
    memset(p, 0, sizeof *p); /* zeros are initialised numbers */
    p->curve = curve;
    p->cut = cut;
    p->same = o->piece_count++;
    p->next_same = OUTLINE_NONE;
    p->box = around;
    return context_work(context, 10000);
}

/* Does a piece that is not slanted pass a point, within? */
static graze_status piece_passes(int *out, graze_context *context, const graze_outline *o,
                                 const outline_piece *p, const fmpq *point) {
    LOCAL(fmpz_poly, at_point);
    HELD(algebraic_list, roots);
    outline_curve_at_point(at_point, &o->curve[p->curve], point);
    if (fmpz_poly_degree(at_point) > 0)
        TRY(roots_between(&roots, context, at_point, piece_end(o, p, 0), piece_end(o, p, 1)));
    *out = roots.count > 0;
    return GRAZE_OK;
}

/* Do two pieces on slanted lines meet? They do if they have a point in common within p. */
static graze_status slants_are_same(int *out, graze_context *context, const graze_outline *o,
                                    const outline_piece *p, const outline_piece *q) {
    outline_curve *c = &o->curve[p->curve];
    HELD(algebraic, s);
    HELD(algebraic, x);
    HELD(algebraic, y);
    int order = 0;
    TRY(piece_middle(s.value, context, o, p));
    TRY(number_between(out, context, piece_end(o, q, 0), &s, piece_end(o, q, 1)));
    if (!*out)
        return GRAZE_OK;
    TRY(outline_coordinate(&x, o, context, c, &s, 1 - c->axis));
    TRY(outline_coordinate(&y, o, context, &o->curve[q->curve], &s, 1 - c->axis));
    TRY(algebraic_compare(&order, context, &x, &y));
    *out = order == 0;
    return GRAZE_OK;
}

/* Find the later pieces of the equation that are the piece `first`. */
static graze_status find_same(graze_outline *o, graze_context *context, size_t first) {
    outline_piece *p = &o->piece[first];
    const outline_curve *c = &o->curve[p->curve];
    LOCAL(fmpq, s);
    LOCAL_VEC(fmpq, point, 2);
    /* A proper curve that is alone covers no piece twice. */
    if (p->same != first || (c->proper && o->equation[c->equation].curve_count == 1))
        return GRAZE_OK;
    if (!c->slant) {
        TRY(piece_middle(s, context, o, p));
        outline_curve_at(point, c, s);
    }
    size_t *tail = &p->next_same;
    for (size_t k = first + 1; k < o->piece_count; k++) {
        outline_piece *q = &o->piece[k];
        int same = 0;
        if (q->same != k || !box_meets(&p->box, &q->box) ||
            o->curve[q->curve].equation != c->equation)
            continue;
        TRY(c->slant ? slants_are_same(&same, context, o, p, q)
                     : piece_passes(&same, context, o, q, point));
        if (same) {
            q->same = first;
            *tail = k;
            tail = &q->next_same;
        }
    }
    return context_work(context, o->piece_count);
}

graze_status outline_pieces(graze_outline *o, graze_context *context) {
    for (size_t k = 0; k < o->curve_count; k++)
        for (size_t cut = 0; cut + 1 < o->curve[k].cut_count; cut++)
            TRY(append_arc_piece(o, context, k, cut));
    for (size_t k = 0; k < o->piece_count; k++)
        TRY(find_same(o, context, k));
    return GRAZE_OK;
}
