/* The public functions that make motion files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include <stdlib.h>
#include "base/context/scope.h"
#include "input/convert/convert.h"
#include "input/motion/motion.h"

static void clear_texts(char **json, char **report) {
    if (json)
        *json = NULL;
    if (report)
        *report = NULL;
}

/* Read the motion that was made; only a legal one is handed out. */
static graze_status finish_conversion(char **json, char **report, graze_context *context,
                                      conversion *made, graze_status status) {
    graze_motion *motion = NULL;
    if (!status && !made->motion.failed)
        status = motion_from_text(&motion, context, made->motion.data, made->motion.length);
    if (motion)
        motion_destroy(motion);
    if (!status)
        status = text_finish(json, context, &made->motion);
    else
        text_clear(&made->motion);
    if (!status && report)
        status = text_finish(report, context, &made->report);
    else
        text_clear(&made->report);
    if (status) {
        free(*json);
        *json = NULL;
    }
    return status;
}

static graze_status take_positive(fmpq_t out, graze_context *context, mpq_srcptr value, int strict,
                                  const char *name) {
    TRY(api_rational(out, context, value));
    if (fmpq_sgn(out) < 0 || (strict && fmpq_is_zero(out)))
        return context_fail(context, GRAZE_EUSE, "the %s must be %s", name,
                            strict ? "positive" : "0 or more");
    return GRAZE_OK;
}

static graze_status take_joint(joint *out, graze_context *context, int dimension,
                               const graze_joint *given) {
    joint_init(out);
    if (given->kind != GRAZE_JOINT_TURN && given->kind != GRAZE_JOINT_SLIDE)
        return context_fail(context, GRAZE_EUSE, "a joint is a turn or a slide");
    out->is_slide = given->kind == GRAZE_JOINT_SLIDE;
    int components = out->is_slide || dimension == 3 ? dimension : 0;
    if ((components && !given->axis) || (!out->is_slide && !given->degrees))
        return context_fail(context, GRAZE_EUSE,
                            "a turn has degrees and in E^3 an axis, a slide has a way");
    graze_status status = GRAZE_OK;
    for (int k = 0; k < components && !status; k++)
        status = api_rational(out->axis + k, context, given->axis[k]);
    if (!components)
        fmpq_one(out->axis + 2);
    if (out->is_slide || status)
        return status;
    status = api_rational(out->degrees, context, given->degrees);
    if (!status && given->pitch && dimension == 3)
        status = api_rational(out->advance, context, given->pitch);
    for (int k = 0; k < dimension && given->center && !status; k++) {
        status = api_rational(out->center + k, context, given->center[k]);
        out->centered |= !fmpq_is_zero(out->center + k);
    }
    return status;
}

static graze_status chain(char **json, char **report, graze_context *context, int dimension,
                          const graze_joint *given, size_t count, mpq_srcptr tolerance,
                          mpq_srcptr radius, int uniform) {
    IN_ENVIRONMENT();
    target goal = {.dimension = dimension};
    conversion made;
    FREED(joint, joints, calloc(count, sizeof *joints));
    size_t taken = 0;
    graze_status status = GRAZE_OK;
    fmpq_init(goal.tolerance);
    fmpq_init(goal.radius);
    text_init(&made.motion);
    text_init(&made.report);
    if (!joints)
        status = context_fail(context, GRAZE_ESYSTEM, "out of memory");
    if (!status)
        status = take_positive(goal.tolerance, context, tolerance, 1, "tolerance");
    if (!status)
        status = take_positive(goal.radius, context, radius, 0, "radius");
    for (; taken < count && !status; taken++)
        status = take_joint(joints + taken, context, dimension, given + taken);
    if (!status)
        status = joints_measure(joints, context, &goal, count);
    if (!status)
        status = uniform ? convert_joints(&made, context, &goal, joints, count)
                         : convert_rotation(&made, context, &goal, joints);
    status = finish_conversion(json, report, context, &made, status);
    while (taken > 0)
        joint_clear(joints + --taken);
    fmpq_clear(goal.radius);
    fmpq_clear(goal.tolerance);
    return status;
}

static int chain_usable(char **json, char **report, int dimension, const graze_joint *joints,
                        size_t count, mpq_srcptr tolerance, mpq_srcptr radius) {
    clear_texts(json, report);
    return json && joints && count && tolerance && radius && (dimension == 2 || dimension == 3);
}

graze_status graze_motion_write_rotation(char **json, char **report, graze_context *context,
                                         int dimension, const graze_joint *turn,
                                         mpq_srcptr tolerance, mpq_srcptr radius) {
    if (!chain_usable(json, report, dimension, turn, 1, tolerance, radius) || !context ||
        turn->kind != GRAZE_JOINT_TURN)
        return api_misuse(context, "graze_motion_write_rotation",
                          "no argument but report may be NULL, the dimension is 2 or 3, and the "
                          "joint a turn");
    return chain(json, report, context, dimension, turn, 1, tolerance, radius, 0);
}

graze_status graze_motion_write_joints(char **json, char **report, graze_context *context,
                                       int dimension, const graze_joint *joints, size_t count,
                                       mpq_srcptr tolerance, mpq_srcptr radius) {
    if (!chain_usable(json, report, dimension, joints, count, tolerance, radius) || !context)
        return api_misuse(context, "graze_motion_write_joints",
                          "no argument but report may be NULL, the dimension is 2 or 3, and there "
                          "is a joint");
    return chain(json, report, context, dimension, joints, count, tolerance, radius, 1);
}

static graze_status take_poses(pose_choice *out, graze_context *context,
                               const graze_pose_options *o) {
    *out = (pose_choice){.naming = {.ignored = o->ignored,
                                    .ignored_count = o->ignored_count,
                                    .columns = o->columns,
                                    .order = o->angles ? angle_order_of(o->angles) : NULL},
                         .has_from = o->from != NULL,
                         .has_to = o->to != NULL,
                         .every = o->every ? o->every : 1,
                         .numbered = (o->flags & GRAZE_POSES_NUMBERED) != 0,
                         .text = o->text,
                         .length = o->length};
    fmpq_init(out->from);
    fmpq_init(out->to);
    fmpq_init(out->scale);
    fmpq_one(out->scale);
    graze_status status =
        o->scale ? take_positive(out->scale, context, o->scale, 1, "scale") : GRAZE_OK;
    if (!status && o->from)
        status = api_rational(out->from, context, o->from);
    return !status && o->to ? api_rational(out->to, context, o->to) : status;
}

/* Options that are known. */
static graze_status write_poses(char **json, char **report, graze_context *context,
                                const char *path, const graze_pose_options *o) {
    IN_ENVIRONMENT();
    conversion made;
    pose_choice choice;
    LOCAL(fmpq, tolerance);
    fmpq_set_si(tolerance, 1, 1000000);
    text_init(&made.motion);
    text_init(&made.report);
    graze_status status = take_poses(&choice, context, o);
    if (!status && o->tolerance)
        status = take_positive(tolerance, context, o->tolerance, 0, "tolerance");
    if (!status)
        status = convert_poses(&made, context, path, &choice, o->flags, tolerance);
    fmpq_clear(choice.from);
    fmpq_clear(choice.to);
    fmpq_clear(choice.scale);
    return finish_conversion(json, report, context, &made, status);
}

graze_status graze_motion_write_poses(char **json, char **report, graze_context *context,
                                      const char *path, mpq_srcptr tolerance, unsigned flags) {
    clear_texts(json, report);
    if (!json || !context || !path || !tolerance)
        return api_misuse(context, "graze_motion_write_poses",
                          "no argument but report may be NULL");
    if (flags & ~(GRAZE_POSES_AFFINE | GRAZE_POSES_LONG))
        return api_misuse(context, "graze_motion_write_poses", "an unknown flag is set");
    graze_pose_options options = {.flags = flags, .tolerance = tolerance};
    return write_poses(json, report, context, path, &options);
}

graze_status graze_motion_write_pose_list(char **json, char **report, graze_context *context,
                                          const char *path, const graze_pose_options *options) {
    static const char name[] = "graze_motion_write_pose_list";
    clear_texts(json, report);
    if (!json || !context || !path)
        return api_misuse(context, name, "json, context and path must not be NULL");
    graze_pose_options taken;
    TRY(api_options(&taken, sizeof taken, context, name, options));
    if (taken.flags & ~(GRAZE_POSES_AFFINE | GRAZE_POSES_SHORTEST | GRAZE_POSES_NUMBERED |
                        GRAZE_POSES_LONG | GRAZE_POSES_SLERP))
        return api_misuse(context, name, "an unknown flag is set");
    if ((taken.flags & GRAZE_POSES_LONG &&
         taken.flags & (GRAZE_POSES_SHORTEST | GRAZE_POSES_SLERP)) ||
        (taken.flags & GRAZE_POSES_AFFINE && taken.flags & GRAZE_POSES_SLERP))
        return context_fail(context, GRAZE_EUSE,
                            "long ways go with neither `shortest` nor `slerp`, affine poses not "
                            "with `slerp`; expected one of them");
    if (taken.angles && !angle_order_of(taken.angles))
        return context_fail(context, GRAZE_EUSE,
                            "angles '%s': expected kuka, fanuc, staubli, kawasaki, cnc or rpy",
                            taken.angles);
    if (taken.ignored_count && !taken.ignored)
        return api_misuse(context, name, "ignored must not be NULL where names are counted");
    return write_poses(json, report, context, path, &taken);
}

graze_status graze_motion_write_dyadic(char **json, char **report, graze_context *context,
                                       const graze_motion *motion, mpq_srcptr tolerance) {
    clear_texts(json, report);
    if (!json || !context || !motion || !tolerance)
        return api_misuse(context, "graze_motion_write_dyadic",
                          "no argument but report may be NULL");
    IN_ENVIRONMENT();
    conversion made;
    LOCAL(fmpq, allowed);
    text_init(&made.motion);
    text_init(&made.report);
    graze_status status = take_positive(allowed, context, tolerance, 1, "tolerance");
    if (!status)
        status = convert_dyadic(&made, context, motion, allowed);
    return finish_conversion(json, report, context, &made, status);
}
