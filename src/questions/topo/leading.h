/* The level of leading directions: are all cells of the arrangement of borders covered?
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_LEADING_H
#define GRAZE_TOPO_LEADING_H

#include "decide/scene/scene.h"
#include "input/solid/planes.h"
#include "questions/topo/finding.h"

/** Decide the position of an `on` point, or leave it undecided with a reason (proofs/topology.md
 * C46). */
graze_status leading_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                            const plane_list *planes, const fmpq *point);

#endif
