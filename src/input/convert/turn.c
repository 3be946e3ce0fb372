/* One turn by an angle in degrees; only its end is approximated.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Quarter turns are rational, and so is every position in between when the tangent of the half
 * angle is the parameter. What is left of the angle is below 90 degrees, and the tangent of its
 * half is approximated by a convergent. Every position on the way is exactly one of the turn asked
 * for, only the last one overshoots or falls short.
 */
#include "input/convert/angle.h"

#include "base/context/scope.h"
#include "input/convert/poses_list.h"

/* Write the axis and the center, and close the two objects of a turn. */
static void put_axis(json_writer *w, const joint *j, int dimension) {
    if (dimension == 3)
        json_point(w, "axis", j->axis, 3);
    put_center(w, j, dimension);
    json_ends(w, "}}");
}

/* Write the whole quarter turns as one piece and the rest of the angle as a second piece. */
static void put_pieces(json_writer *w, const joint *j, int dimension, const fmpz_t quarters,
                       const fmpq_t tangent) {
    LOCAL_VEC(fmpq, zero, 3);
    fmpq *one = zero + 1, *at = zero + 2;
    fmpq_one(one);
    slong whole = fmpz_get_si(quarters);
    if (whole) {
        fmpq_set_si(at, 90 * whole, 1);
        fmpq_div(at, at, j->degrees);
        motion_begin_piece(w, 1, zero, at, 0, "turn", '{');
        text_integer(json_begin(w, "quarters"), quarters);
        put_axis(w, j, dimension);
        json_close(w, '}');
    }
    if (fmpq_is_one(at))
        return;
    motion_begin_piece(w, 1, at, one, 0, whole ? "compose" : "rotate", whole ? '[' : '{');
    if (whole) {
        json_line(w, 3);
        json_open(w, NULL, '{');
        json_open(w, "rotate", '{');
        json_text(w, "tan_half", whole > 0 ? "1" : "-1");
        json_count(w, "times", (unsigned long)(whole > 0 ? whole : -whole));
        put_axis(w, j, dimension);
        json_line(w, 3);
        json_open(w, NULL, '{');
        json_open(w, "rotate", '{');
    }
    json_form(json_begin(w, "tan_half"), "\"(@)*s\"", tangent);
    put_axis(w, j, dimension);
    json_ends(w, whole ? "]}}" : "}");
}

/* Write a turn about an axis of irrational length by a quaternion along the axis as it is given. */
static void put_quaternion(json_writer *w, const joint *j, const fmpq_t tangent) {
    LOCAL_VEC(fmpq, zero, 3);
    fmpq *one = zero + 1, *factor = zero + 2;
    fmpq_one(one);
    motion_begin_piece(w, 1, zero, one, 0, "quaternion", '[');
    json_text(w, NULL, "1");
    for (int k = 0; k < 3; k++) {
        fmpq_mul(factor, tangent, j->axis + k);
        json_form(json_begin(w, NULL), "\"(@)*s\"", factor);
    }
    json_close(w, ']');
    put_center(w, j, 3);
    json_ends(w, "}}");
}

/* The tangent of the half of `rest` quarters, good enough for the target, and its error. */
static void find_tangent(half_angle *out, mpfr_t error, const joint *j, const target *goal,
                         const fmpq_t rest, const fmpq_t square) {
    LOCAL_VEC(fmpq, f, 2);
    fmpq *tolerance = f + 1;
    LOCAL_MPFR(room, ANGLE_BITS);
    divide_by(f, rest, 8);
    rational_to_mpfr(room, goal->tolerance, MPFR_RNDD);
    mpfr_div(room, room, j->reach, MPFR_RNDD);
    if (mpfr_cmp_ui(room, 1) > 0 || mpfr_zero_p(j->reach))
        mpfr_set_ui(room, 1, MPFR_RNDN);
    mpfr_to_rational(tolerance, room);
    half_angle_convergent(out, f, square, tolerance);
    half_angle_error(error, out, f, square);
}

static void report_turn(text *t, const target *goal, const joint *j, const half_angle *made,
                        const mpfr_t error) {
    LOCAL_MPFR(off, ANGLE_BITS);
    json_form(t, "a turn by @ degrees; every position is one of the exact turn, up to the last\n",
              j->degrees);
    if (fmpq_is_one(made->w))
        json_form(t, "tangent: @\n", made->c);
    put_fact(t, "angle: at the end it is off by", error, "radians");
    mpfr_mul(off, error, j->reach, MPFR_RNDU);
    json_form(t, "error: at the end, a point within @", goal->radius);
    put_fact(t, " of the origin is off by", off, "");
    text_put(t, "speed: not uniform; as a screw or a joint the turn is uniform\n");
}

/* Convert a turn by more than 90 degrees about an axis of irrational length as a uniform turn, in
 * one piece for each 90 degrees begun. */
static graze_status by_chain(conversion *out, graze_context *context, const target *goal,
                             const joint *turn) {
    LOCAL(fmpq, f);
    HELD(half_angle, end);
    LOCAL_MPFR(error, ANGLE_BITS);
    turn_fraction(f, turn, 1, 1);
    half_angle_dyadic(&end, f, turn->square, turn->bits);
    half_angle_error(error, &end, f, turn->square);
    json_writer w = motion_begin(&out->motion, 3, "pieces", 1);
    TRY(chain_pieces(&w, context, goal, turn, 1, quarters_above(context, turn)));
    motion_end(&w);
    report_turn(&out->report, goal, turn, &end, error);
    return GRAZE_OK;
}

graze_status convert_rotation(conversion *out, graze_context *context, const target *goal,
                              joint *turn) {
    unsigned long quarters = quarters_above(context, turn);
    if (!quarters)
        return context_limit(context, GRAZE_LIMIT_PIECES, "a turn");
    TRY(joint_bits(turn, context, goal, 1));
    int rational = !fmpq_is_zero(turn->length);
    if (!rational && quarters > 1)
        return by_chain(out, context, goal, turn);
    LOCAL_VEC(fmpq, rest, 2);
    fmpq *square = rest + 1;
    LOCAL(fmpz, whole);
    HELD(half_angle, tangent);
    LOCAL_MPFR(error, ANGLE_BITS);
    divide_by(rest, turn->degrees, 90);
    if (rational) {
        fmpz_tdiv_q(whole, fmpq_numref(rest), fmpq_denref(rest));
        fmpq_sub_fmpz(rest, rest, whole);
        fmpq_one(square);
    } else {
        fmpq_set(square, turn->square);
    }
    find_tangent(&tangent, error, turn, goal, rest, square);
    json_writer w = motion_begin(&out->motion, goal->dimension, "pieces", 1);
    if (rational)
        put_pieces(&w, turn, goal->dimension, whole, tangent.c);
    else
        put_quaternion(&w, turn, tangent.c);
    motion_end(&w);
    report_turn(&out->report, goal, turn, &tangent, error);
    return GRAZE_OK;
}
