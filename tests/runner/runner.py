#!/usr/bin/env python3
"""The runner loses no suite: made-up suites in a folder of their own, each with what must come of it; and in this
repository every module of the tests is used.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import glob
import io
import os
import re
import shutil
import sys
import tempfile
from unittest import mock

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import machine  # noqa: E402
from harness import ROOT, Checks, options, run  # noqa: E402

MAIN = 'if __name__ == "__main__":\n    '
ROW = "| `{path}` | it | law | {least} | 1 s |\n"


def suite(body, head=""):
    return f'"""{head}"""\n{MAIN}{body}\n'


GOOD = suite("print('3 passed, 0 failed')")
# what is shown, files of tests/, rows (path, least), options, and what the runner must say last
CASES = [
    ("one suite", {"a/a.py": GOOD}, [("a/a.py", 3)], [], "3 passed, 0 failed"),
    ("a head of 2000 characters", {"a/a.py": suite("print('3 passed, 0 failed')", "suite " * 333)}, [("a/a.py", 3)], [],
     "3 passed, 0 failed"),
    ("fewer checks than recorded", {"a/a.py": GOOD}, [("a/a.py", 4)], [], "3 passed, 1 failed"),
    ("fewer with a sanitizer", {"a/a.py": GOOD}, [("a/a.py", 4)], ["--sanitizers"], "3 passed, 0 failed"),
    ("fewer with a skip", {"a/a.py": suite("print('SKIP x: y\\n1 passed, 0 failed, 1 skipped')")}, [("a/a.py", 4)], [],
     "1 passed, 0 failed, 1 skipped"),
    ("no row", {"a/a.py": GOOD, "a/b.py": GOOD}, [("a/a.py", 3)], [], "6 passed, 1 failed"),
    ("no row, and left out", {"a/a.py": GOOD, "a/b.py": GOOD}, [("a/a.py", 3)], ["--only", "a/a"], "3 passed, 1 failed"),
    ("no file", {"a/a.py": GOOD}, [("a/a.py", 3), ("a/b.py", 3)], [], "3 passed, 1 failed"),
    ("a C suite without a row", {"a/a.py": GOOD, "unit/test_b.c": ""}, [("a/a.py", 3)], ["--only", "a/a"],
     "3 passed, 1 failed"),
    ("two rows", {"a/a.py": GOOD}, [("a/a.py", 3), ("a/a.py", 3)], [], "3 passed, 1 failed"),
    ("least 0", {"a/a.py": GOOD}, [("a/a.py", 0)], [], "3 passed, 1 failed"),
    ("by hand", {"a/a.py": GOOD, "a/b.py": GOOD}, [("a/a.py", 3), ("a/b.py", "by hand")], [], "3 passed, 0 failed"),
    ("a module", {"a/a.py": GOOD, "a/b.py": "x = 1\n"}, [("a/a.py", 3)], [], "3 passed, 0 failed"),
    ("failed checks", {"a/a.py": suite("print('3 passed, 2 failed')")}, [("a/a.py", 3)], [], "3 passed, 2 failed"),
    ("it dies", {"a/a.py": suite("print('3 passed, 0 failed'); raise SystemExit(3)")}, [("a/a.py", 3)], [],
     "3 passed, 1 failed"),
    ("no count", {"a/a.py": suite("print('fine')")}, [("a/a.py", 3)], [], "0 passed, 1 failed"),
    ("no end", {"a/a.py": suite("import time; print('3 passed, 0 failed', flush=True); time.sleep(60)")}, [("a/a.py", 3)],
     ["--limit", "2"], "3 passed, 1 failed"),
    ("no suite chosen", {"a/a.py": GOOD}, [("a/a.py", 3)], ["--only", "b/"], "0 passed, 1 failed"),
]


def check_case(checks, folder, what, files, rows, words, want):
    for path, text in files.items():
        path = os.path.join(folder, "tests", path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    with open(os.path.join(folder, "tests", "README.md"), "w", encoding="utf-8") as file:
        file.write("# Tests\n\n" + "".join(ROW.format(path=path, least=least) for path, least in rows))
    shutil.copy(os.path.join(ROOT, "tests", "run.py"), os.path.join(folder, "tests"))
    done = run([sys.executable, "tests/run.py", *words], cwd=folder)
    checks.equal((done.stdout.splitlines() or [""])[-1], want, what, done.stdout, done.stderr)
    checks.equal(done.returncode, 0 if " 0 failed" in want else 1, what, "status")


def check_modules(checks):
    """A module that runs nothing is imported by another file; the test_*.py of tests/python are found by unittest."""
    texts = {}
    for path in glob.glob("tests/**/*.py", recursive=True, root_dir=ROOT):
        with open(os.path.join(ROOT, path), encoding="utf-8") as file:
            texts[path] = file.read()
    for path, text in texts.items():
        name = os.path.basename(path)[:-3]
        if MAIN.strip() in text or path.startswith("tests/python/test_"):
            continue
        used = any(re.search(rf"^ *(import|from) .*\b{name}\b", other, re.M) for where, other in texts.items() if where != path)
        checks.holds(used, f"{path}: is imported nowhere and runs nothing")


def check_machine(checks):
    """What a machine lacks is a skip of a name that the CI's list allows, and asked for in one module."""
    with open(os.path.join(ROOT, ".ci", "run"), encoding="utf-8") as file:
        allowed = re.search(r"allowed_skips='(.*)'", file.read())[1]
    said, seen = io.StringIO(), Checks()
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(said):
        script = "#!/bin/sh\necho 'opal_ifinit: unable to find network interfaces.' >&2\nexit 1\n"
        for name, text in (("mpirun", script), ("graze-mpi", "")):
            with open(os.path.join(folder, name), "w", encoding="utf-8", opener=lambda p, f: os.open(p, f, 0o755)) as file:
                file.write(text)
        with mock.patch.object(machine.pty, "openpty", side_effect=OSError("out of pty devices")), \
                mock.patch.dict(machine.MPI_ENVIRONMENT, PATH=folder), mock.patch.dict(os.environ, PATH=folder):
            got = [machine.on_terminal(seen, ["true"], 1), machine.ranks(seen, os.path.join(folder, "graze"), 2)]
    checks.equal((got, seen.skipped, seen.failed), ([None, None], 2, 0), "a machine without terminal and network")
    for line in said.getvalue().splitlines():
        checks.holds(re.search(allowed, line), line, "is a skip that", allowed, "does not allow")
    checks.holds(not re.search(allowed, "SKIP mpi: Open MPI is not installed"), "the CI's machine has Open MPI")
    for path in glob.glob("tests/**/*.py", recursive=True, root_dir=ROOT):
        if path.startswith(("tests/lib/", "tests/bench/", "tests/runner/")):
            continue
        with open(os.path.join(ROOT, path), encoding="utf-8") as file:
            checks.holds(not re.search('openpty|"mpirun"', file.read()), f"{path}: expected tests/lib/machine.py")


def main():
    options(__doc__)
    checks = Checks()
    for case in CASES:
        with tempfile.TemporaryDirectory() as folder:
            check_case(checks, folder, *case)
    check_modules(checks)
    check_machine(checks)
    checks.finish()


if __name__ == "__main__":
    main()
