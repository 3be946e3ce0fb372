/* Leading directions from the coefficients of a trajectory.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/topo/cover.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* Are two polynomials multiples of one another (0 is a multiple of every polynomial)? */
static int are_proportional(const fmpz_poly_t p, const fmpz_poly_t q) {
    if (fmpz_poly_is_zero(p) || fmpz_poly_is_zero(q))
        return 1;
    LOCAL(fmpz_poly, a);
    LOCAL(fmpz_poly, b);
    fmpz_poly_scalar_mul_fmpz(a, p, fmpz_poly_lead(q));
    fmpz_poly_scalar_mul_fmpz(b, q, fmpz_poly_lead(p));
    return fmpz_poly_equal(a, b);
}

/* Is a pulled back normal a constant vector times a function of time? `factor` is set to that
 * function, up to a number. */
static int keeps_direction(fmpz_poly_t factor, const point_map *map, const fmpz *normal) {
    int same = 1;
    LOCAL_VEC(fmpz_poly, p, 3);
    signs_pull_back_normal(p, map, normal);
    fmpz_poly_zero(factor);
    for (int column = 0; column < map->dimension && same; column++) {
        same = are_proportional(p + column, factor);
        if (fmpz_poly_is_zero(factor))
            fmpz_poly_set(factor, p + column);
    }
    return same;
}

void distance_from_plane(fmpz_poly_t out, const local_cone *cone, size_t j,
                         const trajectory *path) {
    int d = cone->dimension;
    LOCAL_VEC(fmpz, form, d + 1);
    LOCAL(fmpz, at);
    _fmpz_vec_dot(at, cone->normal + j * (size_t)d, cone->at, d);
    _fmpz_vec_scalar_mul_fmpz(form, cone->normal + j * (size_t)d, d, cone->at + d);
    fmpz_neg(form + d, at);
    trajectory_pullback(out, path, form);
}

int planes_keep_directions(int *same_way, const local_cone *cone, const point_map *map,
                           const trajectory *path) {
    enum { FACTOR, WAY, FIRST_FACTOR, FIRST_WAY, LEFT, RIGHT, POLYNOMIALS };
    int keep = 1;
    LOCAL_VEC(fmpz_poly, p, POLYNOMIALS);
    *same_way = 1;
    for (size_t j = 0; j < cone->count && keep; j++) {
        keep = keeps_direction(p + FACTOR, map, cone->normal + j * (size_t)cone->dimension);
        distance_from_plane(p + WAY, cone, j, path);
        fmpz_poly_mul(p + LEFT, p + WAY, p + FIRST_FACTOR);
        fmpz_poly_mul(p + RIGHT, p + FIRST_WAY, p + FACTOR);
        *same_way = *same_way && are_proportional(p + LEFT, p + RIGHT);
        if (fmpz_poly_is_zero(p + FIRST_WAY) && !fmpz_poly_is_zero(p + WAY)) {
            fmpz_poly_swap(p + FIRST_WAY, p + WAY);
            fmpz_poly_swap(p + FIRST_FACTOR, p + FACTOR);
        }
    }
    *same_way = *same_way && keep;
    return keep;
}

static void coefficients_at(fmpz *out, fmpq_poly_struct *way, slong k, int d) {
    LOCAL_VEC(fmpq, c, d);
    for (int i = 0; i < d; i++)
        fmpq_poly_get_coeff_fmpq(c + i, way + i, k);
    direction_of_rationals(out, c, d);
}

/* Is a vector along the cell? *planes is the number of the cone's planes that are parallel to the
 * vector. */
static int is_in_cell(size_t *planes, const local_cone *cone, const fmpz *v) {
    slong d = cone->dimension;
    LOCAL(fmpz, a);
    *planes = 0;
    for (size_t j = 0; j < cone->count; j++) {
        _fmpz_vec_dot(a, cone->normal + j * (size_t)d, v, d);
        *planes += fmpz_is_zero(a) != 0;
    }
    return *planes == cone->count;
}

/* Find the first coefficient after the leading one that is not parallel to the leading one. */
static void find_later(germ_side *side, fmpq_poly_struct *way, slong length, int sign) {
    slong at = 0;
    for (slong k = side->order + 1; k < length && !at; k++) {
        coefficients_at(side->later, way, k, 3);
        at = directions_parallel(side->later, side->e) ? 0 : k;
    }
    side->has_later = at > 0;
    if (sign < 0 && at % 2 == 1)
        _fmpz_vec_neg(side->later, side->later, 3);
}

/* The edge keeps its direction if the direction at the germ's time is parallel to the edge's planes
 * throughout the piece. */
int edge_keeps_direction(const germ *g, const point_map *map) {
    LOCAL_VEC(fmpz, world, 9);
    int keeps = 1;
    LOCAL(fmpz_poly, p);
    for (size_t j = 0; j < 2; j++)
        germ_normal_about(world + 3 * (j + 1), g, g->cone.normal + 3 * j);
    integers_cross(world, world + 3, world + 6);
    for (size_t j = 0; j < g->cone.count && keeps; j++) {
        signs_pull_back(p, map, g->cone.normal + 3 * j, world);
        keeps = fmpz_poly_is_zero(p);
    }
    return keeps;
}

graze_status sides_add(germ *g, graze_context *context, const point_map *map, fmpq_poly_struct *way,
                       int same_way, int sign) {
    int d = map->dimension;
    slong length = 0;
    size_t planes = 0;
    graze_state state = GRAZE_STATE_O;
    germ_side *side = &g->side[g->side_count];
    for (int i = 0; i < d; i++)
        length = FLINT_MAX(length, fmpq_poly_length(way + i));
    for (slong k = 1; k < length && !side->order; k++) {
        coefficients_at(side->e, way, k, d);
        side->order = is_in_cell(&planes, &g->cone, side->e) ? 0 : k;
    }
    if (!side->order)
        return GRAZE_OK;
    g->side_count++;
    side->sign = sign;
    if (sign < 0 && side->order % 2 == 1)
        _fmpz_vec_neg(side->e, side->e, d);
    side->exact = same_way;
    if (d == 3 && cone_cell_dimension(&g->cone) == 1)
        side->keeps_edge = side->order == 1 || edge_keeps_direction(g, map);
    if (planes >= 2 && !side->exact)
        TRY(cone_state(&state, &g->cone, context, side->e));
    if (state != GRAZE_STATE_O)
        find_later(side, way, length, sign);
    return GRAZE_OK;
}
