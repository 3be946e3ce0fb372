/* Files of contact points: which column is what, and a row's numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_SITES_H
#define GRAZE_RUN_SITES_H

#include "number/text.h"
#include "run/status.h"
#include "table/stream.h"

/** `where` are the columns of time and point; `in_world` tells x, y, z from bx, by, bz. `others`
 * has the names of the columns that are carried along, NULL if there are none: all but those that
 * the table has itself. */
typedef struct sites {
    stream in;
    graze_context *context;
    int dimension, in_world;
    fields cut;
    size_t count, where[4];
    char *carried; /* 1 for each column that is carried along */
    char *others;
} sites;

/** Open a file, or standard input for `-`, and read the line of names. On failure says why;
 * sites_close in any case. */
int sites_open(sites *out, graze_context *context, const char *path, int dimension);
void sites_close(sites *s);
/**
 * Read the next row.
 * @param[out] number initialised: the time, then the coordinates
 * @param[out] rest   the carried columns, comma-joined as they were
 * @param[out] ended  1 if there was none
 * @return an exit status; on failure says why
 */
int sites_next(mpq_t number[4], text *rest, int *ended, sites *s);

#endif
