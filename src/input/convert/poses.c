/* Motions through poses: keyframes, or matrices interpolated entry by entry.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The motion passes through each pose at its time. Only matrices that become rotations are changed,
 * by an amount that is computed exactly and reported.
 */
#include "input/convert/poses.h"

#include <math.h>
#include <string.h>
#include "base/number/rounding.h"
#include "input/convert/joint.h"
#include "input/convert/poses_nearest.h"
#include "input/convert/poses_turned.h"

static graze_status refuse_pose(graze_context *context, const pose_list *list, const pose *p,
                                const fmpq_t deviation) {
    mpfr_t shown;
    mpq_t copy;
    char digits[64];
    mpfr_init2(shown, 64);
    mpq_init(copy);
    fmpq_get_mpq(copy, deviation);
    mpfr_set_q(shown, copy, MPFR_RNDU);
    mpfr_snprintf(digits, sizeof digits, "%.2RUe", shown);
    mpq_clear(copy);
    mpfr_clear(shown);
    return context_fail_in(context, GRAZE_EINPUT, list->source, p->line,
                           "the matrix is no rotation: an entry is %s off the nearest one; "
                           "expected a rotation, a larger tolerance, or affine poses",
                           digits);
}

/* Find the quaternions of all matrices, and report the largest deviation. */
static graze_status find_rotations(text *report, graze_context *context, pose_list *list,
                                   const fmpq_t tolerance) {
    static const double unturned[4] = {1, 0, 0, 0};
    double before[4] = {1, 0, 0, 0}, matrix[9], q[4];
    graze_status status = GRAZE_OK;
    fmpq_t deviation, worst;
    mpq_t entry;
    fmpq_init(worst);
    fmpq_init(deviation);
    mpq_init(entry);
    for (size_t i = 0; i < list->count && !status; i++) {
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
        for (int k = 0; k < 4 && !status; k++)
            status = rational_from_double(p->quaternion + k, context, before[k]);
        pose_deviation(deviation, p);
        if (fmpq_cmp(deviation, worst) > 0)
            fmpq_set(worst, deviation);
        if (!status && fmpq_cmp(deviation, tolerance) > 0)
            status = refuse_pose(context, list, p, deviation);
    }
    if (!status)
        put_rational_fact(
            report, "rotations: nearest to the matrices, whose entries they change by", worst);
    mpq_clear(entry);
    fmpq_clear(worst);
    fmpq_clear(deviation);
    return status;
}

/* Whether b is a multiple of a, which is not zero, by a number below zero. */
static int are_opposite(const fmpq *a, const fmpq *b) {
    fmpq_t along, sine;
    fmpq_init(along);
    fmpq_init(sine);
    int parallel = 1;
    for (int k = 0; k < 4; k++) {
        fmpq_addmul(along, a + k, b + k);
        for (int j = 0; j < k; j++) {
            fmpq_mul(sine, a + j, b + k);
            fmpq_submul(sine, a + k, b + j);
            parallel &= fmpq_is_zero(sine);
        }
    }
    parallel &= fmpq_sgn(along) < 0;
    fmpq_clear(along);
    fmpq_clear(sine);
    return parallel;
}

/* No quaternion may be zero, nor become zero between two poses. */
static graze_status check_quaternions(graze_context *context, const pose_list *list) {
    for (size_t i = 0; i < list->count; i++) {
        const pose *p = list->item + i;
        int zero = 1;
        for (int k = 0; k < 4; k++)
            zero &= fmpq_is_zero(p->quaternion + k);
        if (zero)
            return context_fail_in(context, GRAZE_EINPUT, list->source, p->line,
                                   "the quaternion is zero; expected that of a rotation");
        if (i && are_opposite(p[-1].quaternion, p->quaternion))
            return context_fail_in(context, GRAZE_EINPUT, list->source, p->line,
                                   "the quaternion is opposite to that of line %lu, and zero "
                                   "between them; expected the same rotation with the other signs",
                                   p[-1].line);
    }
    return GRAZE_OK;
}

static void put_keyframes(text *t, const pose_list *list) {
    text_put(t, "{\"dimension\": 3,\n\"keyframes\": [\n");
    for (size_t i = 0; i < list->count; i++) {
        const pose *p = list->item + i;
        fmpq position[3];
        for (int k = 0; k < 3; k++)
            position[k] = p->matrix[4 * k + 3];
        text_put(t, " {\"t\": \"");
        text_rational(t, p->time);
        text_format(t, "\", \"row\": %lu, \"position\": ", p->row);
        put_vector(t, position, 3);
        if (list->form != POSES_OF_POSITIONS) {
            text_put(t, ", \"quaternion\": ");
            put_vector(t, p->quaternion, 4);
        }
        text_put(t, i + 1 < list->count ? "},\n" : "}\n");
    }
    text_put(t, "]}\n");
}

static void put_interpolated(text *t, const fmpq *from, const fmpq *to) {
    fmpq_t step;
    fmpq_init(step);
    fmpq_sub(step, to, from);
    text_rational(t, from);
    text_put(t, "+(");
    text_rational(t, step);
    text_put(t, ")*s");
    fmpq_clear(step);
}

static void put_matrices(text *t, const pose_list *list) {
    text_put(t, "{\"dimension\": 3,\n\"pieces\": [\n");
    for (size_t i = 0; i + 1 < list->count; i++) {
        const pose *p = list->item + i;
        text_put(t, " {\"t\": [\"");
        text_rational(t, p[0].time);
        text_put(t, "\", \"");
        text_rational(t, p[1].time);
        text_format(t, "\"], \"row\": %lu, \"transform\": {\"matrix\": [\n", p[1].row);
        for (int k = 0; k < 12; k++) {
            text_put(t, k % 4 ? "\", \"" : "  [\"");
            put_interpolated(t, p[0].matrix + k, p[1].matrix + k);
            text_put(t, k % 4 < 3 ? "" : k < 11 ? "\"],\n" : "\"]]}}");
        }
        text_put(t, i + 2 < list->count ? ",\n" : "\n");
    }
    text_put(t, "]}\n");
}

/* Is the quaternion of a pose more than 90 degrees from the one before: more than 180 of rotation?
 */
static int is_long_way(const pose *p) {
    return pose_along(p) < 0;
}

/* Begin or go on with a list of poses, of which the first few are named. */
static void put_pose_row(text *t, size_t count, const char *before, const char *what,
                         const pose *p) {
    enum { NAMED = 10 };
    if (count == 0)
        text_format(t, "%s%s ", before, what);
    if (count < NAMED)
        text_format(t, "%s%lu", count ? ", " : "", p->row);
    else if (count == NAMED)
        text_put(t, ", ...");
}

/* Give each quaternion the sign that is nearer to the one before. */
static void take_short_ways(text *t, pose_list *list, int numbered) {
    size_t count = 0;
    for (size_t i = 1; i < list->count; i++) {
        pose *p = list->item + i;
        if (!is_long_way(p))
            continue;
        pose_negate(p);
        put_pose_row(t, count++, "shortest: signs of quaternions changed at",
                     numbered ? " poses" : " lines", p);
    }
    text_format(t, count ? "; %zu in all\n" : "shortest: no sign of a quaternion changed\n", count);
}

static void report_long_ways(text *t, pose_list *list, int numbered) {
    size_t count = 0;
    for (size_t i = 1; i < list->count; i++)
        if (is_long_way(list->item + i))
            put_pose_row(
                t, count++,
                "long way: the signs of the quaternions ask for more than half a turn up to the "
                "poses",
                numbered ? "" : " of lines", &list->item[i]);
    if (count)
        text_format(t, "; %zu in all; they are kept (`--shortest` changes signs)\n", count);
}

/* What was read, and what was done with it. */
static void report_poses(text *t, const pose_list *list, int affine, const pose_choice *choice) {
    text_format(t, "poses: %zu", list->count);
    if (list->count < list->rows)
        text_format(t, " of %lu", list->rows);
    text_format(t, ", each %s exactly as given at its time\n",
                affine || list->form == POSES_OF_QUATERNIONS ? "one" : "position");
    if (!fmpq_is_one(choice->scale)) {
        text_put(t, "scale: positions are those given times ");
        text_rational(t, choice->scale);
        text_put(t, "\n");
    }
    text_put(t, affine ? "between: every entry of the matrix is linear\n"
                : list->form == POSES_OF_POSITIONS
                    ? "between: the position is linear; the list has no rotations\n"
                    : "between: position and quaternion are linear, the quaternion not "
                      "normalised\n");
}

/* Quaternions of what the rows have for rotations. */
static graze_status find_quaternions(conversion *out, graze_context *context, pose_list *list,
                                     const pose_choice *choice, int shortest,
                                     const fmpq_t tolerance) {
    graze_status status = GRAZE_OK;
    if (list->form == POSES_OF_POSITIONS)
        return GRAZE_OK;
    if (list->form == POSES_OF_MATRICES)
        status = find_rotations(&out->report, context, list, tolerance);
    else if (list->form != POSES_OF_QUATERNIONS)
        status = poses_turn(&out->report, context, list, choice->naming.order, tolerance);
    if (!status)
        (shortest ? take_short_ways : report_long_ways)(&out->report, list, choice->numbered);
    return status ? status : check_quaternions(context, list);
}

graze_status convert_poses(conversion *out, graze_context *context, const char *path,
                           const pose_choice *choice, int affine, int shortest,
                           const fmpq_t tolerance) {
    pose_list list;
    graze_status status = poses_read(&list, &out->report, context, path, choice);
    if (!status && affine && list.form != POSES_OF_MATRICES)
        status = context_fail_in(context, GRAZE_EINPUT, path, 0,
                                 "the poses are no matrices; expected matrices for an affine "
                                 "motion");
    if (!status)
        report_poses(&out->report, &list, affine, choice);
    if (!status && !affine)
        status = find_quaternions(out, context, &list, choice, shortest, tolerance);
    if (!status)
        (affine ? put_matrices : put_keyframes)(&out->motion, &list);
    poses_clear(&list);
    return status;
}
