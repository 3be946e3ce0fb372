/* The times at which something may change, in order: ends of the motion, breaks, events.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_MOMENTS_H
#define GRAZE_ENVELOPE_MOMENTS_H

#include "questions/envelope/envelope_record.h"

/** Moments ascending, each once; the first and the last are the ends of the motion. `hard` are the
 * numbers of ends and breaks; `of_event` is the moment of each time in the envelope's list of
 * events. The times made here are `own`. */
typedef struct moment_list {
    size_t count, own_count, hard_count;
    graze_time **time, **own;
    size_t *hard, *of_event;
} moment_list;

/** @param[out] out uninitialised; moments_clear in any case */
graze_status moments_make(moment_list *out, graze_context *context, const graze_envelope *e);
void moments_clear(moment_list *list);

/** A rational time between two moments, from < to, at which the motion is smooth. */
graze_status moments_between(fmpq_t out, graze_context *context, const moment_list *list,
                             size_t from, size_t to);

#endif
