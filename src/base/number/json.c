/* Writes JSON. SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number/json.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static void put_line(json_writer *w) {
    if (w->pretty)
        text_put(w->out, "\n");
}

static void put_indent(json_writer *w) {
    for (int k = 0; k < w->depth && w->pretty; k++)
        text_put(w->out, "  ");
}

static void put_string(text *out, const char *string) {
    static const char plain[] = "\"\\\b\f\n\r\t", escaped[] = "\"\\bfnrt";
    text_put(out, "\"");
    while (*string) {
        size_t n = 0;
        while ((unsigned char)string[n] >= ' ' && string[n] != '"' && string[n] != '\\')
            n++;
        text_bytes(out, string, n);
        string += n;
        const char *known = *string ? strchr(plain, *string) : NULL;
        if (known)
            text_bytes(out, (const char[]){'\\', escaped[known - plain]}, 2);
        else if (*string)
            text_format(out, "\\u%04X", (unsigned)(unsigned char)*string);
        string += *string != '\0';
    }
    text_put(out, "\"");
}

/* Begin the line that json_line asked for, if it did. */
static void put_asked_line(json_writer *w) {
    if (w->line)
        text_format(w->out, "\n%*s", w->line - 1, "");
    w->line = 0;
}

text *json_begin(json_writer *w, const char *key) {
    if (w->members) {
        text_put(w->out, w->spaced && !w->line ? ", " : ",");
        put_line(w);
    }
    put_asked_line(w);
    put_indent(w);
    w->members = 1;
    if (key) {
        put_string(w->out, key);
        text_put(w->out, w->pretty || w->spaced ? ": " : ":");
    }
    return w->out;
}

void json_line(json_writer *w, int indent) {
    w->line = indent + 1;
}

void json_open(json_writer *w, const char *key, char bracket) {
    text_bytes(json_begin(w, key), &bracket, 1);
    put_line(w);
    w->depth++;
    w->members = 0;
}

void json_close(json_writer *w, char bracket) {
    w->depth--;
    w->members = 1;
    put_line(w);
    put_asked_line(w);
    put_indent(w);
    text_bytes(w->out, &bracket, 1);
    if (!w->depth)
        put_line(w);
}

void json_ends(json_writer *w, const char *brackets) {
    for (; *brackets; brackets++)
        json_close(w, *brackets);
}

void json_text(json_writer *w, const char *key, const char *value) {
    json_begin(w, key);
    if (value)
        put_string(w->out, value);
    else
        text_put(w->out, "null");
}

void json_count(json_writer *w, const char *key, unsigned long value) {
    text_count(json_begin(w, key), value);
}

void json_number(json_writer *w, const char *key, const char *digits) {
    text_put(json_begin(w, key), digits);
}

void json_double(json_writer *w, const char *key, double value) {
    text *out = json_begin(w, key);
    if (isfinite(value))
        text_format(out, "%.17g", value);
    else
        text_put(out, "null");
}

void json_bool(json_writer *w, const char *key, int value) {
    json_number(w, key, value ? "true" : "false");
}

void json_form(text *out, const char *form, ...) {
    va_list numbers;
    va_start(numbers, form);
    for (; *form; form++) {
        text_put(out, *form == '%' ? "\"" : "");
        if (*form == '@' || *form == '%')
            text_rational(out, va_arg(numbers, const fmpq *));
        else
            text_bytes(out, form, 1);
        text_put(out, *form == '%' ? "\"" : "");
    }
    va_end(numbers);
}

void json_rational(json_writer *w, const char *key, const fmpq_t value) {
    json_form(json_begin(w, key), "%", value);
}

void json_point(json_writer *w, const char *key, const fmpq *point, int dimension) {
    json_open(w, key, '[');
    for (int k = 0; k < dimension; k++)
        json_rational(w, NULL, point + k);
    json_close(w, ']');
}

void json_integer(json_writer *w, const char *key, const fmpz_t value) {
    json_begin(w, key);
    text_put(w->out, "\"");
    text_integer(w->out, value);
    text_put(w->out, "\"");
}

void json_owned(json_writer *w, const char *key, char *value) {
    if (value)
        json_text(w, key, value);
    else
        w->out->failed = 1;
    free(value);
}
