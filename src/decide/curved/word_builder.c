/* The word and the contacts of a trace, built from states.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/array.h"
#include "base/context/scope.h"
#include "decide/curved/walker.h"

static graze_state last_of(const word_builder *l) {
    return l->length ? (graze_state)l->out->word[l->length - 1] : GRAZE_STATE_ABSENT;
}

static graze_status append_state(word_builder *l, graze_state state) {
    return word_append(&l->out->word, &l->length, &l->capacity, l->context, state,
                       "the word of a trace");
}

static graze_status no_memory(word_builder *l) {
    return context_fail(l->context, GRAZE_ESYSTEM, "out of memory for the contacts of a trace");
}

/* Append a contact at a time, which may be NULL. */
static graze_status begin_contact(word_builder *l, graze_time *time) {
    graze_trace *out = l->out;
    if (!array_reserve(&out->contact, &out->contact_capacity, out->contact_count + 1,
                       sizeof *out->contact))
        return no_memory(l);
    out->contact[out->contact_count++] = (contact){.from = time, .to = time};
    return GRAZE_OK;
}

/* Begin a contact at a time, or prolong the last one to it. */
static graze_status touch_at(word_builder *l, int begins, size_t piece, const algebraic *u) {
    graze_trace *out = l->out;
    graze_time *time;
    TRY(time_make(&time, l->context, l->motion, piece, u));
    if (begins) {
        graze_status status = begin_contact(l, time);
        if (status)
            time_destroy(time);
        return status;
    }
    contact *c = &out->contact[out->contact_count - 1];
    if (c->to != c->from)
        time_destroy(c->to);
    c->to = time;
    return GRAZE_OK;
}

graze_status word_put_time(word_builder *l, graze_state state, size_t piece, const algebraic *u) {
    int begins = last_of(l) != GRAZE_STATE_B;
    graze_status status = append_state(l, state);
    if (status || state != GRAZE_STATE_B)
        return status;
    return touch_at(l, begins, piece, u);
}

graze_status word_put_gap(word_builder *l, graze_state state) {
    if (state == GRAZE_STATE_B && last_of(l) != GRAZE_STATE_B)
        return context_fail(l->context, GRAZE_EINTERNAL, "a slide does not begin on the boundary");
    return append_state(l, state);
}

graze_status word_put_crossing(word_builder *l) {
    TRY(append_state(l, GRAZE_STATE_B));
    return begin_contact(l, NULL);
}

graze_status word_add_cell(word_builder *l, contact *c, size_t primitive) {
    for (size_t k = 0; k < c->cell_count; k++)
        if (c->cell[k].a == primitive)
            return GRAZE_OK;
    if (!array_reserve(&c->cell, &c->cell_capacity, c->cell_count + 1, sizeof *c->cell))
        return no_memory(l);
    c->cell[c->cell_count++] = (graze_cell){.kind = GRAZE_CELL_PRIMITIVE, .a = primitive};
    qsort(c->cell, c->cell_count, sizeof *c->cell, cell_compare);
    return GRAZE_OK;
}
