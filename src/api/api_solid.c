/* The public functions of solids: from files, from arrays, and their properties.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include <stdint.h>
#include "base/context/file.h"
#include "base/number/rounding.h"
#include "input/mend/mend.h"
#include "input/read/read.h"

/* Read a solid; `sha256` is the hash of a file validated before, or NULL. */
static graze_status read_solid(graze_solid **out, graze_context *context, const char *path,
                               unsigned flags, const unsigned char *sha256) {
    soup input;
    format_kind kind = format_of(path)->kind;
    if (kind == FORMAT_CURVED)
        return solid_create_curved(out, context, path, sha256);
    if (kind == FORMAT_SCAD)
        return api_scad_solid(out, context, path, sha256);
    TRY(soup_read(&input, context, path));
    if (sha256 && memcmp(sha256, input.sha256, sizeof input.sha256) != 0) {
        soup_clear(&input);
        return solid_is_another(context, path);
    }
    return context_in(
        context,
        solid_create(out, context, &input, sha256 ? flags | VALIDATE_TRUST_CONTACTS : flags), path,
        0);
}

graze_status graze_solid_read(graze_solid **out, graze_context *context, const char *path,
                              unsigned flags) {
    PUBLIC_OUT(out, context, path);
    REFUSED(flags & ~GRAZE_SOLID_TRIANGULATE, "an unknown flag is set");
    return read_solid(out, context, path, flags, NULL);
}

graze_status graze_solid_read_trusted(graze_solid **out, graze_context *context, const char *path,
                                      const unsigned char *sha256, unsigned flags) {
    PUBLIC_OUT(out, context, path, sha256);
    REFUSED(flags & ~GRAZE_SOLID_TRIANGULATE, "an unknown flag is set");
    return read_solid(out, context, path, flags, sha256);
}

graze_status graze_solid_from_csg(graze_solid **out, graze_context *context, const char *text,
                                  size_t length) {
    PUBLIC_OUT(out, context, text);
    unsigned char sha256[32];
    file_sha256(sha256, text, length);
    return solid_create_curved_text(out, context, "solid", text, length, sha256);
}

graze_status graze_solid_mend(char **out, char **report, graze_context *context, const char *path,
                              mpq_srcptr weld, unsigned flags) {
    EMPTY(out);
    EMPTY(report);
    PUBLIC(out, context, path);
    REFUSED(flags & ~GRAZE_SOLID_TRIANGULATE, "an unknown flag is set");
    REFUSED(weld && mpq_sgn(weld) <= 0, "weld must be positive");
    graze_solid *solid = NULL;
    soup input;
    LOCAL(fmpq, distance);
    if (weld)
        TRY(api_rational(distance, context, weld));
    TRY(soup_read_mesh(&input, context, path));
    HELD(text, written);
    HELD(text, done);
    graze_status status = mend_solid(&solid, &done, context, &input, flags, weld ? distance : NULL);
    if (!status) {
        solid_write(&written, solid);
        status = text_finish(out, context, &written);
    } else {
        status = context_in(context, status, path, 0);
    }
    if (report && (!status || status == GRAZE_EILLEGAL)) {
        *report = text_take(&done);
        if (!*report)
            status = context_fail(context, GRAZE_ESYSTEM, "out of memory");
    }
    if (status && *out) {
        graze_free(*out);
        *out = NULL;
    }
    graze_solid_destroy(solid);
    return status;
}

/* A caller's arrays; exactly one of `rationals` and `doubles` is given. */
typedef struct arrays {
    int dimension;
    graze_rationals rationals;
    const double *doubles;
    size_t vertex_count;
    const size_t *facet_sizes;
    size_t facet_count;
    const size_t *indices;
    size_t index_count;
} arrays;

/* Check the arrays before anything is copied, and set `index_count`. */
static graze_status check_arrays(arrays *a, graze_context *context, unsigned flags) {
    const char *name = a->doubles ? "graze_solid_from_doubles" : "graze_solid_from_arrays";
    unsigned long limit = context->limits[GRAZE_LIMIT_CELLS];
    if (a->dimension != 2 && a->dimension != 3)
        return api_misuse(context, name, "the dimension must be 2 or 3");
    if (flags & ~GRAZE_SOLID_TRIANGULATE)
        return api_misuse(context, name, "an unknown flag is set");
    if (!a->facet_count)
        return context_fail(context, GRAZE_EILLEGAL,
                            "empty interior: there is no facet; expected a closed boundary");
    if (!a->facet_sizes || !a->indices || (!a->rationals && !a->doubles))
        return api_misuse(context, name, "no array must be NULL");
    if (a->vertex_count > limit)
        return context_limit(context, GRAZE_LIMIT_CELLS, "vertices");
    if (a->facet_count > limit)
        return context_limit(context, GRAZE_LIMIT_CELLS, "facets");
    size_t next = 0;
    for (size_t f = 0; f < a->facet_count; f++) {
        size_t size = a->facet_sizes[f];
        if (size < 3)
            return context_fail(context, GRAZE_EINPUT,
                                "facet %zu has %zu vertices; expected at least 3", f, size);
        if (size > SIZE_MAX - next || next + size > limit)
            return context_limit(context, GRAZE_LIMIT_CELLS, "corners of facets");
        for (size_t k = 0; k < size; k++, next++)
            if (a->indices[next] >= a->vertex_count)
                return context_fail(context, GRAZE_EINPUT,
                                    "facet %zu names vertex %zu; expected below %zu", f,
                                    a->indices[next], a->vertex_count);
    }
    a->index_count = next;
    return GRAZE_OK;
}

graze_status api_vertices(soup *s, graze_context *context, graze_rationals rationals,
                          const double *doubles, size_t count) {
    size_t d = (size_t)s->dimension;
    LOCAL_VEC(fmpq, point, (slong)d);
    for (size_t v = 0; v < count; v++) {
        for (size_t k = 0; k < d; k++) {
            graze_status status =
                rationals ? api_rational(point + k, context, rationals[v * d + k])
                          : rational_from_double(point + k, context, doubles[v * d + k]);
            TRY(api_coordinate(context, status, "vertex", v, k));
        }
        TRY(soup_add_vertex(s, context, point));
    }
    return GRAZE_OK;
}

static graze_status add_facets(soup *s, graze_context *context, const arrays *a) {
    if (a->dimension == 2)
        return nesting_add_rings(s, context, a->facet_sizes, a->facet_count, a->indices,
                                 (const int[]){0, 1});
    const size_t *index = a->indices;
    for (size_t f = 0; f < a->facet_count; f++) {
        TRY(soup_add_facet(s, context));
        TRY(soup_add_cycle(s, context, index, a->facet_sizes[f]));
        index += a->facet_sizes[f];
    }
    return GRAZE_OK;
}

static graze_status make_solid(graze_solid **out, graze_context *context, arrays *a,
                               unsigned flags) {
    TRY(check_arrays(a, context, flags));
    soup input;
    soup_init(&input, a->dimension);
    graze_status status = api_vertices(&input, context, a->rationals, a->doubles, a->vertex_count);
    if (!status)
        status = add_facets(&input, context, a);
    if (!status)
        return solid_create(out, context, &input, flags);
    soup_clear(&input);
    return status;
}

graze_status graze_solid_from_arrays(graze_solid **out, graze_context *context, int dimension,
                                     graze_rationals coordinates, size_t vertex_count,
                                     const size_t *facet_sizes, size_t facet_count,
                                     const size_t *indices, unsigned flags) {
    PUBLIC_OUT(out, context);
    arrays a = {dimension, coordinates, NULL, vertex_count, facet_sizes, facet_count, indices, 0};
    return make_solid(out, context, &a, flags);
}

graze_status graze_solid_from_doubles(graze_solid **out, graze_context *context, int dimension,
                                      const double *coordinates, size_t vertex_count,
                                      const size_t *facet_sizes, size_t facet_count,
                                      const size_t *indices, unsigned flags) {
    PUBLIC_OUT(out, context);
    arrays a = {dimension, NULL, coordinates, vertex_count, facet_sizes, facet_count, indices, 0};
    return make_solid(out, context, &a, flags);
}

FACT(int, graze_solid_dimension, graze_solid, of->input.dimension, 0)
FACT(size_t, graze_solid_vertex_count, graze_solid, of->input.vertex_count, 0)

size_t graze_solid_facet_count(const graze_solid *solid) {
    if (!solid)
        return 0;
    return solid->input.dimension == 2 ? solid->cut.count : solid->input.facet_count;
}

FACT(size_t, graze_solid_component_count, graze_solid, of->cut.component_count, 0)

size_t graze_solid_primitive_count(const graze_solid *solid) {
    return solid && solid->curved ? solid->curved->primitive_count : 0;
}

const char *graze_solid_primitive(const graze_solid *solid, size_t index) {
    return index < graze_solid_primitive_count(solid) ? solid->curved->primitive[index].title : "";
}

int graze_solid_bounded(const graze_solid *solid) {
    return solid && solid_bounded(solid);
}

size_t graze_solid_surface_count(const graze_solid *solid) {
    return solid && solid->curved ? solid->curved->surface_count : 0;
}

FACT(const char *, graze_solid_note, graze_solid, of->note, "")

graze_status graze_solid_box(mpq_t *low, mpq_t *high, graze_context *context,
                             const graze_solid *solid) {
    PUBLIC(low, high, context, solid);
    TRY(api_takes(context, "graze_solid_box", solid));
    int d = solid->input.dimension;
    LOCAL_VEC(fmpq, from, d);
    LOCAL_VEC(fmpq, to, d);
    solid_box(from, to, solid);
    api_point_out(low, from, d);
    api_point_out(high, to, d);
    return GRAZE_OK;
}

graze_status graze_solid_text(char **out, graze_context *context, const graze_solid *solid) {
    PUBLIC_OUT(out, context, solid);
    TRY(api_takes(context, "graze_solid_text", solid));
    HELD(text, t);
    solid_write(&t, solid);
    return text_finish(out, context, &t);
}
