/* Calls that must be refused, and the functions called so far, for the test of wrong calls.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TESTS_API_MISUSE_H
#define GRAZE_TESTS_API_MISUSE_H

#include "walk.h"

/* Arguments of the calls, and the names of the functions called so far. */
typedef struct bench {
    scene s;
    graze_trace *trace;
    graze_generator *generator;
    graze_boundary *boundary;
    graze_comparison *comparison;
    mpq_t x[2], half; /* x: a point and a corner of a box */
    graze_rationals point;
    graze_boundary_options box;
    char called[8192];
} bench;

static void note(bench *b, const char *function) {
    char name[80];
    snprintf(name, sizeof name, "%s(", function);
    if (!strstr(b->called, name))
        strcat(b->called, name);
}

static void expect(bench *b, const char *call, graze_status status, const void *out) {
    char function[64];
    snprintf(function, sizeof function, "%.*s", (int)strcspn(call, "("), call);
    note(b, function);
    if (status != GRAZE_EUSE || out)
        fail_msg("%s: status %d, output %p: %s", call, (int)status, out,
                 graze_context_message(b->s.context));
}

static char dirty[] = "an output that was not set";

/* A call that must be refused. The second kind has the output `out`, of a pointer type, which must
 * be NULL afterwards. */
#define WRONG(call) expect(b, #call, call, NULL)
#define WRONG_OUT(type, call)                                                                      \
    do {                                                                                           \
        type *out = (type *)(void *)dirty;                                                         \
        graze_status wrong_status = call;                                                          \
        expect(b, #call, wrong_status, out);                                                       \
    } while (0)
/* A call that gives nothing: `nothing` holds. */
#define HARMLESS(function, nothing)                                                                \
    do {                                                                                           \
        note(b, #function);                                                                        \
        assert_true(nothing);                                                                      \
    } while (0)
#define CALLS(call) (call, 1)

#endif
