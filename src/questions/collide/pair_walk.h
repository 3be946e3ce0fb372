/* Builds the pair word, state by state, from the times at which it can change (proofs/collision.md
 * C112). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_PAIR_WALK_H
#define GRAZE_COLLIDE_PAIR_WALK_H

#include "decide/trace/time.h"
#include "questions/collide/cell_pairs.h"
#include "questions/collide/near_pairs.h"

/** A contact; `to` is NULL until it is known. */
typedef struct pair_contact {
    graze_state left, right;
    const graze_time *from, *to;
    cell_pairs cells;
} pair_contact;

typedef struct pair_walk {
    const solid_pair *pair;
    graze_context *context;
    size_t contact_count, contact_capacity;
    pair_contact *contact;
    size_t length, word_capacity;
    char *word; /* ends in NUL unless it is empty */
    size_t time_count, time_capacity;
    graze_time **time; /* all times that were kept, in order; contacts borrow them */
    graze_time *last;  /* the last time reached; NULL: none */
    graze_state gap;   /* state after the last time, or from t0 on; ABSENT: unknown */
    int open;          /* the last contact has not ended */
    int first; /* only the first contact, and the gap after its first instant, are asked for */
    int done;  /* that contact is found */
} pair_walk;

void pair_walk_clear(pair_walk *walk);

/** Begin; if only the first contact is asked for, with the state at t0. */
graze_status pair_walk_begin(pair_walk *walk);

/** Walk to a time of a piece at which the boundaries meet. No time of incidences_find between the
 * last time and this one may be left out.
 * @param near pairs of leaves, with all that meet then
 * @param whole a placing on the whole piece */
graze_status pair_walk_to(pair_walk *walk, placing *whole, size_t piece, const algebraic *time,
                          const node_list *near);

/** Find the gap after the last time, if that is a contact.
 * @param u a time of a piece; no contact is between the last time and u */
graze_status pair_walk_on(pair_walk *walk, size_t piece, const fmpq_t u);

/** Walk to a time of a piece at which, and for a while before which, the interiors meet. */
graze_status pair_walk_pass(pair_walk *walk, size_t piece, const fmpq_t u);

/** Walk to the end of the motion. */
graze_status pair_walk_end(pair_walk *walk);

#endif
