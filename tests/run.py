#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Run test suites and add up what they counted.

A suite is a C file of tests/unit or tests/api, which is a cmocka program, or a script tests/FOLDER/*.py that runs
when it is called (`if __name__ == "__main__"`). Its summary is `N passed, N failed` or `N passed, N failed, N
skipped`, or cmocka's own. The tables of tests/README.md record each of them: its rooms, the tier that runs it, and the least number of
checks that it must count. A suite or script without a row, a row without a file, a row whose rooms, tier or checks are not such, a suite
that counts fewer checks than recorded, dies, or runs too long is one failure.

Tiers: `test` has all that is derived, and the first quarter of random input; `rest` the other three quarters, and what is costly;
`sanitizers` what `test` has, and what is costly; `long` random input at twice the scale or --scale, and what is costly; `all` everything
at scale 1. Golden cases and unit tests begin, and end the run where one fails; then what is derived, then what is random, long ones first.
Lines `SKIP name: reason` are passed on; a name that the environment's GRAZE_SKIPS does not list, if it is there, is a failure. The last
line of all is the sum.
"""
import argparse
import collections
import concurrent.futures
import functools
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

import suiterows  # noqa: E402
import suitetimes  # noqa: E402
from suitetimes import QUARTER, REST, WHOLE  # noqa: E402

PLAIN = re.compile(r"^(?:\w+: )?(\d+) passed, (\d+) failed(?:, (\d+) skipped)?$", re.M)
CMOCKA_PASSED = re.compile(r"\[  PASSED  \] (\d+) test")
CMOCKA_FAILED = re.compile(r"\[  FAILED  \] (\d+) test")
CMOCKA_SKIPPED = re.compile(r"\[  SKIPPED \] (\d+) test")
SKIPPED = re.compile(r"^ *SKIP ([\w-]+):", re.M)
# Suites that run in the plain build alone, not with a sanitizer nor for coverage: those about sources and other programs, and those
# that give many more inputs to code which other suites run too, as the coverage by file without them shows.
PLAIN_ALONE = [
    "structure/", "runner/runner", "runner/tries", "runner/rounds", "install/", "readme/", "cases/recompute", "curved/schema", "motioncmd/schema",
    "agree/", "words/", "unsweep/properties", "curved/germs", "curved/polyhedra",
    "topo/germs", "topo/straight", "topo/orders", "topo/prisms",
    "filter/equal", "filter/columns", "filter/contraction", "envelope/derivation", "contact/derivation", "benchmark/", "judge/sums",
]
# Golden cases and tests of functions: where one of these fails, the rest is not asked.
FIRST = ("cases/cases.py", "unit/", "api/")
# tier of a call -> {tier of a suite: the part of it that runs}
PARTS = {
    "test": {"derived": WHOLE, "random": QUARTER},
    "rest": {"random": REST, "ci": WHOLE},
    "sanitizers": {"derived": WHOLE, "random": QUARTER, "ci": WHOLE},
    "long": {"random": WHOLE, "ci": WHOLE, "long": WHOLE},
    "all": {"derived": WHOLE, "random": WHOLE, "ci": WHOLE, "long": WHOLE},
}
WORDS = {WHOLE: [], QUARTER: ["--scale", suiterows.QUARTER], REST: ["--scale", "1", "--from", suiterows.QUARTER]}
LONG_SCALE = "2"
DEBIAN = "/usr/bin/python3"
# One run of a suite: words after its name, the part of it that runs (None: another), least checks, and the place in the order.
Job = collections.namedtuple("Job", "path words part least order")


@functools.cache
def interpreter():
    """The Python of the suites, and what it computes fractions with: Debian's where it has gmpy2 (tests/lib/exact.py)."""
    if os.environ.get("GRAZE_FRACTIONS") == "python":
        return DEBIAN if os.path.exists(DEBIAN) else sys.executable, "Python's fractions, as GRAZE_FRACTIONS says"
    for python in (DEBIAN, sys.executable):
        asked = subprocess.run([python, "-c", "import gmpy2; print('gmpy2', gmpy2.version())"], capture_output=True, text=True) \
            if os.path.exists(python) else None
        if asked and asked.returncode == 0:
            return python, asked.stdout.strip()
    return sys.executable, "Python's fractions, as no gmpy2 is there"


def scaled(options):
    """The words of random suites by --scale and --from or the tier, or None where the tier's parts are meant; and if they are a whole."""
    scale = options.scale or (LONG_SCALE if options.tier == "long" else None)
    if scale is None and options.first is None:
        return None, False
    words = ["--scale", scale or "1", *(["--from", options.first] if options.first else [])]
    return words, not options.first and suiterows.share(scale or "1") >= 1


def job(row, options, known):
    """How a suite runs in the tier of the call; one that is named by path runs in any, by its own tier's part or whole."""
    words, is_whole = scaled(options) if row.tier == "random" else (None, False)
    part = PARTS[options.tier].get(row.tier, WHOLE)
    least = row.least[1] if part == REST else row.least[0] if part == QUARTER else sum(row.least)
    seconds = suitetimes.part_of(known.get(row.path, {}), part)[0]
    if words is not None:
        part, least = None, sum(row.least) if is_whole else 0
    if row.path.endswith(".c"):
        words = []
    else:
        words = [*(WORDS[part] if words is None else words), *(["--seed", options.seed] if options.seed else [])]
    group = 0 if row.path.startswith(FIRST) else 2 if row.tier == "random" else 1
    return Job(row.path, words, part, 0 if options.sanitizers else least, (group, -seconds))


def jobs(rows, seeds, options, known):
    """The jobs, in the order in which they begin: a long suite before shorter ones of its group, none alone at the end."""
    def is_wanted(path):
        named = any(text in "tests/" + path for text in options.only) if options.only else True
        return named and (not options.suites or path in options.suites) and not any(text in "tests/" + path for text in options.skip)

    chosen = [row for row in rows.values() if row.tier != "by hand" and is_wanted(row.path)
              and (row.tier in PARTS[options.tier] or row.path in options.suites)]
    out = [job(row, options, known) for row in chosen]
    if options.tier in ("test", "all") and not options.sanitizers and not options.suites:
        out += [Job(seed.path, ["--seed", seed.seed, "--scale", seed.scale], None, 0, (2, -1)) for seed in seeds if is_wanted(seed.path)]
    return sorted(out, key=lambda job: job.order)


def command(job_, options):
    if job_.path.endswith(".c"):
        return [os.path.join(options.build, "tests", job_.path[:-2])]
    return [options.python, "tests/" + job_.path, "--graze", os.path.join(options.build, "graze"), *job_.words,
            *(["--sanitizers"] if options.sanitizers else [])]


def count(output, status):
    """(passed, failed, skipped) of one suite."""
    plain = PLAIN.findall(output)
    if plain:
        passed, failed, skipped = (int(n or 0) for n in plain[-1])
    else:
        passed, failed, skipped = (sum(int(n) for n in pattern.findall(output))
                                   for pattern in (CMOCKA_PASSED, CMOCKA_FAILED, CMOCKA_SKIPPED))
    if passed + failed + skipped == 0 or (status != 0 and failed == 0):
        failed += 1
    return passed, failed, skipped


def run(job_, options):
    """(output, exit status, seconds of wall time, seconds of CPU of the suite and all that it waited for)."""
    start = time.time()
    with tempfile.TemporaryFile() as file:
        suite = subprocess.Popen(command(job_, options), stdout=file, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        stopped = threading.Event()
        late = threading.Timer(options.limit, lambda: (stopped.set(), os.kill(suite.pid, signal.SIGKILL)))
        late.start()
        _, status, used = os.wait4(suite.pid, 0)
        suite.returncode = os.waitstatus_to_exitcode(status)
        late.cancel()
        file.seek(0)
        output = file.read().decode("utf-8", "replace") + (f"\nstopped after {options.limit} s\n" if stopped.is_set() else "")
    return output, suite.returncode, (time.time() - start, used.ru_utime + used.ru_stime)


def judge(path, output, status, least, allowed):
    """The counts of a suite and what is printed of its output. A suite that skips, or has a sanitizer (least 0),
    counts fewer checks."""
    passed, failed, skipped = count(output, status)
    if passed < least and not skipped and not failed:
        failed = 1
        output += f"\nFAILED {path}: {passed} checks passed, expected at least {least} by tests/README.md\n"
    for name in SKIPPED.findall(output) if allowed is not None else []:
        if name not in allowed:
            failed += 1
            output += f"\nFAILED {path}: skips {name}; expected skips of {' '.join(allowed)} alone\n"
    shown = output[-6000:] if failed else "".join(f"  {line}\n" for line in output.splitlines()
                                                  if line.startswith(("SKIP ", "histogram")))
    return (passed, failed, skipped), shown


class Tally:
    """Counts and seconds of the suites, as they end."""

    def __init__(self, options, failed):
        self.options, self.total, self.took, self.counted = options, [0, failed, 0], {}, {}
        skips = os.environ.get("GRAZE_SKIPS")
        self.allowed = None if skips is None or options.sanitizers else skips.split()

    def ended(self, job_, output, status, used):
        counts, shown = judge(job_.path, output, status, job_.least, self.allowed)
        named = " ".join([f"tests/{job_.path}", *(job_.words if job_.part is None else [])])
        print(f"{named}: {counts[0]} passed, {counts[1]} failed, {counts[2]} skipped ({used[0]:.1f} s)")
        print(shown, end="", flush=True)
        self.total = [a + b for a, b in zip(self.total, counts)]
        if job_.part:
            self.took[job_.path, job_.part], self.counted[job_.path, int(job_.part == REST)] = used, counts[0]
        return counts[1] == 0

    def all(self, chosen):
        """The groups one after the other; the first alone, since the others are not asked where it fails."""
        first = [job_ for job_ in chosen if job_.order[0] == 0]
        if self.pool(first, is_first=True):
            self.pool(chosen[len(first):])
        elif len(chosen) > len(first):
            print(f"FAILED golden cases or unit tests: {len(chosen) - len(first)} suites are not asked")

    def pool(self, chosen, is_first=False):
        """Whether all passed. Of the first none begins after a failure."""
        sound = True
        with concurrent.futures.ThreadPoolExecutor(self.options.jobs) as pool:
            waited = {pool.submit(run, job_, self.options): job_ for job_ in chosen}
            for done in concurrent.futures.as_completed(waited):
                if done.cancelled():
                    continue
                sound = self.ended(waited[done], *done.result()) and sound
                if is_first and not sound:
                    for other in waited:
                        other.cancel()
        return sound


def proposed(passed):
    """The least count that a row gets: nine tenths of what was counted, in two digits; few checks all count."""
    if passed < 20:
        return passed
    digits = 10 ** max(0, len(str(passed * 9 // 10)) - 2)
    return passed * 9 // 10 // digits * digits


def parsed():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("suites", nargs="*", metavar="SUITE", help="FOLDER/FILE of tests/README.md: these alone, in whichever tier")
    parser.add_argument("--tier", choices=PARTS, help="test if none is given; all with --only or a SUITE")
    parser.add_argument("--build", default="build")
    parser.add_argument("--only", action="append", default=[], help="run suites whose path contains this text; more than once: any of these")
    parser.add_argument("--skip", action="append", default=[], help="leave out suites whose path contains this text")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() + 1, help="suites at a time; some wait, so one more than there are cores")
    parser.add_argument("--scale", help="of random suites, a fraction too, where it is not the tier's")
    parser.add_argument("--from", dest="first", metavar="F", help="random suites begin at this share of their stream")
    parser.add_argument("--seed", default="", help="of random tests, where it is not the suite's own")
    parser.add_argument("--sanitizers", action="store_true", help="the build has a sanitizer or counts coverage: no limits of "
                        "memory, without the suites that run in the plain build alone")
    parser.add_argument("--record", action="store_true", help="write the seconds of each suite into tests/times.txt, if nothing failed; on "
                        "two idle cores")
    parser.add_argument("--counts", nargs="?", const="print", choices=["print", "write"], help="propose least counts for the rows of "
                        "tests/README.md by what was counted, or write them there")
    parser.add_argument("--limit", type=float, default=900, help="seconds for one suite")
    options = parser.parse_args()
    options.tier = options.tier or ("all" if options.only or options.suites else "test")
    for name in ("scale", "first"):
        try:
            if getattr(options, name) not in (None, "0"):
                suiterows.share(getattr(options, name))
        except (ValueError, ZeroDivisionError):
            parser.error(f"--{'from' if name == 'first' else name} {getattr(options, name)}: expected a positive fraction, as 1/4")
    if options.record and (options.scale or options.first or options.seed or options.sanitizers or options.tier == "long"):
        parser.error("--record is of suites as `make test` and .ci/run have them: without --scale, --from, --seed, --sanitizers, --tier long")
    if options.sanitizers and not options.only:
        options.skip += ["tests/" + path for path in PLAIN_ALONE]
    return options


def put_records(options, rows, tally, seconds):
    """Seconds into times.txt, least counts into the rows or onto standard output."""
    took = tally.took
    if options.record and not tally.total[1]:
        if options.tier == "test" and not options.only and not options.skip and not options.suites:
            took = {**took, (suitetimes.TEST, WHOLE): (seconds, sum(cpu for _, cpu in took.values()))}
        suitetimes.write(took, [path for path, row in rows.items() if row.tier != "by hand"])
    counts = {}
    for (path, k), passed in sorted(tally.counted.items()) if options.counts else []:
        if len(rows[path].least) == 1 or (path, QUARTER) in took or (path, REST) in took:
            counts[path, k] = proposed(passed)
            print(f"COUNT {path} {passed} passed, {rows[path].least[k]} in the row, {counts[path, k]} proposed")
    if options.counts == "write":
        suiterows.fill({key: least for key, least in counts.items() if least})


def main():
    options = parsed()
    for which in (signal.SIGINT, signal.SIGHUP):   # ignored in a shell's background; suites send them
        if signal.getsignal(which) == signal.SIG_IGN:
            signal.signal(which, signal.SIG_DFL)
    rows, faults = suiterows.read()
    seeds, wrong = suiterows.seeds(rows)
    faults += wrong + [f"tests/README.md has no suite {path}" for path in options.suites if path not in rows]
    for fault in faults:
        print("FAILED", fault)
    options.python, fractions = interpreter()
    print(f"suites run in {options.python} with {fractions}", flush=True)
    tally, began = Tally(options, len(faults)), time.time()
    tally.all(jobs(rows, seeds, options, suitetimes.parts()))
    put_records(options, rows, tally, time.time() - began)
    total = tally.total
    if sum(total) == 0:
        total[1] = 1
    skipped = f", {total[2]} skipped" if total[2] else ""
    print(f"{total[0]} passed, {total[1]} failed{skipped}")
    sys.exit(1 if total[1] else 0)


if __name__ == "__main__":
    main()
