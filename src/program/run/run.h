/* run: long runs: points in blocks, threads, tables that are continued or merged, files and
 * progress.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_PROGRAM_RUN_H
#define GRAZE_PROGRAM_RUN_H

#include "input/delimited/delimited.h"
#include "output/table/table.h"
#include "program/io/io.h"
#include "program/points/points.h"

/* Files and options of one run of graze classify, graze certify or graze contact. */

/** Strings are borrowed. */
typedef struct classify_options {
    scene_options scene;
    const char *receipt; /* of the scene, or NULL */
    const char *points;  /* the file, or `-`; not looked at with a grid */
    grid_options grid;
    struct shard_choice {
        int given;  /* the table is marked as that of a shard */
        shard part; /* 0 of 1: the whole run */
    } shard;
    struct site_choice {
        int wanted, snap; /* contact points in place of points, moved to the contacts of cells */
    } sites;
    coordinate_options coordinates;
    int no_table;            /* a certificate takes the table's place */
    const char *output;      /* NULL: standard output */
    const char *resume;      /* the table to continue, or NULL */
    const char *certificate; /* a file for the certificate beside the table, or NULL */
    int times;               /* the certificate gives the times and cells of contacts */
    int threads;             /* 0: one for each core */
    int quiet;               /* no progress */
    int transient;           /* files are for a moment only: no record for a later run is kept */
} classify_options;

/* One run of graze classify or graze certify: points of a file or a grid into a table, a
 * certificate or both. */

/** Classify the points and write the table, the certificate or both. Returns an exit status and
 * says what is wrong. */
int classify_run(const classify_options *o);

/** Behind the name of a table, that of its record. */
#define RECORD_ENDING ".kept"

/* Runs of rows answered: their numbers read, their points classified, all of it written as one
 * text. */

/** Source of the rows of the blocks: a file's columns or a grid; the other is NULL. */
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
    int no_table;                     /* 1: a certificate alone is wanted */
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
/** Answer the rows of a block from `first` on into `r`, whose `taken` is set to their number and
 * which is zeroed otherwise. */
void answer(answerer *a, row_run *r, const block *b, size_t first);

/* The scene of a certificate, in a form that graze-check reads. */

/**
 * Make the certifier of a scene that was read, with times of contacts or without. A solid or a
 * motion that graze-check cannot read is written as `graze convert` writes it to a file beside the
 * certificate, CERTIFICATE.off, .wkt or .json, which is named on standard error, and the scene is
 * read anew with that file. Refused if a file of that name is one that is read, or if a run is
 * continued and the file there has another content. On failure says why and returns an exit status.
 * @param writes 0: the files beside the certificate are there already
 */
int certified_load(loaded *l, const classify_options *o, int writes);

/* Blocks with rows that are not yet taken, in order. */

/** Zeroed: empty. Blocks are borrowed and linked by `after`. */
typedef struct queue {
    block *first, *last;
    size_t left; /* rows not yet taken */
} queue;

/** Add a block whose rows are taken after those of the blocks before it. */
void queue_add(queue *q, block *b);

/**
 * Take the next rows, of one block: up to `most`, and fewer towards the end, so that all
 * `workers` finish at about the same time. The queue is not empty.
 * @param[out] of the block; its run at the row returned has `taken` set and the fault EXIT_SIGNAL
 * @return the first of the rows
 */
size_t queue_take(queue *q, block **of, int workers, size_t most);

/* Rows answered by several at one time: by threads (jobs.c), or by the ranks of graze-mpi. */

typedef struct jobs jobs;

/** After a signal jobs_wait looks LAST_LOOKS times for answers, LOOK_MILLISECONDS apart. */
enum { LAST_LOOKS = 10, LOOK_MILLISECONDS = 20 };

/** The number of threads used if `threads` are asked for (0: one a core): at most one a core. */
int jobs_width(int threads);
/** Start the threads, each with a context of its own. On failure says why; `*out` is for jobs_stop
 * in either case. */
int jobs_start(jobs **out, int threads, const answer_task *task);
/** Hand a block over; it is answered after the blocks handed over before, and must stay until
 * jobs_wait has returned for it. */
void jobs_submit(jobs *j, block *b);
/** Wait until all rows of a block are answered; after a signal only for a moment. Runs without an
 * answer have the fault EXIT_SIGNAL. */
void jobs_wait(jobs *j, const block *b);
/**
 * End all threads, after the runs they are at. NULL is harmless.
 * @return 0 if a signal came and some are still at a row: then nothing that they use may be freed,
 * and the process is to end by the signal
 */
int jobs_stop(jobs *j);

/* Receipts: files in which graze check records a legal scene, so that graze classify need not
 * search for facets that meet again.
 *
 * A receipt is a text that the scene and the options that shape it determine: version, hashes of
 * both files and of the scene, rounding, triangulation; and last a checksum of the lines before,
 * against accidents. It holds for every run that would write an equal receipt. */

/** Write the receipt of a legal scene to a file. */
int receipt_write(const char *path, const loaded *l, const scene_options *o);

/** Read a scene, without the checks that its receipt covers; with all of them where `path` is NULL.
 * EXIT_INPUT: the file is no receipt, or not one of this scene. `out` is for loaded_clear in either
 * case. */
int receipt_load(loaded *out, const char *path, const scene_options *o);

/* A part: the table or the certificate of one shard, as graze merge reads it.
 *
 * A part is a plain file that is open only while it is read from, so that there is no limit to how
 * many there are. Its head and its last lines are read first; the last lines state the number of
 * rows and a checksum of the bytes, which are compared with those of the file. */

typedef struct part {
    stream in;
    result_kind kind;
    shard shard;
    text head;    /* without the line that names the shard */
    field next;   /* the line behind the rows that are copied, borrowed from `in` */
    checksum sum; /* of the bytes before that line */
    last_lines last;
} part;

/** Read head and last lines, and see that they fit together. Returns an exit status and says what
 * is wrong: EXIT_INPUT it is no part, or not a whole one. part_close frees it in any case. */
int part_open(part *p, graze_context *context, const char *path);
void part_close(part *p);

/** Copy the next row. EXIT_INPUT: there is none. */
int part_copy_row(part *p, output *out);

/** Check that no row is left. EXIT_INPUT: there are more, or the part was changed meanwhile. */
int part_end(part *p);

#endif
