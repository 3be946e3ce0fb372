#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests beside `make test`, stage by stage: of every submission (`ci`, in .ci/run), or by hand (`long`, as `make test-long`).

CI asks what is costly and hangs on few rooms in full where a file of them has changed since the commit of tests/base.txt, else a
sample. `long` asks it in full, goes on where an earlier run at the same commit ended (lib/kept.py), and writes that commit when all has
passed. The first stage that fails ends the run. At the end stands what each took: seconds of wall time, seconds of CPU of all its
processes, its share of the CPU.
"""
import argparse
import collections
import itertools
import os
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

import changed  # noqa: E402
import suitetimes  # noqa: E402
from kept import Kept  # noqa: E402
from run import interpreter  # noqa: E402

# `beside`: one process, which may wait; one more of these than cores runs at a time.
Stage = collections.namedtuple("Stage", "name command beside", defaults=(False,))
# Suites that ask CGAL, whose answers are recorded.
ORACLES = ["agree/minkowski", "agree/laws", "collide/hand", "collide/laws", "collide/minkowski", "collide/peers", "distance/cgal", "judge/sums", "rest/cgal",
           "topo/straight", "topo/duals", "benchmark/codes"]
CHECKER = ["src/check/", "tests/check/", "tests/fuzz/checker/"]
CERTIFIED = [*CHECKER, "src/questions/certify/", "src/decide/trace/", "src/decide/verdict/", "src/input/solid/", "src/input/motion/"]
PROVED = ["proofs/", "tests/proofs/", *CERTIFIED]
WEAKENED = ["verdict.c", "trace.c", "legal.c"]  # what follows a row, and what tells a legal solid; the others read files


def run_suites(*words):
    return ["python3", "tests/run.py", "--build", "build", "--limit", "3000", *words]


def suite(name, *more):
    return run_suites("--only", "tests/" + name, *more)


def script(path, *more):
    return [interpreter()[0], "tests/" + path, "--graze", "build/graze", *more]


def touched():
    """A function: the files of these places that have changed since the commit of tests/base.txt; where git does not know it, the
    places themselves."""
    since = changed.recorded()
    names = None if since is None else changed.files(since)
    return lambda places: list(places) if names is None else [name for name in names if name.startswith(tuple(places))]


def ci(options):
    of = touched()
    return [
        Stage("the rest of the suites", run_suites("--tier", "rest", *(["--record"] if options.record else []))),
        Stage("lint", ["tests/lint.sh"]),
        Stage("sanitizers and coverage", ["tests/stages/sanitizers.sh"]),
        Stage("threads", ["tests/stages/threads.sh", "test_threads.py"]),
        Stage("the checker weakened", script("check/weakened.py", "--only", ",".join(WEAKENED if of(CHECKER) else WEAKENED[:1]))),
        Stage("proofs", ["make", "-s", "proofs", *([] if of(PROVED) else ["BROKEN=--sample"])], True),
        Stage("the site", ["make", "-s", "docs"], True),
        Stage("falsified decisions", ["bash", "-c", "make -s build/tests/graze-flips && "
                                      f"{interpreter()[0]} tests/filter/flip.py --graze build/tests/graze-flips"], True),
        Stage("pages in a browser", script("page/browser.py"), True),
        Stage("forged certificates", script("check/forged.py", *([] if of(CERTIFIED) else ["--only", "outside"])), True),
        Stage("candidates in pandas", script("compare/python_candidates.py", "--pandas"), True),
        Stage("packages of Python", script("python/packages.py"), True),
        Stage("mutants of the rules", ["python3", "tests/mutate.py", "--only", "decide/verdict", "--each", "1000"]),
        Stage("mutants of changed files", ["python3", "tests/mutate.py", "--changed", "--each", "3", "--minutes", "4", "--wanted", "75", "--seed",
                                           "2008"]),
    ]


def long(options):
    """Stages with more input for code that CI asks too, those that CI asks by samples alone, and CI's suites in another way."""
    seed = ["--seed", options.seed]
    return [
        Stage("random suites at twice the scale", run_suites("--tier", "long", *seed, "--skip", "tests/memory/", "--skip", "tests/contact/probe",
                                                             "--skip", "tests/check/golden", "--skip", "tests/distance/cgal",
                                                             "--skip", "tests/collide/distances", "--skip", "tests/collide/round")),
        Stage("1,000 contact points probed", suite("contact/probe", "--scale", "4", *seed), True),
        Stage("certificates of 300 rows a case", suite("check/golden", "--scale", "15", *seed), True),
        Stage("1,000 distances to Minkowski sums", suite("distance/cgal", "--scale", "4", *seed), True),
        Stage("1,000 pairs at a clearance", suite("collide/distances", "--scale", "17", *seed), True),
        Stage("2,000 round pairs and traces", suite("collide/round", "--scale", "25", *seed), True),
        Stage("distances of FCL and Bullet at 1,000 times", ["python3", "cases/candidates/distances.py", "--graze", "build/graze"], True),
        Stage("forged certificates of all cases", script("check/forged.py", "--scale", "2"), True),
        Stage("packages of Python", script("python/packages.py"), True),
        Stage("tests in Catch2, doctest, GoogleTest", script("adapters/adapters.py", "--all"), True),
        Stage("CGAL's answers anew", ["env", "GRAZE_ORACLES=anew", *run_suites(*(word for name in ORACLES for word in ("--only", "tests/" + name)))]),
        Stage("archives, wheel and container in bare systems", script("install/dist.py"), True),
        Stage("memory in full", script("memory/memory.py", "--scale", "2"), True),
        Stage("proofs", ["make", "-s", "proofs"], True),
        Stage("the checker weakened", script("check/weakened.py"), True),
        Stage("the checker without GMP", script("check/mini.py"), True),
        Stage("the checker in a browser", script("page/checker.py"), True),
        Stage("threads of all of Python", ["tests/stages/threads.sh", "test_*.py"]),
        Stage("Python's own fractions, runs by exec", ["env", "GRAZE_FRACTIONS=python", "GRAZE_EXEC=1", *run_suites("--tier", "all")]),
        Stage("mutants of every room", ["python3", "tests/mutate.py", "--minutes", "30", "--wanted", "80", *seed]),
        Stage("fuzz targets, a minute each", ["make", "-s", "fuzz", "SECONDS=60"]),
    ]


class Run:
    """Stages one after the other or beside each other, and what each took."""

    def __init__(self, took, kept=None):
        self.rows = [(name, float(wall), float(cpu)) for name, wall, cpu in took]
        self.passed, self.failed, self.kept = 0, [], kept

    def ended(self, stage, began, status, used):
        wall = time.time() - began
        self.rows.append((stage.name, wall, used.ru_utime + used.ru_stime))
        if status:
            self.failed.append(stage.name)
        self.passed += status == 0
        if self.kept:
            self.kept.ended(stage.name, *self.rows[-1][1:], failed=status != 0)
        print(f"== {stage.name}: {wall:.0f} s" + (", FAILED" if status else ""), flush=True)

    def one(self, stage):
        print(f"== {stage.name}", flush=True)
        began = time.time()
        child = subprocess.Popen(stage.command, stdin=subprocess.DEVNULL)
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        self.ended(stage, began, status, used)

    def beside(self, stages):
        """None begins after one failed. What each said is shown when it has ended."""
        waiting, running = list(stages), {}
        while running or (waiting and not self.failed):
            while waiting and not self.failed and len(running) <= os.cpu_count():
                stage, said = waiting.pop(0), tempfile.TemporaryFile()
                print(f"== {stage.name} begins", flush=True)
                child = subprocess.Popen(stage.command, stdin=subprocess.DEVNULL, stdout=said, stderr=said)
                running[child.pid] = stage, said, time.time(), child
            pid, status, used = os.wait3(0)
            stage, said, began, child = running.pop(pid)
            child.returncode = os.waitstatus_to_exitcode(status)
            with said:
                said.seek(0)
                print(said.read().decode("utf-8", "replace"), end="", flush=True)
            self.ended(stage, began, status, used)

    def all(self, stages):
        for together, group in itertools.groupby(stages, lambda stage: stage.beside):
            for part in [list(group)] if together else group:
                if not self.failed:
                    (self.beside if together else self.one)(part)

    def cpu(self):
        return sum(cpu for _, _, cpu in self.rows)

    def table(self):
        whole = self.cpu() or 1
        lines = [("stage", "wall s", "CPU s", "share")]
        lines += [(name, f"{wall:.0f}", f"{cpu:.0f}", f"{100 * cpu / whole:.0f} %") for name, wall, cpu in self.rows]
        lines.append(("all stages", "", f"{whole:.0f}", ""))
        return "\n".join(f"{a:<45}{b:>8}{c:>8}{d:>8}" for a, b, c, d in lines)


def from_first(stages, options, parser):
    """The stages from --from on."""
    names = [stage.name for stage in stages]
    if options.first and options.first not in names:
        parser.error(f"--from {options.first}: expected one of {', '.join(names)}")
    return stages[names.index(options.first) if options.first else 0:]


def end(run, before):
    """The status of a run, whose failures are named once more: of a long log often the end alone is read."""
    for name in run.failed:
        print(f"== {name} FAILED, see above")
    print(f"{run.passed + before} passed, {len(run.failed)} failed")
    return 1 if run.failed or not run.passed + before else 0


def run_ci(options, parser):
    run, began = Run(options.took), time.time()
    run.all(from_first(ci(options), options, parser))
    wall = time.time() - began + sum(float(wall) for _, wall, _ in options.took)
    print(f"{run.table()}\n{wall:.0f} s in all")
    if options.record and not run.failed:
        suitetimes.write({(suitetimes.CI, suitetimes.WHOLE): (wall, run.cpu())}, suitetimes.parts())
    return end(run, 0)


def run_long(options, parser):
    """Stages that have passed at this commit with this seed are not asked again, but by --from."""
    kept = Kept(options.seed)
    options.seed = kept.seed
    stages = long(options)
    asked = from_first(stages, options, parser) if options.first else [stage for stage in stages if stage.name not in kept.passed]
    before = {stage.name: kept.passed[stage.name] for stage in stages if stage.name in kept.passed and stage not in asked}
    print(f"seed {options.seed}" if kept.commit else f"seed {options.seed}; this tree is not that of a commit, so that no stage is kept")
    if before:
        print(f"goes on at {kept.commit[:12]}, where these have passed: {', '.join(before)}", flush=True)
    run, began = Run([(name, *took) for name, took in before.items()], kept), time.time()
    run.all(asked)
    print(f"{run.table()}\n{time.time() - began:.0f} s in this run")
    if not run.failed:
        print(kept.make_base([stage.name for stage in stages]))
    return end(run, len(before))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("which", choices=["ci", "long"])
    parser.add_argument("--seed", default="", help="of what is drawn in `long`: a whole number, the day if none is given")
    parser.add_argument("--took", nargs=3, action="append", default=[], metavar=("NAME", "WALL", "CPU"),
                        help="a stage that the caller ran, for the table")
    parser.add_argument("--from", dest="first", default="", metavar="NAME", help="begin at this stage, as after one that failed")
    parser.add_argument("--record", action="store_true", help="write what `ci` and its suites took into tests/times.txt, if nothing failed")
    options = parser.parse_args()
    os.chdir(changed.ROOT)
    sys.exit((run_long if options.which == "long" else run_ci)(options, parser))


if __name__ == "__main__":
    main()
