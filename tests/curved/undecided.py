#!/usr/bin/env python3
# suite
"""Rows with states that are not decided: pmc where the others tell it (C125), and what commands make of such rows.

The point at which two surfaces touch in order 4 is one that the rules leave open, and so are points of a line in which more than
12 planes meet. pmc is that of all ways to complete the states in which I and O are open in time, if they agree.
Points on which the rules work long: `explain` names the limit, and a signal ends them.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import itertools
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from fractions import Fraction as F

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

from scenes import (Checks, Curved, Motion, along, box, common, halfspace, minus, options, polynomial, torus,  # noqa: E402
                    union)

WHOLE = "work=1000000000000000"
PATIENCE = 20                   # seconds after a signal

# z <= 0 touched from above by z <= -x^4 - y^4 + x^2 y^2 at the origin: a flat form of order 4, whose patterns no rule tells.
FLAT = minus(polynomial({"0,0,1": 1, "4,0,0": 1, "0,4,0": 1, "2,2,0": -1}), halfspace((0, 0, 1)))
SOLID = Curved(3, FLAT)
MOTION = along(-1, 1, "t", "0", "t^2")
POINTS = "0,0,0\n0,0,5\n0,0,7\n"
CANDIDATES = [   # answers, agree, wrong, undecided-answers
    (("in", "out", "out"), 2, 0, {"in": 1, "on": 0, "out": 0}),
    (("on", "out", "on"), 1, 1, {"in": 0, "on": 1, "out": 0}),
    (("undecided", "out", "out"), 2, 0, {"in": 0, "on": 0, "out": 0}),
]
# Fifteen planes through a point that touches both outer gaps: dimension, limit, the reason that is told. In the plane a line counts
# 1 + 6, and 8 (15 * 7)^2 = 88200.
REASONS = [(3, [], "more than 12 surfaces meet there"), (2, ["--limit", "work=88199"], "the limit `work` allows fewer surfaces"),
           (2, ["--limit", "work=88200"], "")]


# Seven sectors between lines through the origin, less than a quarter turn apart in all, times [-1, 1]: 14 planes in the z axis.
# A ball around all, without which the solids would be meshes, has no other part in it.
STAR = {"polygon": {"points": [[str(c) for c in p] for k in range(1, 8) for p in ((0, 0), (10, -k * k - 20), (10, -k * k - 20 - k))],
                    "extrude": ["-1", "1"]}}


def moved(low, high, *by):
    return Motion(3, [(low, high, {"translate": by})])


AROUND = {"ball": {"radius": 1000}}
LARGE, SLAB, EDGE = box((-9, -9, -9), (9, 9, 9)), box((2, -1, -1), (3, 1, 1)), box((2, -1, 0), (3, 1, 1))
BESIDE = minus(LARGE, FLAT, box((2, -1, 0), (3, 1, 1)))   # the complement of both, cut off where no trajectory comes
RIGHT = moved(-1, 4, "t", "0", "0")
REST = Motion(3, [(0, 1, {"translate": ["0", "0", "0"]}), (1, 5, {"translate": ["t-1", "0", "0"]})])
UP = Motion(3, [(0, 1, {"translate": ["0", "0", "t/2"]}), (1, 5, {"translate": ["t-1", "0", "1/2"]})])
# Name, solid, motion, and for the sweep and the unsweep the states of the origin at the time t0, in the gap behind it, at the next
# time and so on to t1. A sweep's trajectory is -x, an unsweep's x. SLAB is met in its interior, EDGE in z = 0, a side of it.
OPEN = [
    ("in behind", union(FLAT, SLAB), moved(-4, 1, "t", "0", "0"), "OOBIBO?OO", "OO?OO"),
    ("in before", union(FLAT, SLAB), moved(-1, 4, "-t", "0", "0"), "OO?OBIBOO", "OO?OO"),
    ("in to the end", union(FLAT, SLAB), moved(0, F(5, 2), "-t", "0", "0"), "?OBII", "?OO"),
    ("in from the start", union(FLAT, SLAB), moved(F(-5, 2), 0, "t", "0", "0"), "IIBO?", "OO?"),
    ("touched", union(FLAT, EDGE), moved(-1, 4, "-t", "0", "0"), "OO?OBBBOO", "OO?OO"),
    ("touched, ? first", union(FLAT, EDGE), moved(0, 4, "-t", "0", "0"), "?OBBBOO", "?OO"),
    ("touched, ? last", union(FLAT, EDGE), moved(-4, 0, "t", "0", "0"), "OOBBBO?", "OO?"),
    ("touched, at rest in ?", union(FLAT, EDGE), Motion(3, [(0, 1, {"translate": ["0"] * 3}), (1, 5, {"translate": ["1-t", "0", "0"]})]),
     "???OBBBOO", "???OO"),
    ("alone", FLAT, RIGHT, "OO?OO", "OO?OO"),
    ("never out", minus(LARGE, FLAT), RIGHT, "II?II", "II?II"),
    ("never out, touched", BESIDE, RIGHT, "II?II", "II?IBBBII"),
    ("never out, at rest in ?, touched", BESIDE, REST, "???II", "???IBBBII"),
    ("out at the end", minus(LARGE, FLAT, SLAB), moved(0, F(5, 2), "t", "0", "0"), "?II", "?IBOO"),
    ("through a line of many planes", common(union(STAR, EDGE), AROUND), RIGHT, None, "OO?OBBBOO"),
    ("along a line of many planes", common(union(STAR, box((2, -1, F(1, 2)), (3, 1, 1))), AROUND), UP, None, "???OBBBOO"),
]


def memberships(states, unsweep):
    """pmc of each way to complete the states: where one is I (O) at a time, so are the gaps beside it."""
    found = set()
    places = [k for k, letter in enumerate(states) if letter == "?"]
    for letters in itertools.product("IBO", repeat=len(places)):
        s = list(states)
        for k, letter in zip(places, letters):
            s[k] = letter
        times = [k for k in range(0, len(s), 2) if s[k] != "B"]
        if any(s[n] != s[k] for k in times for n in (k - 1, k + 1) if 0 <= n < len(s)):
            continue
        if any(s[k] != "B" and s[k] != s[n] and s[n] != "B" for k, n in zip(range(len(s)), range(1, len(s)))):
            continue
        first, last = ("out", "in") if unsweep else ("in", "out")
        found.add(first if ("O" if unsweep else "I") in s else "on" if "B" in s else last)
    return found


def merged(states):
    return "".join(letter for letter, _ in itertools.groupby(states))


def check_memberships(bench):
    """pmc, word and the empty columns; pmc alone is the same."""
    checks, seen = bench.checks, set()
    points = bench.file("o.csv", "0,0,0\n")
    for name, node, motion, *states in OPEN:
        paths = [bench.file("o.csg.json", Curved(3, node).text()), bench.file("o.json", motion.text()), points]
        for operation, path in zip(("sweep", "unsweep"), states):
            if path is None:
                continue
            expected = memberships(path, operation == "unsweep")
            pmc = expected.pop() if len(expected) == 1 else "undecided"
            seen.add((operation, pmc))
            told = bench.run("classify", *paths, "--operation", operation)
            row = next(csv.DictReader(line for line in told.stdout.splitlines() if not line.startswith("#")), {})
            checks.equal((row.get("pmc"), row.get("word")), (pmc, merged(path)), name, operation, told.stderr)
            checks.holds("\n# contract 2\n" in told.stdout and "\n# undecided 1\n" in told.stdout, name, told.stdout)
            checks.holds("note: the word of 1 of 1 rows is undecided" in told.stderr, name, told.stderr)
            if operation == "sweep":
                checks.equal([row.get(k) for k in ("class", "definition", "case", "i", "t")], ["undecided", "", "", "", ""], name)
            alone = bench.run("classify", *paths, "--operation", operation, "--columns", "pmc").stdout.splitlines()
            checks.equal(alone[-3:], [f"0,0,0,{pmc}", f"# undecided {int(pmc == 'undecided')}", "# complete 1"], name, operation)
            said = bench.run("explain", *paths[:2], "0", "0", "0", "--operation", operation).stdout
            checks.equal((f"P is `{pmc}` whatever that state is" in said, "The state is not decided" in said), (pmc != "undecided", True), said)
    checks.equal(len(seen), 6, "in, on and undecided of a sweep, out, on and undecided of an unsweep", sorted(seen))


def check_tables(bench):
    """A row that has pmc alone is judged by it; a table that was made before such rows, and one made since, agree."""
    checks = bench.checks
    paths = [bench.file("o.csg.json", Curved(3, union(FLAT, SLAB)).text()), bench.file("o.json", moved(-4, 1, "t", "0", "0").text()),
             bench.file("o.csv", "0,0,0\n0,0,5\n2,0,1/2\n")]   # the second one is out, the third in: x from -2 to 3, z = 1/2
    golden = bench.run("classify", *paths).stdout
    before = golden.replace("\n0,0,0,in,", "\n0,0,0,undecided,").replace("# contract 2", "# contract 1")
    checks.holds("\n0,0,0,in,undecided,,,,,OBIBO?O\n" in golden and before != golden, golden)
    full, head = bench.file("g.csv", golden), "x,y,z,"
    rest = "0,0,5,out,exterior,9,1,0,0,O\n2,0,1/2,in,regular,5,1,2,0,OBIBO\n"
    for name, given, agree, wrong, undecided, alone in (
            ("itself", golden, 3, 0, 0, 1),
            ("from before", before, None, None, None, None),
            ("another word", "x,y,z,pmc,class,definition,case,i,t,word\n0,0,0,in,fold,6,1,4,0,OBIBO\n" + rest, 3, 0, 0, 1),
            ("another pmc", "x,y,z,pmc,class,definition,case,i,t,word\n0,0,0,on,fold,6,1,4,0,OBIBO\n" + rest, 2, 1, 0, 1),
            ("pmc alone", head + "pmc\n0,0,0,in\n0,0,5,out\n2,0,1/2,in\n", 3, 0, 0, 0),
            ("the class alone", head + "class\n0,0,0,fold\n0,0,5,exterior\n2,0,1/2,regular\n", 2, 0, 1, 0)):
        done = bench.run("compare", full, bench.file("c.csv", given), "--format", "json")
        if agree is None:   # pmc `undecided` is no answer to a row that has one
            checks.equal((done.returncode, "pmc: 'undecided' is no answer" in done.stderr), (3, True), name, done.stderr)
            continue
        report = json.loads(done.stdout or "{}")
        checks.equal([done.returncode, *(report.get(k) for k in ("agree", "wrong", "undecided", "golden-rows-of-pmc-alone"))],
                     [int(wrong > 0), agree, wrong, undecided, alone], name, done.stderr)
        counted = sum(n for row in report.get("class", {}).values() for n in row.values())
        checks.equal(counted, 2 if "class" in given else 0, name, "rows in the matrix of classes")
    text = bench.run("compare", full, full).stdout
    checks.holds("in 1 golden rows class, i, t and word are undecided: pmc is judged\n" in text, text)
    since = json.loads(bench.run("compare", bench.file("b.csv", before), full, "--format", "json").stdout or "{}")
    checks.equal([since.get(k) for k in ("agree", "wrong", "undecided")], [2, 0, 1], "a golden table from before, and one made since")
    record = json.loads(bench.run("classify", *paths, "--format", "jsonl").stdout.splitlines()[0])
    checks.equal([record.get(k) for k in ("pmc", "class", "word", "contacts", "i")], ["in", "undecided", "OBIBO?O", [], None], record)
    checks.holds(record["undecided"]["reason"], record)
    array = bench.file("o.npy", "")
    checks.equal(bench.run("classify", *paths, "--format", "npy", "--output", array).returncode, 0)
    with open(array, "rb") as file:   # pmc, class, four numbers of 4 bytes that are 0, the word
        checks.holds(b"in\0undecided" + bytes(16) + b"OBIBO?O" in file.read(), "npy")


def check_made(bench):
    """Corners whose trajectory comes by what no rule tells, along the line x = y = z, are made: they are in."""
    paths = [bench.file("o.csg.json", Curved(3, union(common(box((-1, -1, -1), (1, 1, 1)), FLAT), box((2, 2, 2), (3, 3, 3)))).text()),
             bench.file("o.json", along(-8, 8, "t", "t", "t").text())]
    made = bench.run("generate", *paths, "-n", "60", "--seed", "1", "--strata", "vertex").stdout
    rows = [r for r in csv.DictReader(line for line in made.splitlines() if not line.startswith("#")) if r["x"] == r["y"] == r["z"]]
    bench.checks.holds(len(rows) >= 4, "corners on the line", len(rows))
    told = bench.run("classify", *paths, bench.file("o.csv", made)).stdout
    pmc = [r["pmc"] for r in csv.DictReader(line for line in told.splitlines() if not line.startswith("#")) if "?" in r["word"]]
    bench.checks.equal(set(pmc), {"in"}, "their answers")
    picture = bench.run("draw", *paths, "--plane", "z=1", "--box", "0,0,0,4,4,4", "--grid", "2", "-o", os.path.join(bench.folder, "o.svg"))
    bench.checks.equal(picture.returncode, 0, picture.stderr)


class Bench:
    def __init__(self, checks, args, folder):
        self.checks, self.graze, self.folder = checks, os.path.abspath(args.graze), folder

    def file(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run(self, *words):
        return subprocess.run([self.graze, *words], capture_output=True, text=True, timeout=120)


def judge(bench, name, done, agree, wrong, answers):
    checks = bench.checks
    if not checks.holds(done.stdout.startswith("{"), name, done.stderr):
        return
    report = json.loads(done.stdout)
    report = report.get("comparison", report)
    checks.equal(done.returncode, 1 if wrong else 0, name, done.stderr)
    checks.equal([report[k] for k in ("rows", "agree", "wrong", "missing", "undecided", "undecided-golden-rows")],
                 [3, agree, wrong, 0, 1, 1], name)
    checks.equal(report["undecided-answers"], answers, name)
    counted = sum(n for row in report["pmc"].values() for n in row.values())
    checks.equal(counted, 2, name, "rows in the matrix")


def hard_points(bench):
    """Solid, motion and point: two quartics that touch along a line, with long numbers, at an irrational time; and a slide
    along the circle in which two rings touch, of degree 80 and 300 digits."""
    rng = random.Random(1)
    touching = minus(polynomial({"0,0,1": 7, "1,0,1": 1, "0,2,1": 2, "0,1,2": -1, "3,0,1": 2, "2,0,0": 5, "2,2,0": 3, "4,0,0": 1}),
                     polynomial({"0,0,1": 6, "0,3,1": 1, "2,0,1": 2, "2,0,0": 9, "2,1,0": -1, "2,0,2": 1, "3,0,0": 2}))
    rows = [["1", "1/33333333", "-1/27777777", "0"], ["2/71111111", "1", "1/3", "0"], ["1/2", "-1/4", "1", "0"]]
    rings = union(*(torus((0, 0, 0), (0, 0, 1), r, 1) for r in (2, 4)))
    angle = "+".join(f"({rng.randint(-10 ** 300, 10 ** 300)}e-301)*t^{k}" for k in range(41))
    turn = Motion(3, [(0, 1, {"rotate": {"tan_half": angle, "axis": ["0", "0", "1"]}})])
    for name, node, motion, point in (
            ("touching", {"affine": {"matrix": rows, "of": touching}}, along(0, 1, "1/2-t^2", "t^2-1/2", "1-2*t^2"),
             ("1/99999999", "1/3", "-1/12")), ("slide", rings, turn, ("0", "3", "0"))):
        yield (name, bench.file(name + ".csg.json", Curved(3, node).text()), bench.file(name + ".json", motion.text()), point)


def check_hard_points(bench):
    """Without the limit they go on for a minute; a signal ends each command, all four at once."""
    started = []
    for name, solid, motion, point in hard_points(bench):
        told = bench.run("explain", solid, motion, *point, "--limit", "work=2000000")
        bench.checks.equal((told.returncode, "the limit work was met" in told.stdout), (0, True), name, told.stdout, told.stderr)
        points = bench.file(name + ".csv", ",".join(point) + "\n")
        for words in (("explain", solid, motion, *point), ("classify", "--jobs", "1", solid, motion, points)):
            started.append((name, words[0], subprocess.Popen([bench.graze, *words, "--limit", WHOLE], stdout=subprocess.DEVNULL,
                                                             stderr=subprocess.DEVNULL)))
    time.sleep(2)
    for name, command, process in started:
        bench.checks.equal(process.poll(), None, name, command, "is at work")
        process.send_signal(signal.SIGTERM)
    late = time.monotonic() + PATIENCE
    for name, command, process in started:
        try:
            process.wait(max(0, late - time.monotonic()))
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        bench.checks.equal(process.returncode, -signal.SIGTERM, name, command, "is ended by a signal")


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(checks, args, folder)
        solid, motion = bench.file("s.csg.json", SOLID.text()), bench.file("m.json", MOTION.text())
        points = bench.file("p.csv", POINTS)
        table = bench.run("classify", solid, motion, points, "--quiet")
        golden = bench.file("g.csv", table.stdout)
        pmc = [line.split(",")[3] for line in table.stdout.splitlines() if not line.startswith(("#", "x"))]
        checks.equal(pmc, ["undecided", "out", "out"], "golden", table.stderr)
        for operation, pmc, word in (("sweep", "undecided", "undecided"), ("unsweep", "out", "")):
            told = bench.run("classify", solid, motion, points, "--quiet", "--operation", operation).stdout
            row = next(csv.DictReader(line for line in told.splitlines() if not line.startswith("#")))
            checks.equal((row["pmc"], row.get("class") or ""), (pmc, word), operation)
        decided = bench.run("classify", solid, motion, bench.file("d.csv", "0,0,5\n0,0,7\n"))
        checks.equal((decided.returncode, decided.stderr), (0, ""), "no note of no row")
        for answers, agree, wrong, counts in CANDIDATES:
            rows = "".join(f"{p},{a}\n" for p, a in zip(POINTS.split(), answers))
            given = bench.file("c.csv", "x,y,z,pmc\n" + rows)
            judge(bench, answers, bench.run("compare", golden, given, "--format", "json"), agree, wrong, counts)
            done = bench.run("validate", solid, motion, "--points", points, "--format", "json", "--quiet",
                             "--candidate", f"sh -c 'cp \"$1\" \"$3\"' sh {given} {{points}} {{out}}")
            judge(bench, ("validate", *answers), done, agree, wrong, counts)
        for d, limit, reason in REASONS:
            fan = [halfspace((k, *[1] * (d - 1))) for k in range(-7, 8)]
            files = bench.file("f.csg.json", Curved(d, common(*fan)).text()), bench.file("f.json", along(-1, 1, *["t", "0", "0"][:d]).text())
            told = bench.run("explain", *files, *["0"] * d, *limit).stdout
            checks.holds(reason in told, "reason", told)
            checks.equal("?" in told, bool(reason), "word", told)
        text = bench.run("compare", golden, given)
        checks.holds("in 1 golden rows all answers that are judged are undecided" in text.stdout, text.stdout)
        refused = bench.run("compare", golden, bench.file("c.csv", "x,y,z,pmc\n0,0,0,in\n0,0,5,undecided\n0,0,7,out\n"))
        checks.equal((refused.returncode, "is no answer" in refused.stderr), (3, True), "no answer where there is one")
        check_memberships(bench)
        check_tables(bench)
        check_made(bench)
        check_hard_points(bench)
    checks.finish()


if __name__ == "__main__":
    main()
