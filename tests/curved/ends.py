#!/usr/bin/env python3
# suite
"""Boxes of curved solids and of what they sweep, whether the ends of a motion meet, and grids (C102, C103).

Boxes are derived by hand; the sweep by a translation of (a, 0, 0) is the box, longer by a. Ends are moved until the sets are
certainly apart, or have an inner point in common.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

from scenes import (Checks, Curved, Motion, ball, box, capsule, common, cone, cylinder, halfspace, minus, options,  # noqa: E402
                    polynomial, torus, union)
from exact import Fraction as F  # noqa: E402

QUARTER = [[0, -1, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0]]           # a quarter turn about z, then 5 along x
TILTED = [["3/5", "-4/5", 0, 0], ["4/5", "3/5", 0, 0], [0, 0, 1, 0]]


def affine(matrix, node):
    return {"affine": {"matrix": [[str(x) for x in row] for row in matrix], "of": node}}


def cut_cone(point, axis, slope, low, high):
    node = cone(point, axis, slope, high)
    node["cone"]["from"] = str(low)
    return node


def tube(point, axis, radius, low=None, high=None):
    node = cylinder(point, axis, radius)
    node["cylinder"].update({key: str(end) for key, end in (("from", low), ("to", high)) if end is not None})
    return node


def polygon(points, **more):
    return {"polygon": {"points": [[str(x) for x in p] for p in points], **more}}


RAISED = [[1, 0, 0, 0], [0, "3/5", "-4/5", 0], [0, "4/5", "3/5", 0]]    # (0, 0, 1) becomes (0, -4/5, 3/5)
SLAB = halfspace((0, 0, 1), 4), halfspace((0, 0, -1), 1)                # -1 <= z <= 4

# node, its box: low, high; None where there is none.
BOXES = [
    (ball((1, 2, 3), 2), (-1, 0, 1), (3, 4, 5)),
    (ball((1, 2), F(1, 2)), (F(1, 2), F(3, 2)), (F(3, 2), F(5, 2))),
    (box((0, 1, 2), (3, 4, 5)), (0, 1, 2), (3, 4, 5)),
    ({"ellipsoid": {"center": ["1", "0", "0"], "semiaxes": ["1", "2", "3"]}}, (0, -2, -3), (2, 2, 3)),
    (cylinder((0, 0, 0), (0, 0, 2), 3, -1, 2), (-3, -3, -2), (3, 3, 4)),
    (cylinder((0, 0, 0), (3, 4, 0), 5, 0, 1), (-4, -3, -5), (7, 7, 5)),    # the disk's half sides are 5 (4/5, 3/5, 1)
    (cone((0, 0, 0), (0, 0, 2), 1, 2), (-4, -4, 0), (4, 4, 4)),
    (cut_cone((0, 0, 0), (0, 0, -1), 2, 1, 3), (-6, -6, -3), (6, 6, -1)),
    (torus((0, 0, 1), (0, 0, 5), 2, 1), (-3, -3, 0), (3, 3, 2)),
    (torus((0, 0, 0), (3, 4, 0), 5, 1), (-5, -4, -6), (5, 4, 6)),
    (capsule((0, 0, 0), (4, 0, 0), 1), (-1, -1, -1), (5, 1, 1)),
    (capsule((0, 0), (3, 4), 1), (-1, -1), (4, 5)),
    (polygon([(0, 0), (4, 0), (0, 3)]), (0, 0), (4, 3)),
    (polygon([(0, 0), (-4, 0), (0, 3)], extrude=["-1", "2"]), (-4, 0, -1), (0, 3, 2)),
    (polygon([(1, 0), (-4, 0), (0, 3)], extrude=["-1", "2"], scale=["2", "2"]), (-8, 0, -1), (2, 6, 2)),
    (polygon([(1, -1), (4, -1), (4, 3), (1, 3)], extrude=["0", "2"], scale=["1/2", "0"]), (F(1, 2), -1, 0), (4, 3, 2)),
    (affine(QUARTER, ball((1, 0, 0), 1)), (4, 0, -1), (6, 2, 1)),
    (affine(TILTED, ball((5, 0, 0), 1)), (2, 3, -1), (4, 5, 1)),           # (3, 4, 0): a turned ball is no larger
    (affine(QUARTER, affine(TILTED, ball((5, 0, 0), 1))), (0, 2, -1), (2, 4, 1)),
    (affine(QUARTER, union(ball((1, 0, 0), 1), affine(TILTED, ball((5, 0, 0), 1)))), (0, 0, -1), (6, 4, 1)),
    (union(ball((0, 0), 1), ball((5, 1), 1)), (-1, -1), (6, 2)),
    (common(ball((0, 0), 1), ball((1, 0), 1)), (0, -1), (1, 1)),
    (common(ball((0, 0), 1), halfspace((1, 0))), (-1, -1), (0, 1)),
    (common(halfspace((1, 0)), ball((0, 0), 1)), (-1, -1), (0, 1)),
    (common(ball((0, 0), 1), halfspace((1, 0), -2)), (-1, -1), (1, 1)),    # empty, and in any box
    (common(ball((0, 0), 1), halfspace((1, 0), 2)), (-1, -1), (1, 1)),     # half-spaces never widen a box
    (common(ball((0, 0), 5), halfspace((3, 4), -20)), (-5, -5), (0, F(-5, 4))),   # 3 x <= -20 + 20, 4 y <= -20 + 15
    (common(ball((0, 0), 1), ball((5, 0), 1)), (-1, -1), (1, 1)),          # empty, and in any box
    (minus(ball((0, 0), 1), ball((5, 0), 9)), (-1, -1), (1, 1)),
    (minus(ball((0, 0), 1), halfspace((1, 0))), (-1, -1), (1, 1)),
    (halfspace((1, 0)), None, None),
    (union(ball((0, 0), 1), halfspace((1, 0))), None, None),
    (union(halfspace((1, 0)), ball((0, 0), 1)), None, None),
    (minus(halfspace((1, 0)), ball((0, 0), 1)), None, None),
    (cylinder((0, 0, 0), (0, 0, 1), 1), None, None),
    (cone((0, 0, 0), (0, 0, 1), 1), None, None),
    (polynomial({"2,0": 1, "0,2": 1, "0,0": -1}), None, None),
    # Ends that half-spaces make: of a cylinder, wherever they stand in an intersection.
    (common(halfspace((0, 0, 1), 20), tube((0, 0, 1), (0, 0, 2), 3, 0)), (-3, -3, 1), (3, 3, 20)),
    (common(tube((0, 0, 1), (0, 0, -2), 3, 0), halfspace((0, 0, -5), 20)), (-3, -3, -4), (3, 3, 1)),
    (common(tube((0, 0, 0), (0, 0, 1), 3, None, 2), halfspace((0, 0, -1), 1)), (-3, -3, -1), (3, 3, 2)),
    (common(tube((0, 0, 0), (0, 0, 1), 3), *SLAB), (-3, -3, -1), (3, 3, 4)),
    (common(*SLAB, halfspace((0, 0, 1), 3), common(union(tube((1, 0, 0), (0, 0, 1), 1), ball((0, 0, 0), 1)))),
     (-1, -1, -1), (2, 1, 3)),
    (minus(common(tube((0, 0, 0), (0, 0, 1), 3), *SLAB), tube((0, 0, 0), (0, 0, 1), 1)), (-3, -3, -1), (3, 3, 4)),
    # At height z the disk of radius 5 reaches down to 4 z - 15 along (0, 3, 4); so z <= 10, where the point (0, -5) is.
    (common(tube((0, 0, 0), (0, 0, 1), 5, 0), halfspace((0, 3, 4), 25)), (-5, -5, 0), (5, 5, 10)),
    (common(tube((0, 0, 0), (0, 0, 2), 5, 0), halfspace((0, 3, 4), 25)), (-5, -5, 0), (5, 5, 10)),
    # Disks of radius 5 about 0 and (0, -8, 6) with normal (0, -4, 3) reach 5, 3 and 4.
    (affine(RAISED, common(tube((0, 0, 0), (0, 0, 1), 5, 0), halfspace((0, 0, 1), 10))), (-5, -11, -4), (5, 3, 10)),
    (common(halfspace((0, -4, 3), 50), affine(RAISED, tube((0, 0, 0), (0, 0, 1), 5, 0))), (-5, -11, -4), (5, 3, 10)),
    # Ends of a cone. Along (0, 3, 4) its side of slope 1 rises by 4 - 3 each unit of z; then 3 y <= 3 - 4 z.
    (common(cone((0, 0, 0), (0, 0, 1), F(1, 2)), halfspace((0, 0, 1), 4)), (-2, -2, 0), (2, 2, 4)),
    (common(cone((0, 0, 0), (0, 0, 1), 1), halfspace((0, 3, 4), 3)), (-3, -3, 0), (3, 1, 3)),
    (common(cone((0, 0, 0), (0, 0, 2), 1), halfspace((0, 3, 4), 3)), (-3, -3, 0), (3, 1, 3)),
    (common(halfspace((0, 0, 1), 6), cone((0, 0, 0), (0, 0, 1), F(1, 2)), halfspace((0, 0, 1), 4), halfspace((0, 0, 1), 9)),
     (-2, -2, 0), (2, 2, 4)),
    (common(cut_cone((0, 0, 5), (0, 0, -1), 1, 0, 5), halfspace((0, 0, 1), 3)), (-5, -5, 0), (5, 5, 3)),
    (common(cone((0, 0, 0), (0, 0, 1), F(4, 3)), halfspace((0, 3, 4), 2)), None, None),        # parallel to a side
    (common(cone((0, 0, 0), (0, 0, 1), 1), halfspace((0, 0, -1), 2)), None, None),             # open above
    (common(tube((0, 0, 0), (0, 0, 1), 3, 0), halfspace((1, 0, 0), 2)), None, None),       # parallel to the axis
    (union(common(tube((0, 0, 0), (0, 0, 1), 3), *SLAB), tube((0, 0, 0), (0, 0, 1), 1)), None, None),
    (common(union(*SLAB), tube((0, 0, 0), (0, 0, 1), 3)), None, None),
    # Half-spaces alone.
    (common(halfspace((1, 1), 1), halfspace((-1, 0)), halfspace((0, -1))), (0, 0), (1, 1)),
    (common(halfspace((1, 0), 4), halfspace((-1, 0), -1), halfspace((0, 2), 6), halfspace((0, -1))), (1, 0), (4, 3)),
    (common(halfspace((1, 0), 4), halfspace((-1, 0), -1), halfspace((0, 2), 6)), None, None),
]
RING = torus((0, 0, 0), (0, 0, 1), 3, 1)
FAR = union(ball((0, 0), 1), ball((10, 0), 1))
# A name, a node, a translation along x, what is known of the ends.
MOVED = [
    ("the same place", ball((0, 0), 1), 0, "yes"),
    ("a little", ball((0, 0), 1), F(1, 1000), "yes"),
    ("nearly apart", ball((0, 0), 1), F(199, 100), "yes"),
    ("touching", ball((0, 0), 1), 2, "undecided"),
    ("apart by 2^-96", ball((0, 0), 1), 2 + F(1, 2 ** 96), "no"),
    ("a ring beside its hole", RING, 1, "yes"),
    ("a ring far out", RING, 9, "no"),
    ("one onto the other", FAR, 10, "yes"),
    ("one between", FAR, 5, "undecided"),                                  # apart, but their boxes are not
    ("both past", FAR, 13, "no"),
    # Beads of a hundredth: only half way between a middle and its image is a common inner point that is tried.
    ("half way", union(ball((0, 10), F(1, 100)), ball((10, -10), F(1, 100))), F(3, 200), "yes"),
    ("a lens", common(ball((0, 0), 1), ball((1, 0), 1)), F(3, 4), "yes"),
    ("past a lens", common(ball((0, 0), 1), ball((1, 0), 1)), F(5, 4), "no"),
    ("less a half", minus(ball((0, 0), 1), halfspace((1, 0))), F(1, 4), "yes"),
    ("less all", minus(ball((0, 0), 1), ball((0, 0), 2)), F(1, 4), "undecided"),
    ("unbounded", halfspace((1, 0)), 5, "undecided"),                      # no middle of a box to begin with
    ("unbounded, with a ball", union(halfspace((1, 0)), ball((9, 0), 1)), 1, "yes"),
    ("a slit", union(box((-4, -1), (-1, 1)), box((1, -1), (4, 1))), 1, "yes"),
]


def motion(d, x):
    return Motion(d, [(0, 1, {"translate": [f"{x}*t"] + ["0"] * (d - 1)})])


class Runs:
    def __init__(self, args, folder):
        self.program, self.folder, self.count = os.path.abspath(args.graze), folder, 0

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run(self, command, node, d, x, *more):
        solid = self.write("s.csg.json", Curved(d, node).text())
        move = self.write("m.json", motion(d, x).text())
        return subprocess.run([self.program, command, solid, move, *more], capture_output=True, text=True, timeout=120)


def shown_box(text, what):
    """The ends of a box of `check`, as fractions."""
    line = re.search(rf"^{what}[^:]*: (.*); size", text, re.M)
    if not line:
        return None
    sides = [[F(x) for x in side.split(" .. ")] for side in line.group(1).split(", ")]
    return [s[0] for s in sides], [s[1] for s in sides]


def check_boxes(checks, runs):
    for node, low, high in BOXES:
        d = 2 if node_is_plane(node, low) else 3
        done = runs.run("check", node, d, 4)
        checks.equal(done.returncode, 0, node, done.stderr)
        own, sweep = shown_box(done.stdout, "box of S"), shown_box(done.stdout, "box that holds")
        if low is None:
            checks.holds("box of S: none is proved" in done.stdout, str(node), done.stdout)
            refused = runs.run("classify", node, d, 4, "--grid", ",".join("2" * d))
            checks.equal((refused.returncode, refused.stderr.count("\n")), (3, 1), node, refused.stderr)
            checks.holds("no box of the curved solid is proved" in refused.stderr, refused.stderr)
            continue
        checks.equal(own, (list(low), list(high)), node)
        wide = F(max(h - l for l, h in zip(low, high)) + 4)
        checks.holds(sweep and all(l - wide / 1024 <= got <= l for got, l in zip(sweep[0], low)), node, str(sweep))
        right = [high[0] + 4, *high[1:]]
        checks.holds(sweep and all(h <= got <= h + wide / 1024 for got, h in zip(sweep[1], right)), node, str(sweep))


def node_is_plane(node, low):
    if low is not None:
        return len(low) == 2
    return not any(word in str(node) for word in ("cylinder", "cone"))


def check_cut_bodies(checks, runs, rng):
    """The end that a slanted half-space makes is irrational: z <= 1 + sqrt 2. Of an empty set any box will do. Many
    half-spaces, and numbers that grow too long, leave no box or a larger one."""
    column = tube((0, 0, 0), (0, 0, 1), 1, 0)
    done = runs.run("check", common(column, halfspace((1, 1, 1), 1)), 3, 4)
    low, high = shown_box(done.stdout, "box of S") or ([], [0] * 3)
    checks.holds(low == [-1, -1, 0] and 2 <= (high[2] - 1) ** 2 < 2 + F(1, 1000), "irrational", done.stdout)
    for node in (common(column, halfspace((0, 0, 1), -1)), common(cone((0, 0, 0), (0, 0, 1), 1), halfspace((0, 0, 1), -1)),
                 common(halfspace((0, 0, -1), -5), tube((0, 0, 0), (0, 0, 1), 1, None, 2))):
        done = runs.run("check", node, 3, 4)
        low, high = shown_box(done.stdout, "box of S") or ([0], [0])
        checks.holds(all(l < h for l, h in zip(low, high)), "empty", node, done.stdout, done.stderr)
    walls = [halfspace((0, 0, 1), 100 - k) for k in range(100)]           # z <= 1; the first 64 say z <= 37
    done = runs.run("check", common(column, *walls), 3, 4)
    checks.equal(shown_box(done.stdout, "box of S"), ([-1, -1, 0], [1, 1, 37]), "many", done.stderr)
    node = common(column, halfspace((0, 0, F(10 ** 40 + 1, 10 ** 41 + 3)), F(10 ** 40 + 7, 10 ** 41 + 9)))
    cuts = [halfspace((0, 0, F(rng.randrange(10 ** 100), 10 ** 100 + k)), 1) for k in range(64)]
    for count, known in ((20, True), (400, False)):                       # 64 numbers of 200 digits for each: work of seconds
        done = runs.run("check", common(*cuts, union(*[column] * count)), 3, 4)
        checks.equal((done.returncode, bool(shown_box(done.stdout, "box of S"))), (0, known), "work", count, done.stderr)
    for more, known in (("--limit", "digits=50"), False), ((), True):     # the end has 82 digits
        done = runs.run("check", node, 3, 4, *more)
        checks.equal((done.returncode, bool(shown_box(done.stdout, "box of S"))), (0, known), "long", more, done.stderr)


def check_beyond(checks, runs, rng):
    """Random bodies, cut by random half-spaces: no point beyond the box is in the solid at rest. Returns whether it has a box."""
    def vector():
        return next(v for v in iter(lambda: tuple(rng.randint(-3, 3) for _ in range(3)), None) if any(v))

    def body():
        point, axis = tuple(rng.randint(-2, 2) for _ in range(3)), vector()
        ends = rng.choice(((None, None), (0, None), (None, 1), (-1, 2)))
        return rng.choice((lambda: tube(point, axis, F(rng.randint(1, 6), 2), *ends), lambda: cone(point, axis, F(rng.randint(1, 4), 3)),
                           lambda: ball(point, rng.randint(1, 3)), lambda: halfspace(vector(), rng.randint(-2, 6))))()

    def cut():
        walls = [halfspace(vector(), rng.randint(1, 9)) for _ in range(rng.randint(2, 6))]
        parts = [*walls, union(*(body() for _ in range(rng.randint(1, 3)))), *([cut()] if rng.random() < 0.25 else [])]
        rng.shuffle(parts)
        return affine(rng.choice((QUARTER, RAISED)), common(*parts)) if rng.random() < 0.5 else common(*parts)

    node, points = cut(), []
    done = runs.run("check", node, 3, 1)
    checks.equal(done.returncode, 0, node, done.stderr)
    box = shown_box(done.stdout, "box of S")
    for _ in range(60 if box else 0):
        side, k = rng.choice(((0, -1), (1, 1))), rng.randrange(3)
        p = [a + (b - a) * F(rng.randint(-4, 20), 16) for a, b in zip(*box)]
        p[k] = box[side[0]][k] + side[1] * F(rng.choice((0, 0, 1, 40)), 64)
        points.append((p, any(not a <= x <= b for x, a, b in zip(p, *box))))
    path = runs.write("p.csv", "x,y,z\n" + "".join(",".join(map(str, p)) + "\n" for p, _ in points))
    done = subprocess.run([runs.program, "classify", runs.write("s.csg.json", Curved(3, node).text()), path, "--at-rest", "--quiet"],
                          capture_output=True, text=True, timeout=120)
    rows = [line.split(",")[3] for line in done.stdout.splitlines() if not line.startswith(("#", "x"))]
    checks.equal(len(rows), len(points), node, done.stderr)
    for (p, beyond), pmc in zip(points, rows):
        checks.holds(pmc != "in" and (pmc == "out" or not beyond), node, p, pmc)
    return box is not None


def check_ends(checks, runs):
    for name, node, x, known in MOVED:
        d = 3 if node is RING else 2
        points = runs.write("p.csv", ",".join("0" * d) + "\n")
        done = runs.run("classify", node, d, x, points)
        checks.equal(re.findall(r"^# ends-meet (.*)$", done.stdout, re.M), [known], name, done.stderr)
        done = runs.run("check", node, d, x, "--overlap", "reject")
        checks.equal((done.returncode, done.stderr.count("\n")), (0, 0) if known == "no" else (1, 1), name, done.stderr)


def check_grid(checks, runs):
    """A disk moved by 4 covers the points at most 1 from a segment; shards, jobs and formats agree."""
    grid = ("--grid", "17,9", "--box", "-2,-2,6,2")
    whole = runs.run("classify", ball((0, 0), 1), 2, 4, *grid, "--columns", "pmc")
    rows = [line.split(",") for line in whole.stdout.splitlines() if not line.startswith(("#", "x"))]
    checks.equal(len(rows), 17 * 9, whole.stderr)
    seen = set()
    for x, y, pmc in rows:
        x, y = F(x), F(y)
        square = (x - min(max(x, 0), 4)) ** 2 + y * y
        checks.equal(pmc, "in" if square < 1 else "on" if square == 1 else "out", "grid", x, y)
        seen.add(pmc)
    checks.equal(seen, {"in", "on", "out"}, "grid")
    checks.holds("\n# undecided 0\n" in whole.stdout, "grid", whole.stdout[-200:])
    jobs = runs.run("classify", ball((0, 0), 1), 2, 4, *grid, "--columns", "pmc", "--jobs", "3")
    checks.equal(jobs.stdout, whole.stdout, "jobs")
    full = runs.run("classify", ball((0, 0), 1), 2, 4, *grid)
    long = [line.split(",") for line in full.stdout.splitlines() if not line.startswith(("#", "x"))]
    checks.equal([row[:3] for row in long], rows, "all columns")
    parts = []
    for k in range(2):
        parts.append(os.path.join(runs.folder, f"part{k}.csv"))
        runs.run("classify", ball((0, 0), 1), 2, 4, *grid, "--shard", f"{k + 1}/2", "-o", parts[k])
    merged = subprocess.run([runs.program, "merge", *parts], capture_output=True, text=True, timeout=120)
    checks.equal(merged.stdout, full.stdout, "shards", merged.stderr)
    first = open(parts[0], encoding="utf-8").read().splitlines(True)
    half = runs.write("half.csv", "".join(first[:len(first) // 2]))
    runs.run("classify", ball((0, 0), 1), 2, 4, *grid, "--shard", "1/2", "--resume", half)
    checks.equal(open(half, encoding="utf-8").read(), "".join(first), "resumed")
    for form in ("vtk", "npy", "jsonl"):
        path = os.path.join(runs.folder, "out." + form)
        done = runs.run("classify", ball((0, 0), 1), 2, 4, *grid, "--format", form, "-o", path)
        checks.holds(done.returncode == 0 and os.path.getsize(path) > 17 * 9, form, done.stderr)


def turned(checks, runs):
    """A box turned by a quarter about a corner, in whose frame the ends are apart only by the box of the turned one."""
    solid = runs.write("s.csg.json", Curved(2, box((0, 0), (4, 1))).text())
    for shift, known in ((F(9, 2), "no"), (3, "yes")):             # [shift - 1, shift] x [0, 4] against [0, 4] x [0, 1]
        move = runs.write("m.json", Motion(2, [(0, 1, {"compose": [
            {"rotate": {"tan_half": "t"}}, {"translate": [f"{shift + 1}*t", "0"]}]})]).text())
        done = subprocess.run([runs.program, "check", solid, move], capture_output=True, text=True, timeout=120)
        said = "S^0 and S^1 do not meet" if known == "no" else "S^0 and S^1 meet\n"
        checks.holds(said in done.stdout, "turned", shift, done.stdout + done.stderr)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(args, folder)
        if args.derived:
            check_boxes(checks, runs)
            check_cut_bodies(checks, runs, args.random)
            check_ends(checks, runs)
            check_grid(checks, runs)
            turned(checks, runs)
        bounded = [check_beyond(checks, runs, args.random) for _ in args.rounds(40, "beyond")]
        checks.holds(not args.ample or sum(bounded) > 8, "random bodies with a box", sum(bounded))
    checks.finish()


if __name__ == "__main__":
    main()
