/* Germs of contacts at irrational times.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A number of the field Q(time) is a polynomial modulo the minimal polynomial. Several numbers are
 * rational up to a common factor if their residues are rational multiples of one residue.
 */
#include "questions/topo/eliminate.h"

#include "base/context/scope.h"

/* Polynomials of a larger degree are not factored. */
enum { FACTORED_DEGREE = 60 };

int root_find_minimal(fmpz_poly_t out, const algebraic *time) {
    return fmpz_poly_degree(time->poly) <= FACTORED_DEGREE &&
           algebraic_factor(out, time->poly, &time->where) != 0;
}

int root_is_rational(fmpq_t out, const fmpz_poly_t minimal) {
    if (fmpz_poly_degree(minimal) != 1)
        return 0;
    LOCAL(fmpz, c);
    fmpz_neg(c, fmpz_poly_get_coeff_ptr(minimal, 0));
    fmpq_set_fmpz_frac(out, c, fmpz_poly_get_coeff_ptr(minimal, 1));
    return 1;
}

/* Allocate a germ's root at a time, with zeros as polynomials. */
static graze_status germ_make_root(germ *g, graze_context *context, const algebraic *time) {
    germ_root *root = malloc(sizeof *root + g->cone.count * sizeof *root->way);
    if (!root)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a contact");
    root->count = g->cone.count;
    for (size_t j = 0; j < root->count; j++)
        fmpz_poly_init(root->way + j);
    algebraic_init(&root->time);
    algebraic_set(&root->time, time);
    g->root = root;
    return GRAZE_OK;
}

void germ_drop_root(germ *g) {
    germ_root *root = g->root;
    if (!root)
        return;
    for (size_t j = 0; j < root->count; j++)
        fmpz_poly_clear(root->way + j);
    algebraic_clear(&root->time);
    free(root);
    g->root = NULL;
}

/* Find the rational factor that makes `residue` of `base`; returns 0 if there is none. */
static int multiple_of(fmpq_t out, const fmpq_poly_t residue, const fmpq_poly_t base) {
    slong degree = fmpq_poly_degree(base);
    LOCAL(fmpq, lead);
    LOCAL(fmpq_poly, multiple);
    fmpq_poly_get_coeff_fmpq(lead, base, degree);
    fmpq_poly_get_coeff_fmpq(out, residue, degree);
    fmpq_div(out, out, lead);
    fmpq_poly_scalar_mul_fmpq(multiple, base, out);
    return fmpq_poly_equal(multiple, residue);
}

/* Set coprime integers to a positive multiple of the values of n polynomials at a time; *rational
 * is 0 if there are no such integers. */
static graze_status ratio_of(int *rational, fmpz *out, slong n, const fmpz_poly_struct *p,
                             graze_context *context, algebraic *time, const fmpz_poly_t minimal) {
    int sign = 1;
    LOCAL_VEC(fmpq, ratio, n);
    LOCAL(fmpq_poly, modulus);
    LOCAL(fmpq_poly, residue);
    LOCAL(fmpq_poly, base);
    fmpq_poly_set_fmpz_poly(modulus, minimal);
    *rational = 1;
    for (slong k = 0; k < n && *rational; k++) {
        fmpq_poly_set_fmpz_poly(residue, p + k);
        fmpq_poly_rem(residue, residue, modulus);
        if (fmpq_poly_is_zero(residue))
            continue;
        if (fmpq_poly_is_zero(base)) {
            fmpq_poly_set(base, residue);
            TRY(algebraic_sign_at(&sign, context, p + k, time));
        }
        *rational = multiple_of(ratio + k, residue, base);
        if (sign < 0)
            fmpq_neg(ratio + k, ratio + k);
    }
    direction_of_rationals(out, ratio, n);
    return GRAZE_OK;
}

/* Differentiate the distances from the cone's planes until one is not 0 at the time; *order is the
 * number of derivatives, or 0 if all distances vanish identically. */
static graze_status find_order(slong *order, germ *g, const germ_place *place) {
    germ_root *root = g->root;
    int left = 1, sign = 0;
    *order = 0;
    for (size_t j = 0; j < root->count; j++)
        distance_from_plane(root->way + j, &g->cone, j, place->path);
    while (left && !sign) {
        left = 0;
        for (size_t j = 0; j < root->count; j++) {
            fmpz_poly_derivative(root->way + j, root->way + j);
            left = left || !fmpz_poly_is_zero(root->way + j);
        }
        for (size_t j = 0; j < root->count && !sign; j++)
            TRY(algebraic_sign_at(&sign, place->context, root->way + j, &root->time));
        ++*order;
    }
    *order = sign ? *order : 0;
    return GRAZE_OK;
}

/* Find a direction whose scalar products with the cone's normals are given integers, times a
 * positive factor; returns 0 if there is none. */
static int direction_with_products(fmpz *out, const local_cone *cone, const fmpz *product) {
    slong d = cone->dimension, n = (slong)cone->count;
    LOCAL_VEC(fmpq, x, d);
    LOCAL(fmpq_mat, a, n, d);
    LOCAL(fmpq_mat, b, n, 1);
    LOCAL(fmpq_mat, e, d, 1);
    for (slong j = 0; j < n; j++) {
        for (slong i = 0; i < d; i++)
            fmpq_set_fmpz(fmpq_mat_entry(a, j, i), cone->normal + j * d + i);
        fmpq_set_fmpz(fmpq_mat_entry(b, j, 0), product + j);
    }
    int found = fmpq_mat_can_solve(e, a, b);
    for (slong i = 0; i < d; i++)
        fmpq_set(x + i, fmpq_mat_entry(e, i, 0));
    direction_of_rationals(out, x, d);
    return found;
}

/* Approximate the leading direction by the derivative, near the root, of the displacement from the
 * cone's point. */
static void set_direction_near(germ *g, const germ_place *place, slong order, const fmpq_t near) {
    int d = g->cone.dimension;
    LOCAL_VEC(fmpq, x, d);
    LOCAL(fmpz_poly, way);
    for (int i = 0; i < d; i++) {
        fmpz_poly_scalar_mul_fmpz(way, &place->path->x[i], g->cone.at + d);
        fmpz_poly_scalar_submul_fmpz(way, &place->path->x[d], g->cone.at + i);
        for (slong k = 0; k < order; k++)
            fmpz_poly_derivative(way, way);
        fmpz_poly_evaluate_fmpq(x + i, way, near);
    }
    direction_of_rationals(g->side[0].e, x, d);
}

/* Set the linear part of the inverse map: exactly if it is rational up to a factor, else
 * approximately. */
static graze_status set_map_near(int *rational, germ *g, const germ_place *place,
                                 const fmpz_poly_t minimal, const fmpq_t near) {
    int d = place->map->dimension;
    fmpz_poly_struct entry[9];
    LOCAL_VEC(fmpq, value, d * d);
    for (int i = 0; i < d * d; i++)
        entry[i] = place->map->entry[i / d * (d + 1) + i % d]; /* borrowed */
    TRY(ratio_of(rational, g->to_body, d * d, entry, place->context, &g->root->time, minimal));
    for (int i = 0; i < d * d && !*rational; i++)
        fmpz_poly_evaluate_fmpq(value + i, entry + i, near);
    if (!*rational)
        direction_of_rationals(g->to_body, value, d * d);
    return GRAZE_OK;
}

/* Set the leading direction: exactly if it is rational up to a factor, else approximately. *found
 * is 0 if the direction runs along an edge from a vertex of E^3: the cover then depends on further
 * terms. */
static graze_status set_direction(int *rational, int *found, germ *g, const germ_place *place,
                                  slong order, const fmpz_poly_t minimal, const fmpq_t near) {
    germ_root *root = g->root;
    slong n = (slong)root->count;
    size_t along = 0;
    LOCAL_VEC(fmpz, product, n);
    for (slong j = 0; j < n; j++) {
        int sign = 0;
        TRY(algebraic_sign_at(&sign, place->context, root->way + j, &root->time));
        along += sign == 0;
    }
    *found = along < 2;
    TRY(ratio_of(rational, product, n, root->way, place->context, &root->time, minimal));
    if (*rational)
        *rational = direction_with_products(g->side[0].e, &g->cone, product);
    if (!*rational)
        set_direction_near(g, place, order, near);
    return GRAZE_OK;
}

/* Set both sides; if the order is odd, the direction before the time is opposite to that after it,
 * else equal. */
static void set_sides(germ *g, slong order) {
    int d = g->cone.dimension;
    g->side_count = 2;
    g->side[0].order = g->side[1].order = order;
    g->side[0].sign = 1;
    g->side[1].sign = -1;
    (order % 2 == 1 ? _fmpz_vec_neg : _fmpz_vec_set)(g->side[1].e, g->side[0].e, d);
}

/* Drop the root of a germ whose members are exact, and complete it as at a rational time. */
static void make_exact(germ *g, const germ_place *place) {
    int same_way = 0, on_edge = g->cone.dimension == 3 && cone_cell_dimension(&g->cone) == 1;
    g->exact = planes_keep_directions(&same_way, &g->cone, place->map, place->path);
    for (int s = 0; s < g->side_count; s++) {
        g->side[s].exact = same_way;
        g->side[s].keeps_edge =
            on_edge && (g->side[s].order == 1 || edge_keeps_direction(g, place->map));
    }
    germ_drop_root(g);
}

/* Set all members but the cone; the root is dropped if they are exact. */
static graze_status set_ways(int *found, germ *g, const germ_place *place,
                             const fmpz_poly_t minimal, const fmpq_t near) {
    int map_rational = 0, way_rational = 1;
    slong order = 0;
    TRY(set_map_near(&map_rational, g, place, minimal, near));
    TRY(find_order(&order, g, place));
    if (order) {
        TRY(set_direction(&way_rational, found, g, place, order, minimal, near));
        set_sides(g, order);
    }
    if (*found && map_rational && way_rational)
        make_exact(g, place);
    return GRAZE_OK;
}

graze_status root_set_germ(int *found, germ *g, const germ_place *place, const algebraic *time,
                           const fmpz_poly_t minimal) {
    int d = place->map->dimension;
    LOCAL_VEC(fmpz, x, d + 1);
    LOCAL(fmpq, near);
    HELD(algebraic, at);
    algebraic_set(&at, time);
    TRY(place_find(found, x, near, place, &at));
    if (!*found)
        return GRAZE_OK;
    TRY(cone_make(&g->cone, place->context, place->solid, place->outside, place->planes, x));
    TRY(germ_make_root(g, place->context, &at));
    return set_ways(found, g, place, minimal, near);
}
