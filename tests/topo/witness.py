#!/usr/bin/env python3
# suite
"""Witnesses of the boundary of the closed sweep, and interiors, by exact classification down to 2^-400 of a distance.

SPDX-License-Identifier: GPL-3.0-or-later

By L1 a witness is the point + epsilon * direction: from epsilon down all are `out`, also next to a part that passes
2^-100 away, which epsilon must stay below. By LR and L3 it lies on a square whose half side is rho. Near a point that is
interior nothing is `out` below some distance. Truths are those of verdicts.py, and derived here.
"""
import os
import sys
from fractions import Fraction as F

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "agree", "lib"))

from motion import legs  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from solids import Polygon, block, box_ring, joined  # noqa: E402
from verdicts import EXAMPLES, POSITIONS, TINY, examples, neighbours  # noqa: E402

# Every scale from 1 to 2^-48, then on to 2^-400.
SCALES = [*range(48), *range(48, 401, 8)]
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


def check_ray(checks, graze, name, files, point, record):
    direction, epsilon = [int(x) for x in record["topo_direction"]], F(record["topo_epsilon"])
    witness = [F(x) for x in record["topo_witness"]]
    checks.equal(witness, [p + epsilon * u for p, u in zip(point, direction)], name, "the witness on its ray")
    checks.holds(epsilon > 0, name, "epsilon")
    places = [tuple(p + (q - p) / 2 ** k for p, q in zip(point, witness)) for k in SCALES]
    places += [tuple(p + (q - p) * F(k, 37) for p, q in zip(point, witness)) for k in range(1, 37)]
    found = graze.classify(name + " ray", *files, places) or []
    checks.equal({answer.record["pmc"] for answer in found}, {"out"}, name, "on the ray up to the witness", record)
    return epsilon * max(abs(x) for x in direction)


def check_square(checks, name, point, record):
    rho, witness = F(record["topo_rho"]), [F(x) for x in record["topo_witness"]]
    plane = [[int(x) for x in v] for v in record["topo_plane"]] if len(point) == 3 else [[1, 0], [0, 1]]
    way = [q - p for p, q in zip(point, witness)]
    # x and y with way = x a + y b, by a minor of (a, b) that is not 0
    (a, b), d = plane, len(point)
    i, j = next((i, j) for i in range(d) for j in range(i) if a[i] * b[j] != a[j] * b[i])
    det = a[i] * b[j] - a[j] * b[i]
    x, y = (way[i] * b[j] - way[j] * b[i]) / F(det), (a[i] * way[j] - a[j] * way[i]) / F(det)
    checks.equal([x * p + y * q for p, q in zip(a, b)], way, name, "the witness in its plane")
    checks.equal(max(abs(x), abs(y)), rho, name, "the witness on its square")


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
    checks.equal("topo_direction" in keys, record["topo_level"] == "L1", name, keys)
    if record["topo_level"] == "L1":
        checks.equal(keys, {"topo_witness", "topo_direction", "topo_epsilon"}, name)
        return check_ray(checks, graze, name, files, point, record)
    checks.equal(keys, {"topo_witness", "topo_rho"} | ({"topo_plane"} if len(point) == 3 else set()), name)
    check_square(checks, name, point, record)
    return None


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
    checks.finish()


if __name__ == "__main__":
    main()
