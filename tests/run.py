#!/usr/bin/env python3
"""Run every test suite and add up what they counted.

A suite is a program. It ends with `N passed, N failed` or `N passed, N failed, N skipped`, or it is a cmocka
program, whose own summary is read. A suite that dies, runs too long or counts nothing is one failure.
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


# Suites that hold the program to a limit of memory, and how to tell them not to: sanitizers need address space.
NO_LIMIT = {"refuse": ["--sanitizers"], "agree": ["--memory", "0"], "words": ["--memory", "0"],
            "examples": ["--memory", "0"], "unsweep": ["--memory", "0"],
            "compare": ["--sanitizers"], "bombs": ["--sanitizers"], "filter": ["--memory", "0"],
            "install": ["--sanitizers"], "memory": ["--sanitizers"]}


def suites(build, scale, sanitizers):
    graze = os.path.join(build, "graze")
    for kind in ("unit", "api"):
        for source in sorted(glob.glob(f"tests/{kind}/*.c")):
            yield source, [os.path.join(build, source[:-2])]
    for script in sorted(glob.glob("tests/*/*.py")):
        with open(script, encoding="utf-8") as file:
            if "# suite" in file.read(400):
                command = [sys.executable, script, "--graze", graze]
                if scale != 1:
                    command += ["--scale", str(scale)]
                if sanitizers:
                    command += NO_LIMIT.get(script.split("/")[1], [])
                yield script, command


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


def run(suite, limit):
    name, command = suite
    start = time.time()
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, timeout=limit)
        output, status = done.stdout.decode("utf-8", "replace"), done.returncode
    except subprocess.TimeoutExpired as late:
        output = (late.stdout or b"").decode("utf-8", "replace") + f"\nstopped after {limit} s\n"
        status = -1
    return name, output, status, time.time() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", default="build")
    parser.add_argument("--only", default="", help="run suites whose name holds this text")
    parser.add_argument("--skip", action="append", default=[], help="leave out suites whose name holds this text")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--scale", type=int, default=1, help="multiplies random tests")
    parser.add_argument("--sanitizers", action="store_true", help="no limits of memory")
    parser.add_argument("--limit", type=float, default=900, help="seconds for one suite")
    options = parser.parse_args()
    for which in (signal.SIGINT, signal.SIGHUP):   # ignored in a shell's background; suites send them
        if signal.getsignal(which) == signal.SIG_IGN:
            signal.signal(which, signal.SIG_DFL)
    chosen = [s for s in suites(options.build, options.scale, options.sanitizers)
              if options.only in s[0] and not any(text in s[0] for text in options.skip)]
    total = [0, 0, 0]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for name, output, status, seconds in pool.map(lambda s: run(s, options.limit), chosen):
            counts = count(output, status)
            print(f"{name}: {counts[0]} passed, {counts[1]} failed, {counts[2]} skipped "
                  f"({seconds:.1f} s)", flush=True)
            if counts[1]:
                print(output[-6000:], flush=True)
            else:
                for line in output.splitlines():
                    if line.startswith(("SKIP ", "histogram")):
                        print("  " + line)
            total = [a + b for a, b in zip(total, counts)]
    if sum(total) == 0:
        total[1] = 1
    skipped = f", {total[2]} skipped" if total[2] else ""
    print(f"{total[0]} passed, {total[1]} failed{skipped}")
    sys.exit(1 if total[1] else 0)


if __name__ == "__main__":
    main()
