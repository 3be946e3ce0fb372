#!/usr/bin/env python3
"""The runner loses no suite: made-up suites in a folder of their own, each with what must come of it; and in this
repository every module of the tests is used.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import re
import shutil
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

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


def main():
    options(__doc__)
    checks = Checks()
    for case in CASES:
        with tempfile.TemporaryDirectory() as folder:
            check_case(checks, folder, *case)
    check_modules(checks)
    checks.finish()


if __name__ == "__main__":
    main()
