/* Cuts a line of CSV into its fields.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/delimited/delimited.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"

static int is_blank(char byte) {
    return byte == ' ' || byte == '\t';
}

field field_trimmed(field f) {
    for (; f.length && is_blank(*f.start); f.start++)
        f.length--;
    while (f.length && is_blank(f.start[f.length - 1]))
        f.length--;
    return f;
}

field field_content(field f) {
    f = field_trimmed(f);
    if (f.length >= 2 && *f.start == '"') {
        f.start++;
        f.length -= 2;
    }
    return f;
}

int field_is(field f, const char *text) {
    return f.length == strlen(text) && memcmp(f.start, text, f.length) == 0;
}

int field_equal(field a, field b) {
    return a.length == b.length && memcmp(a.start, b.start, a.length) == 0;
}

int field_count(unsigned long *out, field f, unsigned long most) {
    *out = 0;
    for (size_t k = 0; k < f.length; k++) {
        unsigned long digit = (unsigned long)f.start[k] - '0';
        if (f.start[k] < '0' || digit > 9 || digit > most || *out > (most - digit) / 10)
            return 0;
        *out = 10 * *out + digit;
    }
    return f.length > 0;
}

field field_line(field *rest) {
    const char *end = memchr(rest->start, '\n', rest->length);
    size_t length = end ? (size_t)(end - rest->start) : rest->length, gone = length + (end != NULL);
    field line = {rest->start, length};
    *rest = (field){rest->start + gone, rest->length - gone};
    return line;
}

int field_behind(field *out, field line, const char *key) {
    size_t length = strlen(key);
    if (line.length < length || memcmp(line.start, key, length) != 0)
        return 0;
    *out = (field){line.start + length, line.length - length};
    return 1;
}

void field_note(field *key, field *value, field line) {
    *value = *key = field_trimmed((field){line.start + 1, line.length - 1});
    for (key->length = 0; key->length < value->length && !is_blank(key->start[key->length]);)
        key->length++;
    value->start += key->length;
    value->length -= key->length;
    *value = field_trimmed(*value);
}

/* The end of a field that begins at `at`; NULL if it opens a quote that is not closed, or if more
 * than blanks follow the closing quote.
 */
static const char *field_end(const char *at, const char *end, char separator) {
    while (at < end && is_blank(*at))
        at++;
    if (at == end || *at != '"') {
        const char *stop = at == end ? NULL : memchr(at, separator, (size_t)(end - at));
        return stop ? stop : end;
    }
    for (at++; at < end; at++) {
        if (*at != '"')
            continue;
        if (at + 1 == end || at[1] != '"')
            break;
        at++;
    }
    if (at == end)
        return NULL;
    for (at++; at < end && is_blank(*at);)
        at++;
    return at == end || *at == separator ? at : NULL;
}

static int take_field(field *out, field *rest, char separator) {
    const char *end = rest->start + rest->length, *stop = field_end(rest->start, end, separator);
    if (!stop)
        return 0;
    *out = (field){rest->start, (size_t)(stop - rest->start)};
    *rest = stop == end ? (field){NULL, 0} : (field){stop + 1, (size_t)(end - stop - 1)};
    return 1;
}

int field_take(field *out, field *rest) {
    return take_field(out, rest, ',');
}

char field_separator(field line) {
    int quoted = 0, semicolon = 0, blank = 0;
    line = field_trimmed(line);
    for (size_t k = 0; k < line.length; k++) {
        quoted ^= line.start[k] == '"';
        if (quoted)
            continue;
        if (line.start[k] == ',')
            return ',';
        semicolon |= line.start[k] == ';';
        blank |= is_blank(line.start[k]);
    }
    return semicolon ? ';' : blank ? ' ' : ',';
}

static int add(fields *f, field one) {
    if (!array_reserve(&f->item, &f->capacity, f->count + 1, sizeof *f->item))
        return 0;
    f->item[f->count++] = one;
    return 1;
}

static fields_result cut_fields(fields *out, field line, char separator) {
    out->count = 0;
    while (line.start) {
        field one;
        if (!take_field(&one, &line, separator))
            return FIELDS_OPEN_QUOTE;
        if (!add(out, one))
            return FIELDS_NO_MEMORY;
    }
    return FIELDS_CUT;
}

fields_result fields_cut(fields *out, field line) {
    return cut_fields(out, line, ',');
}

/* Cut at runs of blanks; quotes are characters like others. */
static fields_result cut_words(fields *out, field line) {
    out->count = 0;
    for (line = field_trimmed(line); line.length; line = field_trimmed(line)) {
        field one = {line.start, 0};
        while (one.length < line.length && !is_blank(one.start[one.length]))
            one.length++;
        if (!add(out, one))
            return FIELDS_NO_MEMORY;
        line = (field){line.start + one.length, line.length - one.length};
    }
    return FIELDS_CUT;
}

graze_status fields_read(fields *out, graze_context *context, const char *name,
                         unsigned long number, field line, char separator) {
    if (memchr(line.start, '\0', line.length))
        return context_fail_in(context, GRAZE_EINPUT, name, number, "a byte 0 in a text file");
    switch (separator == ' ' ? cut_words(out, line) : cut_fields(out, line, separator)) {
    case FIELDS_CUT:
        return GRAZE_OK;
    case FIELDS_OPEN_QUOTE:
        return context_fail_in(context, GRAZE_EINPUT, name, number,
                               "a quoted field does not end; expected its closing quote on "
                               "this line, before a %s or the line's end",
                               separator == ';' ? "semicolon" : "comma");
    default:
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    }
}

void fields_clear(fields *f) {
    free(f->item);
    *f = (fields){NULL, 0, 0};
}

int field_is_among(field name, field line) {
    field one;
    while (line.start && field_take(&one, &line))
        if (field_equal(field_content(one), name))
            return 1;
    return 0;
}

int lines_differ(field *a, field *b, const char **x, const char **y) {
    do {
        if (!**x && !**y)
            return 0;
        *a = (field){*x, strcspn(*x, "\n")};
        *b = (field){*y, strcspn(*y, "\n")};
        *x += a->length + ((*x)[a->length] == '\n');
        *y += b->length + ((*y)[b->length] == '\n');
    } while (field_equal(*a, *b));
    return 1;
}
