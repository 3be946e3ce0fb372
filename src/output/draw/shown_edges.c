/* Sides of triangles, sorted by their ends, so that the two of an edge are neighbours.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The angle is computed in doubles: what a picture leaves out decides nothing.
 */
#include "output/draw/shown_edges.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* From so many triangles on a mesh is dense; its edges are shown where the surface bends by more
 * than 30 degrees. */
enum { DENSE = 2000 };
static const double least_cosine = 0.866;

static int compare_edges(const void *a, const void *b) {
    const shown_edge *e = a, *f = b;
    uint32_t ends[4] = {e->from < e->to ? e->from : e->to, e->from < e->to ? e->to : e->from,
                        f->from < f->to ? f->from : f->to, f->from < f->to ? f->to : f->from};
    if (ends[0] != ends[2])
        return ends[0] < ends[2] ? -1 : 1;
    if (ends[1] != ends[3])
        return ends[1] < ends[3] ? -1 : 1;
    return e->simplex < f->simplex ? -1 : e->simplex > f->simplex;
}

static int same_edge(const shown_edge *e, const shown_edge *f) {
    return (e->from == f->from && e->to == f->to) || (e->from == f->to && e->to == f->from);
}

static void unit_normal(double out[3], const graze_solid *solid, uint32_t simplex) {
    const uint32_t *vertex = solid->cut.item[simplex].vertex;
    const double *a = solid->low + 3 * (size_t)vertex[0], *b = solid->low + 3 * (size_t)vertex[1];
    const double *c = solid->low + 3 * (size_t)vertex[2];
    double length = 0;
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        out[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
        length += out[k] * out[k];
    }
    for (int k = 0; k < 3; k++)
        out[k] /= sqrt(length);
}

/* Two sides alone that make a nearly flat edge; an edge with other than two is shown. */
static int bends_little(const graze_solid *solid, const shown_edge *e, size_t count) {
    double a[3], b[3];
    if (count != 2)
        return 0;
    unit_normal(a, solid, e[0].simplex);
    unit_normal(b, solid, e[1].simplex);
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > least_cosine;
}

static size_t list_sides(shown_edge *out, const graze_solid *solid) {
    size_t n = 0;
    for (size_t s = 0; s < solid->cut.count; s++) {
        const simplex *from = &solid->cut.item[s];
        for (int k = 0; k < 3; k++)
            if (!(from->diagonal >> k & 1))
                out[n++] = (shown_edge){from->vertex[k], from->vertex[(k + 1) % 3], (uint32_t)s,
                                        (unsigned char)k};
    }
    return n;
}

graze_status edges_make(edge_list *out, graze_context *context, const graze_solid *solid) {
    memset(out, 0, sizeof *out);
    out->sides = calloc(solid->cut.count, 1);
    out->item = calloc(3 * solid->cut.count, sizeof *out->item);
    if (!out->sides || !out->item)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the edges of a picture");
    size_t n = list_sides(out->item, solid);
    int dense = solid->cut.count >= DENSE;
    if (n)
        qsort(out->item, n, sizeof *out->item, compare_edges);
    for (size_t k = 0, next; k < n; k = next) {
        for (next = k + 1; next < n && same_edge(&out->item[k], &out->item[next]);)
            next++;
        if (dense && bends_little(solid, out->item + k, next - k))
            continue;
        for (size_t i = k; i < next; i++)
            out->sides[out->item[i].simplex] |= (unsigned char)(1u << out->item[i].side);
        out->item[out->count++] = out->item[k];
    }
    return GRAZE_OK;
}

void edges_clear(edge_list *e) {
    free(e->item);
    free(e->sides);
    *e = (edge_list){NULL, 0, NULL};
}
