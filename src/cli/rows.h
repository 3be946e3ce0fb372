/* Rows of query points: taken from a file or a grid in blocks, read and answered by threads.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The first thread cuts a file into lines and does nothing else with them; a thread that answers
 * takes a run of rows, reads their numbers, classifies them and writes them into one text.
 */
#ifndef GRAZE_CLI_ROWS_H
#define GRAZE_CLI_ROWS_H

#include "cli/cli.h"
#include "cli/fields.h"

/** A block takes no further line once it holds that many rows or bytes. */
enum { BLOCK_ROWS = 1024, BLOCK_BYTES = 1 << 20 };

/** Why a row has no answer: an exit status and, unless it is EXIT_SIGNAL, a message for complain,
 * malloc'ed; NULL stands for memory that ran short. Zeroed: no fault. */
typedef struct fault {
    int status;
    char *message;
} fault;

/** Set a fault that is zeroed; returns `status`. */
int fault_set(fault *f, int status, const char *format, ...) __attribute__((format(printf, 3, 4)));
/** Complain of a fault; returns its exit status. */
int fault_tell(const fault *f);
void fault_clear(fault *f);

/** A line of a file: `start` counts bytes of its block. */
typedef struct line {
    size_t start, length;
    unsigned long number;
} line;

/** Neighbouring rows answered by one thread, at the place of the first of them. */
typedef struct row_run {
    size_t taken; /* rows; 0 until a thread takes them */
    size_t done;  /* rows the text holds */
    char *text;   /* for graze_free */
    size_t length;
    fault fault; /* why row `done` has no answer, where done < taken */
} row_run;

typedef struct block {
    unsigned long before; /* rows of earlier blocks */
    size_t count;
    char *bytes; /* the lines of a file, one after the other */
    size_t used, capacity;
    line lines[BLOCK_ROWS];
    row_run runs[BLOCK_ROWS];
    size_t next;         /* jobs: the first row that no thread has taken */
    size_t busy;         /* jobs: runs taken and not yet answered */
    struct block *after; /* jobs: the block handed over next */
} block;

block *block_create(void);
void block_destroy(block *b);
/** Take the answers away and empty the block, whose rows will come after `before` others. */
void block_reset(block *b, unsigned long before);
/** Add a line of a file; 0 when memory is short. */
int block_add(block *b, field text, unsigned long number);

/* -------------------------------------------------------------------------------- CSV files */

typedef struct csv csv;

/** What a thread reads rows with. The context is borrowed, the rest is freed by reader_clear. */
typedef struct reader {
    graze_context *context;
    fields cut;
    char *rest; /* further columns of the rows of a run, each with a NUL */
    size_t rest_length, rest_capacity;
} reader;

void reader_clear(reader *r);

/** Open a file, or standard input for `-`. The context is borrowed. On failure says why. */
int csv_open(csv **out, const char *path, int dimension, graze_context *context);
void csv_close(csv *c);
/**
 * Fill a block with the next rows; an empty block means the end. On an error, for which csv_fault
 * has the message, the rows before it are in the block. EXIT_SIGNAL when a signal came first.
 */
int csv_fill(csv *c, block *b);
/** 1 if csv_fill would return without waiting for its input. May read. */
int csv_ready(csv *c);
/** The error csv_fill met. */
const fault *csv_fault(const csv *c);
/**
 * Read row `index` of a block. Any thread may ask, once the columns are known.
 * @param[out] point as many initialised rationals as the points have coordinates
 * @param r          the further columns are added to `rest` where there are any
 * @return EXIT_DONE, or the status of the fault, which names file and line
 */
int csv_row(mpq_t *point, fault *f, const csv *c, reader *r, const block *b, size_t index);
/** 1 once the columns are known: a header or a first row has been read. */
int csv_started(const csv *c);
/** Names of the further columns, comma-joined, once the columns are known; NULL if none. */
const char *csv_columns(const csv *c);
/** 1 if both are the same file. */
int csv_same_file(const csv *c, const char *path);

/* -------------------------------------------------------------------------------------- grid */

typedef struct grid grid;

/** Read a value of --box into d initialised rationals each. On failure says why. */
int box_read(mpq_t *low, mpq_t *high, const char *text, int d, graze_context *context);
/** Read --grid and --box, or ask for the scene's box. On failure says why. */
int grid_open(grid **out, const options *o, graze_context *context, const graze_scene *scene);
void grid_close(grid *g);
/** Fill a block with the next points; an empty block means the end. */
void grid_fill(const grid *g, block *b);
/** Make `count` points from point `first` on, x running fastest. Any thread may ask. `points` has
 * room for three coordinates a point and uses as many as there are, point after point. */
void grid_points(mpq_t *points, const grid *g, unsigned long first, size_t count);
/** `# grid` and `# box` lines, malloc'ed; NULL when out of memory. */
char *grid_notes(const grid *g);

/* -------------------------------------------------------------------------------------- jobs */

/** Where the rows of the blocks come from: one is NULL. */
typedef struct row_source {
    const csv *points;
    const grid *grid;
} row_source;

typedef struct jobs jobs;

/** Start `count` threads, each with a context of its own. On failure says why. */
int jobs_start(jobs **out, const options *o, const graze_scene *scene, row_source source,
               int count);
/** Hand a block over; it is answered after those before it and must stay until jobs_wait. */
void jobs_submit(jobs *j, block *b);
/** Wait until all rows of a block are answered, or those a signal leaves time for. */
void jobs_wait(jobs *j, const block *b);
/** End all threads, after the runs they are at. NULL is harmless. */
void jobs_stop(jobs *j);

#endif
