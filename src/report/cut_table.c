/* Cuts a finished table into columns and says what each holds.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "report/cut_notes.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "number/rational.h"
#include "number/rounding.h"

/* Take the next line from the front of a text. */
static field take_line(field *rest) {
    const char *end = memchr(rest->start, '\n', rest->length);
    size_t length = end ? (size_t)(end - rest->start) : rest->length;
    field line = {rest->start, length};
    length += end != NULL;
    *rest = (field){rest->start + length, rest->length - length};
    return line;
}

static int is(field s, const char *text) {
    return s.length == strlen(text) && memcmp(s.start, text, s.length) == 0;
}

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
        if (is(name, known[k].name))
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
static size_t own_columns(field line, int dimension) {
    const char *axes = dimension == 2 ? "x,y," : "x,y,z,";
    if (begins(line, axes, "pmc,class,definition,case,i,t,word"))
        return (size_t)dimension + 7;
    return begins(line, axes, "pmc,word") ? (size_t)dimension + 2 : 0;
}

/* The columns up to `word` are Graze's; what the points bring may have any name. */
static graze_status name_columns(cut_table *c, graze_context *context, field line) {
    size_t count = 1;
    for (size_t k = 0; k < line.length; k++)
        count += line.start[k] == ',';
    c->own = own_columns(line, c->dimension);
    if (!c->own)
        return cut_broken(context, "the column line `%.*s` is not that of a table of dimension %d",
                          FIELD_SHOWN(line), c->dimension);
    c->column = calloc(count, sizeof *c->column);
    if (!c->column)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a table");
    while (line.start) {
        column *to = &c->column[c->column_count];
        if (!field_take(&to->name, &line))
            return cut_broken(context, "a quote in the column line is not closed");
        to->name = field_content(to->name);
        to->kind = c->column_count < c->own ? kind_of(to->name) : COLUMN_NUMBER;
        c->column_count++;
    }
    return GRAZE_OK;
}

/* GRAZE_OK if the field is a number, GRAZE_EINPUT if it is none. */
static graze_status check_number(graze_context *context, field field) {
    fmpq_t value;
    fmpq_init(value);
    graze_status status = rational_parse(value, context, field.start, field.length);
    fmpq_clear(value);
    return status;
}

/* 1 ... for a name that stands for a number, 0 if there is no such name. */
static unsigned long code_of(column_kind kind, field field) {
    for (int k = 1; k <= 3 && kind == COLUMN_PMC; k++)
        if (is(field, graze_pmc_name((graze_pmc)k)))
            return (unsigned long)k;
    for (int k = 1; k <= 5 && kind == COLUMN_CLASS; k++)
        if (is(field, graze_class_name((graze_class)k)))
            return (unsigned long)k;
    return 0;
}

static int is_word(field field) {
    for (size_t k = 0; k < field.length; k++)
        if (!memchr("IBO", field.start[k], 3))
            return 0;
    return field.length > 0;
}

/* What is right where a field of Graze's own is wrong, else NULL. */
static const char *expected(const column *of, field field) {
    unsigned long n;
    switch (of->kind) {
    case COLUMN_PMC:
        return code_of(of->kind, field) ? NULL : "in, on or out";
    case COLUMN_CLASS:
        return code_of(of->kind, field) ? NULL : "the name of a class";
    case COLUMN_DEFINITION:
        return is(field, "ext") || (field_count(&n, field, 11) && n >= 5) ? NULL : "ext or 5 to 11";
    case COLUMN_WORD:
        return is_word(field) ? NULL : "letters I, B, O";
    case COLUMN_COUNT:
        return field_count(&n, field, is(of->name, "case") ? 9 : INT32_MAX)
                   ? NULL
                   : "a whole number, of a case up to 9, else below 2^31";
    default:
        return NULL;
    }
}

static graze_status check_field(column *of, graze_context *context, field field) {
    graze_status status = GRAZE_OK;
    const char *right = expected(of, field);
    if (right)
        return context_fail(context, GRAZE_EINPUT, "'%.*s'; expected %s", FIELD_SHOWN(field),
                            right);
    if (of->kind == COLUMN_COORDINATE || of->kind == COLUMN_NUMBER)
        status = check_number(context, field);
    if (of->kind == COLUMN_NUMBER && status == GRAZE_EINPUT) {
        of->kind = COLUMN_TEXT;
        status = GRAZE_OK;
    }
    if (field.length > of->widest)
        of->widest = field.length;
    return status;
}

static graze_status check_row(cut_table *c, graze_context *context, field row) {
    size_t k = 0;
    for (; k < c->column_count && row.start; k++) {
        field one;
        if (!field_take(&one, &row))
            return cut_broken(context, "row %zu: a quoted field does not end", c->row_count + 1);
        graze_status status = check_field(&c->column[k], context, field_content(one));
        if (status)
            return context_at(context, status, "row %zu, column %.*s", c->row_count + 1,
                              FIELD_SHOWN(c->column[k].name));
    }
    if (k < c->column_count || row.start)
        return cut_broken(context, "row %zu has %s than the %zu fields of the column line",
                          c->row_count + 1, row.start ? "more" : "fewer", c->column_count);
    return GRAZE_OK;
}

/* The last line of all, and what it says is so. */
static graze_status end_rows(const cut_table *c, graze_context *context, field value, field rest) {
    unsigned long count;
    if (rest.length)
        return cut_broken(context, "something stands after # complete");
    if (!field_count(&count, value, ~0ul) || count != c->row_count)
        return cut_broken(context, "the table has another number of rows than it says");
    if (!cut_grid_has(c, c->row_count))
        return cut_broken(context, "the table has another number of rows than its grid");
    return GRAZE_OK;
}

/* Rows until the line that says how many there were. */
static graze_status read_rows(cut_table *c, graze_context *context, field rest, size_t lines) {
    c->row = calloc(lines + 1, sizeof *c->row);
    if (!c->row)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a table");
    while (rest.length) {
        field line = take_line(&rest), value;
        if (cut_value(&value, line, "# complete "))
            return end_rows(c, context, value, rest);
        if (line.length && *line.start == '#')
            return cut_broken(context, "`%.*s` stands behind the column line", FIELD_SHOWN(line));
        graze_status status = check_row(c, context, line);
        if (status)
            return status;
        c->row[c->row_count++] = line;
    }
    return cut_broken(context, "the table has no line # complete");
}

graze_status cut_table_read(cut_table *out, graze_context *context, const char *table,
                            size_t length) {
    memset(out, 0, sizeof *out);
    for (int k = 0; k < 3; k++) {
        fmpq_init(out->low + k);
        fmpq_init(out->high + k);
    }
    field rest = {table, length}, line = {table, 0};
    size_t lines = 0;
    graze_status status = GRAZE_OK;
    if (length && memchr(table, '\0', length))
        return cut_broken(context, "a byte 0 in the table");
    for (size_t k = 0; k < length; k++)
        lines += table[k] == '\n';
    while (rest.length && !status) {
        line = take_line(&rest);
        if (!line.length || *line.start != '#')
            break;
        status = cut_note(out, context, line);
    }
    if (!status)
        status = cut_notes_end(out, context);
    if (!status)
        status = name_columns(out, context, line);
    return status ? status : read_rows(out, context, rest, lines);
}

void cut_table_clear(cut_table *c) {
    for (int k = 0; k < 3; k++) {
        fmpq_clear(c->low + k);
        fmpq_clear(c->high + k);
    }
    free(c->column);
    free(c->row);
}

field cut_table_field(const cut_table *c, size_t row, size_t index) {
    field one, rest = c->row[row];
    do
        (void)field_take(&one, &rest);
    while (index--);
    return field_content(one);
}

graze_status cut_table_number(double *out, graze_context *context, const cut_table *c, size_t row,
                              size_t index) {
    field one = cut_table_field(c, row, index);
    fmpq_t value;
    fmpq_init(value);
    graze_status status = rational_parse(value, context, one.start, one.length);
    if (status) {
        status = context_at(context, status, "row %zu, column %zu", row + 1, index + 1);
    } else {
        int negative = fmpq_sgn(value) < 0;
        if (rational_round(value, context, GRAZE_ROUND_BINARY64) == GRAZE_OK)
            *out = fmpq_get_d(value);
        else
            *out = negative ? -INFINITY : INFINITY;
    }
    fmpq_clear(value);
    return status;
}

unsigned long cut_table_code(column_kind kind, field field) {
    unsigned long count;
    if (kind == COLUMN_PMC || kind == COLUMN_CLASS)
        return code_of(kind, field);
    return field_count(&count, field, INT32_MAX) ? count : 0;
}
