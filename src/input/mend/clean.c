/* Merges equal vertices, and drops facets without area.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _GNU_SOURCE /* qsort_r */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/mend/mesh.h"

static int order_of_points(const void *a, const void *b, void *data) {
    const mesh *m = data;
    uint32_t u = *(const uint32_t *)a, v = *(const uint32_t *)b;
    int order = vector_compare(mesh_point(m, u), mesh_point(m, v), 3);
    return order ? order : (u > v) - (u < v);
}

/* Replace each vertex in facets by the first one at its position, and report those replaced. */
static void merge_vertices(mesh *m, const uint32_t *order, uint32_t *first) {
    size_t n = m->input->vertex_count;
    few merged = {0, {NULL, 0, 0, 0}};
    for (size_t k = 0; k < n; k++) {
        const fmpq *at = mesh_point(m, order[k]);
        int again = k > 0 && vector_compare(mesh_point(m, order[k - 1]), at, 3) == 0;
        first[order[k]] = again ? first[order[k - 1]] : order[k];
    }
    FREED(unsigned char, used, calloc(n + 1, 1));
    m->report.failed |= !used;
    for (size_t k = 0; used && k < m->now.of.index_count; k++)
        used[m->now.of.index[k]] = 1;
    for (uint32_t v = 0; used && v < n; v++)
        if (used[v] && first[v] != v)
            few_add(&merged, "%u with %u", v, first[v]);
    few_report(&merged, m, "merged", "vertices with the first one at their position");
    for (size_t k = 0; k < m->now.of.index_count; k++)
        m->now.of.index[k] = first[m->now.of.index[k]];
}

graze_status clean_vertices(mesh *m) {
    size_t n = m->input->vertex_count;
    FREED(uint32_t, order, malloc((n + 1) * sizeof *order));
    FREED(uint32_t, first, malloc((n + 1) * sizeof *first));
    if (!order || !first)
        return context_fail(m->context, GRAZE_ESYSTEM, "out of memory for %zu vertices", n);
    for (uint32_t v = 0; v < n; v++)
        order[v] = v;
    qsort_r(order, n, sizeof *order, order_of_points, m);
    merge_vertices(m, order, first);
    return context_poll(m->context);
}

/* Has the last facet corners that are not all on one line? */
static int has_area(const mesh *m, const soup *f) {
    size_t first = f->cycle_start[f->cycle_count - 1], end = f->cycle_start[f->cycle_count],
           second = first;
    while (second < end && f->index[second] == f->index[first])
        second++;
    for (size_t k = second + 1; k < end; k++)
        if (!mesh_collinear(m, f->index[first], f->index[second], f->index[k]))
            return 1;
    return 0;
}

/* Copy a facet, keeping the last one of corners that repeat each other, as a reader does, so that a
 * fan begins at the same corner. */
static graze_status copy_facet(facets *to, const mesh *m, size_t facet, int *repeated) {
    const soup *f = &m->now.of;
    TRY(facets_begin(to, m->context, m->now.origin.item[facet]));
    for (size_t k = f->cycle_start[facet]; k < f->cycle_start[facet + 1]; k++) {
        size_t next = k + 1 < f->cycle_start[facet + 1] ? k + 1 : f->cycle_start[facet];
        if (f->index[k] != f->index[next])
            TRY(soup_add_index(&to->of, m->context, f->index[k]));
        else
            *repeated = 1;
    }
    return GRAZE_OK;
}

graze_status clean_facets(mesh *m) {
    facets made = {.origin = {0}};
    few flat = {0, {NULL, 0, 0, 0}}, repeats = {0, {NULL, 0, 0, 0}};
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < m->now.of.cycle_count && !status; k++) {
        int repeated = 0;
        status = copy_facet(&made, m, k, &repeated);
        if (!status && k % 4096 == 0)
            status = context_poll(m->context);
        if (status || has_area(m, &made.of)) {
            if (repeated)
                few_add(&repeats, "%zu", m->now.origin.item[k]);
            continue;
        }
        facets_drop_last(&made);
        few_add(&flat, "%zu", m->now.origin.item[k]);
    }
    few_report(&repeats, m, "took repeated corners out of", "facets");
    few_report(&flat, m, "dropped", "facets without area");
    if (!status)
        mesh_replace(m, &made);
    facets_clear(&made);
    return status;
}
