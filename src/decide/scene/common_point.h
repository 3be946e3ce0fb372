/* Tests whether a curved solid certainly meets its image, or certainly does not (proofs/curved.md
 * C103). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCENE_COMMON_POINT_H
#define GRAZE_SCENE_COMMON_POINT_H

#include <flint/fmpq_mat.h>
#include "input/csg/csg.h"

/**
 * Test whether the boxes are disjoint; else look for a point in the interior of both sets.
 * @param map, inverse homogeneous matrices
 * @return GRAZE_ESYSTEM, GRAZE_ECANCELED
 */
graze_status common_point_ends(graze_ends *out, graze_context *context, const csg *solid,
                               const fmpq_mat_t map, const fmpq_mat_t inverse);

#endif
