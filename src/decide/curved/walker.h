/* States of a trajectory in windows of time that the exact path is asked for.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_WALKER_H
#define GRAZE_CURVED_WALKER_H

#include "decide/curved/word_builder.h"
#include "decide/curved/pullbacks.h"
#include "decide/curved/truth.h"
#include "decide/trace/tracer.h"

/** Between windows the owner keeps `before` and the signs as they are there. */
typedef struct walker {
    tracer *r;
    const csg *solid;
    word_builder *word;
    expression expression;
    pullbacks at;
    size_t piece;
    const trajectory *c;
    algebraic *pending; /* a time that is not decided yet, until the next window; or NULL */
    size_t *vanishing;  /* surfaces that vanish there */
    size_t vanishing_count;
    unsigned long work; /* of the rules, for the limit */
    int limited;        /* the limit was met */
    graze_state before; /* the state of the gap before it; ABSENT at the start of the motion */
} walker;

/** @return GRAZE_ESYSTEM; walker_clear in either case */
graze_status walker_init(walker *w, tracer *r, word_builder *word);
void walker_clear(walker *w);

/**
 * Put the states of a window, all but that of its last time where the piece ends: that is pending.
 * @param asked by number within the window: the surfaces that may vanish in it
 */
graze_status walker_walk(walker *w, const exact_window *window, const candidate *asked);

/** Put the pending time, if there is one; the gap behind it has the state `after`. */
graze_status walker_settle(walker *w, graze_state after);

#endif
