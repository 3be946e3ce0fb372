/* The record of an unfinished run: how far its files have come, in a file beside the table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * FILE.kept is one line of fixed length with a checksum of its own. It is written at most once a
 * second while rows are written, and at a run's early end; the whole table has none. A run without
 * a name for its rows (standard output, a pipe) has no record.
 */
#ifndef GRAZE_RUN_RECORD_H
#define GRAZE_RUN_RECORD_H

#include "program/run/checksum.h"
#include "program/run/lines.h"

/** Record of a run: rows that are written, with the sums that bind them to points and files. */
typedef struct record {
    unsigned long rows, undecided, wide;
    unsigned long long points; /* checksum of the points up to there */
    struct kept_bytes {
        unsigned long long length, sum; /* of the file up to there */
    } file[RESULT_KINDS];
} record;

typedef struct record_file {
    char *path;     /* NULL: there is no record */
    int fd;         /* -1 until the first line is written */
    double written; /* seconds of the monotonic clock; first the start */
} record_file;

/** Behind the name of a table, that of its record. */
#define RECORD_ENDING ".kept"

/** Name the record of `path`. EXIT_INPUT: something else stands there; EXIT_IO. Says why. */
int record_open(record_file *f, const char *path);
/** Read it; 0 if there is none, or it is not whole. */
int record_read(record *out, const record_file *f);
/** Write it, `now` or where the last time is a second ago. A record that cannot be written is none:
 * its rows are made again. */
void record_write(record_file *f, const record *r, int now);
/** Take it away: the files are whole, or begun anew. */
void record_remove(record_file *f);
void record_close(record_file *f);

#endif
