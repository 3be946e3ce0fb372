/* Edges: sides of simplices that bound facets, cut at vertices that lie in them and where two of
 * them cross.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "base/number/vector.h"
#include "questions/envelope/patch_ends.h"

/* A side of a simplex from vertex u to vertex v, u < v. */
typedef struct side {
    size_t u, v, simplex;
    int k;
} side;

/* A vertex in a side, `lambda` of the way from u to v. */
typedef struct inner_vertex {
    fmpq lambda;
    size_t vertex;
} inner_vertex;

typedef struct edge_finder {
    cell_complex *c;
    graze_context *context;
    size_t side_count;
    side *side;          /* sorted by ends; in E^2 the simplices */
    unsigned char *keep; /* of each simplex: bit k is 1 if its side k bounds a facet */
    size_t edge_capacity, inner_count, inner_capacity, corner_positions;
    inner_vertex *inner; /* vertices within the side that is being cut */
} edge_finder;

static int compare_sides(const void *left, const void *right) {
    const side *a = left, *b = right;
    int order = array_compare_numbers(&a->u, &b->u);
    order = order ? order : array_compare_numbers(&a->v, &b->v);
    return order ? order : array_compare_numbers(&a->simplex, &b->simplex);
}

static void list_edge_sides(edge_finder *f) {
    const cell_complex *c = f->c;
    size_t d = (size_t)c->dimension, sides = d == 3 ? 3 : 1;
    for (size_t s = 0; s < c->solid->cut.count; s++)
        for (size_t k = 0; k < sides; k++) {
            size_t a = c->corner[s * d + k], b = c->corner[s * d + (k + 1) % d];
            f->side[f->side_count++] = (side){a < b ? a : b, a < b ? b : a, s, (int)k};
        }
    qsort(f->side, f->side_count, sizeof *f->side, compare_sides);
}

/* Do entries first to end - 1, the sides between two vertices, belong to two simplices of one
 * facet? Then they are no edge of the boundary.
 */
static int is_diagonal(const edge_finder *f, size_t first, size_t end) {
    return f->c->dimension == 3 && end - first == 2 &&
           f->c->facet_of[f->side[first].simplex] == f->c->facet_of[f->side[first + 1].simplex];
}

/* Keep one entry for each edge; drop the sides within a facet. */
static void keep_edges(edge_finder *f) {
    size_t kept = 0;
    for (size_t first = 0, end; first < f->side_count; first = end) {
        for (end = first; end < f->side_count && f->side[end].u == f->side[first].u &&
                          f->side[end].v == f->side[first].v;)
            end++;
        if (is_diagonal(f, first, end))
            continue;
        for (size_t k = first; k < end; k++)
            f->keep[f->side[k].simplex] |= (unsigned char)(1u << f->side[k].k);
        f->side[kept++] = f->side[first];
    }
    f->side_count = kept;
}

static const fmpq *at_vertex(const cell_complex *c, size_t v) {
    return c->at + v * (size_t)c->dimension;
}

static graze_status add_inner(edge_finder *f, const fmpq_t lambda, size_t vertex) {
    for (size_t k = 0; k < f->inner_count; k++)
        if (f->inner[k].vertex == vertex)
            return GRAZE_OK;
    TRY(ARRAY_GROW(f->context, f->inner, f->inner_capacity, f->inner_count + 1,
                   "the vertices in an edge"));
    fmpq_init(&f->inner[f->inner_count].lambda);
    fmpq_set(&f->inner[f->inner_count].lambda, lambda);
    f->inner[f->inner_count++].vertex = vertex;
    return GRAZE_OK;
}

/* Is 0 < x < 1? */
static int is_within(const fmpq_t x) {
    return fmpq_sgn(x) > 0 && fmpz_cmp(fmpq_numref(x), fmpq_denref(x)) < 0;
}

/* Add a vertex to `inner` if it lies within the side. */
static graze_status try_inner_vertex(edge_finder *f, const side *e, size_t vertex) {
    int d = f->c->dimension;
    if (vertex == e->u || vertex == e->v)
        return GRAZE_OK;
    LOCAL_VEC(fmpq, along, 9);
    fmpq *to = along + 3, *cross = along + 6;
    vector_sub(along, at_vertex(f->c, e->v), at_vertex(f->c, e->u), d);
    vector_sub(to, at_vertex(f->c, vertex), at_vertex(f->c, e->u), d);
    vector_cross(cross, along, to);
    if (vector_is_zero(cross, 3)) {
        LOCAL_VEC(fmpq, lambda, 2);
        fmpq *length = lambda + 1;
        _fmpq_vec_dot(lambda, to, along, 3);
        _fmpq_vec_dot(length, along, along, 3);
        fmpq_div(lambda, lambda, length);
        if (is_within(lambda))
            TRY(add_inner(f, lambda, vertex));
    }
    return GRAZE_OK;
}

/* The index of the corner at a point; `corner_positions`, the index of the first crossing, if no
 * corner is there. */
static size_t corner_at_point(const edge_finder *f, const fmpq *point) {
    size_t low = 0, high = f->corner_positions;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (vector_compare(at_vertex(f->c, middle), point, f->c->dimension) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    int found = low < f->corner_positions &&
                vector_compare(at_vertex(f->c, low), point, f->c->dimension) == 0;
    return found ? low : f->corner_positions;
}

/* The number of a crossing: the number of the vertex at that point, or a new one. */
static graze_status number_crossing(size_t *out, edge_finder *f, const fmpq *point) {
    cell_complex *c = f->c;
    int d = c->dimension;
    for (*out = corner_at_point(f, point); *out < c->vertex_count; ++*out)
        if (*out < f->corner_positions || vector_compare(point, at_vertex(c, *out), d) == 0)
            return GRAZE_OK;
    size_t before = c->vertex_capacity;
    TRY(array_grow(f->context, &c->at, &c->vertex_capacity, c->vertex_count + 1,
                   (size_t)d * sizeof *c->at, "the crossings of edges"));
    for (size_t k = before * (size_t)d; k < c->vertex_capacity * (size_t)d; k++)
        fmpq_init(c->at + k);
    vector_set(c->at + c->vertex_count++ * (size_t)d, point, d);
    return GRAZE_OK;
}

/* Find the point in which two segments cross, *lambda of the way along the first; 0 if their lines
 * do not meet in one point, or if that point is not inside both segments. `v`: room for 12 numbers.
 */
static int meet_within(fmpq_t lambda, fmpq *v, const cell_complex *c, const side *e, size_t p,
                       size_t q) {
    int d = c->dimension, found = 0;
    fmpq *along = v, *other = v + 3, *to = v + 6, *normal = v + 9;
    LOCAL_VEC(fmpq, mu, 2);
    fmpq *length = mu + 1;
    vector_sub(along, at_vertex(c, e->v), at_vertex(c, e->u), d);
    vector_sub(other, at_vertex(c, q), at_vertex(c, p), d);
    vector_sub(to, at_vertex(c, p), at_vertex(c, e->u), d);
    vector_cross(normal, along, other);
    _fmpq_vec_dot(mu, to, normal, 3);
    if (!vector_is_zero(normal, 3) && fmpq_is_zero(mu)) {
        _fmpq_vec_dot(length, normal, normal, 3);
        LOCAL_VEC(fmpq, side_of, 3);
        vector_cross(side_of, to, other);
        _fmpq_vec_dot(lambda, side_of, normal, 3);
        fmpq_div(lambda, lambda, length);
        vector_cross(side_of, to, along);
        _fmpq_vec_dot(mu, side_of, normal, 3);
        fmpq_div(mu, mu, length);
        found = is_within(lambda) && is_within(mu);
    }
    return found;
}

/* Add to `inner` the point in which the edge from p to q crosses the side, if there is one. */
static graze_status try_crossing(edge_finder *f, const side *e, size_t p, size_t q) {
    int d = f->c->dimension;
    if (p == e->u || p == e->v || q == e->u || q == e->v)
        return GRAZE_OK;
    LOCAL_VEC(fmpq, v, 12);
    LOCAL(fmpq, lambda);
    if (meet_within(lambda, v, f->c, e, p, q)) {
        size_t vertex;
        vector_between(v, at_vertex(f->c, e->u), at_vertex(f->c, e->v), lambda, d);
        TRY(number_crossing(&vertex, f, v));
        TRY(add_inner(f, lambda, vertex));
    }
    return GRAZE_OK;
}

static graze_status try_touching(edge_finder *f, const side *e, size_t simplex) {
    const cell_complex *c = f->c;
    size_t d = (size_t)c->dimension;
    for (size_t k = 0; k < d; k++)
        TRY(try_inner_vertex(f, e, c->corner[simplex * d + k]));
    for (size_t k = 0; k < d && d == 3; k++)
        if (f->keep[simplex] >> k & 1)
            TRY(try_crossing(f, e, c->corner[simplex * d + k],
                             c->corner[simplex * d + (k + 1) % d]));
    return GRAZE_OK;
}

static graze_status search_touching(edge_finder *f, const side *e, const box *around,
                                    size_t index) {
    const tree_node *node = &f->c->solid->boxes.node[index];
    if (!box_meets(&node->box, around))
        return GRAZE_OK;
    if (!node->child)
        return try_touching(f, e, node->simplex);
    TRY(search_touching(f, e, around, node->child));
    return search_touching(f, e, around, node->child + 1);
}

static void box_of(box *out, const cell_complex *c, const side *e) {
    *out = (box){{0}, {0}};
    for (int i = 0; i < c->dimension; i++) {
        double low, high;
        rational_bounds(&out->low[i], &out->high[i], at_vertex(c, e->u) + i);
        rational_bounds(&low, &high, at_vertex(c, e->v) + i);
        out->low[i] = low < out->low[i] ? low : out->low[i];
        out->high[i] = high > out->high[i] ? high : out->high[i];
    }
}

static int compare_inner(const void *left, const void *right) {
    const inner_vertex *a = left, *b = right;
    return fmpq_cmp(&a->lambda, &b->lambda);
}

static graze_status append_edge(edge_finder *f, size_t a, size_t b) {
    cell_complex *c = f->c;
    TRY(ARRAY_GROW(f->context, c->edge, f->edge_capacity, c->edge_count + 1,
                   "the edges of a boundary"));
    c->edge[c->edge_count++] = (cell_edge){.u = a < b ? a : b, .v = a < b ? b : a};
    return GRAZE_OK;
}

static graze_status cut_side(edge_finder *f, const side *e) {
    box around;
    f->inner_count = 0;
    box_of(&around, f->c, e);
    graze_status status = search_touching(f, e, &around, 0);
    if (f->inner_count)
        qsort(f->inner, f->inner_count, sizeof *f->inner, compare_inner);
    size_t from = e->u;
    for (size_t k = 0; k < f->inner_count; k++) {
        if (!status)
            status = append_edge(f, from, f->inner[k].vertex);
        from = f->inner[k].vertex;
        fmpq_clear(&f->inner[k].lambda);
    }
    return status ? status : append_edge(f, from, e->v);
}

static int order_of_edges(const void *left, const void *right) {
    const cell_edge *a = left, *b = right;
    int order = array_compare_numbers(&a->u, &b->u);
    return order ? order : array_compare_numbers(&a->v, &b->v);
}

static void edge_finder_clear(edge_finder *f) {
    free(f->side);
    free(f->keep);
    free(f->inner);
}

graze_status edges_find(cell_complex *c, graze_context *context) {
    size_t n = c->solid->cut.count;
    ZEROED(edge_finder, f);
    f.c = c;
    f.context = context;
    f.corner_positions = c->vertex_count;
    TRY(MAKE_ARRAY(context, f.side, n * 3, "edges"));
    TRY(MAKE_ARRAY(context, f.keep, n, "edges"));
    list_edge_sides(&f);
    keep_edges(&f);
    for (size_t k = 0; k < f.side_count; k++) {
        TRY(cut_side(&f, &f.side[k]));
        TRY(context_work(context, 10000));
    }
    /* Parts of different sides may be one edge. */
    c->edge_count = array_sort_once(c->edge, c->edge_count, sizeof *c->edge, order_of_edges);
    return GRAZE_OK;
}
