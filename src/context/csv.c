/* Cuts a line of CSV into its fields.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "context/csv.h"

#include <string.h>

static int is_blank(char byte) {
    return byte == ' ' || byte == '\t';
}

csv_field csv_trimmed(csv_field f) {
    for (; f.length && is_blank(*f.start); f.start++)
        f.length--;
    while (f.length && is_blank(f.start[f.length - 1]))
        f.length--;
    return f;
}

/* Where a field that begins at `at` ends; NULL if a quote in it is not closed or followed by more.
 */
static const char *field_end(const char *at, const char *end) {
    while (at < end && is_blank(*at))
        at++;
    if (at == end || *at != '"') {
        const char *comma = at == end ? NULL : memchr(at, ',', (size_t)(end - at));
        return comma ? comma : end;
    }
    for (at++; at < end && !(*at == '"' && (at + 1 == end || at[1] != '"')); at++)
        at += *at == '"';
    if (at >= end)
        return NULL;
    for (at++; at < end && is_blank(*at);)
        at++;
    return at == end || *at == ',' ? at : NULL;
}

int csv_take(csv_field *out, const char **at, const char *end) {
    const char *stop = field_end(*at, end);
    if (!stop)
        return 0;
    *out = csv_trimmed((csv_field){*at, (size_t)(stop - *at)});
    if (out->length >= 2 && *out->start == '"') {
        out->start++;
        out->length -= 2;
    }
    *at = stop == end ? NULL : stop + 1;
    return 1;
}
