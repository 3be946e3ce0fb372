/* The simplices that a trajectory may meet, with windows of time, by a search of the solid's tree
 * with pieces of the curve. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_CANDIDATES_H
#define GRAZE_TRACE_CANDIDATES_H

#include "base/number/bernstein.h"
#include "decide/filter/findings.h"
#include "decide/trace/trajectory.h"
#include "input/solid/solid.h"

/**
 * Find all candidates, sorted by simplex and time; windows of one simplex do not touch.
 * @param[out] out initialised to zero, or used before; freed by the caller
 */
graze_status candidates_find(candidates *out, graze_context *context, const graze_solid *solid,
                             const trajectory *c);

/** Find the candidates for all points between two trajectories of one map: at each time the segment
 * between both places is searched. Both are raised to the same degree. */
graze_status candidates_find_between(candidates *out, graze_context *context,
                                     const graze_solid *solid, trajectory *c, trajectory *other);

#endif
