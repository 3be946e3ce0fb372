/* The states of a trajectory in the windows of time that are decided exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_WALKER_H
#define GRAZE_CURVED_WALKER_H

#include "decide/curved/word_builder.h"
#include "decide/curved/pullbacks.h"
#include "decide/curved/truth.h"
#include "decide/trace/tracer.h"

/** State of the walk. Between windows the owner sets `before` and the signs. */
typedef struct walker {
    tracer *r;
    const csg *solid;
    word_builder *word;
    expression expression;
    pullbacks at;
    size_t piece;
    const trajectory *c;
    algebraic *pending; /* a time that is decided with the next window, or NULL */
    size_t *vanishing;  /* surfaces that vanish at the pending time */
    size_t vanishing_count;
    unsigned long work; /* work of the rules, for the limit */
    int limited;        /* the limit was met */
    graze_state before; /* the state of the gap before the pending time; ABSENT at the start of the
                           motion */
} walker;

/** @return GRAZE_ESYSTEM; walker_clear in either case */
graze_status walker_init(walker *w, tracer *r, word_builder *word);
void walker_clear(walker *w);

/** Put the states of a window into the word. If it ends with its piece, its last time becomes
 * pending.
 * @param asked the surfaces that may vanish in the window */
graze_status walker_walk(walker *w, const exact_window *window, const candidate *asked);

/** Put the state of the pending time, if there is one; the gap after it has the state `after`. */
graze_status walker_settle(walker *w, graze_state after);

#endif
