/* The ranks of graze-mpi: rank 0 reads points and writes the table, the others answer rows.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Rank 0 runs graze classify with the jobs of program/run/jobs.h made of ranks in place of threads.
 * A rank is handed one run of rows at a time and gets the next one when its answer is there, so
 * that none waits for a slower one.
 */
#ifndef GRAZE_MPI_RANKS_H
#define GRAZE_MPI_RANKS_H

#include "program/run/classify.h"

/** Rank 0: send an exit status to the ranks that wait for the first one, unless jobs_start has sent
 * EXIT_DONE. */
void ranks_release(int status);

/** Rank 0: 1 if a signal came and another rank is still at a row. That rank does not reach the end
 * of MPI; mpirun ends it once rank 0 has died. */
int ranks_abandoned(void);

/** Other ranks: read the scene once rank 0 has, and answer rows to the last one. Returns an exit
 * status and says what is wrong here and not on rank 0. */
int ranks_serve(const classify_options *o);

#endif
