/* Bodies of a diameter, corner, taper and length.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/angle.h"

#include <math.h>
#include "base/context/scope.h"

enum { TAPER_BITS = 40, BODY_NUMBERS = 7 };

void tool_init(tool *s) {
    fmpq *n = _fmpq_vec_init(BODY_NUMBERS);
    *s = (tool){n, n + 1, n + 2, n + 3, n + 5, 0};
}

void tool_clear(tool *s) {
    _fmpq_vec_clear(s->flat, BODY_NUMBERS);
}

/* The point ((1 - t^2), -2 t) / (1 + t^2) of the circle. */
static void set_normal(fmpq *out, const fmpq_t t) {
    LOCAL_VEC(fmpq, square, 2);
    fmpq *sum = square + 1;
    fmpq_mul(square, t, t);
    fmpq_add_si(sum, square, 1);
    fmpq_sub_si(square, square, 1);
    fmpq_neg(square, square);
    fmpq_div(out, square, sum);
    fmpq_add(out + 1, t, t);
    fmpq_neg(out + 1, out + 1);
    fmpq_div(out + 1, out + 1, sum);
}

/* Find the normals of two sides, one with at most and one with at least the taper in degrees: the
 * tangent of its half, off by less than 2^-200, is rounded to a grid and moved by one step each
 * way, a taper of 0 by none. The body of the larger taper contains the other: the radius flat +
 * corner / cos A + (z - corner) tan A grows with A above the arc. */
static void bound_taper(tool *s, const fmpq_t degrees) {
    LOCAL_MPFR(half, ANGLE_BITS);
    LOCAL_MPFR(pi, ANGLE_BITS);
    LOCAL(mpq, copy);
    LOCAL_VEC(fmpq, t, 2);
    fmpq *step = t + 1;
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
}

/* Check that the bottom's radius is not negative, that the side begins below the top, and that the
 * side does not reach the axis up to the top. */
static graze_status check_cutter(graze_context *context, const tool *s) {
    LOCAL_VEC(fmpq, end, 2);
    fmpq *rest = end + 1;
    fmpq_mul(end, s->corner, s->low + 1);
    fmpq_add(end, end, s->corner);
    fmpq_sub(rest, s->height, s->corner);
    fmpq_mul(rest, rest, s->low + 1);
    fmpq_sub(rest, s->corner, rest);
    fmpq_div(rest, rest, s->low);
    fmpq_add(rest, rest, s->flat);
    if (fmpq_sgn(s->flat) < 0)
        return context_fail(context, GRAZE_EUSE, "corner: expected at most half the diameter");
    if (fmpq_cmp(s->height, end) <= 0)
        return context_fail(context, GRAZE_EUSE,
                            "length: expected more than the height at which the corner ends");
    if (fmpq_sgn(rest) <= 0)
        return context_fail(context, GRAZE_EUSE,
                            "taper: the sides meet below the length; expected a larger one");
    return GRAZE_OK;
}

graze_status tool_take(tool *s, graze_context *context, const fmpq *given, int ball) {
    LOCAL(fmpq, radius);
    fmpq_div_2exp(radius, given + TOOL_DIAMETER, 1);
    s->ball = ball;
    if (ball) {
        fmpq_set(s->corner, radius);
        fmpq_set(s->height, given + TOOL_DIAMETER);
        fmpq_one(s->low + 1);
        fmpq_one(s->high + 1);
        return GRAZE_OK;
    }
    fmpq_set(s->corner, given + TOOL_CORNER);
    fmpq_set(s->height, given + TOOL_LENGTH);
    fmpq_sub(s->flat, radius, given + TOOL_CORNER);
    if (fabs(fmpq_get_d(given + TOOL_TAPER)) >= 90)
        return context_fail(context, GRAZE_EUSE, "taper: expected degrees between -90 and 90");
    bound_taper(s, given + TOOL_TAPER);
    return check_cutter(context, s);
}
