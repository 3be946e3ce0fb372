/* All rows of a table by their keys, for tables whose rows stand in any order.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Rows of one key are handed out in the order of the table.
 */
#ifndef GRAZE_COMPARE_ROW_INDEX_H
#define GRAZE_COMPARE_ROW_INDEX_H

#include "output/compare/key.h"

/** A row that is kept. */
typedef struct kept_row {
    digest key;
    unsigned long line, number; /* in the file, and among the rows */
    char *text;                 /* malloc'ed */
    size_t taken;               /* of the first of a key: how many of them are handed out */
} kept_row;

/** Zeroed at first. */
typedef struct row_index {
    table *table;
    kept_row *rows; /* by key, then by number; once `rest` is asked those left, by number */
    size_t count, capacity;
    int resting;  /* 1: the rest is being handed out */
    size_t next;  /* of it */
    table_row at; /* the row handed out last */
} row_index;

/** Read the rest of a table. GRAZE_EINPUT, GRAZE_ELIMIT, GRAZE_ESYSTEM, GRAZE_ECANCELED. */
graze_status row_index_read(row_index *out, table *t, const row_key *key);

/** The next row of a key; NULL if none is left. Borrowed until the next call. */
graze_status row_index_take(row_index *x, const table_row **out, digest key);

/** The next row that nobody took, by the order of the table; NULL at the end. Nothing can be taken
 * then. Borrowed until the next call. */
graze_status row_index_rest(row_index *x, const table_row **out);

void row_index_clear(row_index *x);

#endif
