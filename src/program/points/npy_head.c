/* Reads the head of a .npy file: a literal of a Python dictionary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Each key must be there once, in any order. Everything else is refused.
 */
#include "program/points/heads.h"

#include <ctype.h>
#include <string.h>

enum { MAGIC = 6, VERSION = 2 };

int npy_is_begun(const char *bytes, size_t length) {
    return length >= MAGIC && memcmp(bytes, "\x93NUMPY", MAGIC) == 0;
}

static int no_head(fault *f, const char *name) {
    return fault_set(f, EXIT_INPUT,
                     "%s: the head of the .npy file is not understood; expected a dictionary with "
                     "descr, fortran_order and shape",
                     name);
}

static void skip_white(field *rest) {
    while (rest->length && isspace((unsigned char)*rest->start))
        rest->start++, rest->length--;
}

/* Take one byte, if it is the next one that is not blank. */
static int take_byte(field *rest, char wanted) {
    skip_white(rest);
    if (!rest->length || *rest->start != wanted)
        return 0;
    rest->start++, rest->length--;
    return 1;
}

/* Take a text in quotes of either kind. */
static int take_quoted(field *out, field *rest) {
    char quote = take_byte(rest, '\'') ? '\'' : take_byte(rest, '"') ? '"' : '\0';
    const char *end = quote ? memchr(rest->start, quote, rest->length) : NULL;
    if (!end)
        return 0;
    *out = (field){rest->start, (size_t)(end - rest->start)};
    *rest = (field){end + 1, rest->length - out->length - 1};
    return 1;
}

/* Take a value, up to the first byte that `ends` has, which stays in `rest`. */
static field take_until(field *rest, const char *ends) {
    skip_white(rest);
    field out = {rest->start, 0};
    while (out.length < rest->length && !strchr(ends, rest->start[out.length]))
        out.length++;
    *rest = (field){rest->start + out.length, rest->length - out.length};
    return field_trimmed(out);
}

static int take_type(npy_head *out, fault *f, const char *name, field *rest) {
    field type;
    if (take_byte(rest, '['))
        return fault_set(f, EXIT_INPUT, "%s: an array of records; expected one of numbers", name);
    if (!take_quoted(&type, rest))
        return no_head(f, name);
    out->size = type.length == 3 ? type.start[2] - '0' : 0;
    int wide = out->size == 4 || out->size == 8, narrow = out->size == 1 || out->size == 2;
    char kind = type.length > 1 ? type.start[1] : '\0';
    int known = (wide && kind == 'f') || ((wide || narrow) && (kind == 'i' || kind == 'u'));
    if (!known || !strchr(out->size == 1 ? "|<>" : "<>", *type.start))
        return fault_set(f, EXIT_INPUT,
                         "%s: numbers of type '%.*s'; expected floats of 4 or 8 bytes or integers "
                         "of up to 8, such as '<f8'",
                         name, FIELD_SHOWN(type));
    out->kind = kind;
    out->big_endian = *type.start == '>';
    return EXIT_DONE;
}

static int take_order(npy_head *out, fault *f, const char *name, field *rest) {
    field value = take_until(rest, ",}");
    out->column_after_column = field_is(value, "True");
    return out->column_after_column || field_is(value, "False") ? EXIT_DONE : no_head(f, name);
}

static int take_shape(npy_head *out, fault *f, const char *name, field *rest, int dimension) {
    unsigned long columns = 0;
    if (!take_byte(rest, '('))
        return no_head(f, name);
    field shape = take_until(rest, ")"), left = shape;
    if (!take_byte(rest, ')'))
        return no_head(f, name);
    int two = field_count(&out->rows, take_until(&left, ","), ~0ul) && take_byte(&left, ',') &&
              field_count(&columns, take_until(&left, ","), ~0ul);
    (void)take_byte(&left, ',');
    if (!two || left.length || columns != (unsigned long)dimension)
        return fault_set(f, EXIT_INPUT, "%s: an array of shape (%.*s); expected (n, %d)", name,
                         FIELD_SHOWN(shape), dimension);
    return EXIT_DONE;
}

/* Take one key and its value; `seen` has a bit for each key. */
static int take_key(npy_head *out, fault *f, const char *name, field *rest, int dimension,
                    unsigned *seen) {
    static const char *const keys[] = {"descr", "fortran_order", "shape"};
    field key;
    unsigned k = 0;
    if (!take_quoted(&key, rest) || !take_byte(rest, ':'))
        return no_head(f, name);
    while (k < 3 && !field_is(key, keys[k]))
        k++;
    if (k == 3 || *seen >> k & 1)
        return no_head(f, name);
    *seen |= 1u << k;
    return k == 0   ? take_type(out, f, name, rest)
           : k == 1 ? take_order(out, f, name, rest)
                    : take_shape(out, f, name, rest, dimension);
}

static int read_dictionary(npy_head *out, fault *f, const char *name, field rest, int dimension) {
    unsigned seen = 0;
    int status = take_byte(&rest, '{') ? EXIT_DONE : no_head(f, name);
    while (!status && !take_byte(&rest, '}')) {
        status = take_key(out, f, name, &rest, dimension, &seen);
        skip_white(&rest);
        if (!status && !take_byte(&rest, ',') && (!rest.length || *rest.start != '}'))
            status = no_head(f, name);
    }
    skip_white(&rest);
    return !status && (seen != 7 || rest.length) ? no_head(f, name) : status;
}

int npy_head_read(npy_head *out, fault *f, const char *name, const char *bytes, size_t length,
                  int dimension) {
    const unsigned char *at = (const unsigned char *)bytes;
    size_t width = length > MAGIC && at[MAGIC] == 1 ? 2 : 4, begin = MAGIC + VERSION + width;
    *out = (npy_head){.rows = 0};
    if (!npy_is_begun(bytes, length))
        return fault_set(f, EXIT_INPUT,
                         "%s: is no .npy file, as its name says; expected the bytes "
                         "\\x93NUMPY at its beginning",
                         name);
    if (length < begin || at[MAGIC] < 1 || at[MAGIC] > 3)
        return fault_set(f, EXIT_INPUT, "%s: expected version 1, 2 or 3 of the .npy form", name);
    size_t head = 0;
    for (size_t k = width; k > 0; k--)
        head = head << 8 | at[MAGIC + VERSION + k - 1];
    out->start = begin + head;
    if (head > NPY_HEAD_MOST - begin || out->start > length)
        return no_head(f, name);
    return read_dictionary(out, f, name, (field){bytes + begin, head}, dimension);
}
