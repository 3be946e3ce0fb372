/* Rows of two tables, by their points.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_COMPARE_ROWS_H
#define GRAZE_OUTPUT_COMPARE_ROWS_H

#include <stdint.h>
#include "output/compare/compare.h"

/* A table of answers as a stream of rows: golden or a candidate's.
 *
 * Invariant: once opened, the `#` lines before the column line and the columns are known; every
 * row handed out has one field per column. */

/** Keys of `#` lines that a comparison uses. */
typedef enum note {
    NOTE_GRAZE,
    NOTE_DIMENSION,
    NOTE_SOLID,
    NOTE_MOTION,
    NOTE_SCENE,
    NOTE_AT_REST,
    NOTE_OPERATION,
    NOTE_FOLDS,
    NOTE_ROUND,
    NOTE_TRIANGULATE,
    NOTE_COLUMNS,
    NOTE_DIAGONAL,
    NOTE_COUNT
} note;

/** A table that is read. */
typedef struct table {
    stream in;
    char *notes[NOTE_COUNT];  /* values of `#` lines; NULL where there is none */
    unsigned sets;            /* bits of columns_of_line: the options that were given */
    int dimension;            /* of the points; 0 without columns x and y */
    long where[COLUMN_COUNT]; /* -1 where there is no such column */
    size_t columns;
    unsigned long head; /* the line of the column line */
    int doubled;        /* the first column of contact points that is there twice, or -1 */
    char *names;        /* the column line */
    unsigned long rows; /* handed out */
    int complete;       /* 1 once `# complete N` has been read, and N is the number of rows */
} table;

/** Fail with GRAZE_EINPUT at a line of a table, or at none if it is 0. */
#define table_fail(t, line, ...)                                                                   \
    context_fail_in((t)->in.context, GRAZE_EINPUT, (t)->in.name, line, __VA_ARGS__)

/** Differences of coordinates over the rows counted so far. Tables are borrowed. */
typedef struct drift {
    const table *golden, *candidate;
    row_key axes;       /* coordinates that both tables have */
    unsigned long rows; /* pairs of rows whose points differ */
    fmpq *farthest;     /* the greatest difference of a coordinate; least and most follow it */
    fmpq *least, *most; /* bounds of golden coordinates in pairs that are written differently */
    int any;            /* 1: some pair is written differently */
} drift;

/** The first 128 bits of a SHA-256 hash, by which equal points and answers are found. */
typedef struct digest {
    uint64_t high, low;
} digest;

/** A row with bytes of its own. */
typedef struct table_row {
    unsigned long line; /* in the file */
    char *bytes;
    size_t capacity;
    fields cut;
    int keyed;  /* 1 once `key` is known */
    digest key; /* of the row's id, or of its point and, for contact points, time */
} table_row;

/** The name of a column, and names of `#` lines. */
const char *column_name(column c);
extern const char *const note_names[NOTE_COUNT];
/** The first column of an option of graze classify. */
column column_of(const char *option);

/** Open a table and read to its column line. table_clear frees it in either case. `path` is
 * borrowed.
 * @return GRAZE_EINPUT there is no column line, or it names a column twice; also as stream_next */
graze_status table_open(table *out, graze_context *context, const char *path);
void table_clear(table *t);

/** Read the next row. *more is 0 at the end of the table.
 * @return GRAZE_EINPUT another number of fields, a quote not closed, a wrong `# complete N`, rows
 * after it; also as stream_next */
graze_status table_next(table *t, table_row *row, int *more);
void table_row_clear(table_row *row);

/** GRAZE_EINPUT: the column line names a column twice. */
graze_status table_named_twice(const table *t, column c);

/** Room for table_meant. */
enum { TABLE_MEANT = 112 };
/** Set `; did you mean NAME by 'COLUMN'?` for the first column whose name is nearly one of `count`
 * names; an empty text if there is none. */
void table_meant(char out[TABLE_MEANT], const table *t, const char *const *names, size_t count);

/** A row as it stands in the file, malloc'ed; NULL when out of memory. */
char *table_row_text(const table_row *row);

/** A field of a row; empty where the table has no such column. */
field table_field(const table *t, const table_row *row, column c);

/** Read a number in a column, rounded as the context says. GRAZE_EINPUT, GRAZE_ELIMIT. */
graze_status table_rational(fmpq_t out, const table *t, const table_row *row, column c);
/** Read a number exactly, whatever the context's rounding. Statuses of rational_parse. */
graze_status table_number(fmpq_t out, graze_context *context, field f);

/** The digest of bytes. */
digest digest_of(const char *bytes, size_t length);
int digest_equal(digest a, digest b);

/* Keys by which the rows of two tables are matched.
 *
 * The key of a row is its id (by value if it is a number), or its point in lowest terms after
 * rounding; the key of a contact point is its time and its point. */

/** Coordinates x, y (and z) of points that both tables have; none if one of them lacks any. */
void key_of_axes(row_key *out, const table *golden, const table *candidate);

/** Check that the columns of a row's key are numbers; a time may be `root(...)`. GRAZE_EINPUT. */
graze_status key_check(const row_key *key, const table *t, const table_row *row);

/** Make the digest of a row's key. GRAZE_EINPUT, GRAZE_ELIMIT. */
graze_status key_make(table_row *row, const row_key *key, const table *t);

/* An index of all rows of a table by their keys, for rows in any order.
 *
 * Rows with equal keys are handed out in the order of the table. */

/** A row that is kept. */
typedef struct kept_row {
    unsigned long line; /* in the file */
    char *text;         /* malloc'ed; NULL once it is handed out */
    size_t next;        /* the next row of its key, or SLOTS_NONE */
} kept_row;

/** The rows of a key that are not yet handed out; `first` is SLOTS_NONE if there are none. */
typedef struct key_rows {
    digest key;
    size_t first, last;
} key_rows;

/** The index; zeroed at first. */
typedef struct row_index {
    table *table;
    slots slots; /* of the keys */
    key_rows *keys;
    kept_row *rows; /* in the order of the table */
    size_t key_capacity, count, capacity;
    size_t next;  /* for row_index_rest: all rows before it are handed out */
    table_row at; /* the row handed out last */
} row_index;

/** Read the rest of a table. GRAZE_EINPUT, GRAZE_ELIMIT, GRAZE_ESYSTEM, GRAZE_ECANCELED. */
graze_status row_index_read(row_index *out, table *t, const row_key *key);

/** The next row of a key; NULL if none is left. Borrowed until the next call. */
graze_status row_index_take(row_index *x, const table_row **out, digest key);

/** The next row that is not handed out, in the order of the table; NULL at the end. Borrowed until
 * the next call. */
graze_status row_index_rest(row_index *x, const table_row **out);

void row_index_clear(row_index *x);

/* Matches the rows of the candidate with those of the golden table. */

enum { MATCH_AHEAD = 1000 };

/** Rows read and not yet matched, oldest first, in a ring. */
typedef struct row_window {
    table *table;
    size_t first, count;
    int ended;
    table_row rows[MATCH_AHEAD];
} row_window;

typedef struct match {
    graze_context *context;
    row_key key;
    match_way way;
    int indexed; /* 1: the candidate's rows are in `index` */
    row_index index;
    int sites;   /* 1: rows are contact points */
    drift drift; /* over pairs that were not matched by their points */
    row_window golden, candidate;
    size_t skip_golden, skip_candidate; /* rows to hand out alone before the next pair */
    digest missing, extra;              /* sums of the keys of rows handed out alone */
    unsigned long pairs, missing_count, extra_count;
} match;

/** Start a matching. match_clear frees it in any case, and also takes a zeroed one. */
void match_start(match *m, graze_context *context, table *golden, table *candidate,
                 const row_key *key, match_way way, int sites);
void match_clear(match *m);

/**
 * Hand out the next pair of rows. One is NULL if the other has no counterpart; both are NULL at the
 * end of both tables. Borrowed until the next call.
 * @return GRAZE_EINPUT a coordinate or a time is no number
 */
graze_status match_next(match *m, const table_row **golden, const table_row **candidate);

/** At the end of a matching: another way that may give more rows a counterpart, or else the way
 * that was taken. */
match_way match_better(const match *m);

/** Check a matching at its end. GRAZE_EINPUT: no row has a counterpart; the rows without a
 * counterpart are the same in both tables, in another order; tables without keys differ in their
 * numbers of rows; rows with one id have different points. */
graze_status match_finish(const match *m);

/* Choice of a comparison: the kind of tables, the columns judged, the key of rows, the groupings.
 */

/** Choose the columns to judge and those to match rows by, and take over the golden table's
 * options.
 * @return GRAZE_EINPUT the tables do not go together, or lack columns; GRAZE_ESYSTEM */
graze_status comparison_choose(graze_comparison *c, const table *golden, const table *candidate);

/** The golden column of each grouping, whose name is the grouping's, and a longer name for the head
 * of a table. BY_SDF stands for the candidate's column. */
extern const struct grouped {
    column of;
    const char *title;
} groupings[GROUPING_COUNT];
/** Does the golden table have the column of a grouping, and do tables of its kind have the
 * grouping?
 */
int grouping_is_of(const graze_comparison *c, const table *golden, grouping g);

/* Golden rows that rounding makes equal. */

/**
 * Refuse two golden rows that rounding makes equal and whose answers in `columns` differ. The table
 * is read again, several times if digests would take more than 160 MB.
 * @param key     columns of numbers
 * @param columns count columns whose answers matter
 */
graze_status match_rounding(graze_context *context, const table *golden, const char *path,
                            const row_key *key, const column *columns, size_t count);

#endif
