/* Makes facets of simplices, identifies vertices by position, and finds the facets that contain an
 * edge or a vertex by locating a point of it. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "questions/envelope/patch_ends.h"

#define CELLS "the cells of a boundary"

/* A vertex of the input and its coordinates, to be sorted by position. */
typedef struct position {
    const fmpq *at;
    size_t vertex;
    int dimension;
} position;

static int compare_positions(const void *left, const void *right) {
    const position *a = left, *b = right;
    return vector_compare(a->at, b->at, a->dimension);
}

/* List the corners of all simplices, each vertex once; `seen` is zeros before. */
static size_t list_corners(position *out, const cell_complex *c, size_t *seen) {
    const simplices *cut = &c->solid->cut;
    size_t d = (size_t)c->dimension, n = 0;
    for (size_t s = 0; s < cut->count; s++)
        for (size_t k = 0; k < d; k++) {
            size_t v = cut->item[s].vertex[k];
            if (!seen[v])
                out[n++] = (position){c->solid->input.coordinates + v * d, v, c->dimension};
            seen[v] = 1;
        }
    return n;
}

/* Number the positions of the corners: number[v] becomes that of vertex v. `number` is zeros
 * before. */
static graze_status number_positions(size_t *number, cell_complex *c, graze_context *context) {
    size_t d = (size_t)c->dimension;
    FREED(position, sorted, NULL);
    TRY(MAKE_ARRAY(context, sorted, c->solid->input.vertex_count, CELLS));
    size_t n = list_corners(sorted, c, number);
    qsort(sorted, n, sizeof *sorted, compare_positions);
    c->at = _fmpq_vec_init((slong)(n * d));
    c->vertex_capacity = n;
    for (size_t k = 0; k < n; k++) {
        if (k == 0 || compare_positions(&sorted[k - 1], &sorted[k]) != 0)
            vector_set(c->at + d * c->vertex_count++, sorted[k].at, c->dimension);
        number[sorted[k].vertex] = c->vertex_count - 1;
    }
    return GRAZE_OK;
}

static graze_status find_corners(cell_complex *c, graze_context *context) {
    const simplices *cut = &c->solid->cut;
    size_t d = (size_t)c->dimension;
    FREED(size_t, number, NULL);
    TRY(MAKE_ARRAY(context, number, c->solid->input.vertex_count, CELLS));
    TRY(MAKE_ARRAY(context, c->corner, cut->count * d, CELLS));
    TRY(number_positions(number, c, context));
    for (size_t s = 0; s < cut->count; s++)
        for (size_t k = 0; k < d; k++)
            c->corner[s * d + k] = number[cut->item[s].vertex[k]];
    return GRAZE_OK;
}

static int compare_cell_facets(const void *left, const void *right) {
    const cell_facet *a = left, *b = right;
    int order = cell_compare(&a->name, &b->name);
    for (int i = 0; i < 4 && order == 0; i++)
        order = fmpz_cmp(a->form + i, b->form + i);
    return order;
}

/* Set a facet that consists of one simplex. */
static void set_facet(cell_facet *f, const cell_complex *c, size_t simplex) {
    int d = c->dimension;
    memset(f, 0, sizeof *f);
    f->name = solid_cell(c->solid, simplex, 0);
    f->first = simplex;
    int facing = solid_plane(f->form, c->solid, simplex);
    _fmpz_vec_scalar_mul_si(f->form, f->form, d + 1, facing);
    LOCAL(fmpz, content);
    _fmpz_vec_content(content, f->form, d);
    _fmpz_vec_scalar_divexact_fmpz(f->normal, f->form, d, content);
}

static void clear_facet(cell_facet *f) {
    _fmpz_vec_zero(f->form, 4);
    _fmpz_vec_zero(f->normal, 3);
}

/* Merge equal ones among the sorted facets of single simplices, and list the simplices in `order`.
 */
static void merge_facets(cell_complex *c, size_t count) {
    for (size_t k = 0; k < count; k++) {
        size_t simplex = c->facet[k].first;
        if (k == 0 || compare_cell_facets(&c->facet[c->facet_count - 1], &c->facet[k]) != 0) {
            if (k > c->facet_count) {
                c->facet[c->facet_count] = c->facet[k];
                memset(&c->facet[k], 0, sizeof c->facet[k]);
            }
            c->facet[c->facet_count].first = k;
            c->facet_count++;
        } else {
            clear_facet(&c->facet[k]);
        }
        c->order[k] = simplex;
        c->facet_of[simplex] = c->facet_count - 1;
        c->facet[c->facet_count - 1].count = k + 1 - c->facet[c->facet_count - 1].first;
    }
}

static graze_status find_facets(cell_complex *c, graze_context *context) {
    size_t n = c->solid->cut.count;
    TRY(MAKE_ARRAY(context, c->facet, n, CELLS));
    TRY(MAKE_ARRAY(context, c->order, n, CELLS));
    TRY(MAKE_ARRAY(context, c->facet_of, n, CELLS));
    for (size_t s = 0; s < n; s++)
        set_facet(&c->facet[s], c, s);
    qsort(c->facet, n, sizeof *c->facet, compare_cell_facets);
    merge_facets(c, n);
    return GRAZE_OK;
}

/* The number of the facet with a place_facet's name and form. */
static size_t facet_number(const cell_complex *c, const place_facet *wanted) {
    cell_facet key;
    memset(&key, 0, sizeof key);
    key.name = wanted->name;
    for (int i = 0; i < 4; i++)
        key.form[i] = wanted->form[i]; /* borrowed */
    const cell_facet *found =
        bsearch(&key, c->facet, c->facet_count, sizeof *c->facet, compare_cell_facets);
    return (size_t)(found - c->facet);
}

/* The state while cells are located one after another. */
typedef struct locating {
    cell_complex *c;
    graze_context *context;
    cell_lists *lists;
    size_t done, used, capacity;
} locating;

/* Locate a point of the next cell: set the cell's name and kind, and append its facets to the list.
 */
static graze_status locate_next(graze_cell *name, place_kind *kind, locating *l, const fmpq *at) {
    ZEROED(neighborhood, found);
    TRY(neighborhood_locate(&found, l->context, l->c->solid, at));
    if (!found.count)
        return context_fail(l->context, GRAZE_EINTERNAL, "a cell is not on the boundary");
    TRY(ARRAY_GROW(l->context, l->lists->item, l->capacity, l->used + found.count,
                   "the facets at a cell"));
    for (size_t k = 0; k < found.count; k++)
        l->lists->item[l->used++] = facet_number(l->c, &found.facet[k]);
    *name = found.cell;
    *kind = found.kind;
    l->lists->start[++l->done] = l->used;
    return context_work(l->context, 10000);
}

static void sort_lists(cell_lists *lists, size_t count) {
    for (size_t k = 0; k < count; k++)
        qsort(lists->item + lists->start[k], lists->start[k + 1] - lists->start[k],
              sizeof *lists->item, array_compare_numbers);
}

static graze_status locate_vertices(cell_complex *c, graze_context *context) {
    int d = c->dimension;
    locating l = {.c = c, .context = context, .lists = &c->vertex_facets};
    TRY(MAKE_ARRAY(context, c->vertex, c->vertex_count, CELLS));
    TRY(MAKE_ARRAY(context, c->vertex_facets.start, c->vertex_count + 1, CELLS));
    for (size_t k = 0; k < c->vertex_count; k++) {
        cell_vertex *v = &c->vertex[k];
        const fmpq *at = c->at + k * (size_t)d;
        _fmpq_vec_get_fmpz_vec_fmpz(v->x, v->x + d, at, d);
        TRY(locate_next(&v->name, &v->kind, &l, at));
    }
    sort_lists(&c->vertex_facets, c->vertex_count);
    return GRAZE_OK;
}

static graze_status locate_edges(cell_complex *c, graze_context *context) {
    int d = c->dimension;
    locating l = {.c = c, .context = context, .lists = &c->edge_facets};
    TRY(MAKE_ARRAY(context, c->edge_facets.start, c->edge_count + 1, CELLS));
    LOCAL_VEC(fmpq, middle, d);
    for (size_t k = 0; k < c->edge_count; k++) {
        cell_edge *e = &c->edge[k];
        vector_middle(middle, c->at + e->u * (size_t)d, c->at + e->v * (size_t)d, d);
        TRY(locate_next(&e->name, &e->kind, &l, middle));
    }
    sort_lists(&c->edge_facets, c->edge_count);
    return GRAZE_OK;
}

/* List the edges of each of `count` keys, ascending. The keys of an edge are its two vertices if
 * `by_vertex`, else the facets that contain it. */
static graze_status invert_edges(cell_lists *out, graze_context *context, const cell_complex *c,
                                 size_t count, int by_vertex) {
    size_t total = by_vertex ? 2 * c->edge_count : c->edge_facets.start[c->edge_count];
    TRY(MAKE_ARRAY(context, out->start, count + 2, CELLS));
    TRY(MAKE_ARRAY(context, out->item, total + 1, CELLS));
    for (int pass = 0; pass < 2; pass++) {
        for (size_t e = 0; e < c->edge_count; e++) {
            const size_t ends[2] = {c->edge[e].u, c->edge[e].v};
            cell_span keys = by_vertex ? (cell_span){ends, 2} : cells_of(&c->edge_facets, e);
            for (size_t j = 0; j < keys.count; j++)
                if (pass == 0)
                    out->start[keys.item[j] + 2]++;
                else
                    out->item[out->start[keys.item[j] + 1]++] = e;
        }
        for (size_t k = 2; pass == 0 && k < count + 2; k++)
            out->start[k] += out->start[k - 1];
    }
    return GRAZE_OK;
}

/* List, or if `count` only count, for each facet the vertices in it that end no edge in it.
 * seen[facet] is 1 + the last vertex that was found to end an edge in the facet. */
static void list_lone_vertices(cell_lists *out, const cell_complex *c, size_t *seen, int count) {
    for (size_t v = 0; v < c->vertex_count; v++) {
        for (size_t i = c->vertex_edges.start[v]; i < c->vertex_edges.start[v + 1]; i++) {
            size_t e = c->vertex_edges.item[i];
            for (size_t j = c->edge_facets.start[e]; j < c->edge_facets.start[e + 1]; j++)
                seen[c->edge_facets.item[j]] = v + 1;
        }
        for (size_t j = c->vertex_facets.start[v]; j < c->vertex_facets.start[v + 1]; j++) {
            size_t facet = c->vertex_facets.item[j];
            if (seen[facet] != v + 1 && count)
                out->start[facet + 2]++;
            else if (seen[facet] != v + 1)
                out->item[out->start[facet + 1]++] = v;
        }
    }
}

static graze_status find_lone_vertices(cell_lists *out, graze_context *context,
                                       const cell_complex *c) {
    FREED(size_t, seen, NULL);
    TRY(MAKE_ARRAY(context, seen, c->facet_count, CELLS));
    TRY(MAKE_ARRAY(context, out->start, c->facet_count + 2, CELLS));
    TRY(MAKE_ARRAY(context, out->item, c->vertex_facets.start[c->vertex_count] + 1, CELLS));
    list_lone_vertices(out, c, seen, 1);
    for (size_t k = 2; k < c->facet_count + 2; k++)
        out->start[k] += out->start[k - 1];
    list_lone_vertices(out, c, seen, 0);
    return GRAZE_OK;
}

graze_status complex_make(cell_complex *out, graze_context *context, const graze_solid *solid) {
    memset(out, 0, sizeof *out);
    out->solid = solid;
    out->dimension = solid->input.dimension;
    TRY(find_corners(out, context));
    TRY(find_facets(out, context));
    TRY(edges_find(out, context));
    TRY(locate_vertices(out, context));
    TRY(locate_edges(out, context));
    TRY(invert_edges(&out->facet_edges, context, out, out->facet_count, 0));
    TRY(invert_edges(&out->vertex_edges, context, out, out->vertex_count, 1));
    return find_lone_vertices(&out->lone_vertices, context, out);
}

static void clear_lists(cell_lists *lists) {
    free(lists->start);
    free(lists->item);
}

void complex_clear(cell_complex *c) {
    for (size_t k = 0; k < c->facet_count; k++)
        clear_facet(&c->facet[k]);
    for (size_t k = 0; c->vertex && k < c->vertex_count; k++)
        _fmpz_vec_zero(c->vertex[k].x, 4);
    free(c->facet);
    free(c->vertex);
    if (c->at)
        _fmpq_vec_clear(c->at, (slong)(c->vertex_capacity * (size_t)c->dimension));
    free(c->edge);
    free(c->order);
    free(c->corner);
    free(c->facet_of);
    clear_lists(&c->vertex_facets);
    clear_lists(&c->edge_facets);
    clear_lists(&c->facet_edges);
    clear_lists(&c->vertex_edges);
    clear_lists(&c->lone_vertices);
}
