/* Solid, motion, surface, mesh and cells as JSON (src/output/page/README.md).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/page/page.h"

#include <math.h>
#include "base/context/scope.h"
#include "questions/boundary/boundary.h"
#include "questions/outline/outline.h"

static graze_status put_shown_edges(json_writer *w, graze_context *context,
                                    const graze_solid *solid) {
    encoder e;
    ZEROED(edge_list, edges);
    TRY(edges_make(&edges, context, solid));
    encode_begin(&e, w, "edges");
    for (size_t k = 0; k < edges.count; k++) {
        encode_count(&e, edges.item[k].from);
        encode_count(&e, edges.item[k].to);
    }
    encode_end(&e);
    return GRAZE_OK;
}

graze_status page_solid(json_writer *w, graze_context *context, const graze_solid *solid) {
    const soup *s = &solid->input;
    int d = s->dimension;
    encoder e;
    json_open(w, "solid", '{');
    encode_begin(&e, w, "vertices");
    for (size_t k = 0; k < s->vertex_count * (size_t)d; k++)
        encode_double(&e, solid->low[k]);
    encode_end(&e);
    encode_begin(&e, w, d == 2 ? "edges" : "triangles");
    for (size_t k = 0; k < solid->cut.count; k++)
        for (int i = 0; i < d; i++)
            encode_count(&e, solid->cut.item[k].vertex[i]);
    encode_end(&e);
    TRY(d == 3 ? put_shown_edges(w, context, solid) : GRAZE_OK);
    json_close(w, '}');
    return GRAZE_OK;
}

/* Put a polynomial's coefficients divided by 2^exponent, the lowest first. */
static void put_coefficients(json_writer *w, const char *key, const fmpz_poly_struct *p,
                             slong exponent) {
    json_open(w, key, '[');
    for (slong k = 0; k < p->length; k++) {
        slong own;
        double value = fmpz_get_d_2exp(&own, p->coeffs + k);
        json_double(w, NULL, own - exponent < -1100 ? 0 : ldexp(value, (int)(own - exponent)));
    }
    json_close(w, ']');
}

/* Put all entries and the weight, divided by one power of two, so that doubles can hold them. */
static void put_map(json_writer *w, const char *key, const point_map *map) {
    int entries = map->dimension * (map->dimension + 1);
    slong most = 0;
    for (int k = 0; k <= entries; k++) {
        const fmpz_poly_struct *p = k < entries ? &map->entry[k] : map->weight;
        for (slong i = 0; i < p->length; i++) {
            slong bits = (slong)fmpz_bits(p->coeffs + i);
            most = bits > most ? bits : most;
        }
    }
    json_open(w, key, '{');
    json_open(w, "entries", '[');
    for (int k = 0; k < entries; k++)
        put_coefficients(w, NULL, &map->entry[k], most);
    json_close(w, ']');
    put_coefficients(w, "weight", map->weight, most);
    json_close(w, '}');
}

void page_motion(json_writer *w, const graze_motion *motion, graze_operation operation) {
    json_open(w, "motion", '[');
    for (size_t k = 0; k < motion->piece_count; k++) {
        const motion_piece *piece = &motion->piece[k];
        json_line(w, 0);
        json_open(w, NULL, '{');
        json_form(json_begin(w, "t"), "[%,%]", piece->lo, piece->hi);
        put_map(w, "place", motion_placing(piece, operation));
        put_map(w, "trace", motion_tracing(piece, operation));
        json_close(w, '}');
    }
    json_close(w, ']');
}

static void put_surface(json_writer *w, const struct graze_boundary *b, const double *centre) {
    encoder e;
    int d = b->dimension;
    LOCAL_VEC(fmpq, point, d);
    json_open(w, "surface", '{');
    json_count(w, "level", b->reached);
    json_bool(w, "closed", b->closed);
    json_bool(w, "complete", b->complete);
    encode_begin(&e, w, "vertices");
    for (size_t v = 0; v < bisect_count(b); v++) {
        bisect_vertex(point, b, v);
        encode_place(&e, point, centre, d);
    }
    encode_end(&e);
    encode_begin(&e, w, "faces");
    for (size_t k = 0; k < b->face_count * (size_t)d; k++)
        encode_count(&e, (uint32_t)b->corners[k]);
    encode_end(&e);
    json_close(w, '}');
}

static void put_arcs(json_writer *w, const outline_polygon *p, const double *centre) {
    encoder e;
    json_open(w, "surface", '{');
    encode_begin(&e, w, "vertices");
    for (size_t k = 0; k < p->count; k++)
        for (int i = 0; i < 2; i++)
            encode_float(&e, ldexp((double)p->edge[k].at[i], -(int)p->places) - centre[i]);
    encode_end(&e);
    json_open(w, "sources", '{');
    for (int source = 0; source < 3; source++) {
        encode_begin(&e, w, curve_source_names[source]);
        for (size_t k = 0; k < p->count; k++)
            if ((int)outline_arc_source(p->o, p->edge[k].arc) == source) {
                encode_count(&e, (uint32_t)k);
                encode_count(&e, (uint32_t)p->edge[k].next);
            }
        encode_end(&e);
    }
    json_close(w, '}');
    json_close(w, '}');
}

typedef graze_outline outline; /* as a local that outline_clear clears */

/* Put the arcs of the exact outline of a polygon's sweep, by their sources; GRAZE_ELIMIT where they
 * are beyond a limit. */
static graze_status put_outline(json_writer *w, graze_context *context, const graze_scene *scene,
                                const double *centre) {
    static const double FINENESS = 1. / 8192; /* of the longest side of the box */
    ZEROED(outline, o);
    ZEROED(outline_polygon, p);
    LOCAL_VEC(fmpq, box, 4);
    double size = 0;
    TRY(scene_box(box, box + 2, context, scene));
    for (int k = 0; k < 2; k++)
        size = fmax(size, fmpq_get_d(box + 2 + k) - fmpq_get_d(box + k));
    TRY(outline_make(&o, context, scene, 1));
    TRY(outline_polygon_make(&p, &o, context, FINENESS * size));
    put_arcs(w, &p, centre);
    return GRAZE_OK;
}

graze_status page_surface(json_writer *w, graze_context *context, const graze_scene *scene,
                          const draw_request *request, const double *centre) {
    enum { CONTACTS = 300, BUDGET = 1000000 };
    unsigned coarse = scene->motion->dimension == 2 ? 5 : 4;
    if (!request->surface || scene->solid->curved) {
        json_text(w, "surface", NULL);
        return GRAZE_OK;
    }
    graze_status status =
        scene->motion->dimension == 2 ? put_outline(w, context, scene, centre) : GRAZE_ELIMIT;
    if (status != GRAZE_ELIMIT)
        return status;
    const graze_boundary_options options = {.coarse = coarse < request->surface ? coarse
                                                                                : request->surface,
                                            .depth = request->surface,
                                            .budget = BUDGET,
                                            .contacts = CONTACTS,
                                            .seed = 1,
                                            .sharp = 1};
    struct graze_boundary b;
    status = boundary_make(&b, context, scene, &options, request->low, request->high);
    if (!status)
        put_surface(w, &b, centre);
    boundary_clear(&b);
    return status;
}

void page_mesh(json_writer *w, const draw_request *request, const double *centre) {
    const draw_mesh *m = request->mesh;
    encoder e;
    if (!m) {
        json_text(w, "mesh", NULL);
        return;
    }
    json_open(w, "mesh", '{');
    encode_begin(&e, w, "vertices");
    for (size_t k = 0; k < m->vertex_count; k++)
        encode_place(&e, m->vertices + 3 * k, centre, 3);
    encode_end(&e);
    encode_begin(&e, w, "faces");
    for (size_t k = 0; k < 3 * m->triangle_count; k++)
        encode_count(&e, m->corners[k]);
    encode_end(&e);
    encode_begin(&e, w, "distances");
    for (size_t k = 0; k < m->vertex_count; k++)
        encode_double(&e, m->distance[k]);
    encode_end(&e);
    json_close(w, '}');
}

/* Put three corners of the cells: the lower left one, and its neighbours to the right and above. */
static void put_corners(json_writer *w, const cells *c) {
    const extent e = cells_extent(c);
    json_open(w, "corners", '[');
    for (int k = 0; k < 3; k++) {
        double at[3];
        cells_corner(at, c, k == 1 ? e.high[0] : e.low[0], k == 2 ? e.high[1] : e.low[1]);
        for (int i = 0; i < 3; i++)
            json_double(w, NULL, at[i]);
    }
    json_close(w, ']');
}

static void put_bytes(json_writer *w, const char *key, const unsigned char *bytes, size_t count) {
    encoder e;
    encode_begin(&e, w, key);
    for (size_t k = 0; k < count; k++)
        encode_byte(&e, bytes[k]);
    encode_end(&e);
}

/* Put the tones of the cells as bytes, and those of the parts of split cells. */
static void put_cells_of(json_writer *w, const cells *c, const draw_request *request) {
    encoder e;
    size_t count = c->count[0] * c->count[1];
    json_open(w, "cells", '{');
    put_corners(w, c);
    text *plane = json_begin(w, "plane");
    text_put(plane, "\"");
    if (c->section || c->dimension == 3)
        cells_plane(plane, c, request->plane_axis);
    text_put(plane, "\"");
    text_format(json_begin(w, "count"), "[%zu,%zu]", c->count[0], c->count[1]);
    json_count(w, "parts", c->parts);
    put_bytes(w, "tones", c->tone, count);
    json_line(w, 0);
    encode_begin(&e, w, "split");
    for (size_t k = 0; k < count; k++)
        if (c->split[k])
            encode_count(&e, (uint32_t)k);
    encode_end(&e);
    json_line(w, 0);
    put_bytes(w, "part", c->part, c->split_count * c->parts * c->parts);
    json_close(w, '}');
}

graze_status page_cells(json_writer *w, graze_context *context, const graze_scene *scene,
                        const draw_request *request) {
    draw_request by_class = *request;
    by_class.by_distance = 0;
    ZEROED(section, oblique); /* cleared after the cells, which borrow it */
    ZEROED(cells, c);
    TRY(request_cells(&c, &oblique, context, scene, &by_class));
    TRY(parts_classify(&c, context, scene));
    put_cells_of(w, &c, request);
    return GRAZE_OK;
}
