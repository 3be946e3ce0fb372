/* Bodies of a diameter, corner, taper and length.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/convert.h"

#include <flint/fmpq_vec.h>
#include <math.h>
#include <string.h>
#include "base/context/scope.h"
#include "input/convert/angle.h"

enum { TAPER_BITS = 40 };

void tool_init(tool *s) {
    memset(s, 0, sizeof *s);
    fmpq_init(s->flat);
    fmpq_init(s->corner);
    fmpq_init(s->height);
    for (int k = 0; k < 2; k++) {
        fmpq_init(s->low + k);
        fmpq_init(s->high + k);
    }
}

void tool_clear(tool *s) {
    fmpq_clear(s->flat);
    fmpq_clear(s->corner);
    fmpq_clear(s->height);
    for (int k = 0; k < 2; k++) {
        fmpq_clear(s->low + k);
        fmpq_clear(s->high + k);
    }
}

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
    mpfr_t half, pi;
    mpfr_inits2(ANGLE_BITS, half, pi, (mpfr_ptr)0);
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
    mpfr_clears(half, pi, (mpfr_ptr)0);
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
    else if (fmpq_cmp(s->height, end) <= 0)
        return context_fail(context, GRAZE_EUSE,
                            "length: expected more than the height at which the corner ends");
    else if (fmpq_sgn(rest) <= 0)
        return context_fail(context, GRAZE_EUSE,
                            "taper: the sides meet below the length; expected a larger one");
    return GRAZE_OK;
}

graze_status tool_take(tool *s, graze_context *context, const tool_numbers *given, int ball) {
    LOCAL(fmpq, radius);
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
    if (ball)
        return GRAZE_OK;
    if (fabs(fmpq_get_d(given->taper)) >= 90)
        return context_fail(context, GRAZE_EUSE, "taper: expected degrees between -90 and 90");
    bound_taper(s, given->taper);
    return check_cutter(context, s);
}
