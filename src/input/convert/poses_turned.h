/* Rotations of poses that have a tool's axis, or angles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_POSES_TURNED_H
#define GRAZE_CONVERT_POSES_TURNED_H

#include "input/convert/poses_read.h"

/**
 * Find the quaternions of a list of axes or angles, each with the sign that is nearer to the one
 * before.
 * @param[out] report the largest error
 * @param order       of angles
 * @return GRAZE_EINPUT an axis is zero or opposite to (0, 0, 1), or an error exceeds the tolerance
 */
graze_status poses_turn(text *report, graze_context *context, pose_list *list,
                        const angle_order *order, const fmpq_t tolerance);

/** Bits of an angle such that the errors of three angles together stay within the tolerance; 0 asks
 * for the finest. */
slong bits_within(const fmpq_t tolerance);

/** Sign of the scalar product of a pose's quaternion with that of the pose before. */
int pose_along(const pose *p);
/** Change the sign of a pose's quaternion. */
void pose_negate(pose *p);

#endif
