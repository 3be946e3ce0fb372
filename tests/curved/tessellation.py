#!/usr/bin/env python3
# suite
"""Where tessellation lies: disks against inscribed and circumscribed polygons of 12, 48, 192 and 768 sides; a ball.

SPDX-License-Identifier: GPL-3.0-or-later

The corners of the inscribed polygon are rational points of the circle, the sides of the circumscribed one touch it there. None
of them lies where a designed point of the golden cases meets the disk, so each point that is `on` for the disk is `out` for
the one and `in` for the other, at any number of sides. Random points obey: inscribed ⊂ disk ⊂ circumscribed.

In space a ball that turns along a curve lies likewise between polyhedra of `graze solid`: all corners of the inner one are in the ball, and
no facet's plane of the outer one is nearer than the radius; both are tested here. --space: this alone, 100,000 points at a scale of 250.
"""
import csv
import itertools
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "lib"), os.path.join(HERE, "..", "cases"), os.path.join(HERE, "..", "lib")]

import casefile  # noqa: E402
from exact import Fraction as F, simple  # noqa: E402
from scenes import Checks, Graze, options  # noqa: E402

SIDES = (12, 48, 192, 768)
CASES = ("curved-parabola", "curved-scaled")
RANDOM = 225
SPACE, AROUND = 400, 2000   # points in space, and the most of one table
ORDER = {"out": 0, "on": 1, "in": 2}


def corners(n):
    """Rational points of the unit circle, about evenly, none of them one at which a designed point meets it."""
    halves = [simple(F(math.tan((k + 1 / 3) * math.pi / n - math.pi / 2 + 1e-4)), 10 ** 6) for k in range(n)]
    return [((1 - h * h) / (1 + h * h), 2 * h / (1 + h * h)) for h in halves]


def about(points):
    """The corners of the polygon whose sides touch the circle in the points: (p + q) / (1 + p.q)."""
    out = []
    for p, q in zip(points, points[1:] + points[:1]):
        scale = 1 + p[0] * q[0] + p[1] * q[1]
        out.append(((p[0] + q[0]) / scale, (p[1] + q[1]) / scale))
    return out


def check_readme(checks, n, designed, words):
    """The line of README's first screen."""
    with open(os.path.join(HERE, "..", "..", "README.md"), encoding="utf-8") as file:
        said = " ".join(file.read().split())
    checks.holds("an inscribed polygon in place of a [moving disk](cases/curved-parabola/README.md) changes the answer for "
                 f"{words} of {designed} points, with {SIDES[0]} sides and with {SIDES[-1]}." in said, "README.md", n, designed, words)


def check_disks(graze, checks, args):
    rng = args.random
    for name in CASES:
        case = casefile.Case(name)
        motion = case.path("motion.json")
        designed = [tuple(map(F, p)) for _, p in case.points] if args.derived else []
        some = [(F(rng.randint(-400, 400), 100), F(rng.randint(-300, 1000), 100)) for _ in args.rounds(RANDOM, name)]
        points = designed + some
        exact = [a.record for a in graze.classify(name, case.path(case.solid), motion, points) or []]
        for n in SIDES:
            inner = corners(n)
            rings = {"inscribed": inner, "circumscribed": about(inner)}
            changed = {}
            for kind, ring in rings.items():
                path = graze.write(f"{kind}.wkt", "POLYGON((" + ", ".join(f"{x} {y}" for x, y in ring + ring[:1]) + "))\n")
                got = [a.record for a in graze.classify(f"{name} {n} {kind}", path, motion, points) or []]
                if not checks.equal(len(got), len(points), name, n, kind):
                    return
                words = sum(a["word"] != b["word"] for a, b in zip(exact[:len(designed)], got))
                changed[kind] = words, sum(a["pmc"] != b["pmc"] for a, b in zip(exact[len(designed):], got[len(designed):]))
                for p, a, b in zip(points, exact, got):
                    lower = ORDER[b["pmc"]] <= ORDER[a["pmc"]]
                    higher = ORDER[b["pmc"]] >= ORDER[a["pmc"]]
                    checks.holds(lower if kind == "inscribed" else higher, name, n, kind, p, a["word"], b["word"])
                for p, a, b in zip(designed, exact, got):
                    if a["pmc"] == "on":
                        checks.equal(b["pmc"], "out" if kind == "inscribed" else "in", name, n, kind, *p)
            if name == "curved-parabola" and args.derived:
                check_readme(checks, n, len(designed), changed["inscribed"][0])
            print(f"{name}, {n} sides: of {len(designed)} designed points {changed['inscribed'][0]} words change (inscribed), "
                  f"{changed['circumscribed'][0]} (circumscribed); of {len(some)} random points {changed['inscribed'][1]} and "
                  f"{changed['circumscribed'][1]} change pmc")


def read_off(path):
    """Corners and facets of a file of `graze solid`."""
    with open(path, encoding="ascii") as file:
        rows = [line.split() for line in file if not line.startswith("#")][1:]
    count = int(rows[0][0])
    return [tuple(map(F, row)) for row in rows[1:count + 1]], [[int(k) for k in row[1:]] for row in rows[count + 1:] if row]


def less(p, q):
    return [a - b for a, b in zip(p, q)]


def dot(p, q):
    return sum(a * b for a, b in zip(p, q))


def plane_of(a, b, c):
    """(n, h) of n.x = h through three points."""
    (x, y, z), (u, v, w) = less(b, a), less(c, a)
    n = (y * w - z * v, z * u - x * w, x * v - y * u)
    return n, dot(n, a)


def polyhedra(graze, checks, radius):
    """Paths of a polyhedron in the ball about 0 and of one around it."""
    paths = [os.path.join(graze.folder.name, name) for name in ("inscribed.off", "circumscribed.off")]
    graze.call("solid", "ball", "--diameter", str(2 * radius), "--at", f"0,0,{-radius}", "--tolerance", "1/20", "--inside", paths[0],
               "--outside", paths[1])
    checks.holds(all(dot(p, p) <= radius ** 2 for p in read_off(paths[0])[0]), "the inscribed one is in the ball")
    corner, facets = read_off(paths[1])
    planes = [plane_of(*(corner[k] for k in facet[:3])) for facet in facets]
    checks.holds(all(h > 0 and h * h >= radius ** 2 * dot(n, n) for n, h in planes), "the circumscribed one is around it")
    return paths


def some_place(rng, radius):
    """At the radius from a place of the ball's middle, up to three hundredths nearer or further, or exactly so."""
    t = F(rng.randint(-200, 200), 100)
    u = [F(rng.randint(-50, 50), 20) for _ in range(2)]
    scale = radius / (1 + dot(u, u)) * (1 + F(rng.randint(-1, 1) * rng.randint(0, 30), 1000))
    across = [2 * u[0] * scale, 2 * u[1] * scale, (1 - dot(u, u)) * scale]
    return tuple(a + b for a, b in zip((3 * t, 3 * t ** 2, 2 * t ** 3), rng.sample(across, 3)))


def check_ball(graze, checks, args):
    """The ball of [EI] Figure 11 along its space curve, turning."""
    case, radius, between, total = casefile.Case("curved-space-curve"), 2, 0, 0
    solids = polyhedra(graze, checks, radius)
    places = (some_place(args.random, radius) for _ in args.rounds(SPACE, "space"))
    while points := list(itertools.islice(places, AROUND)):
        total += len(points)
        rows = graze.write("points.csv", "".join(",".join(map(str, p)) + "\n" for p in points))
        answers = []
        for solid in (solids[0], case.path(case.solid), solids[1]):
            out = graze.call("classify", solid, case.path("motion.json"), rows).stdout
            answers.append([row["pmc"] for row in csv.DictReader(line for line in out.splitlines() if not line.startswith("#"))])
        if not checks.equal([len(a) for a in answers], [len(points)] * 3, "rows"):
            return
        for p, *pmc in zip(points, *answers):
            low, exact, high = (ORDER[word] for word in pmc)
            checks.holds(low <= exact <= high, "a ball in space", p, pmc)
            between += low < high
    checks.holds(20 * between > total, "points that the polyhedra answer differently", between, total)
    print(f"in space: {between} of {total} points are in another set for one polyhedron than for the other")


def main():
    args = options(__doc__.splitlines()[0], ("--space", {"action": "store_true", "help": "the ball in space alone"}))
    checks = Checks()
    graze = Graze(args, checks)
    if not args.space:
        check_disks(graze, checks, args)
    check_ball(graze, checks, args)
    checks.finish()


if __name__ == "__main__":
    main()
