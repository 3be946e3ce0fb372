/* Point maps and their derivatives at one rational time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/strata.h"

#include <math.h>
#include "base/context/scope.h"

/* The derivative of p of the given order at a / b, times a power of the denominator; b[n] is the
 * n-th power of it. */
static void evaluate(fmpz_t out, const fmpz_poly_struct *p, const fmpz_t a, const fmpz *b,
                     slong degree, slong order) {
    LOCAL(fmpz, c);
    fmpz_zero(out);
    for (slong n = fmpz_poly_degree(p); n >= order; n--) {
        fmpz_poly_get_coeff_fmpz(c, p, n);
        for (slong k = 0; k < order; k++)
            fmpz_mul_si(c, c, n - k);
        fmpz_mul(out, out, a);
        fmpz_addmul(out, c, b + (degree - n + order));
    }
}

/* The derivative of a point map of the given order at u, times a power of u's denominator; the
 * weight's row is last. */
static void evaluate_rows(fmpz *out, const point_map *map, const fmpq_t u, slong order) {
    int d = map->dimension, entries = d * (d + 1);
    slong degree = fmpz_poly_degree(map->weight);
    for (int e = 0; e < entries; e++)
        if (fmpz_poly_degree(&map->entry[e]) > degree)
            degree = fmpz_poly_degree(&map->entry[e]);
    LOCAL_VEC(fmpz, power, degree + order + 1);
    fmpz_one(power);
    for (slong n = 1; n <= degree + order; n++)
        fmpz_mul(power + n, power + n - 1, fmpq_denref(u));
    for (int e = 0; e < entries; e++)
        evaluate(out + e, &map->entry[e], fmpq_numref(u), power, degree, order);
    _fmpz_vec_zero(out + entries, d);
    evaluate(out + entries + d, map->weight, fmpq_numref(u), power, degree, order);
}

/* Entry j of a row vector times a square matrix. */
static void row_entry(fmpz_t out, const fmpz *row, const fmpz *matrix, int j, int size) {
    fmpz_mul(out, row, matrix + j);
    for (int k = 1; k < size; k++)
        fmpz_addmul(out, row + k, matrix + k * size + j);
}

/* Set `carried`: the derivatives of the tracing map times the placing map. */
static void carry(instant *i, const point_map *tracing, const point_map *placing) {
    int size = i->dimension + 1;
    LOCAL_VEC(fmpz, place, size * size);
    LOCAL_VEC(fmpz, derivative, size * size);
    evaluate_rows(place, placing, i->u, 0);
    for (int k = 0; k < INSTANT_DERIVATIVES; k++) {
        i->carried[k] = _fmpz_vec_init(size * size);
        evaluate_rows(derivative, tracing, i->u, k + 1);
        for (int e = 0; e < size * size; e++)
            row_entry(i->carried[k] + e, derivative + e / size * size, place, e % size, size);
    }
}

/* Set doubles to the numbers, all scaled by one power of 2; returns 0 if a number is too small
 * beside the largest. */
static int scale_to_doubles(double *out, const fmpz *numbers, int count) {
    slong largest = FLINT_ABS(_fmpz_vec_max_bits(numbers, count)), exponent;
    for (int k = 0; k < count; k++) {
        double mantissa = fmpz_get_d_2exp(&exponent, numbers + k);
        if (mantissa != 0 && exponent - largest < -900)
            return 0;
        out[k] = mantissa != 0 ? ldexp(mantissa, (int)(exponent - largest)) : 0;
    }
    return 1;
}

void instant_init(instant *i, const graze_scene *scene, size_t piece, const fmpq_t u) {
    const graze_motion *motion = scene->motion;
    int d = motion->dimension;
    const motion_piece *p = &motion->piece[piece];
    const point_map *tracing = motion_tracing(p, scene->options.operation);
    i->dimension = d;
    i->piece = piece;
    fmpq_init(i->u);
    fmpq_init(i->t);
    fmpq_set(i->u, u);
    motion_time_at(i->t, p, u);
    i->map = _fmpq_vec_init(d * (d + 1));
    point_map_at(i->map, motion_placing(p, scene->options.operation), u);
    i->inverse = _fmpz_vec_init((d + 1) * (d + 1));
    evaluate_rows(i->inverse, tracing, u, 0);
    carry(i, tracing, motion_placing(p, scene->options.operation));
    i->bounded = scale_to_doubles(i->velocity, i->carried[0], (d + 1) * (d + 1));
}

void instant_clear(instant *i) {
    int d = i->dimension;
    fmpq_clear(i->u);
    fmpq_clear(i->t);
    _fmpq_vec_clear(i->map, d * (d + 1));
    _fmpz_vec_clear(i->inverse, (d + 1) * (d + 1));
    for (int k = 0; k < INSTANT_DERIVATIVES; k++)
        _fmpz_vec_clear(i->carried[k], (d + 1) * (d + 1));
}

void instant_pullback(fmpz *out, const instant *i, const fmpz *form, int k) {
    for (int j = 0; j <= i->dimension; j++)
        row_entry(out + j, form, i->carried[k - 1], j, i->dimension + 1);
}

void instant_normal(fmpq *out, const instant *i, const fmpz *form) {
    for (int j = 0; j < i->dimension; j++) {
        row_entry(fmpq_numref(out + j), form, i->inverse, j, i->dimension + 1);
        fmpz_one(fmpq_denref(out + j));
    }
}
