/* Vertices at a time, outlines and slices. Segments whose ends have equal keys are neighbours.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include <math.h>
#include "base/context/scope.h"

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
    double normal[3];
    cross3(normal, m + 4, m + 8);
    return dot3(m, normal);
}

graze_status shape_moved(shape *out, graze_context *context, const graze_solid *solid,
                         const graze_motion *motion, const fmpq_t t, int inverse) {
    size_t k = 0;
    int d = motion->dimension, entries = d * (d + 1);
    while (k + 1 < motion->piece_count && fmpq_cmp(t, motion->piece[k].hi) > 0)
        k++;
    const motion_piece *piece = &motion->piece[k];
    LOCAL(fmpq, u);
    motion_parameter_at(u, piece, t);
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

/* End `end` of a segment. */
typedef struct chain_end {
    uint64_t key;
    size_t segment;
    int end;
} chain_end;

static int order_ends(const void *a, const void *b) {
    const chain_end *e = a, *f = b;
    if (e->key != f->key)
        return e->key < f->key ? -1 : 1;
    if (e->segment != f->segment)
        return e->segment < f->segment ? -1 : 1;
    return e->end - f->end;
}

/* No end. Ends are numbered 2 * segment + end; next[] gives the end that meets an end, or NONE. */
static const size_t NONE = SIZE_MAX;

static void link_ends(size_t *next, chain_end *ends, size_t count) {
    for (size_t k = 0; k < count; k++)
        next[k] = NONE;
    qsort(ends, count, sizeof *ends, order_ends);
    for (size_t k = 0; k + 1 < count; k++) {
        if (ends[k].key != ends[k + 1].key)
            continue;
        size_t a = 2 * ends[k].segment + (size_t)ends[k].end;
        size_t b = 2 * ends[k + 1].segment + (size_t)ends[k + 1].end;
        next[a] = b;
        next[b] = a;
        k++;
    }
}

/* Add a line to a point, unless the point is nearer than `apart` to the node before it. */
static void chain_to(drawn_path *out, double x, double y, double apart) {
    const path_node *last = out->count ? &out->node[out->count - 1] : NULL;
    if (out->failed || !last || last->verb == 'z' || apart == 0 ||
        hypot(x - last->x, y - last->y) >= apart)
        drawn_path_to(out, 'L', x, y);
}

/* The end at which the line through a segment begins: an end without a neighbour or, in a closed
 * line, the first end of this segment. */
static size_t first_end(const size_t *next, size_t segment) {
    size_t at = 2 * segment;
    while (next[at] != NONE && next[at] / 2 != segment)
        at = next[at] ^ 1;
    return next[at] == NONE ? at : 2 * segment;
}

static void put_chain(drawn_path *out, const chain_segment *segments, const size_t *next,
                      char *taken, size_t from, double apart) {
    size_t at = from;
    drawn_path_to(out, 'M', segments[at / 2].x[at % 2], segments[at / 2].y[at % 2]);
    for (;;) {
        const chain_segment *s = &segments[at / 2];
        size_t far = at ^ 1;
        taken[at / 2] = 1;
        if (next[far] == from) {
            drawn_path_to(out, 'z', 0, 0);
            return;
        }
        int last = next[far] == NONE || taken[next[far] / 2];
        chain_to(out, s->x[far % 2], s->y[far % 2], last ? 0 : apart);
        if (last)
            return;
        at = next[far];
    }
}

void chain_path(drawn_path *out, const chain_segment *segments, size_t count, double apart) {
    FREED(chain_end, ends, calloc(2 * count + 1, sizeof *ends));
    FREED(size_t, next, calloc(2 * count + 1, sizeof *next));
    FREED(char, taken, calloc(count + 1, 1));
    out->failed |= !ends || !next || !taken;
    if (!out->failed) {
        for (size_t k = 0; k < 2 * count; k++)
            ends[k] = (chain_end){segments[k / 2].key[k % 2], k / 2, (int)(k % 2)};
        link_ends(next, ends, 2 * count);
        for (size_t k = 0; k < count; k++)
            if (!taken[k])
                put_chain(out, segments, next, taken, first_end(next, k), apart);
    }
}

/* Find the segment in which a triangle meets the plane; 0 if its vertices are all on one side. */
static int slice_triangle(chain_segment *out, const shape *s, const simplex *f, const panel *p,
                          const double normal[3], double place) {
    int ends = 0;
    for (int k = 0; k < 3; k++) {
        uint64_t v = f->vertex[k], w = f->vertex[(k + 1) % 3];
        /* The ends are ordered, so that both triangles of the edge find the same point. */
        uint64_t from = v < w ? v : w, to = v < w ? w : v;
        const double *a = s->at + 3 * from, *b = s->at + 3 * to;
        double end[3], at_a = dot3(normal, a), at_b = dot3(normal, b);
        if ((at_a >= place) == (at_b >= place))
            continue;
        for (int i = 0; i < 3; i++)
            end[i] = a[i] + (place - at_a) / (at_b - at_a) * (b[i] - a[i]);
        panel_map(&out->x[ends], &out->y[ends], p, end);
        out->key[ends++] = from << 32 | to;
    }
    return ends == 2;
}

/* Map an edge of the boundary in E^2 to pixels. */
static void map_side(chain_segment *out, const shape *s, const simplex *f, const panel *p) {
    for (int k = 0; k < 2; k++) {
        out->key[k] = f->vertex[k];
        panel_map(&out->x[k], &out->y[k], p, s->at + 3 * (size_t)f->vertex[k]);
    }
}

void shape_outline(drawn_path *out, const shape *s, const panel *p, const double *normal,
                   double place) {
    enum { DENSE = 2000 }; /* simplices of a mesh whose nodes are kept apart */
    const simplices *cut = &s->solid->cut;
    FREED(chain_segment, segments, calloc(cut->count + 1, sizeof *segments));
    size_t n = 0;
    out->failed |= !segments;
    for (size_t f = 0; f < cut->count && segments; f++)
        if (normal)
            n += (size_t)slice_triangle(&segments[n], s, &cut->item[f], p, normal, place);
        else
            map_side(&segments[n++], s, &cut->item[f], p);
    if (segments)
        chain_path(out, segments, n, cut->count < DENSE ? 0 : .4);
}
