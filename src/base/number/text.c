/* Text that grows by doubling.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "base/number/rational.h"

void text_init(text *t) {
    memset(t, 0, sizeof *t);
}

void text_clear(text *t) {
    free(t->data);
    text_init(t);
}

int text_reserve(text *t, size_t length) {
    if (!t->failed)
        t->failed = !array_reserve(&t->data, &t->capacity, t->length + length + 1, 1);
    return !t->failed;
}

void text_bytes(text *t, const char *bytes, size_t length) {
    if (!text_reserve(t, length))
        return;
    if (length)
        memcpy(t->data + t->length, bytes, length);
    t->length += length;
    t->data[t->length] = '\0';
}

void text_put(text *t, const char *string) {
    text_bytes(t, string, strlen(string));
}

void text_format(text *t, const char *format, ...) {
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    size_t room = t->failed ? 0 : t->capacity - t->length;
    int length = vsnprintf(room ? t->data + t->length : NULL, room, format, arguments);
    if (length < 0)
        t->failed = 1;
    else if (text_reserve(t, (size_t)length)) {
        if ((size_t)length >= room)
            vsnprintf(t->data + t->length, (size_t)length + 1, format, again);
        t->length += (size_t)length;
    }
    va_end(again);
    va_end(arguments);
}

static void put_printable(text *t, char byte) {
    char printable = (unsigned char)byte < 0x20 || byte == 0x7f ? ' ' : byte;
    text_bytes(t, &printable, 1);
}

void text_markdown(text *t, const char *string) {
    for (; *string; string++)
        if (*string == '<')
            text_put(t, "&lt;");
        else if (*string == '&')
            text_put(t, "&amp;");
        else {
            if (strchr("|`\\*[]", *string))
                text_put(t, "\\");
            put_printable(t, *string);
        }
}

/* The fences have one backquote more than the longest run of backquotes in the string. */
void text_code(text *t, const char *string) {
    size_t longest = 0, run = 0;
    for (const char *at = string; *at; at++) {
        run = *at == '`' ? run + 1 : 0;
        longest = run > longest ? run : longest;
    }
    for (size_t k = 0; k <= longest; k++)
        text_put(t, "`");
    text_put(t, longest ? " " : "");
    for (const char *at = string; *at; at++)
        put_printable(t, *at);
    text_put(t, longest ? " " : "");
    for (size_t k = 0; k <= longest; k++)
        text_put(t, "`");
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

void text_integer(text *t, const fmpz_t value) {
    if (text_reserve(t, fmpz_sizeinbase(value, 10) + 1)) {
        fmpz_get_str(t->data + t->length, 10, value);
        t->length += strlen(t->data + t->length);
    }
}

void text_coefficients(text *t, const fmpz_poly_t p) {
    for (slong k = 0; k < fmpz_poly_length(p); k++) {
        text_put(t, k ? " " : "");
        text_integer(t, fmpz_poly_get_coeff_ptr(p, k));
    }
}

void text_rational(text *t, const fmpq_t value) {
    if (text_reserve(t, rational_room(value)))
        t->length += rational_write(t->data + t->length, value);
}

char *text_take(text *t) {
    text_bytes(t, "", 0);
    char *data = t->failed ? NULL : t->data;
    if (data)
        t->data = NULL;
    text_clear(t);
    return data;
}

graze_status text_finish(char **out, graze_context *context, text *t) {
    *out = text_take(t);
    return *out ? GRAZE_OK : context_fail(context, GRAZE_ESYSTEM, "out of memory");
}
