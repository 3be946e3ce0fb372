#!/usr/bin/env python3
# suite
"""`classify --at-rest`: heads and rows in every format, grids, shards, continued tables, comparisons, curved solids, refusals.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import ast
import csv
import json
import os
import re
import struct
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
for folder in ("lib", os.path.join("agree", "lib")):
    sys.path.insert(0, os.path.join(HERE, "..", folder))

from exact import Fraction as F  # noqa: E402
from program import Checks, Graze, options  # noqa: E402

CUBE = os.path.join(HERE, "..", "refuse", "common", "cube.off")  # [0, 2]^3
# Points, where they are, and the signed distance to the cube, or its square where it is out; the square root of 2 is irrational.
ROWS = [("1", "1", "1", "in", F(-1)), ("0.5", "1", "1", "in", F(-1, 2)), ("2", "1", "1/3", "on", F(0)), ("0", "0", "2", "on", F(0)),
        ("5", "6", "1", "out", F(25)), ("3", "3", "1", "out", F(2)), ("1", "1", "-1e-9", "out", F(1, 10 ** 18))]
BALL = {"dimension": 3, "solid": {"ball": {"radius": 5}}}
HALF = {"dimension": 2, "solid": {"halfspace": {"normal": [3, 4], "offset": 5}}}
# Where z + x^4 + y^4 - x^2 y^2 = 0 meets its tangent plane z = 0, no rule decides (0, 0, 0).
FLAT = {"dimension": 3, "solid": {"difference": [{"polynomial": {"0,0,1": 1, "4,0,0": 1, "0,4,0": 1, "2,2,0": -1}},
                                                {"halfspace": {"normal": [0, 0, 1], "offset": 0}}]}}


def rows_of(text):
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def notes_of(text):
    return [line[2:].split(" ", 1) for line in text.splitlines() if line.startswith("# ")]


class Suite:
    def __init__(self, args):
        self.checks = Checks()
        self.graze = Graze(args, self.checks)
        self.points = self.graze.write("points.csv", "x,y,z,name\n" + "".join(f"{x},{y},{z},p{k}\n" for k, (x, y, z, *_) in enumerate(ROWS)))
        self.moved = self.graze.write("move.json", '{"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["8*t", 0, 0]}}]}')

    def run(self, *words, status=0, said="", command="classify"):
        done = self.graze.call(command, *words)
        self.checks.equal((done.returncode, done.stderr), (status, said), command, *words)
        return done.stdout

    def rest(self, *words, **more):
        return self.run(CUBE, self.points, "--at-rest", *words, **more)


def check_table(suite):
    checks, plain = suite.checks, suite.rest()
    keys = ["graze", "contract", "dimension", "solid-sha256", "scene-sha256", "at-rest", "round", "columns", "triangulate", "coordinates", "complete"]
    checks.equal([note[0] for note in notes_of(plain)], keys, "head")
    notes = dict(notes_of(plain))
    checks.equal([notes[k] for k in ("at-rest", "columns", "complete")], ["yes", "pmc", str(len(ROWS))])
    body = [line for line in plain.splitlines() if not line.startswith("#")]
    checks.equal(body, ["x,y,z,pmc,name", *(f"{x},{y},{z},{pmc},p{k}" for k, (x, y, z, pmc, _) in enumerate(ROWS))], "rows")
    near = suite.rest("--sdf", "1e-9")
    checks.equal([note[0] for note in notes_of(near)], keys[:7] + ["sdf", "diagonal"] + keys[7:], "head with sdf")
    checks.equal(list(rows_of(near)[0]), ["x", "y", "z", "pmc", "name", "sdf_low", "sdf_high"], "columns with sdf")
    for row, (*_, pmc, s) in zip(rows_of(near), ROWS):
        low, high = F(row["sdf_low"]), F(row["sdf_high"])
        right = low * low <= s <= high * high and low >= 0 if pmc == "out" else low <= s <= high
        checks.holds(row["pmc"] == pmc and right and high - low <= F(1, 10 ** 9), row)
    for words in ((), ("--sdf", "1e-9")):
        table = suite.rest(*words)
        checks.equal(suite.run(CUBE, suite.graze.write("again.csv", table), "--at-rest", *words), table, "a table as points")
        checks.equal(suite.rest(*words, "--no-filter"), table, "no filter")
        checks.equal(suite.rest(*words, "--columns", "pmc"), table, "--columns pmc")
        with open(suite.points, encoding="utf-8") as file:
            done = subprocess.run([suite.graze.path, "classify", CUBE, "-", "--at-rest", *words], stdin=file, capture_output=True, text=True, timeout=60)
        checks.equal(done.stdout, table, "standard input", done.stderr)


def npy_rows(path):
    with open(path, "rb") as file:
        data = file.read()
    size, = struct.unpack("<I", data[8:12])
    head = ast.literal_eval(data[12:12 + size].decode())
    form = "<" + "".join({"f8": "d", "u4": "I"}.get(kind[1:], kind[2:] + "s") for _, kind in head["descr"])
    return [name for name, _ in head["descr"]], list(struct.iter_unpack(form, data[12 + size:]))


def check_formats(suite):
    checks = suite.checks
    near = rows_of(suite.rest("--sdf", "1e-9"))
    lines = [json.loads(line) for line in suite.rest("--format", "jsonl").splitlines()]
    checks.equal(lines, [{"point": [str(F(c)) for c in row[:3]], "pmc": row[3]} for row in ROWS], "jsonl")
    lines = [json.loads(line) for line in suite.rest("--format", "jsonl", "--sdf", "1e-9").splitlines()]
    checks.equal([list(line) for line in lines], [["point", "pmc", "sdf_low", "sdf_high"]] * len(ROWS), "jsonl with sdf")
    checks.equal([(line["sdf_low"], line["sdf_high"]) for line in lines], [(float(r["sdf_low"]), float(r["sdf_high"])) for r in near], "jsonl")
    answers = [row[3] for row in ROWS]
    for words, names in (((), []), (("--sdf", "1e-9"), ["sdf_low", "sdf_high"])):
        path = suite.graze.write("out.npy", "")
        suite.rest("--format", "npy", "-o", path, *words)
        found, values = npy_rows(path)
        checks.equal((found, [row[3].rstrip(b"\0").decode() for row in values]), (["x", "y", "z", "pmc", "name", *names], answers), "npy")
        checks.equal([row[5:] for row in values] if names else near, [(float(r["sdf_low"]), float(r["sdf_high"])) for r in near] if names else near)
        path = suite.graze.write("out.vtk", "")
        suite.rest("--format", "vtk", "-o", path, *words)
        with open(path, "rb") as file:
            scalars = re.findall(rb"^SCALARS (\w+) ", file.read(), re.M)
        checks.equal([name.decode() for name in scalars], ["pmc", "name", *names], "vtk")


def check_grid(suite):
    """The 5 x 5 x 5 points of [-1, 3]^3: by hand; a distance too; by parts, by threads, in the box of the solid."""
    checks, grid = suite.checks, ("--grid", "5,5,5", "--box=-1,-1,-1,3,3,3")
    for words in ((), ("--sdf", "1e-9")):
        whole = suite.run(CUBE, "--at-rest", *grid, *words)
        rows = rows_of(whole)
        checks.equal(len(rows), 125, words)
        for row in rows:
            beyond = [max(-F(row[a]), F(row[a]) - 2) for a in "xyz"]
            checks.equal(row["pmc"], ("in", "on", "out")[(max(beyond) >= 0) + (max(beyond) > 0)], row)
            if words:
                square = sum(max(b, 0) ** 2 for b in beyond) or max(beyond) ** 2
                ends = sorted(F(row[k]) ** 2 for k in ("sdf_low", "sdf_high"))
                checks.holds(ends[0] <= square <= ends[1], row)
        checks.equal(suite.run(CUBE, "--at-rest", *grid, *words, "--jobs", "3"), whole, "threads")
        parts = [suite.graze.write(f"part{k}.csv", suite.run(CUBE, "--at-rest", *grid, *words, "--shard", f"{k}/3")) for k in (1, 2, 3)]
        checks.equal(suite.run(*parts, command="merge"), whole, "merged")
        lines = whole.splitlines(keepends=True)
        begun = suite.graze.write("begun.csv", "".join(lines[:-30]) + lines[-30][:4])
        suite.run(CUBE, "--at-rest", *grid, *words, "--resume", begun)
        with open(begun, encoding="utf-8") as file:
            checks.equal(file.read(), whole, "continued")
    box = dict(notes_of(suite.run(CUBE, "--at-rest", "--grid", "2,2,2")))["box"]
    checks.equal(box, "0,0,0,2,2,2", "the box of the solid")


def check_compare(suite):
    checks, golden = suite.checks, suite.graze.write("golden.csv", suite.rest("--sdf", "1e-9"))
    right = suite.graze.write("right.csv", suite.rest())
    suite.run(golden, right, command="compare")
    wrong = suite.graze.write("wrong.csv", "x,y,z,pmc\n" + "".join(f"{x},{y},{z},{'in' if pmc == 'on' else pmc}\n" for x, y, z, pmc, _ in ROWS))
    said = json.loads(suite.run(golden, wrong, "--solid", CUBE, "--format", "json", command="compare", status=1))
    checks.equal((said["rows"], said["agree"], said["wrong"]), (7, 5, 2), "wrong rows")
    told = [row["explain"] for row in said["disagreements"]]
    checks.equal(sorted(told), sorted(f"echo {p} | graze classify {CUBE} - --at-rest" for p in ("2 1 1/3", "0 0 2")), "explained")
    for command in told:
        path = f"{os.path.dirname(suite.graze.path)}:{os.environ['PATH']}"
        done = subprocess.run(["sh", "-c", command], capture_output=True, text=True, timeout=60, env={**os.environ, "PATH": path})
        checks.holds(",on\n" in done.stdout, command, done.stderr)
    values = suite.graze.write("values.csv", "x,y,z,sdf\n" + "".join(f"{x},{y},{z},{-1 if pmc == 'in' else 0 if pmc == 'on' else 1}\n" for x, y, z, pmc, _ in ROWS))
    suite.run(golden, values, "--candidate-has", "sdf", command="compare")
    suite.run(golden, right, "--solid", CUBE, "--motion", suite.moved, "--page", suite.graze.write("page.html", ""), command="compare", status=2,
              said=f"graze: {golden} is a table of a solid at rest, which has no motion to show; expected no --page\n")
    moving = suite.graze.write("moving.csv", suite.run(CUBE, suite.moved, suite.points, "--columns", "pmc"))
    hashes = [dict(notes_of(open(path, encoding="utf-8").read()))["scene-sha256"] for path in (moving, golden)]
    suite.run(golden, moving, command="compare", status=3,
              said=f"graze: {moving}: scene-sha256 is {hashes[0]}, that of {golden} is {hashes[1]}; expected tables of one scene and one set of options\n")


def check_solids(suite):
    """A ball, a half-plane, which has no box, a point that no rule decides, polygons with holes, a rounded point."""
    checks = suite.checks
    ball, half, flat = (suite.graze.write(f"{name}.csg.json", json.dumps(node)) for name, node in (("ball", BALL), ("half", HALF), ("flat", FLAT)))
    table = suite.run(ball, suite.graze.write("p.csv", "3,4,0\n0,3,4\n3,4,1e-30\n5,0,-1e-30\n2.99,4,0\n"), "--at-rest")
    checks.equal([row["pmc"] for row in rows_of(table)], ["on", "on", "out", "out", "in"], "ball")
    checks.holds("\n# undecided 0\n" in table and table.startswith("# graze") and "# contract 2\n" in table, table)
    table = suite.run(half, suite.graze.write("p.csv", "3,-1\n3,-1.01\n3,-0.99\n1e9,-1e9\n"), "--at-rest")
    checks.equal([row["pmc"] for row in rows_of(table)], ["on", "in", "out", "in"], "half-plane")
    suite.run(half, "--at-rest", "--grid", "2,2", status=3,
              said="graze: no box of the curved solid is proved; expected balls, cylinders with two ends and other bounded primitives, or their "
                   "intersection with a box\n")
    table = suite.run(flat, suite.graze.write("p.csv", "0,0,0\n0,0,-1\n0,0,1\n"), "--at-rest",
                      said="graze: note: pmc of 1 of 3 rows is undecided\n")
    checks.equal([row["pmc"] for row in rows_of(table)], ["undecided", "out", "out"], "undecided", table)
    checks.holds("\n# undecided 1\n" in table, table)
    suite.run(ball, suite.points, "--at-rest", "--sdf", "1", status=3,
              said=f"graze: {ball}: the solid is a curved solid in space; --sdf takes polygons and polyhedra\n")
    ring = suite.graze.write("ring.wkt", "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (2 2, 4 2, 4 4, 2 4, 2 2))\n")
    table = suite.run(ring, suite.graze.write("p.csv", "1,1\n3,3\n2,3\n4,4\n6,5\n7,7\n"), "--at-rest", "--sdf", "1e-3")
    checks.equal([row["pmc"] for row in rows_of(table)], ["in", "out", "on", "on", "on", "out"], "ring")
    for row, s in zip(rows_of(table), (-1, 1, 0, 0, 0)):
        checks.holds(F(row["sdf_low"]) <= s <= F(row["sdf_high"]), "ring", row)
    touch = suite.graze.write("touch.wkt", "MULTIPOLYGON (((0 0, 6 0, 6 3, 0 3, 0 0), (3 0, 4 1, 3 2, 2 1, 3 0)), ((3 3, 4 5, 2 5, 3 3)))\n")
    table = suite.run(touch, suite.graze.write("p.csv", "3,0\n3,1e-9\n3,3\n3,2.9\n3,3.1\n2.9,3.1\n2,1\n"), "--at-rest")
    checks.equal([row["pmc"] for row in rows_of(table)], ["on", "out", "on", "in", "in", "out", "on"], "a hole and a part that touch the outer ring")
    rounded = suite.run(CUBE, suite.graze.write("p.csv", "2.00000001,1,1\n"), "--at-rest", "--round", "binary32")
    checks.equal([row["pmc"] for row in rows_of(rounded)], ["on"], "rounded to 2")


def check_refused(suite):
    near = ("--sdf", "1")
    for name, *words in (("operation", "sweep"), ("operation", "unsweep"), ("overlap", "extend"), ("folds", "separate"), ("moments",), ("topo",),
                         ("regular",), ("times",), ("certify", "c.txt"), ("receipt", suite.moved), ("boundary-distance",), ("motion-error", "1")):
        suite.rest(f"--{name}", *words, *near, status=2, said=f"graze: --{name} needs a motion; expected no --at-rest beside it\n")
    suite.rest("--columns", "all", status=2, said="graze: --columns all needs a motion; expected no --at-rest beside it\n")
    count = "classify takes SOLID, with --at-rest no MOTION, and"
    suite.run(CUBE, suite.moved, suite.points, "--at-rest", status=2,
              said=f"graze: {count} POINTS or --grid, 3 operands given; see graze classify --help\n")
    suite.run(CUBE, suite.points, "--at-rest", "--grid", "2,2,2", status=2,
              said=f"graze: {count} with --grid no POINTS, 2 operands given; see graze classify --help\n")
    suite.run(CUBE, suite.points, status=2, said="graze: classify takes SOLID, MOTION and POINTS or --grid, 2 operands given; see graze classify --help\n")
    suite.rest("--format", "jsonl", "--shard", "1/2", status=2, said="graze: --shard needs the head of a table; expected --format csv\n")
    suite.rest("-o", suite.points, status=2, said=f"graze: --output {suite.points}: is also {suite.points}, which is read; expected another file\n")
    with open(suite.points, encoding="utf-8") as file:
        done = subprocess.run([suite.graze.path, "classify", CUBE, "-", "--at-rest", "-o", suite.points], stdin=file, capture_output=True, text=True, timeout=60)
    suite.checks.equal(done.stderr, f"graze: --output {suite.points}: is also standard input, which is read; expected another file\n", "guarded")


def main():
    suite = Suite(options(__doc__.splitlines()[0]))
    check_table(suite)
    check_formats(suite)
    check_grid(suite)
    check_compare(suite)
    check_solids(suite)
    check_refused(suite)
    suite.checks.finish()


if __name__ == "__main__":
    main()
