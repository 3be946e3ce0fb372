/* Fixes the columns of a file of points and reads its rows (src/cli/formats.md, Points).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The first line is a header if it has a field x, y or (in E^3) z; else the first d columns are the
 * coordinates. Further columns are handed on as the bytes they were.
 */
#include "run/columns.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "context/array.h"

/* 0, 1, 2 for x, y, z; -1 for any other name. */
static int axis_of(field f, int dimension) {
    f = field_content(f);
    if (f.length != 1 || *f.start < 'x' || *f.start >= 'x' + dimension)
        return -1;
    return *f.start - 'x';
}

static int is_coordinate(const columns *c, size_t column) {
    for (int k = 0; k < c->dimension; k++)
        if (c->where[k] == column)
            return 1;
    return 0;
}

/* Names for the fields that are no coordinates, comma-joined; numbers where there is no header. */
static int name_others(fault *f, columns *c, const fields *first, int numbered) {
    size_t room = 1;
    if (first->count <= (size_t)c->dimension)
        return EXIT_DONE;
    for (size_t k = 0; k < first->count; k++)
        room += (numbered ? 28 : first->item[k].length) + 1;
    char *at = c->others = malloc(room);
    int some = 0;
    if (!at)
        return fault_set(f, EXIT_IO, "out of memory");
    for (size_t k = 0; k < first->count; k++) {
        if (is_coordinate(c, k))
            continue;
        if (some)
            *at++ = ',';
        some = 1;
        if (numbered) {
            at += sprintf(at, "column%zu", k + 1);
        } else {
            memcpy(at, first->item[k].start, first->item[k].length);
            at += first->item[k].length;
        }
    }
    *at = '\0';
    return EXIT_DONE;
}

/* Fix the columns by the first line; *header says whether it names them. */
static int fix(int *header, fault *f, columns *c, const fields *first, unsigned long number) {
    int found[3] = {0, 0, 0};
    *header = 0;
    for (int k = 0; k < 3; k++)
        c->where[k] = (size_t)k;
    for (size_t k = 0; k < first->count; k++) {
        int axis = axis_of(first->item[k], c->dimension);
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
    int status = name_others(f, c, first, !*header);
    if (!status)
        c->count = first->count;
    return status;
}

int columns_fix(int *header, fault *f, columns *c, graze_context *context, field text,
                unsigned long number) {
    fields first = {NULL, 0, 0};
    graze_status cut = fields_read(&first, context, c->name, number, text, ',');
    int status = fault_of(f, cut, context, EXIT_INPUT);
    if (!status)
        status = fix(header, f, c, &first, number);
    fields_clear(&first);
    return status;
}

/* Add the fields that are no coordinates to `rest` as they were. They are shorter than the line. */
static int keep_others(reader *r, const columns *c, size_t length) {
    if (!array_reserve(&r->rest, &r->rest_capacity, r->rest_length + length + 1, 1))
        return 0;
    char *at = r->rest + r->rest_length;
    int some = 0;
    for (size_t k = 0; k < r->cut.count; k++) {
        if (is_coordinate(c, k))
            continue;
        if (some)
            *at++ = ',';
        some = 1;
        memcpy(at, r->cut.item[k].start, r->cut.item[k].length);
        at += r->cut.item[k].length;
    }
    *at++ = '\0';
    r->rest_length = (size_t)(at - r->rest);
    return 1;
}

int columns_row(mpq_t *point, fault *f, const columns *c, reader *r, const block *b, size_t index) {
    const line *l = &b->lines[index];
    field text = {b->bytes + l->start, l->length};
    graze_status cut = fields_read(&r->cut, r->context, c->name, l->number, text, ',');
    if (cut)
        return fault_of(f, cut, r->context, EXIT_INPUT);
    if (r->cut.count != c->count)
        return fault_set(f, EXIT_INPUT, "%s:%lu: %zu columns; expected %zu, as on the first line",
                         c->name, l->number, r->cut.count, c->count);
    for (int k = 0; k < c->dimension; k++) {
        field token = field_content(r->cut.item[c->where[k]]);
        graze_status read = graze_number_parse(point[k], r->context, token.start, token.length);
        if (read)
            return fault_set(f, exit_for(read, EXIT_INPUT), "%s:%lu: %c: %s", c->name, l->number,
                             'x' + k, graze_context_message(r->context));
    }
    return c->others && !keep_others(r, c, l->length) ? fault_set(f, EXIT_IO, "out of memory")
                                                      : EXIT_DONE;
}

void reader_clear(reader *r) {
    fields_clear(&r->cut);
    free(r->rest);
    *r = (reader){NULL, {NULL, 0, 0}, NULL, 0, 0};
}

void columns_clear(columns *c) {
    free(c->others);
    c->others = NULL;
}
