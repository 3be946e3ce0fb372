/* Fixes the columns of a file of points and reads its rows (src/program/cli/formats.md, Points).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The first line is a header if it has a field x, y or (in E^3) z; else the first d columns are the
 * coordinates. Further columns are passed to the table unchanged.
 */
#include "program/points/heads.h"

#include "base/context/scope.h"
#include "output/report/columns.h"

/* 0, 1, 2 for x, y, z, or for X, Y, Z if `first` is 'X'; -1 for any other name. */
static int axis_of(field f, int dimension, char first) {
    f = field_content(f);
    if (f.length != 1 || *f.start < first || *f.start >= first + dimension)
        return -1;
    return *f.start - first;
}

/* 'x', or 'X' if only capital letters name coordinates. */
static char first_axis_name(const fields *first, int dimension) {
    int capitals = 0;
    for (size_t k = 0; k < first->count; k++) {
        if (axis_of(first->item[k], dimension, 'x') >= 0)
            return 'x';
        capitals |= axis_of(first->item[k], dimension, 'X') >= 0;
    }
    return capitals ? 'X' : 'x';
}

/* Is a column carried along: neither a coordinate nor an answer of graze classify? */
static int is_further(const columns *c, size_t column) {
    if (c->sites.wanted)
        return c->sites.carried[column];
    for (int k = 0; c->pairs.wanted && k < PAIR_COLUMNS; k++)
        if (c->pairs.where[k] == column)
            return 0;
    for (int k = 0; k < c->dimension; k++)
        if (c->where[k] == column)
            return 0;
    return !(column >= c->own.first && column < c->own.end) && column + c->own.last < c->count;
}

/* How many columns at the end, at most `most`, are answers that the `#` lines mention. */
static size_t count_last(const fields *first, unsigned sets, size_t most) {
    const column_label *names[COLUMNS_MOST];
    size_t count = 0;
    for (size_t k = columns_names(names, sets); k > 0 && count < most; k--) {
        int is_it =
            field_is(field_content(first->item[first->count - 1 - count]), names[k - 1]->name);
        if (!is_it && !names[k - 1]->mark)
            return 0;
        count += (size_t)is_it;
    }
    return count;
}

/* Find the answers in a file that graze classify has written: some of answer_columns, in their
 * order, behind the coordinates, and further answers in the last columns. */
static void find_own(columns *c, const fields *first, columns_head head) {
    size_t count = head.pmc_alone ? 1 : ANSWER_COLUMNS, k = 0;
    size_t at = c->own.first = c->own.end = (size_t)c->dimension;
    for (; head.graze && at < first->count; at++) {
        while (k < count && ((head.unsweep && !answer_columns[k].of_unsweep) ||
                             !field_is(field_content(first->item[at]), answer_columns[k].name)))
            k++;
        if (k++ >= count)
            break;
        c->own.end = at + 1;
    }
    c->own.last = head.graze ? count_last(first, head.sets, first->count - c->own.end) : 0;
}

static int order_of_names(const void *a, const void *b) {
    const field *x = a, *y = b;
    if (x->length != y->length)
        return x->length < y->length ? -1 : 1;
    return x->length ? memcmp(x->start, y->start, x->length) : 0;
}

/* Refuse two further columns with the same name; columns without a name are allowed. */
static int check_different_names(fault *f, const columns *c, const fields *first,
                                 unsigned long number) {
    FREED(field, names, malloc(first->count * sizeof *names));
    size_t count = 0, k = 1;
    if (!names)
        return fault_set(f, EXIT_IO, "out of memory");
    for (size_t column = 0; column < first->count; column++)
        if (is_further(c, column))
            names[count++] = field_content(first->item[column]);
    qsort(names, count, sizeof *names, order_of_names);
    while (k < count && (!names[k].length || !field_equal(names[k - 1], names[k])))
        k++;
    return k < count ? fault_set(f, EXIT_INPUT,
                                 "%s:%lu: two columns have the name '%.*s'; expected different "
                                 "names",
                                 c->name, number, FIELD_SHOWN(names[k]))
                     : EXIT_DONE;
}

/* Does a field from a file with another separator need quotes in a table with commas? */
static int needs_quotes(char separator, field one) {
    field bare = field_trimmed(one);
    if (separator == ' ')
        return memchr(one.start, ',', one.length) || memchr(one.start, '"', one.length);
    return separator == ';' && memchr(one.start, ',', one.length) && *bare.start != '"';
}

void put_quoted(text *out, field one) {
    text_put(out, "\"");
    for (size_t k = 0; k < one.length; k++) {
        text_put(out, one.start[k] == '"' ? "\"" : "");
        text_bytes(out, one.start + k, 1);
    }
    text_put(out, "\"");
}

void columns_put_field(text *out, const columns *c, field one) {
    if (one.length && needs_quotes(c->separator, one))
        put_quoted(out, one);
    else
        text_bytes(out, one.start, one.length);
}

/* Append the fields of a line that are carried along, comma-joined; if `numbered`, in place of each
 * `column` with its number, from 1. Returns how many they are. */
static size_t put_others(text *out, const columns *c, const fields *line, int numbered) {
    size_t count = 0;
    for (size_t k = 0; k < line->count; k++) {
        if (!is_further(c, k))
            continue;
        if (count++)
            text_bytes(out, ",", 1);
        if (numbered)
            text_format(out, "column%zu", k + 1);
        else
            columns_put_field(out, c, line->item[k]);
    }
    return count;
}

/* Set `others`, the names of the fields that are carried along. Without a header they are numbered.
 */
static int name_others(fault *f, columns *c, const fields *first, int numbered) {
    text names;
    text_init(&names);
    if (!put_others(&names, c, first, numbered))
        return EXIT_DONE;
    c->others = text_take(&names);
    return c->others ? EXIT_DONE : fault_set(f, EXIT_IO, "out of memory");
}

/* Fix the columns of points by the first line; *header is 1 if this line names the columns. */
static int fix_points(int *header, fault *f, columns *c, const fields *first, unsigned long number,
                      columns_head head) {
    int found[3] = {0, 0, 0};
    *header = 0;
    for (int k = 0; k < 3; k++)
        c->where[k] = (size_t)k;
    char letter = first_axis_name(first, c->dimension);
    for (size_t k = 0; k < first->count; k++) {
        int axis = axis_of(first->item[k], c->dimension, letter);
        if (axis < 0)
            continue;
        if (found[axis]++)
            return fault_set(f, EXIT_INPUT, "%s:%lu: the header names %c twice", c->name, number,
                             'x' + axis);
        c->where[axis] = k;
        *header = 1;
    }
    for (int k = 0; *header && k < c->dimension; k++)
        if (!found[k])
            return fault_set(f, EXIT_INPUT, "%s:%lu: the header names no column %c", c->name,
                             number, 'x' + k);
    if (first->count < (size_t)c->dimension)
        return fault_set(
            f, EXIT_INPUT, "%s:%lu: %zu columns; expected at least %d, or a header naming x, y%s",
            c->name, number, first->count, c->dimension, c->dimension == 3 ? ", z" : "");
    if (*header)
        find_own(c, first, head);
    return EXIT_DONE;
}

static int fix(int *header, fault *f, columns *c, const fields *first, unsigned long number,
               columns_head head) {
    c->count = first->count;
    *header = 1;
    int status = c->sites.wanted   ? site_columns_fix(f, c, first, number)
                 : c->pairs.wanted ? pair_columns_fix(f, c, first, number)
                                   : fix_points(header, f, c, first, number, head);
    if (!status && *header)
        status = check_different_names(f, c, first, number);
    if (!status)
        status = name_others(f, c, first, !*header);
    c->count = status ? 0 : first->count;
    return status;
}

int columns_fix(int *header, fault *f, columns *c, graze_context *context, field text,
                unsigned long number, columns_head head) {
    ZEROED(fields, first);
    if (npy_is_begun(text.start, text.length))
        return fault_set(f, EXIT_INPUT,
                         "%s: is a .npy file, which is no text and is read by its name; expected "
                         "a plain file",
                         c->name);
    c->separator = field_separator(text);
    TRY(fault_of(f, fields_read(&first, context, c->name, number, text, c->separator), context,
                 EXIT_INPUT));
    return fix(header, f, c, &first, number, head);
}

/* Append a name, to which `_in` is added until neither the table's own columns nor the others have
 * the name. */
static void put_free_name(text *out, const columns *c, field own, field others, field name) {
    field bare = field_content(name);
    if (!field_is_among(bare, own)) {
        text_bytes(out, name.start, name.length);
        return;
    }
    HELD(text, one);
    text_bytes(&one, bare.start, bare.length);
    do
        text_put(&one, "_in");
    while (!one.failed && (field_is_among((field){one.data, one.length}, own) ||
                           field_is_among((field){one.data, one.length}, others)));
    if (!one.failed)
        complain(EXIT_DONE,
                 "note: %s: the column `%.*s` is carried as `%s`, since the table has one of that "
                 "name",
                 c->name, FIELD_SHOWN(bare), one.data);
    out->failed |= one.failed;
    text_bytes(out, one.failed ? "" : one.data, one.length);
}

char *columns_free_names(const columns *c, field own) {
    text out;
    field others = {c->others, c->others ? strlen(c->others) : 0}, rest = others, name;
    if (!c->others)
        return NULL;
    text_init(&out);
    for (int some = 0; rest.start && field_take(&name, &rest); some = 1) {
        text_put(&out, some ? "," : "");
        put_free_name(&out, c, own, others, name);
    }
    return text_take(&out);
}

/* The end of a message, with a hint if a number has a semicolon. */
static const char *semicolon_hint(field token) {
    return memchr(token.start, ';', token.length)
               ? "; expected decimal points where fields stand between semicolons"
               : "";
}

/* Read the cell of a row. */
static int read_cell(fault *f, const columns *c, reader *r, unsigned long number) {
    field token = field_content(r->cut.item[c->sites.cell]);
    return cell_read(&r->cell, token)
               ? EXIT_DONE
               : fault_set(f, EXIT_INPUT, "%s:%lu: cell: `%.*s`; expected " CELL_FORM, c->name,
                           number, FIELD_SHOWN(token));
}

static int refuse_number(fault *f, const columns *c, int index, field token, unsigned long number,
                         const char *why, int status) {
    char axis[2] = {(char)('x' + index), '\0'};
    if (c->sites.wanted && index == 0 && site_time_is_root(token))
        return fault_set(f, status,
                         "%s:%lu: time: `%.*s` is a root; expected a rational time, as contact "
                         "points have",
                         c->name, number, FIELD_SHOWN(token));
    return fault_set(f, status, "%s:%lu: %s: %s%s", c->name, number,
                     c->sites.wanted ? site_number_name(&c->sites, index) : axis, why,
                     semicolon_hint(token));
}

int columns_row(mpq_t *point, fault *f, const columns *c, reader *r, const block *b, size_t index) {
    const line *l = &b->lines[index];
    field text = {b->bytes + l->start, l->length};
    graze_status cut = fields_read(&r->cut, r->context, c->name, l->number, text, c->separator);
    if (cut)
        return fault_of(f, cut, r->context, EXIT_INPUT);
    if (r->cut.count != c->count)
        return fault_set(f, EXIT_INPUT, "%s:%lu: %zu columns; expected %zu, as on the first line",
                         c->name, l->number, r->cut.count, c->count);
    for (int k = 0; k < c->numbers; k++) {
        field token = field_content(r->cut.item[c->where[k]]);
        graze_status read = graze_number_parse(point[k], r->context, token.start, token.length);
        if (read)
            return refuse_number(f, c, k, token, l->number, graze_context_message(r->context),
                                 exit_for(read, EXIT_INPUT));
    }
    if (c->sites.snap && read_cell(f, c, r, l->number))
        return f->status;
    if (c->others) {
        put_others(&r->rest, c, &r->cut, 0);
        text_bytes(&r->rest, "", 1);
    }
    return r->rest.failed ? fault_set(f, EXIT_IO, "out of memory") : EXIT_DONE;
}

void reader_clear(reader *r) {
    fields_clear(&r->cut);
    text_clear(&r->rest);
    *r = (reader){.context = NULL};
}

int columns_are_named(const columns *c) {
    return c->sites.wanted || c->pairs.wanted;
}

void columns_clear(columns *c) {
    free(c->others);
    free(c->sites.carried);
    c->others = c->sites.carried = NULL;
}
