/* The last level in space: planes through the point, in which the boundary may be proved.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_SLICES_H
#define GRAZE_TOPO_SLICES_H

#include "decide/scene/scene.h"
#include "input/solid/planes.h"
#include "questions/topo/finding.h"

/** Prove an undecided `on` point of E^3 to be on the boundary, or leave it undecided for the reason
 * it has (proofs/topology.md C50). Where it has an open direction, a plane holds that. */
graze_status slices_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                           const plane_list *planes, const fmpq *point);

#endif
