/* One run of graze classify: points of a file or a grid into a table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_CLASSIFY_H
#define GRAZE_RUN_CLASSIFY_H

#include "run/grid.h"
#include "run/load.h"

/** Strings are borrowed. */
typedef struct classify_options {
    scene_options scene;
    const char *receipt; /* of the scene, or NULL */
    const char *points;  /* the file, or `-`; not looked at with a grid */
    grid_options grid;
    struct shard_choice {
        int given;  /* the table is marked as that of a shard */
        shard part; /* 0 of 1: the whole run */
    } shard;
    struct row_format {
        graze_format rows;
        graze_export table; /* made of the rows at the end */
    } format;
    const char *output; /* NULL: standard output */
    const char *resume; /* the table to continue, or NULL */
    int threads;        /* 0: one for each core */
    int quiet;          /* no progress */
} classify_options;

/** Classify the points and write the table. Returns an exit status and says what is wrong. */
int classify_run(const classify_options *o);

#endif
