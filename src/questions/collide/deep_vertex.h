/* A vertex of one solid that stays in the other one's interior for a while: then what happens to
 * the boundaries meanwhile does not matter. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_DEEP_VERTEX_H
#define GRAZE_COLLIDE_DEEP_VERTEX_H

#include "questions/collide/placing.h"

/** Strictly between `low` and `high`, times of a piece, the interiors meet. Both are 0 if no such
 * interval is known. */
typedef struct deep_interval {
    fmpq_t low, high;
} deep_interval;

/**
 * Look for a longer one that has the middle of an interval, among some vertices of the pairs.
 * @param whole a placing on the whole piece
 */
graze_status deep_vertex_find(deep_interval *out, placing *whole, size_t piece,
                              const near_list *near, const dyadic_interval *interval);

#endif
