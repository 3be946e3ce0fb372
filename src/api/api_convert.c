/* The public functions that make motion files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "base/number/rounding.h"
#include "input/convert/convert.h"

static void conversion_init(conversion *c) {
    text_init(&c->motion);
    text_init(&c->report);
}

static void conversion_clear(conversion *c) {
    text_clear(&c->motion);
    text_clear(&c->report);
}

/* Read a motion that was made, whose numbers are rounded already. */
static graze_status read_conversion(graze_motion **out, graze_context *context, const char *json,
                                    size_t length) {
    graze_rounding rounding = context->rounding;
    context->rounding = GRAZE_ROUND_NONE;
    graze_status status = motion_from_text(out, context, json, length);
    context->rounding = rounding;
    return status;
}

/* Only a legal motion is handed out. */
static graze_status finish_conversion(char **json, char **report, graze_context *context,
                                      conversion *made) {
    graze_motion *motion = NULL;
    if (!made->motion.failed)
        TRY(read_conversion(&motion, context, made->motion.data, made->motion.length));
    graze_motion_destroy(motion);
    TRY(text_finish(json, context, &made->motion));
    if (!report || !text_finish(report, context, &made->report))
        return GRAZE_OK;
    free(*json);
    *json = NULL;
    return GRAZE_ESYSTEM;
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
    if (given->kind != GRAZE_JOINT_TURN && given->kind != GRAZE_JOINT_SLIDE)
        return context_fail(context, GRAZE_EUSE, "a joint is a turn or a slide");
    out->is_slide = given->kind == GRAZE_JOINT_SLIDE;
    int components = out->is_slide || dimension == 3 ? dimension : 0;
    if ((components && !given->axis) || (!out->is_slide && !given->degrees))
        return context_fail(context, GRAZE_EUSE,
                            "a turn needs degrees and in E^3 an axis, a slide a displacement");
    for (int k = 0; k < components; k++)
        TRY(api_rational(out->axis + k, context, given->axis[k]));
    if (!components)
        fmpq_one(out->axis + 2);
    if (out->is_slide)
        return GRAZE_OK;
    TRY(api_rational(out->degrees, context, given->degrees));
    if (given->pitch && dimension == 3)
        TRY(api_rational(out->advance, context, given->pitch));
    for (int k = 0; k < dimension && given->center; k++) {
        TRY(api_rational(out->center + k, context, given->center[k]));
        out->centered |= !fmpq_is_zero(out->center + k);
    }
    return GRAZE_OK;
}

static graze_status convert_chain(conversion *made, joint *joints, const target *goal,
                                  graze_context *context, const graze_joint *given, size_t count,
                                  int uniform) {
    for (size_t k = 0; k < count; k++)
        TRY(take_joint(joints + k, context, goal->dimension, given + k));
    TRY(joints_measure(joints, context, goal, count));
    return uniform ? convert_joints(made, context, goal, joints, count)
                   : convert_rotation(made, context, goal, joints);
}

static graze_status chain(char **json, char **report, graze_context *context, int dimension,
                          const graze_joint *given, size_t count, mpq_srcptr tolerance,
                          mpq_srcptr radius, int uniform) {
    IN_ENVIRONMENT();
    LOCAL_VEC(fmpq, bound, 2);
    target goal = {dimension, bound, bound + 1};
    HELD(conversion, made);
    TRY(take_positive(goal.tolerance, context, tolerance, 1, "tolerance"));
    TRY(take_positive(goal.radius, context, radius, 0, "radius"));
    FREED(joint, joints, calloc(count, sizeof *joints));
    if (!joints)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    for (size_t k = 0; k < count; k++)
        joint_init(joints + k);
    graze_status status = convert_chain(&made, joints, &goal, context, given, count, uniform);
    for (size_t k = 0; k < count; k++)
        joint_clear(joints + k);
    TRY(status);
    return finish_conversion(json, report, context, &made);
}

static int chain_usable(char **json, char **report, int dimension, const graze_joint *joints,
                        size_t count, mpq_srcptr tolerance, mpq_srcptr radius) {
    EMPTY(json);
    EMPTY(report);
    return json && joints && count && tolerance && radius && (dimension == 2 || dimension == 3);
}

graze_status graze_motion_write_rotation(char **json, char **report, graze_context *context,
                                         int dimension, const graze_joint *turn,
                                         mpq_srcptr tolerance, mpq_srcptr radius) {
    REFUSED(!chain_usable(json, report, dimension, turn, 1, tolerance, radius) || !context ||
                turn->kind != GRAZE_JOINT_TURN,
            "no argument but report may be NULL, the dimension is 2 or 3, and the "
            "joint a turn");
    return chain(json, report, context, dimension, turn, 1, tolerance, radius, 0);
}

graze_status graze_motion_write_joints(char **json, char **report, graze_context *context,
                                       int dimension, const graze_joint *joints, size_t count,
                                       mpq_srcptr tolerance, mpq_srcptr radius) {
    REFUSED(!chain_usable(json, report, dimension, joints, count, tolerance, radius) || !context,
            "no argument but report may be NULL, the dimension is 2 or 3, and there "
            "is a joint");
    return chain(json, report, context, dimension, joints, count, tolerance, radius, 1);
}

static graze_status take_poses(pose_choice *out, fmpq *number, graze_context *context,
                               const graze_pose_options *o) {
    *out = (pose_choice){.naming = {.ignored = o->ignored,
                                    .ignored_count = o->ignored_count,
                                    .columns = o->columns,
                                    .order = angle_order_of(o->angles           ? o->angles
                                                            : o->dimension == 2 ? "theta"
                                                                                : ""),
                                    .dimension = o->dimension ? o->dimension : 3},
                         .from = o->from ? number : NULL,
                         .to = o->to ? number + 1 : NULL,
                         .scale = number + 2,
                         .every = o->every ? o->every : 1,
                         .numbered = (o->flags & GRAZE_POSES_NUMBERED) != 0,
                         .text = o->text,
                         .length = o->length};
    fmpq_one(number + 2);
    if (o->scale)
        TRY(take_positive(number + 2, context, o->scale, 1, "scale"));
    if (o->from)
        TRY(api_rational(number, context, o->from));
    return o->to ? api_rational(number + 1, context, o->to) : GRAZE_OK;
}

/* Options that are known. */
static graze_status write_poses(char **json, char **report, graze_context *context,
                                const char *path, const graze_pose_options *o) {
    IN_ENVIRONMENT();
    HELD(conversion, made);
    pose_choice choice;
    LOCAL_VEC(fmpq, tolerance, 4);
    fmpq_set_si(tolerance, 1, 1000000);
    TRY(take_poses(&choice, tolerance + 1, context, o));
    if (o->tolerance)
        TRY(take_positive(tolerance, context, o->tolerance, 0, "tolerance"));
    TRY(convert_poses(&made, context, path, &choice, o->flags, tolerance));
    return finish_conversion(json, report, context, &made);
}

graze_status graze_motion_write_poses(char **json, char **report, graze_context *context,
                                      const char *path, mpq_srcptr tolerance, unsigned flags) {
    EMPTY(json);
    EMPTY(report);
    REFUSED(!json || !context || !path || !tolerance, "no argument but report may be NULL");
    REFUSED(flags & ~(GRAZE_POSES_AFFINE | GRAZE_POSES_LONG), "an unknown flag is set");
    graze_pose_options options = {.flags = flags, .tolerance = tolerance};
    return write_poses(json, report, context, path, &options);
}

graze_status graze_motion_write_pose_list(char **json, char **report, graze_context *context,
                                          const char *path, const graze_pose_options *options) {
    EMPTY(json);
    EMPTY(report);
    PUBLIC(json, context, path);
    graze_pose_options taken;
    TRY(api_options(&taken, sizeof taken, context, __func__, options));
    REFUSED(taken.flags & ~(GRAZE_POSES_AFFINE | GRAZE_POSES_SHORTEST | GRAZE_POSES_NUMBERED |
                            GRAZE_POSES_LONG | GRAZE_POSES_SLERP),
            "an unknown flag is set");
    if ((taken.flags & GRAZE_POSES_LONG &&
         taken.flags & (GRAZE_POSES_SHORTEST | GRAZE_POSES_SLERP)) ||
        (taken.flags & GRAZE_POSES_AFFINE && taken.flags & GRAZE_POSES_SLERP))
        return context_fail(context, GRAZE_EUSE,
                            "long ways go with neither `shortest` nor `slerp`, affine poses not "
                            "with `slerp`; expected one of them");
    if (taken.angles && !angle_order_of(taken.angles))
        return context_fail(context, GRAZE_EUSE,
                            "angles '%s': expected kuka, fanuc, staubli, kawasaki, cnc, rpy or "
                            "theta",
                            taken.angles);
    REFUSED(taken.dimension && taken.dimension != 2 && taken.dimension != 3,
            "the dimension is 0, 2 or 3");
    REFUSED(taken.ignored_count && !taken.ignored,
            "ignored must not be NULL where names are counted");
    return write_poses(json, report, context, path, &taken);
}

/* Write rows as the list that they stand for. */
static graze_status list_rows(text *out, graze_context *context, const graze_pose_rows *rows) {
    LOCAL(fmpq, value);
    size_t width = 1;
    for (const char *c = rows->names; *c; c++)
        width += *c == ',';
    text_put(out, rows->names);
    for (size_t k = 0; k < width * rows->count; k++) {
        const char *number = rows->texts ? rows->texts[k] : "";
        if (!number || strpbrk(number, ",;#\"\r\n"))
            return context_fail(context, GRAZE_EINPUT, "pose %zu has a text that is no number",
                                k / width);
        if (!rows->texts)
            TRY(context_item(context, rational_from_double(value, context, rows->doubles[k]),
                             "pose", k / width, NULL));
        text_put(out, k % width ? "," : "\n");
        text_put(out, number);
        if (!rows->texts)
            text_rational(out, value);
    }
    return out->failed ? context_fail(context, GRAZE_ESYSTEM, "out of memory") : GRAZE_OK;
}

graze_status graze_motion_from_poses(graze_motion **out, char **report, graze_context *context,
                                     const graze_pose_rows *rows,
                                     const graze_pose_options *options) {
    EMPTY(report);
    PUBLIC_OUT(out, context, rows);
    graze_pose_rows given;
    graze_pose_options taken;
    FREED(char, json, NULL);
    HELD(text, list);
    TRY(api_options(&given, sizeof given, context, __func__, rows));
    TRY(api_options(&taken, sizeof taken, context, __func__, options));
    REFUSED(!given.names || strpbrk(given.names, "#\r\n") || !given.doubles == !given.texts,
            "names are one line, and one of doubles and texts is given");
    TRY(list_rows(&list, context, &given));
    taken.size = sizeof taken;
    taken.text = list.data;
    taken.length = list.length;
    TRY(graze_motion_write_pose_list(&json, report, context, "poses", &taken));
    graze_status status = read_conversion(out, context, json, strlen(json));
    if (status && report) {
        free(*report);
        *report = NULL;
    }
    return status;
}

graze_status graze_motion_write_gcode(char **json, char **report, graze_context *context,
                                      const char *path, const graze_gcode_options *options) {
    EMPTY(json);
    EMPTY(report);
    PUBLIC(json, context, path);
    graze_gcode_options taken;
    HELD(conversion, made);
    LOCAL_VEC(fmpq, start, 4);
    fmpq *tolerance = start + 3;
    TRY(api_options(&taken, sizeof taken, context, __func__, options));
    gcode_choice choice = {taken.start ? start : NULL, tolerance, taken.text, taken.length};
    fmpq_set_si(tolerance, 1, 200);
    if (taken.tolerance)
        TRY(take_positive(tolerance, context, taken.tolerance, 0, "tolerance"));
    for (int k = 0; k < 3 && taken.start; k++)
        TRY(api_rational(start + k, context, taken.start[k]));
    TRY(convert_gcode(&made, context, path, &choice));
    return finish_conversion(json, report, context, &made);
}

graze_status graze_motion_write_dyadic(char **json, char **report, graze_context *context,
                                       const graze_motion *motion, mpq_srcptr tolerance) {
    EMPTY(json);
    EMPTY(report);
    REFUSED(!json || !context || !motion || !tolerance, "no argument but report may be NULL");
    IN_ENVIRONMENT();
    HELD(conversion, made);
    LOCAL(fmpq, allowed);
    TRY(take_positive(allowed, context, tolerance, 1, "tolerance"));
    convert_dyadic(&made, motion, allowed);
    return finish_conversion(json, report, context, &made);
}
