/* Blocks of rows on their way from a file or a grid through the threads to the table, and faults.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_BLOCK_H
#define GRAZE_RUN_BLOCK_H

#include "input/delimited/field.h"
#include "program/run/lines.h"
#include "program/run/status.h"

/** A block takes no further line once it holds that many rows or bytes; a run has at most RUN_ROWS.
 */
enum { BLOCK_ROWS = 1024, BLOCK_BYTES = 1 << 20, RUN_ROWS = 64 };

/** Why a row has no answer: an exit status (status.h) and, unless it is EXIT_SIGNAL, a message for
 * complain, malloc'ed; NULL stands for memory that ran short. Zeroed: no fault. */
typedef struct fault {
    int status;
    char *message;
} fault;

/** Set a fault that is zeroed; returns `status`. */
int fault_set(fault *f, int status, const char *format, ...) __attribute__((format(printf, 3, 4)));
/** Set a fault to the context's message; `otherwise` as in exit_for, EXIT_SIGNAL for a cancel. */
int fault_of(fault *f, graze_status status, const graze_context *context, int otherwise);
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
    graze_row_totals totals; /* of the rows that are done */
    size_t taken;            /* rows; 0 until a thread takes them */
    size_t done;             /* rows the texts hold */
    struct row_text {
        char *text; /* for graze_free; NULL where none is wanted */
        size_t length;
    } out[RESULT_KINDS];
    fault fault; /* why row `done` has no answer, where done < taken; EXIT_SIGNAL until answered */
} row_run;

typedef struct block {
    unsigned long before; /* the shard's rows of earlier blocks */
    size_t count;
    char *bytes; /* the lines of a file, one after the other */
    size_t used, capacity;
    line lines[BLOCK_ROWS];
    unsigned long long points[BLOCK_ROWS]; /* checksum of the points up to that row; 0 of a grid */
    row_run runs[BLOCK_ROWS];
    size_t next;         /* jobs: the first row that is not taken */
    size_t busy;         /* jobs: runs taken and not yet answered */
    struct block *after; /* jobs: the block handed over next */
} block;

block *block_create(void);
void block_destroy(block *b);
/** Take the answers away and empty the block, whose rows will come after `before` others. */
void block_reset(block *b, unsigned long before);
/** Add a line of a file; 0 when memory is short. */
int block_add(block *b, field text, unsigned long number);

#endif
