/* mpi: the program graze-mpi, whose rows are answered by MPI ranks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_PROGRAM_MPI_H
#define GRAZE_PROGRAM_MPI_H

#include "program/points/points.h"
#include "program/run/run.h"

/* Messages: a run of rows on its way to a rank, and the answer on its way back, as bytes. */

/** Kinds of messages; STOP is empty. */
enum { MESSAGE_RUN = 1, MESSAGE_ANSWER = 2, MESSAGE_STOP = 3 };

/** Pack the run that begins at row `first` of a block. `columns` is NULL for a grid. 0 when out of
 * memory, as the other functions of messages. */
int message_put_run(text *m, const block *b, size_t first, const columns *c);
/** Unpack a run as the only run of an emptied block. */
int message_get_run(const text *m, block *b, columns *c);

/** Pack an answer. */
int message_put_answer(text *m, const row_run *r);
/** Unpack an answer into its run, whose `taken` stays. */
int message_get_answer(const text *m, row_run *r);

/* The ranks of graze-mpi: rank 0 reads points and writes the table, the others answer rows.
 *
 * Rank 0 runs graze classify; the jobs of program/run/run.h are ranks instead of threads. A rank
 * gets further rows as soon as its answer has come, so that no rank waits for a slower one. */

/** Rank 0: send an exit status to the ranks that wait for the first one, unless jobs_start has sent
 * EXIT_DONE. */
void ranks_release(int status);

/** Rank 0: 1 if a signal came and another rank is still at a row. This rank does not reach
 * MPI_Finalize; mpirun ends it once rank 0 has died. */
int ranks_abandoned(void);

/** Other ranks: read the scene once rank 0 has read it, and answer rows until the last. Returns an
 * exit status; reports errors of this rank that rank 0 does not have. */
int ranks_serve(const classify_options *o);

#endif
