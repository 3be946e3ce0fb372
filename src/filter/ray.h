/* Where a trajectory is at one time, by a ray in doubles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_RAY_H
#define GRAZE_FILTER_RAY_H

#include "filter/filter.h"

/**
 * The state at u of a piece.
 * @return GRAZE_STATE_I or GRAZE_STATE_O, or GRAZE_STATE_ABSENT: ask the exact location
 */
graze_state filter_locate(filter_workspace *w, const filter *f, size_t piece,
                          const filter_point *point, double u);

#endif
