/* Local cones: a direction's state is that of a point beside the cone's point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The point beside it lies on the ray, nearer than every facet's plane that does not pass through
 * the cone's point: up to there the state is constant.
 */
#include "questions/topo/cover.h"

#include "base/context/array.h"
#include "base/context/scope.h"

/* Does a facet in the plane contain the cone's point, which is in the plane? */
static int plane_holds_point(const local_cone *cone, size_t plane) {
    int found = 0;
    unsigned zero = 0;
    const plane_list *list = cone->planes;
    const fmpz *form = list->form + plane * (size_t)(cone->dimension + 1);
    for (uint32_t k = list->start[plane]; k < list->start[plane + 1] && !found; k++)
        found = solid_holds(&zero, cone->solid, list->order[k], form, cone->at);
    return found;
}

graze_status cone_make(local_cone *cone, graze_context *context, const graze_solid *solid,
                       int outside, const plane_list *planes, const fmpz *at) {
    slong d = planes->dimension;
    memset(cone, 0, sizeof *cone);
    cone->solid = solid;
    cone->outside = outside;
    cone->planes = planes;
    cone->dimension = (int)d;
    cone->at = _fmpz_vec_init(d + 1);
    _fmpz_vec_set(cone->at, at, d + 1);
    cone->normal = _fmpz_vec_init((slong)planes->count * d);
    LOCAL(fmpz, value);
    for (size_t p = 0; p < planes->count; p++) {
        const fmpz *form = planes->form + p * (size_t)(d + 1);
        _fmpz_vec_dot(value, form, at, d + 1);
        slong bits = FLINT_ABS(_fmpz_vec_max_bits(form, d)) + 3 - (slong)fmpz_bits(value);
        if (!fmpz_is_zero(value))
            cone->nearest = FLINT_MAX(cone->nearest, bits);
        else if (plane_holds_point(cone, p))
            _fmpz_vec_set(cone->normal + cone->count++ * (size_t)d, form, d);
    }
    return context_poll(context);
}

void cone_clear(local_cone *cone) {
    if (!cone->planes)
        return;
    _fmpz_vec_clear(cone->at, cone->dimension + 1);
    _fmpz_vec_clear(cone->normal, (slong)cone->planes->count * cone->dimension);
    free(cone->known_item);
}

int cone_cell_dimension(const local_cone *cone) {
    LOCAL(fmpz_mat, normals, (slong)cone->count, cone->dimension);
    for (size_t j = 0; j < cone->count; j++)
        for (int i = 0; i < cone->dimension; i++)
            fmpz_set(fmpz_mat_entry(normals, (slong)j, i),
                     cone->normal + j * (size_t)cone->dimension + i);
    return cone->dimension - (int)fmpz_mat_rank(normals);
}

/* Locate a point on the ray that is nearer than every plane that misses the cone's point. If a
 * plane's form has the value v at the cone's point, the ray meets the plane at |v| / |n .
 * direction|, in units of the last coordinate, and |n . direction| < 2^(2 + bits of n + bits of
 * direction). */
static graze_status locate_beside(graze_state *out, const local_cone *cone, graze_context *context,
                                  const fmpz *direction) {
    slong d = cone->dimension, places = cone->nearest + FLINT_ABS(_fmpz_vec_max_bits(direction, d));
    LOCAL_VEC(fmpz, x, d + 1);
    _fmpz_vec_scalar_mul_2exp(x, cone->at, d + 1, (ulong)FLINT_MAX(places, 0));
    _fmpz_vec_add(x, x, direction, d);
    *out = solid_locate(cone->solid, x);
    if (*out == GRAZE_STATE_ABSENT)
        return context_fail(context, GRAZE_EINTERNAL,
                            "the crossings of a ray beside a contact do not add up");
    if (cone->outside && *out != GRAZE_STATE_B)
        *out = *out == GRAZE_STATE_I ? GRAZE_STATE_O : GRAZE_STATE_I;
    return context_poll(context);
}

int cone_knows(graze_state *out, const local_cone *cone, const signed char *signs) {
    size_t width = cone->count + 1;
    for (size_t k = 0; k < cone->known; k++)
        if (memcmp(cone->known_item + k * width, signs, width - 1) == 0) {
            *out = (graze_state)cone->known_item[k * width + width - 1];
            return 1;
        }
    return 0;
}

graze_status cone_state(graze_state *out, local_cone *cone, graze_context *context,
                        const fmpz *direction) {
    size_t width = cone->count + 1;
    TRY(ARRAY_GROW(context, cone->known_item, cone->known_capacity, (cone->known + 1) * width,
                   "the directions of a cone"));
    signed char *signs = cone->known_item + cone->known * width;
    LOCAL(fmpz, value);
    for (size_t j = 0; j < cone->count; j++) {
        _fmpz_vec_dot(value, cone->normal + j * (size_t)cone->dimension, direction,
                      cone->dimension);
        signs[j] = (signed char)fmpz_sgn(value);
    }
    if (cone_knows(out, cone, signs))
        return GRAZE_OK;
    TRY(locate_beside(out, cone, context, direction));
    signs[width - 1] = (signed char)*out;
    cone->known++;
    return GRAZE_OK;
}

/* Add a multiple of the ray to w that is so large that w has the ray's sign at every plane but
 * those along the ray. */
static void add_ray(fmpz *w, const local_cone *cone, const fmpz *ray) {
    slong d = cone->dimension;
    LOCAL(fmpz, at);
    LOCAL(fmpz, most);
    fmpz_set_ui(most, 1);
    for (size_t j = 0; j < cone->count; j++) {
        _fmpz_vec_dot(at, cone->normal + j * (size_t)d, w, d);
        if (fmpz_cmpabs(at, most) > 0)
            fmpz_abs(most, at);
    }
    fmpz_add_ui(most, most, 1);
    _fmpz_vec_scalar_addmul_fmpz(w, ray, d, most);
}

/* Ask the state of the direction u + s e, times the denominator of s. */
static graze_status look_along(int *in_interior, int *in_cone, local_cone *cone,
                               graze_context *context, const fmpz *ray, const fmpz *u,
                               const fmpz *e, const fmpq_t s) {
    graze_state state = GRAZE_STATE_O;
    slong d = cone->dimension;
    LOCAL_VEC(fmpz, w, d);
    _fmpz_vec_scalar_mul_fmpz(w, u, d, fmpq_denref(s));
    _fmpz_vec_scalar_addmul_fmpz(w, e, d, fmpq_numref(s));
    if (ray)
        add_ray(w, cone, ray);
    TRY(cone_state(&state, cone, context, w));
    *in_interior |= state == GRAZE_STATE_I;
    *in_cone |= state != GRAZE_STATE_O;
    return GRAZE_OK;
}

/* The signs of u + s e change only at cuts, so the state is asked at each cut, between two
 * successive cuts, and after the last one. */
graze_status cone_sweep(int *in_interior, int *in_cone, local_cone *cone, graze_context *context,
                        const fmpz *ray, const fmpz *u, const fmpz *e) {
    slong d = cone->dimension, count = 1;
    LOCAL_VEC(fmpq, cut, (slong)cone->count + 1); /* the first cut is 0 */
    LOCAL_VEC(fmpz, a, 2);
    fmpz *b = a + 1;
    LOCAL(fmpq, between);
    for (size_t j = 0; j < cone->count; j++) {
        _fmpz_vec_dot(a, cone->normal + j * (size_t)d, u, d);
        _fmpz_vec_dot(b, cone->normal + j * (size_t)d, e, d);
        fmpz_neg(b, b);
        if (fmpz_sgn(a) * fmpz_sgn(b) > 0)
            fmpq_set_fmpz_frac(cut + count++, a, b);
    }
    _fmpq_vec_sort(cut, count);
    *in_interior = *in_cone = 0;
    for (slong k = 0; k < count && !*in_interior; k++) {
        TRY(look_along(in_interior, in_cone, cone, context, ray, u, e, cut + k));
        if (k + 1 < count) {
            fmpq_add(between, cut + k, cut + k + 1);
            fmpq_div_2exp(between, between, 1);
        } else {
            fmpq_add_si(between, cut + k, 1);
        }
        TRY(look_along(in_interior, in_cone, cone, context, ray, u, e, between));
    }
    return GRAZE_OK;
}

graze_status cone_meets_line(int *out, local_cone *cone, graze_context *context, const fmpz *u,
                             const fmpz *e) {
    slong d = cone->dimension;
    int in_cone = 0;
    LOCAL_VEC(fmpz, back, d);
    _fmpz_vec_neg(back, e, d);
    TRY(cone_sweep(out, &in_cone, cone, context, NULL, u, e));
    if (!*out)
        TRY(cone_sweep(out, &in_cone, cone, context, NULL, u, back));
    return GRAZE_OK;
}
