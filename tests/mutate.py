#!/usr/bin/env python3
"""Mutation test of the code that decides contacts, counts and classes, and of a sample of the code around it.

Every comparison, logical connective and sign in the files below is changed, one at a time. Each mutant is put to the tables
of the cases, the unit tests and the suites below until one notices it. The exact path is asked (--no-filter), and for
src/decide/trace also what lies between it and the filter. A mutant that no suite notices is an error unless tests/mutants.txt lists
it with the reason why it is equivalent. A sample of the filter, comparison, reports, conversion
and tables is asked, as mutation/glue.py defines it. `--sample K/N` takes every N-th mutant from K on. Wants a finished `make test`.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import collections
import concurrent.futures
import glob
import os
import queue
import re
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "mutation"))

import corpus  # noqa: E402
import glue  # noqa: E402
from changes import known_equivalents, mutants  # noqa: E402
from corpus import Suite  # noqa: E402

FILES = [
    "src/decide/verdict/verdict.c", "src/decide/trace/point.c", "src/decide/trace/trace.c", "src/decide/trace/tracer.c", "src/decide/trace/crosscheck.c",
    "src/decide/trace/word.c", "src/decide/trace/contact.c", "src/decide/trace/touch.c", "src/decide/trace/time.c",
    "src/decide/trace/trajectory.c", "src/decide/trace/candidates.c", "src/input/solid/locate.c",
    "src/input/solid/create.c", "src/input/solid/solid.c", "src/input/solid/forms.c", "src/input/solid/planes.c", "src/input/solid/tree.c",
    "src/base/number/algebraic.c", "src/base/number/isolate.c", "src/base/number/bernstein.c",
    "src/base/number/order.c", "src/base/number/dyadic.c", "src/base/number/modular.c", "src/base/number/refine.c",
    "src/base/number/wide.c", "src/base/number/sign.c", "src/base/number/cross.c",
]
EXACT = "--no-filter"
SUITES = [Suite(f"tests/{name}.py", EXACT) for name in (
    "examples/examples", "agree/near", "cases/cases", "agree/second_tracer", "words/words", "agree/laws",
    "unsweep/properties")]
# What decides between the filter and the exact path is asked with the filter, too.
FILTERED = [Suite(suite.script, "") for suite in SUITES[:4]]
REFUSE, REFUSE_SECONDS = "tests/refuse/run.py", 60
UNITS = ["tests/unit/test_algebraic", "tests/unit/test_modular", "tests/unit/test_refine",
         "tests/unit/test_forms", "tests/unit/test_locate", "tests/unit/test_locate_cells"]
LATE_UNITS = ["tests/api/test_word", "tests/unit/test_bernstein", "tests/api/test_classify", "tests/api/test_memory",
              "tests/api/test_exact_count", "tests/api/test_handles",
              "tests/api/test_reports"]
UNIT_SECONDS = 30
CFLAGS = ["-std=c11", "-D_GNU_SOURCE", "-O1", "-w", "-pthread", "-Iinclude", "-Isrc"]
SANITIZE = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
LIBS = ["-lyajl", "-lmd", "-lflint", "-lmpfr", "-lgmp", "-lm", "-lstdc++", "-pthread"]


def compile_c(out, source, *more):
    return subprocess.run(["gcc", *CFLAGS, *more, "-c", "-o", out, source],
                          stderr=subprocess.DEVNULL).returncode == 0


def link(out, *objects):
    subprocess.run(["g++", "-fuse-ld=gold", "-Wl,-rpath,$ORIGIN", "-o", out, *objects, *LIBS], check=True)


def bound():
    """Some mutants never end, or never stop asking for memory."""
    resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
    resource.setrlimit(resource.RLIMIT_CPU, (UNIT_SECONDS, UNIT_SECONDS + 1))


def is_red(command, limit, before=None):
    """Whether a program fails, says FAIL or does not end in time. What it started ends with it."""
    started = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                               stdin=subprocess.DEVNULL, preexec_fn=before, start_new_session=True,
                               env={**os.environ, "PYTHONUNBUFFERED": "1"})

    def end():
        try:
            os.killpg(started.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass

    timer = threading.Timer(limit, end)
    timer.start()
    with started.stdout as lines:
        failed = any(line.startswith(b"FAIL") for line in lines)
    if failed:
        end()
    status = started.wait()
    timer.cancel()
    return failed or status != 0


class Parts:
    """What all mutants share: the program's objects without debugging data, and its unit tests."""

    def __init__(self, build, folder):
        self.archive = os.path.join(folder, "libgraze.a")
        subprocess.run(["strip", "-g", "-o", self.archive, f"{build}/libgraze.a"], check=True)
        main, replay = os.path.join(folder, "main.o"), os.path.join(folder, "replay.o")
        compile_c(main, "src/program/cli/main.c", "-Dmain=graze_main")
        compile_c(replay, "tests/mutation/replay.c")
        sources = sorted(glob.glob("src/program/cli/*.c") + glob.glob("src/program/run/*.c"))
        self.program = [main, replay] + [f"{build}/{name[:-2]}.o" for name in sources if name != "src/program/cli/main.c"]
        self.build, self.folder = build, folder
        self.sound = set()  # those asked that are green without any mutant

    def bench(self, name):
        """A folder that stands in for the build folder, with the other programs of the tests."""
        path = os.path.join(self.folder, name)
        os.makedirs(path)
        for name in ["tests", *(os.path.basename(so) for so in glob.glob(f"{self.build}/*.so"))]:
            os.symlink(os.path.abspath(os.path.join(self.build, name)), os.path.join(path, name))
        return path


def wrapper(folder, graze, flag, seconds=corpus.CPU_SECONDS):
    """A program that is `graze` with an option and a bound on its time."""
    return corpus.executable(os.path.join(folder, f"graze-{seconds}{flag}"), corpus.WRAPPER.format(
        graze=graze, flag=flag, seconds=seconds))


def refuses_badly(folder, graze):
    """Whether the refusals are red. Runs that a signal ends take some seconds of two cores."""
    return suite_is_red(REFUSE, wrapper(folder, graze, EXACT, UNIT_SECONDS), REFUSE_SECONDS)


def suite_is_red(script, program, seconds):
    return is_red([sys.executable, script, "--graze", program], 30 + 5 * seconds)


class Worker:
    """One mutant at a time, in a folder of its own."""

    def __init__(self, parts, name, suites, cases):
        self.parts, self.suites, self.cases = parts, suites, cases
        self.filtered_cases = corpus.cases_list(os.path.join(parts.folder, "filtered-cases"), "")
        self.folder, self.plain = parts.bench(name), {}
        self.graze = os.path.join(self.folder, "graze")
        self.object = os.path.join(self.folder, "mutant.o")
        self.wrappers = {flag: wrapper(self.folder, self.graze, flag) for flag in ("", EXACT)}

    def unit(self, name, flags=(), before=bound):
        program = os.path.join(self.folder, "unit")
        link(program, f"{self.parts.build}/{name}.o", self.object, self.parts.archive, "-lcmocka", *flags)
        return is_red([program], 10 * UNIT_SECONDS, before)

    def suite(self, script, flag, seconds):
        return suite_is_red(script, self.wrappers[flag], seconds)

    def is_noticed_by(self, asker):
        """Whether one of those asked about the code around the kernel notices the program as it is linked now."""
        if asker == glue.CASES:
            return corpus.replay(self.graze, self.filtered_cases)
        if ".py" in asker:
            return is_red([sys.executable, *asker.split(), "--graze", self.graze], glue.SECONDS)
        return self.unit(asker)

    def glue_killer(self, path):
        """The first of those asked that notices it. One that is red without any mutant, too, ends the run."""
        asker = next(filter(self.is_noticed_by, glue.askers(path)), None)
        if asker and asker not in self.parts.sound:
            with open(path, encoding="utf-8") as file:
                self.compiled(file.read())
            link(self.graze, *self.parts.program, self.object, self.parts.archive)
            if self.is_noticed_by(asker):
                raise SystemExit(f"{asker} is red without any mutant")
            self.parts.sound.add(asker)
        return asker

    def killer(self, path):
        """Which suite notices the program as it is linked now; None if none does."""
        if glue.askers(path):
            return self.glue_killer(path)
        if corpus.replay(self.graze, self.cases):
            return "tests/cases/cases.py"
        for name in UNITS if not path.startswith("src/decide/trace") else []:
            if self.unit(name):
                return name
        for suite in self.suites:
            found = corpus.replay(self.graze, suite.list)
            if found and (found == "S" or self.suite(suite.script, suite.flag, suite.seconds)):
                return suite.name
        for name in LATE_UNITS:
            if self.unit(name):
                return name
        if refuses_badly(self.folder, self.graze):
            return REFUSE
        return "address sanitizer" if self.is_unsafe() else None

    def is_unsafe(self):
        """Whether the mutant reads or writes where it must not, in a run of the cases or the
        examples or a unit test. Called last: the object is compiled once more."""
        compile_c(self.object, os.path.join(self.folder, "mutant.c"), *SANITIZE)
        link(self.graze, *self.parts.program, self.object, self.parts.archive, SANITIZE[0])
        return (any(corpus.replay(self.graze, runs, None)
                    for runs in (self.cases, self.suites[0].list)) or
                any(self.unit(name, SANITIZE[:1], None) for name in UNITS))

    def compiled(self, text):
        """The object code of a source, which stays as self.object; None if it does not compile."""
        source = os.path.join(self.folder, "mutant.c")
        with open(source, "w", encoding="utf-8") as file:
            file.write(text)
        if not compile_c(self.object, source):
            return None
        with open(self.object, "rb") as file:
            return file.read()

    def judge(self, mutant):
        """Fate of a mutant: `void`, `same code`, the suite that notices it, or None."""
        with open(mutant.path, encoding="utf-8") as file:
            plain = file.read()
        if mutant.path not in self.plain:
            self.plain[mutant.path] = self.compiled(plain)
        code = self.compiled(mutant.source)
        if code in (None, self.plain[mutant.path]):
            return "same code" if code else "void"
        link(self.graze, *self.parts.program, self.object, self.parts.archive)
        return self.killer(mutant.path)


def prepare(parts, folder, suites, kernel):
    """Record the suites on the unchanged program; the list of the cases, or None if one is red."""
    bench = parts.bench("unchanged")
    graze = os.path.join(bench, "graze")
    link(graze, *parts.program, parts.archive)
    cases = corpus.cases_list(os.path.join(parts.folder, "cases"), EXACT)
    if corpus.replay(graze, cases):
        print("the cases are red without any mutant")
        return None
    for suite in suites:
        if not corpus.record(folder, suite, graze):
            print(f"{suite.name} is red without any mutant")
            return None
    if kernel and refuses_badly(bench, graze):
        print(f"{REFUSE} is red without any mutant")
        return None
    return cases


def run(parts, folder, options, chosen):
    """(mutant, its fate) for each mutant, in the order of their ends."""
    kernel = any(not glue.askers(m.path) for m in chosen)
    suites = SUITES + (FILTERED if any("src/decide/trace" in m.path for m in chosen) else []) if kernel else []
    cases = prepare(parts, folder, suites, kernel)
    if cases is None:
        return
    idle = queue.Queue()
    for k in range(options.jobs):
        idle.put(Worker(parts, f"worker-{k}", suites, cases))

    def one(mutant):
        worker = idle.get()
        try:
            return mutant, worker.judge(mutant)
        finally:
            idle.put(worker)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for done in concurrent.futures.as_completed(pool.submit(one, m) for m in chosen):
            yield done.result()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", default="build")
    parser.add_argument("--sample", default="0/1", help="K/N: every N-th mutant from K on")
    parser.add_argument("--only", default="", help="only where this pattern meets PATH:LINE:")
    parser.add_argument("--jobs", type=int, default=1, help="mutants at a time")
    parser.add_argument("--corpus", help="folder that keeps the recorded runs from call to call")
    parser.add_argument("--verbose", action="store_true", help="print the fate of each mutant")
    options = parser.parse_args()
    first, step = (int(n) for n in options.sample.split("/"))
    known = known_equivalents("tests/mutants.txt")
    everything = [m for m in [*(m for path in FILES for m in mutants(path)), *glue.sample()]
                  if re.search(options.only, f"{m.path}:{m.line}:")]
    chosen = everything[first::step]
    fates, start = collections.Counter(), time.time()
    fates["equivalent"] = sum(m.key() in known for m in chosen)
    with tempfile.TemporaryDirectory() as folder:
        parts = Parts(options.build, folder)
        wanted = [m for m in chosen if m.key() not in known]
        for mutant, fate in run(parts, options.corpus or folder, options, wanted):
            fates[fate] += 1
            if fate is None:
                print(f"SURVIVED {mutant.path}:{mutant.line}\n" + "\n".join(mutant.key()) + "\n",
                      flush=True)
            elif options.verbose:
                print(f"{time.time() - start:.0f} s {mutant.path}:{mutant.line} {mutant.what}: "
                      f"{fate}", flush=True)
    survived, nothing = fates[None], fates["equivalent"] + fates["same code"] + fates["void"]
    noticed = sum(fates.values()) - survived - nothing
    unfinished = len(chosen) - sum(fates.values())
    print(f"{len(chosen)} mutants of {len(everything)}, {time.time() - start:.0f} s: "
          f"{noticed} noticed, {survived} survived")
    for fate, count in fates.most_common():
        print(f"{count:6d} {fate or 'survived'}")
    print(f"{noticed} passed, {survived + unfinished} failed")
    sys.exit(1 if survived or unfinished or not chosen else 0)


if __name__ == "__main__":
    main()
