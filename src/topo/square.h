/* The last level in the plane: a small square about the point, traced between the curves that cross
 * it. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_SQUARE_H
#define GRAZE_TOPO_SQUARE_H

#include "topo/finding.h"
#include "topo/curves.h"

/**
 * Decide a point of the plane that lies in the closed sweep (proofs/topology.md C52).
 * @param curves those of the scene, whole
 */
graze_status square_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                           const curve_list *curves, const fmpq *point);

#endif
