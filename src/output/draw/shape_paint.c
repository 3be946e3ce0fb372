/* Edges that are shown, and faces of shapes, sorted by depth and painted from the far ones on.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Sides of triangles are sorted by their ends, so that the two sides at an edge are neighbours. The
 * angle at an edge is computed in doubles, since only pictures depend on it.
 */
#include "output/draw/views.h"

#include <math.h>
#include "base/context/scope.h"

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

/* The normal of the triangle of three vertices, with coordinates in `at`. */
static void triangle_normal(double out[3], const double *at, const uint32_t *vertex) {
    double side[2][3];
    for (int j = 0; j < 2; j++)
        for (int k = 0; k < 3; k++)
            side[j][k] =
                at[3 * (size_t)vertex[j + 1] + (size_t)k] - at[3 * (size_t)vertex[0] + (size_t)k];
    cross3(out, side[0], side[1]);
}

static void unit_normal(double out[3], const graze_solid *solid, uint32_t simplex) {
    triangle_normal(out, solid->low, solid->cut.item[simplex].vertex);
    double length = sqrt(dot3(out, out));
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
    return dot3(a, b);
}

static uint32_t least_of_face(uint32_t *face, uint32_t simplex) {
    while (face[simplex] != simplex)
        simplex = face[simplex] = face[face[simplex]];
    return simplex;
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
    if (cosine > cosine_flat) {
        uint32_t a = least_of_face(out->face, e[0].simplex);
        uint32_t b = least_of_face(out->face, e[1].simplex);
        out->face[a > b ? a : b] = a > b ? b : a;
    }
    if (e->diagonal || cosine > (solid->cut.count >= DENSE ? cosine_dense : cosine_flat))
        return;
    for (size_t i = 0; i < count; i++)
        out->sides[e[i].simplex] |= (unsigned char)(1u << e[i].side);
    out->item[out->count++] = *e;
}

graze_status edges_make(edge_list *out, graze_context *context, const graze_solid *solid) {
    size_t n = solid->cut.count;
    memset(out, 0, sizeof *out);
    TRY(MAKE_ARRAY(context, out->sides, n, "the edges of a picture"));
    TRY(MAKE_ARRAY(context, out->face, n, "the edges of a picture"));
    TRY(MAKE_ARRAY(context, out->item, 3 * n, "the edges of a picture"));
    for (size_t s = 0; s < n; s++)
        out->face[s] = (uint32_t)s;
    n = list_sides(out->item, solid);
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

/* A face turned towards the viewer. */
typedef struct face {
    double depth, area;
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

/* Find depth, area and light of a face; 0 if it is turned away from the viewer. The light comes
 * from the viewer's left shoulder. */
static int see(face *out, const shape *s, size_t simplex, const projection *look) {
    double toward[3], normal[3], length = 0, facing = 0, lit = 0;
    const uint32_t *vertex = s->solid->cut.item[simplex].vertex;
    const double *a = s->at + 3 * (size_t)vertex[0], *b = s->at + 3 * (size_t)vertex[1];
    const double *c = s->at + 3 * (size_t)vertex[2];
    cross3(toward, look->row[0], look->row[1]);
    triangle_normal(normal, s->at, vertex);
    out->depth = 0;
    for (int k = 0; k < 3; k++) {
        out->depth += toward[k] * (a[k] + b[k] + c[k]);
        normal[k] = s->reflected ? -normal[k] : normal[k];
        length += normal[k] * normal[k];
        facing += normal[k] * toward[k];
        lit += normal[k] * (.75 * toward[k] - .35 * look->row[0][k] + .55 * look->row[1][k]);
    }
    out->area = sqrt(length);
    out->light = fmax(lit / out->area, 0);
    return facing > 0;
}

static unsigned shade(unsigned colour, double light) {
    double share = .62 + .38 * light;
    unsigned out = 0;
    for (int shift = 16; shift >= 0; shift -= 8)
        out |= (unsigned)((colour >> shift & 255) * share) << shift;
    return PAINT(out);
}

/* How faces are painted: as paths, or as pixels if there are many faces. */
typedef struct brush {
    canvas *canvas;
    const panel *panel;
    const edge_list *edges;
    raster pixels; /* faces are paths if `pixel` is NULL */
} brush;

static void paint_path(const brush *b, const style *plain, const style *line, const double x[3],
                       const double y[3], unsigned sides) {
    drawn_path area = {NULL, 0, 0, 0}, edges = {NULL, 0, 0, 0};
    for (int k = 0; k < 3; k++)
        drawn_path_to(&area, k ? 'L' : 'M', x[k], y[k]);
    drawn_path_to(&area, 'z', 0, 0);
    for (int k = 0; k < 3; k++)
        if (sides >> k & 1)
            drawn_path_line(&edges, x[k], y[k], x[(k + 1) % 3], y[(k + 1) % 3]);
    canvas_path(b->canvas, &area, plain, NULL);
    canvas_path(b->canvas, &edges, line, NULL);
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

/* Give the coplanar faces of one shape the same depth, so that no face of another shape is painted
 * between them. `sums` has two numbers, zeroed, for each simplex. */
static void level_depths(face *faces, size_t count, const uint32_t *face_of, double *sums) {
    for (size_t k = 0; k < count; k++) {
        double *sum = sums + 2 * (size_t)face_of[faces[k].simplex];
        sum[0] += faces[k].area * faces[k].depth;
        sum[1] += faces[k].area;
    }
    for (size_t k = 0; k < count; k++) {
        const double *sum = sums + 2 * (size_t)face_of[faces[k].simplex];
        faces[k].depth = sum[0] / sum[1];
    }
}

/* List the faces of a shape that are turned towards the viewer; returns their number. */
static size_t list_faces(face *out, const shape *shapes, size_t s, const panel *p,
                         const edge_list *edges, double *sums) {
    size_t n = 0, count = shapes[s].solid->cut.count;
    for (size_t f = 0; f < count; f++) {
        out[n].shape = s;
        out[n].simplex = f;
        n += (size_t)see(&out[n], &shapes[s], f, &p->look);
    }
    memset(sums, 0, 2 * count * sizeof *sums);
    level_depths(out, n, edges->face, sums);
    return n;
}

graze_status shapes_paint(canvas *c, graze_context *context, const shape *shapes,
                          const finish *finishes, size_t count, const panel *p) {
    size_t n = 0, per_shape = shapes[0].solid->cut.count;
    ZEROED(edge_list, edges);
    TRY(edges_make(&edges, context, shapes[0].solid));
    FREED(face, faces, calloc(per_shape, count * sizeof *faces));
    FREED(double, sums, calloc(per_shape, 2 * sizeof *sums));
    if (!faces || !sums)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the faces of a picture");
    for (size_t s = 0; s < count; s++)
        n += list_faces(faces + n, shapes, s, p, &edges, sums);
    brush b = {c, p, &edges, {0, 0, NULL}};
    qsort(faces, n, sizeof *faces, nearer_later);
    return paint_faces(&b, context, shapes, finishes, faces, n);
}
