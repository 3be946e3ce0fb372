"""Two cores: threads, processes, shards and MPI ranks on one table, by the wall clock.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import shutil
import statistics

from measure import run_cpu, run_wall

# mpirun asks for these before it starts anything as root.
AS_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
START = 2000


class Cores:
    """One scene whose rows are the given lines, over and over."""

    def __init__(self, graze, folder, solid, motion, lines, repeats):
        self.graze, self.folder, self.scene = graze, folder, [solid, motion]
        self.lines, self.repeats, self.files = lines, repeats, {}
        self.empty = self.start(self.command(1, 1))

    @staticmethod
    def start(command):
        """Seconds of a run that answers next to nothing."""
        return min(run_wall([command]) for _ in range(3))

    def write(self, rows):
        if rows not in self.files:
            path = self.files[rows] = os.path.join(self.folder, f"rows{rows}.csv")
            with open(path, "w", encoding="ascii") as file:
                for r in range(0, rows, len(self.lines)):
                    file.writelines(self.lines[:rows - r])
        return self.files[rows]

    def command(self, jobs, rows, *more):
        return [self.graze, "classify", "--jobs", str(jobs), *more, *self.scene, self.write(rows)]

    def fitting(self, target):
        """How many rows take `target` seconds of one core."""
        return max(START, int(START * target / max(run_cpu(self.command(1, START))[0], 1e-3)))

    def against(self, table, work, rows, one, other, least=None, start=None):
        """Both command lists answer `rows` rows; the row is how much faster the first is, without loading and
        the start of processes, which takes the first `start` seconds."""
        starts = start or self.empty, self.empty
        pairs = [[run_wall(commands) - spent for commands, spent in zip((one, other), starts)]
                 for _ in range(self.repeats)]
        ours, peer = (statistics.median(p[k] for p in pairs) / rows for k in (0, 1))
        table.row(f"{work} ({rows:,} rows)", statistics.median(b / a for a, b in pairs), least=least,
                  graze=ours, peer=peer)

    def measure(self, table, target):
        n = self.fitting(target)
        both = self.command(2, 2 * n)
        alone = self.command(1, 2 * n)
        self.against(table, "2 threads against two processes, wall clock", 2 * n, [both],
                     [self.command(1, n), self.command(1, n)], least=0.9)
        self.against(table, "2 threads against 1", 2 * n, [both], [alone])
        self.against(table, "8 threads against 2", 2 * n, [self.command(8, 2 * n)], [both], least=0.95)
        shards = [self.command(1, 2 * n, "--shard", f"{k}/2") for k in (1, 2)]
        self.against(table, "2 shards at a time against the whole", 2 * n, shards, [alone])
        if shutil.which("mpirun") and os.path.exists(self.graze + "-mpi"):
            os.environ.update(AS_ROOT)
            # Standard output would pass through mpirun, which takes longer than the answers.
            ranks = lambda rows: ["mpirun", "-n", "3", "--oversubscribe", self.graze + "-mpi", *self.scene,
                                  self.write(rows), "--output", os.devnull]
            self.against(table, "graze-mpi, one rank that reads and two that answer, against 1 process", 8 * n,
                         [ranks(8 * n)], [self.command(1, 8 * n)], start=self.start(ranks(1)))
