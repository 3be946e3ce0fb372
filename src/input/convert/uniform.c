/* Joints that move uniformly, screws among them, as rational pieces near enough.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Every piece runs straight from one dyadic half angle to the next, in the plane of the complex
 * number w + i c L: the tangent of the half angle from the piece's middle is linear in the piece's
 * time up to the small difference of the two lengths. The pieces meet exactly. The number of pieces
 * is doubled until the bounds of all joints add up to the tolerance at most: the joints before and
 * after one keep distances, so errors of displacement add.
 */
#include "input/convert/angle.h"

#include "base/context/scope.h"
#include "input/convert/poses_list.h"

enum { PIECE_WORK = 10000 }; /* units of context_work for the angles of a joint in a piece */

void turn_fraction(fmpq_t out, const joint *j, unsigned long k, unsigned long n) {
    fmpq_mul_ui(out, j->degrees, k);
    divide_by(out, out, 720);
    divide_by(out, out, n);
}

unsigned long quarters_above(const graze_context *context, const joint *j) {
    LOCAL(fmpz, quarters);
    fmpz_mul_ui(quarters, fmpq_denref(j->degrees), 90);
    LOCAL(fmpz, size);
    fmpz_abs(size, fmpq_numref(j->degrees));
    fmpz_cdiv_q(quarters, size, quarters);
    if (fmpz_cmp_ui(quarters, context->limits[GRAZE_LIMIT_PIECES]) > 0)
        return 0;
    return fmpz_is_zero(quarters) ? 1 : fmpz_get_ui(quarters);
}

/* An upper bound, radians, of how far a joint's angle is from uniform in the first `count` of the
 * pieces: the larger error at the ends of a piece, and the sway between them. */
static graze_status turn_error(mpfr_t out, graze_context *context, const joint *j,
                               unsigned long pieces, unsigned long count) {
    LOCAL_MPFR(ends, ANGLE_BITS);
    LOCAL_MPFR(end, ANGLE_BITS);
    LOCAL_MPFR(sway, ANGLE_BITS);
    HELD(half_angle, from);
    HELD(half_angle, to);
    LOCAL(fmpq, f);
    mpfr_set_zero(ends, 1);
    mpfr_set_zero(out, 1);
    for (unsigned long k = 0; k <= count; k++) {
        TRY(context_work(context, PIECE_WORK));
        turn_fraction(f, j, k, pieces);
        half_angle_dyadic(&to, f, j->square, j->bits);
        half_angle_error(end, &to, f, j->square);
        mpfr_max(ends, ends, end, MPFR_RNDU);
        if (k > 0) {
            half_angle_sway(sway, &from, &to, j->square);
            mpfr_max(out, out, sway, MPFR_RNDU);
        }
        fmpq_swap(from.w, to.w);
        fmpq_swap(from.c, to.c);
    }
    mpfr_add(out, out, ends, MPFR_RNDU);
    return GRAZE_OK;
}

/* The advance as a multiple of the axis: exact where the length is rational, else dyadic. */
static void advance_factor(fmpq_t out, const joint *j) {
    if (!fmpq_is_zero(j->length)) {
        fmpq_div(out, j->advance, j->length);
        return;
    }
    LOCAL_MPFR(value, ANGLE_BITS);
    LOCAL_MPFR(length, ANGLE_BITS);
    root_above(length, j->square);
    rational_to_mpfr(value, j->advance, MPFR_RNDN);
    mpfr_div(value, value, length, MPFR_RNDN);
    round_to_grid(out, value, j->bits + mpfr_get_exp(length));
}

/* An upper bound of |factor L - advance|: |x - a| = |x^2 - a^2| / (x + a) <= |x^2 - a^2| / a for x
 * >= 0 and a > 0. */
static void advance_error(mpfr_t out, const joint *j) {
    LOCAL_VEC(fmpq, made, 2);
    fmpq *asked = made + 1;
    LOCAL_MPFR(below, ANGLE_BITS);
    mpfr_set_zero(out, 1);
    fmpq_abs(asked, j->advance);
    if (!fmpq_is_zero(asked) && fmpq_is_zero(j->length)) {
        advance_factor(made, j);
        rational_to_mpfr(below, asked, MPFR_RNDD);
        fmpq_mul(made, made, made);
        fmpq_mul(made, made, j->square);
        fmpq_mul(asked, asked, asked);
        fmpq_sub(made, made, asked);
        fmpq_abs(made, made);
        rational_to_mpfr(out, made, MPFR_RNDU);
        mpfr_div(out, out, below, MPFR_RNDU);
    }
}

static void put_turn(json_writer *w, const joint *j, int dimension, const half_angle *from,
                     const half_angle *to) {
    LOCAL_VEC(fmpq, step, 2);
    fmpq_sub(step, to->w, from->w);
    fmpq_sub(step + 1, to->c, from->c);
    json_open(w, dimension == 2 ? "rotate" : "quaternion", dimension == 2 ? '{' : '[');
    if (dimension == 2) {
        json_form(json_begin(w, "tan_half"), "\"(@+(@)*s)/(@+(@)*s)\"", from->c, step + 1, from->w,
                  step);
        put_center(w, j, 2);
        json_close(w, '}');
        return;
    }
    json_form(json_begin(w, NULL), "\"(@+(@)*s)\"", from->w, step);
    for (int k = 0; k < 3; k++)
        json_form(json_begin(w, NULL),
                  fmpq_is_zero(j->axis + k)  ? "\"0\""
                  : fmpq_is_one(j->axis + k) ? "\"(@+(@)*s)\""
                                             : "\"(@+(@)*s)*(@)\"",
                  from->c, step + 1, j->axis + k);
    json_close(w, ']');
    put_center(w, j, 3);
}

/* Write the translation by t times `factor` times the axis. */
static void put_slide(json_writer *w, const joint *j, int dimension, const fmpq_t factor) {
    LOCAL(fmpq, way);
    json_line(w, 3);
    json_open(w, NULL, '{');
    json_open(w, "translate", '[');
    for (int k = 0; k < dimension; k++) {
        fmpq_mul(way, j->axis + k, factor);
        json_form(json_begin(w, NULL), "\"(@)*t\"", way);
    }
    json_ends(w, "]}");
}

static void put_joint(json_writer *w, const target *goal, const joint *j, unsigned long k,
                      unsigned long pieces) {
    HELD(half_angle, from);
    HELD(half_angle, to);
    LOCAL(fmpq, f);
    fmpq_one(f);
    if (!j->is_slide) {
        turn_fraction(f, j, k, pieces);
        half_angle_dyadic(&from, f, j->square, j->bits);
        turn_fraction(f, j, k + 1, pieces);
        half_angle_dyadic(&to, f, j->square, j->bits);
        json_line(w, 3);
        json_open(w, NULL, '{');
        put_turn(w, j, goal->dimension, &from, &to);
        json_close(w, '}');
        advance_factor(f, j);
    }
    if (!fmpq_is_zero(f))
        put_slide(w, j, goal->dimension, f);
}

/* Piece k of a chain. */
static void put_chain_piece(json_writer *w, const target *goal, const joint *joints, size_t count,
                            unsigned long k, unsigned long pieces) {
    json_line(w, 1);
    json_open(w, NULL, '{');
    json_open(w, "t", '[');
    text_format(json_begin(w, NULL), "\"%lu/%lu\"", k, pieces);
    text_format(json_begin(w, NULL), "\"%lu/%lu\"", k + 1, pieces);
    json_close(w, ']');
    json_open(w, "transform", '{');
    json_open(w, "compose", '[');
    for (size_t i = 0; i < count; i++)
        put_joint(w, goal, joints + i, k, pieces);
    json_ends(w, "]}}");
}

graze_status chain_pieces(json_writer *out, graze_context *context, const target *goal,
                          const joint *joints, size_t count, unsigned long pieces) {
    for (unsigned long k = 0; k < pieces; k++) {
        put_chain_piece(out, goal, joints, count, k, pieces);
        TRY(context_work(context, PIECE_WORK * count));
    }
    return GRAZE_OK;
}

/* Check that the work for the first piece, times the number of pieces, is within the limit `work`.
 * The first piece begins unturned and so has the shortest numbers. */
static graze_status check_work(graze_context *context, const target *goal, const joint *joints,
                               size_t count, unsigned long pieces) {
    graze_motion *motion = NULL;
    HELD(text, first);
    json_writer w = motion_begin(&first, goal->dimension, "pieces", 1);
    put_chain_piece(&w, goal, joints, count, 0, pieces);
    motion_end(&w);
    if (first.failed)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    TRY(motion_from_text(&motion, context, first.data, first.length));
    motion_destroy(motion);
    if (context->work > context->limits[GRAZE_LIMIT_WORK] / pieces)
        return context_limit(context, GRAZE_LIMIT_WORK,
                             "the functions of a motion, all pieces together");
    return GRAZE_OK;
}

/* The sum of all joints' errors of displacement, upwards, in the first `few` of the pieces; sets
 * `off` of each joint. */
static graze_status total_error(mpfr_t out, graze_context *context, joint *joints, size_t count,
                                unsigned long pieces, unsigned long few) {
    LOCAL_MPFR(part, ANGLE_BITS);
    mpfr_set_zero(out, 1);
    for (joint *j = joints; j < joints + count; j++) {
        if (j->is_slide)
            continue;
        TRY(turn_error(j->off, context, j, pieces, few));
        mpfr_mul(part, j->off, j->reach, MPFR_RNDU);
        mpfr_add(out, out, part, MPFR_RNDU);
        advance_error(part, j);
        mpfr_add(out, out, part, MPFR_RNDU);
    }
    return GRAZE_OK;
}

/* Double the pieces until the error is small enough. The bound of the first piece alone, which is
 * at most that of all, and the limits come before all pieces are looked at. */
static graze_status refine_pieces(unsigned long *pieces, mpfr_t error, graze_context *context,
                                  const target *goal, joint *joints, size_t count) {
    for (size_t i = 0; i < count; i++) {
        unsigned long need = joints[i].is_slide ? 1 : quarters_above(context, joints + i);
        if (!need)
            return context_limit(context, GRAZE_LIMIT_PIECES, "a turn");
        *pieces = need > *pieces ? need : *pieces;
    }
    for (;; *pieces *= 2) {
        if (*pieces > context->limits[GRAZE_LIMIT_PIECES])
            return context_limit(context, GRAZE_LIMIT_PIECES,
                                 "a motion as near to the uniform one as the tolerance asks");
        TRY(context_poll(context));
        TRY(total_error(error, context, joints, count, *pieces, 1));
        if (bound_exceeds(error, goal->tolerance))
            continue;
        TRY(check_work(context, goal, joints, count, *pieces));
        TRY(total_error(error, context, joints, count, *pieces, *pieces));
        if (!bound_exceeds(error, goal->tolerance))
            return GRAZE_OK;
    }
}

static void report_joints(text *t, const target *goal, const joint *joints, const mpfr_t error,
                          size_t count, unsigned long pieces) {
    text_format(t, "pieces: %lu\n", pieces);
    for (size_t i = 0; i < count; i++) {
        if (joints[i].is_slide) {
            text_format(t, "joint %zu: a slide, exact\n", i);
            continue;
        }
        text_format(t, "joint %zu: a turn by ", i);
        text_rational(t, joints[i].degrees);
        put_fact(t, " degrees; at every time t its angle differs from the uniform one by",
                 joints[i].off, "radians");
    }
    json_form(t, "error: at every time t, a point within @", goal->radius);
    put_fact(t, " of the origin is off the uniform motion by", error, "");
}

graze_status convert_joints(conversion *out, graze_context *context, const target *goal,
                            joint *joints, size_t count) {
    LOCAL_MPFR(error, ANGLE_BITS);
    unsigned long pieces = 1;
    for (size_t i = 0; i < count; i++)
        TRY(joint_bits(joints + i, context, goal, count));
    TRY(refine_pieces(&pieces, error, context, goal, joints, count));
    json_writer w = motion_begin(&out->motion, goal->dimension, "pieces", 1);
    TRY(chain_pieces(&w, context, goal, joints, count, pieces));
    motion_end(&w);
    report_joints(&out->report, goal, joints, error, count, pieces);
    return GRAZE_OK;
}
