#!/usr/bin/env python3
# suite
"""The progress line of graze classify: on standard error where it is a terminal, and nowhere else.
Commands without rows to count show the seconds they have worked, and a signal ends them.
And a row that comes through a pipe is answered before the next one is asked for.

The rows come slower than one a second, so that the line must appear before the end; the counts it
shows are those of the rows sent so far. SPDX-License-Identifier: GPL-3.0-or-later
"""
import concurrent.futures
import itertools
import os
import pathlib
import re
import select
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import Checks, options  # noqa: E402
from machine import read_terminal, terminal  # noqa: E402

COMMON = pathlib.Path(__file__).resolve().parent / "common"
ROWS, PAUSE, SECONDS = 3, 1.3, 60
LINE = re.compile(rb"\r(\d+) rows, (\d+) rows/s   ")


def start(graze, stderr):
    """graze classify, reading rows from a pipe."""
    words = [graze, "classify", COMMON / "cube.off", COMMON / "move3.json", "-"]
    return subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=stderr)


def classify(graze, stderr):
    """Send the rows one after another; (exit status, standard output, standard error's bytes)."""
    child = start(graze, stderr)
    for k in range(ROWS):
        time.sleep(PAUSE if k else 0)
        child.stdin.write(b"%d,0,0\n" % k)
        child.stdin.flush()
    time.sleep(PAUSE)
    out, err = child.communicate(timeout=SECONDS)
    return child.returncode, out, err


def answer_of_half(graze):
    """Output after one row and a half of the next, and output after the rest of it."""
    child = start(graze, subprocess.PIPE)
    child.stdin.write(b"70,80,90\n71,8")
    child.stdin.flush()
    early, end = b"", time.monotonic() + SECONDS
    while b"70,80,90" not in early and time.monotonic() < end:
        if select.select([child.stdout], [], [], 1)[0]:
            early += os.read(child.stdout.fileno(), 65536)
    late, _ = child.communicate(b"1,91", timeout=SECONDS)
    return early, late


def on_terminal(graze, pair):
    """(exit status, table, what is shown) with a pseudo-terminal as standard error."""
    try:
        status, table, _ = classify(graze, pair[1])
    finally:
        os.close(pair[1])
    return status, table, read_terminal(pair[0])


def shown_on_terminal(status, table, shown, plain_table):
    """(what must hold, whether it does, what was seen) of that run."""
    counts = [int(m[1]) for m in LINE.finditer(shown)]
    yield "a run on a terminal ends well", status == 0, status
    yield "nothing but progress is shown", LINE.sub(b"", shown) == b"\r\n", shown
    yield "progress appears before the end", len(counts) >= 3, shown
    yield "counts grow to the number of rows", counts == sorted(counts) and counts[-1:] == [ROWS], counts
    yield "a count is what had been sent", set(counts) <= set(range(ROWS + 1)), counts
    yield "the table is the same", plain_table == table and b"# complete" in table, plain_table


# Each works for minutes: pieces past any tolerance's need, and a motion of degree 200.
LONG = (("motion joints", "motion joints turn:36000:1,2,3 --tolerance 1e-12 --limit pieces=100000000 "
                          "--limit work=1000000000000000"),
        ("draw", "draw {cube} {long} -o {out} --grid 2000 --limit work=1000000000000000"),
        ("boundary", "boundary {cube} {long} --depth 7 --limit work=1000000000000000"))


def cpu_seconds(pid):
    with open(f"/proc/{pid}/stat", encoding="ascii") as file:
        return sum(map(int, file.read().rsplit(")", 1)[1].split()[11:13])) / os.sysconf("SC_CLK_TCK")


def work_and_end(graze, words, pair):
    """(exit status, what was shown, seconds from the signal to the end: of CPU, or a tenth of those that passed if they are more): a signal
    after the line has come twice."""
    child = subprocess.Popen([graze, *words], stdout=subprocess.DEVNULL, stderr=pair[1])
    shown, end = b"", time.monotonic() + SECONDS
    while shown.count(b"working") < 2 and time.monotonic() < end:
        if select.select([pair[0]], [], [], 1)[0]:
            shown += os.read(pair[0], 65536)
    began, before = time.monotonic(), cpu_seconds(child.pid)
    child.send_signal(signal.SIGINT)
    while not os.waitid(os.P_PID, child.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) and time.monotonic() < began + SECONDS:
        time.sleep(0.02)
    used, took = cpu_seconds(child.pid) - before, time.monotonic() - began
    return child.wait(timeout=1), shown, min(took, max(used, took / 10))


def seconds_shown(graze, checks):
    """Promises of commands that count no rows."""
    with tempfile.TemporaryDirectory(prefix="graze-progress-") as folder:
        path = {"cube": str(COMMON / "cube.off"), "long": f"{folder}/long.json", "out": f"{folder}/o.svg"}
        rows = ["+".join(f"({(-1) ** k}/{k + i}{'7' * 30})*t^{k}" for k in range(1, 201)) for i in range(3)]
        with open(path["long"], "w", encoding="utf-8") as file:
            file.write('{"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["%s", "%s", "%s"]}}]}' % tuple(rows))
        pairs = [terminal(checks) for _ in LONG]
        if not all(pairs):
            return
        with concurrent.futures.ThreadPoolExecutor(len(LONG)) as pool:
            ended = list(pool.map(lambda row, pair: work_and_end(graze, [word.format(**path) for word in row[1].split()], pair), LONG, pairs))
        for end in itertools.chain(*pairs):
            os.close(end)
        for (name, _), (status, shown, seconds) in zip(LONG, ended):
            counts = [int(n) for n in re.findall(rb"\rworking, (\d+) s", shown)]
            yield f"{name} shows its seconds, from the second one on", len(counts) > 1 and counts[0] >= 2 and counts == sorted(set(counts)), shown
            yield f"a signal ends {name} within 3 s", status == -signal.SIGINT and seconds < 3, (status, seconds)


def promises(graze, checks):
    """Promises of all runs."""
    pair = terminal(checks)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:  # both wait for their rows
        seen = pool.submit(on_terminal, graze, pair) if pair else None
        plain_status, plain_table, plain_shown = classify(graze, subprocess.PIPE)
    if seen:
        yield from shown_on_terminal(*seen.result(), plain_table)
    yield "a run without a terminal ends well", plain_status == 0, plain_status
    yield "without a terminal nothing is shown", plain_shown == b"", plain_shown
    yield from seconds_shown(graze, checks)
    early, late = answer_of_half(graze)
    yield "a row is answered before more is read", b"\n70,80,90,out," in early, early
    yield "half a row waits for its rest", b"71," not in early and late.startswith(b"71,81,91,out,"), late


def main():
    args, checks = options(__doc__), Checks()
    for what, holds, seen in promises(args.graze, checks):
        checks.holds(holds, what, repr(seen))
    checks.finish()


if __name__ == "__main__":
    main()
