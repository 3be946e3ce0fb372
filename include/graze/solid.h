/* graze/solid.h - points in a solid that does not move.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Membership of a polygon, a polyhedron or a curved solid, exactly, with no motion. A scene at rest
 * takes every function of scenes; what it sweeps is the solid itself, so graze_classify with
 * GRAZE_COLUMNS_PMC and graze_distances answer for the solid, as do grids and rows whose options
 * have at_rest.
 */
#ifndef GRAZE_SOLID_H
#define GRAZE_SOLID_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Make the scene of a solid that does not move. The solid is borrowed and must outlive the scene.
 * Threads may share it.
 * @param[out] out freed by graze_scene_destroy, after all traces of it
 * @return GRAZE_EUSE a NULL; GRAZE_ELIMIT; GRAZE_ECANCELED; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_scene_at_rest(graze_scene **out, graze_context *context,
                                                         const graze_solid *solid);

/**
 * Decide for n points whether they are in the interior of a solid (GRAZE_IN), on its boundary
 * (GRAZE_ON) or outside (GRAZE_OUT), exactly. Each call prepares the solid, in time that grows with
 * its facets; for many calls make a scene at rest once, and use graze_classify.
 * @param[out] out n answers in the order of `points`; those not reached are GRAZE_PMC_NONE. A point
 * of a curved solid may be GRAZE_PMC_UNDECIDED.
 * @param points   n*d canonical rationals, point after point; may be NULL if n is 0
 * @return as graze_classify: after a failure answers that are not zero are exact
 */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_classify(graze_pmc *out, graze_context *context,
                                                          const graze_solid *solid,
                                                          graze_rationals points, size_t n);
/** As graze_solid_classify, from doubles, which are exact. NaN and infinities are GRAZE_EINPUT; the
 * answers before them are given. */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_classify_doubles(graze_pmc *out,
                                                                  graze_context *context,
                                                                  const graze_solid *solid,
                                                                  const double *points, size_t n);

#ifdef __cplusplus
}
#endif
#endif
