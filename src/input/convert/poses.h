/* A motion through poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_POSES_H
#define GRAZE_CONVERT_POSES_H

#include <flint/fmpq.h>
#include "input/convert/conversion.h"
#include "input/convert/poses_read.h"

/** Poses from a file or a text; `affine`: matrices as they are; `shortest`: signs of quaternions
 * are changed where that makes the way shorter. */
graze_status convert_poses(conversion *out, graze_context *context, const char *path,
                           const pose_choice *choice, int affine, int shortest,
                           const fmpq_t tolerance);

#endif
