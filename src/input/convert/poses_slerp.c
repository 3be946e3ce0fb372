/* SLERP between poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Quaternions a, b span a plane in which, over |a|, a is |a|^2 and b is a . b + i L with
 * L^2 = square = |a|^2 |b|^2 - (a . b)^2. SLERP moves the argument from one to the other uniformly;
 * the rotation turns by twice the argument. half_angle_sway bounds how far from it the linear
 * quaternion is.
 *
 * Halving: let u be unit quaternions that divide an arc of at most 90 degrees evenly, and r those
 * that are written, |r - u| <= E. Their middles over their lengths are at most E / (c - E) apart,
 * with c the cosine of half the angle between them, and rounding adds (5/4) 2^-bits. The product of
 * all c is at least sin b / b >= 2 / pi, so E stays below 2^(6 - bits) up to HALVINGS_MOST. Let Q
 * and R be the ways straight through u and r: |Q| >= cos 45 degrees and |Q - R| <= E, so the angle
 * between their rotations is at most 2 asin(E / |Q|) < 5 E < 2^(9 - bits) at each time, and
 * angle_sway bounds that between Q and SLERP.
 */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/convert/angle.h"
#include "input/convert/poses_list.h"

enum { WAY_WORK = 10000, HALVINGS_MOST = 31 }; /* WAY_WORK counts as in context_work */

/* Quaternions between poses are on the grid of 2^-bits; the lengths of all quaternions are about
 * that near to 1. */
static slong slerp_bits(const slerp_course *s) {
    return bits_within(s->tolerance) + 12;
}

/* Bring a quaternion to length 1 by a factor and, if `on_grid`, then to the grid. */
static void scale_to_unit(fmpq *q, slong bits, int on_grid) {
    LOCAL(fmpq, factor);
    LOCAL_MPFR(x, ANGLE_BITS);
    _fmpq_vec_dot(factor, q, q, 4);
    root_above(x, factor);
    slong size = mpfr_get_exp(x);
    mpfr_ui_div(x, 1, x, MPFR_RNDN);
    round_to_grid(factor, x, bits + size + 1);
    for (int k = 0; k < 4; k++) {
        fmpq_mul(q + k, q + k, factor);
        rational_to_mpfr(x, q + k, MPFR_RNDN);
        if (on_grid)
            round_to_grid(q + k, x, bits);
    }
}

/* The fewest halvings of an arc whose bound is within the tolerance. */
static graze_status find_halvings(mpfr_t bound, slerp_course *s, graze_context *context,
                                  const mpfr_t apart) {
    LOCAL_MPFR(rounding, 2);
    mpfr_set_ui_2exp(rounding, 1, 9 - slerp_bits(s), MPFR_RNDU);
    int more = 1;
    for (s->halvings = -1; more && s->halvings < HALVINGS_MOST;) {
        mpfr_div_2ui(bound, apart, (unsigned long)++s->halvings, MPFR_RNDU);
        angle_sway(bound, bound);
        mpfr_add(bound, bound, rounding, MPFR_RNDU);
        more = bound_exceeds(bound, s->tolerance);
    }
    s->pieces += ((size_t)1 << s->halvings) - 1;
    return more || s->pieces > context->limits[GRAZE_LIMIT_PIECES]
               ? context_limit(context, GRAZE_LIMIT_PIECES,
                               "a motion as near to SLERP as the tolerance asks")
               : GRAZE_OK;
}

/* Bound the angle to SLERP; `from` and `to` are the quaternions in the plane that they span. */
static graze_status bound_way(slerp_course *s, graze_context *context, const half_angle *from,
                              const half_angle *to, const fmpq_t square, unsigned long row) {
    graze_status status = GRAZE_OK;
    LOCAL_MPFR(bound, ANGLE_BITS);
    LOCAL_MPFR(apart, ANGLE_BITS);
    half_angle_apart(apart, from, to, square);
    if (s->tolerance)
        status = find_halvings(bound, s, context, apart);
    else
        half_angle_sway(bound, from, to, square);
    if (mpfr_cmp_d(bound, s->worst) > 0) {
        s->worst = mpfr_get_d(bound, MPFR_RNDU);
        s->row = row;
    }
    return status;
}

graze_status slerp_look(slerp_course *s, graze_context *context, const pose_list *list, size_t i) {
    pose *p = list->item + i;
    TRY(context_work(context, WAY_WORK));
    HELD(half_angle, from);
    HELD(half_angle, to);
    LOCAL(fmpq, square);
    _fmpq_vec_dot(square, p->quaternion, p->quaternion, 4);
    s->halvings = 0;
    if (fmpq_is_zero(square))
        return context_fail_in(context, GRAZE_EINPUT, list->source, p->line,
                               "the quaternion is zero; expected that of a rotation");
    if (s->tolerance)
        scale_to_unit(p->quaternion, slerp_bits(s), 0);
    if (!i)
        return GRAZE_OK;
    s->pieces++;
    _fmpq_vec_dot(from.w, p[-1].quaternion, p[-1].quaternion, 4);
    _fmpq_vec_dot(to.w, p[-1].quaternion, p->quaternion, 4);
    _fmpq_vec_dot(square, p->quaternion, p->quaternion, 4);
    fmpq_mul(square, square, from.w);
    fmpq_submul(square, to.w, to.w);
    fmpq_one(to.c);
    if (!fmpq_is_zero(square))
        return bound_way(s, context, &from, &to, square, p->row);
    if (fmpq_sgn(to.w) < 0)
        return context_fail_in(context, GRAZE_EINPUT, list->source, p->line,
                               "the quaternion is opposite to that of line %lu, and zero between "
                               "them; expected the same rotation with the other signs",
                               p[-1].line);
    return GRAZE_OK;
}

void slerp_middle(pose *out, const slerp_course *s, const pose *from, const pose *to) {
    vector_middle(out->time, from->time, to->time, 1);
    for (int k = 3; k < 12; k += 4)
        vector_middle(out->matrix + k, from->matrix + k, to->matrix + k, 1);
    vector_middle(out->quaternion, from->quaternion, to->quaternion, 4);
    scale_to_unit(out->quaternion, slerp_bits(s), 1);
    out->row = to->row;
}

void slerp_report(text *t, const slerp_course *s, const char *unit) {
    char digits[DIGITS_ROOM];
    LOCAL_MPFR(worst, 53);
    mpfr_set_d(worst, s->worst, MPFR_RNDU);
    text_put(t, s->tolerance ? "slerp: " : "slerp: not taken (`--slerp` does); ");
    text_format(t, "at one time the rotation is off it by at most %s radians",
                bound_digits(digits, worst));
    if (s->row)
        text_format(t, ", most of all up to %s %lu", unit, s->row);
    text_format(t, "; pieces: %zu\n", s->pieces);
}
