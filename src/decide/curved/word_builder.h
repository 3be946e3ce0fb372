/* Builds the word and the contacts of a trace from states in order of time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_WORD_BUILDER_H
#define GRAZE_CURVED_WORD_BUILDER_H

#include "decide/trace/trace.h"

/** States are put alternately for a time and for the gap after it, from the first time to the last.
 * A time with the state of both gaps beside it may be left out. */
typedef struct word_builder {
    graze_trace *out;
    graze_context *context;
    const graze_motion *motion;
    size_t length, capacity; /* of the word */
} word_builder;

/** Put the state at a time. */
graze_status word_put_time(word_builder *l, graze_state state, size_t piece, const algebraic *u);

/** Put the state of the gap between the last time and the next one. */
graze_status word_put_gap(word_builder *l, graze_state state);

/** Put a certain crossing whose time is not needed; the gap after it is put next. */
graze_status word_put_crossing(word_builder *l);

/** Add a primitive to the cells of a contact, unless it is one of them. */
graze_status word_add_cell(word_builder *l, contact *c, size_t primitive);

/** Set the states beside each contact and those at the ends of the motion. */
graze_status word_finish(word_builder *l);

#endif
