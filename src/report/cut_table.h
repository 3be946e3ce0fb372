/* A finished CSV table of results, cut into columns for formats that are arrays.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The table is Graze's own (src/cli/formats.md, Tables): whole, with its `#` lines and one row a
 * line. It is borrowed and not copied.
 */
#ifndef GRAZE_REPORT_CUT_TABLE_H
#define GRAZE_REPORT_CUT_TABLE_H

#include "number/text.h"
#include "table/field.h"

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

typedef struct column {
    field name;
    column_kind kind;
    size_t widest; /* bytes of its longest field */
} column;

/* Once read, every row has as many fields as there are columns, each of its column's kind. */
typedef struct cut_table {
    int dimension;
    int boxed;            /* there is a `# box` line */
    size_t grid[3];       /* points along each axis, 1 for an axis that is not; all 0: no grid */
    fmpq low[3], high[3]; /* the grid's box, 0 for an axis that is not */
    size_t row_count, column_count;
    size_t own; /* the first so many columns are Graze's, the others the points' */
    column *column;
    field *row; /* each row without its line end */
} cut_table;

/**
 * Cut a table and check all that it says. `out` is cleared by cut_table_clear, also on failure.
 * @return GRAZE_EINPUT it is no whole table of results; GRAZE_ESYSTEM, GRAZE_ELIMIT
 */
graze_status cut_table_read(cut_table *out, graze_context *context, const char *table,
                            size_t length);
void cut_table_clear(cut_table *c);

/** Field `index` of a row, which has it. */
field cut_table_field(const cut_table *c, size_t row, size_t index);
/** The double nearest to a field that is a number; infinite past the range of doubles.
 * @return GRAZE_ELIMIT more digits than the limit; GRAZE_ESYSTEM */
graze_status cut_table_number(double *out, graze_context *context, const cut_table *c, size_t row,
                              size_t index);
/** The value of a field of Graze's own by which numbers stand for names: pmc and class as in
 * graze.h, definition with 0 for ext, counts as they are. */
unsigned long cut_table_code(column_kind kind, field field);

/** The table as a legacy VTK file: a grid as structured points, else vertices. */
graze_status export_vtk(text *out, graze_context *context, const cut_table *c);
/** The table as a structured numpy array. */
graze_status export_npy(text *out, graze_context *context, const cut_table *c);

#endif
