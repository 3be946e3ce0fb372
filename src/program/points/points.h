/* points: query points from files and grids, in blocks of rows, and their columns in tables.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_PROGRAM_POINTS_H
#define GRAZE_PROGRAM_POINTS_H

#include <graze.h>
#include "base/context/slots.h"
#include "base/number/text.h"
#include "input/delimited/delimited.h"
#include "output/table/table.h"
#include "program/io/io.h"

/* The lines of the two files that a run makes: a table, and a certificate. */

typedef enum result_kind { RESULT_TABLE, RESULT_CERTIFICATE, RESULT_KINDS } result_kind;

/** "table" or "certificate". */
const char *result_name(result_kind kind);
/** The text before the key of a note and of the last line: "# " in a table. */
const char *result_mark(result_kind kind);

/** Kinds of lines. A row of a table is one line; a row of a certificate goes on in the lines of its
 * intervals and contacts (LINE_OF_ROW). */
typedef enum line_part { LINE_ROW, LINE_OF_ROW, LINE_NOTE } line_part;

/** The kind of a line behind the head. */
line_part line_part_of(result_kind kind, field line);
/** Is the line the last one of the head? */
int line_ends_head(result_kind kind, field line);
/** Find the value of a note with this key; 0 if the line is no such note. */
int line_note(field *value, result_kind kind, field line, const char *key);

/* Blocks of rows on their way from a file or a grid through the threads to the table, and faults.
 */

/** A block is full with BLOCK_ROWS rows or BLOCK_BYTES bytes; a run has at most RUN_ROWS rows. */
enum { BLOCK_ROWS = 1024, BLOCK_BYTES = 1 << 20, RUN_ROWS = 64 };

/** Why a row has no answer: an exit status (src/program/io/io.h) and, unless it is EXIT_SIGNAL, a
 * message for complain, malloc'ed; NULL stands for memory that ran short. Zeroed: no fault. */
typedef struct fault {
    int status;
    char *message;
} fault;

/** Set a fault, which is zeroed before; returns `status`. */
int fault_set(fault *f, int status, const char *format, ...) __attribute__((format(printf, 3, 4)));
/** Set a fault to the context's message. Its status is exit_for(status, otherwise), or EXIT_SIGNAL
 * for a cancel. */
int fault_of(fault *f, graze_status status, const graze_context *context, int otherwise);
/** Complain of a fault; returns its exit status. */
int fault_tell(const fault *f);
void fault_clear(fault *f);

/** A line of a file: `start` counts bytes of its block. */
typedef struct line {
    size_t start, length;
    unsigned long number;
} line;

/** Neighbouring rows that one thread answers; block.runs has it at the index of its first row. */
typedef struct row_run {
    graze_row_totals totals; /* of the rows that are done */
    size_t taken;            /* number of rows of the run; 0 until a thread takes them */
    size_t done;             /* number of rows of the run that the texts hold */
    struct row_text {
        char *text; /* for graze_free; NULL where none is wanted */
        size_t length;
    } out[RESULT_KINDS];
    fault fault; /* why row `done` has no answer, where done < taken; EXIT_SIGNAL until answered */
} row_run;

typedef struct block {
    unsigned long before; /* the shard's rows of earlier blocks */
    size_t count;
    char *bytes; /* the lines of a file, one after the other */
    size_t used, capacity;
    line lines[BLOCK_ROWS];
    unsigned long long points[BLOCK_ROWS]; /* checksum of the points up to each row; 0 for a grid */
    row_run runs[BLOCK_ROWS];
    size_t next;         /* jobs: the first row that is not taken */
    size_t busy;         /* jobs: runs taken and not yet answered */
    struct block *after; /* jobs: the block handed over next */
} block;

block *block_create(void);
void block_destroy(block *b);
/** Free the answers and empty the block; `before` rows of the shard come before its next rows. */
void block_reset(block *b, unsigned long before);
/** Add a line of a file; 0 when memory is short. */
int block_add(block *b, field text, unsigned long number);

/** Rows that are contact points: each has a time before the coordinates, and with `snap` a cell.
 * The coordinates are those of y in the solid's frame or, if `in_world`, those of P = M(t) y. */
typedef struct site_form {
    int wanted, snap; /* the options ask for contact points, for points moved to contacts */
    int dimension, in_world;
    size_t cell;   /* the column of the cell */
    char *carried; /* 1 for each column that is carried along */
} site_form;

/** Rows that are pairs of solids: their columns; a file has the first three, and may have others.
 */
enum {
    PAIR_MOVING,
    PAIR_MOTION,
    PAIR_FIXED,
    PAIR_MOTION_OF_FIXED,
    PAIR_ID,
    PAIR_CLEARANCE,
    PAIR_INSIDE,
    PAIR_MOTION_ERROR,
    PAIR_COLUMNS,
    PAIR_FILES = PAIR_ID
};
typedef struct pair_form {
    int wanted;
    size_t where[PAIR_COLUMNS]; /* SIZE_MAX: there is no such column */
} pair_form;

/* The columns of a file of points: places of the coordinates, names of the others. */

/** Columns with answers in a file that graze classify has written; they are not carried along. */
typedef struct own_columns {
    size_t first, end; /* columns `first` to `end` - 1 are answers */
    size_t last;       /* so are the last `last` columns, of options such as --sdf and --topo */
} own_columns;

/** The columns. `count` is 0 until the file's first line fixes them; nothing changes afterwards. */
typedef struct columns {
    const char *name; /* name of the file, for messages; borrowed */
    int dimension;
    int numbers; /* numbers of a row: the dimension, for contact points one more */
    site_form sites;
    pair_form pairs;
    size_t count;
    size_t where[4]; /* columns of the numbers: x, y, z, or time, x, y, z */
    char separator;  /* between fields of this file; tables that are written have commas */
    own_columns own;
    char *others; /* names of the further columns, comma-joined; NULL if none */
} columns;

/** Working memory of a thread that reads rows. The context is borrowed, the rest is freed by
 * reader_clear. */
typedef struct reader {
    graze_context *context;
    fields cut;
    graze_cell cell; /* cell of the row read last, if rows have cells */
    text rest;       /* further columns of the rows of a run, each with a NUL */
} reader;

void reader_clear(reader *r);

/**
 * Names of the further columns in a table. To a name that the table already has, `_in` is appended
 * until the table does not have the name; a note on standard error says so.
 * @param own the table's own column line
 * @return malloc'ed; NULL when out of memory, or where there are no further columns
 */
char *columns_free_names(const columns *c, field own);

/** Append a field in quotes, in which quotes are doubled. */
void put_quoted(text *out, field one);
/** Append a field of the file as a field of a table, whose separator is the comma. */
void columns_put_field(text *out, const columns *c, field one);

/**
 * Read a line of a block. Any thread may ask, once the columns are fixed.
 * @param[out] point one initialised rational per number of a row
 * @param r          the row's further columns, if there are any, are added to its `rest`
 * @return EXIT_DONE, or the status of the fault, which names file and line
 */
int columns_row(mpq_t *point, fault *f, const columns *c, reader *r, const block *b, size_t index);

/* Forms in which tables write the coordinates of points: --coordinates and --digits. */

typedef enum coordinate_form {
    COORDINATES_EXACT,
    COORDINATES_AS_GIVEN,
    COORDINATES_DECIMAL,
    COORDINATES_UNSET /* the command chooses */
} coordinate_form;

/** Zeroed: integers and ratios in lowest terms. */
typedef struct coordinate_options {
    coordinate_form form;
    int digits; /* digits of rounded decimals; 0: decimals are exact */
} coordinate_options;

/** Check that --digits goes with --coordinates. Returns an exit status and says what is wrong. */
int coordinates_check(const coordinate_options *o);

/** Room for coordinates_note. */
enum { COORDINATES_NOTE = 64 };

/** Write the line `# coordinates ...` of a table's head; nothing for exact coordinates. */
void coordinates_note(char out[COORDINATES_NOTE], const coordinate_options *o);

/**
 * Add a point's coordinates.
 * @param tokens a field for each coordinate, as it was read; used only by COORDINATES_AS_GIVEN
 * @return EXIT_DONE, or the status of the fault, whose message begins with `where`
 */
int coordinates_put(text *out, fault *f, const coordinate_options *o, graze_context *context,
                    mpq_t *point, int dimension, const field *tokens, const char *where);

/* Shards: the rows of one run dealt out to several.
 *
 * Rows are dealt like cards, one to each shard in turn: shard i of n has the rows i, i + n, i +
 * 2n, ... of the whole run, counted from 1. So the number of rows need not be known, easy and hard
 * regions are shared evenly, and merging takes rows from the shards in turn. */

/** The note that names the shard in the head of its table or certificate. */
#define SHARD_LINE "shard "
/** In a shard's file, the key of the checksum of all bytes before this line. */
#define SHARD_BYTES "bytes-checksum "
/** The key of the last line; the number of the file's rows stands behind it. */
#define COMPLETE_LINE "complete "

/** The last lines of a table or a certificate: `undecided` if rows may be undecided; for a shard
 * the number of rows of all shards, a checksum of their points (0 for a grid) and a checksum of all
 * bytes before it; and `complete`. */
typedef struct last_lines {
    int counts_undecided, of_shard;
    unsigned long undecided, rows_of_all, rows;
    unsigned long long points, bytes;
} last_lines;

/** Append the last lines before the checksum of bytes (begin), and those from it on (end). */
void last_lines_begin(text *out, result_kind kind, const last_lines *l);
void last_lines_end(text *out, result_kind kind, const last_lines *l);
/** Read the last lines at the end of a shard's file; 0 if it does not end with them, -1: out of
 * memory. */
int last_lines_read(last_lines *out, result_kind kind, const char *tail);

/** Shard `index`, from 0, of `count`; with `count` 1 it is the whole run. */
typedef struct shard {
    unsigned long index, count;
} shard;

/** The most shards a run is cut into. */
enum { SHARDS_MOST = 100000 };

/** Read `i/n`, 1 <= i <= n; 0 if the text does not have this form. */
int shard_read(shard *out, const char *text);

/** The place in the whole run of the shard's row `row`; both from 0. */
unsigned long shard_place(shard s, unsigned long row);

/** How many of the first `rows` rows of the whole run are the shard's. */
unsigned long shard_rows(shard s, unsigned long rows);

/* Grids of query points. */

/** The values of --grid and --box; NULL where not given. */
typedef struct grid_options {
    const char *sizes, *box;
} grid_options;

typedef struct grid {
    int dimension;
    size_t size[3];
    unsigned long count; /* of its points */
    mpq_t low[3], high[3];
    graze_grid *points;
} grid;

/** Read a value of --box into two corners of d initialised rationals each. On failure says why. */
int box_read(mpq_t *low, mpq_t *high, const char *text, int d, graze_context *context);
/** Make the grid of these options, in the box of the scene unless one is given. On failure says
 * why; `*out` is to be closed in either case. */
int grid_open(grid **out, const grid_options *o, graze_context *context, const graze_scene *scene);
void grid_close(grid *g);
/** Fill a block with a shard's next points, at most `most`; an empty block means the end. */
void grid_fill(const grid *g, shard part, block *b, unsigned long most);
/** Add the lines `# grid` and `# box`. */
void grid_notes(text *out, const grid *g);

/* Files of query points, cut into lines and handed out in blocks.
 *
 * The first thread cuts a file into lines and does nothing else with them; columns.c reads them. */

/** Facts from the `#` lines at the beginning of a file: whether Graze has written it, and with
 * which answers. */
typedef struct columns_head {
    int graze, unsweep, pmc_alone;
    unsigned sets; /* bits of columns_of_line */
} columns_head;

typedef struct npy npy;

typedef struct csv {
    stream in;
    fault fault;     /* the error that csv_fill met */
    columns columns; /* fixed once a header or a first row has been read */
    columns_head head;
    shard part;
    unsigned long rows; /* rows of all shards, so far */
    checksum sum;       /* of the line of names and of these rows */
    unsigned long size; /* bytes of the file; 0 for a pipe */
    int is_array;       /* 1: a .npy file, whose head is read with its first row */
    npy *array;
} csv;

/** Open a file, or standard input for `-`, for the rows of a shard; or, unless it is
 * NULL, read a text in memory, which is borrowed and which `path` names. The context is borrowed.
 * On failure says why. */
int csv_open(csv **out, const char *path, const char *in_memory, int dimension, shard part,
             graze_context *context);
void csv_close(csv *c);
/** Expect contact points as rows; with `snap` they have cells, to be moved to contacts. To be
 * called before the first line is read. */
void csv_expect_sites(csv *c, int snap);
/** Expect pairs as rows, likewise. */
void csv_expect_pairs(csv *c);
/**
 * Fill a block with the next rows, at most `most`; an empty block means the end. On an error the
 * block has the rows before it, and `fault` the message. EXIT_SIGNAL if a signal came.
 */
int csv_fill(csv *c, block *b, unsigned long most);
/** 1 if csv_fill would return without waiting for its input. May read. */
int csv_ready(csv *c);
/** The bytes read and the bytes of the file; the latter are 0 for a pipe. */
portion csv_portion(const csv *c);

/* Points that differ from all before them, and strata that have no further points. */
/** A set of points. Zeroed it is empty; distinct_clear frees it. */
typedef struct distinct {
    slots seen;
    unsigned idle;  /* number of repeated points since the last new one */
    unsigned spent; /* strata that gave too many repeated points: a set of 1 << graze_stratum */
    int is_wanted, failed; /* failed: memory has run short */
    graze_stratum wanted;  /* if is_wanted: the stratum of the last point, a repeated one */
    unsigned tries;        /* number of tries at another point of this stratum */
    unsigned passed;       /* number of points of other strata passed over meanwhile */
} distinct;

/** Is a point of a stratum to be taken? After a repeated point, some points of other strata are
 * passed over until its stratum gives another one, so that each stratum keeps its share. */
int distinct_wants(distinct *d, graze_stratum stratum);
/** Add a point of a stratum; 1 if it differs from all points before it. Points are compared as they
 * are written, by hashes of 64 bits: an equal hash counts as an equal point. */
int distinct_add(distinct *d, graze_stratum stratum, const char *point, size_t length);
/** Were the last points all repeated ones, enough of them to make further tries useless? */
int distinct_is_over(const distinct *d);
void distinct_clear(distinct *d);

#endif
