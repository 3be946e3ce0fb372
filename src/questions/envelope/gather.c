/* Events and findings at vertices and edges of facets. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * On an edge u v of a facet, g and theta are linear. So if g_u g_v < 0 the slice ends on the edge
 * at (g_u v - g_v u) / (g_u - g_v), and at this point a function f that is linear along the edge
 * has the sign of (g_u f_v - g_v f_u) sgn g_u (proofs/events.md C78).
 */
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

enum { CORNER_G, CORNER_THETA };

static int no_sign(const signed char *sign) {
    (void)sign;
    return SIGN_NONE;
}

static int corner_g(const signed char *sign) {
    return sign[CORNER_G];
}

/* The sign of theta at the vertex, watched where g is 0 there all along the piece. */
static int corner_theta(const signed char *sign) {
    return sign[CORNER_THETA];
}

/* Note findings at a vertex of the facet: theta is not positive there while g = 0; or the slice
 * reaches the vertex and the solid is neither flat nor convex there. */
static graze_status judge_corner(graze_envelope *e, graze_context *context, size_t facet,
                                 size_t vertex, size_t piece, const signs *s) {
    const cell_vertex *v = &e->cells.vertex[vertex];
    const graze_cell *name = &e->cells.facet[facet].name;
    int free_of_theta = judge_is_still(e, facet),
        is_sharp = v->kind == PLACE_REFLEX || v->kind == PLACE_OTHER;
    for (size_t k = 0; k < s->x.count; k++) {
        const signed char *at = signs_at(s, k), *before = signs_before(s, k);
        int touches = at[CORNER_G] == 0, stays = k > 0 && before[CORNER_G] == 0;
        int positive = (!touches || at[CORNER_THETA] > 0) && (!stays || before[CORNER_THETA] > 0);
        if (!positive && !free_of_theta)
            TRY(judge_find(e, context, GRAZE_REASON_ZERO, name, &v->name, piece, s->x.point[k]));
        if (touches && is_sharp)
            TRY(judge_find(e, context, GRAZE_REASON_REACHES, name, &v->name, piece, s->x.point[k]));
        if (stays && before[CORNER_THETA] < 0 && judge_wants(e, GRAZE_REASON_THETA) &&
            enters_before(e, facet, vertex, piece, &s->x, k))
            TRY(judge_find_before(e, context, GRAZE_REASON_THETA, name, &v->name, piece, &s->x, k));
    }
    return GRAZE_OK;
}

graze_status gather_corner(graze_envelope *e, graze_context *context, size_t facet, size_t vertex) {
    found_event what = {.facet = e->cells.facet[facet].name, .cell = e->cells.vertex[vertex].name};
    watch g = {SIGN_NONE, SIGN_NONE}, theta = g;
    for (size_t piece = 0; piece < e->piece_count; piece++) {
        HELD(signs, s, 2, 1);
        derivatives_velocity(&s.p[CORNER_G], &e->field[piece], facet, vertex);
        derivatives_along(&s.p[CORNER_THETA], &e->field[piece], 2, facet, vertex);
        int stays = fmpz_poly_is_zero(&s.p[CORNER_G]);
        s.rooted = stays ? 2 : 1;
        TRY(signs_find(&s, context));
        what.kind = GRAZE_EVENT_REACH;
        TRY(events_watch(&e->events, context, &what, &g, piece, &s, corner_g));
        what.kind = GRAZE_EVENT_CUSP;
        TRY(events_watch(&e->events, context, &what, &theta, piece, &s,
                         stays ? corner_theta : no_sign));
        TRY(judge_corner(e, context, facet, vertex, piece, &s));
    }
    return GRAZE_OK;
}

enum { SLICE_U, SLICE_V, SLICE_THETA, SLICE_TURN, SLICE_SIGNS };

static int slice_ends(const signed char *sign) {
    return sign[SLICE_U] * sign[SLICE_V] < 0;
}

static int slice_theta(const signed char *sign) {
    return slice_ends(sign) ? sign[SLICE_THETA] * sign[SLICE_U] : SIGN_NONE;
}

static int slice_turn(const signed char *sign) {
    return slice_ends(sign) ? sign[SLICE_TURN] * sign[SLICE_U] : SIGN_NONE;
}

/* Note findings at an edge: theta is not positive where the slice ends on it; or the slice reaches
 * the edge and the solid is neither flat nor convex there. */
static graze_status judge_slice(graze_envelope *e, graze_context *context, size_t facet,
                                size_t edge, size_t piece, const signs *s) {
    const cell_edge *side = &e->cells.edge[edge];
    const graze_cell *name = &e->cells.facet[facet].name;
    int is_sharp = side->kind == PLACE_REFLEX || side->kind == PLACE_OTHER;
    for (size_t k = 0; k < s->x.count; k++) {
        const signed char *at = signs_at(s, k), *before = signs_before(s, k);
        int theta = slice_theta(at), next = k > 0 ? slice_theta(before) : SIGN_NONE;
        if (next < 0 || (next == 0 && theta > 0))
            TRY(judge_find_before(e, context, next < 0 ? GRAZE_REASON_THETA : GRAZE_REASON_ZERO,
                                  name, &side->name, piece, &s->x, k));
        else if (theta <= 0)
            TRY(judge_find(e, context, GRAZE_REASON_ZERO, name, &side->name, piece, s->x.point[k]));
        if (is_sharp && at[SLICE_U] * at[SLICE_V] <= 0)
            TRY(judge_find(e, context, GRAZE_REASON_REACHES, name, &side->name, piece,
                           s->x.point[k]));
    }
    return GRAZE_OK;
}

/* Have both functions the same strict sign at all times of the piece, by a cheap test? Then the
 * slice never ends between the two vertices, and both become 0. */
static int drop_if_apart(fmpz_poly_struct *a, fmpz_poly_struct *b) {
    int sign = axis_one_sign(a);
    if (!sign || axis_one_sign(b) != sign)
        return 0;
    fmpz_poly_zero(a);
    fmpz_poly_zero(b);
    return 1;
}

/* Set the polynomials of a slice on a piece. Returns 0 and leaves zeros if a cheap test shows that
 * the slice never ends on the edge. */
static int set_slice(signs *s, const derivatives *f, size_t facet, const cell_edge *edge) {
    derivatives_velocity(&s->p[SLICE_U], f, facet, edge->u);
    derivatives_velocity(&s->p[SLICE_V], f, facet, edge->v);
    if (drop_if_apart(&s->p[SLICE_U], &s->p[SLICE_V]))
        return 0;
    LOCAL(fmpz_poly, at_u);
    LOCAL(fmpz_poly, at_v);
    derivatives_along(at_u, f, 2, facet, edge->u);
    derivatives_along(at_v, f, 2, facet, edge->v);
    cross_terms(&s->p[SLICE_THETA], &s->p[SLICE_U], &s->p[SLICE_V], at_u, at_v);
    fmpz_poly_derivative(at_u, &s->p[SLICE_U]);
    fmpz_poly_derivative(at_v, &s->p[SLICE_V]);
    cross_terms(&s->p[SLICE_TURN], &s->p[SLICE_U], &s->p[SLICE_V], at_u, at_v);
    return 1;
}

graze_status gather_slice(graze_envelope *e, graze_context *context, size_t facet, size_t edge) {
    found_event what = {.facet = e->cells.facet[facet].name, .cell = e->cells.edge[edge].name};
    watch theta = {SIGN_NONE, SIGN_NONE}, turn = theta;
    for (size_t piece = 0; piece < e->piece_count; piece++) {
        HELD(signs, s, SLICE_SIGNS, SLICE_SIGNS);
        int ends = set_slice(&s, &e->field[piece], facet, &e->cells.edge[edge]);
        TRY(signs_find(&s, context));
        what.kind = GRAZE_EVENT_CUSP;
        TRY(events_watch(&e->events, context, &what, &theta, piece, &s, slice_theta));
        what.kind = GRAZE_EVENT_TURN;
        TRY(events_watch(&e->events, context, &what, &turn, piece, &s, slice_turn));
        if (ends)
            TRY(judge_slice(e, context, facet, edge, piece, &s));
    }
    return GRAZE_OK;
}

enum { MEET_1U, MEET_1V, MEET_2U, MEET_2V, MEET_R, MEET_SIGNS };

/* The sign of the second facet's g where the slice of the first ends on the edge; SIGN_NONE unless
 * both slices end on it. */
static int meet_sign(const signed char *sign) {
    return sign[MEET_1U] * sign[MEET_1V] < 0 && sign[MEET_2U] * sign[MEET_2V] < 0
               ? sign[MEET_R] * sign[MEET_1U]
               : SIGN_NONE;
}

/* Does the slice of one facet meet the edge at a point where g of the other facet is not 0? A facet
 * is `still` if g is 0 on all of it. */
static int crosses_edge(const signed char *sign, int first_still, int second_still) {
    int any_first = sign[MEET_1U] || sign[MEET_1V], any_second = sign[MEET_2U] || sign[MEET_2V];
    int ends = sign[MEET_1U] * sign[MEET_1V] < 0 || sign[MEET_2U] * sign[MEET_2V] < 0;
    return (ends && sign[MEET_R] != 0) || (first_still && any_second) ||
           (second_still && any_first);
}

/* Set the polynomials of two facets at an edge; all are 0 if the edge is not reflex and a cheap
 * test shows that one of the slices never ends on it. */
static void set_meet(signs *s, const derivatives *f, const cell_edge *side, size_t first,
                     size_t second) {
    derivatives_velocity(&s->p[MEET_1U], f, first, side->u);
    derivatives_velocity(&s->p[MEET_1V], f, first, side->v);
    derivatives_velocity(&s->p[MEET_2U], f, second, side->u);
    derivatives_velocity(&s->p[MEET_2V], f, second, side->v);
    if (side->kind != PLACE_REFLEX && (drop_if_apart(&s->p[MEET_1U], &s->p[MEET_1V]) ||
                                       drop_if_apart(&s->p[MEET_2U], &s->p[MEET_2V])))
        for (int k = 0; k < MEET_R; k++)
            fmpz_poly_zero(&s->p[k]);
    cross_terms(&s->p[MEET_R], &s->p[MEET_1U], &s->p[MEET_1V], &s->p[MEET_2U], &s->p[MEET_2V]);
}

graze_status gather_meet(graze_envelope *e, graze_context *context, size_t edge, size_t first,
                         size_t second) {
    const cell_edge *side = &e->cells.edge[edge];
    found_event what = {.kind = GRAZE_EVENT_MEET,
                        .facet = e->cells.facet[second].name,
                        .other = e->cells.facet[first].name,
                        .cell = side->name};
    watch past = {SIGN_NONE, SIGN_NONE};
    for (size_t piece = 0; piece < e->piece_count; piece++) {
        const unsigned char *still = e->still + piece * e->cells.facet_count;
        HELD(signs, s, MEET_SIGNS, MEET_SIGNS);
        set_meet(&s, &e->field[piece], side, first, second);
        TRY(signs_find(&s, context));
        TRY(events_watch(&e->events, context, &what, &past, piece, &s, meet_sign));
        for (size_t k = 1; k < s.x.count && side->kind == PLACE_REFLEX; k++)
            if (crosses_edge(signs_before(&s, k), still[first], still[second]))
                TRY(judge_find_before(e, context, GRAZE_REASON_REFLEX, &e->cells.facet[first].name,
                                      &side->name, piece, &s.x, k));
    }
    return GRAZE_OK;
}
