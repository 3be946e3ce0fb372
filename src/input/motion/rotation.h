/* Rotations of a motion file as affine maps.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_ROTATION_H
#define GRAZE_MOTION_ROTATION_H

#include "input/motion/affine.h"
#include "input/motion/entry.h"

/* Rotations, in rotation.c. `out` is initialised; the value is that of the key. */

/** {"tan_half": e, "times": n, "center": [...], "axis": [...]} */
graze_status rotation_by_tangent(affine *out, graze_context *context, const json *value,
                                 const stretch *part);
/** {"quarters": n, "center": [...], "axis": [...]} */
graze_status rotation_by_quarters(affine *out, graze_context *context, const json *value,
                                  const stretch *part);
/** The integer of "quarters" in the value of a turn. */
graze_status rotation_quarters(fmpz_t out, graze_context *context, const json *value);
/** [w, x, y, z]; not about a center yet. */
graze_status rotation_by_quaternion(affine *out, graze_context *context, const json *value,
                                    const stretch *part);

/**
 * The rotation of a quaternion w, x, y, z, of any length; in E^2 x and y are zero and w + iz is the
 * half angle as a complex number. Only the ratios count, so a pole of the four is harmless.
 * @return GRAZE_EILLEGAL at `where` if they vanish together on the stretch [lo, hi] of t
 */
graze_status rotation_of(affine *out, graze_context *context, const json *where, fmpz_poly_q_t q[4],
                         const fmpq_t lo, const fmpq_t hi);

#endif
