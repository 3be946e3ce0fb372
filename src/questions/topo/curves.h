/* Plane curves that contain the boundary of a sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_CURVES_H
#define GRAZE_TOPO_CURVES_H

#include "decide/scene/scene.h"
#include "input/solid/planes.h"
#include "questions/topo/plane.h"

/** Bounds: of the number of curves of a scene in E^2, and of a point in a plane of E^3; and there
 * of a pullback's degree in time, for which E^2 has the context's limit `curve`. */
enum { CURVE_COUNT = 100000, SLICE_CURVE_COUNT = 5000, SLICE_CURVE_DEGREE = 8 };

/** Append curves whose zeros contain the closed sweep's boundary in the plane, but for finitely
 * many points (proofs/topology.md C47, C50): the lines of the facets at the ends of all pieces, the
 * discriminants of the facets' pullbacks, and the paths of the vertices, in E^3 of the edges.
 * @param[out] refused NULL, or why the list is incomplete: a bound is exceeded, or (E^3) a facet or
 * an edge comes to lie in the plane
 * @param planes       of all facets of the scene's solid */
graze_status curves_of_scene(curve_list *list, const char **refused, graze_context *context,
                             const graze_scene *scene, const plane_list *planes,
                             const plane_view *view);

#endif
