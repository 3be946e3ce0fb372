#!/usr/bin/env python3
# suite
"""Positions relative to the closed sweep that are derived by hand: the worked examples of ../examples that are
`on`, and neighbours of them whose position is the other one.

SPDX-License-Identifier: GPL-3.0-or-later

An undecided point in space is no failure of this suite, but DECIDED of them must be decided.
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "agree", "lib"))
sys.path.insert(0, os.path.join(HERE, "..", "lib"))

from exact import Fraction as F  # noqa: E402
from motion import build, legs, translate  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from solids import Polygon, box_ring, ring  # noqa: E402

EXAMPLES = os.path.join(HERE, "..", "examples")
# Examples in space that must be decided.
DECIDED = {"46", "47", "49", "50", "51", "52", "53", "55a", "55b", "55c"}

# Why, for each example of examples.txt that is `on`. D is what the closed solid covers near P at a contact.
POSITIONS = {
    "5": "boundary",    # the top edge slides along y = 2: D is y <= 0 throughout, (0, 1) is left open
    "7": "boundary",    # the left side at t0, which moves away to the right: (-1, 0) is open
    "9": "boundary",    # the right side at t1: (1, 0) is open
    "10": "boundary",   # the upper right corner, then a slide of the top edge: (0, 1) is open
    "16": "boundary",   # the right side at the turning point: (1, 0) is open
    "17": "interior",   # right side at rest on x = 4, later the left side: two half-planes, closed
    "17b": "interior",  # the same two half-planes; the second contact is the end of the motion
    "19": "interior",   # squares at a pinch, moved across it: each sweeps one side of the path, closed
    "20": "interior",   # the same along a parabola
    "24": "boundary",   # the top of the frame slides: (0, 1) is open
    "26": "boundary",   # the reflex corner is the end of both legs: (1, 1) stays open
    "28": "boundary",   # lower triangle's tip draws y = -x^2, the upper one's y = x^2: open between them
    "29": "interior",   # y <= x^2 and y >= -x^2 are covered: they overlap but at P
    "30": "interior",   # both tips draw y = -x^2: what is below and what is above, closed
    "31": "interior",   # the pinch at an irrational time
    "32": "boundary",   # a corner comes from outside by scaling: (-2, 1) is open
    "34": "boundary",   # a square turns about its corner by 180 degrees: 270 degrees, (1, -1) is open
    "35": "interior",   # by 270 degrees: all 360
    "39": "boundary",   # the side x = 2 passes at distance 2 from the centre: the disk inside is open
    "42": "boundary",   # a corner's circle, and a side at t1: (1, 4) is open
    "44": "boundary",   # the side x = 0 turns back with order 4: (-1, 0) is open
    "45a": "boundary",  # nothing moves: the corner's complement is open
    "46": "boundary",   # the corner of a cube passes by sideways: (1, 1, 1) is open
    "47": "boundary",   # a point of its edge: (1, 1, 0) is open
    "49": "interior",   # example 17b times an interval
    "50": "interior",   # an edge touches along its own direction, a notch takes the rest
    "51": "interior",   # crossed roofs: covered up to x^2 - y^2 below and down to the same above, and more
    "52": "boundary",   # crossed roofs: between -x^2 and y^2 is open where x is not 0
    "53": "boundary",   # the same with x and y exchanged
    "54": "interior",   # crossed roofs, one of them straight
    "55a": "boundary",  # example 28 times an interval
    "55b": "interior",  # example 29 times an interval
    "55c": "interior",  # example 30 times an interval
}
# Levels that prove the position of neighbours chosen for them: by closed cones alone the opposite of the way from the
# pinch stays open, as the way bends. Near walls leave a half-plane open: a ray is a witness, if it ends before them.
LEVELS = {"20 from its pinch on": "edges", "a wall that ends nearby": "first_order", "a wall that begins nearby": "first_order"}
TINY = F(1, 2 ** 100)


def apex(k1, k2, lift=0):
    """Two triangles with their tips at P: the lower one's tip draws y = -k1 x^2, the upper one's, `lift` higher,
    y = -k2' x^2 with k2' = -k2 in the terms of the tip: the body is moved by b = (t - 3, -6 + k2 (t - 3)^2)."""
    def line(a, b, lo):
        return [[F(p) - (F(q) - p) * lo, F(q) - p] for p, q in zip(a, b)]
    start = (F(-1), -6 + F(k2) + lift)
    return build([(-1, 1, translate([[0, 1], [0, 0, -F(k1)]])),
                  (1, 2, translate(line((F(1), -F(k1)), start, 1))),
                  (2, 4, translate([[-3, 1], [-6 + lift + 9 * F(k2), -6 * F(k2), F(k2)]]))])


def neighbours():
    """(name, solid, motion, point, pmc, position), each beside the example whose position is the other one."""
    square = Polygon([[box_ring(0, 0, 2, 2)]])
    double = Polygon([[box_ring(-2, -2, 0, 0)], [box_ring(0, 0, 2, 2)]])
    apart = Polygon([[box_ring(-2, -2, 0, 0)], [box_ring(TINY, TINY, 2, 2)]])
    tips = Polygon([[ring((0, 0), (-1, -2), (1, -2))], [ring((0, 6), (1, 8), (-1, 8))]])
    corner = Polygon([[box_ring(-2, -2, 0, 0)], [box_ring(0, 0, 2, 2)], [ring((-6, 1), (-2, 5), (-6, 5))]])
    wall = Polygon([[box_ring(-2, -1000, 0, 1000)], [box_ring(10, -1000, 11, 1000)]])
    seam = [(0, 0), (2, 0), (0, 4), (8, 4), (4, 0)]
    seen = (F(4), F(1))
    origin = (F(0), F(0))
    across = legs([(4, -4), (-4, 4)])
    return [
        ("17 without its last legs", square, legs(seam[:4]), seen, "on", "boundary"),
        ("17b again", square, legs(seam), seen, "on", "interior"),
        ("17 with a gap of 2^-100", square, legs(seam[:4] + [(4 + TINY, 0)]), seen, "on", "boundary"),
        ("17 with an overlap of 2^-100", square, legs(seam[:4] + [(4 - TINY, 0)]), seen, "in", "interior"),
        ("19 again", double, across, origin, "on", "interior"),
        ("19 with a gap of 2^-100", apart, across, origin, "on", "boundary"),
        # c = (-t, t - t^2/16) leaves the pinch; at t = 4 it reaches the third part's side from (-6, 1) to (-2, 5), at (-4, 3): a
        # half-plane y >= x. A point with x > 0 > y comes to the line x = 0, and all of that is solid near the pinch.
        ("20 from its pinch on", corner, build([(0, 4, translate([[0, 1], [0, -1, F(1, 16)]]))]), origin, "on", "interior"),
        ("30 again", tips, apex(1, -1), origin, "on", "interior"),
        ("30 with more curvature", tips, apex(1, -1 + TINY), origin, "on", "boundary"),
        ("30 with less curvature", tips, apex(1, -1 - TINY), origin, "on", "interior"),
        ("30 lifted by 2^-100", tips, apex(1, -1, TINY), origin, "on", "boundary"),
        ("30 lowered by 2^-100", tips, apex(1, -1, -TINY), origin, "in", "interior"),
        ("29 lifted by 2^-100", tips, apex(-1, -1, TINY), origin, "on", "boundary"),
        # The side x = 0 leaves at t0, and a wall comes from x = 10 to x = 2: it is nearest at t1, at no contact. Then backwards.
        ("a wall that ends nearby", wall, build([(0, 1, translate([[0, -8], [0]]))]), origin, "on", "boundary"),
        ("a wall that begins nearby", wall, build([(0, 1, translate([[-8, 8], [0]]))]), origin, "on", "boundary"),
    ]


def examples():
    with open(os.path.join(EXAMPLES, "examples.txt"), encoding="utf-8") as f:
        for line in f:
            if line.strip() and not line.startswith("#"):
                fields = [x.strip() for x in line.split("|")]
                yield fields[0], fields[1], fields[2], fields[3].split(), fields[10]


def check(checks, graze, name, solid, motion, point, pmc, want, may_be_open):
    answers = graze.classify(name, solid, motion, [point], "--topo", table=True)
    if answers is None:
        return
    record, row = answers[0].record, answers[0].row
    checks.equal(record["pmc"], pmc, name)
    checks.equal(row["topo"], record["topo"], name, "table")
    if may_be_open and record["topo"] == "undecided":
        checks.holds(record["topo_reason"], name, "a reason")
        print("undecided:", name, want)
        return
    checks.equal(record["topo"], want, name)
    checks.equal(record["topo_level"] == "word", pmc != "on", name, "level")
    checks.equal(record["topo_level"], LEVELS.get(name, record["topo_level"]), name, "level")
    checks.equal("topo_witness" in record, pmc == "on" and want == "boundary", name, "witness")
    witness = record.get("topo_witness")
    if witness:  # to first order all of the way to it is out (C74)
        many = 12 if record["topo_level"] == "first_order" else 1
        way = [[F(p) + (F(w) - F(p)) / 2 ** k for p, w in zip(point, witness)] for k in range(many)]
        found = graze.classify(name, solid, motion, way)
        checks.equal(found and [a.record["pmc"] for a in found], ["out"] * many, name, witness)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    used = set()
    for name, solid, motion, point, pmc in examples():
        want = {"in": "interior", "out": "exterior"}.get(pmc) or POSITIONS[name]
        used |= {name} if pmc == "on" else set()
        check(checks, graze, name, os.path.join(EXAMPLES, "solids", solid),
              os.path.join(EXAMPLES, "motions", motion + ".json"), point, pmc, want,
              len(point) == 3 and name not in DECIDED)
    checks.equal(used, set(POSITIONS), "every position is used")
    for name, solid, motion, point, pmc, want in neighbours():
        check(checks, graze, name, solid, motion, point, pmc, want, False)
    checks.finish()


if __name__ == "__main__":
    main()
