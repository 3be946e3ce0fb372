/* Sides of triangles, sorted by their ends, so that the two sides at an edge are neighbours.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The angle at an edge is computed in doubles, since only pictures depend on it.
 */
#include "output/draw/draw.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "output/draw/panel.h"

/* A mesh with DENSE triangles or more is dense: its edges are shown where the surface bends by more
 * than 30 degrees. Other meshes show all edges at which the surface bends. */
enum { DENSE = 2000 };
static const double cosine_dense = 0.866, cosine_flat = 1 - 1e-12;

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
    double side[2][3];
    for (int k = 0; k < 3; k++) {
        side[0][k] = b[k] - a[k];
        side[1][k] = c[k] - a[k];
    }
    cross_product(out, side[0], side[1]);
    double length = sqrt(dot_product(out, out));
    for (int k = 0; k < 3; k++)
        out[k] /= length;
}

/* The cosine of the angle between the normals of the two triangles at an edge; -1 if there are not
 * two. */
static double bend(const graze_solid *solid, const shown_edge *e, size_t count) {
    double a[3], b[3];
    if (count != 2)
        return -1;
    unit_normal(a, solid, e[0].simplex);
    unit_normal(b, solid, e[1].simplex);
    return dot_product(a, b);
}

static uint32_t least_of_face(uint32_t *face, uint32_t simplex) {
    while (face[simplex] != simplex)
        simplex = face[simplex] = face[face[simplex]];
    return simplex;
}

static void join_faces(uint32_t *face, uint32_t a, uint32_t b) {
    a = least_of_face(face, a);
    b = least_of_face(face, b);
    face[a > b ? a : b] = a > b ? b : a;
}

static size_t list_sides(shown_edge *out, const graze_solid *solid) {
    size_t n = 0;
    for (size_t s = 0; s < solid->cut.count; s++) {
        const simplex *from = &solid->cut.item[s];
        for (int k = 0; k < 3; k++)
            out[n++] = (shown_edge){from->vertex[k], from->vertex[(k + 1) % 3], (uint32_t)s,
                                    (unsigned char)k, from->diagonal >> k & 1};
    }
    return n;
}

/* Take an edge of `count` sides: it is shown, or it joins two triangles of one face. */
static void take_edge(edge_list *out, const graze_solid *solid, const shown_edge *e, size_t count) {
    double cosine = bend(solid, e, count);
    if (cosine > cosine_flat)
        join_faces(out->face, e[0].simplex, e[1].simplex);
    if (e->diagonal || cosine > (solid->cut.count >= DENSE ? cosine_dense : cosine_flat))
        return;
    for (size_t i = 0; i < count; i++)
        out->sides[e[i].simplex] |= (unsigned char)(1u << e[i].side);
    out->item[out->count++] = *e;
}

graze_status edges_make(edge_list *out, graze_context *context, const graze_solid *solid) {
    size_t n = solid->cut.count;
    memset(out, 0, sizeof *out);
    out->sides = calloc(n, 1);
    out->face = calloc(n, sizeof *out->face);
    out->item = calloc(3 * n, sizeof *out->item);
    if (!out->sides || !out->face || !out->item)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the edges of a picture");
    for (size_t s = 0; s < n; s++)
        out->face[s] = (uint32_t)s;
    n = list_sides(out->item, solid);
    if (n)
        qsort(out->item, n, sizeof *out->item, compare_edges);
    for (size_t k = 0, next; k < n; k = next) {
        for (next = k + 1; next < n && same_edge(&out->item[k], &out->item[next]);)
            next++;
        take_edge(out, solid, out->item + k, next - k);
    }
    for (size_t s = 0; s < solid->cut.count; s++)
        out->face[s] = least_of_face(out->face, (uint32_t)s);
    return GRAZE_OK;
}

void edge_list_clear(edge_list *e) {
    free(e->item);
    free(e->sides);
    free(e->face);
    *e = (edge_list){NULL, 0, NULL, NULL};
}
