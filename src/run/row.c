/* Checks the form of rows.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Counts, case, class, definition and pmc all follow from the word (graze_word_verdict), so they
 * are made from it and compared as text.
 */
#define _GNU_SOURCE /* memmem */
#include "run/row.h"

#include <ctype.h>
#include <string.h>

/* Room for the longest: two names, `ext`, a digit and two counts. */
enum { ANSWERS = 128 };

/* Go past a text if the line at hand begins with it. */
static int skip_text(const char **at, const char *text) {
    size_t length = strlen(text);
    int same = strncmp(*at, text, length) == 0;
    *at += same ? length : 0;
    return same;
}

int row_form_read(row_form *out, const char *head) {
    size_t length = strlen(head);
    const char *at = head;
    memset(out, 0, sizeof *out);
    for (const char *next; *at == '#' && (next = strchr(at, '\n')) != NULL; at = next + 1) {
        if (strncmp(at, "# operation unsweep\n", 20) == 0)
            out->options.operation = GRAZE_UNSWEEP;
        if (strncmp(at, "# folds combined\n", 17) == 0)
            out->options.folds = GRAZE_FOLDS_COMBINED;
        if (strncmp(at, TOPO_LINE, strlen(TOPO_LINE)) == 0)
            out->topo = 1;
    }
    if (!length || head[length - 1] != '\n' || !skip_text(&at, "x,y,"))
        return 0;
    out->dimension = skip_text(&at, "z,") ? 3 : 2;
    int sweep = out->options.operation == GRAZE_SWEEP;
    if (!skip_text(&at, sweep ? "pmc,class,definition,case,i,t,word" : "pmc,word"))
        return 0;
    if (*at == ',')
        out->others = fields_count((field){at + 1, (size_t)(head + length - 1 - at - 1)});
    int good = *at == ',' ? out->others > 0 : *at == '\n' && !out->topo;
    out->others -= (size_t)(good && out->topo);
    return good;
}

/* Take the bytes before the next comma, or up to the end. */
static field take_column(field *rest) {
    field out = {rest->start, 0}; /* fields are a few bytes long */
    while (out.length < rest->length && out.start[out.length] != ',')
        out.length++;
    size_t gone = out.length + (out.length < rest->length);
    *rest = (field){rest->start + gone, rest->length - gone};
    return out;
}

/* Add a name and a comma. */
static char *put_row_name(char *at, const char *name) {
    size_t length = strlen(name);
    memcpy(at, name, length);
    at[length] = ',';
    return at + length + 1;
}

static char *put_row_count(char *at, unsigned long value) {
    char digits[24], *first = digits + sizeof digits - 1;
    *first = '\0';
    do
        *--first = (char)('0' + value % 10);
    while (value /= 10);
    return put_row_name(at, first);
}

/* The answers before the word, as the table has them; returns their length. */
static size_t write_row_answers(char text[ANSWERS], const row_form *form, const graze_verdict *v) {
    char *at = put_row_name(text, graze_pmc_name(v->pmc));
    if (form->options.operation == GRAZE_UNSWEEP)
        return (size_t)(at - text);
    at = put_row_name(at, graze_class_name(v->class_));
    at = v->definition ? put_row_count(at, (unsigned long)v->definition) : put_row_name(at, "ext");
    at = put_row_count(at, (unsigned long)v->case_);
    return (size_t)(put_row_count(put_row_count(at, v->i), v->t) - text);
}

/* Take the last column off. */
static field take_last_column(field *rest) {
    field out = {rest->start + rest->length, 0};
    while (out.start > rest->start && out.start[-1] != ',')
        out.start--, out.length++;
    rest->length -= out.length + (out.length < rest->length);
    return out;
}

/* Does the position go with the verdict? */
static int position_fits(const row_form *form, graze_pmc pmc, field topo) {
    if (pmc != GRAZE_ON)
        return field_is(
            topo, graze_topo_name(pmc == GRAZE_IN ? GRAZE_TOPO_INTERIOR : GRAZE_TOPO_EXTERIOR));
    int sweep = form->options.operation == GRAZE_SWEEP;
    return field_is(topo, graze_topo_name(GRAZE_TOPO_BOUNDARY)) ||
           (sweep && (field_is(topo, graze_topo_name(GRAZE_TOPO_INTERIOR)) ||
                      field_is(topo, graze_topo_name(GRAZE_TOPO_UNDECIDED))));
}

const char *row_check(row_parts *out, const row_form *form, graze_context *context, field row) {
    char answers[ANSWERS];
    graze_verdict verdict;
    field rest = row;
    for (int k = 0; k < form->dimension; k++)
        take_column(&rest);
    const char *own = rest.start;
    if (own - row.start < form->dimension || row.start == own)
        return "a point and its answers";
    out->point = (field){row.start, (size_t)(own - row.start - 1)};
    for (int k = form->options.operation == GRAZE_UNSWEEP ? 1 : 6; k > 0; k--)
        take_column(&rest);
    const char *before_word = rest.start;
    field word = take_column(&rest);
    int more = word.start + word.length < row.start + row.length;
    if (graze_word_verdict(&verdict, context, word.start, word.length, &form->options))
        return "a word of letters O, I, B of which every second one is B";
    size_t length = write_row_answers(answers, form, &verdict);
    if ((size_t)(before_word - own) != length || memcmp(own, answers, length) != 0)
        return "the answers that belong to its word";
    out->topo = form->topo && more ? take_last_column(&rest) : (field){"", 0};
    if (form->topo && !position_fits(form, verdict.pmc, out->topo))
        return "a position in the last column that goes with pmc";
    if ((form->topo ? rest.length > 0 : more) != (form->others > 0))
        return form->others ? "the further columns of the column line" : "no further columns";
    out->rest = rest;
    return NULL;
}

/* A minus, digits without a zero in front; then nothing, or a slash and the same from 2 up. */
static int is_written_number(field f) {
    const char *at = f.start, *end = at + f.length;
    for (int part = 0; part < 2; part++) {
        int minus = part == 0 && at < end && *at == '-';
        at += minus;
        int zero = at < end && *at == '0';
        const char *digits = at;
        while (at < end && isdigit((unsigned char)*at))
            at++;
        if (at == digits || (zero && (at - digits > 1 || minus || part == 1)))
            return 0;
        if (at == end)
            return part == 0 || at - digits > 1 || *digits > '1';
        if (*at++ != '/' || zero)
            return 0;
    }
    return 0;
}

int row_point_is_written(field point, int dimension) {
    int good = 1;
    for (int k = 0; k < dimension; k++)
        good &= is_written_number(take_column(&point));
    return good && !point.length;
}

int row_is_undecided(field row) {
    static const char csv[] = ",undecided", json[] = "\"topo\":\"undecided\"";
    size_t length = sizeof csv - 1;
    if (row.length >= length && memcmp(row.start + row.length - length, csv, length) == 0)
        return 1;
    return row.length && *row.start == '{' && memmem(row.start, row.length, json, sizeof json - 1);
}
