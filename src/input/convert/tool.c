/* Bodies of a diameter, corner, taper and length, and the polyhedra about them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/tool.h"

#include <math.h>
#include "input/convert/joint.h"

static const double pi_near = 3.14159265358979;

enum { TAPER_BITS = 40, FINEST_SIDES = 1 << 18, ROUNDS = 8 };

void tool_numbers_init(tool_numbers *n) {
    fmpq_init(n->diameter);
    fmpq_init(n->corner);
    fmpq_init(n->taper);
    fmpq_init(n->length);
}

void tool_numbers_clear(tool_numbers *n) {
    fmpq_clear(n->diameter);
    fmpq_clear(n->corner);
    fmpq_clear(n->taper);
    fmpq_clear(n->length);
}

/* The point ((1 - t^2), -2 t) / (1 + t^2) of the circle. */
static void set_normal(fmpq *out, const fmpq_t t) {
    fmpq_t square, sum;
    fmpq_init(square);
    fmpq_init(sum);
    fmpq_mul(square, t, t);
    fmpq_add_si(sum, square, 1);
    fmpq_sub_si(square, square, 1);
    fmpq_neg(square, square);
    fmpq_div(out, square, sum);
    fmpq_add(out + 1, t, t);
    fmpq_neg(out + 1, out + 1);
    fmpq_div(out + 1, out + 1, sum);
    fmpq_clear(sum);
    fmpq_clear(square);
}

/* Normals of sides whose tapers are at most and at least the one in degrees: its half's tangent,
 * off by less than 2^-200, is taken to the grid and a step on. A wider taper makes a body around
 * the other one: its radius corner / cos A + (z - corner) tan A grows with A above the arc. */
static void bound_taper(tool *s, const fmpq_t degrees) {
    mpfr_t half, pi;
    mpq_t copy;
    fmpq_t t, step;
    mpfr_inits2(ANGLE_BITS, half, pi, (mpfr_ptr)0);
    mpq_init(copy);
    fmpq_init(t);
    fmpq_init(step);
    fmpq_get_mpq(copy, degrees);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_mul_q(half, pi, copy, MPFR_RNDN);
    mpfr_div_ui(half, half, 360, MPFR_RNDN);
    mpfr_tan(half, half, MPFR_RNDN);
    round_to_grid(t, half, TAPER_BITS);
    if (!fmpq_is_zero(degrees)) {
        fmpq_one(step);
        fmpq_div_2exp(step, step, TAPER_BITS);
    }
    fmpq_sub(t, t, step);
    set_normal(s->low, t);
    fmpq_add(t, t, step);
    fmpq_add(t, t, step);
    set_normal(s->high, t);
    fmpq_clear(step);
    fmpq_clear(t);
    mpq_clear(copy);
    mpfr_clears(half, pi, (mpfr_ptr)0);
}

/* The corners of the profile, where the side begins, and whether it reaches the top. */
static graze_status check_cutter(graze_context *context, const tool *s) {
    fmpq_t end, rest;
    fmpq_init(end);
    fmpq_init(rest);
    fmpq_mul(end, s->corner, s->low + 1);
    fmpq_add(end, end, s->corner);
    fmpq_sub(rest, s->height, s->corner);
    fmpq_mul(rest, rest, s->low + 1);
    fmpq_sub(rest, s->corner, rest);
    fmpq_div(rest, rest, s->low);
    fmpq_add(rest, rest, s->flat);
    graze_status status = GRAZE_OK;
    if (fmpq_sgn(s->flat) < 0)
        status = context_fail(context, GRAZE_EUSE, "corner: expected at most half the diameter");
    else if (fmpq_cmp(s->height, end) <= 0)
        status = context_fail(context, GRAZE_EUSE,
                              "length: expected more than the height at which the corner ends");
    else if (fmpq_sgn(rest) <= 0)
        status = context_fail(context, GRAZE_EUSE,
                              "taper: the sides meet below the length; expected a larger one");
    fmpq_clear(rest);
    fmpq_clear(end);
    return status;
}

graze_status tool_take(tool *s, graze_context *context, const tool_numbers *given, int ball) {
    fmpq_t radius;
    fmpq_init(radius);
    fmpq_div_2exp(radius, given->diameter, 1);
    s->ball = ball;
    if (ball) {
        fmpq_set(s->corner, radius);
        fmpq_set(s->height, given->diameter);
        fmpq_one(s->low + 1);
        fmpq_one(s->high + 1);
    } else {
        fmpq_set(s->corner, given->corner);
        fmpq_set(s->height, given->length);
        fmpq_sub(s->flat, radius, given->corner);
    }
    fmpq_clear(radius);
    if (ball)
        return GRAZE_OK;
    if (fabs(fmpq_get_d(given->taper)) >= 90)
        return context_fail(context, GRAZE_EUSE, "taper: expected degrees between -90 and 90");
    bound_taper(s, given->taper);
    return check_cutter(context, s);
}

/* Sides and pieces of the arc for half of the tolerance each: a chord over the angle d of a circle
 * of radius r is r d^2 / 8 from it. */
static void choose_counts(double counts[2], const tool *s, const fmpq_t tolerance) {
    double half = 0.45 * fmpq_get_d(tolerance), corner = fmpq_get_d(s->corner);
    double normal = atan2(fmpq_get_d(s->high + 1), fmpq_get_d(s->high));
    double radius = fmpq_get_d(s->flat) + corner;
    if (!s->ball)
        radius = fmax(radius, radius - fmpq_get_d(s->height) * tan(normal));
    counts[0] = 4 * ceil(fmax(2, pi_near * sqrt(radius / (2 * half)) / 4));
    counts[1] = ceil((normal + pi_near / 2) * sqrt(corner / (8 * half)));
}

graze_status tool_fit(tool_pair *out, fmpq_t square, graze_context *context, const tool *s,
                      const fmpq_t tolerance) {
    double counts[2];
    choose_counts(counts, s, tolerance);
    for (int round = 0; round < ROUNDS; round++) {
        double most = fmax(counts[0], counts[1] = fmax(counts[1], 1));
        if (counts[0] * (counts[1] + 2) > (double)context->limits[GRAZE_LIMIT_CELLS])
            return context_limit(context, GRAZE_LIMIT_CELLS, "the vertices of a tool");
        if (!(most < FINEST_SIDES))
            return context_fail(context, GRAZE_EUSE,
                                "tolerance: expected at least 1e-10 of the diameter");
        slong bits = 12 + 2 * (slong)ceil(log2(most));
        tool_pair_make(out, s, (size_t)counts[0], (size_t)counts[1], bits < 50 ? bits : 50);
        if (tool_pair_holds(square, out, s, tolerance))
            return GRAZE_OK;
        tool_pair_clear(out);
        for (int k = 0; k < 2; k++)
            counts[k] = ceil(counts[k] * 1.1);
        counts[0] = 4 * ceil(counts[0] / 4);
        graze_status status = context_poll(context);
        if (status)
            return status;
    }
    return context_fail(context, GRAZE_EUSE,
                        "no polyhedron was found; expected corner, length and tolerance less far "
                        "apart in size");
}

void tool_report(text *out, const tool_pair *p, const fmpq_t square) {
    mpfr_t distance;
    mpfr_init2(distance, ANGLE_BITS);
    root_above(distance, square);
    text_format(out, "sides: %zu, rings: %zu\n", p->sides, p->in.count);
    put_fact(out, "error: the tool lies between both polyhedra, and each is off it by", distance,
             "");
    mpfr_clear(distance);
}
