#!/usr/bin/env python3
"""Run every test suite and add up what they counted.

A suite is a C file of tests/unit or tests/api, which is a cmocka program, or a script tests/FOLDER/*.py that runs
when it is called (`if __name__ == "__main__"`). Its summary is `N passed, N failed` or `N passed, N failed, N
skipped`, or cmocka's own. The tables of tests/README.md record each of them: the suites with the least number of
checks that each must count, and the scripts that are run by hand. A suite or script without a row, a row without a
file, a suite that counts fewer checks than recorded, dies, or runs too long is one failure.
Lines `SKIP name: reason` are passed on. The last line of all is the sum.
"""
import argparse
import concurrent.futures
import glob
import os
import re
import signal
import subprocess
import sys
import time

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
# | `folder/file` | ... | least number of checks, or `by hand` | time |
ROW = re.compile(r"^\| `([\w./-]+)` \|.*\| (\d+|by hand) \| *(\d*)[^|]*\|$", re.M)


def found():
    """The paths under tests/ of all suites and scripts."""
    paths = [path for kind in ("unit", "api") for path in glob.glob(f"tests/{kind}/*.c")]
    for path in glob.glob("tests/*/*.py"):
        with open(path, encoding="utf-8") as file:
            if re.search(r'^if __name__ == "__main__":', file.read(), re.M):
                paths.append(path)
    return sorted(path[len("tests/"):] for path in paths)


def recorded():
    """Path -> least number of checks, None for a script that is run by hand; path -> seconds; and the faults of the record."""
    with open(RECORD, encoding="utf-8") as file:
        rows = ROW.findall(file.read())
    record = {path: None if least == "by hand" else int(least) for path, least, _ in rows}
    there = found()
    faults = [f"{RECORD}: {path} has two rows" for path in record if sum(row[0] == path for row in rows) > 1]
    faults += [f"{RECORD}: tests/{path} has no row" for path in there if path not in record]
    faults += [f"{RECORD}: there is no suite or script tests/{path}" for path in record if path not in there]
    faults += [f"{RECORD}: {path}: expected a number of checks above 0" for path, least in record.items() if least == 0]
    return record, {path: int(seconds or 0) for path, _, seconds in rows}, faults


def command(path, options):
    if path.endswith(".c"):
        return [os.path.join(options.build, "tests", path[:-2])]
    more = ["--scale", str(options.scale)] if options.scale != 1 else []
    more += ["--sanitizers"] if options.sanitizers else []
    return [sys.executable, "tests/" + path, "--graze", os.path.join(options.build, "graze"), *more]


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
    start = time.time()
    try:
        done = subprocess.run(command(path, options), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, timeout=options.limit)
        output, status = done.stdout.decode("utf-8", "replace"), done.returncode
    except subprocess.TimeoutExpired as late:
        output = (late.stdout or b"").decode("utf-8", "replace") + f"\nstopped after {options.limit} s\n"
        status = -1
    return path, output, status, time.time() - start


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
    parser.add_argument("--sanitizers", action="store_true", help="the build has a sanitizer or counts coverage: no limits of "
                        "memory, without the suites that run in the plain build alone")
    parser.add_argument("--limit", type=float, default=900, help="seconds for one suite")
    options = parser.parse_args()
    for which in (signal.SIGINT, signal.SIGHUP):   # ignored in a shell's background; suites send them
        if signal.getsignal(which) == signal.SIG_IGN:
            signal.signal(which, signal.SIG_DFL)
    if options.sanitizers and not options.only:
        options.skip += ["tests/" + path for path in PLAIN_ALONE]
    record, seconds_of, faults = recorded()
    for fault in faults:
        print("FAILED", fault)
    chosen = [path for path in found() if record.get(path, 1) is not None and options.only in "tests/" + path
              and not any(text in "tests/" + path for text in options.skip)]
    chosen.sort(key=lambda path: -seconds_of.get(path, 0))  # long ones first: none runs alone at the end
    total = [0, len(faults), 0]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for path, output, status, seconds in pool.map(lambda path: run(path, options), chosen):
            counts, shown = judge(path, output, status, 0 if options.sanitizers else record.get(path, 1))
            print(f"tests/{path}: {counts[0]} passed, {counts[1]} failed, {counts[2]} skipped ({seconds:.1f} s)")
            print(shown, end="", flush=True)
            total = [a + b for a, b in zip(total, counts)]
    if sum(total) == 0:
        total[1] = 1
    skipped = f", {total[2]} skipped" if total[2] else ""
    print(f"{total[0]} passed, {total[1]} failed{skipped}")
    sys.exit(1 if total[1] else 0)


if __name__ == "__main__":
    main()
