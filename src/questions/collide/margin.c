/* The clearance of a pair: its square on each piece, and its bounds in doubles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_poly.h>
#include <math.h>
#include <stdlib.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "questions/collide/features.h"

/* Extend the bounds by the root of num / den >= 0. */
static void take_root(control_maps *maps, const fmpz_t num, const fmpz_t den) {
    LOCAL(fmpq, value);
    double low, high;
    fmpq_set_fmpz_frac(value, num, den);
    rational_bounds(&low, &high, value);
    maps->least = fmin(maps->least, sqrt(fmax(low, 0)) * (1 - 0x1p-50));
    maps->most = fmax(maps->most, sqrt(high) * (1 + 0x1p-50));
}

void clearance_enclose(control_maps *maps, const solid_pair *pair, size_t piece,
                       const dyadic_interval *interval) {
    maps->least = maps->most = 0;
    if (!pair->near)
        return;
    const clearance *near = &pair->near[piece];
    slong degree = FLINT_MAX(fmpz_poly_degree(near->over), fmpz_poly_degree(near->under));
    LOCAL_VEC(fmpz, over, 2 * (degree + 1));
    fmpz *under = over + degree + 1;
    bernstein_from_poly(over, near->over, degree, interval);
    bernstein_from_poly(under, near->under, degree, interval);
    maps->least = INFINITY;
    for (slong k = 0; k <= degree; k++)
        if (fmpz_sgn(over + k) >= 0 && fmpz_sgn(under + k) > 0) {
            take_root(maps, over + k, under + k);
        } else {
            maps->least = 0;
            maps->most = INFINITY;
        }
}

void clearance_enclose_at(control_maps *maps, const solid_pair *pair, size_t piece,
                          const fmpq_t u) {
    maps->least = maps->most = 0;
    if (!pair->near)
        return;
    LOCAL_VEC(fmpq, value, 2);
    fmpz_poly_evaluate_fmpq(value, pair->near[piece].over, u);
    fmpz_poly_evaluate_fmpq(value + 1, pair->near[piece].under, u);
    fmpq_div(value, value, value + 1);
    maps->least = INFINITY;
    take_root(maps, fmpq_numref(value), fmpq_denref(value));
}

/* Set the square of the factor by which a map multiplies all lengths, times the square of its
 * weight; 0 if it changes their ratios. */
static int set_factor(fmpz_poly_t out, const point_map *map) {
    int d = map->dimension;
    LOCAL(fmpz_poly, sum);
    LOCAL(fmpz_poly, term);
    for (int i = 0; i < d; i++)
        for (int j = i; j < d; j++) {
            fmpz_poly_zero(sum);
            for (int k = 0; k < d; k++) {
                fmpz_poly_mul(term, &map->entry[k * (d + 1) + i], &map->entry[k * (d + 1) + j]);
                fmpz_poly_add(sum, sum, term);
            }
            if (i == 0 && j == 0)
                fmpz_poly_set(out, sum);
            else if (i == j ? !fmpz_poly_equal(sum, out) : !fmpz_poly_is_zero(sum))
                return 0;
        }
    return 1;
}

/* Substitute a + (b - a) u into p / q, times a positive number for both. */
static void substitute(fmpz_poly_t p, fmpz_poly_t q, const fmpq_t a, const fmpq_t b) {
    LOCAL(fmpq_poly, line);
    LOCAL(fmpq_poly, over);
    LOCAL(fmpq_poly, under);
    LOCAL(fmpq, step);
    fmpq_sub(step, b, a);
    fmpq_poly_set_coeff_fmpq(line, 0, a);
    fmpq_poly_set_coeff_fmpq(line, 1, step);
    fmpq_poly_set_fmpz_poly(over, p);
    fmpq_poly_set_fmpz_poly(under, q);
    fmpq_poly_compose(over, over, line);
    fmpq_poly_compose(under, under, line);
    fmpq_poly_get_numerator(p, over);
    fmpq_poly_get_numerator(q, under);
    fmpz_poly_scalar_mul_fmpz(p, p, fmpq_poly_denref(under));
    fmpz_poly_scalar_mul_fmpz(q, q, fmpq_poly_denref(over));
}

/* Multiply the squared clearance on a piece by the frame's squared factor of lengths, inverted. */
static graze_status divide_by_frame(clearance *near, graze_context *context,
                                    const motion_piece *piece, const graze_motion *frame) {
    size_t k = 0;
    LOCAL(fmpz_poly, factor);
    LOCAL(fmpz_poly, weight);
    LOCAL_VEC(fmpq, at, 3);
    fmpq *end = at + 1, *width = at + 2;
    while (fmpq_cmp(frame->piece[k].hi, piece->hi) < 0)
        k++;
    const motion_piece *f = &frame->piece[k];
    if (!set_factor(factor, &f->forward))
        return context_fail(context, GRAZE_EILLEGAL,
                            "piece %zu of the fixed solid's motion changes ratios of distances; "
                            "expected similarities where there is a clearance",
                            k);
    fmpq_sub(width, f->hi, f->lo);
    fmpq_sub(at, piece->lo, f->lo);
    fmpq_div(at, at, width);
    fmpq_sub(end, piece->hi, f->lo);
    fmpq_div(end, end, width);
    fmpz_poly_mul(weight, f->forward.weight, f->forward.weight);
    substitute(weight, factor, at, end);
    fmpz_poly_mul(near->over, near->over, weight);
    fmpz_poly_mul(near->under, near->under, factor);
    return GRAZE_OK;
}

graze_status collide_set_clearance(graze_pair *pair, graze_context *context,
                                   const graze_motion *frame) {
    const graze_motion *motion = pair->pair.motion;
    if (fmpq_is_zero(pair->distance))
        return GRAZE_OK;
    pair->clearance = calloc(motion->piece_count, sizeof *pair->clearance);
    if (!pair->clearance)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the clearance");
    for (size_t k = 0; k < motion->piece_count; k++) {
        clearance *near = &pair->clearance[k];
        fmpz_poly_init(near->over);
        fmpz_poly_init(near->under);
        fmpz_poly_set_fmpz(near->over, fmpq_numref(pair->distance));
        fmpz_poly_set_fmpz(near->under, fmpq_denref(pair->distance));
        fmpz_poly_mul(near->over, near->over, near->over);
        fmpz_poly_mul(near->under, near->under, near->under);
    }
    for (size_t k = 0; k < motion->piece_count && frame; k++)
        TRY(divide_by_frame(&pair->clearance[k], context, &motion->piece[k], frame));
    pair->pair.near = pair->clearance;
    return GRAZE_OK;
}
