/* Reads numbers on the command line, and writes numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/io/io.h"

#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

int numbers_read(mpq_t *out, graze_context *context, const char *name, const char *text,
                 size_t length, int count) {
    const char *end = text + length;
    for (int k = 0; k < count; k++) {
        const char *comma = text <= end ? memchr(text, ',', (size_t)(end - text)) : NULL;
        const char *stop = comma ? comma : end;
        if (text > end || (k + 1 < count) != (comma != NULL))
            return complain(EXIT_USAGE, "%s: expected %d numbers between commas", name, count);
        graze_status status = graze_number_parse(out[k], context, text, (size_t)(stop - text));
        if (status)
            return complain(exit_for(status, EXIT_USAGE), "%s: %s", name,
                            graze_context_message(context));
        text = stop + 1;
    }
    return EXIT_DONE;
}

int numbers_given(mpq_t *out, graze_context *context, const char *name, const char *text,
                  int count) {
    return text ? numbers_read(out, context, name, text, strlen(text), count) : EXIT_DONE;
}

void rationals_init(rationals *n, int count) {
    for (n->count = 0; n->count < count; n->count++)
        mpq_init(n->at[n->count]);
}

void rationals_clear(rationals *n) {
    while (n->count)
        mpq_clear(n->at[--n->count]);
}

int numbers_count(unsigned long *out, const char *text, unsigned long low) {
    char *end;
    if (!isdigit((unsigned char)*text))
        return 0;
    errno = 0;
    *out = strtoul(text, &end, 10);
    return !*end && !errno && *out >= low;
}

char *numbers_text(const mpq_t value) {
    char *out =
        malloc(mpz_sizeinbase(mpq_numref(value), 10) + mpz_sizeinbase(mpq_denref(value), 10) + 3);
    return out ? mpq_get_str(out, 10, value) : NULL;
}
