/* The state of a pair at one time, at which the boundaries may meet.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_INTERIORS_H
#define GRAZE_COLLIDE_INTERIORS_H

#include "questions/collide/common_points.h"

/** The state of the pair at the placing's time: I, B or O (proofs/collision.md C109, C111). The
 * time is rational, or the boundaries meet at it. After a failure of the placing the result is
 * invalid.
 * @param near all pairs of simplices that meet then, and perhaps others
 * @param before for an irrational time: a placing at a rational time such that no vertex changes
 * its state between both; else NULL */
graze_state interiors_look(placing *p, const near_list *near, placing *before);

#endif
