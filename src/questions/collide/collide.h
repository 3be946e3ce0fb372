/* The answer of a pair: the word and the contacts of a moving and a fixed solid
 * (proofs/collision.md). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_COLLIDE_H
#define GRAZE_COLLIDE_COLLIDE_H

#include "questions/collide/pair_walk.h"

struct graze_pair {
    solid_pair pair;
    pair_walk walk;
    graze_motion *own; /* the relative motion if both solids move, else NULL */
    graze_time *start; /* t0 if the word begins with I, else NULL */
    graze_pair_options options;
};

/** Answer a pair with its solids, motion and options set. The caller calls collide_clear in any
 * case. Times of contacts become canonical. */
graze_status collide_answer(graze_pair *pair, graze_context *context);
void collide_clear(graze_pair *pair);

/** The verdict of the word; GRAZE_PAIR_CONTACT if only the first contact was asked for and found.
 */
graze_pair_verdict collide_verdict(const graze_pair *pair);

/** The state just after the first contact begins, if no more was asked for; else ABSENT. */
graze_state collide_next(const graze_pair *pair);

/** The time at which the interiors begin to meet, or NULL. */
const graze_time *collide_overlap_time(const graze_pair *pair);

#endif
