/* Arcs and helices of G-code as rational pieces.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * In the plane, as complex numbers, with c the centre and v the way from it to the start, the path
 * is c + v (1 + u e) N^2 / |N|^2. u runs from 0 to 1 along the whole arc. N runs straight from one
 * corner to the next, over pieces of equal parts of u. Corner k of n is near exp(i k a / 2n), a the
 * arc's angle, so N^2 / |N|^2 is a number of length 1: a turn. With w the quotient of the ends, the
 * last corner has the direction of 1 + w where the ends have one radius, |w| = 1, and e is 0: every
 * point lies exactly on the circle, and the last one is the end. Else the last corner is dyadic,
 * and e is such that the path ends in the end: at each time the path is within |v| |e| of the
 * circle about c through the start.
 *
 * The centre by R is the middle of the chord plus h i times the chord, h^2 = q = (R / D)^2 - 1/4, D
 * the chord's length. A rational h' is taken in place of h, and |h - h'|^2 <= |h^2 - h'^2|. Centre
 * and radius change by at most D |h - h'| each. Where q is negative, h' is 0 and the radius D / 2.
 *
 * The third coordinate is linear in u. The helix has a point at the same angle, from which it is
 * off by its way times |angle / a - u|; angle.h bounds how far the angle is from the uniform one.
 */
#include "input/convert/gcode.h"

#include <flint/fmpq_vec.h>
#include "base/context/scope.h"
#include "input/convert/angle.h"

enum { CORNER_BITS = 6, CENTRE_BITS = 20, TURN_BITS = 64, CORNER_WORK = 10000 };

/* Set `out`, which is neither of them, to the complex product of a and of b or its conjugate. */
static void multiply_complex(fmpq *out, const fmpq *a, const fmpq *b, int conjugate) {
    fmpq_mul(out, a, b);
    fmpq_mul(out + 1, a + 1, b);
    (conjugate ? fmpq_addmul : fmpq_submul)(out, a + 1, b + 1);
    (conjugate ? fmpq_submul : fmpq_addmul)(out + 1, a, b + 1);
}

static void square_of_length(fmpq_t out, const fmpq *z) {
    LOCAL(fmpq, square);
    fmpq_mul(square, z, z);
    fmpq_addmul(square, z + 1, z + 1);
    fmpq_swap(out, square);
}

/* Places of a grid whose steps, times `size`, are well below the tolerance. */
static slong places_within(const mpfr_t size, const fmpq_t tolerance, slong least) {
    LOCAL_MPFR(ratio, ANGLE_BITS);
    rational_to_mpfr(ratio, tolerance, MPFR_RNDD);
    if (mpfr_zero_p(size) || mpfr_zero_p(ratio))
        return least;
    mpfr_div(ratio, size, ratio, MPFR_RNDU);
    slong bits = mpfr_get_exp(ratio) + 8;
    return bits < least ? least : bits > ANGLE_FINEST ? ANGLE_FINEST : bits;
}

/* Set the way from the start to the centre, from R and the chord. */
static void centre_by_radius(gcode_arc *a, const fmpq *chord, const fmpq_t tolerance) {
    LOCAL_VEC(fmpq, ratio, 4); /* of the centre's way to the chord: 1/2 + h i */
    fmpq *square = ratio + 2, *apart = ratio + 3;
    LOCAL_MPFR(length, ANGLE_BITS);
    square_of_length(square, chord);
    root_above(length, square);
    fmpq_div(square, a->radius, square);
    fmpq_mul(square, square, a->radius);
    fmpq_set_si(ratio, 1, 4);
    fmpq_sub(square, square, ratio);
    fmpq_set_si(ratio, 1, 2);
    if (fmpq_sgn(square) < 0) {
        fmpq_abs(square, a->radius);
        rational_to_mpfr(a->error, square, MPFR_RNDD);
        mpfr_div_2ui(length, length, 1, MPFR_RNDU);
        mpfr_sub(a->error, length, a->error, MPFR_RNDU);
    } else if (!rational_root(ratio + 1, square)) {
        root_above(a->error, square);
        round_to_grid(ratio + 1, a->error, 2 * places_within(length, tolerance, CENTRE_BITS));
        fmpq_mul(apart, ratio + 1, ratio + 1);
        fmpq_sub(apart, apart, square);
        fmpq_abs(apart, apart);
        root_above(a->error, apart);
        mpfr_mul(a->error, a->error, length, MPFR_RNDU);
        mpfr_mul_2ui(a->error, a->error, 1, MPFR_RNDU);
    }
    if (fmpq_sgn(a->radius) < 0)
        fmpq_neg(ratio + 1, ratio + 1);
    multiply_complex(a->centre, chord, ratio, 0);
}

/* Set the start from the centre, and the quotient of the ends. */
static graze_status place_arc(gcode_arc *a, graze_context *context, const fmpq_t tolerance) {
    LOCAL_VEC(fmpq, chord, 4);
    fmpq *end = chord + 2;
    mpfr_set_zero(a->error, 1);
    for (int k = 0; k < 2; k++)
        fmpq_sub(chord + k, a->to + k, a->from + k);
    if (a->radius && fmpq_is_zero(chord) && fmpq_is_zero(chord + 1))
        return context_fail(context, GRAZE_EINPUT,
                            "an arc by R ends where it starts; expected I, J or K for a circle");
    if (a->radius)
        centre_by_radius(a, chord, tolerance);
    for (int k = 0; k < 2; k++) {
        fmpq_sub(end + k, chord + k, a->centre + k);
        fmpq_neg(a->start + k, a->centre + k);
    }
    square_of_length(chord, a->start);
    if (fmpq_is_zero(chord) || (fmpq_is_zero(end) && fmpq_is_zero(end + 1)))
        return context_fail(context, GRAZE_EINPUT,
                            "the centre of the arc is one of its ends; expected a radius");
    multiply_complex(a->quotient, end, a->start, 1);
    fmpq_div(a->quotient, a->quotient, chord);
    fmpq_div(a->quotient + 1, a->quotient + 1, chord);
    return GRAZE_OK;
}

/* 1 if the arc turns by more than 180 degrees. */
static int beyond_half(const gcode_arc *a) {
    int side = fmpq_sgn(a->quotient + 1);
    return side < 0 || (side == 0 && fmpq_sgn(a->quotient) > 0);
}

static void find_arc_turn(gcode_arc *a) {
    LOCAL_MPFR(angle, ANGLE_BITS);
    LOCAL_MPFR(other, ANGLE_BITS);
    rational_to_mpfr(angle, a->quotient + 1, MPFR_RNDN);
    rational_to_mpfr(other, a->quotient, MPFR_RNDN);
    mpfr_atan2(angle, angle, other, MPFR_RNDN);
    mpfr_const_pi(other, MPFR_RNDN);
    mpfr_div(angle, angle, other, MPFR_RNDN);
    mpfr_add_ui(angle, angle, beyond_half(a) ? 2 : 0, MPFR_RNDN);
    mpfr_div_2ui(angle, angle, 2, MPFR_RNDN);
    round_to_grid(a->turn, angle, TURN_BITS);
}

/* Corner k of n, and the fraction of its angle for the functions of angle.h. */
static void arc_corner(half_angle *out, fmpq_t fraction, const gcode_arc *a, unsigned long k,
                       unsigned long n) {
    LOCAL_VEC(fmpq, sum, 3);
    fmpq *square = sum + 2;
    LOCAL_MPFR(scale, ANGLE_BITS);
    fmpq_set_si(sum, (slong)k, n);
    fmpq_mul(fraction, a->turn, sum);
    fmpq_one(square);
    half_angle_dyadic(out, fraction, square, k == n ? a->end_bits : a->bits);
    square_of_length(sum, a->quotient);
    if (k < n || !fmpq_is_one(sum))
        return;
    fmpq_add_si(sum, a->quotient, 1);
    fmpq_set(sum + 1, a->quotient + 1);
    square_of_length(square, sum);
    if (fmpq_is_zero(square))
        return; /* half a turn, whose corner is i */
    rational_to_mpfr(scale, square, MPFR_RNDN);
    mpfr_rec_sqrt(scale, scale, MPFR_RNDN);
    round_to_grid(square, scale, CORNER_BITS + 2 - mpfr_get_exp(scale));
    if (beyond_half(a))
        fmpq_neg(square, square);
    fmpq_mul(out->w, sum, square);
    fmpq_mul(out->c, sum + 1, square);
}

/* Set how the way from the centre grows, so that the path ends in the end; add the error. */
static void find_spiral(gcode_arc *a) {
    LOCAL_VEC(fmpq, corner, 6);
    fmpq *back = corner + 2, *square = corner + 4, *other = corner + 5;
    LOCAL_MPFR(size, ANGLE_BITS);
    HELD(half_angle, end);
    arc_corner(&end, other, a, 1, 1);
    fmpq_set(corner, end.w);
    fmpq_set(corner + 1, end.c);
    square_of_length(square, corner);
    multiply_complex(back, a->quotient, corner, 1);
    multiply_complex(a->spiral, back, corner, 1);
    fmpq_div(a->spiral, a->spiral, square);
    fmpq_div(a->spiral + 1, a->spiral + 1, square);
    fmpq_sub_si(a->spiral, a->spiral, 1);
    square_of_length(square, a->spiral);
    square_of_length(other, a->start);
    fmpq_mul(square, square, other);
    root_above(size, square);
    mpfr_add(a->error, a->error, size, MPFR_RNDU);
}

/* Bound how far n pieces are off the helix that rises by `rise`, not negative. */
static graze_status rise_error(mpfr_t out, graze_context *context, const gcode_arc *a,
                               const fmpq_t rise, unsigned long n) {
    LOCAL_VEC(fmpq, share, 3);
    fmpq *fraction = share + 1, *one = share + 2;
    LOCAL_MPFR(worst, ANGLE_BITS);
    LOCAL_MPFR(part, ANGLE_BITS);
    HELD(half_angle, from);
    HELD(half_angle, to);
    fmpq_one(one);
    fmpq_div_2exp(fraction, one, TURN_BITS - 1);
    fmpq_sub(fraction, a->turn, fraction);
    rational_to_mpfr(out, rise, MPFR_RNDU);
    if (fmpq_is_zero(rise) || fmpq_sgn(fraction) <= 0)
        return GRAZE_OK; /* both are between the two ends */
    fmpq_div(share, rise, fraction);
    divide_by(share, share, 12); /* the angle is over 12 times the fraction, as 4 pi > 12 */
    mpfr_set_zero(worst, 1);
    mpfr_set_ui_2exp(out, 1, 4 - TURN_BITS, MPFR_RNDU); /* the error of the angle's fraction */
    for (unsigned long k = 0; k <= n; k++) {
        TRY(context_work(context, CORNER_WORK));
        arc_corner(&to, fraction, a, k, n);
        half_angle_error(part, &to, fraction, one);
        mpfr_max(worst, worst, part, MPFR_RNDU);
        if (k) {
            half_angle_sway(part, &from, &to, one);
            mpfr_max(out, out, part, MPFR_RNDU);
        }
        fmpq_swap(from.w, to.w);
        fmpq_swap(from.c, to.c);
    }
    mpfr_add(out, out, worst, MPFR_RNDU);
    rational_to_mpfr(part, share, MPFR_RNDU);
    mpfr_mul(out, out, part, MPFR_RNDU);
    return GRAZE_OK;
}

/* Double the pieces, from one for each quarter begun, until the helix is near enough. */
static graze_status refine_helix(gcode_arc *a, graze_context *context, const fmpq_t rise,
                                 const fmpq_t tolerance) {
    char digits[DIGITS_ROOM];
    LOCAL_MPFR(before, ANGLE_BITS);
    LOCAL_MPFR(rising, ANGLE_BITS);
    LOCAL_MPFR(sum, ANGLE_BITS);
    LOCAL(fmpz, quarters);
    fmpz_mul_2exp(quarters, fmpq_numref(a->turn), 3);
    fmpz_cdiv_q(quarters, quarters, fmpq_denref(a->turn));
    mpfr_set_inf(before, 1);
    for (a->pieces = fmpz_is_zero(quarters) ? 1 : fmpz_get_ui(quarters);; a->pieces *= 2) {
        if (a->pieces > context->limits[GRAZE_LIMIT_PIECES])
            return context_limit(context, GRAZE_LIMIT_PIECES, "an arc within the tolerance");
        TRY(rise_error(rising, context, a, rise, a->pieces));
        mpfr_add(sum, rising, a->error, MPFR_RNDU);
        if (!bound_exceeds(sum, tolerance))
            break;
        mpfr_mul_d(before, before, 0.75, MPFR_RNDD);
        if (bound_exceeds(a->error, tolerance) || mpfr_cmp(rising, before) > 0 ||
            fmpq_is_zero(tolerance)) /* more pieces come no nearer */
            return context_fail(context, GRAZE_EINPUT,
                                "the arc is off its circle or helix by up to %s; expected at most "
                                "the tolerance",
                                bound_digits(digits, sum));
        mpfr_set(before, rising, MPFR_RNDU);
    }
    mpfr_set(a->error, sum, MPFR_RNDU);
    return GRAZE_OK;
}

graze_status gcode_arc_fit(gcode_arc *a, graze_context *context, const fmpq_t tolerance) {
    LOCAL_VEC(fmpq, rise, 2);
    LOCAL_MPFR(size, ANGLE_BITS);
    TRY(place_arc(a, context, tolerance));
    find_arc_turn(a);
    square_of_length(rise, a->start);
    root_above(size, rise);
    a->end_bits = places_within(size, tolerance, CORNER_BITS);
    fmpq_sub(rise, a->to + 2, a->from + 2);
    fmpq_abs(rise, rise);
    rational_to_mpfr(size, rise, MPFR_RNDU);
    a->bits = places_within(size, tolerance, CORNER_BITS);
    find_spiral(a);
    return refine_helix(a, context, rise, tolerance);
}

void gcode_arc_put(json_writer *w, const gcode_arc *a, unsigned long k, int which, int mirrored) {
    /* With N = A + i B: c + (v (A^2 - B^2) -+ 2 v' A B) / (A^2 + B^2), v' the other part of v. */
    static const char *const forms[] = {"\"@+((@+(@)*s)*((@+(@)*s)^2-(@+(@)*s)^2)"
                                        "-2*(@+(@)*s)*(@+(@)*s)*(@+(@)*s))"
                                        "/((@+(@)*s)^2+(@+(@)*s)^2)\"",
                                        "\"@+((@+(@)*s)*((@+(@)*s)^2-(@+(@)*s)^2)"
                                        "+2*(@+(@)*s)*(@+(@)*s)*(@+(@)*s))"
                                        "/((@+(@)*s)^2+(@+(@)*s)^2)\""};
    LOCAL_VEC(fmpq, way, 8);
    fmpq *step = way + 2, *grow = way + 4, *share = way + 6, *centre = way + 7;
    HELD(half_angle, from);
    HELD(half_angle, to);
    arc_corner(&from, share, a, k, a->pieces);
    arc_corner(&to, share, a, k + 1, a->pieces);
    fmpq_sub(to.w, to.w, from.w);
    fmpq_sub(to.c, to.c, from.c);
    fmpq_add(centre, a->from + which, a->centre + which);
    multiply_complex(grow, a->start, a->spiral, 0);
    for (int i = 0; i < 2; i++) {
        divide_by(step + i, grow + i, a->pieces);
        fmpq_mul_si(way + i, step + i, (slong)k);
        fmpq_add(way + i, way + i, a->start + i);
        (mirrored ? fmpq_neg : fmpq_set)(way + i, way + i);
        (mirrored ? fmpq_neg : fmpq_set)(step + i, step + i);
    }
    (mirrored ? fmpq_neg : fmpq_set)(centre, centre);
    json_form(json_begin(w, NULL), forms[which], centre, way + which, step + which, from.w, to.w,
              from.c, to.c, way + 1 - which, step + 1 - which, from.w, to.w, from.c, to.c, from.w,
              to.w, from.c, to.c);
}
