/* graze-mpi: graze classify with the rows answered by many ranks.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/mpi/mpi.h"

#include <fcntl.h>
#include <mpi.h>
#include <stdio.h>
#include <unistd.h>
#include "program/cli/cli.h"

static const char mpi_help[] =
    "mpirun -n N graze-mpi SOLID MOTION POINTS: graze classify on N ranks\n"
    "\n"
    "Example: mpirun -n 17 graze-mpi cube.off move.json points.csv -o table.csv\n"
    "\n"
    "Rank 0 reads the points and writes the table; the other ranks answer rows, a few at a time,\n"
    "so that none waits for a slower one. N is one more than the number of cores. The table has\n"
    "the bytes of graze classify; its options hold here too, but for --jobs.\n"
    "SOLID and MOTION are read by every rank, POINTS and - by rank 0.\n";

/* Read the words of the command line, which all ranks have; only rank 0 complains of them. */
static int read_words(operands *given, classify_options *o, int *show_help, int rank, int argc,
                      char **argv) {
    int kept = rank ? dup(STDERR_FILENO) : -1, none = rank ? open("/dev/null", O_WRONLY) : -1;
    if (kept >= 0 && none >= 0)
        dup2(none, STDERR_FILENO);
    int status = command_read(given, o, show_help, &command_classify, argc, argv);
    if (!status && !*show_help)
        status = classify_take(o, given);
    if (kept >= 0 && none >= 0)
        dup2(kept, STDERR_FILENO);
    if (kept >= 0)
        close(kept);
    if (none >= 0)
        close(none);
    return status;
}

/* Run this rank's part. If rank 0 ends before it sends rows to the others, it sends them its
 * status.
 */
static int run_rank(const operands *given, const classify_options *o, int rank) {
    int status = rank ? ranks_serve(o) : command_guard(&command_classify, o, given);
    if (!rank && !status)
        status = classify_run(o);
    if (!rank)
        ranks_release(status ? status : EXIT_FAULT);
    return status;
}

int main(int argc, char **argv) {
    int rank, show_help, status;
    classify_options o;
    operands given;
    memory_guard();
    output_guard_standard();
    if (MPI_Init(&argc, &argv) != MPI_SUCCESS || interrupt_watch() != 0)
        return complain(EXIT_IO, "MPI cannot begin");
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    status = read_words(&given, &o, &show_help, rank, argc, argv);
    if (!status && show_help && rank == 0)
        fputs(mpi_help, stdout);
    if (!status && !show_help)
        status = run_rank(&given, &o, rank);
    operands_clear(&given);
    if (!ranks_abandoned())
        MPI_Finalize();
    if (status == EXIT_SIGNAL && rank == 0)
        interrupt_die();
    return status == EXIT_SIGNAL ? EXIT_DONE : status;
}
