/* A few planes through a point of space, each examined as E^2 is.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The planes are askew, so that facets seldom come to lie in one of them. If the contacts do not
 * depend on a direction, one plane across it decides (proofs/topology.md C54); if they depend on it
 * only at a step, two planes decide (C128).
 *
 * A path in a plane has the coordinates x = s^m, y = s^(m + 1) p / q. A curve's polynomial along
 * the path is a polynomial in s; below its first positive root the path does not meet the curve.
 */
#include "questions/topo/eliminate.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* Add a normal's coefficients of all powers of time: the common kernel of all normals, which are
 * functions of time, is the kernel of all their coefficients. */
static void span_add_normal(direction_span *s, const point_map *map, const fmpz *normal) {
    slong length = 0;
    LOCAL_VEC(fmpz, v, 3);
    LOCAL_VEC(fmpz_poly, entry, 3);
    signs_pull_back_normal(entry, map, normal);
    for (int i = 0; i < 3; i++)
        length = FLINT_MAX(length, fmpz_poly_length(entry + i));
    for (slong k = 0; k < length; k++) {
        for (int i = 0; i < 3; i++)
            fmpz_poly_get_coeff_fmpz(v + i, entry + i, k);
        direction_span_add(s, v);
    }
}

/* Return 1 and set a plane's normal about the point if the plane does not move and contains the
 * trajectory; else return 0. */
static int plane_stays(fmpz *normal, const germ *g, size_t j, const fmpq *point) {
    LOCAL_VEC(fmpz, basis, 9);
    direction_span s = {0, basis};
    HELD(trajectory, path, 3);
    LOCAL(fmpz_poly, away);
    trajectory_set(&path, g->map, point);
    distance_from_plane(away, &g->cone, j, &path);
    span_add_normal(&s, g->map, g->cone.normal + 3 * j);
    int stays = fmpz_poly_is_zero(away) && s.rank == 1;
    _fmpz_vec_set(normal, s.basis, 3);
    return stays;
}

/* Find a vector of the kernel of all normals; if `step` is not NULL, without the planes across
 * `step` that stay (plane_stays). */
static int find_kernel(fmpz *out, const germ_list *list, const fmpz *step, const fmpq *point) {
    LOCAL_VEC(fmpz, basis, 9);
    direction_span s = {0, basis};
    LOCAL_VEC(fmpz, stays, 3);
    for (size_t k = 0; k < list->count && s.rank < 3; k++) {
        const germ *g = &list->item[k];
        for (size_t j = 0; j < g->cone.count && s.rank < 3; j++)
            if (!step || !plane_stays(stays, g, j, point) || !directions_parallel(stays, step))
                span_add_normal(&s, g->map, g->cone.normal + 3 * j);
    }
    if (s.rank == 1)
        directions_basis(s.basis + 6, s.basis + 3, s.basis);
    int found = s.rank == 1 || s.rank == 2;
    if (found)
        _fmpz_vec_set(out, s.basis + 6, 3);
    return found;
}

/* Find a direction parallel to all planes of all contacts' cones but the ones with the normal
 * `step`, which do not move and contain the trajectory throughout their pieces. Returns 1 if there
 * are such planes and the direction crosses them, else 0 with a zero `step` (proofs/topology.md
 * C128). */
static int invariant_beside_step(fmpz *out, fmpz *step, const germ_list *list, const fmpq *point) {
    int found = 0;
    LOCAL_VEC(fmpz, normal, 3);
    LOCAL(fmpz, product);
    _fmpz_vec_zero(step, 3);
    for (size_t k = 0; k < list->count && !found; k++)
        for (size_t j = 0; j < list->item[k].cone.count && !found; j++) {
            if (!plane_stays(normal, &list->item[k], j, point) || _fmpz_vec_equal(normal, step, 3))
                continue;
            _fmpz_vec_set(step, normal, 3);
            found = find_kernel(out, list, step, point);
            _fmpz_vec_dot(product, step, out, 3);
            found = found && !fmpz_is_zero(product);
        }
    if (!found)
        _fmpz_vec_zero(step, 3);
    return found;
}

enum { SLICES = 3 };

static const slong askew[SLICES][2][3] = {
    {{3, 1, 2}, {-1, 4, 1}}, {{2, -5, 1}, {1, 1, 4}}, {{1, 2, -7}, {5, -2, 3}}};

/* A curve's polynomial along the path, as a polynomial in s, times a power of q. */
static void curve_on_path(fmpz_poly_t out, const fmpz_mpoly_t curve, const topo_finding *f,
                          const fmpz_mpoly_ctx_t ring) {
    slong most = fmpz_mpoly_degree_si(curve, RING_Y, ring);
    LOCAL_VEC(fmpz, c, 3);
    fmpz *power = c + 1, *sum = c + 2;
    fmpz_poly_zero(out);
    for (slong k = 0; k < fmpz_mpoly_length(curve, ring); k++) {
        ulong e[RING_VARIABLES];
        fmpz_mpoly_get_term_exp_ui(e, curve, k, ring);
        fmpz_mpoly_get_term_coeff_fmpz(c, curve, k, ring);
        fmpz_pow_ui(power, fmpq_numref(&f->lift), e[RING_Y]);
        fmpz_mul(c, c, power);
        fmpz_pow_ui(power, fmpq_denref(&f->lift), (ulong)most - e[RING_Y]);
        slong at = f->order * (slong)e[RING_X] + (f->order + 1) * (slong)e[RING_Y];
        fmpz_poly_get_coeff_fmpz(sum, out, at);
        fmpz_addmul(sum, c, power);
        fmpz_poly_set_coeff_fmpz(out, at, sum);
    }
}

/* Take the path's place at s = 2^-places as the witness, if it is out. */
static graze_status try_path(topo_finding *out, graze_context *context, const graze_scene *scene,
                             const plane_view *view, ulong places) {
    int beyond = 0;
    LOCAL_VEC(fmpq, xy, 2);
    fmpq_one(xy);
    fmpq_div_2exp(xy, xy, places * (ulong)out->order);
    fmpq_div_2exp(xy + 1, &out->lift, places * (ulong)(out->order + 1));
    view_point(out->witness, view, xy);
    TRY(beyond_closed(&beyond, context, scene, out->witness));
    if (beyond) {
        finding_set(out, GRAZE_TOPO_BOUNDARY, GRAZE_LEVEL_LEADING_TERMS);
        out->has_witness = 1;
        fmpq_one(&out->reach);
        fmpq_div_2exp(&out->reach, &out->reach, places);
    }
    return GRAZE_OK;
}

/* Try to prove that the point is on the boundary: that the path of its finding is `out` from some
 * place down to the point (proofs/gaps.md C88). The view is the plane through the point along the
 * finding's `open` and `across`; without success the finding is unchanged. */
static graze_status path_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                                const curve_list *curves, const plane_view *view) {
    ulong places = 0;
    LOCAL(fmpz_poly, p);
    for (size_t k = 0; k < curves->count; k++) {
        TRY(context_poll(context));
        curve_on_path(p, &curves->item[k], out, curves->ring);
        if (fmpz_poly_is_zero(p))
            return GRAZE_OK;
        places_below_roots(&places, p);
        if (places > context->limits[GRAZE_LIMIT_BITS])
            return GRAZE_OK;
    }
    return try_path(out, context, scene, view, places);
}

/* Examine the plane through the point along two directions, 6 integers; first the finding's path,
 * if it lies in the plane. */
static graze_status look_in_plane(topo_finding *out, graze_context *context,
                                  const graze_scene *scene, const plane_list *planes,
                                  const fmpq *point, const fmpz *along, graze_topo_level level,
                                  int has_path) {
    const char *refused = NULL;
    fmpq origin[2] = {{0, 1}, {0, 1}};
    HELD(plane_view, view);
    view_set_through(&view, point, along, along + 3);
    HELD(curve_list, curves);
    TRY(curves_of_scene(&curves, &refused, context, scene, planes, &view));
    if (!refused && has_path)
        TRY(path_decide(out, context, scene, &curves, &view));
    if (!refused && !out->has_witness)
        TRY(square_decide(out, context, scene, &curves, &view, origin, level));
    return GRAZE_OK;
}

/* Find a direction that is parallel to all planes of all contacts at all times but perhaps the
 * planes with the normal `step`. The direction is 0 if there is none; the step is 0 if no plane has
 * to be left out. */
static graze_status find_invariant(fmpz *out, fmpz *step, graze_context *context,
                                   const graze_scene *scene, const plane_list *planes,
                                   const fmpq *point) {
    HELD(germ_list, germs);
    TRY(germs_find(&germs, context, scene, planes, point));
    if (!germs.bounded ||
        (!find_kernel(out, &germs, NULL, NULL) && !invariant_beside_step(out, step, &germs, point)))
        _fmpz_vec_zero(out, 3);
    return GRAZE_OK;
}

/* Does a plane along two directions, 6 integers, cross a third one? */
static int crosses(const fmpz *along, const fmpz *direction) {
    LOCAL_VEC(fmpz, normal, 3);
    LOCAL(fmpz, product);
    integers_cross(normal, along, along + 3);
    _fmpz_vec_dot(product, normal, direction, 3);
    return !fmpz_is_zero(product);
}

static int is_decided(const topo_finding *f) {
    return f->position == GRAZE_TOPO_INTERIOR || f->position == GRAZE_TOPO_BOUNDARY;
}

/* Decide by two planes through a line in the step's plane, one leaning to each side of it: on
 * either side of the step the contacts do not depend on the direction `invariant` (C128). */
static graze_status decide_beside_step(topo_finding *out, graze_context *context,
                                       const graze_scene *scene, const plane_list *planes,
                                       const fmpq *point, const fmpz *step, const fmpz *invariant) {
    LOCAL_VEC(fmpz, along, 6);
    directions_basis(along, along + 3, step);
    _fmpz_vec_add(along + 3, along + 3, invariant, 3);
    for (int side = 0; side < 2 && (!side || out->position == GRAZE_TOPO_INTERIOR); side++) {
        finding_undecided(out, out->reason);
        TRY(look_in_plane(out, context, scene, planes, point, along, GRAZE_LEVEL_SECTION, 0));
        _fmpz_vec_scalar_submul_si(along + 3, invariant, 3, 2);
    }
    return GRAZE_OK;
}

graze_status slices_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                           const plane_list *planes, const fmpq *point) {
    const char *reason = out->reason;
    LOCAL_VEC(fmpz, along, 12);
    fmpz *invariant = along + 6, *step = along + 9;
    TRY(find_invariant(invariant, step, context, scene, planes, point));
    int has_gap = out->order > 0, has_step = !_fmpz_vec_is_zero(step, 3);
    for (int k = has_gap ? -1 : 0; k < SLICES && !is_decided(out); k++) {
        for (int i = 0; i < 6; i++)
            fmpz_set_si(along + i, askew[FLINT_MAX(k, 0)][i / 3][i % 3]);
        if (k < 0)
            _fmpz_vec_set(along + 3, out->across, 3);
        if (k < 0 || (out->has_open && !has_gap))
            _fmpz_vec_set(along, out->open, 3);
        if (directions_parallel(along, along + 3))
            continue;
        int decides = !has_step && crosses(along, invariant);
        TRY(look_in_plane(out, context, scene, planes, point, along,
                          decides ? GRAZE_LEVEL_SECTION : GRAZE_LEVEL_CURVES, k < 0));
    }
    if (!is_decided(out) && has_step)
        TRY(decide_beside_step(out, context, scene, planes, point, step, invariant));
    if (is_decided(out))
        out->reason = "";
    else
        finding_undecided(out, reason);
    return GRAZE_OK;
}
