#!/usr/bin/env python3
"""What is asked beside `make test`, stage by stage: of every submission (`ci`, in .ci/run), or by hand (`long`, as `make test-long`).

The first stage that fails ends the run. At the end stands what each took: seconds of wall time, seconds of CPU of all its
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

import suitetimes  # noqa: E402

# `beside`: one process; as many of these as there are cores run at a time.
Stage = collections.namedtuple("Stage", "name command beside", defaults=(False,))


def suite(name, *more):
    return ["python3", "tests/run.py", "--build", "build", "--limit", "3000", "--only", "tests/" + name, *more]


def script(path, *more):
    return ["python3", "tests/" + path, "--graze", "build/graze", *more]


def ci(_):
    return [
        Stage("proofs", ["make", "-s", "proofs"]),
        Stage("lint", ["tests/lint.sh"]),
        Stage("address and undefined behaviour", ["tests/stages/sanitizers.sh"]),
        Stage("threads", ["tests/stages/threads.sh", "test_threads.py"]),
        Stage("coverage", ["make", "-s", "coverage"]),
        Stage("the checker weakened", script("check/weakened.py", "--only", "verdict.c,trace.c,legal.c")),
        Stage("the site", ["make", "-s", "docs"], True),
        Stage("falsified decisions", ["bash", "-c", "make -s build/tests/graze-flips && "
                                      "python3 tests/filter/flip.py --graze build/tests/graze-flips"], True),
        Stage("pages in a browser", script("page/browser.py"), True),
        Stage("forged certificates", script("check/forged.py"), True),
        Stage("candidates in pandas", script("compare/python_candidates.py", "--pandas"), True),
        Stage("packages of Python", script("python/packages.py"), True),
        Stage("mutants of the rules", ["python3", "tests/mutate.py", "--only", "decide/verdict", "--each", "1000"]),
    ]


def long(seed):
    """What gives more inputs to code that CI asks too, and what asks CI's suites in another way."""
    return [
        Stage("with and without the filter, twice as many", suite("filter/equal", "--scale", "2", "--seed", seed), True),
        Stage("1,000 contact points probed", suite("contact/probe", "--scale", "4", "--seed", seed), True),
        Stage("certificates of 300 rows a case", suite("check/golden", "--scale", "15", "--seed", seed), True),
        Stage("1,000 distances to Minkowski sums", suite("distance/cgal", "--scale", "4", "--seed", seed), True),
        Stage("threads of all of Python", ["tests/stages/threads.sh", "test_*.py"]),
        Stage("Python's own fractions", ["env", "GRAZE_FRACTIONS=python", "python3", "tests/run.py", "--build", "build"]),
        Stage("mutants of every room", ["python3", "tests/mutate.py", "--minutes", "30", "--wanted", "80", "--seed", seed]),
    ]


class Run:
    """Stages one after the other or beside each other, and what each took."""

    def __init__(self, took):
        self.rows = [(name, float(wall), float(cpu)) for name, wall, cpu in took]
        self.passed, self.failed = 0, []

    def ended(self, stage, began, status, used):
        wall = time.time() - began
        self.rows.append((stage.name, wall, used.ru_utime + used.ru_stime))
        if status:
            self.failed.append(stage.name)
        self.passed += status == 0
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
            while waiting and not self.failed and len(running) < os.cpu_count():
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


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("which", choices=["ci", "long"])
    parser.add_argument("--seed", default="", help="of what is drawn in `long`: a whole number, the day if none is given")
    parser.add_argument("--took", nargs=3, action="append", default=[], metavar=("NAME", "WALL", "CPU"),
                        help="a stage that the caller ran, for the table")
    parser.add_argument("--from", dest="first", default="", metavar="NAME", help="begin at this stage, as after one that failed")
    parser.add_argument("--record", action="store_true", help="write what `ci` took into tests/times.txt, if nothing failed")
    options = parser.parse_args()
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    seed = options.seed or time.strftime("%Y%m%d")
    began = time.time()
    if options.which == "long":
        print(f"seed {seed}", flush=True)
    stages = {"ci": ci, "long": long}[options.which](seed)
    names = [stage.name for stage in stages]
    if options.first and options.first not in names:
        parser.error(f"--from {options.first}: expected one of {', '.join(names)}")
    run = Run(options.took)
    run.all(stages[names.index(options.first) if options.first else 0:])
    print(run.table())
    wall = time.time() - began + sum(float(wall) for _, wall, _ in options.took)
    print(f"{wall:.0f} s in all")
    if options.record and options.which == "ci" and not run.failed:
        suitetimes.write({suitetimes.CI: (wall, run.cpu())})
    for name in run.failed:  # named once more at the end: of a long log often the end alone is read
        print(f"== {name} FAILED, see above")
    print(f"{run.passed} passed, {len(run.failed)} failed")
    sys.exit(1 if run.failed or not run.passed else 0)


if __name__ == "__main__":
    main()
