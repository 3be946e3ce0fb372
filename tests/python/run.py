#!/usr/bin/env python3
# suite
"""The module `graze` of src/python: its tests with numpy, and again as if numpy were not installed.

Each test_*.py here is a set of unittest cases. They run in an interpreter of their own: this one if
it has numpy, else Debian's; where neither has, the tests with numpy are skipped and say so. Searches for planted bugs, which are
random (KIT of part.py), and the tests without numpy are left to the rest of the stream.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import Checks, options, run  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
SUMMARY = re.compile(r"^sum (\d+) (\d+) (\d+)$", re.M)


def has_numpy(python):
    return run([python, "-c", "import numpy"]).returncode == 0


def instrumented(library):
    """Was it built with a sanitizer, whose runtime an ordinary interpreter lacks?"""
    with open(library, "rb") as file:
        data = file.read()
    return any(name in data for name in (b"__asan_init", b"__tsan_init", b"__ubsan_handle"))


def part(checks, python, way, args, library, kit):
    """Count one run of the tests, whose output is passed on."""
    environment = dict(os.environ, GRAZE_LIBRARY=library, PYTHONDONTWRITEBYTECODE="1")
    done = run([python, os.path.join(HERE, "part.py"), way, "--graze", args.graze, "--scale", max(1, int(args.scale)),
                "--seed", args.seed, "--kit", kit], 1500, stderr=subprocess.STDOUT, env=environment)
    print(done.stdout, end="")
    counts = SUMMARY.findall(done.stdout)
    passed, failed, skipped = map(int, counts[-1]) if counts else (0, 0, 0)
    checks.passed, checks.failed, checks.skipped = (checks.passed + passed, checks.failed + failed,
                                                    checks.skipped + skipped)
    if not counts or (done.returncode and not failed):
        checks.fail(f"{way}: ended with status {done.returncode}")



def types(checks, cache):
    """`mypy --strict` has nothing to say; what it has read stays in the build folder."""
    folder = os.path.join(HERE, "..", "..", "src", "python")
    for python in (sys.executable, "/usr/bin/python3"):
        if os.path.exists(python) and run([python, "-c", "import mypy"]).returncode == 0:
            done = run([python, "-m", "mypy", "--strict", "--cache-dir", cache, "graze"], 600, cwd=folder)
            checks.holds(done.returncode == 0, "mypy --strict", done.stdout)
            return
    checks.skip("python, types", "no interpreter here has mypy")


def main():
    args, checks = options(__doc__, seed=20090801), Checks()
    library = os.path.join(os.path.dirname(args.graze), "libgraze.so")
    if instrumented(library):
        checks.skip("python", "the library is built with a sanitizer, the interpreter is not")
        checks.finish()
    pythons = [python for python in (sys.executable, "/usr/bin/python3")
               if os.path.exists(python) and has_numpy(python)]
    if args.derived:
        types(checks, os.path.join(os.path.dirname(library), "tests", "mypy"))
    if args.to_the_end:  # the same tests again, in another world
        # The suites' Python is Debian's; another that stands before it in PATH is asked too.
        part(checks, shutil.which("python3") or sys.executable, "without-numpy", args, library, "with" if args.derived else "without")
    if pythons:
        part(checks, pythons[0], "with-numpy", args, library,
             "alone" if not args.derived else "with" if args.ample else "without")
    else:
        checks.skip("python, with numpy", "no interpreter here has numpy")
    checks.finish()


if __name__ == "__main__":
    main()
