/* The last level in the plane: a small square about the point, sampled between the curves that
 * cross it. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_SQUARE_H
#define GRAZE_TOPO_SQUARE_H

#include "questions/topo/curves.h"
#include "questions/topo/finding.h"

/** Sample a square about a point of the closed sweep, in a plane (proofs/topology.md C49, C50). The
 * point is on the boundary if a sample is out; else it is in the interior, if the plane decides
 * that.
 * @param level the level that the finding gets; without a sample that is out, a plane of E^3 leaves
 * the finding unchanged unless this is GRAZE_LEVEL_SECTION
 * @param curves all curves of the scene in the view
 * @param point the point's 2 coordinates in the view */
graze_status square_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                           const curve_list *curves, const plane_view *view, const fmpq *point,
                           graze_topo_level level);

#endif
