/* Parts of the curve of contact. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A slice is cut where it meets vertices and edges; a segment between two such points is within the
 * facet if its middle is. Along an edge, contact changes only at zeros of g (proofs/events.md C79).
 */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "questions/envelope/patch_ends.h"

/* A point in which a slice or run may end. */
typedef struct slice_point {
    fmpq at[3];
    part_end end;
} slice_point;

/* Add a part between the points a and b, which are copied. */
static graze_status add_curve_part(graze_curve *c, graze_context *context, graze_curve_kind kind,
                                   const graze_cell *cell, size_t number, const slice_point *a,
                                   const slice_point *b) {
    TRY(ARRAY_GROW(context, c->part, c->capacity, c->count + 1, "the parts of a curve"));
    curve_part *made = &c->part[c->count++];
    made->facts = (graze_curve_part){
        .kind = kind, .cell = *cell, .theta_a = GRAZE_SIGN_ABSENT, .theta_b = GRAZE_SIGN_ABSENT};
    made->number = number;
    made->end[0] = a->end;
    made->end[1] = b->end;
    made->a = _fmpq_vec_init(c->dimension);
    made->b = _fmpq_vec_init(c->dimension);
    vector_set(made->a, a->at, c->dimension);
    vector_set(made->b, b->at, c->dimension);
    return GRAZE_OK;
}

static const fmpq *vertex_at(const snapshot *s, size_t vertex) {
    return s->e->cells.at + vertex * (size_t)s->dimension;
}

typedef struct slice_points {
    size_t count, capacity;
    slice_point *item;
} slice_points;

static part_end end_at(size_t vertex) {
    return (part_end){vertex, SIZE_MAX, SIZE_MAX};
}

static graze_status add_point(slice_points *list, graze_context *context, const fmpq *at,
                              part_end end, int d) {
    for (size_t k = 0; k < list->count; k++)
        if (end.vertex != SIZE_MAX && list->item[k].end.vertex == end.vertex)
            return GRAZE_OK;
    TRY(LIST_GROW(context, list, "the points of a slice"));
    slice_point *made = &list->item[list->count++];
    made->end = end;
    for (int i = 0; i < 3; i++)
        fmpq_init(made->at + i);
    vector_set(made->at, at, d);
    return GRAZE_OK;
}

static void slice_points_clear(slice_points *list) {
    for (size_t k = 0; k < list->count; k++)
        for (int i = 0; i < 3; i++)
            fmpq_clear(list->item[k].at + i);
    free(list->item);
}

/* Add the zero within an edge of g of a facet, if there is one. */
static graze_status add_zero_within(slice_points *list, graze_context *context, const snapshot *s,
                                    size_t edge, size_t facet) {
    const cell_edge *e = &s->e->cells.edge[edge];
    int d = s->dimension;
    LOCAL_VEC(fmpq, zero, d + 2);
    fmpq *g = zero + d;
    snapshot_g(g, s, facet, vertex_at(s, e->u));
    snapshot_g(g + 1, s, facet, vertex_at(s, e->v));
    if (fmpq_sgn(g) * fmpq_sgn(g + 1) >= 0)
        return GRAZE_OK;
    vector_zero(zero, vertex_at(s, e->u), vertex_at(s, e->v), g, g + 1, d);
    return add_point(list, context, zero, (part_end){SIZE_MAX, edge, facet}, d);
}

/* Add a vertex if g of the facet is 0 there, else set *off. */
static graze_status add_zero_at(slice_points *list, int *off, graze_context *context,
                                const snapshot *s, size_t facet, size_t vertex) {
    const fmpq *at = vertex_at(s, vertex);
    if (snapshot_g_sign(s, facet, at) == 0)
        return add_point(list, context, at, end_at(vertex), s->dimension);
    *off = 1;
    return GRAZE_OK;
}

/* Add the points in which the slice meets the facet's edges and its lone vertices. *off becomes 1
 * unless g is 0 at all ends of the edges. */
static graze_status meet_edges(slice_points *list, int *off, graze_context *context,
                               const snapshot *s, size_t facet) {
    const cell_complex *c = &s->e->cells;
    cell_span edges = cells_of(&c->facet_edges, facet), lone = cells_of(&c->lone_vertices, facet);
    int unused = 0;
    for (size_t j = 0; j < edges.count; j++) {
        TRY(add_zero_at(list, off, context, s, facet, c->edge[edges.item[j]].u));
        TRY(add_zero_at(list, off, context, s, facet, c->edge[edges.item[j]].v));
        TRY(add_zero_within(list, context, s, edges.item[j], facet));
    }
    for (size_t j = 0; j < lone.count; j++)
        TRY(add_zero_at(list, &unused, context, s, facet, lone.item[j]));
    return GRAZE_OK;
}

static int compare_slice_points(const void *left, const void *right) {
    const slice_point *a = left, *b = right;
    return vector_compare(a->at, b->at, 3);
}

/* Order of points by position, at equal positions by facet, descending. */
static int compare_edge_points(const void *left, const void *right) {
    const slice_point *a = left, *b = right;
    int order = compare_slice_points(a, b);
    return order ? order : array_compare_numbers(&b->end.facet, &a->end.facet);
}

int parts_facet_holds(const cell_complex *c, size_t facet, const fmpq *at) {
    const cell_facet *f = &c->facet[facet];
    int d = c->dimension, inside = 0;
    unsigned zero = 0;
    LOCAL_VEC(fmpz, x, 2 * (d + 1));
    fmpz *plane = x + d + 1;
    _fmpq_vec_get_fmpz_vec_fmpz(x, x + d, at, d);
    for (size_t j = 0; j < f->count && !inside; j++) {
        size_t simplex = c->order[f->first + j];
        solid_plane(plane, c->solid, simplex);
        inside = form_sign(plane, x, d) == 0 && solid_holds(&zero, c->solid, simplex, plane, x);
    }
    return inside;
}

int parts_side_is_inner(const cell_complex *c, size_t facet, size_t a, size_t b) {
    const cell_facet *f = &c->facet[facet];
    int found = 0;
    for (size_t j = 0; j < f->count; j++) {
        const size_t *corner = c->corner + c->order[f->first + j] * 3;
        int has_a = corner[0] == a || corner[1] == a || corner[2] == a;
        int has_b = corner[0] == b || corner[1] == b || corner[2] == b;
        found += has_a && has_b;
    }
    return found == 2;
}

/* Are two vertices the ends of one edge? */
static int are_joined(const cell_complex *c, size_t a, size_t b) {
    if (a == SIZE_MAX || b == SIZE_MAX)
        return 0;
    cell_span edges = cells_of(&c->vertex_edges, a);
    for (size_t j = 0; j < edges.count; j++) {
        const cell_edge *e = &c->edge[edges.item[j]];
        if (e->u == b || e->v == b)
            return 1;
    }
    return 0;
}

static graze_status add_slice(graze_curve *c, graze_context *context, const snapshot *s,
                              size_t facet, const slice_point *a, const slice_point *b) {
    TRY(add_curve_part(c, context, GRAZE_CURVE_SLICE, &s->e->cells.facet[facet].name, facet, a, b));
    c->part[c->count - 1].facts.theta_a = snapshot_theta_sign(s, facet, a->at);
    c->part[c->count - 1].facts.theta_b = snapshot_theta_sign(s, facet, b->at);
    return GRAZE_OK;
}

/* The point in the interior of the facet's first simplex with the barycentric weights 1, s, s^2. */
static void point_within(fmpq *out, const cell_complex *c, size_t facet, slong s) {
    int d = c->dimension;
    const size_t *corner = c->corner + c->order[c->facet[facet].first] * (size_t)d;
    slong weight = 1, sum = 0;
    LOCAL(fmpz, factor);
    LOCAL(fmpq, term);
    for (int i = 0; i < d; i++)
        fmpq_zero(out + i);
    for (int k = 0; k < d; k++, weight *= s) {
        sum += weight;
        fmpz_set_si(factor, weight);
        for (int i = 0; i < d; i++) {
            fmpq_mul_fmpz(term, c->at + corner[k] * (size_t)d + (size_t)i, factor);
            fmpq_add(out + i, out + i, term);
        }
    }
    fmpz_set_si(factor, sum);
    for (int i = 0; i < d; i++)
        fmpq_div_fmpz(out + i, out + i, factor);
}

/* The middle of the facet's first simplex, or, if an edge or a vertex of the boundary passes
 * through it, another point in the interior of that simplex. The points tried lie on a conic: a
 * line meets it at most twice, so finitely many vertices and edges cannot hold all of them. */
static graze_status within_facet(fmpq *out, graze_context *context, const cell_complex *cells,
                                 size_t facet) {
    for (slong s = 1;; s++) {
        ZEROED(neighborhood, at);
        point_within(out, cells, facet, s);
        TRY(neighborhood_locate(&at, context, cells->solid, out));
        if (at.cell.kind == cells->facet[facet].name.kind)
            return GRAZE_OK;
    }
}

static graze_status add_whole(graze_curve *c, graze_context *context, const snapshot *s,
                              size_t facet) {
    LOCAL_VEC(fmpq, at, 3);
    TRY(within_facet(at, context, &s->e->cells, facet));
    const slice_point within = {{at[0], at[1], at[2]}, end_at(SIZE_MAX)}; /* borrowed */
    return add_curve_part(c, context, GRAZE_CURVE_WHOLE, &s->e->cells.facet[facet].name, facet,
                          &within, &within);
}

/* Add the segments between neighbouring points of a slice that lie within the facet and not along
 * an edge. */
static graze_status add_segments(graze_curve *c, graze_context *context, const snapshot *s,
                                 size_t facet, slice_points *list) {
    const cell_complex *cells = &s->e->cells;
    LOCAL_VEC(fmpq, middle, 3);
    if (list->count)
        qsort(list->item, list->count, sizeof *list->item, compare_slice_points);
    for (size_t k = 1; k < list->count; k++) {
        const slice_point *a = &list->item[k - 1], *b = &list->item[k];
        vector_middle(middle, a->at, b->at, 3);
        if (!are_joined(cells, a->end.vertex, b->end.vertex) &&
            parts_facet_holds(cells, facet, middle))
            TRY(add_slice(c, context, s, facet, a, b));
    }
    return GRAZE_OK;
}

graze_status parts_of_facet(graze_curve *c, graze_context *context, const snapshot *s,
                            size_t facet) {
    ZEROED(slice_points, list);
    int off = 0;
    TRY(meet_edges(&list, &off, context, s, facet));
    if (!off)
        return add_whole(c, context, s, facet);
    if (s->dimension == 3)
        return add_segments(c, context, s, facet, &list);
    for (size_t k = 0; k < list.count; k++)
        if (list.item[k].end.vertex == SIZE_MAX)
            TRY(add_slice(c, context, s, facet, &list.item[k], &list.item[k]));
    return GRAZE_OK;
}

/* Is a point of the boundary a contact? The signs of g of its facets decide if the local cone is
 * flat, convex or reflex; else the site of the point decides. */
static graze_status is_contact_point(int *out, graze_context *context, const snapshot *s,
                                     place_kind kind, cell_span facets, const fmpq *at) {
    int low = 1, high = -1;
    if (kind == PLACE_OTHER) {
        graze_site site;
        TRY(site_make_for(&site, context, s->e->scene, s->t, at, SITE_ROLE));
        *out = site.facts.role == GRAZE_ROLE_CONTACT;
        site_clear(&site);
        return GRAZE_OK;
    }
    for (size_t k = 0; k < facets.count; k++) {
        int sign = snapshot_g_sign(s, facets.item[k], at);
        low = sign < low ? sign : low;
        high = sign > high ? sign : high;
    }
    *out = kind == PLACE_REFLEX ? low == 0 && high == 0 : low <= 0 && high >= 0;
    return GRAZE_OK;
}

/* List the ends of an edge and the points within it where g of some facet of the edge vanishes, in
 * order along it. */
static graze_status cut_edge(slice_points *list, graze_context *context, const snapshot *s,
                             size_t edge) {
    const cell_complex *c = &s->e->cells;
    const cell_edge *e = &c->edge[edge];
    cell_span facets = cells_of(&c->edge_facets, edge);
    TRY(add_point(list, context, vertex_at(s, e->u), end_at(e->u), s->dimension));
    for (size_t j = 0; j < facets.count; j++)
        TRY(add_zero_within(list, context, s, edge, facets.item[j]));
    TRY(add_point(list, context, vertex_at(s, e->v), end_at(e->v), s->dimension));
    qsort(list->item, list->count, sizeof *list->item, compare_edge_points);
    return GRAZE_OK;
}

/* Add the runs of an edge, where two runs become one if the point between them is a contact. Add
 * also the points within the edge that are contacts but touch no run. */
static graze_status add_runs(graze_curve *c, graze_context *context, const snapshot *s, size_t edge,
                             const slice_points *list) {
    const cell_complex *cells = &s->e->cells;
    const cell_edge *e = &cells->edge[edge];
    cell_span facets = cells_of(&cells->edge_facets, edge);
    size_t from = 0;
    int open = 0;
    LOCAL_VEC(fmpq, middle, 3);
    for (size_t k = 0; k < list->count; k++) {
        const slice_point *at = &list->item[k];
        int is_end = k == 0 || k + 1 == list->count, here = 0, next = 0;
        if (k + 1 < list->count && compare_slice_points(at, at + 1) == 0)
            continue;
        if (k + 1 < list->count) {
            vector_middle(middle, at->at, at[1].at, 3);
            TRY(is_contact_point(&next, context, s, e->kind, facets, middle));
        }
        TRY(is_contact_point(&here, context, s, e->kind, facets, at->at));
        if (open && !(next && here)) {
            TRY(add_curve_part(c, context, GRAZE_CURVE_RUN, &e->name, edge, &list->item[from], at));
            open = 0;
        } else if (!open && !next && here && !is_end) {
            TRY(add_curve_part(c, context, GRAZE_CURVE_POINT, &e->name, edge, at, at));
        }
        if (next && !open) {
            open = 1;
            from = k;
        }
    }
    return GRAZE_OK;
}

graze_status parts_of_edge(graze_curve *c, graze_context *context, const snapshot *s, size_t edge) {
    ZEROED(slice_points, list);
    TRY(cut_edge(&list, context, s, edge));
    return add_runs(c, context, s, edge, &list);
}

/* Is the point an end of a part? */
static int is_end_of_part(const graze_curve *c, const fmpq *at) {
    for (size_t k = 0; k < c->count; k++)
        if (vector_compare(c->part[k].a, at, c->dimension) == 0 ||
            vector_compare(c->part[k].b, at, c->dimension) == 0)
            return 1;
    return 0;
}

graze_status parts_add_vertex(graze_curve *c, graze_context *context, const snapshot *s,
                              size_t vertex) {
    const cell_complex *cells = &s->e->cells;
    int contact = 0;
    TRY(is_contact_point(&contact, context, s, cells->vertex[vertex].kind,
                         cells_of(&cells->vertex_facets, vertex), vertex_at(s, vertex)));
    if (!contact)
        return GRAZE_OK;
    slice_point at = {.end = end_at(vertex)};
    for (int i = 0; i < s->dimension; i++)
        at.at[i] = vertex_at(s, vertex)[i]; /* borrowed */
    return add_curve_part(c, context, GRAZE_CURVE_POINT, &cells->vertex[vertex].name, vertex, &at,
                          &at);
}

graze_status parts_of_vertex(graze_curve *c, graze_context *context, const snapshot *s,
                             size_t vertex) {
    return is_end_of_part(c, vertex_at(s, vertex)) ? GRAZE_OK
                                                   : parts_add_vertex(c, context, s, vertex);
}

graze_status parts_look_at_middle(graze_trim *trim, graze_orientation *orientation, fmpq *body,
                                  fmpq *world, graze_context *context, const graze_envelope *e,
                                  const curve_part *part, const fmpq_t t) {
    graze_site site;
    vector_middle(body, part->a, part->b, e->cells.dimension);
    TRY(site_make_for(&site, context, e->scene, t, body, SITE_TRIM));
    *trim = site.facts.trim;
    *orientation = site.facts.on_slice ? site.facts.orientation : GRAZE_ORIENTATION_NONE;
    if (world)
        vector_set(world, site.world, e->cells.dimension);
    site_clear(&site);
    return GRAZE_OK;
}
