/* A point that is out near a point with an undecided position: a hint, not a verdict.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_HINT_H
#define GRAZE_TOPO_HINT_H

#include "decide/scene/scene.h"
#include "questions/topo/finding.h"

/** Classify places about a point of E^3, from the nearest distance to the farthest: in a few
 * directions, and in the finding's open direction and plane.
 * @param[out] found  1 if a place is out
 * @param[out] out 3 initialised rationals: a place that is out, of the nearest distance with one
 * @param[out] places the place's distance is about the solid's width times 2^-places; if none is
 * out, it belongs to the farthest distance tried */
graze_status hint_find(int *found, fmpq *out, ulong *places, graze_context *context,
                       const graze_scene *scene, const fmpq *point, const topo_finding *topo);

#endif
