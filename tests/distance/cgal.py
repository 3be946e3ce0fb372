#!/usr/bin/env python3
# suite
"""Enclosures of the distance against CGAL: exact Minkowski sums of straight legs, and sampled positions.

SPDX-License-Identifier: GPL-3.0-or-later

Minkowski sum: where a point is out, the exact square of its distance to the closed sweep must lie between the squares
of sdf_low and sdf_high; where it is in, -s is at most its distance to the sweep's boundary. Sampled positions: the
least signed distance at 10,000 times is no lower than sdf_low, and above sdf_high by no more than the trajectory moves
in half a step (C66: the distance in a rigid position is 1-Lipschitz in the inverted trajectory).
"""
import csv
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
for folder in ("lib", os.path.join("agree", "lib"), "agree"):
    sys.path.insert(0, os.path.join(HERE, "..", folder))

from exact import Fraction as F, to_double  # noqa: E402
from minkowski import scenes  # noqa: E402
from motion import legs  # noqa: E402
from oracle import Oracle  # noqa: E402
from points import mixed  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from shells import shells_text  # noqa: E402
from solids import block, polygons, prism  # noqa: E402

TOLERANCE = "1e-9"
POINTS = 30            # a scene; 2,000 in all at --scale 8
TIMES = 10000
SAMPLED = 12           # points a scene against sampled positions
ROUNDING = 1e-11       # of CGAL's doubles, for coordinates below 100


def enclosures(checks, graze, name, solid, motion, points):
    """Rows of --sdf."""
    paths = graze.write("solid" + solid.suffix, solid.text()), graze.write("motion.json", motion.text())
    rows = graze.write("points.csv", "".join(",".join(map(str, p)) + "\n" for p in points))
    out = graze.call("classify", *paths, rows, "--quiet", "--sdf", TOLERANCE)
    checks.equal((out.returncode, out.stderr), (0, ""), name)
    found = list(csv.DictReader(line for line in out.stdout.splitlines() if not line.startswith("#")))
    checks.equal(len(found), len(points), name, "rows")
    return [(r["pmc"], F(r["sdf_low"]), F(r["sdf_high"])) for r in found]


def ask(oracle, solid, *words):
    """Lines; those of sampled positions are doubles, whose last bits hang on the machine."""
    answer = oracle.ask("\n".join((shells_text(solid), *words)) + "\n", 900, one_form=words[0] == "sum")
    return answer.text.splitlines() if answer else []


def rows_of(numbers):
    return "\n".join(" ".join(map(str, row)) for row in numbers)


def around(rng, points, count):
    """Points of the box of others, half as wide again, in 64ths."""
    ends = [(min(p[k] for p in points), max(p[k] for p in points)) for k in range(3)]
    return [tuple(F(round(64 * (a - (b - a) / 4)) + rng.randint(0, round(96 * (b - a))), 64) for a, b in ends)
            for _ in range(count)]


def check_sum(checks, where, found, place, square):
    pmc, low, high = found
    if pmc == "out":
        checks.equal(place, "exterior", *where)
        checks.holds(low * low <= square <= high * high, *where, f"[{to_double(low)}, {to_double(high)}]", to_double(square) ** .5)
    elif pmc == "in":
        checks.equal(place, "interior", *where)
        checks.holds(high * high <= square, *where, f"{to_double(-high)} deep", to_double(square) ** .5)
    else:
        checks.holds(place != "exterior" and low == high == 0, *where, place)


def straight(checks, graze, oracle, args):
    asked = 0
    for _, (name, solid, path) in args.cycle(scenes(), 1, "straight"):
        motion = legs(path)
        points = [p for _, p in mixed(solid, motion, args.random, POINTS // 3)]
        points += around(args.random, points, POINTS - len(points))
        found = enclosures(checks, graze, name, solid, motion, points)
        pairs = list(zip(path, path[1:]))
        answers = ask(oracle, solid, "sum", str(len(pairs)), rows_of([*p, *q] for p, q in pairs), str(len(points)), rows_of(points))
        checks.equal(len(answers), len(points), name, "answers")
        for p, row, answer in zip(points, found, answers):
            place, square = answer.split()
            check_sum(checks, (name, ",".join(map(str, p))), row, place, F(square))
        asked += len(points)
    print(f"{asked} points against Minkowski sums")


class Turn:
    """A rotation by 2 atan(t) about z, then a translation by t v."""

    def __init__(self, shift):
        self.shift = shift

    def text(self):
        return ('{"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"compose": [{"rotate": {"tan_half": "t", '
                '"axis": [0, 0, 1]}}, {"translate": ["%s*t", "%s*t", "%s*t"]}]}}]}' % self.shift)

    def back(self, t):
        """M(t)^-1 as 12 numbers."""
        c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        rows = ((c, s, 0), (-s, c, 0), (0, 0, 1))
        return [x for row in rows for x in (*row, -t * sum(a * to_double(b) for a, b in zip(row, self.shift)))]

    def at(self, t, y):
        """M(t) y."""
        c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        turned = (c * y[0] - s * y[1], s * y[0] + c * y[1], y[2])
        return tuple(a + t * b for a, b in zip(turned, self.shift))

    def speed(self, p):
        """|c'| is at most this: the angle's speed is at most 2, c = R^-1(P - tv)."""
        v = math.hypot(*map(to_double, self.shift))
        return 2 * (math.hypot(*map(to_double, p)) + v) + v


def sampled(checks, graze, oracle, args):
    ell = prism(polygons()["ell"].parts[0][0], 0, 2)
    turns = ("ell turned", ell, Turn((3, 1, 2))), ("block turned", block(1, -1, 0, 3, 1, 2), Turn((0, 0, 4)))
    for _, (name, solid, turn) in args.cycle(turns, 1, "sampled"):
        near = around(args.random, solid.vertices, SAMPLED)
        points = [turn.at(F(args.random.randint(0, 8), 8), y) for y in near]
        found = enclosures(checks, graze, name, solid, turn, points)
        poses = rows_of(turn.back(k / (TIMES - 1)) for k in range(TIMES))
        answers = ask(oracle, solid, "poses", str(TIMES), poses, str(len(points)), rows_of(map(to_double, p) for p in points))
        checks.equal(len(answers), len(points), name, "answers")
        for p, (pmc, low, high), answer in zip(points, found, map(to_double, answers)):
            where = (name, ",".join(map(str, p)), pmc)
            checks.holds(answer >= to_double(low) - ROUNDING, *where, f"sampled {answer} below {to_double(low)}")
            checks.holds(answer <= to_double(high) + turn.speed(p) / (TIMES - 1) / 2 + ROUNDING, *where, f"{answer} far above {to_double(high)}")
        checks.holds(len({pmc for pmc, _, _ in found}) > 1, name, "answers of more than one kind")


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    oracle = Oracle(args, checks, "distances")
    straight(checks, graze, oracle, args)
    sampled(checks, graze, oracle, args)
    oracle.finish()
    checks.finish()


if __name__ == "__main__":
    main()
