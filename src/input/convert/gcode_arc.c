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
 * The third coordinate is linear in u. The helix has a point at the same angle, which is off by
 * the rise times |angle / a - u|. angle_sway bounds how far the angle is from the uniform one where
 * corners are exact. Corners off by 2^-bits move N by no more, and |N| is at least 0.9 between
 * corners of at most a quarter turn, so the angle, twice that of N, is off by 4 * 2^-bits at most.
 */
#include "input/convert/gcode.h"

#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/convert/angle.h"

enum { CORNER_BITS = 6, CENTRE_BITS = 20, TURN_BITS = 64 };

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
    vector_sub(chord, a->to, a->from, 2);
    if (a->radius && vector_is_zero(chord, 2))
        return context_fail(context, GRAZE_EINPUT,
                            "an arc by R ends where it starts; expected I, J or K for a circle");
    if (a->radius)
        centre_by_radius(a, chord, tolerance);
    vector_sub(end, chord, a->centre, 2);
    for (int k = 0; k < 2; k++)
        fmpq_neg(a->start + k, a->centre + k);
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

/* Corner k of n, within 2^-bits. */
static void arc_corner(half_angle *out, const gcode_arc *a, unsigned long k, unsigned long n) {
    LOCAL_VEC(fmpq, sum, 3);
    fmpq *square = sum + 2;
    LOCAL_MPFR(scale, ANGLE_BITS);
    fmpq_set_si(sum, (slong)k, n);
    fmpq_mul(sum, a->turn, sum);
    fmpq_one(square);
    half_angle_dyadic(out, sum, square, a->bits);
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
    round_to_grid(square, scale, a->bits + 1 - mpfr_get_exp(scale));
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
    arc_corner(&end, a, 1, 1);
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

/* Bound how far the pieces are off the helix that rises by `rise`, not negative; `swaying`, 0
 * leaves out what more pieces make less. */
static void rise_error(mpfr_t out, const gcode_arc *a, const fmpq_t rise, int swaying) {
    LOCAL_VEC(fmpq, share, 1);
    LOCAL_MPFR(part, ANGLE_BITS);
    rational_to_mpfr(out, rise, MPFR_RNDU);
    fmpq_mul_2exp(share, a->turn, TURN_BITS - 4);
    if (fmpq_is_zero(rise) || fmpq_cmp_si(share, 1) < 0)
        return; /* both are between the two ends */
    mpfr_set_zero(out, 1);
    if (swaying) {
        mpfr_const_pi(part, MPFR_RNDU);
        rational_to_mpfr(out, a->turn, MPFR_RNDU);
        mpfr_mul(part, part, out, MPFR_RNDU);
        mpfr_mul_2ui(part, part, 1, MPFR_RNDU);
        mpfr_div_ui(part, part, a->pieces, MPFR_RNDU);
        angle_sway(out, part);
    }
    mpfr_set_ui_2exp(part, 1, 2 - a->bits, MPFR_RNDU);
    mpfr_add(out, out, part, MPFR_RNDU);
    mpfr_set_ui_2exp(part, 1, 4 - TURN_BITS, MPFR_RNDU); /* the error of the turn, as an angle */
    mpfr_add(out, out, part, MPFR_RNDU);
    fmpq_div(share, rise, a->turn); /* the angle is over 12 turns, as 4 pi is */
    divide_by(share, share, 12);
    rational_to_mpfr(part, share, MPFR_RNDU);
    mpfr_mul(out, out, part, MPFR_RNDU);
}

/* Double the pieces, from one for each quarter begun, until the helix is near enough. */
static graze_status refine_helix(gcode_arc *a, graze_context *context, const fmpq_t rise,
                                 const fmpq_t tolerance) {
    char digits[DIGITS_ROOM];
    LOCAL_MPFR(error, ANGLE_BITS);
    LOCAL(fmpz, quarters);
    rise_error(error, a, rise, 0);
    mpfr_add(error, error, a->error, MPFR_RNDU);
    if (bound_exceeds(error, tolerance) || (fmpq_is_zero(tolerance) && !fmpq_is_zero(rise)))
        return context_fail(context, GRAZE_EINPUT,
                            "the arc is off its circle or helix by up to %s; expected at most the "
                            "tolerance",
                            bound_digits(digits, error));
    fmpz_mul_2exp(quarters, fmpq_numref(a->turn), 3);
    fmpz_cdiv_q(quarters, quarters, fmpq_denref(a->turn));
    for (a->pieces = fmpz_is_zero(quarters) ? 1 : fmpz_get_ui(quarters);; a->pieces *= 2) {
        if (a->pieces > context->limits[GRAZE_LIMIT_PIECES])
            return context_limit(context, GRAZE_LIMIT_PIECES, "an arc within the tolerance");
        rise_error(error, a, rise, 1);
        mpfr_add(error, error, a->error, MPFR_RNDU);
        if (!bound_exceeds(error, tolerance))
            break;
    }
    mpfr_set(a->error, error, MPFR_RNDU);
    return GRAZE_OK;
}

graze_status gcode_arc_fit(gcode_arc *a, graze_context *context, const fmpq_t tolerance) {
    LOCAL_VEC(fmpq, rise, 2);
    fmpq *square = rise + 1;
    LOCAL_MPFR(size, ANGLE_BITS);
    TRY(place_arc(a, context, tolerance));
    find_arc_turn(a);
    fmpq_sub(rise, a->to + 2, a->from + 2);
    fmpq_abs(rise, rise);
    rational_to_mpfr(size, rise, MPFR_RNDU);
    a->bits = places_within(size, tolerance, CORNER_BITS);
    square_of_length(square, a->quotient);
    if (!fmpq_is_one(square)) { /* a spiral */
        square_of_length(square, a->start);
        root_above(size, square);
        a->bits = places_within(size, tolerance, a->bits);
    }
    find_spiral(a);
    return refine_helix(a, context, rise, tolerance);
}

void gcode_arc_put(json_writer *w, const gcode_arc *a, unsigned long k, int which, int mirrored) {
    LOCAL_VEC(fmpq, way, 8);
    fmpq *step = way + 2, *grow = way + 4, *centre = way + 6;
    HELD(half_angle, from);
    HELD(half_angle, to);
    arc_corner(&from, a, k, a->pieces);
    arc_corner(&to, a, k + 1, a->pieces);
    fmpq_sub(to.w, to.w, from.w);
    fmpq_sub(to.c, to.c, from.c);
    fmpq_add(centre, a->from + which, a->centre + which);
    multiply_complex(grow, a->start, a->spiral, 0);
    for (int i = 0; i < 2; i++) {
        divide_by(step + i, grow + i, a->pieces);
        fmpq_mul_si(way + i, step + i, (slong)k);
        fmpq_add(way + i, way + i, a->start + i);
        int opposite = mirrored != (which == 0 && i == 1);
        (opposite ? fmpq_neg : fmpq_set)(way + i, way + i);
        (opposite ? fmpq_neg : fmpq_set)(step + i, step + i);
    }
    (mirrored ? fmpq_neg : fmpq_set)(centre, centre);
    /* With N = A + i B: c + (v (A^2 - B^2) + 2 v' A B) / (A^2 + B^2), v' the other part of v. */
    json_form(json_begin(w, NULL),
              "\"@+((@+(@)*s)*((@+(@)*s)^2-(@+(@)*s)^2)+2*(@+(@)*s)*(@+(@)*s)*(@+(@)*s))"
              "/((@+(@)*s)^2+(@+(@)*s)^2)\"",
              centre, way + which, step + which, from.w, to.w, from.c, to.c, way + 1 - which,
              step + 1 - which, from.w, to.w, from.c, to.c, from.w, to.w, from.c, to.c);
}
