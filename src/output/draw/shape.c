/* Vertices at a time, outlines, slices, and faces painted from the back to the front.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/shape.h"

#include <flint/fmpq_vec.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "output/draw/chain.h"
#include "output/draw/raster.h"
#include "output/draw/shown_edges.h"

/* Map all vertices by d rows of d + 1 numbers. */
static graze_status place_vertices(shape *out, graze_context *context, const graze_solid *solid,
                                   const double *map) {
    const soup *s = &solid->input;
    int d = s->dimension;
    *out = (shape){solid, calloc(s->vertex_count, 3 * sizeof(double)), 0};
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
    fmpq_t u, width;
    fmpq_init(u);
    fmpq_init(width);
    fmpq_sub(u, t, piece->lo);
    fmpq_sub(width, piece->hi, piece->lo);
    fmpq_div(u, u, width);
    fmpq *exact = _fmpq_vec_init(entries);
    double map[12];
    point_map_at(exact, inverse ? &piece->inverse : &piece->forward, u);
    for (int e = 0; e < entries; e++)
        map[e] = fmpq_get_d(exact + e);
    _fmpq_vec_clear(exact, entries);
    fmpq_clear(width);
    fmpq_clear(u);
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

/* Nodes of a line of a dense mesh are no nearer than this to one another, in pixels. */
static double nodes_apart(size_t count) {
    enum { DENSE = 2000 };
    return count < DENSE ? 0 : .4;
}

void shape_rings(drawn_path *out, const shape *s, const panel *p) {
    const soup *input = &s->solid->input;
    double apart = nodes_apart(input->index_count);
    for (size_t c = 0; c < input->cycle_count; c++) {
        for (size_t k = input->cycle_start[c]; k < input->cycle_start[c + 1]; k++) {
            double x, y;
            panel_map(&x, &y, p, s->at + 3 * (size_t)input->index[k]);
            if (k == input->cycle_start[c])
                drawn_path_to(out, 'M', x, y);
            else
                chain_to(out, x, y, apart);
        }
        drawn_path_to(out, 'z', 0, 0);
    }
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
    chain_segment *segments = calloc(cut->count + 1, sizeof *segments);
    size_t n = 0;
    out->failed |= !segments;
    for (size_t f = 0; f < cut->count && segments; f++)
        n += (size_t)slice_triangle(&segments[n], s, &cut->item[f], p, normal, place);
    if (segments)
        chain_path(out, segments, n, nodes_apart(cut->count));
    free(segments);
}

/* A face turned towards the onlooker. */
typedef struct face {
    double depth;
    size_t shape, simplex;
    double light; /* 0 ... 1 */
} face;

static int nearer_later(const void *a, const void *b) {
    const face *f = a, *g = b;
    if (f->depth != g->depth)
        return f->depth < g->depth ? -1 : 1;
    if (f->shape != g->shape)
        return f->shape < g->shape ? -1 : 1;
    return f->simplex < g->simplex ? -1 : f->simplex > g->simplex;
}

static void toward_onlooker(double out[3], const projection *look) {
    const double *a = look->row[0], *b = look->row[1];
    for (int k = 0; k < 3; k++)
        out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* Look at a face; 0 if it is turned away. The light comes from the onlooker's left shoulder. */
static int see(face *out, const shape *s, size_t simplex, const projection *look) {
    double toward[3], side[2][3], normal[3], length = 0, facing = 0, lit = 0;
    const uint32_t *vertex = s->solid->cut.item[simplex].vertex;
    const double *at[3];
    toward_onlooker(toward, look);
    for (int k = 0; k < 3; k++)
        at[k] = s->at + 3 * (size_t)vertex[k];
    out->depth = 0;
    for (int k = 0; k < 3; k++) {
        side[0][k] = at[1][k] - at[0][k];
        side[1][k] = at[2][k] - at[0][k];
        out->depth += toward[k] * (at[0][k] + at[1][k] + at[2][k]);
    }
    for (int k = 0; k < 3; k++) {
        int l = (k + 1) % 3, m = (k + 2) % 3;
        normal[k] = side[0][l] * side[1][m] - side[0][m] * side[1][l];
        normal[k] = s->reflected ? -normal[k] : normal[k];
        length += normal[k] * normal[k];
        facing += normal[k] * toward[k];
        lit += normal[k] * (.75 * toward[k] - .35 * look->row[0][k] + .55 * look->row[1][k]);
    }
    out->light = fmax(lit / sqrt(length), 0);
    return facing > 0;
}

static unsigned shade(unsigned colour, double light) {
    double share = .62 + .38 * light;
    unsigned out = 0;
    for (int shift = 16; shift >= 0; shift -= 8)
        out |= (unsigned)((colour >> shift & 255) * share) << shift;
    return PAINT(out);
}

/* How faces are painted: as paths, or where they are many as pixels. */
typedef struct brush {
    canvas *canvas;
    const panel *panel;
    const edge_list *edges;
    raster pixels; /* without `pixel`: paths */
} brush;

static void paint_path(const brush *b, const style *plain, const style *line, const double x[3],
                       const double y[3], unsigned sides) {
    drawn_path area = {NULL, 0, 0, 0}, edges = {NULL, 0, 0, 0};
    for (int k = 0; k < 3; k++)
        drawn_path_to(&area, k ? 'L' : 'M', x[k], y[k]);
    drawn_path_to(&area, 'z', 0, 0);
    for (int k = 0; k < 3; k++)
        if (sides >> k & 1) {
            drawn_path_to(&edges, 'M', x[k], y[k]);
            drawn_path_to(&edges, 'L', x[(k + 1) % 3], y[(k + 1) % 3]);
        }
    canvas_path(b->canvas, &area, plain, NULL);
    canvas_path(b->canvas, &edges, line, NULL);
    drawn_path_clear(&area);
    drawn_path_clear(&edges);
}

static void paint_pixels(brush *b, const style *plain, const style *line, double x[3], double y[3],
                         unsigned sides) {
    for (int k = 0; k < 3; k++) {
        x[k] -= b->panel->x;
        y[k] -= b->panel->y;
    }
    raster_triangle(&b->pixels, x, y, plain->fill, plain->faintness);
    for (int k = 0; k < 3; k++) {
        const double from[2] = {x[k], y[k]}, to[2] = {x[(k + 1) % 3], y[(k + 1) % 3]};
        if (sides >> k & 1)
            raster_line(&b->pixels, from, to, line->stroke, line->faintness);
    }
}

static void paint_face(brush *b, const shape *s, const finish *how, const face *f) {
    const simplex *from = &s->solid->cut.item[f->simplex];
    double x[3], y[3];
    for (int k = 0; k < 3; k++)
        panel_map(&x[k], &y[k], b->panel, s->at + 3 * (size_t)from->vertex[k]);
    const style plain = {
        .fill = shade(how->colour, f->light), .faintness = how->faintness, .crisp = 1};
    const style line = {
        .stroke = shade(how->colour, -.6), .width = .6, .faintness = how->faintness};
    unsigned sides = how->edges ? b->edges->sides[f->simplex] : 0;
    if (b->pixels.pixel)
        paint_pixels(b, &plain, &line, x, y, sides);
    else
        paint_path(b, &plain, &line, x, y, sides);
}

static graze_status paint_faces(brush *b, graze_context *context, const shape *shapes,
                                const finish *finishes, const face *faces, size_t count) {
    enum { MOST_PATHS = 2000 };
    if (count > MOST_PATHS && !raster_init(&b->pixels, b->panel))
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the faces of a picture");
    for (size_t k = 0; k < count; k++)
        paint_face(b, &shapes[faces[k].shape], &finishes[faces[k].shape], &faces[k]);
    if (b->pixels.pixel)
        raster_draw(b->canvas, &b->pixels, b->panel);
    raster_clear(&b->pixels);
    return GRAZE_OK;
}

graze_status shapes_paint(canvas *c, graze_context *context, const shape *shapes,
                          const finish *finishes, size_t count, const panel *p) {
    size_t n = 0, per_shape = shapes[0].solid->cut.count;
    edge_list edges;
    graze_status status = edges_make(&edges, context, shapes[0].solid);
    face *faces = calloc(per_shape, count * sizeof *faces);
    if (!status && !faces)
        status = context_fail(context, GRAZE_ESYSTEM, "out of memory for the faces of a picture");
    for (size_t s = 0; s < count && !status; s++)
        for (size_t f = 0; f < per_shape; f++) {
            faces[n].shape = s;
            faces[n].simplex = f;
            n += (size_t)see(&faces[n], &shapes[s], f, &p->look);
        }
    if (!status) {
        brush b = {c, p, &edges, {0, 0, NULL}};
        qsort(faces, n, sizeof *faces, nearer_later);
        status = paint_faces(&b, context, shapes, finishes, faces, n);
    }
    free(faces);
    edges_clear(&edges);
    return status;
}
