/* The columns of a file of contact points. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_RUN_SITE_COLUMNS_H
#define GRAZE_RUN_SITE_COLUMNS_H

#include "program/run/block.h"

/** Contact points in place of points: a row has a time too, before the coordinates, which are those
 * of the solid's frame or, `in_world`, of the place then; and a cell with `snap`. */
typedef struct site_form {
    int wanted, snap; /* by the options */
    int dimension, in_world;
    size_t cell;   /* its column */
    char *carried; /* 1 for each column that is carried along */
} site_form;

/** Fix the columns by a line of names: time and point, `cell` where points are moved; all others
 * but those of the table are carried along.
 * @param[out] where the columns of time and point
 * @param file the name of the file, for messages
 * @return EXIT_DONE or the status of the fault */
int site_columns_fix(fault *f, site_form *s, size_t where[4], const fields *names, const char *file,
                     unsigned long number);

/** The fault of a file without such a line. */
int site_columns_fault(fault *f, const site_form *s, const char *file, unsigned long number,
                       const char *what);

/** Is a field a time as tables write one that is not rational? */
int site_time_is_root(field token);

/** The name of a number of a row, 0 that of its time. */
const char *site_number_name(const site_form *s, int index);

#endif
