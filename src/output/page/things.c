/* Solid, motion and surface as JSON (src/output/page/README.md).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/page/page.h"

#include <flint/fmpq_vec.h>
#include <math.h>
#include "base/context/scope.h"
#include "decide/scene/scene.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "input/soup/soup.h"
#include "output/draw/draw.h"
#include "questions/boundary/boundary.h"

/* The triangles of the boundary; in E^2 its sides. */
static void put_simplices(text *out, const graze_solid *solid) {
    encoder e;
    int d = solid->input.dimension;
    encode_begin(&e, out, d == 2 ? ",\"edges\":" : ",\"triangles\":");
    for (size_t k = 0; k < solid->cut.count; k++)
        for (int i = 0; i < d; i++)
            encode_count(&e, solid->cut.item[k].vertex[i]);
    encode_end(&e);
}

graze_status page_solid(text *out, graze_context *context, const graze_solid *solid) {
    const soup *s = &solid->input;
    size_t d = (size_t)s->dimension;
    encoder e;
    graze_status status = GRAZE_OK;
    encode_begin(&e, out, "{\"vertices\":");
    for (size_t k = 0; k < s->vertex_count * d; k++)
        encode_double(&e, solid->low[k]);
    encode_end(&e);
    put_simplices(out, solid);
    if (d == 3) {
        edge_list edges;
        status = edges_make(&edges, context, solid);
        encode_begin(&e, out, ",\"edges\":");
        for (size_t k = 0; k < edges.count && !status; k++) {
            encode_count(&e, edges.item[k].from);
            encode_count(&e, edges.item[k].to);
        }
        encode_end(&e);
        edges_clear(&edges);
    }
    text_put(out, "}");
    return status;
}

/* A polynomial's coefficients over 2^exponent, the lowest first. */
static void put_coefficients(text *out, const fmpz_poly_struct *p, slong exponent) {
    text_put(out, "[");
    for (slong k = 0; k < p->length; k++) {
        slong own;
        double value = fmpz_get_d_2exp(&own, p->coeffs + k);
        text_put(out, k ? "," : "");
        encode_number(out, own - exponent < -1100 ? 0 : ldexp(value, (int)(own - exponent)));
    }
    text_put(out, "]");
}

/* All entries and the weight over one power of two, so that doubles hold them. */
static void put_map(text *out, const point_map *map) {
    int entries = map->dimension * (map->dimension + 1);
    slong most = 0;
    for (int k = 0; k <= entries; k++) {
        const fmpz_poly_struct *p = k < entries ? &map->entry[k] : map->weight;
        for (slong i = 0; i < p->length; i++) {
            slong bits = (slong)fmpz_bits(p->coeffs + i);
            most = bits > most ? bits : most;
        }
    }
    text_put(out, "{\"entries\":[");
    for (int k = 0; k < entries; k++) {
        text_put(out, k ? "," : "");
        put_coefficients(out, &map->entry[k], most);
    }
    text_put(out, "],\"weight\":");
    put_coefficients(out, map->weight, most);
    text_put(out, "}");
}

void page_motion(text *out, const graze_motion *motion, graze_operation operation) {
    text_put(out, "[");
    for (size_t k = 0; k < motion->piece_count; k++) {
        const motion_piece *piece = &motion->piece[k];
        text_put(out, k ? ",\n{\"t\":[\"" : "\n{\"t\":[\"");
        text_rational(out, piece->lo);
        text_put(out, "\",\"");
        text_rational(out, piece->hi);
        text_put(out, "\"],\"place\":");
        put_map(out, motion_placing(piece, operation));
        text_put(out, ",\"trace\":");
        put_map(out, motion_tracing(piece, operation));
        text_put(out, "}");
    }
    text_put(out, "]");
}

static void put_surface(text *out, const struct graze_boundary *b, const double *centre) {
    encoder e;
    int d = b->dimension;
    LOCAL_VEC(fmpq, point, d);
    text_format(out, "{\"level\":%u,\"closed\":%s,\"complete\":%s", b->reached,
                b->closed ? "true" : "false", b->complete ? "true" : "false");
    encode_begin(&e, out, ",\"vertices\":");
    for (size_t v = 0; v < bisect_count(b); v++) {
        bisect_vertex(point, b, v);
        for (int k = 0; k < d; k++)
            encode_float(&e, (float)(fmpq_get_d(point + k) - centre[k]));
    }
    encode_end(&e);
    encode_begin(&e, out, ",\"faces\":");
    for (size_t k = 0; k < b->face_count * (size_t)d; k++)
        encode_count(&e, (uint32_t)b->corners[k]);
    encode_end(&e);
    text_put(out, "}");
}

graze_status page_surface(text *out, graze_context *context, const graze_scene *scene,
                          const draw_request *request, const double *centre) {
    enum { CONTACTS = 300, BUDGET = 1000000 };
    unsigned coarse = scene->motion->dimension == 2 ? 5 : 4;
    if (!request->surface || scene->solid->curved) {
        text_put(out, "null");
        return GRAZE_OK;
    }
    const graze_boundary_options options = {.coarse = coarse < request->surface ? coarse
                                                                                : request->surface,
                                            .depth = request->surface,
                                            .budget = BUDGET,
                                            .contacts = CONTACTS,
                                            .seed = 1,
                                            .sharp = 1};
    struct graze_boundary b;
    graze_status status = boundary_make(&b, context, scene, &options, request->low, request->high);
    if (!status)
        put_surface(out, &b, centre);
    boundary_clear(&b);
    return status;
}

void page_mesh(text *out, const draw_request *request, const double *centre) {
    const draw_mesh *m = request->mesh;
    encoder e;
    if (!m) {
        text_put(out, "null");
        return;
    }
    encode_begin(&e, out, "{\"vertices\":");
    for (size_t k = 0; k < 3 * m->vertex_count; k++)
        encode_float(&e, (float)(fmpq_get_d(m->vertices + k) - centre[k % 3]));
    encode_end(&e);
    encode_begin(&e, out, ",\"faces\":");
    for (size_t k = 0; k < 3 * m->triangle_count; k++)
        encode_count(&e, m->corners[k]);
    encode_end(&e);
    encode_begin(&e, out, ",\"distances\":");
    for (size_t k = 0; k < m->vertex_count; k++)
        encode_double(&e, m->distance[k]);
    encode_end(&e);
    text_put(out, "}");
}
