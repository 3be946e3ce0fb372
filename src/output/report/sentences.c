/* Sentences by their keys. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/sentences.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

ASSET_FILE(sentences, "src/output/report/sentences.json");

typedef struct fillings {
    va_list next;
} fillings;

void sentence_vector(text *out, const fmpz *v, int dimension) {
    for (int k = 0; k < dimension; k++) {
        text_put(out, k ? ", " : "(");
        text_integer(out, v + k);
    }
    text_put(out, ")");
}

/* A point of rationals or a vector of integers. */
static void put_tuple(text *out, int is_point, fillings *from) {
    const void *at = va_arg(from->next, const void *);
    int dimension = va_arg(from->next, int);
    if (!is_point)
        sentence_vector(out, at, dimension);
    for (int k = 0; k < dimension && is_point; k++) {
        text_put(out, k ? ", " : "(");
        text_rational(out, (const fmpq *)at + k);
    }
    text_put(out, is_point ? ")" : "");
}

static void put_filled(text *out, const char *key, fillings *from) {
    char before[64];
    snprintf(before, sizeof before, "\n\"%s\": \"", key);
    const char *at = strstr(sentences, before);
    out->failed |= !at;
    for (at = at ? at + strlen(before) : "\""; *at != '"'; at++)
        if (*at == '%')
            text_put(out, va_arg(from->next, const char *));
        else if (*at == '#')
            text_count(out, va_arg(from->next, unsigned long));
        else if (*at == '@')
            text_rational(out, va_arg(from->next, const fmpq *));
        else if (*at == '~' || *at == '&')
            put_tuple(out, *at == '~', from);
        else if (*at == '$')
            put_filled(out, va_arg(from->next, const char *), from);
        else
            text_bytes(out, *at == '\\' ? (at++, "\n") : at, 1);
}

void sentence_put(text *out, const char *key, ...) {
    fillings from;
    va_start(from.next, key);
    put_filled(out, key, &from);
    va_end(from.next);
}
