/* Answers pairs: finds the word and the contacts, and what they imply.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/collide/near_pairs.h"

/* Set `start` to t0 if the motion begins in state I. */
static graze_status mark_start(graze_pair *pair, graze_context *context) {
    if (pair->walk.word[0] != GRAZE_STATE_I)
        return GRAZE_OK;
    HELD(algebraic, zero);
    TRY(time_make(&pair->start, context, pair->pair.motion, 0, &zero));
    return time_canonicalise(pair->start, context);
}

graze_status collide_walk(graze_pair *pair, graze_context *context) {
    pair->walk.pair = &pair->pair;
    for (int side = 0; side < 2; side++)
        pair->pair.forms[side] = &pair->forms[side];
    pair->walk.context = context;
    TRY(pair_walk_begin(&pair->walk));
    TRY(pair_search(&pair->walk));
    return pair_walk_end(&pair->walk);
}

graze_status collide_answer(graze_pair *pair, graze_context *context) {
    pair_walk *walk = &pair->walk;
    walk->first = pair->options.first;
    pair->pair.complement = pair->options.question == GRAZE_PAIR_INSIDE;
    TRY(collide_walk(pair, context));
    TRY(mark_start(pair, context));
    return walk->time_count ? times_canonicalise(walk->time, walk->time_count, context) : GRAZE_OK;
}

void collide_clear(graze_pair *pair) {
    pair_walk_clear(&pair->walk);
    time_destroy(pair->start);
    time_destroy(pair->closest_time);
    time_destroy(pair->begun);
    time_destroy(pair->high);
    for (size_t k = 0; pair->clearance && k < pair->pair.motion->piece_count; k++)
        clearance_clear(&pair->clearance[k]);
    free(pair->clearance);
    for (int side = 0; side < 2; side++) {
        graze_solid_destroy(pair->base[side]);
        form_memory_clear(&pair->forms[side]);
    }
    fmpq_clear(pair->distance);
    fmpq_clear(pair->error);
    if (pair->own)
        motion_destroy(pair->own);
}

graze_pair_verdict collide_verdict(const graze_pair *pair) {
    const char *word = pair->walk.word;
    if (pair->options.first && pair->walk.contact_count)
        return GRAZE_PAIR_CONTACT;
    return strchr(word, GRAZE_STATE_I)   ? GRAZE_PAIR_OVERLAP
           : strchr(word, GRAZE_STATE_B) ? GRAZE_PAIR_TOUCH
                                         : GRAZE_PAIR_CLEAR;
}

graze_state collide_next(const graze_pair *pair) {
    return collide_verdict(pair) == GRAZE_PAIR_CONTACT ? pair->walk.gap : GRAZE_STATE_ABSENT;
}

const graze_time *collide_overlap_time(const graze_pair *pair) {
    for (size_t k = 0; k < pair->walk.contact_count && !pair->start; k++)
        if (pair->walk.contact[k].right == GRAZE_STATE_I)
            return pair->walk.contact[k].to;
    return pair->start;
}
