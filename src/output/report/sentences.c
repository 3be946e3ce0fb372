/* Sentences by their keys. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/report.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

ASSET_FILE(sentences, "src/output/report/sentences.json");

/* Append a point of rationals or a vector of integers. */
static void put_tuple(text *out, int is_point, va_list *from) {
    const void *at = va_arg(*from, const void *);
    int dimension = va_arg(*from, int);
    for (int k = 0; k < dimension; k++) {
        text_put(out, k ? ", " : "(");
        if (is_point)
            text_rational(out, (const fmpq *)at + k);
        else
            text_integer(out, (const fmpz *)at + k);
    }
    text_put(out, ")");
}

static void put_filled(text *out, const char *key, va_list *from) {
    char before[64];
    snprintf(before, sizeof before, "\n\"%s\": \"", key);
    const char *at = strstr(sentences, before);
    out->failed |= !at;
    for (at = at ? at + strlen(before) : "\""; *at != '"'; at++)
        if (*at == '%')
            text_put(out, va_arg(*from, const char *));
        else if (*at == '#')
            text_count(out, va_arg(*from, unsigned long));
        else if (*at == '@')
            text_rational(out, va_arg(*from, const fmpq *));
        else if (*at == '~' || *at == '&')
            put_tuple(out, *at == '~', from);
        else if (*at == '$')
            put_filled(out, va_arg(*from, const char *), from);
        else
            text_bytes(out, *at == '\\' ? (at++, "\n") : at, 1);
}

void sentence_put(text *out, const char *key, ...) {
    va_list fillings;
    va_start(fillings, key);
    put_filled(out, key, &fillings);
    va_end(fillings);
}
