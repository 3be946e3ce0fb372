/* Events and findings at vertices where the solid is neither flat nor convex.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "questions/envelope/patch_ends.h"
#include "questions/topo/topo.h"

static size_t other_end(const cell_edge *edge, size_t vertex) {
    return edge->u == vertex ? edge->v : edge->u;
}

/* The direction of an edge from a vertex: 3 integers. */
static void ray_of(fmpz *out, const cell_complex *c, size_t edge, size_t vertex) {
    const fmpz *from = c->vertex[vertex].x, *to = c->vertex[other_end(&c->edge[edge], vertex)].x;
    for (int i = 0; i < 3; i++) {
        fmpz_mul(out + i, to + i, from + 3);
        fmpz_submul(out + i, from + i, to + 3);
    }
}

/* Set the normal of the plane of two edges at a vertex: their cross product, the edge with the
 * lower name first. Returns 0 if they are parallel, or span the plane of a facet at the vertex. */
static int span_plane(fmpz *normal, const cell_complex *c, size_t vertex, size_t first,
                      size_t second) {
    LOCAL_VEC(fmpz, ray, 6);
    int swap = cell_compare(&c->edge[first].name, &c->edge[second].name) > 0;
    ray_of(ray, c, swap ? second : first, vertex);
    ray_of(ray + 3, c, swap ? first : second, vertex);
    integers_cross(normal, ray, ray + 3);
    int found = !_fmpz_vec_is_zero(normal, 3);
    cell_span facets = cells_of(&c->vertex_facets, vertex);
    for (size_t j = 0; j < facets.count; j++)
        found = found && !directions_parallel(normal, c->facet[facets.item[j]].normal);
    return found;
}

static int only_sign(const signed char *sign) {
    return sign[0];
}

static graze_status gather_pair(graze_envelope *e, graze_context *context, size_t vertex,
                                const fmpz *normal) {
    found_event what = {.kind = GRAZE_EVENT_SADDLE, .cell = e->cells.vertex[vertex].name};
    watch past = {SIGN_NONE, SIGN_NONE};
    for (size_t piece = 0; piece < e->piece_count; piece++) {
        HELD(signs, s, 1, 1);
        for (int i = 0; i < 3; i++)
            fmpz_poly_scalar_addmul_fmpz(&s.p[0], derivatives_at(&e->field[piece], 1, vertex) + i,
                                         normal + i);
        TRY(signs_find(&s, context));
        TRY(events_watch(&e->events, context, &what, &past, piece, &s, only_sign));
    }
    return GRAZE_OK;
}

graze_status saddle_gather(graze_envelope *e, graze_context *context, size_t vertex) {
    const cell_complex *c = &e->cells;
    cell_span edges = cells_of(&c->vertex_edges, vertex);
    if (c->dimension == 2)
        return GRAZE_OK;
    LOCAL_VEC(fmpz, normal, 3);
    for (size_t i = 0; i < edges.count; i++)
        for (size_t j = i + 1; j < edges.count; j++)
            if (span_plane(normal, c, vertex, edges.item[i], edges.item[j]))
                TRY(gather_pair(e, context, vertex, normal));
    return GRAZE_OK;
}

/* A vertex, with its facets and edges, on one piece. `s` has the signs of g of the vertex's facets
 * at the vertex, then, edge by edge, the signs of g of the edge's facets at the edge's other end.
 */
typedef struct corner_view {
    graze_envelope *e;
    graze_context *context;
    size_t vertex, piece;
    cell_span facets, edges;
    signs s;
} corner_view;

/* The facets of edge j of the vertex. */
static cell_span facets_along(const corner_view *v, size_t j) {
    return cells_of(&v->e->cells.edge_facets, v->edges.item[j]);
}

static void corner_view_init(corner_view *v, graze_envelope *e, graze_context *context,
                             size_t vertex, size_t piece) {
    const cell_complex *c = &e->cells;
    const derivatives *f = &e->field[piece];
    *v = (corner_view){.e = e, .context = context, .vertex = vertex, .piece = piece};
    v->facets = cells_of(&c->vertex_facets, vertex);
    v->edges = cells_of(&c->vertex_edges, vertex);
    size_t total = v->facets.count, at = total;
    for (size_t j = 0; j < v->edges.count; j++)
        total += facets_along(v, j).count;
    signs_init(&v->s, total, total);
    for (size_t j = 0; j < v->facets.count; j++)
        derivatives_velocity(&v->s.p[j], f, v->facets.item[j], vertex);
    for (size_t j = 0; j < v->edges.count; j++)
        for (size_t k = 0; k < facets_along(v, j).count; k++)
            derivatives_velocity(&v->s.p[at++], f, facets_along(v, j).item[k],
                                 other_end(&c->edge[v->edges.item[j]], vertex));
}

static void corner_view_clear(corner_view *v) {
    signs_clear(&v->s);
}

/* The signs at point k of the axis or, if `before`, between points k - 1 and k. */
static const signed char *signs_of(const corner_view *v, size_t k, int before) {
    return before ? signs_before(&v->s, k) : signs_at(&v->s, k);
}

/* The position of a facet among those of the vertex. */
static size_t facet_place(const corner_view *v, size_t facet) {
    size_t j = 0;
    while (v->facets.item[j] != facet)
        j++;
    return j;
}

/* Does a run on a convex edge reach the vertex, by the signs at one point of the axis or between
 * two? */
static int run_reaches(const corner_view *v, const signed char *sign) {
    const signed char *far = sign + v->facets.count;
    for (size_t j = 0; j < v->edges.count; j++) {
        int low = 1, high = -1;
        for (size_t k = 0; k < facets_along(v, j).count; k++, far++) {
            int here = sign[facet_place(v, facets_along(v, j).item[k])];
            here = here ? here : *far;
            low = here < low ? here : low;
            high = here > high ? here : high;
        }
        if (v->e->cells.edge[v->edges.item[j]].kind == PLACE_CONVEX && low <= 0 && high >= 0)
            return 1;
    }
    return 0;
}

/* At point `at` of the axis g of the facet is 0 at the vertex. Does the facet's slice end on an
 * edge at the vertex just before or after this point, so that this end comes to the vertex? Edges
 * along which g is 0 at the point do not count (proofs/events.md C82). `own` is the position of the
 * sign of the facet's g at the vertex. */
static int slice_comes(const corner_view *v, size_t facet, size_t own, size_t at) {
    size_t position = v->facets.count;
    int comes = 0;
    for (size_t j = 0; j < v->edges.count; j++)
        for (size_t k = 0; k < facets_along(v, j).count; k++, position++) {
            if (facets_along(v, j).item[k] != facet || signs_at(&v->s, at)[position] == 0)
                continue;
            for (size_t m = at ? at : 1; m <= at + 1 && m < v->s.x.count; m++)
                comes |= signs_before(&v->s, m)[own] * signs_before(&v->s, m)[position] < 0;
        }
    return comes;
}

/* Does the slice of a facet (graze/envelope.h) reach the vertex at point k of the time axis or, if
 * `before`, between the points k - 1 and k? */
static graze_status slice_reaches(int *out, const corner_view *v, size_t k, int before) {
    *out = 0;
    for (size_t j = 0; j < v->facets.count && !*out; j++) {
        size_t facet = v->facets.item[j];
        if (signs_of(v, k, before)[j] != 0)
            continue;
        *out = before ? enters_before(v->e, facet, v->vertex, v->piece, &v->s.x, k)
                      : slice_comes(v, facet, j, k);
        if (!*out && !before)
            TRY(enters_at(out, v->e, v->context, facet, v->vertex, v->piece, &v->s.x, k));
    }
    return GRAZE_OK;
}

/* Does the vertex's velocity or its opposite lead into the solid, at point k or, if `before`,
 * between points k - 1 and k? At a reflex vertex one of them does unless g of all facets is 0. */
static graze_status leads_in(int *out, const corner_view *v, size_t k, int before) {
    const signed char *sign = signs_of(v, k, before);
    *out = 0;
    for (size_t j = 0; j < v->facets.count; j++)
        *out |= sign[j] != 0;
    if (v->e->cells.vertex[v->vertex].kind == PLACE_REFLEX || !*out)
        return GRAZE_OK;
    HELD(algebraic, u);
    if (before)
        algebraic_set_rational(&u, v->s.x.sample + k);
    else
        algebraic_set(&u, v->s.x.point[k]);
    return inward_decide(out, v->e, v->context, v->vertex, v->piece, &u, sign);
}

static graze_status judge_place(corner_view *v, size_t k, int before) {
    graze_envelope *e = v->e;
    const graze_cell *name = &e->cells.vertex[v->vertex].name;
    int run = run_reaches(v, signs_of(v, k, before));
    int reaches = run, leads = 0;
    if (run)
        TRY(judge_find(e, v->context, GRAZE_REASON_REACHES, &NO_CELL, name, v->piece,
                       v->s.x.point[k]));
    else
        TRY(slice_reaches(&reaches, v, k, before));
    if (!reaches || !judge_wants(e, GRAZE_REASON_VERTEX) ||
        (!before && !judge_is_inner(e, v->piece, &v->s.x, k)))
        return GRAZE_OK;
    TRY(leads_in(&leads, v, k, before));
    if (!leads)
        return GRAZE_OK;
    return before ? judge_find_before(e, v->context, GRAZE_REASON_VERTEX, &NO_CELL, name, v->piece,
                                      &v->s.x, k)
                  : judge_find(e, v->context, GRAZE_REASON_VERTEX, &NO_CELL, name, v->piece,
                               v->s.x.point[k]);
}

graze_status saddle_judge(graze_envelope *e, graze_context *context, size_t vertex) {
    for (size_t piece = 0; piece < e->piece_count; piece++) {
        HELD(corner_view, v, e, context, vertex, piece);
        TRY(signs_find(&v.s, context));
        for (size_t k = 0; k < v.s.x.count; k++) {
            if (k > 0)
                TRY(judge_place(&v, k, 1));
            TRY(judge_place(&v, k, 0));
        }
    }
    return GRAZE_OK;
}
