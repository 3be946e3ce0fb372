/* Whether the interiors of the two solids meet at a time at which their boundaries may.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_INTERIORS_H
#define GRAZE_COLLIDE_INTERIORS_H

#include "questions/collide/common_points.h"

/**
 * State of the pair at the placing's time, a rational one, or an irrational one at which the
 * boundaries meet: I, B or O (proofs/collision.md C109, C111). Without GRAZE_OK in the placing it
 * means nothing.
 * @param near   all pairs of simplices that meet then, perhaps others
 * @param before for an irrational time a placing at a rational one, such that no vertex changes its
 * state between the two; else NULL
 */
graze_state interiors_look(placing *p, const near_list *near, placing *before);

#endif
