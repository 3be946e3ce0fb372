/* A finished table of answers, read row by row into columns of one type each.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The table is Graze's own (src/program/cli/formats.md, Tables): whole, with its `#` lines and one
 * row a line. Of its text only what further columns need is kept.
 */
#ifndef GRAZE_TABLE_TYPED_H
#define GRAZE_TABLE_TYPED_H

#include "graze/report.h"
#include "output/table/sink.h"
#include "output/table/texts.h"

typedef enum column_kind {
    COLUMN_COORDINATE, /* x, y, z: rationals */
    COLUMN_PMC,        /* in, on, out */
    COLUMN_CLASS,
    COLUMN_DEFINITION, /* a number, or ext */
    COLUMN_COUNT,      /* case, i, t */
    COLUMN_WORD,
    COLUMN_NUMBER, /* a further column with a number in every row */
    COLUMN_TEXT    /* any other further column */
} column_kind;

/* The values of all rows: one of the two arrays. */
typedef struct typed_column {
    field name; /* in the table's column line */
    column_kind kind;
    size_t widest;  /* bytes of its longest field */
    double *number; /* COORDINATE, NUMBER: the nearest double */
    uint32_t *code; /* pmc and class as in graze.h; definition, 0 for ext; counts; else the number
                       of the text */
    size_t capacity;
    texts texts; /* WORD, TEXT */
    text fields; /* NUMBER: the fields, a newline behind each, in case a later one is none */
} typed_column;

typedef struct typed_table {
    graze_context *context;
    enum { TYPED_HEAD, TYPED_ROWS, TYPED_WHOLE } state; /* what has been read */
    int dimension;
    int boxed;            /* there is a `# box` line */
    int pmc_alone;        /* `# columns pmc`: no other answers */
    size_t grid[3];       /* points along each axis, 1 for an axis that is not; all 0: no grid */
    fmpq low[3], high[3]; /* the grid's box, 0 for an axis that is not */
    text names;           /* the column line */
    size_t row_count, column_count;
    size_t own; /* the first so many columns are Graze's, the others the points' */
    typed_column *column;
} typed_table;

/** Begin an empty table. typed_clear frees it. */
void typed_init(typed_table *t, graze_context *context);
void typed_clear(typed_table *t);

/** GRAZE_EINPUT with the message, which says what is wrong, and what is expected. */
graze_status typed_broken(graze_context *context, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/** The name of a column, `column` if it has none; `_2` and so on stand behind a name that occurred.
 */
void typed_name(text *out, const typed_table *t, size_t index);

#endif
