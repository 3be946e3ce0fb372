/* Trajectories: pullbacks, points, boxes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/trace/trace.h"

#include <math.h>
#include "base/context/scope.h"

void trajectory_init(trajectory *c, int dimension) {
    c->dimension = dimension;
    c->degree = 0;
    for (int i = 0; i <= dimension; i++)
        fmpz_poly_init(&c->x[i]);
}

void trajectory_clear(trajectory *c) {
    for (int i = 0; i <= c->dimension; i++)
        fmpz_poly_clear(&c->x[i]);
}

/* sums = the sum of the polynomials times their factors. */
static void sum_products(fmpz_poly_t sums, const fmpz_poly_struct *p, const fmpz *factor,
                         int count) {
    slong length = 0;
    for (int i = 0; i < count; i++)
        length = FLINT_MAX(length, fmpz_poly_length(&p[i]));
    fmpz_poly_fit_length(sums, length);
    _fmpz_vec_zero(sums->coeffs, length);
    for (int i = 0; i < count; i++)
        for (slong k = 0; k < fmpz_poly_length(&p[i]) && !fmpz_is_zero(factor + i); k++)
            fmpz_addmul(sums->coeffs + k, p[i].coeffs + k, factor + i);
    _fmpz_poly_set_length(sums, length);
    _fmpz_poly_normalise(sums);
}

/* With P = p / q: X_i = sum_j N_ij p_j + N_id q, over q W. */
void trajectory_carry(trajectory *c, const point_map *map, const fmpz *p) {
    int d = c->dimension;
    fmpz_poly_scalar_mul_fmpz(&c->x[d], map->weight, p + d);
    c->degree = fmpz_poly_degree(&c->x[d]);
    for (int i = 0; i < d; i++) {
        sum_products(&c->x[i], &map->entry[i * (d + 1)], p, d + 1);
        c->degree = FLINT_MAX(c->degree, fmpz_poly_degree(&c->x[i]));
    }
}

void trajectory_set(trajectory *c, const point_map *map, const fmpq *point) {
    int d = c->dimension;
    LOCAL_VEC(fmpz, p, d + 1);
    _fmpq_vec_get_fmpz_vec_fmpz(p, p + d, point, d);
    trajectory_carry(c, map, p);
}

void trajectory_pullback(fmpz_poly_t out, const trajectory *c, const fmpz *form) {
    sum_products(out, c->x, form, c->dimension + 1);
}

/* All polynomials are made homogeneous to one degree, so that all values have one factor, a power
 * of u's denominator, which does not count. */
void trajectory_at(fmpz *out, const trajectory *c, const fmpq_t u) {
    const fmpz *p = fmpq_numref(u), *q = fmpq_denref(u);
    LOCAL(fmpz, power);
    for (int i = 0; i <= c->dimension; i++) {
        slong degree = fmpz_poly_degree(&c->x[i]);
        fmpz_pow_ui(power, q, (ulong)(c->degree - (degree < 0 ? 0 : degree)));
        fmpz_zero(out + i);
        for (slong k = degree; k >= 0; k--) {
            fmpz_mul(out + i, out + i, p);
            fmpz_addmul(out + i, c->x[i].coeffs + k, power);
            fmpz_mul(power, power, q);
        }
    }
}

/* m 2^exponent rounded down where `down`, else up; 1/4 < |m| < 4 or m = 0. */
static double scale_outward(double m, slong exponent, int down) {
    const slong safe = 900;
    if (m == 0 || (exponent <= safe && exponent >= -safe))
        return ldexp(m, (int)exponent);
    if (exponent > safe)
        return m > 0 ? (down ? 0x1p899 : INFINITY) : (down ? -INFINITY : -0x1p899);
    return m > 0 ? (down ? 0 : 0x1p-897) : (down ? -0x1p-897 : 0);
}

/* low <= x / w <= high for w > 0. The mantissas and their quotient carry relative errors of a few
 * 2^-52 in any rounding mode, and no operand is subnormal; the margin is 2^-48. */
static void quotient_bounds(double *low, double *high, const fmpz_t x, const fmpz_t w) {
    slong ex, ew;
    double m = fmpz_get_d_2exp(&ex, x) / fmpz_get_d_2exp(&ew, w), margin = fabs(m) * 0x1p-48;
    *low = scale_outward(m - margin, ex - ew, 1);
    *high = scale_outward(m + margin, ex - ew, 0);
}

int trajectory_bound(box *out, const trajectory *c, const fmpz *bernstein) {
    slong n = c->degree + 1;
    const fmpz *w = bernstein + c->dimension * n;
    int positive = 1;
    for (slong j = 0; j < n; j++)
        positive = positive && fmpz_sgn(w + j) > 0;
    *out = (box){{0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < c->dimension; i++) {
        out->low[i] = positive ? INFINITY : -INFINITY;
        out->high[i] = -out->low[i];
        for (slong j = 0; j < n && positive; j++) {
            double low, high;
            quotient_bounds(&low, &high, bernstein + i * n + j, w + j);
            out->low[i] = fmin(out->low[i], low);
            out->high[i] = fmax(out->high[i], high);
        }
    }
    return positive;
}
