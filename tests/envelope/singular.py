#!/usr/bin/env python3
# suite
"""The `singular` events of `graze envelope` against the pullback, where facets have contacts of order 4 all the time.

SPDX-License-Identifier: GPL-3.0-or-later

At a rational time the first three derivatives of the pullback are affine functions on a facet's plane. Their common zeros,
solved for in fractions, are a point, a line or nothing, and are asked for in the facet's interior: at each rational event,
and between any two events of the facet at times spread there, where the answer may not change. The events are the same if the
motion is cut, among others at the events, and if the body's axes are exchanged.
"""
import itertools
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contact"))

import oracle  # noqa: E402
from exact import Fraction as F  # noqa: E402
from motion import build, compose, cut, quaternion, rotation, scaling, translate  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from reading import When, between, table  # noqa: E402
from solids import block, minus, prism, ring  # noqa: E402

RANDOM, SPREAD = 14, 7
HEXAGON = ring((0, 0), (2, F(-1, 3)), (4, F(-1, 2)), (6, F(-3, 7)), (7, 1), (3, 3))
NOTCHED = ring((0, 0), (6, 0), (6, 2), (3, 1), (2, 5), (0, 4))
SHRINK = scaling([[1, F(-1, 2)]] * 3, center=[F(1), F(0), F(0)])
WORLD_AXIS = translate([[0], [0, 1], [0]]), rotation([0, 1], axis=[1, 0, 0], length=1)


# ------------------------------------------------------------------------------------ a second method

def affine(values, corners):
    """f(0, 0), and how f rises along the two directions, of a function by its values at three corners."""
    return values[corners[0]], values[corners[1]] - values[corners[0]], values[corners[2]] - values[corners[0]]


def three_corners(points):
    """Numbers of three corners that are not in line."""
    n = len(points)
    for k in range(2, n):
        e, f = minus(points[1], points[0]), minus(points[k], points[0])
        if any(e[i] * f[j] != e[j] * f[i] for i, j in ((0, 1), (0, 2), (1, 2))):
            return 0, 1, k
    raise ValueError("no plane")


def strictly_inside(polygon, p):
    """Is a point of the plane in a simple polygon's interior?"""
    inside = False
    for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
        side = (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax)
        if side == 0 and min(ax, bx) <= p[0] <= max(ax, bx) and min(ay, by) <= p[1] <= max(ay, by):
            return False
        if (ay > p[1]) != (by > p[1]):
            inside ^= (side > 0) == (by > ay)
    return inside


def exists(solid, motion, side, facet, t):
    """Has the facet's interior a point whose first three derivatives are 0 at t?"""
    points = [solid.vertices[k] for k in solid.facets[facet]]
    piece = oracle.pieces_beside(motion, t)[0][1]
    found = [oracle.pullback(piece, side, motion.map(p, t), t, 3)[1:] for p in points]
    rows = []  # independent ones, (constant, along e, along f)
    corners = three_corners(points)
    for k in range(3):
        row = affine([f[k] for f in found], corners)
        for lead, other in rows:
            factor = row[lead] / other[lead]
            row = tuple(a - factor * b for a, b in zip(row, other))
        if row[1] or row[2]:
            rows.append((1 if row[1] else 2, row))
        elif row[0]:
            return False
    if not rows:
        return True
    if len(rows) == 1:  # a line meets an open connected set if the set is on both its sides
        k = next(k for k in range(3) if any(f[k] for f in found))
        return min(f[k] for f in found) < 0 < max(f[k] for f in found)
    (_, a), (_, b) = rows
    det = a[1] * b[2] - a[2] * b[1]
    s, r = (a[2] * b[0] - a[0] * b[2]) / det, (a[0] * b[1] - a[1] * b[0]) / det
    o, p, q = (points[k] for k in corners)
    at = tuple(x + s * (y - x) + r * (z - x) for x, y, z in zip(o, p, q))
    dropped = next(i for i in range(3) if side.normal[i])
    flat = [tuple(x[i] for i in range(3) if i != dropped) for x in points + [at]]
    return strictly_inside(flat[:-1], flat[-1])


# --------------------------------------------------------------------------------------------- checks

def events(checks, graze, solid, motion, name):
    """{facet: texts of times}, or None."""
    files = [graze.write(name + end, text) for end, text in
             ((".off", solid.text()), (".json", motion.text()), ("-events.csv", ""))]
    done = graze.call("envelope", *files[:2], "--events", files[2])
    if not checks.equal(done.returncode, 0, name, done.stderr):
        return None
    out = {k: [] for k in range(len(solid.facets))}
    for row in table(files[2]):
        if row["kind"] == "singular":
            out[int(row["facet"].split()[1])].append(row["time"])
    return out


def spread(a, b, count):
    """Rationals between two times, some near each of them."""
    middle = between(a, b)
    out = [middle]
    for k in range(count // 2):
        out = [between(a, When(str(out[0])))] + out + [between(When(str(out[-1])), b)]
    return out


def check_facet(checks, tally, solid, motion, side, facet, times, name):
    marks = [When(str(motion.start))] + [When(t) for t in times if F(motion.start) < When(t).low or When(t).poly]
    marks = [m for k, m in enumerate(marks) if k == 0 or m.text != str(motion.end)] + [When(str(motion.end))]
    answers = []
    for a, b in zip(marks, marks[1:]):
        here = {t: exists(solid, motion, side, facet, t) for t in spread(a, b, SPREAD)}
        checks.holds(len(set(here.values())) == 1, name, "facet", facet, "between", a.text, b.text, here)
        answers.append(here[min(here)])
        tally["gaps with a point" if answers[-1] else "gaps without"] += 1
    for k, mark in enumerate(marks):
        beside = {answers[j] for j in (k - 1, k) if 0 <= j < len(answers)}
        if mark.poly is None:
            here = exists(solid, motion, side, facet, mark.low)
            checks.equal((mark.text in times), beside != {here}, name, "facet", facet, "at", mark.text)
        elif len(beside) == 2:
            tally["irrational"] += 1
        tally["events"] += mark.text in times


def check_scene(checks, tally, graze, rng, solid, motion, name):
    base = events(checks, graze, solid, motion, name)
    if base is None:
        return
    for facet, side in enumerate(oracle.sides_of(solid)):
        vertex = [solid.vertices[k] for k in solid.facets[facet]]
        moving = any(oracle.pullback(motion.pieces[0], side, motion.map(p, t), t, 1)[1]
                     for p in vertex for t in (F(1, 7), F(2, 5), F(3, 7), F(11, 13)))
        if moving:
            check_facet(checks, tally, solid, motion, side, facet, base[facet], name)
        else:
            checks.equal(base[facet], [], name, "slides", facet)
    at = {F(t) for times in base.values() for t in times if not t.startswith("root")} | {F(rng.randint(1, 63), 64)}
    at -= {motion.start, motion.end}
    checks.equal(events(checks, graze, solid, cut(motion, sorted(at)), name + "-cut"), base, name, "cut")
    # The body is (y_z, y_x, y_y), and the motion takes it back first.
    turned = solid.mapped(lambda p: (p[2], p[0], p[1]))
    other = type(motion)([type(p)(p.lo, p.hi, [[row[j] for j in (2, 0, 1)] for row in p.a], p.b, p.w)
                          for p in motion.pieces])
    checks.equal(other.map(turned.vertices[1], F(1, 3)), motion.map(solid.vertices[1], F(1, 3)), name, "the axes")
    checks.equal(events(checks, graze, turned, other, name + "-axes"), base, name, "axes")


def random_scene(rng):
    """A prism or block that shrinks and turns by a quaternion linear in t, or about a line that it carries."""
    half = lambda: F(rng.choice([0, 0, 1, -1, 2]), 2)  # noqa: E731
    solid = rng.choice([block(0, 0, 0, *[rng.randint(3, 8) for _ in range(3)]), prism(HEXAGON, F(0), F(rng.randint(2, 4))),
                        prism(NOTCHED, F(0), F(rng.randint(2, 4)))])
    shrink = scaling([[1, F(-1, rng.randint(2, 3))]] * 3, center=[F(rng.randint(0, 3)), F(0), F(0)])
    spin = quaternion([[1], [0, half()], [0, half()], [0, half() or 1]], center=[F(rng.randint(0, 2)) for _ in range(3)])
    carried = (translate([[0], [0, F(rng.choice([-3, -2, 1, 2]), 2)], [0]]),
               rotation([0, 1], axis=[1, 0, 0], length=1, center=[F(0), F(0), F(rng.choice([0, 2]))]))
    return solid, rng.choice([(shrink, spin), (shrink, spin), carried, carried + (shrink,)])


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    graze = Graze(args, checks)
    derived = [(prism(HEXAGON, F(0), F(1)), WORLD_AXIS),
               (block(0, 0, 0, 4, 5, 2), (SHRINK, quaternion([[1], [0], [0, 1], [0, F(-1, 2)]], center=[F(1), F(1), F(1)])))]
    drawn = (random_scene(args.random) for _ in args.rounds(RANDOM))
    for number, (solid, transforms) in enumerate(itertools.chain(derived if args.derived else (), drawn)):
        motion = build([(0, 1, compose(*transforms))])
        check_scene(checks, tally, graze, args.random, solid, motion, f"s{number}")
    for key, number in sorted(tally.items()):
        print(key, number)
    for kind in ("gaps with a point", "gaps without", "events"):
        checks.holds(tally[kind], "there are some", kind)
    checks.finish()


if __name__ == "__main__":
    main()
