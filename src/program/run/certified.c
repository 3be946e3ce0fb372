/* Checks the form of a certificate's intervals and contacts (proofs/certificate.md, section 1).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/certified.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"

void certified_clear(certified *c) {
    free(c->word);
    *c = (certified){.word = NULL};
}

int certified_begin(certified *c, field word) {
    if (!array_reserve(&c->word, &c->capacity, word.length, 1))
        return 0;
    memcpy(c->word, word.start, word.length);
    c->length = word.length;
    c->at = 0;
    c->begun = c->reached = c->ended = c->due = 0;
    return 1;
}

static int is_kind(field f) {
    size_t boundaries = 0;
    for (size_t k = 0; k < f.length; k++) {
        if (!memchr("OBI", f.start[k], 3))
            return 0;
        boundaries += f.start[k] == 'B';
    }
    return f.length == 1 || (f.length == 2 && boundaries == 1) ||
           (f.length == 3 && f.start[1] == 'B');
}

/* The coefficients of a polynomial: at least two integers. */
static int are_coefficients(field rest) {
    size_t count = 0;
    for (; rest.length; count++) {
        field f = row_take(&rest, ' ');
        if (!row_is_number(f) || memchr(f.start, '/', f.length))
            return 0;
    }
    return count >= 2;
}

/* Go on in the word by one letter, or stay at it. */
static int spell(certified *c, char letter) {
    if (c->begun && c->word[c->at] != letter)
        c->due |= c->word[c->at++] == 'B';
    c->begun = 1;
    return c->at < c->length && c->word[c->at] == letter;
}

/* Two numbers of vertices. */
static int is_edge(field f) {
    field first = row_take(&f, '-');
    return row_is_number(first) && row_is_number(f);
}

/* `contact`, times and cells. */
static int is_contact(field line) {
    field rest;
    if (!field_behind(&rest, line, "contact ") || !rest.length ||
        rest.start[rest.length - 1] == ' ')
        return 0;
    while (rest.length) {
        field f = row_take(&rest, ' ');
        int is_word = field_is(f, "root") || field_is(f, "to") || field_is(f, "face") ||
                      field_is(f, "edge") || field_is(f, "vertex");
        if (!is_word && !row_is_number(f) && !is_edge(f))
            return 0;
    }
    return 1;
}

static const char *take_contact(certified *c, field line) {
    c->due = 0;
    c->ended = c->reached;
    return is_contact(line) ? NULL : "a contact of the row: its times and cells";
}

static const char *take_interval(certified *c, const row_form *form, field line) {
    field rest = line, kind = row_take(&rest, ' '), time = row_take(&rest, ' ');
    if (!is_kind(kind) || !row_is_number(time) ||
        (kind.length == 3 ? !are_coefficients(rest) : rest.length != 0))
        return "an interval of the row: letters, its end and, of three letters, a polynomial";
    for (size_t k = 0; k < kind.length; k++)
        if (!spell(c, kind.start[k]))
            return "intervals that spell the row's word";
    c->reached = field_equal(time, form->end);
    c->due = form->contacts && (c->due || (c->reached && c->word[c->at] == 'B'));
    c->ended = c->reached && !c->due;
    return c->reached && c->at + 1 != c->length ? "intervals that spell the row's word" : NULL;
}

const char *certified_line(certified *c, const row_form *form, field line) {
    return c->due ? take_contact(c, line) : take_interval(c, form, line);
}
