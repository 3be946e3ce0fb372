/* Location of points by the crossings of a ray.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SOLID_LOCATE_H
#define GRAZE_SOLID_LOCATE_H

#include "input/solid/solid.h"

/**
 * The signed crossings of one ray from a point, made generic by an infinitesimal displacement
 * (proofs/claims.md C6): the winding number where the surface closes, its parity where it
 * closes modulo 2 (proofs/mesh.md C114).
 * @param[out] on 1 if x lies on a simplex
 * @param x d + 1 homogeneous integers, x[d] > 0
 */
long skin_winding(int *on, const skin *s, const fmpz *x);

/**
 * Location of a point: I, B or O, by the winding number. `x` are d + 1 homogeneous integers, x[d] >
 * 0.
 * @return GRAZE_STATE_ABSENT if the crossings add up to neither, which only a fault of Graze causes
 */
graze_state solid_locate(const graze_solid *solid, const fmpz *x);

/**
 * One side test per component of the boundary: the winding number must be 1 on the inner side and 0
 * on the outer side of one facet of it; then it is so for all (proofs/claims.md C3, C4).
 */
graze_status solid_check_sides(const graze_solid *solid, graze_context *context);

#endif
