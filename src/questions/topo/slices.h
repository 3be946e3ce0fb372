/* The last level in space: the boundary may be proved in a plane through the point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_SLICES_H
#define GRAZE_TOPO_SLICES_H

#include "decide/scene/scene.h"
#include "input/solid/planes.h"
#include "questions/topo/finding.h"

/** Try to decide an undecided `on` point of E^3 by planes through it (proofs/topology.md C50);
 * without success it keeps its reason. If it has an open direction, one of the planes contains
 * that. */
graze_status slices_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                           const plane_list *planes, const fmpq *point);

#endif
