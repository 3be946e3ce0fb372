/* The test whether a boundary meets its image under a map.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_OVERLAP_H
#define GRAZE_VALIDATE_OVERLAP_H

#include "input/soup/soup.h"
#include "input/validate/simplices.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Does any simplex of S touch any simplex of the image of S under the affine map? Both are closed
 * sets; the answer is exact. The caller tests whether one boundary lies inside the other solid.
 * @param map d*(d+1) rationals, row by row, invertible
 */
graze_status boundaries_meet(int *out, graze_context *context, const soup *s, const simplices *cut,
                             const fmpq *map);

#ifdef __cplusplus
}
#endif
#endif
