#!/usr/bin/env python3
"""Run every test suite and add up what they counted.

A suite is a C file of tests/unit or tests/api, which is a cmocka program, or a script tests/FOLDER/*.py that runs
when it is called (`if __name__ == "__main__"`). Its summary is `N passed, N failed` or `N passed, N failed, N
skipped`, or cmocka's own. The tables of tests/README.md record each of them: the suites with the least number of
checks that each must count, and the scripts that are run by hand. A suite or script without a row, a row without a
file, a suite that counts fewer checks than recorded, dies, or runs too long is one failure.
Lines `SKIP name: reason` are passed on. The last line of all is the sum.
Long suites begin first, by the seconds of tests/times.txt, which --record writes.
"""
import argparse
import concurrent.futures
import glob
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

import suitetimes  # noqa: E402

PLAIN = re.compile(r"^(?:\w+: )?(\d+) passed, (\d+) failed(?:, (\d+) skipped)?$", re.M)
CMOCKA_PASSED = re.compile(r"\[  PASSED  \] (\d+) test")
CMOCKA_FAILED = re.compile(r"\[  FAILED  \] (\d+) test")
CMOCKA_SKIPPED = re.compile(r"\[  SKIPPED \] (\d+) test")
RECORD = "tests/README.md"
# Suites that run in the plain build alone, not with a sanitizer nor for coverage: those about sources and other programs, and those
# that give many more inputs to code which other suites run too, as the coverage by file without them shows.
PLAIN_ALONE = [
    "structure/", "install/", "readme/", "cases/recompute", "curved/schema", "motioncmd/schema",
    "agree/", "words/", "unsweep/properties", "curved/germs", "curved/polyhedra", "check/contacts",
    "topo/germs", "topo/straight", "topo/orders", "topo/prisms",
    "filter/equal", "filter/columns", "filter/contraction", "envelope/derivation", "contact/derivation", "benchmark/", "judge/sums",
]
# | `folder/file` | ... | least number of checks, or `by hand` |
ROW = re.compile(r"^\| `([\w./-]+)` \|.*\| (\d+|by hand) \|$", re.M)
DEBIAN = "/usr/bin/python3"


def found():
    """The paths under tests/ of all suites and scripts."""
    paths = [path for kind in ("unit", "api") for path in glob.glob(f"tests/{kind}/*.c")]
    for path in glob.glob("tests/*/*.py"):
        with open(path, encoding="utf-8") as file:
            if re.search(r'^if __name__ == "__main__":', file.read(), re.M):
                paths.append(path)
    return sorted(path[len("tests/"):] for path in paths)


def recorded():
    """Path -> least number of checks, None for a script that is run by hand; and the faults of the record."""
    with open(RECORD, encoding="utf-8") as file:
        rows = ROW.findall(file.read())
    record = {path: None if least == "by hand" else int(least) for path, least in rows}
    there = found()
    faults = [f"{RECORD}: {path} has two rows" for path in record if sum(row[0] == path for row in rows) > 1]
    faults += [f"{RECORD}: tests/{path} has no row" for path in there if path not in record]
    faults += [f"{RECORD}: there is no suite or script tests/{path}" for path in record if path not in there]
    faults += [f"{RECORD}: {path}: expected a number of checks above 0" for path, least in record.items() if least == 0]
    return record, faults


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


def command(path, options):
    if path.endswith(".c"):
        return [os.path.join(options.build, "tests", path[:-2])]
    more = ["--scale", str(options.scale)] if options.scale != 1 else []
    more += ["--seed", options.seed] if options.seed else []
    more += ["--sanitizers"] if options.sanitizers else []
    return [options.python, "tests/" + path, "--graze", os.path.join(options.build, "graze"), *more]


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


def run(path, options):
    """(path, output, exit status, seconds of wall time, seconds of CPU of the suite and all that it waited for)."""
    start = time.time()
    with tempfile.TemporaryFile() as file:
        suite = subprocess.Popen(command(path, options), stdout=file, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        stopped = threading.Event()
        late = threading.Timer(options.limit, lambda: (stopped.set(), os.kill(suite.pid, signal.SIGKILL)))
        late.start()
        _, status, used = os.wait4(suite.pid, 0)
        suite.returncode = os.waitstatus_to_exitcode(status)
        late.cancel()
        file.seek(0)
        output = file.read().decode("utf-8", "replace") + (f"\nstopped after {options.limit} s\n" if stopped.is_set() else "")
    return path, output, suite.returncode, (time.time() - start, used.ru_utime + used.ru_stime)


def judge(path, output, status, least):
    """The counts of a suite and what is printed of its output. A suite that skips, or has a sanitizer (least 0),
    counts fewer checks."""
    passed, failed, skipped = count(output, status)
    if passed < least and not skipped and not failed:
        failed = 1
        output += f"\nFAILED {path}: {passed} checks passed, expected at least {least} by {RECORD}\n"
    shown = output[-6000:] if failed else "".join(f"  {line}\n" for line in output.splitlines()
                                                  if line.startswith(("SKIP ", "histogram")))
    return (passed, failed, skipped), shown


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--build", default="build")
    parser.add_argument("--only", default="", help="run suites whose path contains this text")
    parser.add_argument("--skip", action="append", default=[], help="leave out suites whose path contains this text")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--scale", type=int, default=1, help="multiplies random tests")
    parser.add_argument("--seed", default="", help="of random tests, where it is not the suite's own")
    parser.add_argument("--sanitizers", action="store_true", help="the build has a sanitizer or counts coverage: no limits of "
                        "memory, without the suites that run in the plain build alone")
    parser.add_argument("--record", action="store_true", help="write the seconds of each suite into tests/times.txt, if nothing failed; of "
                        "suites as `make test` runs them, on two idle cores")
    parser.add_argument("--limit", type=float, default=900, help="seconds for one suite")
    options = parser.parse_args()
    if options.record and (options.scale != 1 or options.seed or options.sanitizers):
        parser.error("--record is of suites as `make test` runs them: without --scale, --seed, --sanitizers")
    for which in (signal.SIGINT, signal.SIGHUP):   # ignored in a shell's background; suites send them
        if signal.getsignal(which) == signal.SIG_IGN:
            signal.signal(which, signal.SIG_DFL)
    if options.sanitizers and not options.only:
        options.skip += ["tests/" + path for path in PLAIN_ALONE]
    record, faults = recorded()
    for fault in faults:
        print("FAILED", fault)
    options.python, fractions = interpreter()
    print(f"suites run in {options.python} with {fractions}")
    known = suitetimes.read()
    chosen = [path for path in found() if record.get(path, 1) is not None and options.only in "tests/" + path
              and not any(text in "tests/" + path for text in options.skip)]
    chosen.sort(key=lambda path: -known.get(path, (0, 0))[0])  # long ones first: none runs alone at the end
    total, took, began = [0, len(faults), 0], {}, time.time()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for path, output, status, used in pool.map(lambda path: run(path, options), chosen):
            counts, shown = judge(path, output, status, 0 if options.sanitizers else record.get(path, 1))
            print(f"tests/{path}: {counts[0]} passed, {counts[1]} failed, {counts[2]} skipped ({used[0]:.1f} s)")
            print(shown, end="", flush=True)
            total = [a + b for a, b in zip(total, counts)]
            took[path] = used
    if options.record and not total[1]:
        if not options.only and not options.skip:
            took[suitetimes.TEST] = time.time() - began, sum(cpu for _, cpu in took.values())
        suitetimes.write(took)
    if sum(total) == 0:
        total[1] = 1
    skipped = f", {total[2]} skipped" if total[2] else ""
    print(f"{total[0]} passed, {total[1]} failed{skipped}")
    sys.exit(1 if total[1] else 0)


if __name__ == "__main__":
    main()
