/* Motions through poses: keyframes, or matrices interpolated entry by entry.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The motion passes through each pose at its time. Only matrices that become rotations are changed,
 * by an amount that is computed exactly and reported.
 */
#include "input/convert/angle.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "input/convert/poses_list.h"

static graze_status refuse_pose(graze_context *context, const pose_list *list, const pose *p,
                                const fmpq_t deviation) {
    char digits[DIGITS_ROOM];
    LOCAL_MPFR(shown, 64);
    rational_to_mpfr(shown, deviation, MPFR_RNDU);
    return context_fail_in(context, GRAZE_EINPUT, list->source, p->line,
                           "the matrix is no rotation: an entry is %s off the nearest one; "
                           "expected a rotation, a larger tolerance, or affine poses",
                           bound_digits(digits, shown));
}

/* Find the quaternions of all matrices, and report the largest deviation. */
static graze_status find_rotations(text *report, graze_context *context, pose_list *list,
                                   const fmpq_t tolerance) {
    static const double unturned[4] = {1, 0, 0, 0};
    double before[4] = {1, 0, 0, 0}, matrix[9], q[4];
    LOCAL_VEC(fmpq, worst, 2);
    LOCAL_VEC(fmpq, rotation, 9);
    fmpq *deviation = worst + 1;
    LOCAL(mpq, entry);
    for (size_t i = 0; i < list->count; i++) {
        pose *p = list->item + i;
        for (int k = 0; k < 9; k++) {
            fmpq_get_mpq(entry, p->matrix + 4 * (k / 3) + k % 3);
            matrix[k] = mpq_get_d(entry);
        }
        pose_nearest(q, matrix, before);
        int finite = 1;
        for (int k = 0; k < 4; k++)
            finite &= isfinite(q[k]) != 0;
        memcpy(before, finite ? q : unturned, sizeof before);
        for (int k = 0; k < 4; k++)
            TRY(rational_from_double(p->quaternion + k, context, before[k]));
        pose_rotation(rotation, p->quaternion);
        rotation_distance(deviation, rotation, p->matrix, 4);
        if (fmpq_cmp(deviation, worst) > 0)
            fmpq_set(worst, deviation);
        if (fmpq_cmp(deviation, tolerance) > 0)
            return refuse_pose(context, list, p, deviation);
    }
    put_rational_fact(report, "rotations: nearest to the matrices, whose entries they change by",
                      worst);
    return GRAZE_OK;
}

/* Set `off` to an upper bound of how far entries of a pose's matrix are from those of one in the
 * plane, and leave the rest out. A quaternion q turns about z as w and z alone do, and then by the
 * angle a about an axis across, where sin(a/2) = s = hypot(x, y) / |q|: the matrices of both differ
 * by 2 s in the operator norm. */
static void flatten_pose(mpfr_t off, pose *p, int affine) {
    static const int across[] = {2, 6, 8, 9};
    LOCAL_VEC(fmpq, square, 2);
    fmpq *part = square + 1, *q = p->quaternion;
    if (affine) {
        fmpq_sub_ui(part, p->matrix + 10, 1);
        fmpq_mul(square, part, part);
        for (int k = 0; k < 4; k++)
            fmpq_addmul(square, p->matrix + across[k], p->matrix + across[k]);
    } else if (!fmpq_is_zero(q + 1) || !fmpq_is_zero(q + 2)) {
        _fmpq_vec_dot(square, q + 1, q + 1, 2);
        _fmpq_vec_dot(part, q, q, 4);
        fmpq_div(square, square, part);
        fmpq_mul_ui(square, square, 4);
        fmpq_zero(q + 1);
        fmpq_zero(q + 2);
    }
    root_above(off, square);
}

static graze_status flatten_poses(text *report, graze_context *context, const pose_list *list,
                                  int affine, const fmpq_t tolerance) {
    char digits[DIGITS_ROOM];
    int above = 0;
    LOCAL_MPFR(off, 64);
    LOCAL_MPFR(worst, 64);
    mpfr_set_zero(worst, 1);
    for (pose *p = list->item; p < list->item + list->count; p++) {
        flatten_pose(off, p, affine);
        if (bound_exceeds(off, tolerance))
            return context_fail_in(context, GRAZE_EINPUT, list->source, p->line,
                                   "the pose turns out of the plane: an entry of its matrix is up "
                                   "to %s off; expected turns about z, a larger tolerance, or "
                                   "dimension 3",
                                   bound_digits(digits, off));
        mpfr_max(worst, worst, off, MPFR_RNDU);
        above |= !fmpq_is_zero(p->matrix + 11);
    }
    text_put(report, above ? "plane: z is left out\n" : "");
    if (!mpfr_zero_p(worst))
        put_fact(report, "plane: tilts are left out; they change entries of matrices by", worst,
                 "");
    return GRAZE_OK;
}

static void put_keyframe(json_writer *w, const pose *p, const pose_list *list) {
    int flat = list->dimension == 2;
    fmpq position[3], half[2] = {p->quaternion[0], p->quaternion[3]};
    for (int k = 0; k < 3; k++)
        position[k] = p->matrix[4 * k + 3];
    json_line(w, 1);
    json_open(w, NULL, '{');
    json_rational(w, "t", p->time);
    json_count(w, "row", p->row);
    json_point(w, "position", position, list->dimension);
    if (list->form != POSES_OF_POSITIONS)
        json_point(w, flat ? "complex" : "quaternion", flat ? half : p->quaternion, flat ? 2 : 4);
    json_close(w, '}');
}

/* Write the poses between two, by halving: first those before the middle, then the middle, then the
 * rest.
 */
static void put_between(json_writer *w, const pose_list *list, const slerp_course *s,
                        const pose *from, const pose *to, int halvings) {
    if (!halvings)
        return;
    HELD(pose, middle);
    slerp_middle(&middle, s, from, to);
    put_between(w, list, s, from, &middle, halvings - 1);
    put_keyframe(w, &middle, list);
    put_between(w, list, s, &middle, to, halvings - 1);
}

/* Write the poses and, if a tolerance is given, poses between them that bring the motion near
 * SLERP. */
static graze_status put_keyframes(conversion *out, graze_context *context, const pose_list *list,
                                  const fmpq *tolerance) {
    slerp_course s = {.tolerance = tolerance};
    json_writer w = motion_begin(&out->motion, list->dimension, "keyframes", 1);
    for (size_t i = 0; i < list->count; i++) {
        const pose *p = list->item + i;
        if (list->form != POSES_OF_POSITIONS)
            TRY(slerp_look(&s, context, list, i));
        if (i)
            put_between(&w, list, &s, p - 1, p, s.halvings);
        put_keyframe(&w, p, list);
    }
    motion_end(&w);
    if (list->form != POSES_OF_POSITIONS)
        slerp_report(&out->report, &s, list->unit);
    return GRAZE_OK;
}

static void put_matrices(text *t, const pose_list *list) {
    json_writer w = motion_begin(t, list->dimension, "pieces", 1);
    LOCAL(fmpq, step);
    for (size_t i = 0; i + 1 < list->count; i++) {
        const pose *p = list->item + i;
        motion_begin_piece(&w, 1, p[0].time, p[1].time, p[1].row, "matrix", '[');
        for (int k = 0; k < 4 * list->dimension; k++) {
            if (list->dimension == 2 && k % 4 == 2)
                continue;
            if (k % 4 == 0) {
                json_line(&w, 2);
                json_open(&w, NULL, '[');
            }
            fmpq_sub(step, p[1].matrix + k, p[0].matrix + k);
            json_form(json_begin(&w, NULL), "\"@+(@)*s\"", p[0].matrix + k, step);
            if (k % 4 == 3)
                json_close(&w, ']');
        }
        json_ends(&w, "]}}");
    }
    motion_end(&w);
}

/* Negate each quaternion whose negative is nearer to the one before it, which may have been negated
 * itself; with `keep` change none. Report the poses of these quaternions, neighbours as a range. */
static void take_ways(text *t, pose_list *list, int keep) {
    enum { NAMED = 10 };
    size_t count = 0, ranges = 0, length = 0;
    for (size_t i = 1; i <= list->count; i++) {
        pose *p = list->item + i;
        int is_long = i < list->count && pose_along(p) < 0;
        if (is_long && !keep)
            pose_negate(p);
        if (!count && is_long)
            text_format(t,
                        keep
                            ? "long way: quaternions are more than half a turn of those before, at "
                              "%ss"
                            : "shortest: signs of quaternions changed at %ss",
                        list->unit);
        if (is_long && !length++ && ranges++ <= NAMED)
            text_format(t, ranges > NAMED ? ", ..." : ranges > 1 ? ", %lu" : " %lu", p->row);
        if (!is_long && length > 1 && ranges <= NAMED)
            text_format(t, "-%lu", p[-1].row);
        length = is_long ? length : 0;
        count += (size_t)is_long;
    }
    if (count)
        text_format(t, "; %zu in all%s\n", count,
                    keep ? "; they are kept" : " (`--long` keeps them)");
}

/* Report the rows that were read and the changes made to them. */
static void report_poses(text *t, const pose_list *list, unsigned ways, const pose_choice *choice,
                         graze_rounding rounding) {
    int affine = (ways & GRAZE_POSES_AFFINE) != 0;
    text_format(t, "poses: %zu", list->count);
    if (list->count < list->rows)
        text_format(t, " of %lu", list->rows);
    text_format(t, ", each %s %sat its time",
                affine || list->form == POSES_OF_QUATERNIONS ? "one" : "position",
                rounding ? "" : "exactly as given ");
    if (rounding)
        text_format(t, ", all numbers rounded to %s (`--numbers written` takes them exactly)",
                    graze_rounding_name(rounding));
    text_put(t, "\n");
    if (!fmpq_is_one(choice->scale))
        json_form(t, "scale: positions are those given times @\n", choice->scale);
    text_put(t, affine ? "between: every entry of the matrix is linear\n"
                : list->form == POSES_OF_POSITIONS
                    ? "between: the position is linear; the list has no rotations\n"
                : ways & GRAZE_POSES_SLERP
                    ? "between: the position is linear, the rotation near SLERP\n"
                    : "between: position and quaternion are linear, the quaternion not "
                      "normalised\n");
}

graze_status convert_poses(conversion *out, graze_context *context, const char *path,
                           const pose_choice *choice, unsigned ways, const fmpq_t tolerance) {
    ZEROED(pose_list, list);
    int affine = (ways & GRAZE_POSES_AFFINE) != 0;
    TRY(poses_read(&list, &out->report, context, path, choice));
    if (affine && list.form != POSES_OF_MATRICES)
        return context_fail_in(context, GRAZE_EINPUT, path, 0,
                               "the poses are no matrices; expected matrices for an affine motion");
    report_poses(&out->report, &list, ways, choice, context->rounding);
    if (!affine && list.form == POSES_OF_MATRICES)
        TRY(find_rotations(&out->report, context, &list, tolerance));
    if (list.form == POSES_OF_AXES || list.form == POSES_OF_ANGLES)
        TRY(poses_turn(&out->report, context, &list, choice->naming.order, tolerance));
    if (list.dimension == 2)
        TRY(flatten_poses(&out->report, context, &list, affine, tolerance));
    if (affine) {
        put_matrices(&out->motion, &list);
        return GRAZE_OK;
    }
    take_ways(&out->report, &list, (ways & GRAZE_POSES_LONG) != 0);
    return put_keyframes(out, context, &list, ways & GRAZE_POSES_SLERP ? tolerance : NULL);
}
