/* run: long runs: points in blocks, threads, tables that are continued or merged, files and
 * progress.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_PROGRAM_RUN_H
#define GRAZE_PROGRAM_RUN_H

#include "input/delimited/delimited.h"
#include "output/table/table.h"
#include "program/io/io.h"
#include "program/points/points.h"

/* Files and options of one run of graze classify, graze certify, graze contact or graze collide. */
/** The options; strings are borrowed. */
typedef struct classify_options {
    scene_options scene;
    const char *receipt;   /* file with the receipt of the scene, or NULL */
    loaded *known;         /* the scene, already read, which the run takes over; NULL: it is read */
    const char *points;    /* file of points, or `-`; ignored with a grid */
    const char *in_memory; /* their text, which `points` names in messages; NULL: it is read */
    grid_options grid;
    struct shard_choice {
        int given;  /* the table is marked as that of a shard */
        shard part; /* 0 of 1: the whole run */
    } shard;
    struct site_choice {
        int wanted, snap; /* rows are contact points; they are moved to the contacts of cells */
    } sites;
    struct pair_choice {
        int wanted; /* rows are pairs of solids; the scene has their options, and no files */
        graze_pair_options options;
        int overlap_alone, format; /* of graze collide */
        const char *clearance;     /* of rows without one; NULL: 0 */
        const char *motion_error;  /* NULL: none */
        const char *motion_of_fixed;
    } pairs;
    coordinate_options coordinates;
    int no_table;            /* 1: `output` is a certificate, and no table is written */
    const char *output;      /* NULL: standard output */
    const char *resume;      /* the table to continue, or NULL */
    const char *certificate; /* a file for the certificate beside the table, or NULL */
    int times;               /* the certificate gives the times and cells of contacts */
    int threads;             /* 0: one for each core */
    int quiet;               /* no progress */
    int transient;           /* 1: no record for a later run is kept, as of temporary files */
} classify_options;

/* One run of graze classify or graze certify: points of a file or a grid into a table, a
 * certificate or both. */

/** Classify the points and write the table, the certificate or both. Returns an exit status and
 * says what is wrong; of pairs EXIT_INPUT if a row has no answer, else EXIT_NO if a pair meets. */
int classify_run(const classify_options *o);

/** The name of a record is that of its table with this ending. */
#define RECORD_ENDING ".kept"

/* Answering runs of rows: reading their numbers, classifying their points, writing one text. */
/** Source of the rows of the blocks: the columns of a file, or a grid; one of the two is NULL. */
typedef struct row_source {
    const columns *columns;
    const grid *grid;
    shard part;
    coordinate_options coordinates; /* form in which the rows' points are written */
} row_source;

/** Common data of all answerers. All is borrowed, and only read. */
typedef struct answer_task {
    const context_options *context;
    const graze_scene *scene;
    const graze_certifier *certifier; /* NULL: no certificate is wanted */
    int no_table;                     /* 1: a certificate alone is wanted */
    const graze_row_options *rows;
    const classify_options *pairs; /* NULL: rows are no pairs */
    row_source source;
    int one_by_one; /* 1: points of a grid are decided singly, since the solid is curved */
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
/** Answer the r->taken rows of a block from `first` on, and put the answers into `r`, which is
 * zeroed but for `taken`. */
void answer(answerer *a, row_run *r, const block *b, size_t first);

/* Pairs of solids, as rows or alone. */

/** A pair of files; texts are borrowed. */
typedef struct pair_question {
    const char *path[PAIR_FILES]; /* in the order of columns; the last one may be NULL */
    unsigned solid_flags;
    graze_pair_options options; /* without size and clearance */
    field clearance;            /* a number; empty: 0 */
    field motion_error;         /* a number from 0 up; empty: none */
    struct shelved
        *held[PAIR_FILES]; /* NULL; pair_question_clear gives back what pair_decide took */
} pair_question;

/** Decide a pair. A file is read once as long as it is in use, and kept then as there is room.
 * @return EXIT_DONE, or the status of the fault */
int pair_decide(graze_pair **out, fault *f, graze_context *context, pair_question *q);
/** Free a question, after its pair, and all files, after all pairs. */
void pair_question_clear(pair_question *q);
void pairs_end(void);
/** Does a pair that was decided make exit status 1? */
int pair_meets(const classify_options *o, const graze_pair *pair);

/** Answer the row `first` of a block, as answer does. A row without an answer has the reason in its
 * columns status and message, and counts in the totals as `undecided`, one that meets as `wide`. */
void answer_pair(answerer *a, row_run *r, const block *b, size_t first);

/** The bytes of the files that rows name, each file where it is named first; no file that cannot be
 * read. Zeroed but for the context, and pair_files_clear. */
typedef struct pair_files {
    graze_context *context;
    checksum sum;
    void *seen;   /* their paths (tsearch) */
    guard *guard; /* or NULL; they are added, and their bytes are not read */
} pair_files;

/** Add the files of the next rows, and the sum up to each row to the checksum of its points. */
int pair_files_add(pair_files *p, const answer_task *task, block *b);
/** Refuse an output that rows of a list, if that is a plain file, name. */
int pair_files_check(const classify_options *o, graze_context *context);
void pair_files_clear(pair_files *p);

/** Make the head of a table of pairs. `others` are the names of further columns, or NULL. */
int pairs_head(char **head, const classify_options *o, const columns *c, const char *notes,
               const char *others);

/* The scene of a certificate, in a form that graze-check reads. */

/**
 * Make the certifier of a scene that was read, with times of contacts or without. If graze-check
 * cannot read the file of the solid or the motion, it is written in the form of `graze convert` to
 * a file beside the certificate, CERTIFICATE.off, .wkt or .json, which standard error names, and
 * the scene is read anew from this file. It is an error if a file of this name is one that the run
 * reads, or if a run is continued and the file has another content. On failure says why and returns
 * an exit status.
 * @param writes 0: the files beside the certificate exist already
 */
int certified_load(loaded *l, const classify_options *o, int writes);

/* Blocks with rows that are not yet taken, in order. */

/** A queue; zeroed it is empty. Blocks are borrowed and linked by `after`. */
typedef struct queue {
    block *first, *last;
    size_t left; /* rows not yet taken */
} queue;

/** Add a block whose rows are taken after those of the blocks before it. */
void queue_add(queue *q, block *b);

/**
 * Take the next rows, all of one block: up to `most`, and fewer towards the end, so that all
 * `workers` finish at about the same time. The queue must not be empty.
 * @param[out] of the block of the rows; the run of these rows gets `taken` and the fault
 * EXIT_SIGNAL
 * @return the index of the first row in the block
 */
size_t queue_take(queue *q, block **of, int workers, size_t most);

/* Jobs: rows answered in parallel, by threads (jobs.c) or by the ranks of graze-mpi. */

typedef struct jobs jobs;

/** After a signal jobs_wait looks LAST_LOOKS times for answers, LOOK_MILLISECONDS apart. */
enum { LAST_LOOKS = 10, LOOK_MILLISECONDS = 20 };

/** The number of threads used if `threads` are asked for: at most one for each core; 0 asks for as
 * many. */
int jobs_width(int threads);
/** Start the threads, each with a context of its own. On failure says why; jobs_stop takes `*out`
 * in either case. */
int jobs_start(jobs **out, int threads, const answer_task *task);
/** Hand a block over. Its rows are taken after those of earlier blocks; it must exist until
 * jobs_wait has returned for it. */
void jobs_submit(jobs *j, block *b);
/** Wait until all rows of a block are answered; after a signal only for a moment. Runs without an
 * answer have the fault EXIT_SIGNAL. */
void jobs_wait(jobs *j, const block *b);
/**
 * End all threads, each after its current run. NULL is allowed.
 * @return 0 if a signal came and some threads are still at a row; then nothing that they use may be
 * freed, and the process is to end by the signal
 */
int jobs_stop(jobs *j);

/* Receipts: files in which graze check records a legal scene, so that graze classify need not
 * repeat the search for facets that meet.
 *
 * A receipt depends only on the scene and on the options that change it. It has the version, hashes
 * of both files and of the scene, rounding, triangulation, and last a checksum of the lines before,
 * against accidents. It is valid for every run that would write the same receipt. */

/** Write the receipt of a legal scene to a file. */
int receipt_write(const char *path, const loaded *l, const scene_options *o);

/** Read a scene, without the checks that the receipt `path` covers; with all checks if `path` is
 * NULL. EXIT_INPUT: the file is no receipt of this scene. loaded_clear frees `out` in either case.
 */
int receipt_load(loaded *out, const char *path, const scene_options *o);

/* A part: the table or the certificate of one shard, as graze merge reads it.
 *
 * A part is a plain file that is open only while it is read from, so that the number of parts is
 * not limited. Its head and its last lines are read first; the last lines state the number of rows
 * and a checksum of the bytes, which the rest of the file must have. */

typedef struct part {
    stream in;
    result_kind kind;
    shard shard;
    text head;    /* without the line that names the shard */
    field next;   /* the line behind the rows copied so far, borrowed from `in` */
    checksum sum; /* checksum of the bytes before `next` */
    last_lines last;
} part;

/** Read head and last lines, and check that they fit together. Returns an exit status and says what
 * is wrong: EXIT_INPUT the file is no part, or not whole. part_close frees it in any case. */
int part_open(part *p, graze_context *context, const char *path);
void part_close(part *p);

/** Copy the next row. EXIT_INPUT: there is no further row. */
int part_copy_row(part *p, output *out);

/** Check that no row is left. EXIT_INPUT: there are further rows, or the part was changed
 * meanwhile.
 */
int part_end(part *p);

#endif
