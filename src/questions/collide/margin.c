/* The clearance of a pair: its square on each piece, and its bounds in doubles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "questions/collide/features.h"

/* Set out[0] / out[1] to the square of the sum of the lengths times their ratios. One length alone
 * needs no root of its ratio's square. */
static void square_of_sum(fmpz_poly_struct out[2], const clearance *near,
                          const fmpq *const length[3]) {
    int terms = 0;
    LOCAL_VEC(fmpz_poly, term, 2);
    fmpz_poly_zero(&out[0]);
    fmpz_poly_one(&out[1]);
    for (int k = 0; k < 3; k++)
        terms += !fmpq_is_zero(length[k]);
    for (int k = 0; k < 3; k++) {
        const fmpz_poly_struct *of = terms == 1 ? near->ratio[k].square : near->ratio[k].root;
        if (fmpq_is_zero(length[k]))
            continue;
        for (int i = 0; i < 2; i++) {
            const fmpz *by = i ? fmpq_denref(length[k]) : fmpq_numref(length[k]);
            fmpz_poly_scalar_mul_fmpz(&term[i], &of[i], by);
            if (terms == 1)
                fmpz_poly_scalar_mul_fmpz(&term[i], &term[i], by);
        }
        fmpz_poly_mul(&out[0], &out[0], &term[1]);
        fmpz_poly_mul(&term[0], &term[0], &out[1]);
        fmpz_poly_add(&out[0], &out[0], &term[0]);
        fmpz_poly_mul(&out[1], &out[1], &term[1]);
    }
    for (int i = 0; i < 2 && terms > 1; i++)
        fmpz_poly_mul(&out[i], &out[i], &out[i]);
}

static const fmpq *body_radius(const solid_pair *pair, int side, uint32_t simplex) {
    static const fmpq none = {0, 1};
    return pair->round[side] ? pair->round[side][simplex].radius : &none;
}

void clearance_square(fmpz_poly_struct out[2], const clearance *near, const solid_pair *pair,
                      near_pair simplices) {
    const fmpq *const length[3] = {near->distance, body_radius(pair, 0, simplices.moving),
                                   body_radius(pair, 1, simplices.fixed)};
    square_of_sum(out, near, length);
}

/* The simplex of a solid with the greatest radius times `sign`. */
static uint32_t extreme_body(const solid_pair *pair, int side, int sign) {
    size_t count = pair->round[side] ? (side ? pair->fixed : pair->moving)->cut.count : 0;
    uint32_t best = 0;
    for (uint32_t k = 0; k < count; k++)
        if (sign * fmpq_cmp(body_radius(pair, side, k), body_radius(pair, side, best)) > 0)
            best = k;
    return best;
}

void clearance_least(fmpq_t out, const graze_pair *pair) {
    fmpq_set(out, pair->distance);
    for (int side = 0; side < 2; side++)
        fmpq_add(out, out, body_radius(&pair->pair, side, extreme_body(&pair->pair, side, -1)));
    for (size_t k = 0; pair->clearance && k < 3 * pair->pair.motion->piece_count; k++) {
        const length_ratio *ratio = &pair->clearance[k / 3].ratio[k % 3];
        if (!fmpz_poly_equal(&ratio->square[0], &ratio->square[1]))
            fmpq_zero(out);
    }
}

/* Lower `least`, or raise `most`, to the root of num / den >= 0. */
static void take_root(double *least, double *most, const fmpz_t num, const fmpz_t den) {
    LOCAL(fmpq, value);
    double low, high;
    fmpq_set_fmpz_frac(value, num, den);
    rational_bounds(&low, &high, value);
    if (least)
        *least = fmin(*least, sqrt(low));
    if (most)
        *most = fmax(*most, sqrt(high));
}

/* Lower `least`, or raise `most`, by a square's Bernstein coefficients on an interval. */
static void take_square(double *least, double *most, const fmpz_poly_struct square[2],
                        const dyadic_interval *interval) {
    slong degree = FLINT_MAX(fmpz_poly_degree(&square[0]), fmpz_poly_degree(&square[1]));
    LOCAL_VEC(fmpz, over, 2 * (degree + 1));
    fmpz *under = over + degree + 1;
    bernstein_from_poly(over, &square[0], degree, interval);
    bernstein_from_poly(under, &square[1], degree, interval);
    for (slong k = 0; k <= degree; k++)
        if (fmpz_sgn(over + k) >= 0 && fmpz_sgn(under + k) > 0)
            take_root(least, most, over + k, under + k);
        else if (least)
            *least = 0;
        else
            *most = INFINITY;
}

void clearance_enclose(control_maps *maps, const placing *p, const dyadic_interval *interval) {
    maps->least = maps->most = 0;
    if (!p->near)
        return;
    LOCAL_VEC(fmpz_poly, square, 4); /* of the least and the greatest clearance of any pair */
    for (int k = -1; k <= 1; k += 2)
        clearance_square(square + (k + 1), p->near, p->pair,
                         (near_pair){extreme_body(p->pair, 0, k), extreme_body(p->pair, 1, k)});
    maps->least = INFINITY;
    take_square(&maps->least, NULL, square, interval);
    take_square(NULL, &maps->most, square + 2, interval);
}

void clearance_init(clearance *near, const fmpq *distance) {
    near->distance = distance;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++) {
            fmpz_poly_init(&near->ratio[k].square[i]);
            fmpz_poly_init(&near->ratio[k].root[i]);
            fmpz_poly_one(&near->ratio[k].square[i]);
            fmpz_poly_one(&near->ratio[k].root[i]);
        }
}

void clearance_clear(clearance *near) {
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++) {
            fmpz_poly_clear(&near->ratio[k].square[i]);
            fmpz_poly_clear(&near->ratio[k].root[i]);
        }
}

static void freeze_ratio(fmpz_poly_struct out[2], const fmpz_poly_struct of[2], const fmpq_t u) {
    LOCAL_VEC(fmpq, value, 2);
    fmpz_poly_evaluate_fmpq(value, &of[0], u);
    fmpz_poly_evaluate_fmpq(value + 1, &of[1], u);
    fmpq_div(value, value, value + 1);
    fmpz_poly_set_fmpz(&out[0], fmpq_numref(value));
    fmpz_poly_set_fmpz(&out[1], fmpq_denref(value));
}

void clearance_freeze(clearance *out, const clearance *near, const fmpq_t u) {
    clearance_init(out, near->distance);
    for (int k = 0; k < 3; k++) {
        freeze_ratio(out->ratio[k].square, near->ratio[k].square, u);
        freeze_ratio(out->ratio[k].root, near->ratio[k].root, u);
    }
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

/* Set a ratio to the root of its square; 0 if that is no rational function. */
static int set_root(length_ratio *ratio) {
    fmpz_poly_struct *root = ratio->root, *square = ratio->square;
    fmpz_poly_mul(&root[0], &square[0], &square[1]);
    if (!fmpz_poly_sqrt(&root[0], &root[0]))
        return 0;
    if (fmpz_sgn(root[0].coeffs) < 0)
        fmpz_poly_neg(&root[0], &root[0]);
    fmpz_poly_set(&root[1], &square[1]);
    return 1;
}

/* Set a ratio to the inverse of the factor by which a frame multiplies lengths on a piece. */
static graze_status set_frame_ratio(length_ratio *out, graze_context *context,
                                    const motion_piece *piece, const graze_motion *frame) {
    size_t k = 0;
    LOCAL_VEC(fmpq, at, 3);
    fmpq *end = at + 1, *width = at + 2;
    while (fmpq_cmp(frame->piece[k].hi, piece->hi) < 0)
        k++;
    const motion_piece *f = &frame->piece[k];
    if (!point_map_scale(&out->square[1], &f->forward))
        return context_fail(context, GRAZE_EILLEGAL,
                            "piece %zu of the fixed solid's motion changes ratios of distances; "
                            "expected similarities where there is a clearance",
                            k);
    fmpq_sub(width, f->hi, f->lo);
    fmpq_sub(at, piece->lo, f->lo);
    fmpq_div(at, at, width);
    fmpq_sub(end, piece->hi, f->lo);
    fmpq_div(end, end, width);
    fmpz_poly_mul(&out->square[0], f->forward.weight, f->forward.weight);
    substitute(&out->square[0], &out->square[1], at, end);
    return GRAZE_OK;
}

/* Set the ratios of a piece: lengths of the world and of the moving solid in the fixed one's space.
 */
static graze_status set_ratios(clearance *near, graze_context *context, const graze_pair *pair,
                               size_t piece) {
    const motion_piece *m = &pair->pair.motion->piece[piece];
    int far = !fmpq_is_zero(pair->distance); /* a point has no radius */
    int moving = !fmpq_is_zero(body_radius(&pair->pair, SIDE_MOVING, 0));
    int terms = far + moving + !fmpq_is_zero(body_radius(&pair->pair, SIDE_FIXED, 0));
    length_ratio *world = &near->ratio[0], *own = &near->ratio[1];
    if (pair->frame)
        TRY(set_frame_ratio(world, context, m, pair->frame));
    if (moving) {
        if (!point_map_scale(&own->square[0], &m->forward))
            return context_fail(context, GRAZE_EILLEGAL,
                                "piece %zu of the motion makes no balls of balls; expected "
                                "similarities for a round solid",
                                piece);
        fmpz_poly_mul(&own->square[1], m->forward.weight, m->forward.weight);
    }
    if (terms > 1 && ((far && !set_root(world)) || (moving && !set_root(own))))
        return context_fail(context, GRAZE_EILLEGAL,
                            "piece %zu of the motion multiplies lengths by an irrational factor; "
                            "expected a rational one for a sum of a radius and other lengths",
                            piece);
    return GRAZE_OK;
}

graze_status collide_set_clearance(graze_pair *pair, graze_context *context) {
    const graze_motion *motion = pair->pair.motion;
    TRY(collide_set_round(pair, context, SIDE_MOVING));
    TRY(collide_set_round(pair, context, SIDE_FIXED));
    if (fmpq_is_zero(pair->distance) && !pair->pair.round[0] && !pair->pair.round[1])
        return GRAZE_OK;
    TRY(MAKE_ARRAY(context, pair->clearance, motion->piece_count, "the clearance"));
    for (size_t k = 0; k < motion->piece_count; k++)
        clearance_init(&pair->clearance[k], pair->distance);
    for (size_t k = 0; k < motion->piece_count; k++)
        TRY(set_ratios(&pair->clearance[k], context, pair, k));
    pair->pair.near = pair->clearance;
    return GRAZE_OK;
}
