/* One run of graze envelope: a summary, and tables on request.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_ENVELOPE_H
#define GRAZE_RUN_ENVELOPE_H

#include "program/run/load.h"

/** Strings are borrowed. */
typedef struct envelope_options {
    scene_options scene;
    const char *events; /* files; NULL: none */
    const char *patches, *joints;
    const char *at, *curve; /* times between commas, and their file */
    unsigned long count;    /* contact points, and their file */
    unsigned long long seed;
    const char *points;
} envelope_options;

/** Find the events, write them and print the summary. Returns an exit status and says what is
 * wrong. */
int envelope_run(const envelope_options *o);

#endif
