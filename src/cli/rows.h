/* Rows of query points: read or made in blocks, answered by threads.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_ROWS_H
#define GRAZE_CLI_ROWS_H

#include "cli/cli.h"

enum { BLOCK_ROWS = 1024 };

/** One row. `text` is NULL until the row is answered, and stays so when `status` says why not. */
typedef struct row {
    mpq_t point[3];
    char *rest; /* the further columns as they were, malloc'ed, or NULL */
    char *text; /* the answer, for graze_free */
    graze_status status;
    char *message; /* malloc'ed; with a status that is not GRAZE_OK */
} row;

typedef struct block {
    size_t count;
    row rows[BLOCK_ROWS];
} block;

block *block_create(void);
void block_destroy(block *b);
/** Free the texts of the rows and set the count to 0. */
void block_reset(block *b);

/* -------------------------------------------------------------------------------- CSV files */

typedef struct csv csv;

/** Open a file, or standard input for `-`. The context is borrowed. On failure says why. */
int csv_open(csv **out, const char *path, int dimension, graze_context *context);
void csv_close(csv *c);
/**
 * Fill a block with the next rows; an empty block means the end. On an error says file and line;
 * the rows before it are in the block. EXIT_SIGNAL when a signal came first.
 */
int csv_fill(csv *c, block *b);
/** 1 once the columns are known: a header or a first row has been read. */
int csv_started(const csv *c);
/** Names of the further columns, comma-joined, once a block has been filled; NULL if none. */
const char *csv_columns(const csv *c);
/** 1 if both are the same file. */
int csv_same_file(const csv *c, const char *path);

/* -------------------------------------------------------------------------------------- grid */

/** A grid of points, x running fastest, both ends included. */
typedef struct grid {
    int dimension;
    unsigned long size[3];
    mpq_t low[3], high[3];
    unsigned long next, count;
} grid;

/** Read --grid and --box, or ask for the scene's box. On failure says why. */
int grid_open(grid **out, const options *o, graze_context *context, const graze_scene *scene);
void grid_close(grid *g);
void grid_fill(grid *g, block *b);
/** `# grid` and `# box` lines, malloc'ed; NULL when out of memory. */
char *grid_notes(const grid *g);

/* -------------------------------------------------------------------------------------- jobs */

typedef struct jobs jobs;

/** Start `count` threads, each with a context of its own. On failure says why. */
int jobs_start(jobs **out, const options *o, const graze_scene *scene, int count);
/** Answer all rows of a block, or those a signal leaves time for. */
void jobs_answer(jobs *j, block *b);
void jobs_stop(jobs *j);

#endif
