#!/usr/bin/env python3
# suite
"""Scenes of the plane as sheared prisms in space: the position of a point at half height is that of the plane.

SPDX-License-Identifier: GPL-3.0-or-later

A prism over [-1, 1] that moves along with a motion of the plane sweeps, near height 0, what the plane sweeps times an
interval. A linear map of space, other than identity, is applied to solid, motion and points, so that nothing is along
an axis. The plane's answers are those derived in verdicts.py, a point that is `on` for each; every one must be decided,
since a direction of space is on no account of any contact. Scenes with a cap at the point's height have no such
direction: what is covered there is half of what the plane says, so a point is on the boundary.
"""
import itertools
import json
import os
import sys
from collections import Counter

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "agree", "lib"))
sys.path.insert(0, os.path.join(HERE, "..", "lib"))

from exact import Fraction as F  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from solids import Mesh, joined, prism  # noqa: E402
from verdicts import EXAMPLES, POSITIONS, examples, neighbours  # noqa: E402

# Rows of the map, and of its inverse; the determinant is 1.
MAP = [[1, 0, 1], [-1, 1, 1], [0, 1, 3]]
BACK = [[2, 1, -1], [3, 3, -2], [-1, -1, 1]]
# Levels that the examples were chosen for: a direction left open or covered with its neighbourhood, closed cones, a way
# through a pinch and along its edge, a section where contacts are at irrational times or of second order.
LEVELS = {"5": "first_order", "34": "first_order", "42": "first_order", "17": "closed_cones", "35": "closed_cones",
          "20": "edges", "28": "leading_terms", "29": "section", "30": "section", "31": "section"}


SOLIDS = ["q2", "dd", "ll", "tt", "bl", "bar"]
MOTIONS = ["seam", "diagonal_up", "bent_diagonal", "notch", "apex_28", "apex_29", "apex_30", "pivot_2", "pivot_3", "rotate",
           "rotate_and_slide", "quartic", "cubic", "parabola", "pinch_sqrt2", "shrink", "dive"]
POINTS = 12


class Text:
    suffix = ".json"

    def __init__(self, value):
        self.value = value

    def text(self):
        return json.dumps(self.value)


def mapped(p):
    return tuple(sum(F(a) * x for a, x in zip(row, p)) for row in MAP)


def rings_of(wkt):
    """The rings of a POLYGON or MULTIPOLYGON, none of them holes."""
    text = wkt.read() if hasattr(wkt, "read") else wkt
    out = []
    for part in text[text.index("("):].replace("(", " ( ").replace(")", " ) ").split(" ( "):
        numbers = part.split(")")[0].strip()
        if numbers:
            points = [tuple(F(x) for x in point.split()) for point in numbers.split(",") if point.strip()]
            out.append(points[:-1])
    return out


def turned_left(r):
    area = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(r, r[1:] + r[:1]))
    return r if area > 0 else r[::-1]


def lifted(transform):
    """A transform of the plane as one of space that keeps heights."""
    (kind, value), = transform.items()
    if kind == "translate":
        return {kind: [*value, 0]}
    if kind in ("turn", "rotate"):
        more = {"center": [*value["center"], 0]} if "center" in value else {}
        return {kind: {**value, **more, "axis": [0, 0, 1]}}
    if kind == "scale":
        return {kind: [value, value, 1]}
    if kind == "matrix":
        (a, b, c), (d, e, f) = value
        return {kind: [[a, b, 0, c], [d, e, 0, f], [0, 0, 1, 0]]}
    return {kind: [lifted(x) for x in value]}


def carried(motion):
    """The motion of space T M T^-1."""
    def linear(rows):
        return {"matrix": [[*row, 0] for row in rows]}
    pieces = [{"t": p["t"], "transform": {"compose": [linear(BACK), lifted(p["transform"]), linear(MAP)]}}
              for p in motion["pieces"]]
    return Text({"dimension": 3, "pieces": pieces})


def prisms(rings, low, high):
    mesh = joined(*(prism(turned_left(list(r)), low, high) for r in rings))
    return Mesh([mapped(v) for v in mesh.vertices], mesh.facets)


def has_hole(name):
    return name == "rg.wkt"


def plane_scenes():
    """(name, rings, motion, point, position)"""
    for name, solid, motion, point, pmc in examples():
        if len(point) == 2 and pmc == "on" and not has_hole(solid):
            with open(os.path.join(EXAMPLES, "solids", solid), encoding="utf-8") as wkt:
                rings = rings_of(wkt)
            with open(os.path.join(EXAMPLES, "motions", motion + ".json"), encoding="utf-8") as f:
                yield name, rings, json.load(f), [F(x) for x in point], POSITIONS[name]
    for name, solid, motion, point, pmc, position in neighbours():
        if pmc == "on":
            yield name, rings_of(solid.text()), json.loads(motion.text()), point, position


def generated(graze, solid, motion, seed):
    """Points of the plane that are `on`, with their positions."""
    made = graze.call("generate", solid, motion, "-n", str(POINTS), "--seed", str(seed))
    points = graze.write("generated.csv", made.stdout)
    out = graze.call("classify", solid, motion, points, "--topo", "--format", "jsonl", "--quiet")
    records = [json.loads(line) for line in out.stdout.splitlines()]
    return [(r["point"], r["topo"], r["topo_level"]) for r in records if r["pmc"] == "on"]


def check_witness(checks, graze, name, point, witness):
    """For level first_order the witness is out, and so is every place from it down towards the point."""
    tag = name.replace(" ", "_")
    files = [os.path.join(graze.keep or graze.folder.name, tag + suffix) for suffix in (".off", ".json")]
    places = [tuple(p + (q - p) / 2 ** k for p, q in zip(point, witness)) for k in (0, 8, 40, 120, 400)]
    found = graze.classify(name + " witness", *files, places) or []
    checks.equal([answer.record["pmc"] for answer in found], ["out"] * len(places), name, "witness towards the point")


def check_pairs(checks, graze, seen, args):
    """Every solid with every motion of the plane: what levels of the plane say of generated points, by the curves if
    need be, is what those of space say of the prism."""
    rng = args.random
    for _, (name, motion_name) in args.cycle(itertools.product(SOLIDS, MOTIONS), 1, "pairs"):
        solid = os.path.join(EXAMPLES, "solids", name + ".wkt")
        motion = os.path.join(EXAMPLES, "motions", motion_name + ".json")
        on = generated(graze, solid, motion, rng.randrange(10 ** 6))
        if not on:
            continue
        with open(solid, encoding="utf-8") as wkt, open(motion, encoding="utf-8") as file:
            mesh, there = prisms(rings_of(wkt), -1, 1), carried(json.load(file))
        points = [mapped([F(p[0]), F(p[1]), F(rng.randint(-9, 9), 10)]) for p, _, _ in on]
        answers = graze.classify(f"pair {name} {motion_name}", mesh, there, points, "--topo") or []
        for answer, (p, position, level) in zip(answers, on):
            r = answer.record
            checks.equal(r["topo"], position, name, motion_name, p, level, r.get("topo_level"), r.get("topo_reason"))
            seen["pair", position, level, r.get("topo_level", "undecided")] += 1


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    seen = Counter()
    check_pairs(checks, graze, seen, args)
    for name, rings, motion, point, want in plane_scenes() if args.derived else ():
        there = [mapped([*point, 0])]
        for bottom, position in ((-1, want), (0, "boundary")):
            answers = graze.classify(f"prism {name} {bottom}", prisms(rings, bottom, 1), carried(motion), there, "--topo")
            if not answers:
                continue
            record = answers[0].record
            checks.equal(record["pmc"], "on", name, bottom)
            checks.equal(record["topo"], position, name, bottom, record.get("topo_reason"))
            checks.equal("topo_witness" in record, position == "boundary", name, bottom, "witness")
            if record.get("topo_level") == "first_order":
                check_witness(checks, graze, f"prism {name} {bottom}", there[0], [F(x) for x in record["topo_witness"]])
            seen[position, record.get("topo_level", "undecided")] += 1
            if bottom < 0 and name in LEVELS:
                checks.equal(record.get("topo_level"), LEVELS[name], name, "level")
    for key, n in sorted(seen.items()):
        print(*key, n)
    checks.finish()


if __name__ == "__main__":
    main()
