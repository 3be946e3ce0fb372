/* Contexts: options, limits and the message of the last failure.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant: the message is one line of printable text, "" while nothing has failed.
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "context/context.h"

/* Products of machine words between two polls: a few milliseconds. */
enum { POLLED_WORK = 1 << 22 };

/* The largest values keep every size Graze computes from a limit inside 64 bits, indices of
 * vertices inside 32 bits, and recursion inside an ordinary stack. */
static const struct {
    const char *name;
    unsigned long preset, largest;
} limit_table[GRAZE_LIMIT_COUNT] = {
    [GRAZE_LIMIT_DIGITS] = {"digits", 10000, 100000000},
    [GRAZE_LIMIT_DEGREE] = {"degree", 200, 1000000},
    [GRAZE_LIMIT_PIECES] = {"pieces", 10000, 100000000},
    [GRAZE_LIMIT_DEPTH] = {"depth", 100, 5000},
    [GRAZE_LIMIT_GRID] = {"grid", 10000000000, 1000000000000000000},
    [GRAZE_LIMIT_LINE] = {"line", 10000000, 1000000000000},
    [GRAZE_LIMIT_CELLS] = {"cells", 100000000, 4000000000},
    [GRAZE_LIMIT_BYTES] = {"bytes", 4000000000, 1000000000000},
    [GRAZE_LIMIT_WORK] = {"work", 100000000, 1000000000000000},
    [GRAZE_LIMIT_BITS] = {"bits", 100000, 1000000000},
};

graze_status graze_context_create(graze_context **out) {
    if (out == NULL) {
        return GRAZE_EUSE;
    }
    *out = calloc(1, sizeof **out);
    if (*out == NULL) {
        return GRAZE_ESYSTEM;
    }
    for (int k = 0; k < GRAZE_LIMIT_COUNT; k++) {
        (*out)->limits[k] = limit_table[k].preset;
    }
    return GRAZE_OK;
}

void graze_context_destroy(graze_context *context) {
    if (context != NULL && context->workspace != NULL) {
        context->workspace_free(context->workspace);
    }
    free(context);
}

unsigned long graze_context_exact_count(const graze_context *context) {
    return context != NULL ? context->exact_count : 0;
}

const char *graze_context_message(const graze_context *context) {
    return context != NULL ? context->message : "";
}

static int is_limit(graze_limit limit) {
    return (int)limit >= 0 && (int)limit < GRAZE_LIMIT_COUNT;
}

graze_status graze_context_set_limit(graze_context *context, graze_limit limit,
                                     unsigned long value) {
    if (context == NULL) {
        return GRAZE_EUSE;
    }
    if (!is_limit(limit)) {
        return context_fail(context, GRAZE_EUSE, "limit %d: expected 0 to %d", (int)limit,
                            (int)GRAZE_LIMIT_COUNT - 1);
    }
    if (value == 0 || value > limit_table[limit].largest) {
        return context_fail(context, GRAZE_EUSE, "limit %s=%lu: expected 1 to %lu",
                            limit_table[limit].name, value, limit_table[limit].largest);
    }
    context->limits[limit] = value;
    return GRAZE_OK;
}

unsigned long graze_context_limit(const graze_context *context, graze_limit limit) {
    return context != NULL && is_limit(limit) ? context->limits[limit] : 0;
}

void graze_context_set_filter(graze_context *context, int on) {
    if (context != NULL) {
        context->exact_only = !on;
    }
}

const char *graze_limit_name(graze_limit limit) {
    return is_limit(limit) ? limit_table[limit].name : NULL;
}

graze_status graze_context_set_rounding(graze_context *context, graze_rounding rounding) {
    if (context == NULL) {
        return GRAZE_EUSE;
    }
    if (rounding != GRAZE_ROUND_NONE && rounding != GRAZE_ROUND_BINARY64 &&
        rounding != GRAZE_ROUND_BINARY32) {
        return context_fail(context, GRAZE_EUSE, "rounding %d: expected none, binary64 or binary32",
                            (int)rounding);
    }
    context->rounding = rounding;
    return GRAZE_OK;
}

void graze_context_set_cancel(graze_context *context, graze_cancel cancel, void *data) {
    if (context != NULL) {
        context->cancel = cancel;
        context->cancel_data = data;
    }
}

void graze_free(void *memory) {
    free(memory);
}

/* A message is one line: control bytes of quoted input are replaced. A character of UTF-8 that is
 * cut at the end is left out. */
static void set_message(graze_context *context, const char *text) {
    size_t n = strnlen(text, CONTEXT_MESSAGE_SIZE - 1);
    for (size_t k = 0; k < n; k++) {
        unsigned char c = (unsigned char)text[k];
        context->message[k] = c < 0x20 || c == 0x7f ? '?' : text[k];
    }
    if (n == CONTEXT_MESSAGE_SIZE - 1) {
        while (n > 0 && ((unsigned char)text[n - 1] & 0x80) != 0) {
            n--;
        }
    }
    context->message[n] = '\0';
}

graze_status context_fail(graze_context *context, graze_status status, const char *format, ...) {
    char text[CONTEXT_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    set_message(context, text);
    return status;
}

graze_status context_at(graze_context *context, graze_status status, const char *format, ...) {
    char text[2 * CONTEXT_MESSAGE_SIZE + 2];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, CONTEXT_MESSAGE_SIZE, format, arguments);
    va_end(arguments);
    size_t used = strlen(text);
    snprintf(text + used, sizeof text - used, ": %s", context->message);
    set_message(context, text);
    return status;
}

graze_status context_limit(graze_context *context, graze_limit limit, const char *what) {
    return context_fail(context, GRAZE_ELIMIT, "%s: more than the limit %s=%lu allows", what,
                        limit_table[limit].name, context->limits[limit]);
}

graze_status context_poll(graze_context *context) {
    if (context->cancel != NULL && context->cancel(context->cancel_data) != 0) {
        return context_fail(context, GRAZE_ECANCELED, "canceled by the caller");
    }
    return GRAZE_OK;
}

graze_status context_work(graze_context *context, unsigned long work) {
    if (context == NULL) {
        return GRAZE_OK;
    }
    context->unpolled += work < POLLED_WORK ? work : POLLED_WORK;
    if (context->unpolled < POLLED_WORK) {
        return GRAZE_OK;
    }
    context->unpolled = 0;
    return context_poll(context);
}
