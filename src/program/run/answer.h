/* Runs of rows answered: their numbers read, their points classified, all of it written as one
 * text. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_ANSWER_H
#define GRAZE_RUN_ANSWER_H

#include "program/run/columns.h"
#include "program/run/coordinates.h"
#include "program/run/grid.h"
#include "program/run/load.h"

/** Source of the rows of the blocks: one is NULL. */
typedef struct row_source {
    const columns *columns;
    const grid *grid;
    shard part;
    coordinate_options coordinates; /* form in which their points are written */
} row_source;

/** Common data of all answerers. All is borrowed, and only read. */
typedef struct answer_task {
    const context_options *context;
    const graze_scene *scene;
    const graze_certifier *certifier; /* NULL: no certificate is wanted */
    int no_table;                     /* a certificate alone is */
    const graze_row_options *rows;
    row_source source;
    int one_by_one; /* no points of a grid are decided together: the solid is curved */
} answer_task;

/** The state of one thread that answers rows. Its context is its own. */
typedef struct answerer {
    answer_task task;
    graze_context *context;
    reader reader;
    mpq_t points[4 * RUN_ROWS];
    graze_cell cell[RUN_ROWS]; /* where rows have cells */
    text written; /* coordinates of the rows of a run, each with a NUL, unless they are exact */
    graze_row_texts texts[RUN_ROWS];
} answerer;

/** Make an answerer; answerer_clear frees it in either case. On failure says why. */
int answerer_init(answerer *a, const answer_task *task);
void answerer_clear(answerer *a);
/** Most rows that a run may have. */
size_t answer_most(const answer_task *task);
/** Answer the run that begins at row `first` of a block, into a run whose `taken` is set and that
 * is zeroed otherwise. */
void answer(answerer *a, row_run *r, const block *b, size_t first);

#endif
