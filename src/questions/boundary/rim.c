/* Finds rims: the sides of faces that belong to one face of the patch only.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/boundary/sampling.h"

/* Directed edges: sides of the patch's faces while these are added, and in the end those of the rim
 * alone. */
typedef struct edge_list {
    size_t from[RIM_MOST], to[RIM_MOST], count;
} edge_list;

/* Add an edge, or remove the opposite one if that is in the list. */
static void toggle_edge(edge_list *l, size_t from, size_t to) {
    for (size_t k = 0; k < l->count; k++) {
        if (l->from[k] != to || l->to[k] != from)
            continue;
        l->count--;
        l->from[k] = l->from[l->count];
        l->to[k] = l->to[l->count];
        return;
    }
    l->from[l->count] = from;
    l->to[l->count++] = to;
}

/* The edge that begins at a vertex, `count` if there is none; *several becomes 1 if there is more
 * than one. */
static size_t edge_from(const edge_list *l, size_t vertex, int *several) {
    size_t found = l->count;
    for (size_t k = 0; k < l->count; k++) {
        if (l->from[k] != vertex)
            continue;
        *several |= found < l->count;
        found = k;
    }
    return found;
}

/* The edge at which the rim begins: in E^2 one at whose beginning no other ends; in E^3 the first
 * in the list. */
static size_t first_edge(const edge_list *l, int dimension) {
    for (size_t k = 0; k < l->count && dimension == 2; k++) {
        int ends = 0;
        for (size_t j = 0; j < l->count; j++)
            ends |= l->to[j] == l->from[k];
        if (!ends)
            return k;
    }
    return 0;
}

int rim_find(rim *out, const struct graze_boundary *b, size_t index) {
    size_t d = (size_t)b->dimension, first = b->patches[index].first;
    size_t end = index + 1 < b->patch_count ? b->patches[index + 1].first : b->face_count;
    edge_list edges = {.count = 0};
    int several = 0;
    for (size_t face = first; face < end; face++)
        for (size_t k = 0; k < (d == 2 ? 1 : d); k++)
            toggle_edge(&edges, b->corners[face * d + k], b->corners[face * d + (k + 1) % d]);
    out->count = 0;
    size_t at = first_edge(&edges, b->dimension), passed = 0;
    for (; at < edges.count && passed < edges.count; passed++) {
        out->vertex[out->count++] = edges.from[at];
        size_t next = edges.to[at];
        at = edge_from(&edges, next, &several);
        if (d == 2 && at == edges.count)
            out->vertex[out->count++] = next;
        if (d == 3 && at < edges.count && edges.from[at] == out->vertex[0])
            at = edges.count;
    }
    return !several && passed == edges.count;
}

int rim_run_at(rim_run *out, const struct graze_boundary *b, const sample_cell *c,
               const size_t *vertex, size_t count, int axis, int upper) {
    uint64_t place = (c->at[axis] + (uint64_t)upper) << (b->depth + 1 - c->level);
    size_t runs = 0, last = count - 1;
    int before = 0, in = 0;
    *out = (rim_run){0, 0};
    for (size_t k = 0; k <= count; k++) {
        /* the edge from `last` to k; that from count - 1 to 0 comes first and again last, to give
         * `before` */
        size_t to = k % count;
        in = key_coordinate(b->vertices.key[vertex[last]], axis) == place &&
             key_coordinate(b->vertices.key[vertex[to]], axis) == place;
        if (k > 0) {
            out->edges += (size_t)in;
            if (in && !before) {
                runs++;
                out->first = last;
            }
        }
        before = in;
        last = to;
    }
    return runs == 1;
}
