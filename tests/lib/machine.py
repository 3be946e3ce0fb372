"""Parts that a machine may lack: pseudo-terminals, Open MPI, and a network interface, without which Open MPI starts nothing.
A check that needs one is then a skip of the name `terminal`, `mpi` or `mpi-network`.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import functools
import os
import pty
import shutil
import subprocess
import tempfile

import harness

# mpirun asks for these before it starts anything as root; leaks of the library are not ours.
MPI_ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       ASAN_OPTIONS="detect_leaks=0")


def terminal(checks):
    """(master, slave) of a pseudo-terminal, or None and a skip."""
    try:
        return pty.openpty()
    except OSError as failure:
        checks.skip("terminal", f"no pseudo-terminal: {failure}")
        return None


def read_terminal(master):
    """Read all that is written to a terminal until its last writer is gone; close it."""
    parts = []
    while True:
        try:
            part = os.read(master, 4096)
        except OSError:  # the other end is closed
            part = b""
        if not part:
            os.close(master)
            return b"".join(parts)
        parts.append(part)


def on_terminal(checks, words, seconds):
    """(exit status, what it shows) of a command whose standard error is a terminal, or None and a skip."""
    pair = terminal(checks)
    if not pair:
        return None
    child = subprocess.Popen([str(word) for word in words], stdout=subprocess.DEVNULL, stderr=pair[1])
    os.close(pair[1])
    shown = read_terminal(pair[0])
    return child.wait(seconds), shown


@functools.lru_cache
def has_no_network():
    """Does mpirun say so, of a command that needs no MPI?"""
    done = harness.run(["mpirun", "-n", "1", "--oversubscribe", "true"], env=MPI_ENVIRONMENT)
    return done.returncode != 0 and "network interfaces" in done.stdout + done.stderr


@functools.lru_cache
def sessions():
    """A folder for those that mpirun makes: two that begin at once fail where both would make one of the same name."""
    return tempfile.TemporaryDirectory(prefix="graze-mpi-")


def ranks(checks, graze, count):
    """The words that start graze-mpi with this number of ranks, for MPI_ENVIRONMENT, or None and a skip. Each call is for one run."""
    if not shutil.which("mpirun") or not os.path.exists(graze + "-mpi"):
        checks.skip("mpi", "Open MPI is not installed")
    elif has_no_network():
        checks.skip("mpi-network", "there is no network interface")
    else:
        own = tempfile.mkdtemp(dir=sessions().name)
        return ["mpirun", "--mca", "orte_tmpdir_base", own, "-n", str(count), "--oversubscribe", graze + "-mpi"]
    return None
