/* Verdict, word, contacts and cells. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/row_parts.h"

#include "decide/verdict/verdict.h"

enum { NEAR_DIGITS = 17 };

/* Write the decimal of a time and, where pieces have rows of a log, the row of its piece. */
static void put_near_decimal(json_writer *w, const graze_time *time) {
    text_owned(json_begin(w, "near"), decimal_of_time(NULL, time, NEAR_DIGITS));
    unsigned long row = time->motion->piece[time_first_piece(time)].row;
    if (time->motion->has_rows)
        json_index(w, "row", row != 0, row);
}

/* Write a cell; of one of several balls and capsules with its number. */
static void put_body_cell(json_writer *w, const char *key, const graze_pair *pair, int side,
                          graze_cell cell) {
    size_t body;
    json_open(w, key, '{');
    int several = collide_in_body(&body, &cell, pair->base[side]);
    json_cell_members(w, &cell);
    if (several)
        json_count(w, "body", body);
    json_close(w, '}');
}

static void put_cell_pairs(json_writer *w, const graze_pair *pair, const cell_pairs *cells) {
    json_open(w, "cells", '[');
    for (size_t k = 0; cells && k < cells->count; k++) {
        json_open(w, NULL, '{');
        put_body_cell(w, "moving", pair, 0, cells->item[k].moving);
        put_body_cell(w, "fixed", pair, 1, cells->item[k].fixed);
        json_text(w, "type", cell_pair_name(&cells->item[k]));
        json_close(w, '}');
    }
    json_close(w, ']');
}

static void put_pair_contact(json_writer *w, const char *key, const graze_pair *pair,
                             const pair_contact *c) {
    json_open(w, key, '{');
    json_time(w, "from", c->from);
    json_time(w, "to", pair->options.first ? NULL : c->to);
    put_near_decimal(w, c->from);
    json_contact_kind(w, "kind", pair->options.first ? 0 : verdict_kind(c->left, c->right));
    put_cell_pairs(w, pair, &c->cells);
    json_close(w, '}');
}

/* Write the first contact; if the motion begins in I, its start time, without cells. */
static void put_first(json_writer *w, const graze_pair *pair) {
    if (pair->start) {
        json_open(w, "first", '{');
        json_time(w, "from", pair->start);
        put_near_decimal(w, pair->start);
        put_cell_pairs(w, pair, NULL);
        json_close(w, '}');
    } else if (pair->walk.contact_count) {
        put_pair_contact(w, "first", pair, &pair->walk.contact[0]);
    } else {
        json_text(w, "first", NULL);
    }
}

static void put_closest(json_writer *w, const graze_pair *pair) {
    const graze_closest *c = &pair->closest;
    json_open(w, "closest", '{');
    json_bound(w, "low", c->low, 0);
    json_bound(w, "high", c->high, 1);
    json_time(w, "t", c->time);
    put_near_decimal(w, c->time);
    if (c->placed)
        json_open(w, "at", '[');
    else
        json_text(w, "at", NULL);
    for (int side = 0; side < 2 && c->placed; side++) {
        json_open(w, NULL, '[');
        for (int i = 0; i < pair->pair.motion->dimension; i++)
            json_double(w, NULL, c->at[3 * side + i]);
        json_ends(w, side ? "]]" : "]");
    }
    json_bool(w, "wide", c->wide);
    json_close(w, '}');
}

void pair_json(text *out, const graze_pair *pair) {
    json_writer w = {.out = out};
    const char next[] = {(char)collide_next(pair), '\0'};
    json_open(&w, NULL, '{');
    if (!pair->is_bounded) {
        json_text(&w, "verdict", pair_verdict_word(pair));
        json_text(&w, "word", pair->walk.word);
    }
    if (pair->options.first && !pair->is_bounded)
        json_text(&w, "next", *next ? next : NULL);
    if (!fmpq_is_zero(pair->distance))
        json_rational(&w, "clearance", pair->distance);
    if (pair->is_bounded) {
        json_rational(&w, "motion_error", pair->error);
        json_open(&w, "first", '{');
        json_time(&w, "low", pair->bounds.low);
        json_time(&w, "high", pair->bounds.high);
        json_ends(&w, "}}\n");
        return;
    }
    put_first(&w, pair);
    json_open(&w, "contacts", '[');
    for (size_t k = 0; k < pair->walk.contact_count; k++)
        put_pair_contact(&w, NULL, pair, &pair->walk.contact[k]);
    json_close(&w, ']');
    if (pair->closest.time)
        put_closest(&w, pair);
    json_ends(&w, "}\n");
}
