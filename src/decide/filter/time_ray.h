/* Where a trajectory is at one time, by a ray in doubles (proofs/filter.md C38).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_TIME_RAY_H
#define GRAZE_FILTER_TIME_RAY_H

#include "decide/filter/filter.h"

/**
 * The state at a place.
 * @param at, error d + 1 homogeneous coordinates, the last one positive, each within its error
 */
graze_state ray_locate(filter_workspace *w, const graze_solid *solid, const double *at,
                       const double *error);

/** Lay the bricks that spare searches for memberships alone, unless they are. */
graze_status filter_lay_bricks(const filter *f, graze_context *context);

/**
 * The state at u of a piece.
 * @return GRAZE_STATE_I or GRAZE_STATE_O, or GRAZE_STATE_ABSENT: ask the exact location
 */
graze_state filter_locate(filter_workspace *w, const filter *f, size_t piece,
                          const filter_point *point, double u);

#endif
