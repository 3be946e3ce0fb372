/* table: numpy arrays and VTK files of a table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_TABLE_H
#define GRAZE_OUTPUT_TABLE_H

#include <gmp.h>
#include <stddef.h>
#include <stdint.h>
#include "base/context/context.h"
#include "base/context/slots.h"
#include "base/number/text.h"
#include "graze/report.h"
#include "input/delimited/delimited.h"

/* Rows of values: binary rows, from which tables with one type for each column are made.
 *
 * A row has, in this order: its coordinates, each the nearest double; codes of 32 bits for pmc,
 * class, definition (0 for ext), case, i and t, for those of these columns that the table has; its
 * word, if the table has one; the further columns, if any, as one comma-joined text; the answers
 * behind them, each a double or a word. A text is its length and its bytes. Values are as in
 * memory, without gaps. */

/** The double nearest to a rational, ties to even. GRAZE_EINPUT: the rational is past binary64. */
graze_status values_nearest(double *out, graze_context *context, const fmpq_t value);

void values_coordinate(text *out, double value);
/** Add the double nearest to the number in a field; statuses of values_nearest. The rounding of the
 * context has no effect. */
graze_status values_field(text *out, graze_context *context, field number);
void values_code(text *out, uint32_t code);
void values_text(text *out, const char *bytes, size_t length);

/* A sink of bytes: a text in memory, or a file. */

/** A sink. Failures are not returned; `to` has to record them. */
typedef struct sink {
    void (*put)(void *to, const char *bytes, size_t length);
    void *to;
} sink;

/* Different texts, numbered from 0 in the order of their first occurrence. */
/** The texts. Zeroed, there are none. */
typedef struct texts {
    text bytes;  /* one text after another, each with a newline behind it */
    size_t *end; /* for each text the index in `bytes` behind its newline */
    size_t count, capacity;
    slots numbers;
} texts;

void texts_clear(texts *t);
/** Find the number of a text, which has no newline; a new text is added. Returns 0 when out of
 * memory or if there are already 2^32 - 1 texts. */
int texts_number(uint32_t *out, texts *t, field one);
/** A text by its number. */
field texts_at(const texts *t, uint32_t number);

/* A table of answers in columns of one type each.
 *
 * Rows are added as values. Fields of further columns are kept as text only as long as their type
 * is open.
 */

typedef enum typed_kind {
    TYPED_DOUBLE, /* x, y, z and bounds: the nearest double */
    TYPED_PMC,    /* in, on, out */
    TYPED_CLASS,
    TYPED_DEFINITION, /* a number, or ext */
    TYPED_COUNT,      /* case, i, t */
    TYPED_WORD,       /* word, and answers that are a word */
    TYPED_NUMBER,     /* a further column with a number in every row */
    TYPED_TEXT        /* any other further column */
} typed_kind;

/* An answer that stands in front of the columns of the file. */
typedef struct answer_column {
    const char *name;
    typed_kind kind;
    int of_unsweep; /* 1: tables of unsweeps have the column too */
} answer_column;

enum { ANSWER_COLUMNS = 7 };

/** The answers, in the order of their columns. A table of pmc alone has only the first of them. */
extern const answer_column answer_columns[ANSWER_COLUMNS];

/* A column with the values of all rows in one of two arrays, `number` or `code`. */
typedef struct typed_column {
    field name; /* in the table's column line */
    typed_kind kind;
    size_t widest;  /* bytes of the column's longest field */
    double *number; /* DOUBLE, NUMBER */
    uint32_t *code; /* pmc and class as in graze.h; definition, 0 for ext; counts; else the number
                       of the text */
    size_t capacity;
    texts texts; /* WORD, TEXT */
    text fields; /* NUMBER: the fields, each with a newline, needed if a later one is no number */
} typed_column;

typedef struct typed_table {
    graze_context *context;
    int dimension;
    size_t grid[3];       /* points along each axis, 1 for z in the plane; all 0: no grid */
    fmpq low[3], high[3]; /* the grid's box, 0 for z in the plane */
    text names;           /* the names of the columns */
    size_t row_count, column_count;
    size_t own, last; /* the first `own` columns are coordinates and answers of Graze, the last
                         `last` answers too; the further columns between them are read as text */
    typed_column *column;
} typed_table;

/** An empty table without columns. typed_clear frees it. */
void typed_init(typed_table *t, graze_context *context);
void typed_clear(typed_table *t);

/** Tell that the rows are those of a grid, by its sizes and the corners of its box, d each. */
void typed_set_grid(typed_table *t, int dimension, const size_t *size, graze_rationals low,
                    graze_rationals high);

/** The word of a code of pmc or class; NULL for other columns. Static. */
const char *typed_word(const typed_column *c, uint32_t code);

/** The name of a column, `column` if it has none; a name that an earlier column has gets `_2`, `_3`
 * and so on behind it. */
void typed_name(text *out, const typed_table *t, size_t index);

/* Rows of values, read into typed columns. */

/** Set the columns of a table: `names` are those of its head, comma-joined, `last` the kinds of the
 * last columns, which are answers. */
graze_status typed_begin(typed_table *t, int dimension, field names, int pmc_alone,
                         const typed_kind *last, size_t last_count);
/**
 * Add rows of values. The rounding of the context has no effect: numbers of further columns do not
 * belong to the scene.
 * @return GRAZE_EINPUT the bytes are not whole rows of these columns, or a number is past binary64;
 * GRAZE_ELIMIT; GRAZE_ESYSTEM
 */
graze_status typed_add(typed_table *t, const char *rows, size_t length);

/* A typed table as a VTK file. */

/** Write the table as a legacy VTK file: a grid as structured points, else vertices. */
graze_status typed_write_vtk(const typed_table *t, sink to);

/* A typed table in one of its forms. */

/** Write a whole table in one of the binary forms. GRAZE_ELIMIT, GRAZE_ESYSTEM. */
graze_status typed_write(const typed_table *t, graze_format form, sink to);

/* Writes legacy VTK files, version 3.0, as text or binary.
 *
 * The parts of a file come in the order of these functions. Each part that has values is ended by
 * vtk_end. */

/** Numbers of VTK for kinds of cells. */
enum { VTK_VERTEX = 1, VTK_LINE = 3, VTK_TRIANGLE = 5, VTK_QUAD = 9, VTK_HEXAHEDRON = 12 };

typedef struct vtk {
    sink to;
    int binary; /* big-endian values, else decimals */
} vtk;

/** Write the lines before the data. `dataset`: UNSTRUCTURED_GRID or STRUCTURED_POINTS. */
void vtk_begin(const vtk *w, const char *title, const char *dataset);

/** Begin an array of `length` bytes in field data. */
void vtk_bytes_begin(const vtk *w, field name, size_t length);
/** Begin the points; vtk_point puts each. */
void vtk_points_begin(const vtk *w, size_t count);
void vtk_point(const vtk *w, const double at[3]);
/** vtk_point for d rationals: the nearest binary64, ties to even, and 0 for z in the plane.
 * GRAZE_EINPUT past its range. */
graze_status vtk_rational_point(const vtk *w, graze_context *context, const mpq_t *point,
                                int dimension);
/** Begin the cells; vtk_cell puts each. */
void vtk_cells_begin(const vtk *w, size_t count, size_t corners);
void vtk_cell(const vtk *w, const size_t *corner, size_t corners);
/** Put the type of each cell: all have one type. */
void vtk_cell_types(const vtk *w, size_t count, unsigned type);

/** Begin the data of points (POINT_DATA) or cells (CELL_DATA). */
void vtk_data_begin(const vtk *w, const char *of, size_t count);
/** Begin a column of `int` or `double`, whose values are put by vtk_int or vtk_double. Blanks in
 * its name become `_`. */
void vtk_scalars_begin(const vtk *w, field name, const char *type);
void vtk_int(const vtk *w, uint32_t value);
void vtk_double(const vtk *w, double value);

void vtk_end(const vtk *w);

#endif
