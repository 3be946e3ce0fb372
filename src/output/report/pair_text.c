/* Verdict, word, contacts and cells in words. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/row_parts.h"

#include "base/context/scope.h"
#include "decide/verdict/verdict.h"

const char *pair_verdict_name(graze_pair_verdict verdict) {
    return verdict == GRAZE_PAIR_CLEAR     ? "clear"
           : verdict == GRAZE_PAIR_TOUCH   ? "touch"
           : verdict == GRAZE_PAIR_OVERLAP ? "overlap"
           : verdict == GRAZE_PAIR_CONTACT ? "meets"
                                           : "none";
}

const char *pair_verdict_word(const graze_pair *pair) {
    graze_pair_verdict verdict = collide_verdict(pair);
    int inside = pair->options.first && pair->pair.complement && verdict == GRAZE_PAIR_CLEAR;
    return inside ? "inside" : pair_verdict_name(verdict);
}

const char *cell_pair_name(const graze_cell_pair *cells) {
    static const char *const names[4][4] = {{"", "", "", ""},
                                            {"", "facet-facet", "facet-edge", "facet-vertex"},
                                            {"", "edge-facet", "edge-edge", "edge-vertex"},
                                            {"", "vertex-facet", "vertex-edge", "vertex-vertex"}};
    unsigned a = cells->moving.kind, b = cells->fixed.kind;
    return a < 4 && b < 4 ? names[a][b] : "";
}

enum { NEAR_DIGITS = 17, CELLS_SHOWN = 8 };

/* Append a time: a rational as it is, with a decimal where it is no integer; an irrational time as
 * a decimal. The row of the motion's piece follows. NULL is none. */
static void tell_pair_time(text *t, const graze_time *time) {
    text_put(t, time ? "" : "none");
    if (!time)
        return;
    int rational = time_is_rational(time);
    int near = rational && !fmpz_is_one(fmpq_denref(time->low));
    unsigned long row = time->motion->piece[time_first_piece(time)].row;
    FREED(char, decimal, decimal_of_time(NULL, time, NEAR_DIGITS));
    t->failed |= !decimal;
    if (rational)
        text_rational(t, time->low);
    else
        text_format(t, "%s...", decimal ? decimal : "");
    if (near)
        text_format(t, " (%s%s", decimal ? decimal : "", row ? "" : ")");
    if (row)
        text_format(t, "%srow %lu)", near ? ", " : " (", row);
}

/* Append a cell; of one of several balls and capsules with its number. */
static void tell_body_cell(text *t, const graze_pair *pair, int side, graze_cell cell) {
    size_t body;
    int several = collide_in_body(&body, &cell, pair->base[side]);
    report_put_cell(t, &cell);
    if (several)
        text_format(t, " of body %zu", body);
}

static void tell_cells(text *t, const graze_pair *pair, const cell_pairs *cells) {
    for (size_t k = 0; k < cells->count && k < CELLS_SHOWN; k++) {
        text_put(t, k ? ", " : ": ");
        tell_body_cell(t, pair, 0, cells->item[k].moving);
        text_put(t, " of MOVING with ");
        tell_body_cell(t, pair, 1, cells->item[k].fixed);
    }
    if (cells->count > CELLS_SHOWN)
        text_format(t, ", and %zu more", cells->count - CELLS_SHOWN);
    text_put(t, "\n");
}

static void tell_contact(text *t, const graze_pair *pair, const pair_contact *c) {
    graze_state next = collide_next(pair);
    graze_kind kind = pair->options.first ? 0 : verdict_kind(c->left, c->right);
    text_put(t, pair->options.first ? "first contact " : "contact ");
    tell_pair_time(t, c->from);
    if (!pair->options.first && c->to != c->from) {
        text_put(t, " to ");
        tell_pair_time(t, c->to);
    }
    if (pair->options.first) /* the word OB does not tell whether the contact lasts */
        text_put(t, next == GRAZE_STATE_ABSENT ? ", where the motion ends"
                    : next == GRAZE_STATE_B    ? ", which lasts"
                                               : "");
    if (kind)
        text_put(t, kind == GRAZE_INTERSECTION ? ", intersection" : ", tangency");
    tell_cells(t, pair, &c->cells);
}

/* Append when the moving solid first touches or leaves the fixed one, and what follows. */
static void tell_first_inside(text *t, const graze_pair *pair) {
    graze_state next = collide_next(pair);
    text_put(t, next == GRAZE_STATE_I ? "leaves at " : "touches at ");
    tell_pair_time(t, pair->walk.contact[0].from);
    text_put(t, next == GRAZE_STATE_I        ? ""
                : next == GRAZE_STATE_ABSENT ? ", where the motion ends"
                                             : " and stays inside at first");
}

/* Append the verdict. Verdicts on GRAZE_PAIR_INSIDE have words of their own. */
static void tell_verdict(text *t, const graze_pair *pair) {
    graze_pair_verdict verdict = collide_verdict(pair);
    int inside = pair->options.question == GRAZE_PAIR_INSIDE;
    if (inside && verdict == GRAZE_PAIR_CONTACT) {
        tell_first_inside(t, pair);
    } else if (!inside || (pair->options.first && verdict == GRAZE_PAIR_OVERLAP)) {
        text_put(t, pair_verdict_name(verdict));
    } else if (verdict != GRAZE_PAIR_OVERLAP) {
        text_put(t, verdict == GRAZE_PAIR_CLEAR ? "inside" : "inside, touching");
    } else {
        text_put(t, "leaves at ");
        tell_pair_time(t, collide_overlap_time(pair));
    }
    if (!fmpq_is_zero(pair->distance)) {
        text_put(t, " at clearance ");
        text_rational(t, pair->distance);
    }
    text_put(t, "\n");
}

/* Append the least distance, its time and its places. */
static void tell_closest(text *t, const graze_pair *pair) {
    const graze_closest *c = &pair->closest;
    char low[BOUND_ROOM], high[BOUND_ROOM];
    report_bound(low, c->low, 0);
    report_bound(high, c->high, 1);
    text_format(t, "closest %s%s%s at ", low, c->placed ? " to " : "", c->placed ? high : "");
    tell_pair_time(t, c->time);
    for (int side = 0; side < 2 && c->placed; side++) {
        for (int i = 0; i < pair->pair.motion->dimension; i++)
            text_format(t, "%s%.17g", i ? ", " : side ? " and (" : ": (", c->at[3 * side + i]);
        text_put(t, side ? ") of FIXED" : ") of MOVING");
    }
    text_put(t, c->wide ? ", wide\n" : "\n");
}

void pair_text(text *out, const graze_pair *pair) {
    if (pair->is_bounded) {
        text_put(out, "first contact between ");
        tell_pair_time(out, pair->bounds.low);
        text_put(out, " and ");
        tell_pair_time(out, pair->bounds.high);
        text_put(out, "\n");
        return;
    }
    tell_verdict(out, pair);
    text_format(out, "word %s\n", pair->walk.word);
    for (size_t k = 0; k < pair->walk.contact_count; k++)
        tell_contact(out, pair, &pair->walk.contact[k]);
    if (pair->closest.time)
        tell_closest(out, pair);
}

void pair_fields(text *out, const graze_pair *pair) {
    const pair_contact *c = pair->walk.contact_count && !pair->start ? pair->walk.contact : NULL;
    const char next[] = {(char)collide_next(pair), '\0'};
    if (pair->is_bounded) {
        report_put_time_near(out, pair->bounds.low);
        text_put(out, ",");
        report_put_time_near(out, pair->bounds.high);
        return;
    }
    text_format(out, "%s,%s,", pair_verdict_word(pair), pair->walk.word);
    report_put_time_near(out, c ? c->from : pair->start);
    text_put(out, ",");
    if (pair->options.first)
        text_format(out, "%s,", next);
    for (size_t k = 0; c && k < c->cells.count; k++) {
        text_put(out, k ? "; " : "");
        tell_body_cell(out, pair, 0, c->cells.item[k].moving);
        text_put(out, " with ");
        tell_body_cell(out, pair, 1, c->cells.item[k].fixed);
    }
}
