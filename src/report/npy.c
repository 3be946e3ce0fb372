/* Tables as structured numpy arrays, in the format of numpy.save.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Coordinates and further numbers are float64, the nearest to the exact ones; texts are bytes;
 * definition is 0 for ext.
 */
#include <stdint.h>
#include <string.h>
#include "report/cut_table.h"

/* Little-endian. */
static void put_bytes(text *t, uint64_t value, int count) {
    for (int k = 0; k < count; k++) {
        char byte = (char)(value >> 8 * k);
        text_bytes(t, &byte, 1);
    }
}

static void put_double(text *t, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_bytes(t, bits, 8);
}

static int is_text(column_kind kind) {
    return kind == COLUMN_PMC || kind == COLUMN_CLASS || kind == COLUMN_WORD || kind == COLUMN_TEXT;
}

static int is_number(column_kind kind) {
    return kind == COLUMN_COORDINATE || kind == COLUMN_NUMBER;
}

/* numpy has no text of no bytes. */
static size_t width_of(const column *c) {
    return c->widest ? c->widest : 1;
}

static int same_name(const field *a, const field *b) {
    return a->length == b->length && memcmp(a->start, b->start, a->length) == 0;
}

/* A name as Python writes it between quotes. Names that occurred are told apart by `_2`. */
static void put_name(text *t, const cut_table *c, size_t index) {
    const field *name = &c->column[index].name;
    size_t same = 1;
    for (size_t k = 0; k < name->length; k++) {
        if (name->start[k] == '\'' || name->start[k] == '\\')
            text_put(t, "\\");
        text_bytes(t, name->start + k, 1);
    }
    if (!name->length)
        text_put(t, "column");
    for (size_t k = 0; k < index; k++)
        same += same_name(&c->column[k].name, name);
    if (same > 1)
        text_format(t, "_%zu", same);
}

/* The dictionary that describes the array. */
static void put_description(text *t, const cut_table *c) {
    text_put(t, "{'descr': [");
    for (size_t k = 0; k < c->column_count; k++) {
        const column *from = &c->column[k];
        text_put(t, k ? ", ('" : "('");
        put_name(t, c, k);
        if (is_number(from->kind))
            text_put(t, "', '<f8')");
        else if (is_text(from->kind))
            text_format(t, "', '|S%zu')", width_of(from));
        else
            text_put(t, "', '<u4')");
    }
    text_format(t, "], 'fortran_order': False, 'shape': (%zu,), }", c->row_count);
}

/* Version 3 has a length of four bytes and UTF-8; head and description fill whole 64 bytes. */
static void put_head(text *t, const cut_table *c) {
    text description;
    text_init(&description);
    put_description(&description, c);
    while (!description.failed && (12 + description.length + 1) % 64)
        text_put(&description, " ");
    text_put(&description, "\n");
    t->failed |= description.failed;
    text_bytes(t, "\x93NUMPY\x03\x00", 8);
    put_bytes(t, description.length, 4);
    if (!description.failed)
        text_bytes(t, description.data, description.length);
    text_clear(&description);
}

static graze_status put_field(text *out, graze_context *context, const cut_table *c, size_t row,
                              size_t index) {
    const column *to = &c->column[index];
    field field = cut_table_field(c, row, index);
    double number;
    if (is_number(to->kind)) {
        graze_status status = cut_table_number(&number, context, c, row, index);
        if (!status)
            put_double(out, number);
        return status;
    }
    if (!is_text(to->kind)) {
        put_bytes(out, cut_table_code(to->kind, field), 4);
        return GRAZE_OK;
    }
    text_bytes(out, field.start, field.length);
    for (size_t pad = field.length; pad < width_of(to); pad++)
        text_bytes(out, "", 1);
    return GRAZE_OK;
}

graze_status export_npy(text *out, graze_context *context, const cut_table *c) {
    graze_status status = GRAZE_OK;
    put_head(out, c);
    for (size_t r = 0; r < c->row_count; r++)
        for (size_t k = 0; k < c->column_count && !status; k++)
            status = put_field(out, context, c, r, k);
    return status;
}
