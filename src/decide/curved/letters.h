/* The word and the contacts of a trace, from its states in order of time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_LETTERS_H
#define GRAZE_CURVED_LETTERS_H

#include "decide/trace/trace.h"

/** States come as time, gap, time, ..., time; times at which a gap's state goes on may be left out.
 */
typedef struct letters {
    graze_trace *out;
    graze_context *context;
    const graze_motion *motion;
    size_t length, capacity; /* of the word */
} letters;

/** The state at a time. */
graze_status letters_put_time(letters *l, graze_state state, size_t piece, const algebraic *u);

/** The state between the last time and the next one. */
graze_status letters_put_gap(letters *l, graze_state state);

/** A certain crossing, whose time is not wanted; its gap follows. */
graze_status letters_put_crossing(letters *l);

/** Add a primitive to the cells of a contact. */
graze_status letters_add_cell(letters *l, contact *c, size_t primitive);

/** Complete the contacts and the ends. */
graze_status letters_finish(letters *l);

#endif
