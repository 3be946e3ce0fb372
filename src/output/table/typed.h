/* A table of answers in columns of one type each.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Rows are added as values (row_values.h). Of further columns only what they need is kept as text.
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
    int dimension;
    size_t grid[3];       /* points along each axis, 1 for an axis that is not; all 0: no grid */
    fmpq low[3], high[3]; /* the grid's box, 0 for an axis that is not */
    text names;           /* the names of the columns */
    size_t row_count, column_count;
    size_t own; /* number of the first columns, which are Graze's answers; the others are read as
                   text */
    typed_column *column;
} typed_table;

/** An empty table without columns. typed_clear frees it. */
void typed_init(typed_table *t, graze_context *context);
void typed_clear(typed_table *t);

/** The rows will be those of a grid: sizes and corners of its box, d each. */
void typed_set_grid(typed_table *t, int dimension, const size_t *size, graze_rationals low,
                    graze_rationals high);

/** The word of a code of pmc or class; NULL for other columns. Static. */
const char *typed_word(const typed_column *c, uint32_t code);

/** The name of a column, `column` if it has none; `_2` and so on stand behind a name that occurred.
 */
void typed_name(text *out, const typed_table *t, size_t index);

#endif
