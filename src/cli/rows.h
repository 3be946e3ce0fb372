/* Rows of query points: taken from a file or a grid in blocks, read and answered by threads.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The first thread cuts a file into lines and does nothing else with them; a thread that answers
 * takes a run of rows, reads their numbers, classifies them and writes them into one text.
 */
#ifndef GRAZE_CLI_ROWS_H
#define GRAZE_CLI_ROWS_H

#include "cli/columns.h"
#include "cli/progress.h"

/* -------------------------------------------------------------------------------- CSV files */

typedef struct csv csv;

/** Open a file, or standard input for `-`, of which the rows of a shard are wanted. The context is
 * borrowed. On failure says why. */
int csv_open(csv **out, const char *path, int dimension, shard part, graze_context *context);
void csv_close(csv *c);
/**
 * Fill a block with the next rows, at most `most`; an empty block means the end. On an error, for
 * which csv_fault has the message, the rows before it are in the block. EXIT_SIGNAL when a signal
 * came first.
 */
int csv_fill(csv *c, block *b, unsigned long most);
/** 1 if csv_fill would return without waiting for its input. May read. */
int csv_ready(csv *c);
/** The error csv_fill met. */
const fault *csv_fault(const csv *c);
/** The columns, fixed once a header or a first row has been read. */
const columns *csv_columns(const csv *c);
/** 1 if both are the same file. */
int csv_same_file(const csv *c, const char *path);
/** How much of the file is read; of a pipe nobody knows. */
portion csv_portion(const csv *c);
/** Rows read so far, those of other shards too, and a checksum of their text. */
unsigned long csv_rows(const csv *c);
unsigned long long csv_checksum(const csv *c);

/* -------------------------------------------------------------------------------------- grid */

typedef struct grid grid;

/** Read a value of --box into d initialised rationals each. On failure says why. */
int box_read(mpq_t *low, mpq_t *high, const char *text, int d, graze_context *context);
/** Read --grid and --box, or ask for the scene's box. On failure says why. */
int grid_open(grid **out, const options *o, graze_context *context, const graze_scene *scene);
void grid_close(grid *g);
/** The number of its points. */
unsigned long grid_count(const grid *g);
/** Fill a block with a shard's next points, at most `most`; an empty block means the end. */
void grid_fill(const grid *g, shard part, block *b, unsigned long most);
/** Make `count` points of a shard from its point `first` on, x running fastest in the whole grid.
 * Any thread may ask. `points` has room for three coordinates a point and uses as many as there
 * are, point after point. */
void grid_points(mpq_t *points, const grid *g, shard part, unsigned long first, size_t count);
/** `# grid` and `# box` lines, malloc'ed; NULL when out of memory. */
char *grid_notes(const grid *g);

/* ----------------------------------------------------------------------------------- answers */

/** Where the rows of the blocks come from: one is NULL. */
typedef struct row_source {
    const columns *columns;
    const grid *grid;
    shard part;
} row_source;

/** As many rows as one run has at the most. */
enum { RUN_ROWS = 64 };

/** What a thread answers rows with. Its context is its own. */
typedef struct answerer {
    const graze_scene *scene;
    row_source source;
    graze_format format;
    graze_context *context;
    reader reader;
    mpq_t points[3 * RUN_ROWS];
    size_t rest_at[RUN_ROWS];
    const char *rest[RUN_ROWS];
} answerer;

/** Make an answerer; answerer_clear frees it in either case. On failure says why. */
int answerer_init(answerer *a, const options *o, const graze_scene *scene, row_source source);
void answerer_clear(answerer *a);
/** Answer the run that begins at row `first` of a block; its `taken` rows are set. */
void answer(answerer *a, block *b, size_t first);

/* -------------------------------------------------------------------------------------- jobs */

typedef struct jobs jobs;

/** How many answer rows at one time. */
int jobs_width(const options *o);
/** Start the threads, each with a context of its own. On failure says why. */
int jobs_start(jobs **out, const options *o, const graze_scene *scene, row_source source);
/** Hand a block over; it is answered after those before it and must stay until jobs_wait. */
void jobs_submit(jobs *j, block *b);
/** Wait until all rows of a block are answered, or those a signal leaves time for. */
void jobs_wait(jobs *j, const block *b);
/** End all threads, after the runs they are at. NULL is harmless. */
void jobs_stop(jobs *j);

#endif
