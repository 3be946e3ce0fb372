#!/usr/bin/env python3
# suite
"""Witnesses of the boundary of the closed sweep, and interiors, by exact classification down to 2^-400 of a distance.

SPDX-License-Identifier: GPL-3.0-or-later

By first order a witness is the point + epsilon * direction, by leading terms on a path of a higher order: from epsilon
down all are `out`, also next to a part that passes 2^-100 away, which epsilon must stay below. By a section and by curves
it lies on a square whose half side is rho. Near a point that is
interior nothing is `out` below some distance. Truths are those of verdicts.py, and derived here.
"""
import csv
import glob
import os
import sys
from collections import Counter

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "agree", "lib"))
sys.path.insert(0, os.path.join(HERE, "..", "lib"))

from exact import Fraction as F  # noqa: E402
from motion import legs  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from solids import Polygon, block, box_ring, joined, ring  # noqa: E402
from verdicts import EXAMPLES, POSITIONS, TINY, examples, neighbours  # noqa: E402
from witnesses import HALVINGS as SCALES, check_witness  # noqa: E402

COMPASS = [(1, 0), (0, 1), (1, 1), (1, -1), (2, 1), (1, 3), (-3, 2), (-1, 5)]


def around(point):
    """Directions about a point, and the opposite ones."""
    some = COMPASS if len(point) == 2 else [(*u, z) for u in COMPASS for z in (0, 1, -2)] + [(0, 0, 1)]
    return [u for v in some for u in (v, tuple(-x for x in v))]


def passing():
    """A box rests on the point's left and leaves to the left; another one passes `gap` away from the point on its other
    side, above or to the right: (name, solid, motion, point, gap, axis along which it lies)."""
    for gap in (F(1, 8), F(1, 2 ** 20), TINY, F(1, 2 ** 300)):
        second = box_ring(gap, -1, gap + 1, 1)
        yield f"plane {gap}", Polygon([[box_ring(-2, -1, 0, 1)], [second]]), legs([(0, 0), (0, 1), (0, 0)]), (F(0), F(0)), gap, 0
        solid = joined(block(-2, -1, -1, 0, 1, 1), block(gap, -3, -3, gap + 1, 3, 3))
        yield f"space {gap}", solid, legs([(0, 0, 0), (0, 1, F(1, 3))]), (F(0),) * 3, gap, 0


def leaving():
    """A square's upper right corner is on the point at one end of the motion, and comes or goes by (3, -4) below it:
    what is above is open. There, at that end, is a triangle's lower side, y = 5/2 + 4 (1 - x): 3/2 above the point. It
    meets the ray upward at 3/2 + 12 u - 4 u, higher and higher, until its left end, x = 1/2, has it at 17/6. So epsilon,
    halved from a power of 2, is 1 because of that end of the motion alone; the place at 2 is in."""
    solid = Polygon([[box_ring(0, 0, 1, 1)], [ring((3, F(-11, 2)), (3, F(9, 2)), (F(1, 2), F(9, 2)))]])
    yield "from the start", solid, legs([(0, 0), (3, -4)])
    yield "to the end", solid, legs([(3, -4), (0, 0)])


def check(checks, graze, name, files, point, want):
    answers = graze.classify(name, *files, [point], "--topo")
    if not answers or answers[0].record["topo"] == "undecided":
        return None
    record = answers[0].record
    checks.equal(record["topo"], want, name)
    keys = {key for key in record if key.startswith("topo_")} - {"topo_level"}
    if want == "interior":
        checks.equal(keys, set(), name, "no witness")
        ways = [(k, tuple(p + F(x, 2 ** k) for p, x in zip(point, u))) for k in SCALES[::4] for u in around(point)]
        found = graze.classify(name + " near", *files, [p for _, p in ways]) or []
        scales = {k for (k, _), answer in zip(ways, found) if answer.record["pmc"] == "out"}
        least = max(scales, default=-1) + 1
        checks.holds(least <= 200, name, "the scales at which a point is out", sorted(scales))
        return None
    return check_witness(checks, graze, name, files, point, record)


def golden(checks, graze):
    """The cases with positions: each row that is `on` and `boundary` of a sweep."""
    seen = Counter()
    for folder in sorted(glob.glob(os.path.join(HERE, "..", "..", "cases", "*", "expected.csv"))):
        name, folder = os.path.basename(os.path.dirname(folder)), os.path.dirname(folder)
        with open(os.path.join(folder, "expected.csv"), encoding="utf-8") as f:
            rows = [row for row in csv.DictReader(f) if row.get("topo") == "boundary" and row["pmc"] == "on"]
        files = [glob.glob(os.path.join(folder, part))[0] for part in ("solid.*", "motion.*")] if rows else []
        for row in rows:
            point = [F(row[x]) for x in "xyz" if x in row]
            answers = graze.classify(f"{name} {row['id']}", *files, [point], "--topo")
            if answers:
                checks.equal(answers[0].record["topo"], "boundary", name)
                check_witness(checks, graze, f"{name} {row['id']}", files, point, answers[0].record)
                seen[len(point), answers[0].record["topo_level"]] += 1
    print("golden:", dict(seen))
    for kind in ((2, "first_order"), (2, "curves"), (3, "leading_terms")):
        checks.holds(seen[kind], "a golden row with a witness by", kind)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    for name, solid, motion, point, pmc in examples():
        if pmc == "on":
            files = os.path.join(EXAMPLES, "solids", solid), os.path.join(EXAMPLES, "motions", motion + ".json")
            check(checks, graze, name, files, [F(x) for x in point], POSITIONS[name])
    for name, solid, motion, point, pmc, want in neighbours():
        if pmc == "on":
            check(checks, graze, name, (solid, motion), point, want)
    for name, solid, motion, point, gap, axis in passing():
        reach = check(checks, graze, name, (solid, motion), point, "boundary")
        checks.holds(reach and reach < 100 * gap, name, "the reach, with a part so near", reach)
    for name, solid, motion in leaving():
        reach = check(checks, graze, name, (solid, motion), (F(1), F(1)), "boundary")
        checks.equal(reach, 1, name, "the reach upward")
    golden(checks, graze)
    checks.finish()


if __name__ == "__main__":
    main()
