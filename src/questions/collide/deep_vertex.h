/* A vertex of one solid that is in the other solid's interior for an interval of time: meanwhile
 * the state is I, whatever the boundaries do. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_DEEP_VERTEX_H
#define GRAZE_COLLIDE_DEEP_VERTEX_H

#include "questions/collide/placing.h"

/** An open interval of times of a piece in which the interiors meet; both ends are 0 if none is
 * known. */
typedef struct deep_interval {
    fmpq_t low, high;
} deep_interval;

/** Find the longest such interval around the middle of `interval` that a few vertices of the pairs
 * give.
 * @param whole a placing on the whole piece */
graze_status deep_vertex_find(deep_interval *out, placing *whole, size_t piece,
                              const near_list *near, const dyadic_interval *interval);

#endif
