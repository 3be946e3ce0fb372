/* Findings at breaks, with contact on one side and then on the other.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The envelope may not decompose if there is contact before the break and all g are positive after
 * it (turn = 1), or contact after it and all g are negative before it (turn = -1). In both cases
 * all g of the side without contact, times `turn`, are positive. Values at the break are rational.
 */
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

/* Two pieces that meet at a break: the one that is searched for contact, and the other. */
typedef struct meeting_pieces {
    graze_envelope *e;
    size_t contact, other;
    int turn; /* 1: contact before the break */
} meeting_pieces;

/* g at the break times `turn`, by the piece with contact or, if `other`, by the other piece. */
static void break_value(fmpz_t out, const meeting_pieces *m, int other, size_t facet,
                        size_t vertex) {
    LOCAL(fmpz_poly, g);
    derivatives_velocity(g, &m->e->field[other ? m->other : m->contact], facet, vertex);
    int at_one = (m->turn > 0) != other;
    LOCAL(fmpz, u);
    fmpz_set_si(u, at_one);
    fmpz_poly_evaluate_fmpz(out, g, u);
    fmpz_mul_si(out, out, m->turn);
}

static int break_sign(const meeting_pieces *m, int other, size_t facet, size_t vertex) {
    LOCAL(fmpz, value);
    break_value(value, m, other, facet, vertex);
    return fmpz_sgn(value);
}

/* The sign of g times `turn` next to the break, within the piece with contact. */
static int sign_beside(const meeting_pieces *m, size_t facet, size_t vertex) {
    int sign = 0, flip = m->turn;
    LOCAL(fmpz_poly, g);
    LOCAL(fmpz, u);
    fmpz_set_si(u, m->turn > 0);
    LOCAL(fmpz, value);
    derivatives_velocity(g, &m->e->field[m->contact], facet, vertex);
    while (!sign && !fmpz_poly_is_zero(g)) {
        fmpz_poly_evaluate_fmpz(value, g, u);
        sign = fmpz_sgn(value) * flip;
        flip = m->turn > 0 ? -flip : flip;
        fmpz_poly_derivative(g, g);
    }
    return sign;
}

static int is_vertex_bad(const meeting_pieces *m, size_t vertex) {
    const cell_complex *c = &m->e->cells;
    int low = 1, high = -1, all = 1;
    if (c->vertex[vertex].kind == PLACE_REFLEX || c->vertex[vertex].kind == PLACE_OTHER)
        return 0;
    cell_span facets = cells_of(&c->vertex_facets, vertex);
    for (size_t j = 0; j < facets.count && all; j++) {
        int beside = sign_beside(m, facets.item[j], vertex);
        low = beside < low ? beside : low;
        high = beside > high ? beside : high;
        all = break_sign(m, 1, facets.item[j], vertex) > 0;
    }
    return all && low <= 0 && high >= 0;
}

/* The sign, `lambda` of the way along an edge, of a linear function with the values `at` at the
 * ends. */
static int sign_along(const fmpz at[2], const fmpq_t lambda) {
    LOCAL(fmpz, step);
    LOCAL(fmpq, value);
    fmpz_sub(step, at + 1, at);
    fmpq_mul_fmpz(value, lambda, step);
    fmpq_add_fmpz(value, value, at);
    return fmpq_sgn(value);
}

/* Is there a place on the edge at which the first two of four linear functions have opposite signs
 * and the last two are positive? One place between neighbouring zeros is tested for all. */
static int has_place(const fmpz *f) {
    LOCAL_VEC(fmpq, place, 6);
    slong count = 1;
    int found = 0;
    LOCAL(fmpq, middle);
    for (int k = 0; k < 4; k++)
        if (fmpz_sgn(f + 2 * k) * fmpz_sgn(f + 2 * k + 1) < 0) {
            fmpz_sub(fmpq_denref(place + count), f + 2 * k, f + 2 * k + 1);
            fmpz_set(fmpq_numref(place + count), f + 2 * k);
            fmpq_canonicalise(place + count++);
        }
    fmpq_set_si(place + count++, 1, 1);
    _fmpq_vec_sort(place, count);
    for (slong k = 1; k < count && !found; k++) {
        fmpq_add(middle, place + k - 1, place + k);
        fmpq_div_2exp(middle, middle, 1);
        found = sign_along(f, middle) * sign_along(f + 2, middle) < 0 &&
                sign_along(f + 4, middle) > 0 && sign_along(f + 6, middle) > 0;
    }
    return found;
}

/* Is the break bad at some point of a convex edge? The edge has two planes; facets in one plane
 * have the same g. */
static int is_edge_bad(const meeting_pieces *m, size_t edge) {
    const cell_complex *c = &m->e->cells;
    const cell_edge *e = &c->edge[edge];
    if (e->kind != PLACE_CONVEX)
        return 0;
    cell_span facets = cells_of(&c->edge_facets, edge);
    LOCAL_VEC(fmpz, value, 8);
    for (int k = 0; k < 4; k++) {
        size_t facet = facets.item[k % 2 ? facets.count - 1 : 0];
        break_value(value + 2 * k, m, k >= 2, facet, e->u);
        break_value(value + 2 * k + 1, m, k >= 2, facet, e->v);
    }
    return has_place(value);
}

/* Does the facet's slice at the break end on the edge at a point where g of the other piece, times
 * `turn`, is positive? In E^2 that end is the slice itself. */
static int is_slice_bad(const meeting_pieces *m, size_t facet, size_t edge) {
    const cell_edge *e = &m->e->cells.edge[edge];
    LOCAL_VEC(fmpz, u, 4);
    fmpz *v = u + 1, *other_u = u + 2, *other_v = u + 3;
    break_value(u, m, 0, facet, e->u);
    break_value(v, m, 0, facet, e->v);
    break_value(other_u, m, 1, facet, e->u);
    break_value(other_v, m, 1, facet, e->v);
    int ends = fmpz_sgn(u) * fmpz_sgn(v) < 0, sign = fmpz_sgn(u);
    fmpz_mul(u, u, other_v);
    fmpz_submul(u, v, other_u);
    return ends && fmpz_sgn(u) * sign > 0;
}

/* Is is_slice_bad true of an edge of the facet? If g is 0 on the whole facet all along the piece:
 * is g of the other piece, times `turn`, positive at a vertex of the facet? */
static int is_facet_bad(const meeting_pieces *m, size_t facet) {
    const cell_complex *c = &m->e->cells;
    int bad = 0, still = m->e->still[m->contact * c->facet_count + facet];
    cell_span edges = cells_of(&c->facet_edges, facet);
    for (size_t j = 0; j < edges.count && !bad; j++) {
        const cell_edge *e = &c->edge[edges.item[j]];
        bad = still ? break_sign(m, 1, facet, e->u) > 0 || break_sign(m, 1, facet, e->v) > 0
                    : is_slice_bad(m, facet, edges.item[j]);
    }
    return bad;
}

static graze_status judge_turn(const meeting_pieces *m, graze_context *context,
                               const algebraic *start, size_t piece) {
    const cell_complex *c = &m->e->cells;
    for (size_t k = 0; k < c->facet_count; k++)
        if (is_facet_bad(m, k))
            TRY(judge_find(m->e, context, GRAZE_REASON_BREAK, &c->facet[k].name, &c->facet[k].name,
                           piece, start));
    for (size_t k = 0; k < c->edge_count; k++)
        if (is_edge_bad(m, k))
            TRY(judge_find(m->e, context, GRAZE_REASON_BREAK, &NO_CELL, &c->edge[k].name, piece,
                           start));
    for (size_t k = 0; k < c->vertex_count; k++)
        if (is_vertex_bad(m, k))
            TRY(judge_find(m->e, context, GRAZE_REASON_BREAK, &NO_CELL, &c->vertex[k].name, piece,
                           start));
    return context_poll(context);
}

graze_status breaks_judge(graze_envelope *e, graze_context *context, size_t piece) {
    HELD(algebraic, start);
    TRY(judge_find(e, context, GRAZE_REASON_PIECES, &NO_CELL, &NO_CELL, piece, &start));
    for (int turn = 1; turn >= -1 && judge_wants(e, GRAZE_REASON_BREAK); turn -= 2) {
        meeting_pieces m = {e, turn > 0 ? piece - 1 : piece, turn > 0 ? piece : piece - 1, turn};
        TRY(judge_turn(&m, context, &start, piece));
    }
    return GRAZE_OK;
}
