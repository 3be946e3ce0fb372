#!/usr/bin/env python3
# suite
"""Where tessellation lies: disks against inscribed and circumscribed polygons of 12, 48, 192 and 768 sides.

SPDX-License-Identifier: GPL-3.0-or-later

The corners of the inscribed polygon are rational points of the circle, the sides of the circumscribed one touch it there. None
of them lies where a designed point of the golden cases meets the disk, so each point that is `on` for the disk is `out` for
the one and `in` for the other, at any number of sides. Random points obey: inscribed ⊂ disk ⊂ circumscribed.
"""
import math
import os
import sys
from fractions import Fraction as F

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "lib"), os.path.join(HERE, "..", "cases")]

import casefile  # noqa: E402
from scenes import Checks, Graze, options  # noqa: E402

SIDES = (12, 48, 192, 768)
CASES = ("curved-parabola", "curved-scaled")
RANDOM = 225
ORDER = {"out": 0, "on": 1, "in": 2}


def corners(n):
    """Rational points of the unit circle, about evenly, none of them one at which a designed point meets it."""
    halves = [F(math.tan((k + F(1, 3)) * math.pi / n - math.pi / 2 + 1e-4)).limit_denominator(10 ** 6) for k in range(n)]
    return [((1 - h * h) / (1 + h * h), 2 * h / (1 + h * h)) for h in halves]


def about(points):
    """The corners of the polygon whose sides touch the circle in the points: (p + q) / (1 + p.q)."""
    out = []
    for p, q in zip(points, points[1:] + points[:1]):
        scale = 1 + p[0] * q[0] + p[1] * q[1]
        out.append(((p[0] + q[0]) / scale, (p[1] + q[1]) / scale))
    return out


def main():
    args = options(__doc__.splitlines()[0])
    checks, rng = Checks(), args.random
    graze = Graze(args, checks)
    for name in CASES:
        case = casefile.Case(name)
        motion = case.path("motion.json")
        designed = [tuple(map(F, p)) for _, p in case.points]
        some = [(F(rng.randint(-400, 400), 100), F(rng.randint(-300, 1000), 100)) for _ in range(RANDOM * args.scale)]
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
                    return checks.finish()
                words = sum(a["word"] != b["word"] for a, b in zip(exact[:len(designed)], got))
                changed[kind] = words, sum(a["pmc"] != b["pmc"] for a, b in zip(exact[len(designed):], got[len(designed):]))
                for p, a, b in zip(points, exact, got):
                    lower = ORDER[b["pmc"]] <= ORDER[a["pmc"]]
                    higher = ORDER[b["pmc"]] >= ORDER[a["pmc"]]
                    checks.holds(lower if kind == "inscribed" else higher, name, n, kind, p, a["word"], b["word"])
                for p, a, b in zip(designed, exact, got):
                    if a["pmc"] == "on":
                        checks.equal(b["pmc"], "out" if kind == "inscribed" else "in", name, n, kind, *p)
            print(f"{name}, {n} sides: of {len(designed)} designed points {changed['inscribed'][0]} words change (inscribed), "
                  f"{changed['circumscribed'][0]} (circumscribed); of {len(some)} random points {changed['inscribed'][1]} and "
                  f"{changed['circumscribed'][1]} change pmc")
    checks.finish()


if __name__ == "__main__":
    main()
