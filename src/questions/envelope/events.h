/* Events of an envelope, collected piece by piece and put in order of time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_EVENTS_H
#define GRAZE_ENVELOPE_EVENTS_H

#include "decide/trace/time.h"
#include "graze/envelope.h"
#include "input/motion/motion.h"
#include "questions/envelope/sign_events.h"

/** A sign that a quantity does not have where it is not defined. */
enum { SIGN_NONE = GRAZE_SIGN_ABSENT };

/** An event; `time` is a number in the list of times once they are in order. */
typedef struct found_event {
    graze_event_kind kind;
    graze_cell facet, other, cell;
    int before, after;
    size_t piece, time;
    algebraic u;
} found_event;

/** Times ascending, each once, owned. */
typedef struct event_list {
    const graze_motion *motion;
    size_t count, capacity, time_count;
    found_event *item;
    graze_time **time;
} event_list;

void events_init(event_list *list, const graze_motion *motion);
void events_clear(event_list *list);

/** One more event, copied but for its time. */
graze_status events_add(event_list *list, graze_context *context, const found_event *what,
                        size_t piece, const algebraic *u);

/** The signs of one quantity beside the end of the piece before. */
typedef struct watch {
    int before, at;
} watch;

/** The sign of a quantity from the signs of the polynomials at one place, or SIGN_NONE. */
typedef int watched_sign(const signed char *sign);

/**
 * Add the events of a quantity on the next piece: times at which it has a sign that is not the one
 * on both sides (proofs/events.md C79).
 * @param past on the first piece anything; kept for the next one
 */
graze_status events_watch(event_list *list, graze_context *context, const found_event *what,
                          watch *past, size_t piece, const signs *s, watched_sign *sign);

/** Put the events in order, with their times. */
graze_status events_finish(event_list *list, graze_context *context);

#endif
