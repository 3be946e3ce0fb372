/* The position of a point relative to the closed sweep, by the cheapest level that decides it
 * (proofs/topology.md C45: the word; each other one cites its claim).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_TOPO_H
#define GRAZE_TOPO_TOPO_H

#include "decide/trace/trace.h"
#include "input/solid/planes.h"
#include "questions/topo/finding.h"

/**
 * @param[out] out initialised
 * @param trace    that of the point, decided
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL
 */
graze_status topo_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                         const fmpq *point, const graze_trace *trace);

/** The position relative to the closure of an unsweep's interior: the regularised unsweep. `on`
 * points beyond it are those of dangling parts (proofs/dangling.md C113). As topo_decide. */
graze_status topo_regular(topo_finding *out, graze_context *context, const graze_scene *scene,
                          const fmpq *point, const graze_trace *trace);

/** The planes of all facets of a scene, made once and kept with it. */
graze_status topo_planes(const plane_list **out, graze_context *context, const graze_scene *scene);

/** One level alone, for an `on` point of a sweep: leading directions, or (E^2) curves. */
graze_status topo_by_leading(topo_finding *out, graze_context *context, const graze_scene *scene,
                             const fmpq *point);
graze_status topo_by_curves(topo_finding *out, graze_context *context, const graze_scene *scene,
                            const fmpq *point);

#endif
