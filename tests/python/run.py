#!/usr/bin/env python3
# suite
"""The module `graze` of src/python: its tests with numpy, and again as if numpy were not installed.

Each test_*.py here is a set of unittest cases. They run in an interpreter of their own: this one if
it has numpy, else Debian's; where neither has, the tests with numpy are skipped and say so.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
SUMMARY = re.compile(r"^sum (\d+) (\d+) (\d+)$", re.M)


def has_numpy(python):
    return subprocess.run([python, "-c", "import numpy"], stderr=subprocess.DEVNULL).returncode == 0


def instrumented(library):
    """Was it built with a sanitizer, whose runtime an ordinary interpreter lacks?"""
    with open(library, "rb") as file:
        data = file.read()
    return any(name in data for name in (b"__asan_init", b"__tsan_init", b"__ubsan_handle"))


def part(python, way, options, library):
    """(passed, failed, skipped) of one run of all tests, whose output is passed on."""
    environment = dict(os.environ, GRAZE_LIBRARY=library, PYTHONDONTWRITEBYTECODE="1")
    command = [python, os.path.join(HERE, "part.py"), way, "--graze", options.graze,
               "--scale", str(options.scale), "--seed", str(options.seed)]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=environment)
    output = done.stdout.decode("utf-8", "replace")
    counts = SUMMARY.findall(output)
    if not counts or done.returncode:
        print(f"{way}: ended with status {done.returncode}")
    print(output, end="")
    passed, failed, skipped = map(int, counts[-1]) if counts else (0, 1, 0)
    return passed, failed + (done.returncode != 0 and failed == 0), skipped


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--scale", type=int, default=1)
    parser.add_argument("--seed", type=int, default=20090801)
    options = parser.parse_args()
    options.graze = os.path.abspath(options.graze)
    library = os.path.join(os.path.dirname(options.graze), "libgraze.so")
    if instrumented(library):
        print("SKIP python: the library is built with a sanitizer, the interpreter is not")
        print("0 passed, 0 failed, 1 skipped")
        return
    pythons = [python for python in (sys.executable, "/usr/bin/python3")
               if os.path.exists(python) and has_numpy(python)]
    total = [part(sys.executable, "without-numpy", options, library)]
    if pythons:
        total.append(part(pythons[0], "with-numpy", options, library))
    else:
        print("SKIP python, with numpy: no interpreter here has numpy")
        total.append((0, 0, 1))
    passed, failed, skipped = map(sum, zip(*total))
    print(f"{passed} passed, {failed} failed" + (f", {skipped} skipped" if skipped else ""))
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
