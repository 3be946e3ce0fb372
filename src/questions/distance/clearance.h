/* How far a point is at least from where the membership changes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_CLEARANCE_H
#define GRAZE_DISTANCE_CLEARANCE_H

#include "questions/distance/distance.h"

/**
 * A lower bound of the distance from the boundary of the sweep: all points that are nearer than it
 * have the membership of the point. 0 where none is proved, and of points `on` (proofs/judging.md
 * C120).
 * @param found of the point, whose answer is `pmc`
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
graze_status distance_to_boundary(double *low, graze_context *context, const graze_scene *scene,
                                  const fmpq *point, graze_pmc pmc, const distance *found);

#endif
