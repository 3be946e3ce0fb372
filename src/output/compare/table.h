/* A table of answers as a stream of rows: golden or a candidate's.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant: once opened, the `#` lines before the column line and the columns are known; every row
 * handed out has one field per column.
 */
#ifndef GRAZE_COMPARE_TABLE_H
#define GRAZE_COMPARE_TABLE_H

#include <flint/fmpq.h>
#include <stdint.h>
#include "input/delimited/field.h"
#include "input/delimited/stream.h"

/** Columns that a comparison uses; others are skipped. Those from COLUMN_TIME on are of tables of
 * contact points. */
typedef enum column {
    COLUMN_X,
    COLUMN_Y,
    COLUMN_Z,
    COLUMN_ID,
    COLUMN_PMC,
    COLUMN_CLASS,
    COLUMN_DEFINITION,
    COLUMN_CASE,
    COLUMN_I,
    COLUMN_T,
    COLUMN_WORD,
    COLUMN_TOPO,
    COLUMN_STRATUM,
    COLUMN_ORDER,
    COLUMN_CELL,
    COLUMN_K,
    COLUMN_SDF,
    COLUMN_SDF_LOW,
    COLUMN_SDF_HIGH,
    COLUMN_TIME,
    COLUMN_BX,
    COLUMN_BY,
    COLUMN_BZ,
    COLUMN_ROLE,
    COLUMN_THETA,
    COLUMN_CONTACT_ORDER,
    COLUMN_ORIENTATION,
    COLUMN_LEFT,
    COLUMN_RIGHT,
    COLUMN_TRIMMED,
    COLUMN_STATUS,
    COLUMN_NEAR,
    COLUMN_NEAR_IN,
    COLUMN_SHIFT,
    COLUMN_COUNT
} column;

/** Keys of `#` lines that a comparison uses. */
typedef enum note {
    NOTE_GRAZE,
    NOTE_DIMENSION,
    NOTE_SOLID,
    NOTE_MOTION,
    NOTE_SCENE,
    NOTE_OPERATION,
    NOTE_FOLDS,
    NOTE_ROUND,
    NOTE_TRIANGULATE,
    NOTE_COLUMNS,
    NOTE_SDF,
    NOTE_DIAGONAL,
    NOTE_COUNT
} note;

/** The first 128 bits of a SHA-256, to find equal points and answers. */
typedef struct digest {
    uint64_t high, low;
} digest;

/** A row with bytes of its own. */
typedef struct table_row {
    unsigned long line, number; /* in the file, and among the rows, from 1 */
    char *bytes;
    size_t capacity;
    fields cut;
    int keyed;  /* 1 once `key` is known */
    digest key; /* of the row's id, or of its point and, for contact points, time */
} table_row;

typedef struct table {
    stream in;
    char *notes[NOTE_COUNT];  /* values of `#` lines; NULL where there is none */
    int dimension;            /* of the points; 0 without columns x and y */
    long where[COLUMN_COUNT]; /* -1 where there is no such column */
    size_t columns;
    unsigned long head; /* the line of the column line */
    int doubled;        /* the first column of contact points whose name stands twice, or -1 */
    char *names;        /* the column line */
    unsigned long rows; /* handed out */
    int complete;       /* 1 once `# complete N` has been read, and N is the number of rows */
} table;

/** The name of a column or of a `#` line. */
const char *column_name(column c);
const char *note_name(note n);

/** Open a table and read up to its columns. table_close in either case. `path` is borrowed.
 * @return GRAZE_EINPUT no column line, or a name in it twice; also those of stream_next */
graze_status table_open(table *out, graze_context *context, const char *path);
void table_close(table *t);

/** Read the next row. *more is 0 at the end of the table.
 * @return GRAZE_EINPUT another number of fields, a quote not closed, a wrong `# complete N`, rows
 * after it; also those of stream_next */
graze_status table_next(table *t, table_row *row, int *more);
void table_row_clear(table_row *row);

/** GRAZE_EINPUT: the column line names a column twice. */
graze_status table_named_twice(const table *t, column c);

/** Room for table_meant. */
enum { TABLE_MEANT = 112 };
/** `; did you mean NAME by 'COLUMN'?` of the first column that is nearly one of `count` names; else
 * nothing. */
void table_meant(char out[TABLE_MEANT], const table *t, const char *const *names, size_t count);

/** A row as it stands in the file, malloc'ed; NULL when out of memory. */
char *table_row_text(const table_row *row);

/** A field of a row; empty where the table has no such column. */
field table_field(const table *t, const table_row *row, column c);

/** A number as it is written, whatever rounding the context asks for. Those of rational_parse. */
graze_status table_number(fmpq_t out, graze_context *context, field f);

/** The digest of bytes. */
digest digest_of(const char *bytes, size_t length);
int digest_equal(digest a, digest b);

#endif
