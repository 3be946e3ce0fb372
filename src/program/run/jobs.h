/* Rows answered by several at one time: by threads (jobs.c), or by the ranks of graze-mpi.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_JOBS_H
#define GRAZE_RUN_JOBS_H

#include "program/run/answer.h"

typedef struct jobs jobs;

/** After a signal, rows that are nearly answered have this number of looks, this number of
 * milliseconds apart. */
enum { LAST_LOOKS = 10, LOOK_MILLISECONDS = 20 };

/** How many rows are answered at one time, if `threads` are asked for: no more than there are
 * cores; 0: one for each core. */
int jobs_width(int threads);
/** Start the threads, each with a context of its own. On failure says why; `*out` is for jobs_stop
 * in either case. */
int jobs_start(jobs **out, int threads, const answer_task *task);
/** Hand a block over; it is answered after those before it and must stay until jobs_wait. */
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

#endif
