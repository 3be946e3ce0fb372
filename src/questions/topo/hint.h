/* A point that is out, near one whose position is undecided: a hint, and no verdict.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_HINT_H
#define GRAZE_TOPO_HINT_H

#include "decide/scene/scene.h"
#include "questions/topo/finding.h"

/**
 * Look at places about a point of E^3 along a few directions, and along the plane and the direction
 * that a finding has, from the nearest distance to the farthest.
 * @param[out] found  1 if a place is out
 * @param[out] out    3 initialised rationals: a place of the nearest distance that has one
 * @param[out] places its distance is about the solid's width times 2^-places, or that none is out
 *                    from there on
 */
graze_status hint_find(int *found, fmpq *out, ulong *places, graze_context *context,
                       const graze_scene *scene, const fmpq *point, const topo_finding *topo);

#endif
