/* Contexts: options, limits, the last message, the cancel callback.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTEXT_H
#define GRAZE_CONTEXT_H

#include "graze/core.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CONTEXT_MESSAGE_SIZE 2048

/** The place of the last failure, as graze_place describes it. */
typedef struct context_place {
    char file[4096], item[32], field[256];
    size_t line, index;
} context_place;

struct graze_context {
    char message[CONTEXT_MESSAGE_SIZE];
    context_place place;
    unsigned long limits[GRAZE_LIMIT_COUNT];
    graze_rounding rounding;
    int exact_only;     /* the filter is off */
    unsigned long work; /* of the motion or curved solid being read, counted for the limit `work` */
    unsigned long exact_count; /* points whose answer needed the exact path */
    void *workspace;           /* buffers of the filter, reused from call to call */
    void (*workspace_free)(void *);
    graze_cancel cancel;
    void *cancel_data;
    unsigned long unpolled; /* work done since the last call of `cancel` */
};

/**
 * Record a message and hand the status back, so that a failing function ends in one line: return
 * context_fail(context, GRAZE_EINPUT, "...", ...). A message names the place, the fault and what is
 * expected, in one line without a full stop at its end. The place of an earlier failure is
 * forgotten.
 */
graze_status context_fail(graze_context *context, graze_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** context_fail at a place in a file: the message begins with "file:line: ", or with "file: " if
 * `line` is 0. */
graze_status context_fail_in(graze_context *context, graze_status status, const char *file,
                             size_t line, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/** Put "file:line: ", or "file: " if `line` is 0, before the message of a failed call and record
 * the place; returns `status`. Nothing happens if it is GRAZE_OK. */
graze_status context_in(graze_context *context, graze_status status, const char *file, size_t line);

/** Put "item index, field: " before the message of a failed call and record the place: "field: " if
 * `item` is NULL, "item index: " if `field` is NULL. Returns `status`; nothing happens if it is
 * GRAZE_OK. */
graze_status context_item(graze_context *context, graze_status status, const char *item,
                          size_t index, const char *field);

/** Put the formatted text and ": " before the message; returns `status`. To be called after a
 * failure only. */
graze_status context_at(graze_context *context, graze_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Make a malloc'ed array of `count` zeroed entries; NULL on failure.
 * @return GRAZE_ESYSTEM; the message is "out of memory for " and the formatted text */
graze_status context_array(graze_context *context, void *array, size_t count, size_t size,
                           const char *what, ...) __attribute__((format(printf, 5, 6)));

/** context_array for a pointer; behind the count stands the formatted text. */
#define MAKE_ARRAY(context, array, count, ...)                                                     \
    context_array(context, &(array), count, sizeof *(array), __VA_ARGS__)

/** Fail with GRAZE_ELIMIT; the message says that `what` exceeds the limit and gives the limit's
 * name and value. */
graze_status context_limit(graze_context *context, graze_limit limit, const char *what);

/** Call the cancel callback, if there is one. @return GRAZE_ECANCELED, with a message, if it asks
 * to stop; else GRAZE_OK */
graze_status context_poll(graze_context *context);

/**
 * Count work of the exact arithmetic, in products of two machine words, and call the cancel
 * callback after some milliseconds of work. A context of NULL has no callback.
 */
graze_status context_work(graze_context *context, unsigned long work);

/** The name of an enum's value: names[value], or "none" for a value beyond `count` or without a
 * name. */
const char *name_at(const char *const *names, size_t count, size_t value);

/** Define a public function that names the values of an enum by a list in braces. */
#define NAMES_OF(function, type, ...)                                                              \
    const char *function(type value) {                                                             \
        static const char *const names[] = __VA_ARGS__;                                            \
        return name_at(names, sizeof names / sizeof *names, (size_t)value);                        \
    }

#ifdef __cplusplus
}
#endif
#endif
