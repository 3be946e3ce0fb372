/* A motion through poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_POSES_H
#define GRAZE_CONVERT_POSES_H

#include <flint/fmpq.h>
#include "graze/convert.h"
#include "input/convert/conversion.h"
#include "input/convert/poses_read.h"

/** Poses from a file or a text. @param ways flags of graze/convert.h */
graze_status convert_poses(conversion *out, graze_context *context, const char *path,
                           const pose_choice *choice, unsigned ways, const fmpq_t tolerance);

#endif
