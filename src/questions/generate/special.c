/* Finds times at which the normal velocity is zero at all vertices of a simplex, one simplex a
 * plane, by polynomials in time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/strata.h"

#include "base/context/array.h"
#include "base/context/scope.h"
#include "decide/trace/trace.h"

/* The most pairs of a plane and a piece that are searched, and the most special instants that are
 * kept. */
enum { MOST_PAIRS = 4000, MOST_SPECIALS = 512 };

void special_velocity(fmpz_poly_t out, const graze_scene *scene, size_t piece, const fmpz *form,
                      const fmpq *y) {
    const motion_piece *p = &scene->motion->piece[piece];
    const point_map *tracing = motion_tracing(p, scene->options.operation);
    int d = tracing->dimension;
    HELD(trajectory, place, d);
    LOCAL(fmpz_poly, column);
    trajectory_set(&place, motion_placing(p, scene->options.operation), y);
    fmpz_poly_zero(out);
    for (int j = 0; j <= d; j++) {
        fmpz_poly_scalar_mul_fmpz(column, tracing->weight, form + d);
        if (j < d)
            fmpz_poly_zero(column);
        for (int i = 0; i < d; i++)
            fmpz_poly_scalar_addmul_fmpz(column, &tracing->entry[i * (d + 1) + j], form + i);
        fmpz_poly_derivative(column, column);
        fmpz_poly_mul(column, column, &place.x[j]);
        fmpz_poly_add(out, out, column);
    }
}

static graze_status append_special(specials *out, graze_context *context, const graze_scene *scene,
                                   size_t piece, const fmpq_t u, size_t simplex, int slides) {
    TRY(LIST_GROW(context, out, "the special times"));
    special *added = &out->item[out->count++];
    instant_init(&added->when, scene, piece, u);
    added->simplex = simplex;
    added->slides = slides;
    return GRAZE_OK;
}

int special_roots(fmpq *out, const fmpz_poly_t p) {
    int count = 0;
    if (fmpz_poly_degree(p) < 1 || fmpz_poly_degree(p) > SPECIAL_ROOTS)
        return 0;
    LOCAL(fmpz_poly_factor, factors);
    fmpz_poly_factor(factors, p);
    for (slong k = 0; k < factors->num; k++) {
        if (fmpz_poly_degree(factors->p + k) != 1)
            continue;
        fmpq *u = out + count;
        fmpq_set_fmpz_frac(u, factors->p[k].coeffs, factors->p[k].coeffs + 1);
        fmpq_neg(u, u);
        count += fmpq_sgn(u) > 0 && fmpq_cmp_ui(u, 1) < 0;
    }
    return count;
}

/* Append the rational roots in (0, 1) of the greatest common divisor of the vertices' normal
 * velocities, or a slide if that is 0. `rootless` is the last divisor without such roots: most
 * simplices have the one that comes from the motion's weight. */
static graze_status look_at(specials *out, graze_context *context, const graze_scene *scene,
                            fmpz_poly_t rootless, size_t piece, size_t simplex, const fmpz *plane) {
    const graze_solid *solid = scene->solid;
    int d = solid->input.dimension;
    LOCAL(fmpz_poly, common);
    LOCAL(fmpz_poly, velocity);
    LOCAL_VEC(fmpq, u, SPECIAL_ROOTS);
    for (int k = 0; k < d; k++) {
        special_velocity(velocity, scene, piece, plane,
                         solid->input.coordinates + solid->cut.item[simplex].vertex[k] * (size_t)d);
        fmpz_poly_gcd(common, common, velocity);
        fmpz_poly_primitive_part(common, common);
        if (k > 0 && fmpz_poly_equal(common, rootless))
            return GRAZE_OK;
    }
    if (fmpz_poly_is_zero(common))
        return append_special(out, context, scene, piece, &(fmpq){1, 2}, simplex, 1);
    int count = special_roots(u, common);
    if (!count)
        fmpz_poly_set(rootless, common);
    for (int k = 0; k < count && out->count < MOST_SPECIALS; k++)
        TRY(append_special(out, context, scene, piece, u + k, simplex, 0));
    return GRAZE_OK;
}

/* Search the first simplex of each plane, in the order of the simplices. */
static graze_status look_at_planes(specials *out, graze_context *context, const graze_scene *scene,
                                   const plane_list *planes, uint32_t *plane_from) {
    size_t pieces = scene->motion->piece_count, seen = 0;
    size_t stride = planes->count * pieces / MOST_PAIRS + 1;
    size_t width = (size_t)planes->dimension + 1;
    LOCAL(fmpz_poly, rootless);
    fmpz_poly_one(rootless);
    for (size_t p = 0; p < planes->count; p++)
        plane_from[planes->order[planes->start[p]]] = (uint32_t)p + 1;
    for (size_t s = 0; s < planes->simplex_count; s++) {
        if (!plane_from[s])
            continue;
        const fmpz *form = planes->form + (plane_from[s] - 1) * width;
        for (size_t piece = 0; piece < pieces && out->count < MOST_SPECIALS; piece++)
            if (seen++ % stride == 0)
                TRY(look_at(out, context, scene, rootless, piece, s, form));
        TRY(context_poll(context));
    }
    return GRAZE_OK;
}

graze_status specials_find(specials *out, graze_context *context, const graze_scene *scene) {
    const graze_solid *solid = scene->solid;
    plane_list planes;
    *out = (specials){.count = 0};
    FREED(uint32_t, plane_from, calloc(solid->cut.count, sizeof *plane_from));
    if (!plane_from || planes_find(&planes, NULL, solid, NULL, solid->cut.count))
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the planes of %zu simplices",
                            solid->cut.count);
    graze_status status = look_at_planes(out, context, scene, &planes, plane_from);
    planes_clear(&planes);
    if (status)
        specials_clear(out);
    return status;
}

void specials_clear(specials *list) {
    for (size_t k = 0; k < list->count; k++)
        instant_clear(&list->item[k].when);
    free(list->item);
    *list = (specials){.count = 0};
}
