/* The last level in the plane: a small square about the point, traced between the curves that cross
 * it. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_SQUARE_H
#define GRAZE_TOPO_SQUARE_H

#include "questions/topo/curves.h"
#include "questions/topo/finding.h"

/**
 * Look around a point that lies in the closed sweep, in a plane (proofs/topology.md C49, C50): it
 * is on the boundary if a sample is out; else, if the plane decides, in the interior.
 * @param level the level found, the section only if the plane decides, as E^2 does; in another
 * plane of E^3 without a sample that is out the finding stays as it was
 * @param curves those of the scene in the view, whole
 * @param point  its 2 coordinates in the view
 */
graze_status square_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                           const curve_list *curves, const plane_view *view, const fmpq *point,
                           graze_topo_level level);

#endif
