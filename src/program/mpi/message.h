/* A run of rows on its way to a rank, and its answer on the way back, as bytes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MPI_MESSAGE_H
#define GRAZE_MPI_MESSAGE_H

#include "program/run/answer.h"

/** Kinds of messages; STOP is empty. */
enum { MESSAGE_RUN = 1, MESSAGE_ANSWER = 2, MESSAGE_STOP = 3 };

/** Bytes that grow; zeroed at first. */
typedef struct message {
    char *bytes;
    size_t length, capacity;
} message;

void message_clear(message *m);
/** Room for `length` bytes; 0 when memory is short. */
int message_reserve(message *m, size_t length);

/** Pack the run that begins at row `first` of a block. `columns` is NULL for a grid. */
int message_put_run(message *m, const block *b, size_t first, const columns *c);
/** Unpack it as the one run of an emptied block. */
int message_get_run(const message *m, block *b, columns *c);

/** Pack an answer. */
int message_put_answer(message *m, const row_run *r);
/** Unpack an answer into its run, whose `taken` stays. */
int message_get_answer(const message *m, row_run *r);

#endif
