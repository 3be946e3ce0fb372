/* Simplices that a trajectory can meet, with the times: a search of the solid's tree with pieces of
 * the curve. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_CANDIDATES_H
#define GRAZE_TRACE_CANDIDATES_H

#include "base/number/bernstein.h"
#include "decide/filter/findings.h"
#include "decide/trace/trajectory.h"
#include "input/solid/solid.h"

/**
 * All candidates, ordered by simplex and time; windows of one simplex do not touch each
 * other.
 * @param[out] out initialised to zero, or used before; freed by the caller
 */
graze_status candidates_find(candidates *out, graze_context *context, const graze_solid *solid,
                             const trajectory *c);

/** Candidates for all points of the segments between two trajectories, of one map, at each time;
 * both are given the same degree. */
graze_status candidates_find_between(candidates *out, graze_context *context,
                                     const graze_solid *solid, trajectory *c, trajectory *other);

#endif
