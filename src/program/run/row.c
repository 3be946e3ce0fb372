/* Checks the form of rows.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Counts, case, class, definition and pmc all follow from the word (graze_word_verdict), so they
 * are made from it and compared as text.
 */
#define _GNU_SOURCE /* memmem */
#include "program/run/row.h"

#include <string.h>
#include "program/run/enclosed.h"
#include "program/run/site_row.h"

/* Room for the longest: two names, `ext`, a digit and three counts. */
enum { ANSWERS = 128 };

/* Go past a text if the line at hand begins with it. */
static int skip_text(const char **at, const char *text) {
    size_t length = strlen(text);
    int same = strncmp(*at, text, length) == 0;
    *at += same ? length : 0;
    return same;
}

/* The value of a line of a head; a field without start if there is none. */
static field note_of(const char *head, const char *key) {
    field rest = {head, strlen(head)}, value;
    while (rest.length)
        if (field_behind(&value, field_line(&rest), key))
            return value;
    return (field){NULL, 0};
}

static void read_options(row_form *out, const char *operation, const char *folds,
                         const char *head) {
    if (field_is(note_of(head, operation), "unsweep"))
        out->options.operation = GRAZE_UNSWEEP;
    if (field_is(note_of(head, folds), "combined"))
        out->options.folds = GRAZE_FOLDS_COMBINED;
    if (field_is(note_of(head, "# columns "), "pmc"))
        out->options.columns = GRAZE_COLUMNS_PMC;
}

static int read_certificate_form(row_form *out, const char *head) {
    field dimension = note_of(head, "dimension "), times = note_of(head, "signs ");
    if (!dimension.start || !times.start || !(field_is(dimension, "2") || field_is(dimension, "3")))
        return 0;
    out->dimension = *dimension.start - '0';
    out->separator = ' ';
    out->contacts = field_is(note_of(head, "contacts "), "yes");
    while (times.length)
        out->end = row_take(&times, ' ');
    read_options(out, "operation ", "folds ", head);
    return 1;
}

static int read_table_form(row_form *out, const char *head) {
    size_t length = strlen(head);
    const char *at = head;
    for (const char *next; *at == '#' && (next = strchr(at, '\n')) != NULL; at = next + 1)
        ;
    read_options(out, "# operation ", "# folds ", head);
    out->topo = field_is(note_of(head, "# topo "), "yes");
    out->sdf = note_of(head, "# sdf ").start != NULL;
    out->certain = note_of(head, "# motion-error ").start != NULL;
    if (strncmp(at, "time,", 5) == 0)
        return site_form_read(out, at, field_is(note_of(head, "# snap "), "yes"));
    field written = note_of(head, "# coordinates ");
    if (written.start)
        out->coordinates =
            field_is(written, "as-given") ? COORDINATES_AS_GIVEN : COORDINATES_DECIMAL;
    size_t last = (size_t)(out->topo + out->certain + 3 * out->sdf);
    if (!length || head[length - 1] != '\n' || !skip_text(&at, "x,y,"))
        return 0;
    out->dimension = skip_text(&at, "z,") ? 3 : 2;
    int sweep = out->options.operation == GRAZE_SWEEP;
    int pmc_alone = out->options.columns == GRAZE_COLUMNS_PMC;
    if (!skip_text(&at, pmc_alone ? "pmc"
                        : sweep   ? "pmc,class,definition,case,i,t,word"
                                  : "pmc,word"))
        return 0;
    if (*at == ',')
        out->others = fields_count((field){at + 1, (size_t)(head + length - 1 - at - 1)});
    int good = *at == ',' ? out->others > 0 && out->others >= last : *at == '\n' && !last;
    out->others -= good ? last : 0;
    return good;
}

int row_form_read(row_form *out, result_kind kind, const char *head) {
    *out = (row_form){.kind = kind, .separator = ','};
    return kind == RESULT_TABLE ? read_table_form(out, head) : read_certificate_form(out, head);
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

/* Take the point from the front of a row. */
static int take_point_of(row_parts *out, field *rest, const row_form *form) {
    const char *start = rest->start;
    for (int k = 0; k < form->dimension; k++)
        row_take(rest, form->separator);
    out->point = (field){start, (size_t)(rest->start - start)};
    if (out->point.length < (size_t)form->dimension)
        return 0;
    out->point.length--; /* the separator behind it */
    return 1;
}

/* The answer of a row of pmc alone, and what stands behind it. */
static const char *check_pmc_row(row_parts *out, const row_form *form, field rest) {
    field pmc = row_take(&rest, ',');
    int known = 0, more = rest.start > pmc.start + pmc.length;
    for (int k = GRAZE_IN; k <= GRAZE_OUT; k++)
        known |= field_is(pmc, graze_pmc_name((graze_pmc)k));
    out->word = out->topo = (field){"", 0};
    out->rest = rest;
    if (!known)
        return "in, on or out behind the point";
    if (more != (form->others > 0))
        return form->others ? "the further columns of the column line" : "no further columns";
    return NULL;
}

/* No row that is `on` is certain. */
static int certainty_fits(graze_pmc pmc, field certain) {
    return field_is(certain, "no") || (field_is(certain, "yes") && pmc != GRAZE_ON);
}

static const char *check_table_row(row_parts *out, const row_form *form, graze_context *context,
                                   field row) {
    char answers[ANSWERS];
    graze_verdict verdict;
    field rest = row;
    if (!take_point_of(out, &rest, form))
        return "a point and its answers";
    if (form->options.columns == GRAZE_COLUMNS_PMC)
        return check_pmc_row(out, form, rest);
    const char *own = rest.start;
    for (int k = form->options.operation == GRAZE_UNSWEEP ? 1 : 6; k > 0; k--)
        row_take(&rest, ',');
    const char *before_word = rest.start;
    out->word = row_take(&rest, ',');
    int more = out->word.start + out->word.length < row.start + row.length;
    if (graze_word_verdict(&verdict, context, out->word.start, out->word.length, &form->options))
        return "a word of letters O, I, B of which every second one is B";
    size_t length = write_row_answers(answers, form, &verdict);
    if ((size_t)(before_word - own) != length || memcmp(own, answers, length) != 0)
        return "the answers that belong to its word";
    out->topo = form->topo && more ? take_last_column(&rest) : (field){"", 0};
    if (form->topo && !position_fits(form, verdict.pmc, out->topo))
        return "a position in the last column that goes with pmc";
    if (form->certain && !certainty_fits(verdict.pmc, take_last_column(&rest)))
        return "yes or no in the column certain, and no for `on`";
    if (form->sdf) {
        field time = take_last_column(&rest), high = take_last_column(&rest);
        if (!enclosed_fits(verdict.pmc, take_last_column(&rest), high, time))
            return "an enclosure of the distance that goes with pmc";
    }
    if ((form->topo || form->sdf ? rest.length > 0 : more) != (form->others > 0))
        return form->others ? "the further columns of the column line" : "no further columns";
    out->rest = rest;
    return NULL;
}

/* As in a table, but with blanks, and behind the others k, which no verdict has: by parity
 * (proofs/claims.md C11). */
static size_t write_certified_answers(char text[ANSWERS], const row_form *form,
                                      const graze_verdict *v, field word) {
    size_t length = write_row_answers(text, form, v);
    unsigned long ends =
        (unsigned long)(*word.start == 'I') + (unsigned long)(word.start[word.length - 1] == 'I');
    if (form->options.operation == GRAZE_SWEEP)
        length = (size_t)(put_row_count(text + length, ((unsigned long)v->i + ends) / 2) - text);
    for (size_t k = 0; k < length; k++)
        text[k] = text[k] == ',' ? ' ' : text[k];
    return length - 1; /* without the last blank */
}

static const char *check_certified_row(row_parts *out, const row_form *form, graze_context *context,
                                       field row) {
    char answers[ANSWERS];
    graze_verdict verdict;
    field rest = row;
    if (!field_is(row_take(&rest, ' '), "row") || !take_point_of(out, &rest, form))
        return "`row`, a point and its answers";
    out->word = row_take(&rest, ' ');
    out->rest = (field){"", 0};
    if (graze_word_verdict(&verdict, context, out->word.start, out->word.length, &form->options))
        return "a word of letters O, I, B of which every second one is B";
    size_t length = write_certified_answers(answers, form, &verdict, out->word);
    return field_equal(rest, (field){answers, length}) ? NULL
                                                       : "the answers that belong to its word";
}

const char *row_check(row_parts *out, const row_form *form, graze_context *context, field row) {
    if (form->sites)
        return site_row_check(out, form, context, row);
    return (form->kind == RESULT_TABLE ? check_table_row : check_certified_row)(out, form, context,
                                                                                row);
}

static int is_any_number(graze_context *context, field f) {
    mpq_t value;
    mpq_init(value);
    graze_status read = graze_number_parse(value, context, f.start, f.length);
    mpq_clear(value);
    return read == GRAZE_OK;
}

/* A decimal as graze writes it has neither a slash nor a plus in front. */
static int is_decimal(graze_context *context, field f) {
    return f.length && *f.start != '+' && !memchr(f.start, '/', f.length) &&
           is_any_number(context, f);
}

const char *row_point_is_written(field point, const row_form *form, graze_context *context) {
    static const char *const expected[] = {[COORDINATES_EXACT] = "coordinates such as -12 or 22/7",
                                           [COORDINATES_AS_GIVEN] = "coordinates that are numbers",
                                           [COORDINATES_DECIMAL] =
                                               "coordinates such as -12 or 0.125"};
    int good = 1;
    for (int k = 0; k < (form->sites ? 2 * form->dimension + 1 : form->dimension); k++) {
        field number = row_take(&point, form->separator);
        good &= form->coordinates == COORDINATES_EXACT      ? row_is_number(number)
                : form->coordinates == COORDINATES_AS_GIVEN ? is_any_number(context, number)
                                                            : is_decimal(context, number);
    }
    return good && !point.length ? NULL : expected[form->coordinates];
}

int row_is_undecided(field row) {
    static const char csv[] = ",undecided", json[] = "\"topo\":\"undecided\"";
    size_t length = sizeof csv - 1;
    if (row.length >= length && memcmp(row.start + row.length - length, csv, length) == 0)
        return 1;
    return row.length && *row.start == '{' && memmem(row.start, row.length, json, sizeof json - 1);
}
