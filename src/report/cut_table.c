/* Cuts a finished table into columns and says what each holds.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "report/cut_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "number/rational.h"
#include "number/rounding.h"

static token trimmed(token s) {
    while (s.length && (*s.start == ' ' || *s.start == '\t')) {
        s.start++;
        s.length--;
    }
    while (s.length && (s.start[s.length - 1] == ' ' || s.start[s.length - 1] == '\t'))
        s.length--;
    return s;
}

/* Take the next field from the front of a row; doubled quotes stay as they are. */
static token take_field(token *rest) {
    const char *at = rest->start, *end = at + rest->length;
    int quoted = 0;
    while (at < end && (quoted || *at != ','))
        quoted ^= *at++ == '"';
    token field = trimmed((token){rest->start, (size_t)(at - rest->start)});
    if (field.length >= 2 && *field.start == '"') {
        field.start++;
        field.length -= 2;
    }
    at += at < end;
    *rest = (token){at, (size_t)(end - at)};
    return field;
}

/* Take the next line from the front of a text. */
static token take_line(token *rest) {
    const char *end = memchr(rest->start, '\n', rest->length);
    size_t length = end ? (size_t)(end - rest->start) : rest->length;
    token line = {rest->start, length};
    length += end != NULL;
    *rest = (token){rest->start + length, rest->length - length};
    return line;
}

static int is(token s, const char *text) {
    return s.length == strlen(text) && memcmp(s.start, text, s.length) == 0;
}

/* What follows a key in a `#` line; 0 if the line has another. */
static int value_of(token *out, token line, const char *key) {
    size_t length = strlen(key);
    if (line.length <= length || memcmp(line.start, key, length) != 0)
        return 0;
    *out = (token){line.start + length, line.length - length};
    return 1;
}

static unsigned long count_of(token s) {
    unsigned long value = 0;
    for (size_t k = 0; k < s.length && s.start[k] >= '0' && s.start[k] <= '9'; k++)
        value = 10 * value + (unsigned long)(s.start[k] - '0');
    return value;
}

static graze_status broken(graze_context *context, const char *why) {
    return context_fail(context, GRAZE_EINPUT,
                        "%s; right is a whole table as graze classify writes it", why);
}

static graze_status read_note(cut_table *c, graze_context *context, token line) {
    token value;
    graze_status status = GRAZE_OK;
    if (value_of(&value, line, "# dimension "))
        c->dimension = (int)count_of(value);
    if (value_of(&value, line, "# grid "))
        for (int k = 0; k < 3; k++)
            c->grid[k] = value.length ? count_of(take_field(&value)) : 1;
    if (value_of(&value, line, "# box "))
        for (int k = 0; k < 2 * c->dimension && !status; k++) {
            token number = take_field(&value);
            fmpq *to = k < c->dimension ? c->low + k : c->high + (k - c->dimension);
            status = rational_parse(to, context, number.start, number.length);
        }
    return status;
}

static column_kind kind_of(token name) {
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

/* The columns up to `word` are Graze's; what the points bring may have any name. */
static graze_status name_columns(cut_table *c, graze_context *context, token line) {
    size_t count = 1;
    for (size_t k = 0; k < line.length; k++)
        count += line.start[k] == ',';
    c->column = calloc(count, sizeof *c->column);
    if (!c->column)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a table");
    do {
        column *to = &c->column[c->column_count++];
        to->name = take_field(&line);
        to->kind = c->own ? COLUMN_NUMBER : kind_of(to->name);
        if (!c->own && to->kind == COLUMN_WORD)
            c->own = c->column_count;
    } while (line.length);
    return c->own ? GRAZE_OK : broken(context, "the table has no column word");
}

static void look_at_row(cut_table *c, token row) {
    for (size_t k = 0; k < c->column_count; k++) {
        column *to = &c->column[k];
        token field = take_field(&row);
        if (field.length > to->widest)
            to->widest = field.length;
        if (to->kind == COLUMN_NUMBER && !rational_is_token(field.start, field.length))
            to->kind = COLUMN_TEXT;
    }
}

/* Rows until the line that says how many there were. */
static graze_status read_rows(cut_table *c, graze_context *context, token rest, size_t lines) {
    c->row = calloc(lines + 1, sizeof *c->row);
    if (!c->row)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a table");
    while (rest.length) {
        token line = take_line(&rest), count;
        if (value_of(&count, line, "# complete "))
            return count_of(count) == c->row_count
                       ? GRAZE_OK
                       : broken(context, "the table has another number of rows than it says");
        look_at_row(c, line);
        c->row[c->row_count++] = line;
    }
    return broken(context, "the table has no line # complete");
}

graze_status cut_table_read(cut_table *out, graze_context *context, const char *table,
                            size_t length) {
    memset(out, 0, sizeof *out);
    for (int k = 0; k < 3; k++) {
        fmpq_init(out->low + k);
        fmpq_init(out->high + k);
    }
    token rest = {table, length}, line = {table, 0};
    size_t lines = 0;
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < length; k++)
        lines += table[k] == '\n';
    while (rest.length && !status) {
        line = take_line(&rest);
        if (!line.length || *line.start != '#')
            break;
        status = read_note(out, context, line);
    }
    if (!status && (out->dimension < 2 || out->dimension > 3))
        status = broken(context, "the table does not say its dimension");
    if (!status)
        status = name_columns(out, context, line);
    if (!status)
        status = read_rows(out, context, rest, lines);
    if (!status && out->grid[0] && out->grid[0] * out->grid[1] * out->grid[2] != out->row_count)
        status = broken(context, "the table has another number of rows than its grid");
    return status;
}

void cut_table_clear(cut_table *c) {
    for (int k = 0; k < 3; k++) {
        fmpq_clear(c->low + k);
        fmpq_clear(c->high + k);
    }
    free(c->column);
    free(c->row);
}

token cut_table_field(const cut_table *c, size_t row, size_t index) {
    token rest = c->row[row], field = take_field(&rest);
    while (index--)
        field = take_field(&rest);
    return field;
}

graze_status cut_table_number(double *out, graze_context *context, const cut_table *c, size_t row,
                              size_t index) {
    token field = cut_table_field(c, row, index);
    fmpq_t value;
    fmpq_init(value);
    graze_status status = rational_parse(value, context, field.start, field.length);
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

unsigned long cut_table_code(column_kind kind, token field) {
    for (int k = 1; k <= 3 && kind == COLUMN_PMC; k++)
        if (is(field, graze_pmc_name((graze_pmc)k)))
            return (unsigned long)k;
    for (int k = 1; k <= 5 && kind == COLUMN_CLASS; k++)
        if (is(field, graze_class_name((graze_class)k)))
            return (unsigned long)k;
    return count_of(field);
}
