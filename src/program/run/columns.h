/* The columns of a file of points: places of the coordinates, names of the others.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_COLUMNS_H
#define GRAZE_RUN_COLUMNS_H

#include "program/run/site_columns.h"

/** Columns of a file that graze classify has written: its answers, which are not carried along. */
typedef struct own_columns {
    size_t first, end; /* answers are the columns from `first` to before `end` */
    size_t last;       /* and the last ones: of --sdf, --moments, --topo and --regular */
} own_columns;

/** `count` is 0 until the first line has fixed them; nothing changes afterwards. */
typedef struct columns {
    const char *name; /* of the file, for messages; borrowed */
    int dimension;
    int numbers; /* of a row: the dimension, one more of contact points */
    site_form sites;
    size_t count;
    size_t where[4]; /* the columns of time, x, y, z, without time of x, y, z */
    char separator;  /* of the file's fields; those of a table stand between commas */
    own_columns own;
    char *others; /* names of the further columns, comma-joined; NULL if none */
} columns;

/** Facts from the `#` lines before the first line: whether Graze has written the file, and with
 * which answers. */
typedef struct columns_head {
    int graze, topo, regular, sdf, boundary, certain, moments, unsweep, pmc_alone;
} columns_head;

/** Working memory of a thread that reads rows. The context is borrowed, the rest is freed by
 * reader_clear. */
typedef struct reader {
    graze_context *context;
    fields cut;
    graze_cell cell; /* of the row read last, where rows have cells */
    char *rest;      /* further columns of the rows of a run, each with a NUL */
    size_t rest_length, rest_capacity;
} reader;

void reader_clear(reader *r);
void columns_clear(columns *c);

/**
 * Fix the columns by the first line of a file that is neither blank nor a comment.
 * @param[out] header 1 if the line names the columns, 0 if it is a row
 * @return EXIT_DONE, or the status of the fault, which names file and line
 */
int columns_fix(int *header, fault *f, columns *c, graze_context *context, field text,
                unsigned long number, columns_head head);

/**
 * Names of the further columns in a table: one that the table has already gets `_in` behind it
 * until it is free, and a note says so.
 * @param own the table's own column line
 * @return malloc'ed; NULL when out of memory, or where there are no further columns
 */
char *columns_free_names(const columns *c, field own);

/**
 * Read a line of a block. Any thread may ask, once the columns are fixed.
 * @param[out] point one initialised rational per number of a row
 * @param r          the further columns are added to `rest` where there are any
 * @return EXIT_DONE, or the status of the fault, which names file and line
 */
int columns_row(mpq_t *point, fault *f, const columns *c, reader *r, const block *b, size_t index);

#endif
