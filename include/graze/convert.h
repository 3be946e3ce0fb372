/* graze/convert.h - motion files from turns, joints and poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_H
#define GRAZE_CONVERT_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a joint moves; uniformly as t goes from 0 to 1. */
typedef enum graze_joint_kind { GRAZE_JOINT_TURN = 0, GRAZE_JOINT_SLIDE = 1 } graze_joint_kind;

/** One joint of a chain, where it stands at t = 0. All numbers are canonical and borrowed. */
typedef struct graze_joint {
    graze_joint_kind kind;
    mpq_srcptr degrees;  /**< of a turn, counter-clockwise, of any size */
    mpq_srcptr pitch;    /**< of a turn in E^3: how far it moves along the axis with every 360
                              degrees; NULL: not at all */
    const mpq_t *axis;   /**< of a turn in E^3, of any length but 0; of a slide: its whole way, d
                              rationals */
    const mpq_t *center; /**< of a turn: a point on the axis, d rationals; NULL: the origin */
} graze_joint;

/**
 * Make a motion file of one turn: t runs from 0 to 1, and every position on the way is exactly one
 * of the turn asked for; the tangents of half angles are rational, so the turn ends at an angle
 * near the one asked for, and its speed is not uniform. Quarter turns are exact.
 * @param[out] json      the text of the file, checked to be a legal motion; for graze_free
 * @param[out] report    what was approximated, with proved bounds, for a person; for graze_free;
 * may be NULL
 * @param dimension      2 or 3
 * @param turn           one joint, a turn without pitch
 * @param tolerance      positive: at the end, no point is off by more than this
 * @param radius         not negative, for the points at most that far from the origin at t = 0
 * @return GRAZE_EUSE wrong use, an axis of length 0, or a tolerance too fine for the radius;
 * GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status
graze_motion_write_rotation(char **json, char **report, graze_context *context, int dimension,
                            const graze_joint *turn, mpq_srcptr tolerance, mpq_srcptr radius);
/**
 * Make a motion file of joints that all move uniformly for t from 0 to 1, the first applied first
 * (the product of exponentials; a screw of constant pitch is one such joint). Such a motion is
 * transcendental; it is cut into 2^m times as many pieces as the largest turn has quarters, and m
 * is the least with which no point is off by more than the tolerance at any time. Arguments as
 * above, and
 * @param joints `count` joints, at least one
 * @return as above; GRAZE_ELIMIT also more pieces than the limit; GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_write_joints(
    char **json, char **report, graze_context *context, int dimension, const graze_joint *joints,
    size_t count, mpq_srcptr tolerance, mpq_srcptr radius);

/** Take the matrices as affine maps and interpolate every entry linearly. */
#define GRAZE_POSES_AFFINE 1u

/**
 * Make a motion file in E^3 through poses from a CSV file with a line of names: columns qw, qx, qy,
 * qz with or without x, y, z; or m00 to m23, with or without m30 to m33. With a column t, or the
 * times are 0, 1, 2, ... No other columns. Numbers are rounded as the context says. Quaternions
 * keep their signs; matrices become the nearest rotation's quaternion in binary64, of the sign
 * nearest to the one before. Position and quaternion are interpolated linearly.
 * @param flags     0 or GRAZE_POSES_AFFINE
 * @param tolerance not negative: no entry of a matrix may be changed by more than this
 * @return GRAZE_ESYSTEM the file cannot be read; GRAZE_EINPUT it is no such list, or a matrix is no
 * rotation; GRAZE_EILLEGAL no legal motion goes through the poses so; GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_write_poses(char **json, char **report,
                                                              graze_context *context,
                                                              const char *path, unsigned flags,
                                                              mpq_srcptr tolerance);

#ifdef __cplusplus
}
#endif
#endif
