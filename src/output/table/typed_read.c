/* Reads rows of values into typed columns.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A further column is one of numbers until one of its fields is no number. Until then its fields
 * are also kept as text, so that they can become texts.
 */
#include "output/table/table.h"

#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "base/number/rounding.h"

static graze_status typed_no_memory(const typed_table *t) {
    return context_fail(t->context, GRAZE_ESYSTEM, "out of memory for a table");
}

/* ------------------------------------------------------------------------------- columns */

const answer_column answer_columns[ANSWER_COLUMNS] = {
    {"pmc", TYPED_PMC, 1},    {"class", TYPED_CLASS, 0}, {"definition", TYPED_DEFINITION, 0},
    {"case", TYPED_COUNT, 0}, {"i", TYPED_COUNT, 0},     {"t", TYPED_COUNT, 0},
    {"word", TYPED_WORD, 1}};

/* The kind of an answer or of a coordinate. */
static typed_kind kind_of(field name) {
    for (size_t k = 0; k < ANSWER_COLUMNS; k++)
        if (field_is(name, answer_columns[k].name))
            return answer_columns[k].kind;
    return TYPED_DOUBLE;
}

/* The number of Graze's columns: those up to `word`, or up to `pmc` in a table of pmc alone.
 * Further columns may have any name. */
static size_t own_columns(const fields *names, int pmc_alone) {
    size_t k = 0;
    while (k < names->count && !field_is(names->item[k], pmc_alone ? "pmc" : "word"))
        k++;
    return k + 1;
}

graze_status typed_begin(typed_table *t, int dimension, field names, int pmc_alone,
                         const typed_kind *last, size_t last_count) {
    fields cut = {NULL, 0, 0};
    t->dimension = dimension;
    text_bytes(&t->names, names.start, names.length);
    fields_result result = t->names.failed
                               ? FIELDS_NO_MEMORY
                               : fields_cut(&cut, (field){t->names.data, t->names.length});
    if (result == FIELDS_CUT)
        t->column = calloc(cut.count, sizeof *t->column);
    t->own = own_columns(&cut, pmc_alone);
    for (size_t k = 0; t->column && k < cut.count; k++) {
        t->column[k].name = field_content(cut.item[k]);
        t->column[k].kind = k < t->own                   ? kind_of(t->column[k].name)
                            : k < cut.count - last_count ? TYPED_NUMBER
                                                         : last[k + last_count - cut.count];
    }
    t->last = last_count;
    t->column_count = t->column ? cut.count : 0;
    fields_clear(&cut);
    if (result == FIELDS_OPEN_QUOTE)
        return context_fail(t->context, GRAZE_EINPUT,
                            "a quote in the names of the columns is not closed");
    return t->column ? GRAZE_OK : typed_no_memory(t);
}

/* Make room for one more value; 0 when out of memory. */
static int column_reserve(typed_column *c, size_t rows) {
    return c->kind == TYPED_DOUBLE || c->kind == TYPED_NUMBER
               ? array_reserve(&c->number, &c->capacity, rows + 1, sizeof *c->number)
               : array_reserve(&c->code, &c->capacity, rows + 1, sizeof *c->code);
}

static int typed_reserve(typed_table *t) {
    int done = 1;
    for (size_t k = 0; k < t->column_count && done; k++)
        done = column_reserve(&t->column[k], t->row_count);
    return done;
}

/* -------------------------------------------------------------------------------- fields */

/* Read a number; *number is 1 if the field is one, even if no double can hold it. */
static graze_status read_number(double *out, int *number, graze_context *context, field f) {
    LOCAL(fmpq, value);
    *number = 0;
    TRY(rational_parse(value, context, f.start, f.length));
    *number = 1;
    graze_status status = rational_nearest(out, context, value);
    return status == GRAZE_EINPUT
               ? context_fail(context, status, "'%.*s'; expected a number that binary64 can hold",
                              FIELD_SHOWN(f))
               : status;
}

static graze_status add_text(const typed_table *t, typed_column *c, size_t row, field f) {
    return texts_number(&c->code[row], &c->texts, f) ? GRAZE_OK : typed_no_memory(t);
}

/* Turn a further column, in which a field is no number, into a column of texts. */
static graze_status become_texts(const typed_table *t, typed_column *c) {
    graze_status status = GRAZE_OK;
    c->kind = TYPED_TEXT;
    c->capacity = 0;
    if (!column_reserve(c, t->row_count))
        return typed_no_memory(t);
    field rest = {c->fields.data, c->fields.length};
    for (size_t row = 0; row < t->row_count && !status; row++)
        status = add_text(t, c, row, field_line(&rest));
    free(c->number);
    c->number = NULL;
    text_clear(&c->fields);
    return status;
}

/* Add a field to a further column. */
static graze_status add_further(const typed_table *t, typed_column *c, field f) {
    if (c->kind == TYPED_NUMBER) {
        int number;
        graze_status status = read_number(&c->number[t->row_count], &number, t->context, f);
        if (!status) {
            text_bytes(&c->fields, f.start, f.length);
            text_put(&c->fields, "\n");
            return c->fields.failed ? typed_no_memory(t) : GRAZE_OK;
        }
        if (status == GRAZE_EINPUT && !number)
            status = become_texts(t, c);
        TRY(status);
    }
    return add_text(t, c, t->row_count, f);
}

/* ---------------------------------------------------------------------------------- rows */

/* Take `length` bytes from the front; 0 if there are fewer. */
static int take_bytes(void *out, field *rest, size_t length) {
    if (rest->length < length)
        return 0;
    memcpy(out, rest->start, length);
    rest->start += length;
    rest->length -= length;
    return 1;
}

/* Take a text, which must not have line ends. */
static int take_text(field *out, field *rest) {
    if (!take_bytes(&out->length, rest, sizeof out->length) || rest->length < out->length)
        return 0;
    out->start = rest->start;
    rest->start += out->length;
    rest->length -= out->length;
    return !memchr(out->start, '\n', out->length);
}

static graze_status not_whole(const typed_table *t) {
    return context_fail(t->context, GRAZE_EINPUT, "row %zu is not whole; expected %zu columns",
                        t->row_count + 1, t->column_count);
}

/* Take the value of an answer. */
static graze_status take_answer(const typed_table *t, typed_column *c, field *rows) {
    field one;
    if (c->kind == TYPED_DOUBLE)
        return take_bytes(&c->number[t->row_count], rows, sizeof *c->number) ? GRAZE_OK
                                                                             : not_whole(t);
    if (c->kind == TYPED_WORD) {
        if (!take_text(&one, rows))
            return not_whole(t);
        c->widest = one.length > c->widest ? one.length : c->widest;
        return add_text(t, c, t->row_count, one);
    }
    uint32_t *code = &c->code[t->row_count];
    if (!take_bytes(code, rows, sizeof *code))
        return not_whole(t);
    const char *name = typed_word(c, *code);
    size_t length = name ? strlen(name) : 0;
    c->widest = length > c->widest ? length : c->widest;
    return GRAZE_OK;
}

/* The further columns. */
static graze_status take_further(typed_table *t, field *rows) {
    field rest, one;
    size_t end = t->column_count - t->last;
    if (t->own == end)
        return GRAZE_OK;
    int whole = take_text(&rest, rows);
    for (size_t k = t->own; k < end; k++) {
        if (!whole || !rest.start || !field_take(&one, &rest))
            return not_whole(t);
        one = field_content(one);
        typed_column *c = &t->column[k];
        c->widest = one.length > c->widest ? one.length : c->widest;
        graze_status status = add_further(t, c, one);
        if (status)
            return context_at(t->context, status, "row %zu, column %.*s", t->row_count + 1,
                              FIELD_SHOWN(c->name));
    }
    return rest.start ? not_whole(t) : GRAZE_OK;
}

graze_status typed_add(typed_table *t, const char *rows, size_t length) {
    graze_rounding rounding = t->context->rounding;
    graze_status status = GRAZE_OK;
    field rest = {rows, length};
    t->context->rounding = GRAZE_ROUND_NONE;
    while (rest.length && !status) {
        if (!typed_reserve(t))
            status = typed_no_memory(t);
        for (size_t k = 0; k < t->own && !status; k++)
            status = take_answer(t, &t->column[k], &rest);
        if (!status)
            status = take_further(t, &rest);
        for (size_t k = t->column_count - t->last; k < t->column_count && !status; k++)
            status = take_answer(t, &t->column[k], &rest);
        t->row_count += !status;
    }
    t->context->rounding = rounding;
    return status;
}
