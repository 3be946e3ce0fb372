/* One run of graze generate: a table of query points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_GENERATE_H
#define GRAZE_RUN_GENERATE_H

#include "program/run/coordinates.h"
#include "program/run/load.h"
#include "program/run/lost_strata.h"

/** Results of a generation: zeroed at first, generated_clear at last. */
typedef struct generated {
    lost_strata lost;
    int dimension;
    unsigned long rows;
    char *box; /* of the points, low then high, as decimals of up to 17 digits between commas */
} generated;

/** Strings are borrowed. */
typedef struct generate_options {
    scene_options scene;
    unsigned long count;
    unsigned long long seed;
    const char *strata;  /* NAME=W,...; NULL: all, with their default weights, `rounded` with that
                            of those that --representable leaves none of, and */
    unsigned long level; /* this one of the stratum `level` */
    coordinate_options coordinates;
    int representable;  /* coordinates that a binary64 holds */
    int plain;          /* no `#` lines */
    const char *output; /* NULL: standard output */
    int quiet;          /* no progress */
} generate_options;

/** Make the points, all different, and write the table. It ends early where no other
 * points are found. Returns an exit status and says what is wrong.
 * @param[out] made may be NULL; standard error names the lost strata too */
int generate_run(generated *made, const generate_options *o);
void generated_clear(generated *made);

#endif
