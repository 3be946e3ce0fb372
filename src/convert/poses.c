/* Motions through poses: keyframes, or matrices interpolated entry by entry.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The motion passes through each pose at its time. Only matrices that become rotations are changed,
 * by an amount that is computed exactly and reported.
 */
#include "convert/poses.h"

#include <math.h>
#include "convert/joint.h"
#include "convert/poses_nearest.h"
#include "convert/poses_read.h"
#include "number/rounding.h"

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

/* Find the quaternions of all matrices; `worst` is the largest deviation. */
static graze_status find_rotations(fmpq_t worst, graze_context *context, pose_list *list,
                                   const fmpq_t tolerance) {
    double before[4] = {1, 0, 0, 0}, matrix[9], q[4];
    graze_status status = GRAZE_OK;
    fmpq_t deviation;
    mpq_t entry;
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
        for (int k = 0; k < 4 && !status; k++) {
            before[k] = finite ? q[k] : k == 0;
            status = rational_from_double(p->quaternion + k, context, before[k]);
        }
        pose_deviation(deviation, p);
        if (fmpq_cmp(deviation, worst) > 0)
            fmpq_set(worst, deviation);
        if (!status && fmpq_cmp(deviation, tolerance) > 0)
            status = refuse_pose(context, list, p, deviation);
    }
    mpq_clear(entry);
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
        text_put(t, "\", \"position\": ");
        put_vector(t, position, 3);
        text_put(t, ", \"quaternion\": ");
        put_vector(t, p->quaternion, 4);
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
        text_put(t, "\"], \"transform\": {\"matrix\": [\n");
        for (int k = 0; k < 12; k++) {
            text_put(t, k % 4 ? "\", \"" : "  [\"");
            put_interpolated(t, p[0].matrix + k, p[1].matrix + k);
            text_put(t, k % 4 < 3 ? "" : k < 11 ? "\"],\n" : "\"]]}}");
        }
        text_put(t, i + 2 < list->count ? ",\n" : "\n");
    }
    text_put(t, "]}\n");
}

/* Pairs of poses whose quaternions are more than 90 degrees apart: more than 180 of rotation. */
static void report_long_ways(text *t, const pose_list *list) {
    size_t count = 0;
    fmpq_t along;
    fmpq_init(along);
    for (size_t i = 0; i + 1 < list->count; i++) {
        fmpq_zero(along);
        for (int k = 0; k < 4; k++)
            fmpq_addmul(along, list->item[i].quaternion + k, list->item[i + 1].quaternion + k);
        if (fmpq_sgn(along) >= 0)
            continue;
        if (count++ == 0)
            text_format(t,
                        "long way: from line %lu to line %lu the signs of the quaternions ask "
                        "for more than half a turn\n",
                        list->item[i].line, list->item[i + 1].line);
    }
    if (count > 1)
        text_format(t, "long way: the same at %zu further pairs\n", count - 1);
    fmpq_clear(along);
}

static void report_deviation(text *t, const fmpq_t worst) {
    mpfr_t bound;
    mpq_t copy;
    mpfr_init2(bound, 64);
    mpq_init(copy);
    fmpq_get_mpq(copy, worst);
    mpfr_set_q(bound, copy, MPFR_RNDU);
    put_fact(t, "rotations: nearest to the matrices, whose entries they change by", bound, "");
    mpq_clear(copy);
    mpfr_clear(bound);
}

graze_status convert_poses(conversion *out, graze_context *context, const char *path, int affine,
                           const fmpq_t tolerance) {
    pose_list list;
    fmpq_t worst;
    fmpq_init(worst);
    graze_status status = poses_read(&list, context, path);
    if (!status && affine && !list.has_matrices)
        status =
            context_fail_in(context, GRAZE_EINPUT, path, 0,
                            "the poses are quaternions; expected matrices for an affine motion");
    if (!status && !affine && list.has_matrices)
        status = find_rotations(worst, context, &list, tolerance);
    if (!status && !affine)
        status = check_quaternions(context, &list);
    if (!status) {
        (affine ? put_matrices : put_keyframes)(&out->motion, &list);
        text_format(&out->report, "poses: %zu, each %s exactly as given at its time\n", list.count,
                    !affine && list.has_matrices ? "position" : "one");
        text_put(&out->report, affine ? "between: every entry of the matrix is linear\n"
                                      : "between: position and quaternion are linear, the "
                                        "quaternion not normalised\n");
        if (!affine)
            report_long_ways(&out->report, &list);
        if (!affine && list.has_matrices)
            report_deviation(&out->report, worst);
    }
    poses_clear(&list);
    fmpq_clear(worst);
    return status;
}
