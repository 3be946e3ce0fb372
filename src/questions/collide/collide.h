/* How a moving solid meets a fixed one (proofs/collision.md).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_COLLIDE_H
#define GRAZE_COLLIDE_COLLIDE_H

#include "questions/collide/pair_walk.h"

struct graze_pair {
    solid_pair pair;
    pair_walk walk;
    graze_motion *own; /* the relative motion where both move, else NULL */
    graze_time *start; /* t0, where the word begins with I; else NULL */
    graze_pair_options options;
};

/** Answer a pair whose solids, motion and options are set; collide_clear in any case. Times of
 * contacts become canonical. */
graze_status collide_answer(graze_pair *pair, graze_context *context);
void collide_clear(graze_pair *pair);

/** The verdict of a word, or that it is one of the first contact alone. */
graze_pair_verdict collide_verdict(const graze_pair *pair);

/** The letter of the gap after the first instant of the first contact, where that alone is asked
 * for; else ABSENT. */
graze_state collide_next(const graze_pair *pair);

/** The time at which the first I begins, or NULL. */
const graze_time *collide_overlap_time(const graze_pair *pair);

#endif
