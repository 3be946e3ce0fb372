/* The table or the certificate that a run writes: begun anew, or continued where an earlier run was
 * interrupted.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A file that is continued is passed over up to the end of its record (record.h); behind that its
 * bytes are compared with those of this run. Until all of it is the same nothing in the file
 * changes; a last line without its end is written anew.
 */
#ifndef GRAZE_RUN_RESULTS_H
#define GRAZE_RUN_RESULTS_H

#include "program/run/output.h"
#include "program/run/record.h"

typedef struct results {
    output out;
    result_kind kind;
    int opened;
    int beside; /* a certificate beside a table, which alone tells how far a run has come */
    const char *resumed;      /* the file that is continued, or NULL */
    unsigned long long there; /* bytes of its whole lines, without those that are dropped */
    unsigned long long size;  /* its bytes when it was opened */
    checksum sum;             /* of the bytes passed over, compared or written */
    unsigned long lines;      /* among them, for messages */
    unsigned long rows;       /* rows written, or taken over from an earlier run */
} results;

/** Open standard output (NULL), a file, or with `resumed` a file to continue, which need not be
 * there. Returns an exit status and says what is wrong: EXIT_INPUT the file is whole already, which
 * one that is `beside` another may be. `t` is zeroed before but for `kind` and `beside`;
 * results_close ends it in any case. */
int results_open(results *t, const char *path, const char *resumed);

/** Write the head, or see that it is the one there. EXIT_INPUT: it is not. */
int results_begin(results *t, const char *head);

/** 1 if the file has that number of bytes, so that a record may belong to it. */
int results_reach(const results *t, const struct kept_bytes *kept);

/** Pass over the file up to there, `rows` rows. EXIT_INPUT: it was changed. */
int results_pass(results *t, const struct kept_bytes *kept, unsigned long rows);

/** Add whole lines with `rows` rows, or check that they are there. EXIT_INPUT: others are. */
int results_add(results *t, const char *text, size_t length, unsigned long rows);

/** Nothing will be added. EXIT_INPUT: there are rows for which this run has no points. */
int results_end(const results *t);

/** How far the file has come. */
struct kept_bytes results_kept(const results *t);

/** Flush and close. Returns `status`, or why the writing failed. */
int results_close(results *t, int status);

#endif
