/* Measures joints and bounds how far from their axes points can come.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/angle.h"

#include "base/context/scope.h"

enum { JOINT_NUMBERS = 10 };

void joint_init(joint *j) {
    fmpq *n = _fmpq_vec_init(JOINT_NUMBERS);
    *j = (joint){.degrees = n,
                 .advance = n + 1,
                 .square = n + 2,
                 .length = n + 3,
                 .axis = n + 4,
                 .center = n + 7};
    mpfr_inits2(ANGLE_BITS, j->reach, j->off, (mpfr_ptr)0);
    mpfr_set_zero(j->reach, 1);
}

void joint_clear(joint *j) {
    _fmpq_vec_clear(j->degrees, JOINT_NUMBERS);
    mpfr_clears(j->reach, j->off, (mpfr_ptr)0);
}

void divide_by(fmpq_t out, const fmpq_t value, ulong divisor) {
    LOCAL(fmpz, d);
    fmpz_set_ui(d, divisor);
    fmpq_div_fmpz(out, value, d);
}

int rational_root(fmpq_t out, const fmpq_t square) {
    if (!fmpz_is_square(fmpq_numref(square)) || !fmpz_is_square(fmpq_denref(square)))
        return 0;
    fmpz_sqrt(fmpq_numref(out), fmpq_numref(square));
    fmpz_sqrt(fmpq_denref(out), fmpq_denref(square));
    return 1;
}

/* The axis's length and, where the joint turns, how far it goes along the axis. */
static graze_status measure_axis(graze_context *context, joint *j, size_t index) {
    _fmpq_vec_dot(j->square, j->axis, j->axis, 3);
    if (fmpq_is_zero(j->square) && !j->is_slide)
        return context_fail(context, GRAZE_EUSE,
                            "joint %zu: the axis is zero; expected a direction", index);
    (void)rational_root(j->length, j->square);
    fmpq_mul(j->advance, j->advance, j->degrees);
    divide_by(j->advance, j->advance, 360);
    return GRAZE_OK;
}

/* Bound the distance from the axis for points within `far` of the origin; `far` becomes a bound of
 * the distance of their images from the origin. */
static void set_reach(joint *j, mpfr_t far) {
    LOCAL_VEC(fmpq, along, 2);
    fmpq *apart = along + 1;
    LOCAL_MPFR(way, ANGLE_BITS);
    LOCAL_MPFR(along_axis, ANGLE_BITS);
    if (j->is_slide) {
        root_above(way, j->square);
    } else {
        _fmpq_vec_dot(along, j->center, j->axis, 3);
        fmpq_mul(along, along, along);
        fmpq_div(along, along, j->square);
        _fmpq_vec_dot(apart, j->center, j->center, 3);
        fmpq_sub(apart, apart, along);
        root_above(j->reach, apart);
        mpfr_mul_2ui(way, j->reach, 1, MPFR_RNDU);
        mpfr_add(j->reach, j->reach, far, MPFR_RNDU);
        fmpq_abs(apart, j->advance);
        rational_to_mpfr(along_axis, apart, MPFR_RNDU);
        mpfr_add(way, way, along_axis, MPFR_RNDU);
    }
    mpfr_add(far, far, way, MPFR_RNDU);
}

graze_status joints_measure(joint *joints, graze_context *context, const target *goal,
                            size_t count) {
    LOCAL_MPFR(far, ANGLE_BITS);
    rational_to_mpfr(far, goal->radius, MPFR_RNDU);
    for (size_t i = 0; i < count; i++) {
        TRY(measure_axis(context, joints + i, i));
        set_reach(joints + i, far);
    }
    return GRAZE_OK;
}

void put_center(json_writer *w, const joint *j, int dimension) {
    if (j->centered)
        json_point(w, "center", j->center, dimension);
}

const char *bound_digits(char out[DIGITS_ROOM], const mpfr_t bound) {
    mpfr_snprintf(out, DIGITS_ROOM, "%.2RUe", bound);
    return out;
}

void put_fact(text *t, const char *name, const mpfr_t bound, const char *unit) {
    char digits[DIGITS_ROOM];
    text_format(t, "%s at most %s%s%s\n", name, bound_digits(digits, bound), *unit ? " " : "",
                unit);
}

void put_rational_fact(text *t, const char *name, const fmpq_t bound) {
    LOCAL_MPFR(above, 64);
    rational_to_mpfr(above, bound, MPFR_RNDU);
    put_fact(t, name, above, "");
}

graze_status joint_bits(joint *j, graze_context *context, const target *goal, size_t count) {
    LOCAL(mpq, tolerance);
    LOCAL_MPFR(ratio, ANGLE_BITS);
    fmpq_get_mpq(tolerance, goal->tolerance);
    mpfr_set_ui(ratio, 1, MPFR_RNDU); /* at least 1: an advance is rounded on this grid too */
    mpfr_max(ratio, ratio, j->reach, MPFR_RNDU);
    mpfr_mul_ui(ratio, ratio, 32 * (unsigned long)count, MPFR_RNDU);
    mpfr_div_q(ratio, ratio, tolerance, MPFR_RNDU);
    /* 2^bits >= ratio, and the angle is off by less than 4 * 2^-bits. */
    j->bits = mpfr_get_exp(ratio) < 8 ? 8 : (slong)mpfr_get_exp(ratio);
    if (j->bits <= ANGLE_FINEST)
        return GRAZE_OK;
    return context_fail(context, GRAZE_EUSE,
                        "the tolerance is too fine for this radius; expected 2^-%d of it or more",
                        ANGLE_FINEST - 8);
}
