/* Reads the `#` lines, the column line and the rows of a table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/counts.h"

#include <stdio.h>
#include "base/context/array.h"
#include "base/context/file.h"
#include "base/context/scope.h"
#include "base/context/spelling.h"
#include "base/number/rational.h"

static const char *const column_names[COLUMN_OPTIONS] = {
    "x",           "y",     "z",          "id",      "stratum", "order", "k",
    "pmc",         "class", "definition", "case",    "i",       "t",     "cell",
    "time",        "bx",    "by",         "bz",      "role",    "theta", "contact_order",
    "orientation", "left",  "right",      "trimmed", "status",  "near",  "near_in",
    "word",        "shift", "sdf"};

const char *const note_names[NOTE_COUNT] = {
    "graze",     "dimension", "solid-sha256", "motion-sha256", "scene-sha256", "at-rest",
    "operation", "folds",     "round",        "triangulate",   "columns",      "diagonal"};

const char *column_name(column c) {
    return c < COLUMN_OPTIONS ? column_names[c] : columns_known(c - COLUMN_OPTIONS).name;
}

column column_of(const char *option) {
    return (column)(COLUMN_OPTIONS + columns_place(option));
}

field table_field(const table *t, const table_row *row, column c) {
    return t->where[c] < 0 ? (field){"", 0} : field_content(row->cut.item[t->where[c]]);
}

graze_status table_rational(fmpq_t out, const table *t, const table_row *row, column c) {
    graze_context *context = t->in.context;
    field f = table_field(t, row, c);
    graze_status status = rational_parse(out, context, f.start, f.length);
    context_item(context, status, NULL, 0, column_name(c));
    return context_in(context, status, t->in.name, row->line);
}

graze_status table_number(fmpq_t out, graze_context *context, field f) {
    graze_rounding asked = context->rounding;
    context->rounding = GRAZE_ROUND_NONE;
    graze_status status = rational_parse(out, context, f.start, f.length);
    context->rounding = asked;
    return status;
}

digest digest_of(const char *bytes, size_t length) {
    unsigned char sha256[32];
    digest d;
    file_sha256(sha256, bytes, length);
    memcpy(&d.high, sha256, 8);
    memcpy(&d.low, sha256 + 8, 8);
    return d;
}

int digest_equal(digest a, digest b) {
    return a.high == b.high && a.low == b.low;
}

static graze_status read_complete(table *t, field value) {
    unsigned long count;
    if (!field_count(&count, value, ~0ul) || count != t->rows || t->complete)
        return table_fail(t, t->in.line,
                          "`# complete %.*s` stands after %lu rows; expected one such line, the "
                          "last, with their number",
                          FIELD_SHOWN(value), t->rows);
    t->complete = 1;
    return GRAZE_OK;
}

/* Take a `#` line. */
static graze_status read_note(table *t, field line) {
    field key, value;
    if (memchr(line.start, '\0', line.length))
        return table_fail(t, t->in.line, "a byte 0 in a text file");
    field_note(&key, &value, line);
    t->sets |= t->columns ? 0 : columns_of_line(line);
    if (field_is(key, "complete"))
        return read_complete(t, value);
    for (int n = 0; n < NOTE_COUNT; n++) {
        if (!field_is(key, note_names[n]) || t->notes[n] || t->columns)
            continue;
        t->notes[n] = strndup(value.start, value.length);
        return t->notes[n] ? GRAZE_OK : comparison_no_memory(t->in.context);
    }
    return GRAZE_OK;
}

/* Copy a line into a row and cut it into fields. */
static graze_status split(table *t, table_row *row, field line) {
    if (!array_reserve(&row->bytes, &row->capacity, line.length + 1, 1))
        return comparison_no_memory(t->in.context);
    memcpy(row->bytes, line.start, line.length);
    row->keyed = 0;
    row->line = t->in.line;
    return fields_read(&row->cut, t->in.context, t->in.name, t->in.line,
                       (field){row->bytes, line.length}, ',');
}

/* Read the next line that is neither blank nor a `#` line as a row. */
static graze_status next_table_line(table *t, table_row *row, int *more) {
    field line;
    *more = 0;
    for (;;) {
        TRY(stream_next(&t->in, &line));
        if (!line.start)
            return GRAZE_OK;
        if (line.length && *line.start == '#') {
            TRY(read_note(t, line));
        } else if (field_trimmed(line).length) {
            *more = 1;
            return split(t, row, line);
        }
    }
}

/* Does a comparison read the columns of this name: no columns of options that it does not know, and
 * of a table of Graze no further columns of the points? Those have names of answers in a table of
 * pmc alone, and names of columns of options that were not given. */
static int is_read(const table *t, int c) {
    const char *columns = t->notes[NOTE_COLUMNS];
    if (c >= COLUMN_OPTIONS) {
        known_column known = columns_known((size_t)(c - COLUMN_OPTIONS));
        return known.set && known.set->compared && (!t->notes[NOTE_GRAZE] || t->sets & known.bit);
    }
    int answer = (c > COLUMN_PMC && c <= COLUMN_T) || c == COLUMN_WORD;
    return !(answer && t->notes[NOTE_GRAZE] && columns && strcmp(columns, "pmc") == 0);
}

char *table_row_text(const table_row *row) {
    field last = row->cut.item[row->cut.count - 1];
    return strndup(row->bytes, (size_t)(last.start + last.length - row->bytes));
}

graze_status table_named_twice(const table *t, column c) {
    return table_fail(t, t->head, "the column line names %s twice; expected once", column_name(c));
}

void table_meant(char out[TABLE_MEANT], const table *t, const char *const *names, size_t count) {
    field rest = {t->names, strlen(t->names)}, one;
    *out = '\0';
    while (!*out && rest.start && field_take(&one, &rest)) {
        one = field_content(one);
        const char *meant = near_among(one.start, one.length, names, count);
        if (meant && !field_is(one, meant))
            snprintf(out, TABLE_MEANT, "; did you mean %s by '%.*s'?", meant, FIELD_SHOWN(one));
    }
}

/* Find the columns. In a table of Graze, whose further columns come last and may have any name, the
 * first column of a name counts. */
static graze_status fix_columns(table *t, const table_row *row) {
    t->head = row->line;
    for (size_t k = 0; k < row->cut.count; k++)
        for (int c = 0; c < COLUMN_COUNT; c++) {
            if (!is_read(t, c) ||
                !field_is(field_content(row->cut.item[k]), column_name((column)c)))
                continue;
            int twice = t->where[c] >= 0 && !t->notes[NOTE_GRAZE];
            if (twice && (c < COLUMN_TIME || c > COLUMN_SHIFT || c == COLUMN_WORD))
                return table_named_twice(t, (column)c);
            if (twice && t->doubled < 0)
                t->doubled = c;
            if (t->where[c] < 0)
                t->where[c] = (long)k;
        }
    t->columns = row->cut.count;
    if (t->where[COLUMN_X] >= 0 && t->where[COLUMN_Y] >= 0)
        t->dimension = t->where[COLUMN_Z] >= 0 ? 3 : 2;
    if (t->notes[NOTE_DIMENSION] && t->dimension == 3 && strcmp(t->notes[NOTE_DIMENSION], "2") == 0)
        t->dimension = 2;
    return GRAZE_OK;
}

graze_status table_open(table *out, graze_context *context, const char *path) {
    ZEROED(table_row, row);
    int more;
    memset(out, 0, sizeof *out);
    for (int c = 0; c < COLUMN_COUNT; c++)
        out->where[c] = -1;
    out->doubled = -1;
    TRY(stream_open(&out->in, context, path));
    TRY(next_table_line(out, &row, &more));
    if (!more)
        return table_fail(out, 0, "no column line; expected a line of names such as x,y,z,pmc");
    TRY(fix_columns(out, &row));
    out->names = table_row_text(&row);
    return out->names ? GRAZE_OK : comparison_no_memory(out->in.context);
}

void table_clear(table *t) {
    stream_close(&t->in);
    free(t->names);
    for (int n = 0; n < NOTE_COUNT; n++)
        free(t->notes[n]);
}

graze_status table_next(table *t, table_row *row, int *more) {
    TRY(next_table_line(t, row, more));
    if (!*more)
        return GRAZE_OK;
    if (t->complete)
        return table_fail(t, t->in.line, "a row after `# complete`; expected that line last");
    if (row->cut.count != t->columns)
        return table_fail(t, t->in.line, "%zu columns; expected %zu, as on the column line",
                          row->cut.count, t->columns);
    t->rows++;
    return GRAZE_OK;
}

void table_row_clear(table_row *row) {
    free(row->bytes);
    fields_clear(&row->cut);
    memset(row, 0, sizeof *row);
}
