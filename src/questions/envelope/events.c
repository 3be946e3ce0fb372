/* Collects events and sorts them by exact times; names of events, answers and reasons.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stddef.h>
#include "base/context/scope.h"
#include "questions/envelope/sign_events.h"

void events_init(event_list *list, const graze_motion *motion) {
    *list = (event_list){.motion = motion};
}

void events_clear(event_list *list) {
    for (size_t k = 0; k < list->count; k++)
        algebraic_clear(&list->item[k].u);
    for (size_t k = 0; k < list->time_count; k++)
        time_destroy(list->time[k]);
    free(list->item);
    free(list->time);
}

graze_status events_add(event_list *list, graze_context *context, const found_event *what,
                        size_t piece, const algebraic *u) {
    TRY(LIST_GROW(context, list, "events"));
    found_event *made = &list->item[list->count++];
    *made = *what;
    made->piece = piece;
    algebraic_init(&made->u);
    algebraic_set(&made->u, u);
    return GRAZE_OK;
}

/* Do the signs at several places differ? SIGN_NONE is left out. */
static int signs_differ(const int *sign, int count) {
    int first = SIGN_NONE;
    for (int k = 0; k < count; k++) {
        if (sign[k] == SIGN_NONE)
            continue;
        if (first != SIGN_NONE && sign[k] != first)
            return 1;
        first = sign[k];
    }
    return 0;
}

graze_status events_watch(event_list *list, graze_context *context, const found_event *what,
                          watch *past, size_t piece, const signs *s, watched_sign *sign) {
    size_t last = s->x.count - 1;
    watch left = piece > 0 ? *past : (watch){SIGN_NONE, SIGN_NONE};
    for (size_t k = 0; k <= last; k++) {
        int here = sign(signs_at(s, k));
        int after = k < last ? sign(signs_before(s, k + 1)) : SIGN_NONE;
        watch right = {k > 0 ? sign(signs_before(s, k)) : left.before, here};
        if (k > 0)
            left.at = SIGN_NONE;
        if (k == last && piece + 1 < list->motion->piece_count) {
            *past = right;
            break;
        }
        const int places[] = {right.before, left.at, here, after};
        if ((here != SIGN_NONE || left.at != SIGN_NONE) && signs_differ(places, 4)) {
            found_event made = *what;
            made.before = right.before;
            made.after = after;
            TRY(events_add(list, context, &made, piece, s->x.point[k]));
        }
    }
    return GRAZE_OK;
}

/* The order of events by time, then by kind, cells and signs. */
static int compare_at_one_time(const void *left, const void *right) {
    const found_event *a = left, *b = right;
    int order = array_compare_numbers(&a->time, &b->time);
    order = order ? order : (int)a->kind - (int)b->kind;
    order = order ? order : cell_compare(&a->cell, &b->cell);
    order = order ? order : cell_compare(&a->facet, &b->facet);
    order = order ? order : cell_compare(&a->other, &b->other);
    order = order ? order : a->before - b->before;
    return order ? order : a->after - b->after;
}

/* Number the times of the events of one piece; `where` points to their parameters u. */
static graze_status number_times(event_list *list, graze_context *context, algebraic **where,
                                 size_t count, size_t piece) {
    TRY(algebraic_sort(where, count, context));
    for (size_t k = 0; k < count; k++) {
        found_event *event = (found_event *)((char *)where[k] - offsetof(found_event, u));
        int order = -1;
        if (k > 0)
            TRY(algebraic_compare(&order, context, where[k - 1], where[k]));
        if (order != 0) {
            TRY(time_make(&list->time[list->time_count], context, list->motion, piece, where[k]));
            list->time_count++;
        }
        event->time = list->time_count - 1;
    }
    return GRAZE_OK;
}

static int compare_event_pieces(const void *left, const void *right) {
    const found_event *a = left, *b = right;
    return a->piece < b->piece ? -1 : a->piece > b->piece;
}

graze_status events_finish(event_list *list, graze_context *context) {
    FREED(algebraic *, where, NULL);
    TRY(MAKE_ARRAY(context, where, list->count + 1, "times"));
    TRY(MAKE_ARRAY(context, list->time, list->count + 1, "times"));
    if (!list->count)
        return GRAZE_OK;
    qsort(list->item, list->count, sizeof *list->item, compare_event_pieces);
    for (size_t k = 0, first = 0; k < list->count; k++) {
        where[k - first] = &list->item[k].u;
        if (k + 1 < list->count && list->item[k + 1].piece == list->item[k].piece)
            continue;
        TRY(number_times(list, context, where, k + 1 - first, list->item[k].piece));
        first = k + 1;
    }
    qsort(list->item, list->count, sizeof *list->item, compare_at_one_time);
    return GRAZE_OK;
}

NAMES_OF(graze_event_kind_name, graze_event_kind,
         {[GRAZE_EVENT_SADDLE] = "saddle",
          [GRAZE_EVENT_REACH] = "reach",
          [GRAZE_EVENT_MEET] = "meet",
          [GRAZE_EVENT_CUSP] = "cusp",
          [GRAZE_EVENT_TURN] = "turn",
          [GRAZE_EVENT_SINGULAR] = "singular"})

NAMES_OF(graze_decomposable_name, graze_decomposable,
         {[GRAZE_DECOMPOSABLE_YES] = "yes",
          [GRAZE_DECOMPOSABLE_NO] = "no",
          [GRAZE_DECOMPOSABLE_UNDECIDED] = "undecided"})

NAMES_OF(
    graze_decomposable_reason_name, graze_decomposable_reason,
    {[GRAZE_REASON_THETA] = "theta is negative on a slice",
     [GRAZE_REASON_REFLEX] = "a slice crosses a reflex edge",
     [GRAZE_REASON_BREAK] = "contact on one side of a break, into the solid on the other",
     [GRAZE_REASON_VERTEX] = "a slice or run reaches a vertex and enters the solid there",
     [GRAZE_REASON_PIECES] = "the motion has a break",
     [GRAZE_REASON_ZERO] = "theta is not positive on a closed slice",
     [GRAZE_REASON_REACHES] = "a slice or run reaches a reflex edge or a vertex that is not convex",
     [GRAZE_REASON_POSITIVE] = "theta is positive on all slices, none of them and no run "
                               "reaches a reflex edge or a vertex that is not convex"})

NAMES_OF(graze_curve_kind_name, graze_curve_kind,
         {[GRAZE_CURVE_SLICE] = "slice",
          [GRAZE_CURVE_RUN] = "run",
          [GRAZE_CURVE_POINT] = "point",
          [GRAZE_CURVE_WHOLE] = "whole"})

NAMES_OF(graze_chain_form_name, graze_chain_form,
         {[GRAZE_CHAIN_CLOSED] = "closed",
          [GRAZE_CHAIN_OPEN] = "open",
          [GRAZE_CHAIN_BRANCHING] = "branching"})
