/* Times of an interval at which a vertex of one solid is in a simplex of the other, or two edges
 * cross, and this can change. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_INCIDENCES_H
#define GRAZE_COLLIDE_INCIDENCES_H

#include "questions/collide/common_points.h"
#include "questions/collide/near_pairs.h"

/**
 * Find times in a closed interval of a piece between which, for each of the pairs, nothing that
 * common_points_find says changes; at each of them some pair has a common point. Contacts that last
 * have times where they change alone (proofs/collision.md C110).
 * @param[out] out   the times, ascending, each once
 * @param p          on the whole piece
 * @param maps       the motion during the interval, for what is certain in doubles
 */
graze_status incidences_find(algebraic_list *out, placing *p, const near_list *near,
                             const control_maps *maps, const dyadic_interval *interval);

#endif
