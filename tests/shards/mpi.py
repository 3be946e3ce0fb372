#!/usr/bin/env python3
# suite
"""graze-mpi on the ranks of one machine writes the bytes of graze classify, and ends as it does.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import concurrent.futures
import signal
import subprocess
import time

from bench import COMMON, SECONDS, harness, random_points, run_checks
from machine import MPI_ENVIRONMENT, ranks


def command(bench, count, *words):
    return [*ranks(bench.checks, bench.graze, count), *map(str, words)]


def run(bench, count, *words, stdin=None):
    """(exit status, standard output, standard error) of graze-mpi."""
    done = harness.run(command(bench, count, *words), SECONDS, text=False, input=stdin, env=MPI_ENVIRONMENT)
    return done.returncode, done.stdout, done.stderr


def at_once(function, items):
    """The function's value for each item, three of them at once: mpirun waits more than it works."""
    with concurrent.futures.ThreadPoolExecutor(3) as pool:
        return list(pool.map(function, items))


def check_tables(bench):
    """The table of any number of ranks is that of one process."""
    cube, square = (COMMON / "cube.off", COMMON / "move3.json"), (COMMON / "square.wkt", COMMON / "move2.json")
    text = random_points(bench.random, 2500 * bench.scale, 3)
    points = bench.file("points.csv", text)
    cases = ((1, [*cube, points], None), (2, [*cube, points], None), (4, [*cube, points], None),
             (4, [*cube, "-"], text), (4, [*cube, "--grid", "17,9,23"], None),
             (4, [*square, "--grid", "9,9", "--operation", "unsweep"], None),
             (4, [*cube, points, "--format", "jsonl"], None),
             (4, [*cube, points, "--shard", "2/3"], None),
             (3, [*square, bench.file("none.csv", b"x,y\n")], None))
    ran = at_once(lambda case: run(bench, case[0], *case[1], stdin=case[2]), cases)
    for (count, words, stdin), (status, out, err) in zip(cases, ran):
        whole = bench.good("classify", *words, stdin=stdin)
        bench.check(status == 0 and out == whole, f"{count} ranks: {words}", status, err, out[-200:])
    path = bench.folder / "resumed.csv"
    whole = bench.good("classify", *cube, points)
    path.write_bytes(whole[:len(whole) * 2 // 3])
    status, _, err = run(bench, 4, *cube, points, "--resume", path)
    bench.check(status == 0 and path.read_bytes() == whole, "four ranks continue a table", status, err)
    lines = whole.splitlines(keepends=True)
    at = next(k for k, line in enumerate(lines) if not line.startswith(b"#")) + 5
    lines[at] = lines[at].replace(b",", b"1,", 1)
    begun = b"".join(lines[:len(lines) * 2 // 3])
    path.write_bytes(begun)
    status, _, err = run(bench, 4, *cube, points, "--resume", path)
    bench.check(status == 3 and path.read_bytes() == begun and b"resumed.csv:%d: " % (at + 1) in err,
                "four ranks refuse a row of another point", status, err)
    beside, alone = bench.folder / "beside.txt", bench.good("certify", *cube, points)
    exact = bench.good("classify", *cube, points, "--coordinates", "exact")
    for count in (1, 4):
        status, out, err = run(bench, count, *cube, points, "--certify", beside)
        bench.check(status == 0 and out == exact and beside.read_bytes() == alone, f"{count} ranks write a certificate too",
                    status, err)
    receipt = bench.folder / "receipt.txt"
    bench.good("check", "--receipt", receipt, *cube)
    status, out, err = run(bench, 4, *cube, points, "--receipt", receipt)
    bench.check(status == 0 and out == whole, "four ranks take a receipt", status, err)


def check_faults(bench):
    """Faults are reported once, with the exit status of graze, and the rows before them stay."""
    cube = [COMMON / "cube.off", COMMON / "move3.json"]
    lines = random_points(bench.random, 600, 3).splitlines(keepends=True)
    bad = bench.file("bad.csv", b"".join(lines[:300] + [b"bad,1,2,x,y\n"] + lines[300:]))
    cases = (("a bad row", [*cube, bad]), ("no motion", [cube[0], "none.json", bad]),
             ("an unknown option", [*cube, bad, "--tolerance"]), ("a missing operand", cube))
    for (what, words), (seen, its_out, its_err) in zip(cases, at_once(lambda case: run(bench, 4, *case[1]), cases)):
        status, out, err = bench.run("classify", *words)
        mine = [line for line in its_err.splitlines() if line.startswith(b"graze: ")]
        bench.check((seen, its_out, mine) == (status, out, err.splitlines()), what, seen, its_err, its_out[-200:])


def check_signal(bench):
    """SIGTERM leaves whole rows, and they can be continued."""
    words = [COMMON / "cube.off", COMMON / "move3.json", "--grid", "100,100,80"]
    path = bench.folder / "killed.csv"
    # without the filter, as mpirun hands a signal on after half a second
    child = subprocess.Popen(command(bench, 3, *words, "--no-filter", "--resume", path), env=MPI_ENVIRONMENT,
                             stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    end = time.monotonic() + SECONDS
    while child.poll() is None and time.monotonic() < end and not (path.exists() and path.stat().st_size > 100000):
        time.sleep(0.01)
    child.send_signal(signal.SIGTERM)
    status = child.wait(SECONDS)
    whole = bench.good("classify", *words)
    text = path.read_bytes()
    bench.check(status != 0 and whole.startswith(text) and text.endswith(b"\n") and text != whole,
                "SIGTERM leaves whole rows", status, text[-100:])
    bench.good("classify", *words, "--resume", path)
    bench.check(path.read_bytes() == whole, "what it left is continued")


def check_all(bench):
    for check in (check_tables, check_faults, check_signal) if ranks(bench.checks, bench.graze, 1) else ():
        check(bench)


if __name__ == "__main__":
    run_checks(__doc__, [check_all])
