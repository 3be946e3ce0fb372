#!/usr/bin/env python3
"""The runner loses no suite: made-up suites in a folder of their own, each with what must come of it, also by tiers. Stages end at the
first that fails; documents quote what was recorded; numbers of the suites are exact. In this repository every module of the tests is used,
every room of src has suites, and the planted faults apply.

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

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "mutation"))

import exact  # noqa: E402
import machine  # noqa: E402
import rooms  # noqa: E402
import stages  # noqa: E402
import suiterows  # noqa: E402
import suitetimes  # noqa: E402
from harness import ROOT, Checks, options, run  # noqa: E402

MAIN = 'if __name__ == "__main__":\n    '
ROW = "| `{}` | it | law | {} | {} | {} |\n"


def suite(body, head=""):
    return f'"""{head}"""\n{MAIN}{body}\n'


GOOD = suite("print('3 passed, 0 failed')")
# This suite prints the part of its stream that it was asked for.
STREAM = suite("import sys; w = sys.argv[3:]; print(*w); print({'--scale 1/4': 20, '--scale 1 --from 1/4': 60, '': 80, '--scale 2': 160}"
               "[' '.join(w)], 'passed, 0 failed')")
SEEDED = suite("import sys; w = sys.argv[3:]; print(int(w[1]) if '--seed' in w else 3, 'passed, 0 failed')")
SKIPS = suite("print('SKIP x: y\\n1 passed, 0 failed, 1 skipped')")
BAD = suite("print('2 passed, 1 failed')")
THREE = {"a/a.py": suite("print('100 passed, 0 failed')"), "a/b.py": STREAM, "a/c.py": suite("print('1000 passed, 0 failed')"),
         "a/d.py": suite("print('10000 passed, 0 failed')")}
TIERS = [("a/a.py", 100), ("a/b.py", "20 + 60", "random"), ("a/c.py", 1000, "ci"), ("a/d.py", 10000, "long")]
# what is shown, files of tests/, rows (path, least, tier, rooms), options, and what the runner must say last
CASES = [
    ("one suite", {"a/a.py": GOOD}, [("a/a.py", 3)], [], "3 passed, 0 failed"),
    ("a head of 2000 characters", {"a/a.py": suite("print('3 passed, 0 failed')", "suite " * 333)}, [("a/a.py", 3)], [],
     "3 passed, 0 failed"),
    ("fewer checks than recorded", {"a/a.py": GOOD}, [("a/a.py", 4)], [], "3 passed, 1 failed"),
    ("fewer with a sanitizer", {"a/a.py": suite("print('3 passed, 0 failed')")}, [("a/a.py", 4)], ["--sanitizers"], "3 passed, 0 failed"),
    ("fewer with a skip", {"a/a.py": SKIPS}, [("a/a.py", 4)], [], "1 passed, 0 failed, 1 skipped"),
    ("no row", {"a/a.py": GOOD, "a/b.py": GOOD}, [("a/a.py", 3)], [], "3 passed, 1 failed"),
    ("no row, and left out", {"a/a.py": GOOD, "a/b.py": GOOD}, [("a/a.py", 3)], ["--only", "a/a"], "3 passed, 1 failed"),
    ("no file", {"a/a.py": GOOD}, [("a/a.py", 3), ("a/b.py", 3)], ["--only", "a/a"], "3 passed, 1 failed"),
    ("a C suite without a row", {"a/a.py": GOOD, "unit/test_b.c": ""}, [("a/a.py", 3)], ["--only", "a/a"],
     "3 passed, 1 failed"),
    ("two rows", {"a/a.py": GOOD}, [("a/a.py", 3), ("a/a.py", 3)], [], "3 passed, 1 failed"),
    ("by hand", {"a/a.py": GOOD, "a/b.py": GOOD}, [("a/a.py", 3), ("a/b.py", "-", "by hand")], [], "3 passed, 0 failed"),
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
    ("the tier test", THREE, TIERS, [], "120 passed, 0 failed"),
    ("the tier rest", THREE, TIERS, ["--tier", "rest"], "1060 passed, 0 failed"),
    ("the tier sanitizers", {**THREE, "a/b.py": suite("import sys; print(20 if sys.argv[3:] == ['--scale', '1/4', '--sanitizers'] else 0, "
                                                      "'passed, 0 failed')")}, TIERS, ["--tier", "sanitizers", "--sanitizers"],
     "1120 passed, 0 failed"),
    ("the tier long", THREE, TIERS, ["--tier", "long"], "11160 passed, 0 failed"),
    ("the tier all", THREE, TIERS, ["--tier", "all"], "11180 passed, 0 failed"),
    ("one suite in full", THREE, TIERS, ["--only", "a/b"], "80 passed, 0 failed"),
    ("one suite at a scale", THREE, TIERS, ["--only", "a/b", "--scale", "2"], "160 passed, 0 failed"),
    ("a part that is another", THREE, TIERS, ["--only", "a/b", "--scale", "1/4"], "20 passed, 0 failed"),
    ("a suite by its path", THREE, TIERS, ["--tier", "test", "a/b.py", "a/c.py"], "1020 passed, 0 failed"),
    ("a suite that is none", THREE, TIERS, ["--tier", "test", "a/b.py", "a/e.py"], "20 passed, 1 failed"),
    ("a quarter counts too few", THREE, [("a/b.py", "21 + 1", "random"), *(row for row in TIERS if row[0] != "a/b.py")], [],
     "120 passed, 1 failed"),
    ("the rest counts too few", THREE, [("a/b.py", "1 + 61", "random"), *(row for row in TIERS if row[0] != "a/b.py")],
     ["--tier", "rest"], "1060 passed, 1 failed"),
    ("the whole counts too few", THREE, [("a/b.py", "20 + 61", "random"), *(row for row in TIERS if row[0] != "a/b.py")],
     ["--only", "a/b"], "80 passed, 1 failed"),
    ("a scale that is none", THREE, TIERS, ["--scale", "1/0"], ""),
    ("a scale below 0", THREE, TIERS, ["--scale", "-1"], ""),
    *((f"a row: {row[1:]}", {"a/a.py": GOOD, "a/b.py": GOOD}, [row, ("a/b.py", 3)], ["--only", "a/b"], f"3 passed, {many} failed") for row, many in (
        (("a/a.py", 0), 1), (("a/a.py", ""), 1), (("a/a.py", "3 + 4"), 1), (("a/a.py", "-"), 1), (("a/a.py", "many"), 1),
        (("a/a.py", 3, "random"), 1), (("a/a.py", "3 + 0", "random"), 1), (("a/a.py", "3 + 4 + 5", "random"), 1),
        (("a/a.py", "3 + 4", "ci"), 1), (("a/a.py", 3, "by hand"), 1), (("a/a.py", 3, "quick"), 1), (("a/a.py", 3, ""), 1),
        (("a/a.py", 3, "derived", ""), 1), (("a/a.py", 3, "derived", "wing/none"), 1), (("a/a.py", 3, "derived", "wing/room,wing"), 1),
        (("a/a.py", 3, "derived", "all, wing"), 1), (("a/a.py", 3, "derived", "-, wing"), 1), (("a/a.py", 3, "derived", "../src/wing"), 1),
        (("a/a.py", 3, "", "nowhere"), 2), (("a/a.py", 3, "derived", "wing/room, wing"), 0), (("a/a.py", 3, "derived", "all"), 0))),
    ("golden cases fail", {"cases/cases.py": BAD, "a/a.py": GOOD}, [("cases/cases.py", 2), ("a/a.py", 3)], [], "2 passed, 1 failed"),
    ("the others go on after one that fails", {"a/a.py": BAD, "a/b.py": GOOD}, [("a/a.py", 2), ("a/b.py", 3)], ["--jobs", "1"],
     "5 passed, 1 failed"),
    ("a seed is replayed", {"a/a.py": GOOD, "a/b.py": SEEDED, "seeds.txt": "# head\na/b.py 70 1/2  a fault of old\n"},
     [("a/a.py", 3), ("a/b.py", "3 + 9", "random")], [], "76 passed, 0 failed"),
    ("a seed is not replayed by the rest", {"a/a.py": GOOD, "a/b.py": SEEDED, "seeds.txt": "a/b.py 70 1/2  a fault of old\n"},
     [("a/a.py", 3), ("a/b.py", "3 + 3", "random")], ["--tier", "rest"], "3 passed, 0 failed"),
    *((f"a row of seeds: {line}", {"a/a.py": GOOD, "a/b.py": GOOD, "seeds.txt": line + "\n"}, [("a/a.py", 3), ("a/b.py", "3 + 3", "random")],
       ["--only", "a/a"], "3 passed, 1 failed") for line in ("a/c.py 1 1  why", "a/a.py 1 1  why", "a/b.py x 1  why", "a/b.py 1 0  why",
                                                              "a/b.py 1 1", "a/b.py 1 1/0  why", "a/b.py")),
]


def lay_out(folder, files, rows):
    """A folder with made-up suites, their rows and the runner."""
    names = ("run.py", "changed.py", "lib/suiterows.py", "lib/suitetimes.py", "mutation/rooms.py")
    texts = {f"tests/{path}": text for path, text in files.items()}
    texts["tests/README.md"] = "# Tests\n\n" + "".join(ROW.format(row[0], *(row[3:] or ("-",)), *(row[2:3] or ("derived",)), row[1]) for row in rows)
    texts["src/wing/room/source.c"] = ""
    for path, text in texts.items():
        os.makedirs(os.path.dirname(os.path.join(folder, path)), exist_ok=True)
        with open(os.path.join(folder, path), "w", encoding="utf-8") as file:
            file.write(text)
    for name in names:
        os.makedirs(os.path.dirname(os.path.join(folder, "tests", name)), exist_ok=True)
        shutil.copy(os.path.join(ROOT, "tests", name), os.path.join(folder, "tests", name))


def ask(folder, files, rows, words, **environment):
    lay_out(folder, files, rows)
    # The runner asks no interpreter what it has; check_written lets it.
    kept = {**{name: value for name, value in os.environ.items() if name != "GRAZE_SKIPS"}, "GRAZE_FRACTIONS": "python"}
    return run([sys.executable, "tests/run.py", *words], cwd=folder, env={**kept, **environment})


def check_case(checks, folder, what, files, rows, words, want):
    done = ask(folder, files, rows, words)
    checks.equal((done.stdout.splitlines() or [""])[-1], want, what, done.stdout, done.stderr)
    checks.equal(done.returncode, 0 if " 0 failed" in want else 1 if want else 2, what, "status")


def check_skips(checks):
    """A skip that CI does not name is a failure, in the plain build."""
    for skips, more, want in (("", [], "1 passed, 1 failed, 1 skipped"), ("z", [], "1 passed, 1 failed, 1 skipped"),
                              ("z x", [], "1 passed, 0 failed, 1 skipped"), ("", ["--sanitizers"], "1 passed, 0 failed, 1 skipped")):
        with tempfile.TemporaryDirectory() as folder:
            done = ask(folder, {"a/a.py": SKIPS}, [("a/a.py", 1)], more, GRAZE_SKIPS=skips)
        checks.equal(done.stdout.splitlines()[-1], want, "skips allowed:", skips, done.stdout)


def check_order(checks):
    """Golden cases and unit tests begin, then what is derived, then what is random and replayed; the longest first by times.txt."""
    files = {name: GOOD for name in ("a/a.py", "a/b.py", "a/c.py", "a/d.py", "a/e.py", "cases/cases.py")}
    files["times.txt"] = "a/a.py 1.0 1.0\na/b.py 2.0 2.0\na/c.py 90.0 1.0\na/d.py 3.0 3.0 50.0 50.0\na/e.py 100.0 1.0\n"
    files["seeds.txt"] = "a/c.py 5 1  of old\n"
    rows = [("a/a.py", 3), ("a/b.py", 3), ("a/c.py", "3 + 3", "random"), ("a/d.py", "3 + 3", "random"), ("a/e.py", 3, "ci"), ("cases/cases.py", 3)]
    for tier, want in (("test", ["cases/cases.py", "a/b.py", "a/a.py", "a/c.py", "a/d.py", "a/c.py --seed 5 --scale 1"]),
                       ("rest", ["a/e.py", "a/c.py", "a/d.py"])):
        with tempfile.TemporaryDirectory() as folder:
            done = ask(folder, files, rows, ["--jobs", "1", "--tier", tier])
        checks.equal(re.findall(r"^tests/([^:]*): ", done.stdout, re.M), want, "the order of", tier, done.stdout)


def check_written(checks):
    """--record keeps seconds by part, and drops those of suites that are gone; --counts write fills the rows."""
    with tempfile.TemporaryDirectory() as folder:
        lay_out(folder, {**THREE, "times.txt": "a/gone.py 9.0 9.0\na/b.py 8.0 8.0\n"}, TIERS)
        for tier in ("test", "rest"):
            done = run([sys.executable, "tests/run.py", "--tier", tier, "--record", "--counts", "write"], cwd=folder)
            checks.equal(done.returncode, 0, tier, done.stdout, done.stderr)
        with open(os.path.join(folder, "tests", "times.txt"), encoding="utf-8") as file:
            times = [line.split() for line in file if line[0] != "#"]
        with open(os.path.join(folder, "tests", "README.md"), encoding="utf-8") as file:
            counts = re.findall(r"\| ([\d +]+) \|$", file.read(), re.M)
    checks.equal([(row[0], len(row)) for row in times], [("a/a.py", 3), ("a/b.py", 5), ("a/c.py", 3), ("make-test", 3)], "rows of times.txt", times)
    checks.equal(counts, ["90", "18 + 54", "900", "10000"], "nine tenths of what was counted")


def check_rooms(checks):
    """Every room of src has suites whose rows name it, also those that are asked about its mutants; SMOKE's have rows."""
    rows, _ = suiterows.read()
    named = {room for row in rows.values() for room in row.rooms if row.tier in ("derived", "random", "ci")}
    for folder in glob.glob("src/**/", recursive=True, root_dir=ROOT):
        room = folder[len("src/"):-1]
        has_sources = any(re.search(r"\.(c|cpp|h|py|js|sh)$", name) for name in os.listdir(os.path.join(ROOT, folder)))
        checks.holds(not has_sources or room == "docs" or any(f"{room}/".startswith(f"{other}/") for other in named),
                     f"no suite of tests/README.md names the room {room}")
    for room, askers in rooms.ROOMS.items():
        for path in map(rooms.suite, askers):
            checks.holds(path in rows and {room, "all"} & set(rows[path].rooms), f"rooms.py asks {path} of {room}, which its row does not name")
    for path in map(rooms.suite, rooms.SMOKE):
        checks.holds(path in rows and rows[path].tier in ("derived", "random"), f"SMOKE of rooms.py has {path}")
    for path, row in rows.items():
        with open(os.path.join(ROOT, "tests", path), encoding="utf-8") as file:
            has_rounds = not path.startswith("runner/") and re.search(r"\bargs\.(rounds|cycle|once)\(", file.read())
        checks.holds(not has_rounds or row.tier in ("random", "by hand"), f"{path} has rounds; expected the tier random")


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


def check_planted(checks):
    """Each patch of mutation/planted applies, and noticed.txt has a row with its first line; at its top it names the rows without a patch."""
    folder = os.path.join(ROOT, "tests", "mutation", "planted")
    with open(os.path.join(folder, "noticed.txt"), encoding="utf-8") as file:
        text = file.read()
    rows = {name: f"{what}: {path}" for name, what, path in re.findall(r"^([^#| ]+) \| ([^|]*) \| (\S+) \|", text, re.M)}
    patches = glob.glob(os.path.join(folder, "*.patch"))
    checks.holds(len(patches) > 80, "patches of mutation/planted")
    for path in patches:
        name = os.path.basename(path)[:-len(".patch")]
        with open(path, encoding="utf-8") as file:
            checks.equal(rows.pop(name, None), file.readline().rstrip("\n"), name, "in noticed.txt")
        done = run(["git", "apply", "--check", path], cwd=ROOT)
        checks.holds(done.returncode == 0, f"{name} does not apply; expected its fault in today's code, or its place named as gone in noticed.txt",
                     done.stderr)
    for name in rows:
        checks.holds(re.search(rf"^#.*{name}\b", text, re.M), f"{name} has no patch, and the top of noticed.txt does not say why")


def check_machine(checks):
    """A part that a machine lacks is a skip of a name that the CI's list allows, and asked for in one module."""
    with open(os.path.join(ROOT, ".ci", "run"), encoding="utf-8") as file:
        allowed = r"^SKIP (" + "|".join(re.search(r"GRAZE_SKIPS='(.*)'", file.read())[1].split()) + "):"
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


# Stages beside `make test`: made-up commands, and the names of those that must run.
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
    suites = {path for path, row in suiterows.read()[0].items() if row.tier != "by hand"}
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
    check_skips(checks)
    check_order(checks)
    check_written(checks)
    check_rooms(checks)
    check_stages(checks)
    check_times(checks)
    check_exact(checks)
    check_modules(checks)
    check_planted(checks)
    check_machine(checks)
    checks.finish()


if __name__ == "__main__":
    main()
