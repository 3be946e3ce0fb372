/* The files of a run, and the record of the rows that are written.
 *
 * A run writes `results`: a table, a certificate, or both, each a `result`. While they are
 * unfinished, a file FILE.kept beside them holds the run's `record`, which counts the rows that are
 * written. A result is written through an `output` (program/io), which knows only bytes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_PROGRAM_RUN_RESULTS_H
#define GRAZE_PROGRAM_RUN_RESULTS_H

#include "program/run/run.h"

/** Most rows that a run may have. */
size_t answer_most(const answer_task *task);

/* The record of an unfinished run: how far its files have come, in a file beside the table.
 *
 * FILE.kept is one line of fixed length with a checksum of its own. It is written at most once a
 * second while rows are written, and at a run's early end; the whole table has none. A run without
 * a name for its rows (standard output, a pipe) has no record. */

/** Record of a run: the number of rows that are written, with checksums of their points and of the
 * files. */
typedef struct record {
    unsigned long rows, undecided, wide;
    unsigned long long points; /* checksum of the points of these rows */
    struct recorded {
        unsigned long long length, sum; /* length and checksum of the file with these rows */
    } file[RESULT_KINDS];
} record;

typedef struct record_file {
    char *path;     /* NULL: there is no record */
    int fd;         /* -1 until the first line is written */
    double written; /* time of the last writing, at first of the start; monotonic clock, seconds */
} record_file;

/** Set the name of the record beside `path`. EXIT_INPUT: there is a file of this name that is no
 * record or cannot be read; EXIT_IO: out of memory. Says why. */
int record_open(record_file *f, const char *path);
/** Read the record; 0 if there is none, or if it is not whole. */
int record_read(record *out, const record_file *f);
/** Write the record if the last one is a second old, or in any case if `now`. A failure is not
 * reported: a run that continues without the record makes the rows again. */
void record_write(record_file *f, const record *r, int now);
/** Remove the record; called when the files are whole or begun anew. */
void record_remove(record_file *f);
void record_close(record_file *f);

/* The table or the certificate that a run writes: begun anew, or continued where an earlier run
 * was interrupted.
 *
 * The bytes of a continued file that its record counts are passed over; the bytes behind are
 * compared with those that this run makes. Nothing in the file changes until its end is reached; an
 * incomplete last line is written anew. */

typedef struct result {
    output out;
    result_kind kind;
    int opened;
    int beside;          /* 1: a certificate beside a table, whose rows then count for the run */
    const char *resumed; /* the file that is continued, or NULL */
    unsigned long long there; /* bytes of this file's whole lines, without dropped notes */
    unsigned long long size;  /* bytes of this file when it was opened */
    checksum sum;             /* of the bytes passed over, compared or written */
    unsigned long lines;      /* lines among these bytes, for messages */
    unsigned long rows;       /* rows written, or taken over from an earlier run */
} result;

/** Open the file `resumed` to continue it, or make it if it does not exist. If `resumed` is NULL,
 * open `path` as output_open does. Returns an exit status and says what is wrong; EXIT_INPUT:
 * `resumed` is complete already, which is allowed if `beside` is set. Before the call the caller
 * sets `kind` and `beside` of `t` and zeroes the rest; it calls result_close in any case. */
int result_open(result *t, const char *path, const char *resumed);

/** Write the head or, in a continued file, check it. EXIT_INPUT: the file has another head. */
int result_begin(result *t, const char *head);

/** Pass over the kept bytes of the file, which have `rows` rows. EXIT_INPUT: they were changed. */
int result_pass(result *t, const struct recorded *kept, unsigned long rows);

/** Add whole lines with `rows` rows, or check that the file has them. EXIT_INPUT: it has others. */
int result_add(result *t, const char *text, size_t length, unsigned long rows);

/** Check that all of a continued file is reached. EXIT_INPUT: it has rows beyond this run's. */
int result_end(const result *t);

/** Length and checksum of the file with the rows written so far. */
struct recorded result_recorded(const result *t);

/** Flush and close. Returns `status`, or why the writing failed. */
int result_close(result *t, int status);

/* The files of one run: a table, a certificate, or both.
 * The certificate of rows is written before these rows of the table, so that a table never has a
 * row without its certificate. */
/** The files. Zeroed first, then results_init; results_close in any case. */
typedef struct results {
    const classify_options *o;
    const loaded *l;
    result file[RESULT_KINDS];
    typed_table typed;  /* the table's values, if its form is binary (npy, vtk) */
    record_file beside; /* the record: beside the table, or beside a certificate alone */
    int recorded;       /* 1: the record counts rows of this run */
    record at;          /* the rows written, up to the first row without an answer */
} results;

void results_init(results *out, const classify_options *o, const loaded *l);
/** The file whose rows count for the run: the table, or else the certificate. */
result *results_main(results *out);

/** Open the files, or those to continue. Returns an exit status and says what is wrong. */
int results_open(results *out);
/** Pass over the rows that the record of an earlier run counts, for which this run has read `rows`
 * points with the checksum `points`. EXIT_INPUT: the files have other rows, or rows of other
 * points. */
int results_pass(results *out, unsigned long rows, unsigned long long points);
/** Write the heads. `source` has the columns or the grid. */
int results_begin(results *out, const row_source *source);
/** Write the rows of a block up to the first without an answer, and complain of this row.
 * EXIT_SIGNAL: the row has no answer because a signal came. */
int results_block(results *out, const block *b);
/** Write the last lines, or the table in the form asked for. `rows_of_all` and `checksum` describe
 * the whole run, so that merge can match the parts. */
int results_end(results *out, unsigned long rows_of_all, unsigned long long checksum);
/** Has a write failed? */
int results_failed(const results *out);
/** Flush and close the files. Returns `status`, or why the writing failed; after a signal reports
 * how many rows the files have. */
int results_close(results *out, int status);

#endif
