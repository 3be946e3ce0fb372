#!/usr/bin/env python3
# suite
"""Golden rows that are `undecided`: compare and validate count them apart, and judge nothing by them.

The point at which two surfaces touch in order 4 is one that the rules leave open; beside it are points of balls.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import json
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

from scenes import Checks, Curved, along, halfspace, minus, options, polynomial  # noqa: E402

# z <= 0 touched from above by z <= -x^4 - y^4 + x^2 y^2 at the origin: a flat form of order 4, whose patterns no rule tells.
SOLID = Curved(3, minus(polynomial({"0,0,1": 1, "4,0,0": 1, "0,4,0": 1, "2,2,0": -1}), halfspace((0, 0, 1))))
MOTION = along(-1, 1, "t", "0", "t^2")
POINTS = "0,0,0\n0,0,5\n0,0,7\n"
CANDIDATES = [   # answers, agree, wrong, undecided-answers
    (("in", "out", "out"), 2, 0, {"in": 1, "on": 0, "out": 0}),
    (("on", "out", "on"), 1, 1, {"in": 0, "on": 1, "out": 0}),
    (("undecided", "out", "out"), 2, 0, {"in": 0, "on": 0, "out": 0}),
]


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
        for operation, word in (("sweep", "undecided"), ("unsweep", "")):
            told = bench.run("classify", solid, motion, points, "--quiet", "--operation", operation).stdout
            row = next(csv.DictReader(line for line in told.splitlines() if not line.startswith("#")))
            checks.equal((row["pmc"], row.get("class") or ""), ("undecided", word), operation)
        decided = bench.run("classify", solid, motion, bench.file("d.csv", "0,0,5\n0,0,7\n"))
        checks.equal((decided.returncode, decided.stderr), (0, ""), "no note of no row")
        for answers, agree, wrong, counts in CANDIDATES:
            rows = "".join(f"{p},{a}\n" for p, a in zip(POINTS.split(), answers))
            given = bench.file("c.csv", "x,y,z,pmc\n" + rows)
            judge(bench, answers, bench.run("compare", golden, given, "--format", "json"), agree, wrong, counts)
            done = bench.run("validate", solid, motion, "--points", points, "--format", "json", "--quiet",
                             "--candidate", f"sh -c 'cp \"$1\" \"$3\"' sh {given} {{points}} {{out}}")
            judge(bench, ("validate", *answers), done, agree, wrong, counts)
        text = bench.run("compare", golden, given)
        checks.holds("of these 1 golden rows are undecided themselves" in text.stdout, text.stdout)
        refused = bench.run("compare", golden, bench.file("c.csv", "x,y,z,pmc\n0,0,0,in\n0,0,5,undecided\n0,0,7,out\n"))
        checks.equal((refused.returncode, "is no answer" in refused.stderr), (3, True), "no answer where there is one")
    checks.finish()


if __name__ == "__main__":
    main()
