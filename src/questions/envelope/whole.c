/* Findings, and those at single times at which g vanishes on all of a facet.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

int judge_wants(const graze_envelope *e, graze_decomposable_reason reason) {
    return reason < e->found.reason;
}

graze_status judge_find(graze_envelope *e, graze_context *context, graze_decomposable_reason reason,
                        const graze_cell *facet, const graze_cell *cell, size_t piece,
                        const algebraic *u) {
    if (!judge_wants(e, reason))
        return GRAZE_OK;
    graze_time *time;
    TRY(time_make(&time, context, e->scene->motion, piece, u));
    time_destroy(e->found.time);
    e->found = (finding){reason, *facet, *cell, time};
    return GRAZE_OK;
}

graze_status judge_find_before(graze_envelope *e, graze_context *context,
                               graze_decomposable_reason reason, const graze_cell *facet,
                               const graze_cell *cell, size_t piece, const axis *x, size_t k) {
    HELD(algebraic, u);
    algebraic_set_rational(&u, x->sample + k);
    return judge_find(e, context, reason, facet, cell, piece, &u);
}

int judge_is_break(const graze_envelope *e, size_t piece, const axis *x, size_t k) {
    return (k == 0 && e->is_break[piece]) ||
           (k + 1 == x->count && piece + 1 < e->piece_count && e->is_break[piece + 1]);
}

int judge_is_inner(const graze_envelope *e, size_t piece, const axis *x, size_t k) {
    int is_end = (k == 0 && piece == 0) || (k + 1 == x->count && piece + 1 == e->piece_count);
    return !is_end && !judge_is_break(e, piece, x, k);
}

int judge_is_still(const graze_envelope *e, size_t facet) {
    for (size_t piece = 0; piece < e->piece_count; piece++)
        if (!e->still[piece * e->cells.facet_count + facet])
            return 0;
    return 1;
}

/* The common divisor of the polynomials g at the corners of one simplex of the facet; 0 if all of
 * them are zero.
 */
static void find_common(fmpz_poly_t out, const graze_envelope *e, size_t facet, size_t piece) {
    const cell_complex *c = &e->cells;
    size_t d = (size_t)c->dimension, simplex = c->order[c->facet[facet].first];
    LOCAL(fmpz_poly, g);
    fmpz_poly_zero(out);
    for (size_t k = 0; k < d; k++) {
        derivatives_velocity(g, &e->field[piece], facet, c->corner[simplex * d + k]);
        fmpz_poly_gcd(out, out, g);
    }
}

/* Is theta of the facet negative at one of its corners at parameter u? */
static graze_status is_theta_negative(int *out, const graze_envelope *e, graze_context *context,
                                      size_t facet, size_t piece, algebraic *u) {
    const cell_complex *c = &e->cells;
    size_t d = (size_t)c->dimension;
    LOCAL(fmpz_poly, theta);
    *out = 0;
    for (size_t j = 0; j < c->facet[facet].count * d && !*out; j++) {
        int sign = 0;
        size_t simplex = c->order[c->facet[facet].first + j / d];
        derivatives_along(theta, &e->field[piece], 2, facet, c->corner[simplex * d + j % d]);
        TRY(algebraic_sign_at(&sign, context, theta, u));
        *out = sign < 0;
    }
    return GRAZE_OK;
}

/* Is g of another facet of the edge different from 0 at an end of the edge, at parameter u? */
static graze_status moves_across(int *out, const graze_envelope *e, graze_context *context,
                                 size_t facet, size_t edge, size_t piece, algebraic *u) {
    const cell_complex *c = &e->cells;
    const size_t ends[] = {c->edge[edge].u, c->edge[edge].v};
    LOCAL(fmpz_poly, g);
    *out = 0;
    for (size_t j = c->edge_facets.start[edge]; j < c->edge_facets.start[edge + 1]; j++)
        for (int k = 0; k < 2 && c->edge_facets.item[j] != facet && !*out; k++) {
            derivatives_velocity(g, &e->field[piece], c->edge_facets.item[j], ends[k]);
            TRY(algebraic_sign_at(out, context, g, u));
        }
    return GRAZE_OK;
}

static graze_status judge_whole(graze_envelope *e, graze_context *context, size_t facet,
                                size_t piece, axis *x, size_t k) {
    const cell_complex *c = &e->cells;
    const graze_cell *name = &c->facet[facet].name;
    int found = 0;
    TRY(is_theta_negative(&found, e, context, facet, piece, x->point[k]));
    if (found)
        TRY(judge_find(e, context, GRAZE_REASON_THETA, name, name, piece, x->point[k]));
    for (size_t j = c->facet_edges.start[facet];
         j < c->facet_edges.start[facet + 1] && judge_is_inner(e, piece, x, k); j++) {
        size_t edge = c->facet_edges.item[j];
        if (c->edge[edge].kind != PLACE_REFLEX)
            continue;
        TRY(moves_across(&found, e, context, facet, edge, piece, x->point[k]));
        if (found)
            TRY(judge_find(e, context, GRAZE_REASON_REFLEX, name, &c->edge[edge].name, piece,
                           x->point[k]));
    }
    return GRAZE_OK;
}

graze_status gather_whole(graze_envelope *e, graze_context *context, size_t facet) {
    for (size_t piece = 0; piece < e->piece_count; piece++) {
        LOCAL(fmpz_poly, common);
        find_common(common, e, facet, piece);
        e->still[piece * e->cells.facet_count + facet] = (unsigned char)fmpz_poly_is_zero(common);
        if (fmpz_poly_degree(common) <= 0)
            continue;
        ZEROED(axis, x);
        TRY(axis_make(&x, context, common, 1));
        for (size_t k = 0; k < x.count; k++) {
            int sign = 0;
            TRY(algebraic_sign_at(&sign, context, common, x.point[k]));
            if (sign == 0 && !judge_is_break(e, piece, &x, k))
                TRY(judge_whole(e, context, facet, piece, &x, k));
        }
    }
    return GRAZE_OK;
}
