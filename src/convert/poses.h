/* A motion through poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_POSES_H
#define GRAZE_CONVERT_POSES_H

#include <flint/fmpq.h>
#include "convert/conversion.h"

/** Poses from a CSV file; `affine`: matrices as they are. */
graze_status convert_poses(conversion *out, graze_context *context, const char *path, int affine,
                           const fmpq_t tolerance);

#endif
