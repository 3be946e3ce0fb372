/* Files and options of one run of graze classify, graze certify or graze contact.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_FILES_H
#define GRAZE_RUN_FILES_H

#include "program/run/coordinates.h"
#include "program/run/grid.h"
#include "program/run/load.h"

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
    struct site_choice {
        int wanted, snap; /* contact points in place of points, moved to the contacts of cells */
    } sites;
    coordinate_options coordinates;
    int no_table;            /* a certificate takes the table's place */
    const char *output;      /* NULL: standard output */
    const char *resume;      /* the table to continue, or NULL */
    const char *certificate; /* a file for the certificate beside the table, or NULL */
    int times;               /* it gives the times and cells of contacts */
    int threads;             /* 0: one for each core */
    int quiet;               /* no progress */
    int transient;           /* the files are not kept, and nothing is that a run may go on with */
} classify_options;

#endif
