/* The pair word, letter by letter, from the times at which it can change (proofs/collision.md
 * C112).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_PAIR_WALK_H
#define GRAZE_COLLIDE_PAIR_WALK_H

#include "decide/trace/time.h"
#include "questions/collide/cell_pairs.h"
#include "questions/collide/near_pairs.h"

/** `to` is NULL until it is known. */
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
    char *word; /* ends in NUL once there is a letter */
    size_t time_count, time_capacity;
    graze_time **time; /* all that contacts have, in order, and those between */
    graze_time *last;  /* the last time looked at; NULL: none */
    graze_state gap;   /* after it, or from t0 on; ABSENT: not known */
    int open;          /* the last contact goes on */
    int first; /* only the first contact and the gap after its first instant are asked for, */
    int done;  /* and found */
} pair_walk;

void pair_walk_clear(pair_walk *walk);

/** Begin with the state at t0, where only the first contact is asked for. */
graze_status pair_walk_begin(pair_walk *walk);

/**
 * Go on to a time of a piece at which the boundaries meet; between the last one and it none of
 * incidences_find is left out.
 * @param near  pairs of leaves, all that meet then among them
 * @param whole a placing on the whole piece
 */
graze_status pair_walk_to(pair_walk *walk, placing *whole, size_t piece, const algebraic *time,
                          const node_list *near);

/** Know the gap after the last time, a contact, from a time of a piece up to which no other is. */
graze_status pair_walk_on(pair_walk *walk, size_t piece, const fmpq_t u);

/** Go on to a time of a piece up to which, for a while, it included, the interiors meet. */
graze_status pair_walk_pass(pair_walk *walk, size_t piece, const fmpq_t u);

/** Go on to the end of the motion. */
graze_status pair_walk_end(pair_walk *walk);

#endif
