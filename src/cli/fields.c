/* Cuts a line of CSV into its fields.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "cli/fields.h"

#include <stdlib.h>

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

static int add(fields *f, field one) {
    if (f->count == f->capacity) {
        size_t capacity = 2 * f->capacity + 16;
        field *grown = realloc(f->item, capacity * sizeof *grown);
        if (!grown)
            return 0;
        f->item = grown;
        f->capacity = capacity;
    }
    f->item[f->count++] = one;
    return 1;
}

/* Where a field that begins at `at` ends; NULL if a quote in it is not closed or followed by more.
 */
static const char *field_end(const char *at, const char *end) {
    while (at < end && is_blank(*at))
        at++;
    if (at == end || *at != '"') {
        while (at < end && *at != ',')
            at++;
        return at;
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
    return at == end || *at == ',' ? at : NULL;
}

fields_result fields_cut(fields *out, field line) {
    const char *at = line.start, *end = at + line.length;
    out->count = 0;
    for (;;) {
        const char *stop = field_end(at, end);
        if (!stop)
            return FIELDS_OPEN_QUOTE;
        if (!add(out, (field){at, (size_t)(stop - at)}))
            return FIELDS_NO_MEMORY;
        if (stop == end)
            return FIELDS_CUT;
        at = stop + 1;
    }
}

size_t fields_count(field line) {
    const char *at = line.start, *end = at + line.length;
    for (size_t count = 1;; count++) {
        const char *stop = field_end(at, end);
        if (!stop || stop == end)
            return stop ? count : 0;
        at = stop + 1;
    }
}

void fields_clear(fields *f) {
    free(f->item);
    *f = (fields){NULL, 0, 0};
}
