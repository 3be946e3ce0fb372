/* Point maps and their derivatives at one rational time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/strata.h"

#include <math.h>
#include "base/context/scope.h"
#include "questions/contact/contact.h"

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
    i->map = _fmpz_vec_init((d + 1) * (d + 1));
    map_rows(i->map, motion_placing(p, scene->options.operation), u, 0);
    i->inverse = _fmpz_vec_init((d + 1) * (d + 1));
    map_rows(i->inverse, tracing, u, 0);
    LOCAL_VEC(fmpz, derivative, (d + 1) * (d + 1));
    for (int k = 0; k < INSTANT_DERIVATIVES; k++) {
        i->carried[k] = _fmpz_vec_init((d + 1) * (d + 1));
        map_rows(derivative, tracing, u, k + 1);
        rows_multiply(i->carried[k], derivative, i->map, d + 1, d + 1, d + 1);
    }
    i->bounded = scale_to_doubles(i->velocity, i->carried[0], (d + 1) * (d + 1));
}

void instant_clear(instant *i) {
    int d = i->dimension;
    fmpq_clear(i->u);
    fmpq_clear(i->t);
    _fmpz_vec_clear(i->map, (d + 1) * (d + 1));
    _fmpz_vec_clear(i->inverse, (d + 1) * (d + 1));
    for (int k = 0; k < INSTANT_DERIVATIVES; k++)
        _fmpz_vec_clear(i->carried[k], (d + 1) * (d + 1));
}

void instant_pullback(fmpz *out, const instant *i, const fmpz *form, int k) {
    rows_multiply(out, form, i->carried[k - 1], 1, i->dimension + 1, i->dimension + 1);
}

void instant_normal(fmpq *out, const instant *i, const fmpz *form) {
    LOCAL_VEC(fmpz, row, 4);
    rows_multiply(row, form, i->inverse, 1, i->dimension + 1, i->dimension + 1);
    for (int j = 0; j < i->dimension; j++)
        fmpq_set_fmpz(out + j, row + j);
}
