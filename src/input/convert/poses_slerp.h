/* SLERP between poses: how far linear quaternions are from it, and poses between that come near.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_POSES_SLERP_H
#define GRAZE_CONVERT_POSES_SLERP_H

#include "input/convert/poses_read.h"

/** The way to a pose, and what is known of all ways before. Only the tolerance is set at first. */
typedef struct slerp_course {
    const fmpq *tolerance; /* of the angle between both rotations at one time; NULL: no halving */
    int halvings;          /* of the way */
    size_t pieces;         /* of all ways */
    double worst;          /* the angle off SLERP, radians, at most */
    unsigned long row;     /* of the pose that the way of that bound leads to; 0: none turns */
} slerp_course;

/** Look at the way to a pose, item `i` of a list, from the one before: how often it is halved and
 * how far it then is from SLERP. Where it may be halved, a factor brings the quaternion to
 * length 1.
 * @return GRAZE_EINPUT a quaternion that is 0, or opposite to the one before; GRAZE_ELIMIT,
 * GRAZE_ECANCELED */
graze_status slerp_look(slerp_course *s, graze_context *context, const pose_list *list, size_t i);

/** The pose in the middle of two. @param[out] out initialised */
void slerp_middle(pose *out, const slerp_course *s, const pose *from, const pose *to);

void slerp_report(text *t, const slerp_course *s, const char *unit);

#endif
