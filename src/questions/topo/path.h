/* A path from a point through a gap in a plane of space.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_PATH_H
#define GRAZE_TOPO_PATH_H

#include "decide/scene/scene.h"
#include "questions/topo/finding.h"
#include "questions/topo/plane.h"

/** Try to prove that an `on` point of E^3 is on the boundary: the path of its finding is `out`
 * between some place and the point (proofs/gaps.md C88). Without success the finding is unchanged.
 * @param curves the scene's curves in the view
 * @param view   the plane through the point along the finding's `open` and `across` */
graze_status path_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                         const curve_list *curves, const plane_view *view);

#endif
