/* The table or the certificate that a run writes: begun anew, or continued where an earlier run was
 * interrupted. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A file that is continued has the head this run would write, to the byte, rows of its points
 * (kept.h), and its last row is the one this run makes of the same point; a certificate's may be
 * the beginning of it. Until all of it is checked nothing in the file changes.
 */
#ifndef GRAZE_RUN_RESULTS_H
#define GRAZE_RUN_RESULTS_H

#include "input/delimited/stream.h"
#include "program/run/lines.h"
#include "program/run/output.h"

typedef struct results {
    output out;
    result_kind kind;
    int opened;
    int beside; /* a certificate beside a table, which alone tells how far a run has come */
    const char *resumed; /* the file that is continued, or NULL */
    unsigned long rows;  /* rows written, or taken over from an earlier run */
    int counts_undecided;
    unsigned long undecided; /* of these rows, if they are counted */
    double tolerance;        /* of enclosures; 0: rows have none */
    int certain;             /* rows say whether they are certain */
    unsigned long wide;      /* of these rows, those whose enclosure is wider */
    text head;               /* the part of a head that the file had */
    int head_whole;          /* it ends with the head's last line */
    char *last; /* whole lines of the last row there was, until it is made again; malloc'ed */
    size_t last_length, last_room; /* with their newlines */
    long long last_start;          /* byte of the file */
    stream in; /* the resumed file, from which kept rows are read; open while it is locked */
    unsigned long head_lines;
} results;

/** Count the undecided positions and the wide enclosures among rows, whose last line may lack its
 * end. */
void results_count(results *t, const char *text, size_t length);

/** Open standard output (NULL), a file, or with `resumed` a file to continue, which need not be
 * there. Returns an exit status and says what is wrong: EXIT_INPUT the file is whole already, which
 * one that is `beside` another may be. `t` is zeroed before but for `kind` and `beside`;
 * results_close ends it in any case. */
int results_open(results *t, graze_context *context, const char *path, const char *resumed);

/** Take over the first `rows` rows alone. EXIT_INPUT: there are fewer. */
int results_shorten(results *t, unsigned long rows);

/** The rows that need not be made again. The last one there is made again, as a check. */
unsigned long results_skip(const results *t);

/** The next line of these rows, without its line end; borrowed until the next call. EXIT_INPUT: one
 * that is no part of a row stands there. */
int results_next(results *t, field *line);

/** Refuse that line: `there` is what it has, and after `expected` comes `here`. EXIT_INPUT. */
int results_refuse(const results *t, field there, const char *expected, field here);

/** Write the head, or see that it is the one there. EXIT_INPUT: it is not. */
int results_begin(results *t, const char *head);

/** Add whole rows. EXIT_INPUT: the first one is not the last one there. */
int results_add(results *t, const char *text, size_t length, unsigned long rows);

/** Nothing will be added. EXIT_INPUT: there were rows for which this run has no points. */
int results_end(results *t);

/** Flush and close. Returns `status`, or why the writing failed. */
int results_close(results *t, int status);

#endif
