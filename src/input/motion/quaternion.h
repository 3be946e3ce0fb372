/* The rotation of a quaternion whose numbers are polynomials.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_QUATERNION_H
#define GRAZE_MOTION_QUATERNION_H

#include "input/motion/common_map.h"
#include "input/motion/entry.h"

/**
 * Set the linear part and its denominator to the rotation of a quaternion w, x, y, z, of any
 * length; in E^2 x and y are zero. q is divided by what its numbers have in common.
 * @param[in,out] out its dimension is set
 * @return GRAZE_EILLEGAL at `where` if they vanish together on the stretch [lo, hi] of t
 */
graze_status quaternion_rotation(common_map *out, graze_context *context, const json *where,
                                 fmpz_poly_struct q[4], const fmpq_t lo, const fmpq_t hi);

#endif
