/* Tests whether a solid's boundary meets its image under an affine map.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCENE_MEETING_H
#define GRAZE_SCENE_MEETING_H

#include "input/solid/solid.h"

/**
 * Decide whether the boundary of S and its image have a common point.
 * @param map d*(d+1) rationals, row by row, invertible
 * @return GRAZE_ESYSTEM, GRAZE_ECANCELED
 */
graze_status meeting_find(int *out, graze_context *context, const graze_solid *solid,
                          const fmpq *map);

#endif
