#!/usr/bin/env python3
# suite
"""Curved solids have the same bytes with the filter and without it: tables and JSON Lines (C104 to C107).

SPDX-License-Identifier: GPL-3.0-or-later

Scenes are the golden ones of curved solids, those of tests/curved/words.py, and some made to be hard for doubles: points a
power of two beside tangencies and rims, surfaces far from the origin, coordinates and degrees beyond the filter, weights with
negative coefficients, many pieces, many balls. The exact path is the second method; that it is right is what tests/curved is for.
"""
import os
import random
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", *part.split("/")) for part in ("curved", "curved/lib", "cases", "generate", "agree/lib", "lib")]

import casefile  # noqa: E402
import words  # noqa: E402
from exact import Fraction as F  # noqa: E402
from queries import written  # noqa: E402
from scenes import Checks, Curved, Graze, Motion, along, ball, box, common, cone, cylinder, halfspace, minus, options  # noqa: E402
from scenes import polynomial, torus, union  # noqa: E402
from sides import Sides, ways  # noqa: E402

POINTS = 160
MILL = union(ball((0, 0, 1), 1), cylinder((0, 0, 1), (0, 0, 1), 1, 0, 3), cone((0, 0, 4), (0, 0, -1), F(1, 2), 2),
             cylinder((0, 0, 5), (0, 0, 1), F(3, 2), 0, 3), torus((0, 0, 8), (0, 0, 1), 2, F(1, 2)))
FLAT = minus(polynomial({"0,0,1": 1, "4,0,0": 1, "0,4,0": 1, "2,2,0": -1}), halfspace((0, 0, 1)))
TURN = {"compose": [{"rotate": {"axis": ["2/7", "3/7", "6/7"], "center": ["1/2", "0", "0"], "tan_half": "t"}},
                    {"translate": ["0.7*t", "t^2/2", "t/4"]}]}


def lattice(count):
    """Balls and ellipsoids far from each other and from the origin."""
    rng = random.Random(count)
    return union(*(ball([F(rng.randint(-40, 40), 4) for _ in range(3)], F(rng.randint(1, 8), 8)) if k % 3 else
                   {"ellipsoid": {"center": [str(rng.randint(-9, 9)) for _ in range(3)], "semiaxes": ["1", "1/2", "1/3"]}}
                   for k in range(count)))


def moved(x, y):
    return {"affine": {"matrix": [["1", "0", "0", str(x)], ["0", "1", "0", str(y)], ["0", "0", "1", "0"]], "of": MILL}}


def jointed(pieces):
    """Pieces that go on where the one before ends: along x, then y, then x again."""
    path, at = [], [F(0), F(0), F(0)]
    for k in range(pieces):
        axis, step = k % 3, F((-1) ** (k // 3) * (k % 4 + 1), 2)
        path.append((k, k + 1, {"translate": [f"{at[i]}+{step if i == axis else 0}*(t-{k})" for i in range(3)]}))
        at[axis] += step
    return Motion(3, path)


# name, solid, motion, the point around which others are
HARD = [
    ("mill turns", MILL, Motion(3, [(0, 1, TURN)]), (1, 1, 4)),
    ("mill, tangent", MILL, Motion(3, [(0, 1, {"translate": ["3*t", "0", "0"]})]), (F(3, 2), 1, 2)),
    ("mill, tip", MILL, Motion(3, [(-1, 1, {"translate": ["t", "0", "-t^2"]})]), (0, 0, 0)),
    ("mill, many legs", MILL, jointed(24), (0, 1, 4)),
    ("far away", moved(2 ** 20, -2 ** 20), Motion(3, [(0, 1, {"translate": ["3*t", "0", "0"]})]),
     (2 ** 20 + F(3, 2), 1 - 2 ** 20, 2)),
    ("too far", moved(2 ** 64, 0), Motion(3, [(0, 1, {"translate": ["3*t", "0", "0"]})]),
     (2 ** 64 + F(3, 2), 1, 2)),
    ("too steep", torus((0, 0, 0), (0, 0, 1), 2, 1), Motion(3, [(0, 1, {"translate": ["t^16", "3*t", "0"]})]), (3, 1, 0)),
    ("weights", union(ball((1, 0), F(1, 4)), box((-2, -2), (-1, 2))), Motion(2, [(0, 1, {"rotate": {"tan_half": "4*t-2"}})]), (1, 0)),
    ("balls", lattice(60), Motion(3, [(0, 1, TURN)]), (1, 1, 4)),
    ("balls, many legs", lattice(30), jointed(40), (0, 1, 0)),
    ("undecided", FLAT, along(-1, 1, "t", "0", "t^2"), (0, 0, 0)),
    ("sheared", {"affine": {"matrix": [["1", "1/3", "0", "0"], ["0", "2", "0", "0"], ["0", "0", "-1", "0"]], "of": common(MILL, ball((0, 0, 3), 3))}},
     Motion(3, [(0, 1, {"translate": ["3*t", "t/3", "0"]})]), (1, 1, -2)),
]


def around(rng, centre, count):
    """Points near a centre: on a lattice, displaced by a power of two, in doubles."""
    for k in range(count):
        if k % 4 == 0:
            yield tuple(c + F(rng.randint(-16, 16), 8) for c in centre)
        elif k % 4 == 1:
            yield tuple(c + rng.choice((-1, 0, 0, 1)) * F(1, 2 ** rng.randint(3, 96)) for c in centre)
        else:
            yield tuple(c + F(rng.uniform(-3, 3)) for c in centre)


def scene(sides, name, solid, motion, points, records=True):
    graze, count = sides.graze, len(points)
    tag = name.replace(" ", "_").replace("/", "_").replace(",", "")
    paths = [graze.write(tag + suffix, text) for suffix, text in
             ((".csg.json", solid.text()), (".json", motion.text()), (".csv", written(motion.dimension, [("", p) for p in points])))]
    sides.table(name, *paths, [], count)
    if records:
        sides.records(name, *paths, ["case"] * count, [])


def main():
    args = options(__doc__.splitlines()[0])
    checks, rng = Checks(), args.random
    sides = Sides(Graze(args, checks), checks, *ways(args.graze))
    for name in args.once(filter(casefile.is_curved, casefile.all_names()), "cases"):
        case = casefile.Case(name)
        files = case.path(case.solid), case.path("motion.json"), case.path("points.csv")
        sides.table(name, *files, case.options, len(case.points))
        sides.records(name, *files, ["case"] * len(case.points), case.options)
    for k, (name, node, motion, *_) in args.cycle(words.SCENES, 1, "words"):
        d = motion.dimension
        points = [(F(0),) * d, *around(rng, (0,) * d, 8)]
        scene(sides, f"words {name}", Curved(d, node), motion, points, k % 4 == 0)
    for _, (name, node, motion, centre) in args.cycle(HARD, 1, "hard"):
        points = [centre, *around(rng, centre, POINTS)]
        scene(sides, name, Curved(motion.dimension, node), motion, points)
    print(f"{sides.rows} points both ways")
    checks.finish()


if __name__ == "__main__":
    main()
