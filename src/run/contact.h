/* One run of graze contact: a table of contact points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_CONTACT_H
#define GRAZE_RUN_CONTACT_H

#include "run/load.h"

/** Strings are borrowed. */
typedef struct contact_options {
    scene_options scene;
    const char *contacts; /* the file, or `-` */
    graze_format format;
    const char *output; /* NULL: standard output */
    int quiet;          /* no progress */
} contact_options;

/** Read the points and write the table. Returns an exit status and says what is wrong. */
int contact_run(const contact_options *o);

#endif
