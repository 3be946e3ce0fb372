/* The inside of a context: options, limits, the last message, the cancel callback.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTEXT_H
#define GRAZE_CONTEXT_H

#include "graze/core.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CONTEXT_MESSAGE_SIZE 2048

struct graze_context {
    char message[CONTEXT_MESSAGE_SIZE];
    unsigned long limits[GRAZE_LIMIT_COUNT];
    graze_rounding rounding;
    int exact_only;            /* the filter is off */
    unsigned long work;        /* done for the motion that is read, as the limit `work` counts it */
    unsigned long exact_count; /* points whose answer needed the exact path */
    void *workspace;           /* memory that a later stage uses again from call to call */
    void (*workspace_free)(void *);
    graze_cancel cancel;
    void *cancel_data;
    unsigned long unpolled; /* work done since the callback was last asked */
};

/**
 * Record a message and hand the status back, so that a failing function ends in one line:
 * return context_fail(context, GRAZE_EINPUT, "%s:%zu: ...", ...). A message says where, what is
 * wrong and what would be right, in one line without a full stop at its end.
 */
graze_status context_fail(graze_context *context, graze_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Put `where` and ": " before the message of a failure on its way up; returns `status`. */
graze_status context_at(graze_context *context, graze_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** GRAZE_ELIMIT with the message every limit has, naming `--limit NAME=V`. `what` names the thing
 * that is too large. */
graze_status context_limit(graze_context *context, graze_limit limit, const char *what);

/** GRAZE_OK, or GRAZE_ECANCELED with its message when the callback asks to stop. */
graze_status context_poll(graze_context *context);

/**
 * Count work of the exact arithmetic, in products of two machine words or what takes as long, and
 * poll when some milliseconds of it have come together. A context of NULL has no callback.
 */
graze_status context_work(graze_context *context, unsigned long work);

#ifdef __cplusplus
}
#endif
#endif
