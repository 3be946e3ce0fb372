/* The position of a point relative to the closed sweep, by the cheapest level that decides it
 * (proofs/topology.md C45 for the word; each other level cites its claim).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_TOPO_H
#define GRAZE_TOPO_TOPO_H

#include "decide/trace/trace.h"
#include "input/solid/planes.h"
#include "questions/topo/finding.h"

/** Decide the position of a point.
 * @param[out] out initialised
 * @param trace the point's trace, decided
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL */
graze_status topo_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                         const fmpq *point, const graze_trace *trace);

/** Decide the position relative to the regularised unsweep, the closure of the unsweep's interior,
 * as topo_decide does. `on` points outside it are those of dangling parts (proofs/dangling.md
 * C113). */
graze_status topo_regular(topo_finding *out, graze_context *context, const graze_scene *scene,
                          const fmpq *point, const graze_trace *trace);

/** The planes of all facets of a scene, made at the first call and kept with the scene. */
graze_status topo_planes(const plane_list **out, graze_context *context, const graze_scene *scene);

/** Decide an `on` point of a sweep by one level alone: leading directions, or (E^2) curves. */
graze_status topo_by_leading(topo_finding *out, graze_context *context, const graze_scene *scene,
                             const fmpq *point);
graze_status topo_by_curves(topo_finding *out, graze_context *context, const graze_scene *scene,
                            const fmpq *point);

#endif
