/* Text that grows by doubling.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "number/rational.h"

void text_init(text *t) {
    memset(t, 0, sizeof *t);
}

void text_clear(text *t) {
    free(t->data);
    text_init(t);
}

/* Room for `length` more bytes and a NUL; 0 where there is none. */
static int reserve(text *t, size_t length) {
    if (!t->failed && t->capacity - t->length <= length) {
        size_t capacity = 2 * (t->length + length) + 64;
        char *data = realloc(t->data, capacity);
        t->failed = !data;
        if (data) {
            t->data = data;
            t->capacity = capacity;
        }
    }
    return !t->failed;
}

void text_bytes(text *t, const char *bytes, size_t length) {
    if (!reserve(t, length))
        return;
    memcpy(t->data + t->length, bytes, length);
    t->length += length;
    t->data[t->length] = '\0';
}

void text_put(text *t, const char *string) {
    text_bytes(t, string, strlen(string));
}

void text_format(text *t, const char *format, ...) {
    char line[512];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    if (length < 0 || (size_t)length >= sizeof line)
        t->failed = 1;
    else
        text_bytes(t, line, (size_t)length);
}

void text_owned(text *t, char *string) {
    if (string)
        text_put(t, string);
    else
        t->failed = 1;
    free(string);
}

void text_count(text *t, unsigned long value) {
    char digits[3 * sizeof value], *at = digits + sizeof digits;
    do {
        *--at = (char)('0' + value % 10);
        value /= 10;
    } while (value);
    text_bytes(t, at, (size_t)(digits + sizeof digits - at));
}

void text_rational(text *t, const fmpq_t value) {
    if (reserve(t, rational_room(value)))
        t->length += rational_write(t->data + t->length, value);
}

graze_status text_finish(char **out, graze_context *context, text *t) {
    text_bytes(t, "", 0);
    int failed = t->failed;
    *out = failed ? NULL : t->data;
    if (!failed)
        t->data = NULL;
    text_clear(t);
    return failed ? context_fail(context, GRAZE_ESYSTEM, "out of memory") : GRAZE_OK;
}
