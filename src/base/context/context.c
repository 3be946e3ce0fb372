/* Contexts: options, limits and the message of the last failure.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant: the message is one line of printable text, "" while nothing has failed.
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/context.h"

/* Products of two machine words between two calls of the cancel callback; they take a few
 * milliseconds. */
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
    [GRAZE_LIMIT_CURVE] = {"curve", 20, 1000000},
    [GRAZE_LIMIT_ARCS] = {"arcs", 1000000, 1000000000},
};

graze_status graze_context_create(graze_context **out) {
    if (out == NULL)
        return GRAZE_EUSE;
    *out = calloc(1, sizeof **out);
    if (*out == NULL)
        return GRAZE_ESYSTEM;
    for (int k = 0; k < GRAZE_LIMIT_COUNT; k++)
        (*out)->limits[k] = limit_table[k].preset;
    return GRAZE_OK;
}

void graze_context_destroy(graze_context *context) {
    if (context != NULL && context->workspace != NULL)
        context->workspace_free(context->workspace);
    free(context);
}

unsigned long graze_context_exact_count(const graze_context *context) {
    return context != NULL ? context->exact_count : 0;
}

const char *graze_context_message(const graze_context *context) {
    return context != NULL ? context->message : "";
}

graze_place graze_context_place(const graze_context *context) {
    if (context == NULL)
        return (graze_place){"", 0, "", 0, ""};
    const context_place *at = &context->place;
    return (graze_place){at->file, at->line, at->item, at->index, at->field};
}

static int is_limit(graze_limit limit) {
    return (int)limit >= 0 && (int)limit < GRAZE_LIMIT_COUNT;
}

graze_status graze_context_set_limit(graze_context *context, graze_limit limit,
                                     unsigned long value) {
    if (context == NULL)
        return GRAZE_EUSE;
    if (!is_limit(limit))
        return context_fail(context, GRAZE_EUSE, "limit %d: expected 0 to %d", (int)limit,
                            (int)GRAZE_LIMIT_COUNT - 1);
    if (value == 0 || value > limit_table[limit].largest)
        return context_fail(context, GRAZE_EUSE, "limit %s=%lu: expected 1 to %lu",
                            limit_table[limit].name, value, limit_table[limit].largest);
    context->limits[limit] = value;
    return GRAZE_OK;
}

unsigned long graze_context_limit(const graze_context *context, graze_limit limit) {
    return context != NULL && is_limit(limit) ? context->limits[limit] : 0;
}

void graze_context_set_filter(graze_context *context, int on) {
    if (context != NULL)
        context->exact_only = !on;
}

const char *graze_status_name(graze_status status) {
    static const char *const names[] = {"ok",    "use",    "input",    "illegal",
                                        "limit", "system", "canceled", "internal"};
    return (unsigned)status < sizeof names / sizeof *names ? names[status] : NULL;
}

const char *graze_rounding_name(graze_rounding rounding) {
    static const char *const names[] = {"none", "binary64", "binary32"};
    return (unsigned)rounding < sizeof names / sizeof *names ? names[rounding] : NULL;
}

const char *name_at(const char *const *names, size_t count, size_t value) {
    return value < count && names[value] ? names[value] : "none";
}

NAMES_OF(graze_pmc_name, graze_pmc,
         {[GRAZE_IN] = "in",
          [GRAZE_ON] = "on",
          [GRAZE_OUT] = "out",
          [GRAZE_PMC_UNDECIDED] = "undecided"})

NAMES_OF(graze_class_name, graze_class,
         {[GRAZE_REGULAR] = "regular",
          [GRAZE_FOLD] = "fold",
          [GRAZE_FOLD_BOUNDARY] = "fold_boundary",
          [GRAZE_BOUNDARY] = "boundary",
          [GRAZE_EXTERIOR] = "exterior",
          [GRAZE_CLASS_UNDECIDED] = "undecided"})

const char *graze_limit_name(graze_limit limit) {
    return is_limit(limit) ? limit_table[limit].name : NULL;
}

graze_status graze_context_set_rounding(graze_context *context, graze_rounding rounding) {
    if (context == NULL)
        return GRAZE_EUSE;
    if (graze_rounding_name(rounding) == NULL)
        return context_fail(context, GRAZE_EUSE, "rounding %d: expected none, binary64 or binary32",
                            (int)rounding);
    context->rounding = rounding;
    return GRAZE_OK;
}

int graze_cancel_countdown(void *left) {
    return left != NULL && __atomic_fetch_sub((int *)left, 1, __ATOMIC_RELAXED) <= 0;
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

/* A message is one line: control bytes of quoted input are replaced. A message that fills its
 * buffer loses the bytes of UTF-8 characters at its end, since the last one may be cut. */
static void set_message(graze_context *context, const char *text) {
    size_t n = strnlen(text, CONTEXT_MESSAGE_SIZE - 1);
    for (size_t k = 0; k < n; k++) {
        unsigned char c = (unsigned char)text[k];
        context->message[k] = c < 0x20 || c == 0x7f ? '?' : text[k];
    }
    if (n == CONTEXT_MESSAGE_SIZE - 1)
        while (n > 0 && ((unsigned char)text[n - 1] & 0x80) != 0)
            n--;
    context->message[n] = '\0';
}

static void set_field(char *to, size_t size, const char *from) {
    snprintf(to, size, "%s", from);
}

static void put_before(graze_context *context, const char *where) {
    char text[2 * CONTEXT_MESSAGE_SIZE + 2];
    snprintf(text, sizeof text, "%s: %s", where, context->message);
    set_message(context, text);
}

static void record_failure(graze_context *context, const char *format, va_list arguments) {
    char text[CONTEXT_MESSAGE_SIZE];
    vsnprintf(text, sizeof text, format, arguments);
    set_message(context, text);
    context->place.file[0] = context->place.item[0] = context->place.field[0] = '\0';
    context->place.line = context->place.index = 0;
}

graze_status context_fail(graze_context *context, graze_status status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    record_failure(context, format, arguments);
    va_end(arguments);
    return status;
}

graze_status context_fail_in(graze_context *context, graze_status status, const char *file,
                             size_t line, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    record_failure(context, format, arguments);
    va_end(arguments);
    return context_in(context, status, file, line);
}

graze_status context_in(graze_context *context, graze_status status, const char *file,
                        size_t line) {
    char where[CONTEXT_MESSAGE_SIZE];
    if (status == GRAZE_OK)
        return status;
    int used = snprintf(where, sizeof where, "%s", file);
    if (line != 0 && used >= 0 && (size_t)used < sizeof where)
        snprintf(where + used, sizeof where - (size_t)used, ":%zu", line);
    put_before(context, where);
    set_field(context->place.file, sizeof context->place.file, file);
    context->place.line = line;
    return status;
}

graze_status context_item(graze_context *context, graze_status status, const char *item,
                          size_t index, const char *field) {
    char where[CONTEXT_MESSAGE_SIZE];
    if (status == GRAZE_OK)
        return status;
    int used = item != NULL ? snprintf(where, sizeof where, "%s %zu", item, index) : 0;
    if (field != NULL) {
        snprintf(where + used, sizeof where - (size_t)used, "%s%s", used > 0 ? ", " : "", field);
        set_field(context->place.field, sizeof context->place.field, field);
    }
    if (item != NULL) {
        set_field(context->place.item, sizeof context->place.item, item);
        context->place.index = index;
    }
    put_before(context, where);
    return status;
}

graze_status context_at(graze_context *context, graze_status status, const char *format, ...) {
    char where[CONTEXT_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(where, sizeof where, format, arguments);
    va_end(arguments);
    put_before(context, where);
    return status;
}

graze_status context_array(graze_context *context, void *array, size_t count, size_t size,
                           const char *what, ...) {
    char text[128];
    va_list arguments;
    void *made = calloc(count ? count : 1, size);
    memcpy(array, &made, sizeof made);
    if (made)
        return GRAZE_OK;
    va_start(arguments, what);
    vsnprintf(text, sizeof text, what, arguments);
    va_end(arguments);
    return context_fail(context, GRAZE_ESYSTEM, "out of memory for %s", text);
}

graze_status context_limit(graze_context *context, graze_limit limit, const char *what) {
    return context_fail(context, GRAZE_ELIMIT, "%s: more than the limit %s=%lu allows", what,
                        limit_table[limit].name, context->limits[limit]);
}

graze_status context_poll(graze_context *context) {
    if (context->cancel != NULL && context->cancel(context->cancel_data) != 0)
        return context_fail(context, GRAZE_ECANCELED, "canceled by the caller");
    return GRAZE_OK;
}

graze_status context_work(graze_context *context, unsigned long work) {
    if (context == NULL)
        return GRAZE_OK;
    context->unpolled += work < POLLED_WORK ? work : POLLED_WORK;
    if (context->unpolled < POLLED_WORK)
        return GRAZE_OK;
    context->unpolled = 0;
    return context_poll(context);
}
