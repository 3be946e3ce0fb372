/* The ranks of graze-mpi: rank 0 reads points and writes the table, the others answer rows.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Rank 0 runs graze classify with the jobs of run/jobs.h made of ranks in place of threads. A rank
 * is handed one run of rows at a time and gets the next one when its answer is there, so that none
 * waits for a slower one.
 */
#ifndef GRAZE_MPI_RANKS_H
#define GRAZE_MPI_RANKS_H

#include "run/classify.h"

/** Rank 0: tell the other ranks how it went before any rows were asked for, unless jobs_start has
 * told them that all is well. */
void ranks_release(int status);

/** Rank 0: whether a signal came and another rank is still at a row. It will not come to the end of
 * MPI; it ends when mpirun finds that rank 0 has died. */
int ranks_abandoned(void);

/** Other ranks: load the scene once rank 0 has, and answer until there is nothing left. Returns an
 * exit status and says what is wrong here and not on rank 0. */
int ranks_serve(const classify_options *o);

#endif
