/* From touches, piece after piece, to contacts: maximal closed intervals of time on the boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/trace/trace.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"

/* Sort the cells of a contact; each once. */
static void order_cells(contact *c) {
    c->cell_count = array_sort_once(c->cell, c->cell_count, sizeof *c->cell, cell_compare);
}

/* Add cells of touches to a contact, in order and each once; 0 if memory runs out. */
static int add_cells(contact *c, const touch *item, size_t count) {
    if (!array_reserve(&c->cell, &c->cell_capacity, c->cell_count + count, sizeof *c->cell))
        return 0;
    for (size_t k = 0; k < count; k++)
        c->cell[c->cell_count++] = item[k].cell;
    order_cells(c);
    return 1;
}

/* Replace the simplices' names of cells by the input's; 0 if memory runs out. */
static int name_contact(contact *c, const cell_names *names) {
    size_t count = 0, n;
    for (size_t k = 0; k < c->cell_count; k++, count += n)
        cell_names_of(&n, names, &c->cell[k]);
    graze_cell *cell = NULL;
    size_t capacity = 0;
    if (!array_reserve(&cell, &capacity, count + 1, sizeof *cell))
        return 0;
    count = 0;
    for (size_t k = 0; k < c->cell_count; k++, count += n) {
        const graze_cell *name = cell_names_of(&n, names, &c->cell[k]);
        memcpy(cell + count, name, n * sizeof *cell);
    }
    free(c->cell);
    c->cell = cell;
    c->cell_count = count;
    c->cell_capacity = capacity;
    order_cells(c);
    return 1;
}

graze_status contacts_name(graze_trace *trace, graze_context *context, const cell_names *names) {
    for (size_t k = 0; k < trace->contact_count && names->count > 0; k++)
        if (!name_contact(&trace->contact[k], names))
            return context_fail(context, GRAZE_ESYSTEM,
                                "out of memory for the contacts of a trace");
    return GRAZE_OK;
}

/* Let the last contact, which ends where the piece before ended, go on to `to`. */
static int prolong(contact *last, graze_time *to) {
    if (!to)
        return 0;
    if (last->to != last->from)
        time_destroy(last->to);
    last->to = to;
    return 1;
}

/* Append a contact, all zero; NULL if memory runs out. */
static contact *append_contact(graze_trace *trace) {
    if (!array_reserve(&trace->contact, &trace->contact_capacity, trace->contact_count + 1,
                       sizeof *trace->contact))
        return NULL;
    contact *added = &trace->contact[trace->contact_count++];
    *added = (contact){.from = NULL};
    return added;
}

/* Append a contact that takes over two times, which may be one handle. If a time is NULL or memory
 * is short, free them and return NULL. */
static contact *append_timed(graze_trace *trace, graze_time *from, graze_time *to) {
    contact *added = from && to ? append_contact(trace) : NULL;
    if (!added) {
        time_destroy(from);
        if (to != from)
            time_destroy(to);
        return NULL;
    }
    added->from = from;
    added->to = to;
    return added;
}

/* 1 if a contact ends where a piece begins; 0 for NULL. */
static int ends_before(const contact *last, size_t piece) {
    return last && last->to && last->to->piece + 1 == piece && time_is_piece_end(last->to);
}

/* Add a maximal run of `count` touches from touch `first` on, which ends at rank `to`, as a
 * contact. */
static int add_run(graze_trace *trace, const graze_motion *motion, size_t piece, const touches *t,
                   size_t first, size_t count, size_t to) {
    const algebraic *u0 = &t->time.item[t->by_rank[t->item[first].from]];
    const algebraic *u1 = &t->time.item[t->by_rank[to]];
    contact *last = trace->contact_count ? &trace->contact[trace->contact_count - 1] : NULL;
    int at_start = algebraic_is_rational(u0) && fmpq_is_zero(u0->value), instant = u0 == u1;
    if (at_start && ends_before(last, piece)) {
        if (!instant && !prolong(last, time_create(motion, piece, u1)))
            return 0;
    } else {
        graze_time *from = time_create(motion, piece, u0);
        last = append_timed(trace, from, instant ? from : time_create(motion, piece, u1));
        if (!last)
            return 0;
    }
    return add_cells(last, &t->item[first], count);
}

static int begins_with_touch(const touches *t) {
    const algebraic *first = t->count ? &t->time.item[t->by_rank[t->item[0].from]] : NULL;
    return first && algebraic_is_rational(first) && fmpq_is_zero(first->value);
}

graze_status contacts_append_crossing(graze_trace *trace, graze_context *context, int enters) {
    contact *added = append_contact(trace);
    if (!added)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the contacts of a trace");
    added->left = enters ? GRAZE_STATE_O : GRAZE_STATE_I;
    added->right = enters ? GRAZE_STATE_I : GRAZE_STATE_O;
    return GRAZE_OK;
}

graze_status contacts_append(graze_trace *trace, graze_context *context, const graze_motion *motion,
                             size_t piece, const touches *t, int opens) {
    const contact *last = trace->contact_count ? &trace->contact[trace->contact_count - 1] : NULL;
    if (opens && ends_before(last, piece) && !begins_with_touch(t))
        return context_fail(context, GRAZE_EINTERNAL,
                            "a contact ends between two pieces of the motion");
    for (size_t first = 0, next; first < t->count; first = next) {
        size_t to = t->item[first].to;
        for (next = first + 1; next < t->count && t->item[next].from <= to; next++)
            to = t->item[next].to > to ? t->item[next].to : to;
        if (!add_run(trace, motion, piece, t, first, next - first, to))
            return context_fail(context, GRAZE_ESYSTEM,
                                "out of memory for the contacts of a trace");
    }
    return GRAZE_OK;
}
