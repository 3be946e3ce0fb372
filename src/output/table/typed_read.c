/* Reads a finished table into typed columns.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A further column is one of numbers until a field is none; its fields so far are kept as text
 * until then, and become texts.
 */
#include "output/table/typed_read.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "base/number/rational.h"
#include "base/number/rounding.h"
#include "output/table/typed_head.h"

static graze_status typed_no_memory(const typed_table *t) {
    return context_fail(t->context, GRAZE_ESYSTEM, "out of memory for a table");
}

/* ------------------------------------------------------------------------------- columns */

static column_kind kind_of(field name) {
    static const struct {
        const char *name;
        column_kind kind;
    } known[] = {{"x", COLUMN_COORDINATE}, {"y", COLUMN_COORDINATE},
                 {"z", COLUMN_COORDINATE}, {"pmc", COLUMN_PMC},
                 {"class", COLUMN_CLASS},  {"definition", COLUMN_DEFINITION},
                 {"case", COLUMN_COUNT},   {"i", COLUMN_COUNT},
                 {"t", COLUMN_COUNT},      {"word", COLUMN_WORD}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (field_is(name, known[k].name))
            return known[k].kind;
    return COLUMN_TEXT;
}

/* Does the column line begin with these names, and nothing behind them but further columns? */
static int begins(field line, const char *axes, const char *answers) {
    size_t n = strlen(axes), length = n + strlen(answers);
    return line.length >= length && memcmp(line.start, axes, n) == 0 &&
           memcmp(line.start + n, answers, length - n) == 0 &&
           (line.length == length || line.start[length] == ',');
}

/* How many columns of the line are Graze's, 0 if they are not as it writes them. */
static size_t own_columns(field line, int dimension, int pmc_alone) {
    const char *axes = dimension == 2 ? "x,y," : "x,y,z,";
    if (pmc_alone)
        return begins(line, axes, "pmc") ? (size_t)dimension + 1 : 0;
    if (begins(line, axes, "pmc,class,definition,case,i,t,word"))
        return (size_t)dimension + 7;
    return begins(line, axes, "pmc,word") ? (size_t)dimension + 2 : 0;
}

/* The columns up to `word`, or to `pmc` alone, are Graze's; further ones may have any name. */
static graze_status name_columns(typed_table *t, field line) {
    fields names = {NULL, 0, 0};
    t->own = own_columns(line, t->dimension, t->pmc_alone);
    if (!t->own)
        return typed_broken(t->context,
                            "the column line `%.*s` is not that of a table of dimension %d",
                            FIELD_SHOWN(line), t->dimension);
    text_bytes(&t->names, line.start, line.length);
    if (t->names.failed)
        return typed_no_memory(t);
    fields_result result = fields_cut(&names, (field){t->names.data, t->names.length});
    if (result == FIELDS_CUT)
        t->column = calloc(names.count, sizeof *t->column);
    for (size_t k = 0; t->column && k < names.count; k++) {
        t->column[k].name = field_content(names.item[k]);
        t->column[k].kind = k < t->own ? kind_of(t->column[k].name) : COLUMN_NUMBER;
    }
    t->column_count = t->column ? names.count : 0;
    fields_clear(&names);
    t->state = TYPED_ROWS;
    if (result == FIELDS_OPEN_QUOTE)
        return typed_broken(t->context, "a quote in the column line is not closed");
    return t->column ? GRAZE_OK : typed_no_memory(t);
}

static int is_number(const typed_column *c) {
    return c->kind == COLUMN_COORDINATE || c->kind == COLUMN_NUMBER;
}

/* Room for one more value; 0 where there is none. */
static int column_reserve(typed_column *c, size_t rows) {
    return is_number(c) ? array_reserve(&c->number, &c->capacity, rows + 1, sizeof *c->number)
                        : array_reserve(&c->code, &c->capacity, rows + 1, sizeof *c->code);
}

static int typed_reserve(typed_table *t) {
    int done = 1;
    for (size_t k = 0; k < t->column_count && done; k++)
        done = column_reserve(&t->column[k], t->row_count);
    return done;
}

/* -------------------------------------------------------------------------------- fields */

/* *number: the field is a number, whether or not a double can hold it. */
static graze_status read_number(double *out, int *number, graze_context *context, field f) {
    fmpq_t value;
    fmpq_init(value);
    graze_status status = rational_parse(value, context, f.start, f.length);
    *number = status == GRAZE_OK;
    if (!status)
        status = rational_nearest(out, context, value);
    if (*number && status == GRAZE_EINPUT)
        status = context_fail(context, status, "'%.*s'; expected a number that binary64 can hold",
                              FIELD_SHOWN(f));
    fmpq_clear(value);
    return status;
}

static int is_word(field f) {
    for (size_t k = 0; k < f.length; k++)
        if (!memchr("IBO", f.start[k], 3))
            return 0;
    return f.length > 0;
}

/* The number of a name of graze.h; 0 if it is none. */
static unsigned long name_code(const typed_column *c, field f) {
    for (int k = 1; k <= 3 && c->kind == COLUMN_PMC; k++)
        if (field_is(f, graze_pmc_name((graze_pmc)k)))
            return (unsigned long)k;
    for (int k = 1; k <= 5 && c->kind == COLUMN_CLASS; k++)
        if (field_is(f, graze_class_name((graze_class)k)))
            return (unsigned long)k;
    return 0;
}

/* The value of a field of an answer, or what is expected where it is wrong, else NULL. */
static const char *read_answer(unsigned long *out, const typed_column *c, field f) {
    *out = 0;
    switch (c->kind) {
    case COLUMN_PMC:
        *out = name_code(c, f);
        return *out ? NULL : "in, on or out";
    case COLUMN_CLASS:
        *out = name_code(c, f);
        return *out ? NULL : "the name of a class";
    case COLUMN_DEFINITION:
        return field_is(f, "ext") || (field_count(out, f, 11) && *out >= 5) ? NULL
                                                                            : "ext or 5 to 11";
    case COLUMN_COUNT:
        return field_count(out, f, field_is(c->name, "case") ? 9 : INT32_MAX)
                   ? NULL
                   : "a whole number, of a case up to 9, else below 2^31";
    default:
        return is_word(f) ? NULL : "letters I, B, O";
    }
}

static graze_status add_text(const typed_table *t, typed_column *c, size_t row, field f) {
    return texts_number(&c->code[row], &c->texts, f) ? GRAZE_OK : typed_no_memory(t);
}

/* A further column that has met a field that is no number: its fields become texts. */
static graze_status become_texts(const typed_table *t, typed_column *c) {
    graze_status status = GRAZE_OK;
    c->kind = COLUMN_TEXT;
    c->capacity = 0;
    if (!column_reserve(c, t->row_count))
        return typed_no_memory(t);
    field rest = {c->fields.data, c->fields.length}, one;
    for (size_t row = 0; row < t->row_count && !status; row++) {
        one = field_line(&rest);
        status = add_text(t, c, row, one);
    }
    free(c->number);
    c->number = NULL;
    text_clear(&c->fields);
    return status;
}

/* A field of a further column. */
static graze_status add_further(const typed_table *t, typed_column *c, field f) {
    if (c->kind == COLUMN_NUMBER) {
        int number;
        graze_status status = read_number(&c->number[t->row_count], &number, t->context, f);
        if (!status) {
            text_bytes(&c->fields, f.start, f.length);
            text_put(&c->fields, "\n");
            return c->fields.failed ? typed_no_memory(t) : GRAZE_OK;
        }
        if (status == GRAZE_EINPUT && !number)
            status = become_texts(t, c);
        if (status)
            return status;
    }
    return add_text(t, c, t->row_count, f);
}

static graze_status add_field(const typed_table *t, size_t index, field f) {
    typed_column *c = &t->column[index];
    unsigned long code;
    int number;
    if (f.length > c->widest)
        c->widest = f.length;
    if (c->kind == COLUMN_COORDINATE)
        return read_number(&c->number[t->row_count], &number, t->context, f);
    if (index >= t->own)
        return add_further(t, c, f);
    const char *expected = read_answer(&code, c, f);
    if (expected)
        return context_fail(t->context, GRAZE_EINPUT, "'%.*s'; expected %s", FIELD_SHOWN(f),
                            expected);
    if (c->kind == COLUMN_WORD)
        return add_text(t, c, t->row_count, f);
    c->code[t->row_count] = (uint32_t)code;
    return GRAZE_OK;
}

/* ---------------------------------------------------------------------------------- rows */

static graze_status add_row(typed_table *t, field row) {
    size_t k = 0;
    if (!typed_reserve(t))
        return typed_no_memory(t);
    for (; k < t->column_count && row.start; k++) {
        field one;
        if (!field_take(&one, &row))
            return typed_broken(t->context, "row %zu: a quoted field does not end",
                                t->row_count + 1);
        graze_status status = add_field(t, k, field_content(one));
        if (status)
            return context_at(t->context, status, "row %zu, column %.*s", t->row_count + 1,
                              FIELD_SHOWN(t->column[k].name));
    }
    if (k < t->column_count || row.start)
        return typed_broken(t->context, "row %zu has %s than the %zu fields of the column line",
                            t->row_count + 1, row.start ? "more" : "fewer", t->column_count);
    t->row_count++;
    return GRAZE_OK;
}

/* The last line, `# complete N`. */
static graze_status end_rows(typed_table *t, field value) {
    unsigned long count;
    if (!field_count(&count, value, ~0ul) || count != t->row_count)
        return typed_broken(t->context, "the table has another number of rows than it says");
    if (!typed_grid_fits(t))
        return typed_broken(t->context, "the table has another number of rows than its grid");
    t->state = TYPED_WHOLE;
    return GRAZE_OK;
}

static graze_status add_line(typed_table *t, field line) {
    int note = line.length && *line.start == '#';
    field value;
    if (t->state == TYPED_WHOLE)
        return typed_broken(t->context, "something stands after # complete");
    if (t->state == TYPED_ROWS && field_behind(&value, line, "# complete "))
        return end_rows(t, value);
    if (t->state == TYPED_ROWS && field_behind(&value, line, "# undecided "))
        return GRAZE_OK;
    if (t->state == TYPED_ROWS)
        return note ? typed_broken(t->context, "`%.*s` stands behind the column line",
                                   FIELD_SHOWN(line))
                    : add_row(t, line);
    if (note)
        return typed_head_line(t, line);
    graze_status status = typed_head_end(t);
    return status ? status : name_columns(t, line);
}

graze_status typed_add(typed_table *t, const char *lines, size_t length) {
    graze_rounding rounding = t->context->rounding;
    graze_status status = GRAZE_OK;
    field rest = {lines, length};
    if (length && memchr(lines, '\0', length))
        return typed_broken(t->context, "a byte 0 in the table");
    t->context->rounding = GRAZE_ROUND_NONE;
    while (rest.length && !status)
        status = add_line(t, field_line(&rest));
    t->context->rounding = rounding;
    return status;
}

graze_status typed_end(const typed_table *t) {
    if (t->state == TYPED_WHOLE)
        return GRAZE_OK;
    graze_status status = t->state == TYPED_HEAD ? typed_head_end(t) : GRAZE_OK;
    if (status)
        return status;
    return typed_broken(t->context, "the table has no %s",
                        t->state == TYPED_ROWS ? "line # complete" : "column line");
}
