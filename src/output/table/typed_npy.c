/* Tables as structured numpy arrays, in the format of numpy.save.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Coordinates and further numbers are float64, texts are bytes; definition is 0 for ext.
 */
#include "output/table/table.h"

#include "base/context/scope.h"

/* Little-endian. */
static void put_number(sink to, uint64_t value, size_t count) {
    char bytes[8];
    for (size_t k = 0; k < count; k++)
        bytes[k] = (char)(value >> 8 * k);
    to.put(to.to, bytes, count);
}

static void put_double(sink to, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_number(to, bits, 8);
}

/* Bytes of a text column; at least 1, since numpy has no texts of 0 bytes. */
static size_t width_of(const typed_column *c) {
    return c->widest ? c->widest : 1;
}

/* Append a column's name as Python writes it between quotes. */
static void put_name(text *out, const typed_table *t, size_t index) {
    HELD(text, name);
    typed_name(&name, t, index);
    for (size_t k = 0; k < name.length; k++) {
        if (name.data[k] == '\'' || name.data[k] == '\\')
            text_put(out, "\\");
        text_bytes(out, name.data + k, 1);
    }
    out->failed |= name.failed;
}

/* Append the dictionary that describes the array. */
static void put_description(text *out, const typed_table *t) {
    text_put(out, "{'descr': [");
    for (size_t k = 0; k < t->column_count; k++) {
        const typed_column *from = &t->column[k];
        text_put(out, k ? ", ('" : "('");
        put_name(out, t, k);
        if (from->kind == TYPED_DOUBLE || from->kind == TYPED_NUMBER)
            text_put(out, "', '<f8')");
        else if (from->kind == TYPED_DEFINITION || from->kind == TYPED_COUNT)
            text_put(out, "', '<u4')");
        else
            text_format(out, "', '|S%zu')", width_of(from));
    }
    text_format(out, "], 'fortran_order': False, 'shape': (%zu,), }", t->row_count);
}

/* Write the head in version 3 of the format, with a length of four bytes and UTF-8; it is padded to
 * a multiple of 64 bytes. */
static graze_status put_head(sink to, const typed_table *t) {
    HELD(text, description);
    put_description(&description, t);
    while (!description.failed && (12 + description.length + 1) % 64)
        text_put(&description, " ");
    text_put(&description, "\n");
    if (description.failed)
        return context_fail(t->context, GRAZE_ESYSTEM, "out of memory");
    to.put(to.to, "\x93NUMPY\x03\x00", 8);
    put_number(to, description.length, 4);
    to.put(to.to, description.data, description.length);
    return GRAZE_OK;
}

static void put_npy_text(sink to, field one, size_t width) {
    static const char zeros[64];
    to.put(to.to, one.start, one.length);
    for (size_t left = width - one.length; left;) {
        size_t part = left < sizeof zeros ? left : sizeof zeros;
        to.put(to.to, zeros, part);
        left -= part;
    }
}

static void put_field(sink to, const typed_column *c, size_t row) {
    const char *name = c->number ? NULL : typed_word(c, c->code[row]);
    if (c->number)
        put_double(to, c->number[row]);
    else if (c->kind == TYPED_DEFINITION || c->kind == TYPED_COUNT)
        put_number(to, c->code[row], 4);
    else
        put_npy_text(to, name ? (field){name, strlen(name)} : texts_at(&c->texts, c->code[row]),
                     width_of(c));
}

static graze_status typed_write_npy(const typed_table *t, sink to) {
    TRY(put_head(to, t));
    for (size_t row = 0; row < t->row_count; row++)
        for (size_t k = 0; k < t->column_count; k++)
            put_field(to, &t->column[k], row);
    return GRAZE_OK;
}

graze_status typed_write(const typed_table *t, graze_format form, sink to) {
    return form == GRAZE_FORMAT_VTK ? typed_write_vtk(t, to) : typed_write_npy(t, to);
}
