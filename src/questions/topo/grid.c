/* Forms composed with maps, on a plane; their discriminants and resultants with respect to time,
 * interpolated on a triangular grid.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The coefficients of time are linear in x and y. The discriminant of degree n is homogeneous in
 * them of degree 2 n - 2, the resultant of degrees n and m of degree n + m. The values of either at
 * (z_i, z_j), with i + j at most its degree and z = 0, 1, -1, 2, -2, ..., determine it, by Newton's
 * divided differences, which are integers, first in y, then in x. The caller can cancel between two
 * values.
 */
#include "base/context/scope.h"
#include "questions/topo/eliminate.h"

void pullback_form_init(pullback_form *f) {
    f->degree = 0;
    for (int i = 0; i < 3; i++)
        fmpz_poly_init(&f->linear[i]);
}

void pullback_form_clear(pullback_form *f) {
    for (int i = 0; i < 3; i++)
        fmpz_poly_clear(&f->linear[i]);
}

void pullback_of_form(pullback_form *f, const point_map *map, const fmpz *form,
                      const plane_view *view) {
    int d = map->dimension;
    LOCAL_VEC(fmpz, scale,
              d + 1); /* the origin's numerators over the common denominator scale[d] */
    LOCAL(fmpz, factor);
    LOCAL(fmpz_poly, column);
    _fmpq_vec_get_fmpz_vec_fmpz(scale, scale + d, view->origin, d);
    for (int i = 0; i < 3; i++)
        fmpz_poly_zero(&f->linear[i]);
    for (int j = 0; j <= d; j++) {
        fmpz_poly_zero(column);
        for (int row = 0; row < d; row++)
            fmpz_poly_scalar_addmul_fmpz(column, &map->entry[row * (d + 1) + j], form + row);
        if (j == d)
            fmpz_poly_scalar_addmul_fmpz(column, map->weight, form + d);
        fmpz_poly_scalar_addmul_fmpz(&f->linear[2], column, scale + j);
        for (int i = 0; i < 2 && j < d; i++) {
            fmpz_mul(factor, view->along[i] + j, scale + d);
            fmpz_poly_scalar_addmul_fmpz(&f->linear[i], column, factor);
        }
    }
}

void pullback_reduce(pullback_form *f, fmpz_poly_t common) {
    f->degree = 0;
    fmpz_poly_zero(common);
    for (int i = 0; i < 3; i++)
        fmpz_poly_gcd(common, common, &f->linear[i]);
    for (int i = 0; i < 3 && !fmpz_poly_is_zero(common); i++) {
        fmpz_poly_div(&f->linear[i], &f->linear[i], common);
        f->degree = FLINT_MAX(f->degree, fmpz_poly_degree(&f->linear[i]));
    }
}

void pullback_at(fmpz_mpoly_t out, const pullback_form *f, const fmpz_t time,
                 const fmpz_mpoly_ctx_t ring) {
    static const ulong power[3][RING_VARIABLES] = {{1, 0}, {0, 1}, {0, 0}};
    LOCAL(fmpz, value);
    fmpz_mpoly_zero(out, ring);
    for (int i = 0; i < 3; i++) {
        fmpz_poly_evaluate_fmpz(value, &f->linear[i], time);
        fmpz_mpoly_set_coeff_fmpz_ui(out, value, power[i], ring);
    }
}

/* State of making a discriminant or, if `g` is set, a resultant. */
typedef struct grid_maker {
    graze_context *context;
    const pullback_form *f, *g;
    slong degree;
    fmpz *value; /* (degree + 1)^2 values, a row for each x; those outside the triangle are 0 */
} grid_maker;

static slong node(slong k) {
    return k % 2 ? (k + 1) / 2 : -k / 2;
}

/* Evaluate the form at a place x, y: a polynomial in time. */
static void function_at(fmpz_poly_t out, const pullback_form *f, slong x, slong y) {
    LOCAL(fmpz_poly, part);
    fmpz_poly_scalar_mul_si(out, &f->linear[0], x);
    fmpz_poly_scalar_mul_si(part, &f->linear[1], y);
    fmpz_poly_add(out, out, part);
    fmpz_poly_add(out, out, &f->linear[2]);
}

/* out *= c^power */
static void multiply_by_power(fmpz_t out, const fmpz_t c, slong power) {
    LOCAL(fmpz, p);
    fmpz_pow_ui(p, c, (ulong)power);
    fmpz_mul(out, out, p);
}

/* The determinant of Sylvester's matrix for degrees n and m, for f and g that may have lower
 * degrees: each degree that f lacks gives a factor (-1)^m lead(g), each that g lacks a factor
 * lead(f). */
static graze_status resultant_of_degrees(fmpz_t out, graze_context *context, const fmpz_poly_t f,
                                         slong n, const fmpz_poly_t g, slong m) {
    slong drop = n - fmpz_poly_degree(f), other = m - fmpz_poly_degree(g);
    fmpz_zero(out);
    if ((drop > 0 && other > 0) || fmpz_poly_is_zero(f) || fmpz_poly_is_zero(g))
        return GRAZE_OK;
    TRY(resultant_of(out, context, f, g));
    multiply_by_power(out, fmpz_poly_lead(g), drop);
    multiply_by_power(out, fmpz_poly_lead(f), other);
    if (drop % 2 == 1 && m % 2 == 1)
        fmpz_neg(out, out);
    return GRAZE_OK;
}

/* The discriminant for degree n: (-1)^(n (n - 1) / 2) Res(f, f') / lead(f). If f has the degree n -
 * 1, it is the discriminant of f times lead(f)^2; if the degree is lower, 0. */
static graze_status discriminant_of_degree(fmpz_t out, graze_context *context, const fmpz_poly_t f,
                                           slong n) {
    slong degree = fmpz_poly_degree(f);
    fmpz_zero(out);
    if (degree < n - 1)
        return GRAZE_OK;
    LOCAL(fmpz_poly, derivative);
    fmpz_poly_derivative(derivative, f);
    TRY(resultant_of(out, context, f, derivative));
    fmpz_divexact(out, out, fmpz_poly_lead(f));
    multiply_by_power(out, fmpz_poly_lead(f), 2 * (n - degree));
    if (degree * (degree - 1) / 2 % 2 == 1)
        fmpz_neg(out, out);
    return GRAZE_OK;
}

static graze_status value_at(fmpz_t out, const grid_maker *m, slong x, slong y) {
    LOCAL(fmpz_poly, f);
    LOCAL(fmpz_poly, g);
    function_at(f, m->f, x, y);
    if (m->g) {
        function_at(g, m->g, x, y);
        TRY(resultant_of_degrees(out, m->context, f, m->f->degree, g, m->g->degree));
    } else {
        TRY(discriminant_of_degree(out, m->context, f, m->f->degree));
    }
    return context_poll(m->context);
}

/* Replace values at the first `count` nodes, `step` entries apart, by divided differences. */
static void divided_differences(fmpz *v, slong count, slong step) {
    LOCAL(fmpz, by);
    for (slong order = 1; order < count; order++)
        for (slong k = count - 1; k >= order; k--) {
            fmpz_sub(v + k * step, v + k * step, v + (k - 1) * step);
            fmpz_set_si(by, node(k) - node(k - order));
            fmpz_divexact(v + k * step, v + k * step, by);
        }
}

/* Replace divided differences by coefficients of powers, by Horner's rule from the last node. */
static void multiply_out(fmpz *v, slong count, slong step) {
    LOCAL(fmpz, by);
    for (slong last = count - 2; last >= 0; last--)
        for (slong k = last; k < count - 1; k++) {
            fmpz_set_si(by, node(last));
            fmpz_submul(v + k * step, by, v + (k + 1) * step);
        }
}

/* Interpolate in y for each x, then in x: a difference of order j in y has the degree `degree` - j
 * in x. */
static graze_status find_coefficients(const grid_maker *m) {
    slong width = m->degree + 1;
    for (slong i = 0; i < width; i++) {
        divided_differences(m->value + i * width, width - i, 1);
        TRY(context_poll(m->context));
    }
    for (slong j = 0; j < width; j++) {
        divided_differences(m->value + j, width - j, width);
        multiply_out(m->value + j, width - j, width);
        TRY(context_poll(m->context));
    }
    for (slong i = 0; i < width; i++) {
        multiply_out(m->value + i * width, width - i, 1);
        TRY(context_poll(m->context));
    }
    return GRAZE_OK;
}

static graze_status interpolate_grid(fmpz_mpoly_t out, grid_maker *m, const fmpz_mpoly_ctx_t ring) {
    slong width = m->degree + 1;
    LOCAL_VEC(fmpz, value, width * width);
    m->value = value;
    for (slong i = 0; i < width; i++)
        for (slong j = 0; i + j < width; j++)
            TRY(value_at(value + i * width + j, m, node(i), node(j)));
    TRY(find_coefficients(m));
    fmpz_mpoly_zero(out, ring);
    for (slong i = 0; i < width; i++)
        for (slong j = 0; i + j < width; j++) {
            ulong e[RING_VARIABLES] = {(ulong)i, (ulong)j};
            fmpz_mpoly_set_coeff_fmpz_ui(out, value + i * width + j, e, ring);
        }
    return GRAZE_OK;
}

graze_status grid_discriminant(fmpz_mpoly_t out, graze_context *context, const pullback_form *f,
                               const fmpz_mpoly_ctx_t ring) {
    grid_maker m = {.context = context, .f = f, .degree = 2 * f->degree - 2};
    return interpolate_grid(out, &m, ring);
}

graze_status grid_resultant(fmpz_mpoly_t out, graze_context *context, const pullback_form *f,
                            const pullback_form *g, const fmpz_mpoly_ctx_t ring) {
    grid_maker m = {.context = context, .f = f, .g = g, .degree = f->degree + g->degree};
    return interpolate_grid(out, &m, ring);
}
