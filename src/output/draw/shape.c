/* Vertices at a time, outlines and slices.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/draw.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include "base/context/scope.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "input/soup/soup.h"
#include "input/validate/validate.h"
#include "output/draw/panel.h"
#include "output/draw/views.h"

/* Map all vertices by d rows of d + 1 numbers. */
static graze_status place_vertices(shape *out, graze_context *context, const graze_solid *solid,
                                   const double *map) {
    const soup *s = &solid->input;
    int d = s->dimension;
    *out = (shape){solid, calloc(s->vertex_count + 1, 3 * sizeof(double)), 0};
    if (!out->at)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a picture of the solid");
    for (size_t v = 0; v < s->vertex_count; v++)
        for (int i = 0; i < d; i++) {
            const double *row = map + i * (d + 1);
            double sum = row[d];
            for (int j = 0; j < d; j++)
                sum += row[j] * solid->low[v * (size_t)d + (size_t)j];
            out->at[3 * v + (size_t)i] = sum;
        }
    return GRAZE_OK;
}

graze_status shape_standing(shape *out, graze_context *context, const graze_solid *solid) {
    static const double identity2[] = {1, 0, 0, 0, 1, 0};
    static const double identity3[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    return place_vertices(out, context, solid, solid->input.dimension == 2 ? identity2 : identity3);
}

static double determinant(const double *m, int d) {
    if (d == 2)
        return m[0] * m[4] - m[1] * m[3];
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
           m[2] * (m[4] * m[9] - m[5] * m[8]);
}

graze_status shape_moved(shape *out, graze_context *context, const graze_solid *solid,
                         const graze_motion *motion, const fmpq_t t, int inverse) {
    size_t k = 0;
    int d = motion->dimension, entries = d * (d + 1);
    while (k + 1 < motion->piece_count && fmpq_cmp(t, motion->piece[k].hi) > 0)
        k++;
    const motion_piece *piece = &motion->piece[k];
    LOCAL_VEC(fmpq, u, 2);
    fmpq *width = u + 1;
    fmpq_sub(u, t, piece->lo);
    fmpq_sub(width, piece->hi, piece->lo);
    fmpq_div(u, u, width);
    LOCAL_VEC(fmpq, exact, entries);
    double map[12];
    point_map_at(exact, inverse ? &piece->inverse : &piece->forward, u);
    for (int e = 0; e < entries; e++)
        map[e] = fmpq_get_d(exact + e);
    graze_status status = place_vertices(out, context, solid, map);
    out->reflected = determinant(map, d) < 0;
    return status;
}

void shape_clear(shape *s) {
    free(s->at);
    s->at = NULL;
}

void shape_extent(extent *out, const shape *s, const projection *look) {
    for (size_t v = 0; v < s->solid->input.vertex_count; v++)
        extent_add(out, projection_at(look, 0, s->at + 3 * v),
                   projection_at(look, 1, s->at + 3 * v));
}

/* The least distance in pixels between nodes of a line, in a mesh of `count` simplices. */
static double nodes_apart(size_t count) {
    enum { DENSE = 2000 };
    return count < DENSE ? 0 : .4;
}

void shape_rings(drawn_path *out, const shape *s, const panel *p) {
    const simplices *cut = &s->solid->cut;
    FREED(chain_segment, segments, calloc(cut->count + 1, sizeof *segments));
    out->failed |= !segments;
    for (size_t f = 0; f < cut->count && segments; f++)
        for (int k = 0; k < 2; k++) {
            segments[f].key[k] = cut->item[f].vertex[k];
            panel_map(&segments[f].x[k], &segments[f].y[k], p,
                      s->at + 3 * (size_t)cut->item[f].vertex[k]);
        }
    if (segments)
        chain_path(out, segments, cut->count, nodes_apart(cut->count));
}

static double height_over(const double normal[3], const double *a) {
    return normal[0] * a[0] + normal[1] * a[1] + normal[2] * a[2];
}

/* The point in which the line through two vertices meets the plane, one being above it. */
static void meet_plane(double out[3], const double *a, const double *b, const double normal[3],
                       double place) {
    double from = height_over(normal, a), share = (place - from) / (height_over(normal, b) - from);
    for (int k = 0; k < 3; k++)
        out[k] = a[k] + share * (b[k] - a[k]);
}

/* The segment of one triangle; 0 if the plane does not pass between its vertices. */
static int slice_triangle(chain_segment *out, const shape *s, const simplex *f, const panel *p,
                          const double normal[3], double place) {
    int ends = 0;
    for (int k = 0; k < 3; k++) {
        uint64_t from = f->vertex[k], to = f->vertex[(k + 1) % 3];
        const double *a = s->at + 3 * from, *b = s->at + 3 * to;
        double end[3];
        if ((height_over(normal, a) >= place) == (height_over(normal, b) >= place))
            continue;
        /* Alike from both sides of the edge. */
        meet_plane(end, from < to ? a : b, from < to ? b : a, normal, place);
        panel_map(&out->x[ends], &out->y[ends], p, end);
        out->key[ends++] = from < to ? from << 32 | to : to << 32 | from;
    }
    return ends == 2;
}

void shape_slice(drawn_path *out, const shape *s, const panel *p, const double normal[3],
                 double place) {
    const simplices *cut = &s->solid->cut;
    FREED(chain_segment, segments, calloc(cut->count + 1, sizeof *segments));
    size_t n = 0;
    out->failed |= !segments;
    for (size_t f = 0; f < cut->count && segments; f++)
        n += (size_t)slice_triangle(&segments[n], s, &cut->item[f], p, normal, place);
    if (segments)
        chain_path(out, segments, n, nodes_apart(cut->count));
}
