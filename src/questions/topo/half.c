/* The half germs of facets that pass along a plane and of edges that pass in it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/topo/cover.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* A plane of a cone as an affine function value + r . place of places about the point, expanded in
 * powers of the time since the contact: of r the coefficients r0 and r1 are kept, of `value` two
 * from a given power on; all before these are 0. */
typedef struct plane_ways {
    fmpq *value;     /* 2 rationals; the normals stand behind them */
    fmpq *normal[2]; /* r0 and r1, 3 rationals each */
} plane_ways;

enum { WAYS_ENTRIES = 8 };

static void plane_ways_clear(plane_ways *w) {
    _fmpq_vec_clear(w->value, WAYS_ENTRIES);
}

/* Set two coefficients, from a given power on, of p / scale in powers of the time since u. */
static void expand_at(fmpq *out, const fmpz_poly_t p, const fmpz_t scale, const fmpq_t u,
                      slong power) {
    LOCAL(fmpq_poly, q);
    LOCAL(fmpq_poly, later);
    fmpq_poly_set_coeff_fmpq(later, 0, u);
    fmpq_poly_set_coeff_si(later, 1, 1);
    fmpq_poly_set_fmpz_poly(q, p);
    fmpq_poly_compose(q, q, later);
    fmpq_poly_scalar_div_fmpz(q, q, scale);
    for (int k = 0; k < 2; k++)
        fmpq_poly_get_coeff_fmpq(out + k, q, power + k);
}

/* Expand plane j of a germ at its time; the kept powers of `value` begin with `order`. */
static void plane_ways_init(plane_ways *w, const germ *g, size_t j, slong order,
                            const fmpq *point) {
    LOCAL_VEC(fmpz_poly, p, 3);
    LOCAL_VEC(fmpz, place, 5);
    fmpz *scale = place + 4;
    LOCAL_VEC(fmpq, part, 2);
    HELD(trajectory, path, 3);
    w->value = _fmpq_vec_init(WAYS_ENTRIES);
    w->normal[0] = w->value + 2;
    w->normal[1] = w->value + 5;
    _fmpq_vec_get_fmpz_vec_fmpz(place, place + 3, point, 3);
    trajectory_carry(&path, g->map, place);
    distance_from_plane(p, &g->cone, j, &path);
    fmpz_mul(scale, place + 3, g->cone.at + 3);
    expand_at(w->value, p, scale, &g->time, order);
    const fmpz one = 1;
    signs_pull_back_normal(p, g->map, g->cone.normal + 3 * j);
    for (int i = 0; i < 3; i++) {
        expand_at(part, p + i, &one, &g->time, 0);
        for (int k = 0; k < 2; k++)
            fmpq_swap(w->normal[k] + i, part + k);
    }
}

/* Write the linear form x -> normal . x on the plane as a polynomial in b, by its values at the
 * basis. */
static void linear_on_plane(fmpq_poly_t out, const open_plane *h, const fmpq *normal) {
    LOCAL(fmpq, value);
    fmpq_poly_zero(out);
    for (int i = 0; i < 2; i++) {
        vector_dot_integers(value, h->basis[i], normal, 3);
        fmpq_poly_set_coeff_fmpq(out, i, value);
    }
}

void signed_power(fmpq_t out, const fmpq_t v, slong n) {
    int sign = fmpq_sgn(v);
    fmpq_pow_si(out, v, n);
    if (sign < 0 && n % 2 == 0)
        fmpq_neg(out, out);
}

/* Set the form of a facet along the plane that a side meets with the order n = m + 1 >= 2. With g
 * the first kept coefficient of `value`, o the sign of g t^n on the side, s the sign of the side's
 * time t and L = -o s r1 x, the form is o (m / n)^m L^n / (n |g| (r0 N) |r0 N|^(m - 1)); it is
 * valid where L is not negative. */
static int form_of_facet(half_germ *out, const open_plane *h, const germ *g,
                         const germ_side *side) {
    slong n = side->order;
    if (n < 2)
        return 0;
    HELD(plane_ways, w, g, 0, n, h->point);
    int f_sign = fmpq_sgn(w.value) * (n % 2 == 1 ? side->sign : 1);
    LOCAL_VEC(fmpq, factor, 2);
    fmpq *scale = factor + 1;
    linear_on_plane(out->turn, h, w.normal[1]);
    if (f_sign * side->sign > 0)
        fmpq_poly_neg(out->turn, out->turn);
    out->has_turn = 1;
    out->order = n - 1;
    vector_dot_integers(scale, h->normal, w.normal[0], 3);
    signed_power(scale, scale, n - 1);
    fmpq_abs(factor, w.value);
    fmpq_mul(scale, scale, factor);
    fmpq_mul_si(scale, scale, f_sign * n);
    fmpq_set_si(factor, n - 1, (ulong)n);
    fmpq_pow_si(factor, factor, n - 1);
    fmpq_div(factor, factor, scale);
    fmpq_poly_pow(out->form, out->turn, (ulong)n);
    fmpq_poly_scalar_mul_fmpq(out->form, out->form, factor);
    return 1;
}

/* Set the form -X L^m / ((r0 N) |r0 N|^(m - 1)), with X = -(r0 of p) x / (first value of p) as
 * `reach` and L = g X + r1 x as `turn`; g, r0 and r1 are those of `both`. */
static void form_of_ways(half_germ *out, const open_plane *h, const plane_ways *both,
                         const plane_ways *p, slong order) {
    LOCAL(fmpq, factor);
    LOCAL(fmpq_poly, part);
    linear_on_plane(out->reach, h, p->normal[0]);
    fmpq_poly_scalar_div_fmpq(out->reach, out->reach, p->value);
    fmpq_poly_neg(out->reach, out->reach);
    fmpq_poly_scalar_mul_fmpq(part, out->reach, both->value + 1);
    linear_on_plane(out->turn, h, both->normal[1]);
    fmpq_poly_add(out->turn, out->turn, part);
    fmpq_poly_pow(out->form, out->turn, (ulong)order);
    fmpq_poly_mul(out->form, out->form, out->reach);
    vector_dot_integers(factor, h->normal, both->normal[0], 3);
    signed_power(factor, factor, order);
    fmpq_neg(factor, factor);
    fmpq_poly_scalar_div_fmpq(out->form, out->form, factor);
}

/* Set the form of an edge met with an order, from the combination of the edge's two planes that
 * does not depend on time up to that order; returns 0 if the tangent plane of the edge's path is
 * not the plane h. */
static int form_of_edge(half_germ *out, const open_plane *h, const germ *g, size_t other,
                        slong order) {
    LOCAL_VEC(fmpz, across, 3);
    HELD(plane_ways, p, g, 0, order, h->point);
    HELD(plane_ways, q, g, other, order, h->point);
    HELD(plane_ways, both, g, 0, order, h->point);
    for (int k = 0; k < WAYS_ENTRIES; k++) {
        fmpq_mul(both.value + k, q.value, p.value + k);
        fmpq_submul(both.value + k, p.value, q.value + k);
    }
    direction_of_rationals(across, both.normal[0], 3);
    int lies = directions_parallel(across, h->normal);
    if (lies)
        form_of_ways(out, h, &both, fmpq_is_zero(p.value) ? &q : &p, order);
    out->order = order;
    return lies;
}

/* Set the form of an edge for one side, valid where s^m X > 0 with s the sign of the side's time.
 * An even m has two parts: L >= 0 with the form times s and, `turned`, L <= 0 with the form times
 * -s. */
static int form_of_edge_side(half_germ *out, const open_plane *h, const germ *g, size_t other,
                             const germ_side *side, int turned) {
    int odd = side->order % 2 == 1, flips = (side->sign < 0) != turned;
    if ((odd && turned) || !form_of_edge(out, h, g, other, side->order))
        return 0;
    out->has_reach = 1;
    out->has_turn = !odd;
    if (odd && side->sign < 0)
        fmpq_poly_neg(out->reach, out->reach);
    if (!odd && turned)
        fmpq_poly_neg(out->turn, out->turn);
    if (!odd && flips)
        fmpq_poly_neg(out->form, out->form);
    return 1;
}

/* Is the germ's facet, which holds the trajectory's place, parallel to the plane? */
static int is_along_plane(const open_plane *h, const germ *g) {
    LOCAL_VEC(fmpz, across, 3);
    germ_normal_about(across, g, g->cone.normal);
    return directions_parallel(across, h->normal);
}

/* Set the order and the form that a way gives; returns 0 if the way gives no form. */
static int form_of_germ(half_germ *out, const open_plane *h, const germ *g, int way) {
    int cell = g->root || !g->has_time ? 0 : cone_cell_dimension(&g->cone);
    int s = (way - 1) / 2, turned = way > 0 && way % 2 == 0;
    size_t other = 1;
    if (way > 0 && s >= g->side_count)
        return 0;
    out->order = 1;
    if (cell == 2 && is_along_plane(h, g))
        return way == 0 || (!turned && form_of_facet(out, h, g, &g->side[s]));
    if (cell != 1 || (way == 0) != (g->side_count == 2 && g->side[0].order % 2 == 1))
        return 0;
    while (directions_parallel(g->cone.normal, g->cone.normal + 3 * other))
        other++;
    return way == 0 ? form_of_edge(out, h, g, other, g->side[0].order)
                    : form_of_edge_side(out, h, g, other, &g->side[s], turned);
}

/* Does the interior of a germ's cone have a direction on one side of the plane: the normal or, at
 * an edge, the normal plus a multiple of the leading direction, which lies in the plane? */
static graze_status closes_side(int *out, const open_plane *h, graze_context *context, germ *g,
                                int sign) {
    graze_state state = GRAZE_STATE_O;
    LOCAL_VEC(fmpz, u, 3);
    germ_to_body(u, g, h->normal);
    _fmpz_vec_scalar_mul_si(u, u, 3, sign);
    if (cone_cell_dimension(&g->cone) == 1)
        return cone_meets_line(out, &g->cone, context, u, g->side[0].e);
    TRY(cone_state(&state, &g->cone, context, u));
    *out = state == GRAZE_STATE_I;
    return GRAZE_OK;
}

graze_status half_of_germ(int *found, half_germ *out, const open_plane *h, graze_context *context,
                          germ *g, int sign, int way) {
    *found = 0;
    out->above = sign > 0;
    if (form_of_germ(out, h, g, way))
        TRY(closes_side(found, h, context, g, sign));
    return GRAZE_OK;
}
