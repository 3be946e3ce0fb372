/* Times of an interval at which an incidence can begin or end: a vertex of one solid in a simplex
 * of the other, or a crossing of two edges. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_INCIDENCES_H
#define GRAZE_COLLIDE_INCIDENCES_H

#include "questions/collide/common_points.h"
#include "questions/collide/near_pairs.h"

/** Find times in a closed interval of a piece such that between two of them the result of
 * common_points_find does not change for any pair, and at each of them some pair has a common
 * point. A contact that lasts gives only times at which it changes (proofs/collision.md C110).
 * @param[out] out the times, ascending, without duplicates
 * @param p a placing on the whole piece
 * @param maps the motion during the interval, for tests in doubles */
graze_status incidences_find(algebraic_list *out, placing *p, const near_list *near,
                             const control_maps *maps, const dyadic_interval *interval);

#endif
