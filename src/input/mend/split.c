/* Splits edges at the vertices in their middle.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * In a closed surface each edge has an even number of sides. An edge with an odd number is broken;
 * a broken edge with an end of another broken one strictly inside it is split there in all its
 * facets.
 */
#define _GNU_SOURCE /* qsort_r */
#include "base/context/scope.h"
#include "input/mend/mesh.h"

/* A vertex to insert into the side that begins at `corner`. */
typedef struct insertion {
    size_t corner;
    uint32_t vertex;
} insertion;

typedef struct splitter {
    mesh *m;
    mesh_side *side;
    size_t side_count;
    uint32_t *end; /* ends of broken edges, sorted by the first coordinate; each once */
    size_t end_count;
    insertion *made;
    size_t made_count, made_capacity;
    few split;
} splitter;

static int order_along_x(const void *a, const void *b, void *data) {
    uint32_t u = *(const uint32_t *)a, v = *(const uint32_t *)b;
    int order = fmpq_cmp(mesh_point(data, u), mesh_point(data, v));
    return order ? order : (u > v) - (u < v);
}

static graze_status find_ends(splitter *s) {
    size_t n = 0;
    TRY(mesh_sides(&s->side, &s->side_count, s->m));
    TRY(MAKE_ARRAY(s->m->context, s->end, 2 * s->side_count + 1, "edges"));
    for (size_t first = 0, end; first < s->side_count; first = end) {
        end = mesh_edge_end(s->side, s->side_count, first);
        if ((end - first) % 2) {
            s->end[n++] = s->side[first].low;
            s->end[n++] = s->side[first].high;
        }
    }
    qsort_r(s->end, n, sizeof *s->end, order_along_x, s->m);
    for (size_t k = 0; k < n; k++)
        if (!s->end_count || s->end[s->end_count - 1] != s->end[k])
            s->end[s->end_count++] = s->end[k];
    return GRAZE_OK;
}

graze_status split_open_ends(uint32_t **out, size_t *count, mesh *m) {
    splitter s = {.m = m};
    graze_status status = find_ends(&s);
    *out = s.end;
    *count = s.end_count;
    free(s.side);
    return status;
}

/* Does v lie strictly between the ends of an edge? */
static int is_inside_edge(const mesh *m, const mesh_side *edge, uint32_t v) {
    const fmpq *a = mesh_point(m, edge->low), *b = mesh_point(m, edge->high), *p = mesh_point(m, v);
    int between = 0;
    if (v == edge->low || v == edge->high)
        return 0;
    for (int k = 0; k < 3; k++) {
        int from = fmpq_cmp(p + k, a + k), to = fmpq_cmp(b + k, p + k);
        if ((from < 0 && to > 0) || (from > 0 && to < 0) || (from == 0) != (to == 0))
            return 0;
        between |= from != 0;
    }
    return between && mesh_collinear(m, edge->low, edge->high, v);
}

/* The first end whose first coordinate is not below that of the vertex. */
static size_t first_end_from(const splitter *s, uint32_t vertex) {
    size_t low = 0, high = s->end_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (fmpq_cmp(mesh_point(s->m, s->end[middle]), mesh_point(s->m, vertex)) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static graze_status add_insertions(splitter *s, size_t first, size_t end, uint32_t vertex) {
    const mesh *m = s->m;
    few_add(&s->split, "%u-%u at vertex %u", s->side[first].low, s->side[first].high, vertex);
    for (size_t k = first; k < end; k++) {
        TRY(ARRAY_GROW(m->context, s->made, s->made_capacity, s->made_count + 1, "a solid"));
        s->made[s->made_count++] = (insertion){s->side[k].corner, vertex};
    }
    return GRAZE_OK;
}

/* Find the ends inside one broken edge. */
static graze_status look_into_edge(splitter *s, size_t first, size_t end) {
    const mesh *m = s->m;
    const mesh_side *edge = &s->side[first];
    int ascends = fmpq_cmp(mesh_point(m, edge->low), mesh_point(m, edge->high)) <= 0;
    uint32_t from = ascends ? edge->low : edge->high, to = ascends ? edge->high : edge->low;
    TRY(context_poll(m->context));
    for (size_t k = first_end_from(s, from); k < s->end_count; k++) {
        if (fmpq_cmp(mesh_point(m, s->end[k]), mesh_point(m, to)) > 0)
            break;
        if (is_inside_edge(m, edge, s->end[k]))
            TRY(add_insertions(s, first, end, s->end[k]));
    }
    return GRAZE_OK;
}

/* Is u nearer than v to the corner that a side begins at? All three lie on the side. */
static int is_nearer(const mesh *m, uint32_t corner, uint32_t u, uint32_t v) {
    const fmpq *c = mesh_point(m, corner), *p = mesh_point(m, u), *q = mesh_point(m, v);
    int k = 0;
    while (fmpq_equal(p + k, q + k))
        k++;
    return fmpq_cmp(c + k, p + k) == fmpq_cmp(p + k, q + k);
}

static int order_of_insertions(const void *a, const void *b, void *data) {
    const insertion *x = a, *y = b;
    const mesh *m = data;
    if (x->corner != y->corner)
        return x->corner < y->corner ? -1 : 1;
    if (x->vertex == y->vertex)
        return 0;
    return is_nearer(m, m->now.of.index[x->corner], x->vertex, y->vertex) ? -1 : 1;
}

static graze_status insert_vertices(splitter *s) {
    mesh *m = s->m;
    ZEROED(facets, made);
    size_t next = 0;
    qsort_r(s->made, s->made_count, sizeof *s->made, order_of_insertions, m);
    for (size_t f = 0; f < m->now.of.cycle_count; f++) {
        TRY(facets_begin(&made, m->context, m->now.origin.item[f]));
        for (size_t c = m->now.of.cycle_start[f]; c < m->now.of.cycle_start[f + 1]; c++) {
            TRY(soup_add_index(&made.of, m->context, m->now.of.index[c]));
            for (; next < s->made_count && s->made[next].corner == c; next++)
                TRY(soup_add_index(&made.of, m->context, s->made[next].vertex));
        }
    }
    mesh_replace(m, &made);
    return GRAZE_OK;
}

graze_status split_edges(mesh *m) {
    splitter s = {.m = m};
    graze_status status = find_ends(&s);
    for (size_t first = 0, end; first < s.side_count && !status; first = end) {
        end = mesh_edge_end(s.side, s.side_count, first);
        if ((end - first) % 2)
            status = look_into_edge(&s, first, end);
    }
    if (!status && s.made_count)
        status = insert_vertices(&s);
    few_report(&s.split, m, "split", "edges with a vertex in their middle");
    free(s.side);
    free(s.end);
    free(s.made);
    return status;
}
