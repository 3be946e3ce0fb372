#!/usr/bin/env python3
# suite
"""Memory that runs out: every command runs once for each allocation that can fail, by itself or with all after it.

fail.c stands in front of malloc, for every library. A run must end as without a failure, the same bytes written, or
with status 5 and a last message about memory; then it leaves no file but whole lines of the beginning of a table. Which allocations
fail: a fixed eighth of those that are reached on ways that differ, at least one a scene, all ways through sources that were changed
since the commit of tests/base.txt, and some more; from --scale 2 on all ways, from --scale 16 on every allocation.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
import concurrent.futures
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import scenes  # noqa: E402
import ways  # noqa: E402
from harness import Checks, options  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
MEMORY = re.compile(r"memory", re.I)
RECORD = re.compile(rb"graze kept 1 .* sum [0-9a-f]{16}\n")
CHANGING = re.compile(rb"time: .* rows a second|\"milliseconds\": \d+,\n\"rows-per-second\": \d+|/graze-\w{6}/")  # of graze validate
# The C library itself aborts where a thread's first object of C++ cannot be noted down; it is CGAL's.
NO_DESTRUCTOR = "Fatal glibc error: failed to register TLS destructor: out of memory\n"
SHOWN = 12  # faults of one kind are shown once, kinds up to here


def build(folder):
    """The library that makes allocations fail."""
    library = pathlib.Path(folder) / "fail.so"
    subprocess.run([os.environ.get("CC", "cc"), "-std=c11", "-O2", "-shared", "-fPIC", "-o", library,
                    HERE / "fail.c", "-lgcc_s"], check=True)
    return library


class Bench:
    """The program, the way to make it fail, and a folder."""

    def __init__(self, args, folder):
        self.graze = args.graze
        self.wrapped = args.sanitizers
        if self.wrapped:
            self.graze = os.path.join(os.path.dirname(self.graze), "tests", "graze-memory")
        self.folder = pathlib.Path(folder)
        self.scale = args.scale
        self.changes = not self.wrapped  # whether ways through changed files are tried, all of them
        self.library = None if self.wrapped else build(folder)

    def environment(self, scene, **more):
        known = self.folder / "known-leaks"  # CGAL forgets a block where the list of blocks cannot grow
        known.write_text("leak:CGAL::Compact_container\n")
        kept = dict(os.environ, LC_ALL="C", TMPDIR=".", LSAN_OPTIONS=f"suppressions={known}:print_suppressions=0", **more)
        if scene.spared:
            kept["GRAZE_FAIL_SPARE"] = scene.spared
        if self.library:
            kept["LD_PRELOAD"] = str(self.library)
        return kept


def files_of(folder):
    """The files that a run has left, apart from its output."""
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*")
            if p.is_file() and str(p.relative_to(folder)) not in ("out", "err")}


class Run:
    """How one run ended and what it left."""

    def __init__(self, folder, status):
        self.status = status
        self.out = (folder / "out").read_bytes()
        self.err = (folder / "err").read_text("utf-8", "replace")
        self.files = {name: CHANGING.sub(b"", content) for name, content in files_of(folder).items()}
        self.folders = sorted(str(p.relative_to(folder)) for p in folder.rglob("*") if p.is_dir())
        shutil.rmtree(folder)


def is_begun(found, whole):
    """Whether the bytes are whole lines of the beginning of a table, which its last line decides."""
    return whole.startswith(found) and (found == whole or not found or (found.endswith(b"\n") and b"# complete" not in found))


def last_line(text):
    lines = [line for line in text.splitlines() if line.strip()]
    return lines[-1] if lines else "no message"


def fault_of(run, whole, scene):
    """The fault in the end of a run; None if there is none."""
    if os.WIFSIGNALED(run.status) and os.WTERMSIG(run.status) == signal.SIGABRT and run.err == NO_DESTRUCTOR:
        return None
    if os.WIFSIGNALED(run.status):
        return f"{signal.Signals(os.WTERMSIG(run.status)).name}: {last_line(run.err)}"
    if run.status == whole.status:
        if run.out != whole.out:
            return "other standard output with the same status"
        if run.files != whole.files or run.folders != whole.folders:
            return "other files with the same status"
        return None
    if os.WEXITSTATUS(run.status) != 5:
        return f"status {os.WEXITSTATUS(run.status)}: {last_line(run.err)}"
    if not last_line(run.err).startswith("graze: ") or not MEMORY.search(last_line(run.err)):
        return f"status 5 says: {last_line(run.err)}"
    if not is_begun(run.out, whole.out):
        return "wrong bytes on standard output before status 5"
    for name, found in run.files.items():
        if name in scene.files and found == scene.files[name]:
            continue
        if name.endswith(".kept") and RECORD.fullmatch(found):  # tests/shards/record.py asks what it says
            continue
        if name not in whole.files or not is_begun(found, whole.files[name]):
            return f"status 5 leaves {name}, which is not the beginning of a table"
        if name in scene.opened and not found:
            continue
        if name not in scene.tables and found != whole.files[name]:
            return f"status 5 leaves {name} half-written"
    if run.folders != scene.folders:
        return f"status 5 leaves the folders {' '.join(run.folders)}"
    return None


def serve(bench, scene, folder, runs):
    """Run the scene for each (mode, N); yields (mode, N, Run)."""
    for mode, n in runs:
        scene.lay_out(folder / f"{mode}-{n}")
    lines = "".join(f"{mode} {n}\n" for mode, n in runs)
    done = subprocess.run([bench.graze] + scene.arguments, input=lines.encode(), stdout=subprocess.PIPE,
                          env=bench.environment(scene, GRAZE_FAIL_RUNS=str(folder)), check=True)
    for line in done.stdout.decode().splitlines():
        mode, n, status = line.split()
        yield mode, int(n), Run(folder / f"{mode}-{n}", int(status))


def ways_of(bench, scene):
    """The number of the way to each allocation of a run, 0 for those that are spared, and the calls on each way."""
    folder = bench.folder / scene.name
    folder.mkdir()
    place = folder / "list"
    scene.lay_out(place)
    subprocess.run([bench.graze] + scene.arguments, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=place,
                   stdin=subprocess.DEVNULL, env=bench.environment(scene, GRAZE_FAIL_LIST=str(folder / "ways")), check=False)
    shutil.rmtree(place)
    return ways.read(str(folder / "ways"), bench.graze)


def choose(bench, listed):
    """The runs of each scene, (mode, N)."""
    sources, base = ways.changed() if bench.changes else (set(), "not asked")
    choice = ways.Choice(bench.scale, sources)
    own = [choice.own(*found) for found in listed]
    names = ways.Names(place for found in own for way in found for place in way.calls)
    chosen = [choice.runs(numbers, found, names) for (numbers, _), found in zip(listed, own)]
    print(f"{sum(map(len, own))} ways, {sum(n for _, n in chosen)} of them through {len(sources)} changed sources (base: {base}), "
          f"{sum(len(runs) for runs, _ in chosen)} runs", flush=True)
    return [runs for runs, _ in chosen]


def test(bench, scene, count, runs):
    """(runs, ends told, faults: kind -> list of runs) of a scene."""
    folder = bench.folder / scene.name
    whole = next(serve(bench, scene, folder, [("once", count * 2 + 1000)]))[2]
    faults, told = collections.defaultdict(list), 0
    if not os.WIFEXITED(whole.status) or os.WEXITSTATUS(whole.status) != scene.status:
        faults[f"does not run at all: status {whole.status}: {whole.err}"].append("")
        return 0, faults
    for start in range(0, len(runs), 500):
        for mode, n, run in serve(bench, scene, folder, runs[start:start + 500]):
            fault = fault_of(run, whole, scene)
            told += os.WIFEXITED(run.status) and os.WEXITSTATUS(run.status) == 5
            if fault:
                faults[fault].append(f"{mode} {n}")
    if not told:
        faults["no run ended with status 5"].append("")
    return told, faults


def main():
    args = options(__doc__, ("names", {"nargs": "*", "help": "scenes; all if none is named"}))
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        bench = Bench(args, folder)
        every = [s for s in scenes.make(bench.graze, pathlib.Path(folder)) if (not args.names or s.name in args.names)
                 and not (bench.wrapped and "cairo" in s.spared)]
        listed = list(pool.map(lambda s: ways_of(bench, s), every))
        runs, counts = choose(bench, listed), [len(numbers) for numbers, _ in listed]
        for scene, tried, (told, faults) in zip(every, runs, pool.map(lambda *a: test(bench, *a), every, counts, runs)):
            wrong = sum(len(which) for which in faults.values())
            checks.passed, checks.failed = checks.passed + max(len(tried) - wrong, 0), checks.failed + wrong
            print(f"{scene.name}: {len(tried)} runs, {told} with status 5, {wrong} wrong", flush=True)
            for kind, which in sorted(faults.items(), key=lambda pair: -len(pair[1]))[:SHOWN]:
                print(f"  {len(which)} x {kind} ({', '.join(which[:3])})")
    checks.finish()


if __name__ == "__main__":
    main()
