/* The plane curves on which the boundary of a sweep lies.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_CURVES_H
#define GRAZE_TOPO_CURVES_H

#include "decide/scene/scene.h"
#include "input/solid/planes.h"
#include "questions/topo/plane.h"

/** Most curves, in E^2, once for a scene, and in a plane of E^3, for each point; there also the
 * largest degree in time of a pullback whose discriminant is taken. In E^2 that is the context's
 * limit `curve`. */
enum { CURVE_COUNT = 100000, SLICE_CURVE_COUNT = 5000, SLICE_CURVE_DEGREE = 8 };

/**
 * Append curves whose zeros hold the boundary of the closed sweep in the plane, up to finitely many
 * points (proofs/topology.md C47, C50): of the facets' planes the lines at the ends of all pieces
 * and the discriminants of the pullbacks, and the paths of the vertices, in E^3 of the edges.
 * @param[out] refused why the list is not whole: curves that are too dear, or (E^3) a facet or an
 * edge that comes to lie in the plane; else NULL
 * @param planes       of all facets of the scene's solid
 */
graze_status curves_of_scene(curve_list *list, const char **refused, graze_context *context,
                             const graze_scene *scene, const plane_list *planes,
                             const plane_view *view);

#endif
