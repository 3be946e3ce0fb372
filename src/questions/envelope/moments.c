/* Merges the times of events with the ends and breaks of the motion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>
#include "base/context/scope.h"
#include "base/number/order.h"
#include "questions/envelope/patch_ends.h"

static int is_parameter(const graze_time *time, size_t piece, slong u) {
    return time->piece == piece && algebraic_is_rational(&time->u) &&
           fmpz_is_one(fmpq_denref(time->u.value)) && fmpz_equal_si(fmpq_numref(time->u.value), u);
}

static void append_event_time(moment_list *list, const event_list *events, size_t k) {
    list->of_event[k] = list->count;
    list->time[list->count++] = events->time[k];
}

/* Append the end u = 0 or 1 of a piece as a hard moment. If time `*next` of the events is this end,
 * that time is taken. */
static graze_status append_boundary(moment_list *list, graze_context *context,
                                    const event_list *events, size_t *next, size_t piece, slong u) {
    list->hard[list->hard_count++] = list->count;
    if (*next < events->time_count && is_parameter(events->time[*next], piece, u)) {
        append_event_time(list, events, (*next)++);
        return GRAZE_OK;
    }
    HELD(algebraic, at);
    LOCAL(fmpq, value);
    fmpq_set_si(value, u, 1);
    algebraic_set_rational(&at, value);
    graze_time *time = time_create(events->motion, piece, &at);
    if (!time)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for times");
    list->own[list->own_count++] = time;
    list->time[list->count++] = time;
    return GRAZE_OK;
}

graze_status moments_make(moment_list *out, graze_context *context, const graze_envelope *e) {
    const event_list *events = &e->events;
    size_t room = events->time_count + e->piece_count + 1, next = 0;
    memset(out, 0, sizeof *out);
    out->time = malloc(room * sizeof(graze_time *));
    out->own = malloc(room * sizeof(graze_time *));
    out->hard = malloc((e->piece_count + 1) * sizeof *out->hard);
    out->of_event = malloc(room * sizeof *out->of_event);
    if (!out->time || !out->own || !out->hard || !out->of_event)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for times");
    for (size_t piece = 0; piece < e->piece_count; piece++) {
        if (piece == 0 || e->is_break[piece])
            TRY(append_boundary(out, context, events, &next, piece, 0));
        int is_last = piece + 1 == e->piece_count;
        while (next < events->time_count && events->time[next]->piece == piece &&
               !(is_last && is_parameter(events->time[next], piece, 1)))
            append_event_time(out, events, next++);
    }
    return append_boundary(out, context, events, &next, e->piece_count - 1, 1);
}

void moments_clear(moment_list *list) {
    for (size_t k = 0; k < list->own_count; k++)
        time_destroy(list->own[k]);
    free(list->own);
    free(list->time);
    free(list->hard);
    free(list->of_event);
}

graze_status moments_between(fmpq_t out, graze_context *context, const moment_list *list,
                             size_t from, size_t to) {
    const graze_time *first = list->time[from], *last = list->time[to];
    const motion_piece *piece = &first->motion->piece[first->piece];
    HELD(algebraic, low);
    HELD(algebraic, high);
    algebraic_set(&low, &first->u);
    fmpq_one(out);
    algebraic_set_rational(&high, out);
    if (last->piece == first->piece)
        algebraic_set(&high, &last->u);
    TRY(algebraic_between(out, context, &low, &high));
    motion_time_at(out, piece, out);
    return GRAZE_OK;
}
