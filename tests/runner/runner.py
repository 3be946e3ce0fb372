#!/usr/bin/env python3
"""The runner loses no suite: made-up suites in a folder of their own, each with what must come of it. Stages end at the first that
fails; documents quote what was recorded; numbers of the suites are exact. In this repository every module of the tests is used.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import decimal
import glob
import io
import math
import os
import re
import shutil
import sys
import tempfile
from unittest import mock

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))

import exact  # noqa: E402
import machine  # noqa: E402
import stages  # noqa: E402
import suitetimes  # noqa: E402
from harness import ROOT, Checks, options, run  # noqa: E402
from run import recorded  # noqa: E402

MAIN = 'if __name__ == "__main__":\n    '
ROW = "| `{path}` | it | law | {least} |\n"


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
    ("a seed", {"a/a.py": suite("import sys; print(sys.argv[sys.argv.index('--seed') + 1], 'passed, 0 failed')")}, [("a/a.py", 3)],
     ["--seed", "7"], "7 passed, 0 failed"),
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
    os.makedirs(os.path.join(folder, "tests", "lib"))
    for name in ("run.py", "lib/suitetimes.py"):
        shutil.copy(os.path.join(ROOT, "tests", name), os.path.join(folder, "tests", name))
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


# What is asked beside `make test`: commands of stages made up, and the names of those that must run.
PASS, FAIL = ["true"], ["false"]
STAGES = [
    ("all pass", [("a", PASS, False), ("b", PASS, True), ("c", PASS, True), ("d", PASS, True), ("e", PASS, False)], "abcde", ""),
    ("none begins after one failed", [("a", PASS, False), ("b", FAIL, False), ("c", PASS, True), ("d", PASS, False)], "ab", "b"),
    ("nor after one beside others", [("a", FAIL, True), *((name, PASS, True) for name in "bcdefghijklmnopqrst"), ("u", PASS, False)],
     None, "a"),
    ("a signal", [("a", ["sh", "-c", "kill -9 $$"], False)], "a", "a"),
]


def check_stages(checks):
    for what, rows, ran, failed in STAGES:
        run_ = stages.Run([("before", "3", "2")])
        with contextlib.redirect_stdout(io.StringIO()), mock.patch.object(os, "cpu_count", return_value=2):
            run_.all([stages.Stage(*row) for row in rows])
        names = [name for name, _, _ in run_.rows]
        checks.holds(names[0] == "before" and (ran is None and "u" not in names or sorted(names[1:]) == sorted(ran or "")), what, names)
        checks.equal(run_.failed, list(failed), what)
        checks.holds(all(re.search(rf"^{name} +\d+ +\d+ +\d+ %$", run_.table(), re.M) for name in names), what, run_.table())
    busy = stages.Run([])
    with contextlib.redirect_stdout(io.StringIO()):
        busy.all([stages.Stage("busy", ["sh", "-c", f"{sys.executable} -c 'while __import__(\"time\").process_time() < 0.5: pass'"])])
    checks.holds(busy.cpu() >= 0.5, "the CPU seconds of a grandchild", busy.rows)


def check_times(checks):
    """All suites and no others have rows; documents quote what the two calls took, in whole minutes rounded up."""
    times = suitetimes.read()
    suites = {path for path, least in recorded()[0].items() if least is not None}
    checks.equal(sorted(set(times) ^ (suites | {suitetimes.TEST, suitetimes.CI})), [], "rows of tests/times.txt, which --record writes")
    for path in ("README.md", "CONTRIBUTING.md", "Makefile", "tests/README.md", "src/docs/development.md"):
        with open(os.path.join(ROOT, path), encoding="utf-8") as file:
            text = file.read()
        for call, name in (("make test", suitetimes.TEST), (".ci/run", suitetimes.CI)):
            for said in re.findall(rf"{re.escape(call)}\b(?!-)[^.\n]*?(\d+) minutes", text):
                checks.equal(int(said), math.ceil(times.get(name, (0,))[0] / 60), f"{path}: the minutes of {call}")
            if path == "tests/README.md":
                checks.holds(re.search(rf"{re.escape(call)}\b(?!-)[^.\n]*?(\d+) minutes", text), f"{path} does not say what {call} takes")


def check_exact(checks):
    """Numbers of the suites' own algebra: where mpq and Fraction differ, the suites' own functions are right, and no float slips in."""
    ways = {exact.Fraction, exact.PythonFraction}
    for make in ways:
        for a, b in ((1, 3), (2, 3), (-2, 3), (10 ** 30 + 1, 10 ** 29), (3, 2 ** 1075), (2 ** 53 + 1, 1), (2 ** 54 + 3, 1)):
            checks.equal(exact.to_double(make(a, b)), a / b, a, b, "to_double")
        checks.equal(exact.simple(make(355, 113), 50), make(22, 7), "simple")
    for make in ways:
        for text in ("1 2", "1.5e5x", "1e2.5", "1.5e", "1/2 3", "1__0", "", "a", "1/-2"):
            try:
                checks.fail(text, "is read as", make(text))
            except ValueError:
                checks.passed += 1
        got = [make(x) for x in ("-1/2", "+1/2", " 0.1 ", "-.5", "1e3", "1.5E-2", "1_0", decimal.Decimal("0.25"), 0.5, 7)]
        checks.equal(got, [-1 / 2, 1 / 2, make(1, 10), -1 / 2, 1000, make(3, 200), 10, 1 / 4, 1 / 2, 7], "numerals")
    checks.equal([exact.to_double(x) for x in ("1/3", "0.1", 0.5, 7)], [1 / 3, 0.1, 0.5, 7.0], "to_double of other numbers")
    if exact.gmpy2:
        mpq, mpz = exact.gmpy2.mpq, exact.gmpy2.mpz
        for what, make in {"mpq + float": lambda: mpq(1, 2) + 0.5, "mpz / int": lambda: mpz(4) / 2, "mpq ** mpq": lambda: mpq(2) ** mpq(2),
                           "float * mpq": lambda: 2.0 * mpq(1, 2), "mpq ** Fraction": lambda: mpq(2) ** exact.PythonFraction(2)}.items():
            try:
                checks.fail(what, "expected an error, got", make())
            except exact.gmpy2.InexactResultError:
                checks.passed += 1
        with contextlib.redirect_stdout(io.StringIO()):
            seen = Checks()
            seen.equal(exact.gmpy2.mpfr(0), 0)
            seen.holds(True, exact.gmpy2.mpfr(0))
        checks.equal((seen.passed, seen.failed), (0, 2), "a float of gmpy2 as an operand")


def main():
    options(__doc__)
    checks = Checks()
    for case in CASES:
        with tempfile.TemporaryDirectory() as folder:
            check_case(checks, folder, *case)
    check_stages(checks)
    check_times(checks)
    check_exact(checks)
    check_modules(checks)
    check_machine(checks)
    checks.finish()


if __name__ == "__main__":
    main()
