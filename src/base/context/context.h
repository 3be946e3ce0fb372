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

/** Where the last failure is; see graze_place. */
typedef struct context_place {
    char file[4096], item[32], field[256];
    size_t line, index;
} context_place;

struct graze_context {
    char message[CONTEXT_MESSAGE_SIZE];
    context_place place;
    unsigned long limits[GRAZE_LIMIT_COUNT];
    graze_rounding rounding;
    int exact_only;            /* the filter is off */
    unsigned long work;        /* of the motion being read, as the limit `work` counts it */
    unsigned long exact_count; /* points whose answer needed the exact path */
    void *workspace;           /* memory that a later stage reuses from call to call */
    void (*workspace_free)(void *);
    graze_cancel cancel;
    void *cancel_data;
    unsigned long unpolled; /* work done since the last call of the callback */
};

/**
 * Record a message and hand the status back, so that a failing function ends in one line:
 * return context_fail(context, GRAZE_EINPUT, "...", ...). A message names the place, the fault and
 * what is expected, in one line without a full stop at its end. It forgets the place of the failure
 * before.
 */
graze_status context_fail(graze_context *context, graze_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** context_fail at a place in a file: "file:line: " stands before the message, without a line (0)
 * "file: ". */
graze_status context_fail_in(graze_context *context, graze_status status, const char *file,
                             size_t line, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/** Put "file:line: " or, without a line (0), "file: " before the message of a failure on its way
 * up, and record the place; returns `status`. GRAZE_OK passes through. */
graze_status context_in(graze_context *context, graze_status status, const char *file, size_t line);

/** Put "item index, field: " before the message, without `item` or `field` (NULL) the rest of it,
 * and record the place; returns `status`. GRAZE_OK passes through. */
graze_status context_item(graze_context *context, graze_status status, const char *item,
                          size_t index, const char *field);

/** Put `where` and ": " before the message; returns `status`. */
graze_status context_at(graze_context *context, graze_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** GRAZE_ELIMIT with a message that names the limit and its value; `what` is too large. */
graze_status context_limit(graze_context *context, graze_limit limit, const char *what);

/** Call the cancel callback: GRAZE_OK, or GRAZE_ECANCELED with its message. */
graze_status context_poll(graze_context *context);

/**
 * Count work of the exact arithmetic, in products of two machine words, and call the cancel
 * callback after some milliseconds of it. A context of NULL has no callback.
 */
graze_status context_work(graze_context *context, unsigned long work);

#ifdef __cplusplus
}
#endif
#endif
