/* The planes of germs, their common rays, and the cells around a ray.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * More planes than needed do no harm, so the coordinate planes are added: then the planes meet in
 * rays.
 */
#include "questions/topo/cover.h"

#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/vector.h"

void borders_init(borders *b, int dimension) {
    memset(b, 0, sizeof *b);
    b->dimension = dimension;
}

static void clear_vectors(fmpz *vectors, size_t count, int dimension) {
    _fmpz_vec_zero(vectors, (slong)count * dimension);
    free(vectors);
}

void borders_clear(borders *b) {
    clear_vectors(b->plane, b->plane_count, b->dimension);
    clear_vectors(b->ray, b->ray_count, b->dimension);
}

/* out = a turned by a right angle counter-clockwise, in E^2; `out` is not a. */
static void turn_quarter(fmpz *out, const fmpz *a) {
    fmpz_neg(out, a + 1);
    fmpz_set(out + 1, a);
}

/* Append a copy of a vector unless the list has it. */
static graze_status add_vector(fmpz **list, size_t *count, size_t *capacity, graze_context *context,
                               const fmpz *v, int d) {
    for (size_t k = 0; k < *count; k++)
        if (_fmpz_vec_equal(*list + k * (size_t)d, v, d))
            return GRAZE_OK;
    TRY(array_grow(context, list, capacity, (*count + 1) * (size_t)d, sizeof **list,
                   "the cells about a point"));
    for (int i = 0; i < d; i++)
        fmpz_init_set(*list + *count * (size_t)d + i, v + i);
    ++*count;
    return GRAZE_OK;
}

/* Add the plane with a normal, which is reduced in place; a zero normal adds no plane. */
static graze_status add_border(borders *b, graze_context *context, fmpz *normal) {
    int d = b->dimension, sign = 0;
    direction_reduce(normal, d);
    for (int i = 0; i < d && !sign; i++)
        sign = fmpz_sgn(normal + i);
    if (!sign)
        return GRAZE_OK;
    if (sign < 0)
        _fmpz_vec_neg(normal, normal, d);
    return add_vector(&b->plane, &b->plane_count, &b->plane_capacity, context, normal, d);
}

/* Add a plane, given by its normal in the germ's body, as a plane of directions about P. */
static graze_status add_body_border(borders *b, graze_context *context, const germ *g,
                                    const fmpz *normal) {
    LOCAL_VEC(fmpz, n, b->dimension);
    germ_normal_about(n, g, normal);
    return add_border(b, context, n);
}

/* Add the planes that the edges of the cone sweep along e. Two planes of the cone meet in an edge
 * only if their common ray or its opposite is on the cone's boundary. */
static graze_status add_swept_edges(borders *b, graze_context *context, germ *g, const fmpz *e) {
    int d = b->dimension;
    LOCAL_VEC(fmpz, ray, d);
    LOCAL_VEC(fmpz, normal, d);
    if (d == 2) {
        turn_quarter(normal, e);
        return add_body_border(b, context, g, normal);
    }
    for (size_t i = 0; i < g->cone.count; i++)
        for (size_t j = 0; j < i; j++) {
            graze_state state[2] = {GRAZE_STATE_O, GRAZE_STATE_O};
            integers_cross(ray, g->cone.normal + 3 * i, g->cone.normal + 3 * j);
            for (int k = 0; k < 2; k++) {
                TRY(cone_state(&state[k], &g->cone, context, ray));
                _fmpz_vec_neg(ray, ray, d);
            }
            integers_cross(normal, e, ray);
            if (state[0] == GRAZE_STATE_B || state[1] == GRAZE_STATE_B)
                TRY(add_body_border(b, context, g, normal));
        }
    return GRAZE_OK;
}

static graze_status add_germ_borders(borders *b, graze_context *context, germ *g) {
    LOCAL_VEC(fmpz, normal, 3);
    for (size_t j = 0; j < g->cone.count; j++)
        TRY(add_body_border(b, context, g, g->cone.normal + j * (size_t)b->dimension));
    for (int s = 0; s < g->side_count; s++) {
        const germ_side *side = &g->side[s];
        TRY(add_swept_edges(b, context, g, side->e));
        if (!side->has_later)
            continue;
        integers_cross(normal, side->e,
                       side->later); /* normal of the plane along the edge and `later` */
        TRY(add_body_border(b, context, g, normal));
    }
    return GRAZE_OK;
}

static graze_status add_axes(borders *b, graze_context *context) {
    LOCAL_VEC(fmpz, axis, b->dimension);
    for (int i = 0; i < b->dimension; i++) {
        _fmpz_vec_zero(axis, b->dimension);
        fmpz_one(axis + i);
        TRY(add_border(b, context, axis));
    }
    return GRAZE_OK;
}

/* Add both rays in which planes i and j meet; in E^2 both rays of line i. */
static graze_status add_rays(borders *b, graze_context *context, size_t i, size_t j) {
    int d = b->dimension;
    LOCAL_VEC(fmpz, ray, d);
    if (d == 2)
        turn_quarter(ray, b->plane + i * 2);
    else
        integers_cross(ray, b->plane + i * 3, b->plane + j * 3);
    direction_reduce(ray, d);
    for (int k = 0; k < 2; k++) {
        TRY(add_vector(&b->ray, &b->ray_count, &b->ray_capacity, context, ray, d));
        _fmpz_vec_neg(ray, ray, d);
    }
    return GRAZE_OK;
}

/* Find all rays of an arrangement. */
static graze_status find_rays(borders *b, int *refused, graze_context *context) {
    for (size_t i = 0; i < b->plane_count && !*refused; i++) {
        if (b->dimension == 2)
            TRY(add_rays(b, context, i, i));
        for (size_t j = 0; b->dimension == 3 && j < i; j++)
            TRY(add_rays(b, context, i, j));
        *refused = b->ray_count > BORDER_RAYS;
        TRY(context_poll(context));
    }
    return GRAZE_OK;
}

graze_status borders_find(borders *b, int *refused, graze_context *context, germ_list *germs) {
    *refused = 0;
    TRY(add_axes(b, context));
    for (size_t k = 0; k < germs->count && !*refused; k++) {
        TRY(add_germ_borders(b, context, &germs->item[k]));
        *refused = b->plane_count > BORDER_PLANES;
    }
    return *refused ? GRAZE_OK : find_rays(b, refused, context);
}

graze_status borders_of_cone(borders *b, int *refused, graze_context *context,
                             const local_cone *cone) {
    slong d = cone->dimension;
    *refused = 0;
    LOCAL_VEC(fmpz, normal, d);
    TRY(add_axes(b, context));
    for (size_t j = 0; j < cone->count; j++) {
        _fmpz_vec_set(normal, cone->normal + j * (size_t)d, d);
        TRY(add_border(b, context, normal));
    }
    return find_rays(b, refused, context);
}

/* Add the planes of `all` that contain a direction, and the planes through it and the axes, so that
 * two are independent. */
static graze_status keep_planes_through(borders *b, graze_context *context, const borders *all,
                                        const fmpz *direction) {
    LOCAL_VEC(fmpz, normal, 6);
    fmpz *axis = normal + 3;
    LOCAL(fmpz, at);
    for (size_t p = 0; p < all->plane_count; p++) {
        _fmpz_vec_dot(at, all->plane + 3 * p, direction, 3);
        _fmpz_vec_set(normal, all->plane + 3 * p, 3);
        if (fmpz_is_zero(at))
            TRY(add_border(b, context, normal));
    }
    for (int i = 0; i < 3; i++) {
        _fmpz_vec_zero(axis, 3);
        fmpz_one(axis + i);
        integers_cross(normal, direction, axis);
        TRY(add_border(b, context, normal));
    }
    return GRAZE_OK;
}

graze_status borders_about(borders *b, graze_context *context, germ *g, const fmpz *direction) {
    fmpz to_world[9];
    HELD(borders, all, 3);
    memcpy(to_world, g->to_body, sizeof to_world);
    for (int i = 0; i < 9; i++)
        g->to_body[i] = i % 4 == 0; /* in directions of the body itself */
    graze_status status = add_germ_borders(&all, context, g);
    memcpy(g->to_body, to_world, sizeof to_world);
    TRY(status);
    TRY(keep_planes_through(b, context, &all, direction));
    return add_vector(&b->ray, &b->ray_count, &b->ray_capacity, context, direction, 3);
}

/* out = v + s w, times a denominator, with s > 0 so small that no plane is crossed but those
 * through v. */
static void step_from_ray(fmpz *out, const borders *b, const fmpz *v, const fmpz *w) {
    int d = b->dimension;
    LOCAL_VEC(fmpq, s, 2);
    fmpq *most = s + 1;
    LOCAL_VEC(fmpz, at, 2);
    fmpz *slope = at + 1;
    fmpq_one(most);
    for (size_t p = 0; p < b->plane_count; p++) {
        _fmpz_vec_dot(at, b->plane + p * (size_t)d, v, d);
        _fmpz_vec_dot(slope, b->plane + p * (size_t)d, w, d);
        if (fmpz_is_zero(at) || fmpz_is_zero(slope))
            continue;
        fmpq_set_fmpz_frac(s, at, slope);
        fmpq_abs(s, s);
        fmpq_div_2exp(s, s, 1);
        if (fmpq_cmp(s, most) < 0)
            fmpq_set(most, s);
    }
    _fmpz_vec_scalar_mul_fmpz(out, v, d, fmpq_denref(most));
    _fmpz_vec_scalar_addmul_fmpz(out, w, d, fmpq_numref(most));
}

/* The sign of det(v, a, b): is b to the left of a, seen against v? */
static int turn_about_ray(const fmpz *v, const fmpz *a, const fmpz *b) {
    LOCAL_VEC(fmpz, cross, 3);
    LOCAL(fmpz, det);
    integers_cross(cross, a, b);
    _fmpz_vec_dot(det, cross, v, 3);
    return fmpz_sgn(det);
}

/* The direction that follows number `from` by angle, of `count` directions across the ray v. Two of
 * these directions are independent, and each has its opposite among them. */
static size_t next_around(const fmpz *v, const fmpz *across, size_t count, size_t from) {
    size_t best = from;
    for (size_t k = 0; k < count; k++)
        if (turn_about_ray(v, across + 3 * from, across + 3 * k) > 0 &&
            (best == from || turn_about_ray(v, across + 3 * k, across + 3 * best) > 0))
            best = k;
    return best;
}

/* The directions across the ray v in each plane through it; `out` has room for two a plane. */
static size_t directions_across(fmpz *out, const borders *b, const fmpz *v) {
    size_t count = 0;
    LOCAL(fmpz, at);
    for (size_t p = 0; p < b->plane_count; p++) {
        _fmpz_vec_dot(at, b->plane + 3 * p, v, 3);
        if (!fmpz_is_zero(at))
            continue;
        integers_cross(out + 3 * count, v, b->plane + 3 * p);
        _fmpz_vec_neg(out + 3 * (count + 1), out + 3 * count, 3);
        count += 2;
    }
    return count;
}

static void cells_around_in_space(ray_cells *out, const borders *b, const fmpz *v) {
    LOCAL_VEC(fmpz, across, (slong)b->plane_count * 6);
    LOCAL_VEC(fmpz, middle, 3);
    size_t n = directions_across(across, b, v), at = 0;
    *out = (ray_cells){3, 2 * n, _fmpz_vec_init((slong)n * 6)};
    for (size_t k = 0; k < n; k++) {
        size_t next = next_around(v, across, n, at);
        _fmpz_vec_add(middle, across + 3 * at, across + 3 * next, 3);
        step_from_ray(out->item + 6 * k, b, v, middle);
        step_from_ray(out->item + 6 * k + 3, b, v, across + 3 * next);
        at = next;
    }
}

void ray_cells_init(ray_cells *out, const borders *b, size_t r) {
    const fmpz *v = b->ray + r * (size_t)b->dimension;
    if (b->dimension == 3) {
        cells_around_in_space(out, b, v);
        return;
    }
    LOCAL_VEC(fmpz, w, 2);
    *out = (ray_cells){2, 2, _fmpz_vec_init(4)};
    turn_quarter(w, v);
    step_from_ray(out->item, b, v, w);
    _fmpz_vec_neg(w, w, 2);
    step_from_ray(out->item + 2, b, v, w);
}

void ray_cells_clear(ray_cells *cells) {
    _fmpz_vec_clear(cells->item, (slong)cells->count * cells->dimension);
}
