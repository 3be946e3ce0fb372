#!/usr/bin/env python3
# suite
"""Crossed roofs that pass a point of space one after the other: positions that hang on second order, derived.

SPDX-License-Identifier: GPL-3.0-or-later

The lower roof's ridge, along y, passes the origin along (t, 0, k t^2) at t = 0 while the solid tilts about x by the angle
2 atan(w t / 2): it draws z = k x^2 + w x y to second order and covers what is below. The upper roof's ridge, along x,
passes along (0, s, m s^2): it covers what is above z = m y^2. The origin is interior if k x^2 + w x y - m y^2 is positive
but at 0, that is if k > 0 > m and w^2 < -4 k m, and on the boundary if it is negative somewhere. Where it is neither the
answer may be `undecided`. A linear map is applied to all, so that nothing is along an axis.
"""
import os
import sys
from collections import Counter

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "agree", "lib"))
sys.path.insert(0, os.path.join(HERE, "..", "lib"))

from exact import Fraction as F  # noqa: E402
from prisms import BACK, MAP, Text, mapped  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from solids import Mesh  # noqa: E402
from witnesses import check_witness  # noqa: E402

TINY = F(1, 2 ** 100)
SCENES = 60
SCALES = (120, 250, 400)
ROOFS = os.path.join(HERE, "..", "examples", "solids", "crossed_roofs.off")


def roofs():
    with open(ROOFS, encoding="utf-8") as f:
        lines = [x.split() for x in f if x.strip() and not x.startswith(("#", "OFF"))]
    vertices, facets = int(lines[0][0]), int(lines[0][1])
    at = [tuple(F(x) for x in line) for line in lines[1:1 + vertices]]
    of = [tuple(int(x) for x in line[1:]) for line in lines[1 + vertices:1 + vertices + facets]]
    return Mesh([mapped(v) for v in at], of)


def motion(k, m, w):
    """Times and places are those of worked example 51."""
    def tilt(half):
        return {"rotate": {"tan_half": half, "axis": [1, 0, 0]}}

    def piece(lo, hi, half, x, y, z):
        rows = {"matrix": [[*row, 0] for row in BACK]}, {"matrix": [[*row, 0] for row in MAP]}
        return {"t": [lo, hi], "transform": {"compose": [rows[0], tilt(half), {"translate": [x, y, z]}, rows[1]]}}

    half, drop = f"{w / 2}", m - 10 - k
    return Text({"dimension": 3, "pieces": [
        piece(-1, 1, f"({half})*t", "t", "0", f"({k})*t^2"),
        piece(1, 2, f"({half})*(2-t)", "2-t", "1-t", f"({k})+({drop})*(t-1)"),
        piece(2, 4, "0", "0", "t-3", f"-10+({m})*(t-3)^2"),
        piece(4, 5, "0", "0", "1+10*(t-4)", f"-10+({m})")]})


def truth(k, m, w):
    if k > 0 > m and w * w < -4 * k * m:
        return "interior"
    if k < 0 or m > 0 or w * w > -4 * k * m:
        return "boundary"
    return None


def probes(k, m, w, e):
    """Places at the distance e along several directions of z = 0: below, between and above what both ridges draw."""
    for x, y in ((1, 0), (0, 1), (1, 1), (1, -1), (2, 1), (1, 2), (2, -1), (-1, 2)):
        low, high = k * x * x + w * x * y, m * y * y
        for z in ((low + high) / 2, 2 * low - high, 2 * high - low, F(0)):
            yield mapped((x * e, y * e, z * e * e))


def open_somewhere(k, m, w):
    return any(k * x * x + w * x * y < m * y * y
               for x, y in ((1, 0), (0, 1), (1, 1), (1, -1), (2, 1), (1, 2), (2, -1), (-1, 2)))


def chosen(args):
    """(number, (k, m, w)): some on the edge of being definite, and 2^-100 beside it."""
    derived = [(F(1, 64), F(-1, 64), F(0))]
    for beside in (-TINY, F(0), TINY):
        derived += [(F(1, 64), F(-1, 64), F(1, 32) + beside), (F(1, 64), F(-1, 16), -F(1, 16) + beside),
                    (beside, F(-1, 64), F(0)), (F(1, 64), beside, F(0))]
    yield from enumerate(derived if args.derived else [])
    number = args.random.randint
    for k in args.rounds(SCENES, "roofs"):
        yield len(derived) + k, (F(number(-2, 9), 256), F(number(-9, 2), 256), F(number(-6, 6), 256))


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    seen = Counter()
    solid = roofs()
    for n, (k, m, w) in chosen(args):
        answers = graze.classify(f"roofs {n}", solid, motion(k, m, w), [mapped((F(0), F(0), F(0)))], "--topo")
        if not answers:
            continue
        record, want = answers[0].record, truth(k, m, w)
        where = (str(k), str(m), str(w), record["word"], record.get("topo_level"))
        checks.equal(record["pmc"], "on", *where)
        seen[want, record["topo"], record.get("topo_level")] += 1
        if want:
            checks.equal(record["topo"], want, *where)
            checks.equal("topo_witness" in record, want == "boundary", *where, "witness")
            if want == "boundary":
                check_witness(checks, graze, f"roofs {n}", (solid, motion(k, m, w)), mapped((F(0), F(0), F(0))), record)
            places = [p for s in SCALES for p in probes(k, m, w, F(1, 2 ** s))]
            found = graze.classify(f"probes {n}", solid, motion(k, m, w), places)
            out = [answer.record["pmc"] == "out" for answer in found or []]
            each = len(out) // len(SCALES)
            scales = {s for j, s in enumerate(SCALES) if any(out[j * each:(j + 1) * each])}
            if want == "interior":
                checks.equal(scales, set(), *where, "scales of the probes that are out")
            elif open_somewhere(k, m, w):
                checks.equal(scales, set(SCALES), *where, "scales of the probes that are out")
    for key, count in sorted(seen.items(), key=str):
        print(*key, count)
    checks.holds(seen["interior", "interior", "leading_terms"] > 20 * args.share, "few are interior by second order")
    checks.holds(seen["boundary", "boundary", "leading_terms"] > 20 * args.share, "few are boundary")
    checks.finish()


if __name__ == "__main__":
    main()
