/* One run of graze generate: a table of query points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_GENERATE_H
#define GRAZE_RUN_GENERATE_H

#include "run/load.h"

/** Strings are borrowed. */
typedef struct generate_options {
    scene_options scene;
    unsigned long count;
    unsigned long long seed;
    const char *strata; /* NAME=W,...; NULL: all, with their default weights */
    int representable;  /* coordinates that a binary64 holds */
    const char *output; /* NULL: standard output */
    int quiet;          /* no progress */
} generate_options;

/** Make the points and write the table. Returns an exit status and says what is wrong. */
int generate_run(const generate_options *o);

#endif
