#!/usr/bin/env python3
# suite
"""Pictures of contacts' cones: sectors of worked examples, read back from the paths, against those derived by hand.

SPDX-License-Identifier: GPL-3.0-or-later

Sectors run counter-clockwise between two directions. D is what the solid covers at a contact, D + cone(v) what it sweeps on a
side on which it comes from, or goes to, the direction v.
"""
import json
import math
import os
import re
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "lib"))

from exact import Fraction, to_double  # noqa: E402
from harness import Checks, options, run  # noqa: E402

SVG = "{http://www.w3.org/2000/svg}"
EXAMPLES = os.path.join(HERE, "..", "examples")
RIGHT, UP, LEFT, DOWN = (1, 0), (0, 1), (-1, 0), (0, -1)
WEST, EAST, SOUTH = [(UP, DOWN)], [(DOWN, UP)], [(LEFT, RIGHT)]

# Example -> its rings as (contact, side, sectors); a sector of two directions, or "all".
WANTED = {
    # The top of the square [0, 2]^2 slides along y = 2 to the right: first its right corner is at P, at last its left one.
    "5": [(1, "at", [(LEFT, DOWN)]), (1, "after", SOUTH), (1, "before", [(LEFT, DOWN)]),
          (2, "at", SOUTH),
          (3, "at", [(DOWN, RIGHT)]), (3, "after", [(DOWN, RIGHT)]), (3, "before", SOUTH),
          (0, "open", [(RIGHT, LEFT)])],
    # The square's right side comes to x = 4 and goes back at t = 1, its left side at t = 4; each time is in two pieces.
    "17": [(1, "at", WEST), (1, "before", WEST), (2, "at", WEST), (2, "after", WEST),
           (3, "at", EAST), (3, "before", EAST), (4, "at", EAST), (4, "after", EAST), (0, "open", [])],
    # Squares above right and below left of a pinch, which moves by (-1, 1): to the upper left later, from the lower right.
    "20": [(1, "at", [(RIGHT, UP), (LEFT, DOWN)]), (1, "after", [(RIGHT, DOWN)]), (1, "before", [(LEFT, UP)]), (0, "open", [])],
    # The notch of an L comes to P from the lower left, and goes back to it: all but its quadrant throughout.
    "26": [(1, "at", [(UP, RIGHT)]), (1, "before", [(UP, RIGHT)]), (2, "at", [(UP, RIGHT)]), (2, "after", [(UP, RIGHT)]),
           (0, "open", [(RIGHT, UP)])],
    # Tips between (-1, -2) and (1, -2), and turned over, pass to the right: nothing but the line y = 0 is left.
    "28": [(1, "at", [((-1, -2), (1, -2))]), (1, "after", [((-1, -2), RIGHT)]), (1, "before", [(LEFT, (1, -2))]),
           (2, "at", [((1, 2), (-1, 2))]), (2, "after", [(RIGHT, (-1, 2))]), (2, "before", [((1, 2), LEFT)]), (0, "open", [])],
    # A corner of [2, 4] x [-1, 1] is at P = (1, 4) turned by (8 + 15 i) / 17, the other one by i; both move along (-4, 1).
    "42": [(1, "at", [((-8, -15), (15, -8))]), (1, "after", [((-4, 1), (15, -8))]), (1, "before", [((-8, -15), (4, -1))]),
           (2, "at", [(LEFT, DOWN)]), (2, "before", [(LEFT, (4, -1))]), (0, "open", [((4, -1), (-4, 1))])],
}
# A square turns about its corner from t = 1 to 3 by half a turn, from the first quadrant on; it comes and goes diagonally.
TURNED = [("turning", (RIGHT, LEFT)), ("turning", (UP, DOWN)), ("open", (DOWN, RIGHT))]


def angle(v):
    return math.degrees(math.atan2(v[1], v[0])) % 360


def vertices(d):
    """Vertices of a path of M, L, H, V and z, up to its first z."""
    x = y = 0.0
    out = []
    for verb, numbers in re.findall(r"([MLHV])([^MLHVz]*)", d.split("z")[0]):
        given = [float(n) for n in numbers.split()]
        x = given[0] if verb in "MLH" else x
        y = given[-1] if verb in "MLV" else y
        out.append((x, y))
    return out


def sector(path, centre):
    """Its first and last angle: the outer arc is the first half of its vertices."""
    seen = [angle((x - centre[0], centre[1] - y)) for x, y in vertices(path.get("d"))]
    half = len(seen) // 2
    steps = [(b - a) % 360 for a, b in zip(seen[:half], seen[1:half])]
    return seen[0], seen[half - 1], sum(steps)


def read(svg):
    """Rings as (contact, side, sectors), and the witness's angle and whether it is dashed."""
    root = ElementTree.parse(svg).getroot()
    mark = [c for c in root.iter(SVG + "circle")][-1]
    centre = float(mark.get("cx")), float(mark.get("cy"))
    rings, witness = [], None
    for group in root.iter(SVG + "g"):
        if group.get("class") == "ring":
            paths = group.findall(SVG + "path")
            found = ["all" if p.get("class") == "turn" else sector(p, centre) for p in paths]
            rings.append((int(group.get("data-contact")), group.get("data-side"), found, {p.get("fill") for p in paths}))
        if group.get("class") == "witness":
            path = group.find(SVG + "path")
            _, (x, y) = vertices(path.get("d"))[:2]
            witness = angle((x - centre[0], centre[1] - y)), path.get("stroke-dasharray") is not None
    return rings, witness, root


def near(a, b):
    return abs((a - b + 180) % 360 - 180) < 0.2


def is_sector(found, wanted):
    first, last = (angle(v) for v in wanted)
    return found != "all" and near(found[0], first) and near(found[1], last) and abs(found[2] - (last - first) % 360) < 0.4


def same(found, wanted):
    return len(found) == len(wanted) and all(any(is_sector(f, w) for f in found) for w in wanted)


def scene(name):
    with open(os.path.join(EXAMPLES, "examples.txt"), encoding="utf-8") as f:
        fields = next([x.strip() for x in line.split("|")] for line in f if line.split("|")[0].strip() == name)
    return (os.path.join(EXAMPLES, "solids", fields[1]), os.path.join(EXAMPLES, "motions", fields[2] + ".json"),
            fields[3].split())


def draw(checks, graze, folder, name):
    solid, motion, point = scene(name)
    svg = os.path.join(folder, name + ".svg")
    out = run([graze, "explain", solid, motion, *point, "--svg", svg])
    checks.equal((out.returncode, out.stderr), (0, ""), name)
    points = os.path.join(folder, "points.csv")
    with open(points, "w", encoding="utf-8") as f:
        f.write(",".join(point) + "\n")
    record = json.loads(run([graze, "classify", solid, motion, points, "--topo", "--format", "jsonl"]).stdout)
    return (*read(svg), record, [to_double(x) for x in point])


def check_witness(checks, name, witness, record, point):
    checks.equal(witness is not None, "topo_witness" in record, name, "an arrow")
    if witness:
        way = [to_double(Fraction(x)) - p for x, p in zip(record["topo_witness"], point)]
        checks.holds(near(witness[0], angle(way)), name, "the arrow", witness, way)
        checks.equal(witness[1], record["topo_level"] != "first_order", name, "dashed")


def check_colours(checks, name, rings):
    """Parts of a contact have one colour, and its neighbours another; what is left has that of `on`."""
    of = {}
    for contact, _, _, fills in rings:
        of.setdefault(contact, set()).update(fills)
    checks.holds(all(len(fills) <= 1 for fills in of.values()), name, of)
    checks.equal(of[0] - {"#d55e00"}, set(), name, "colour of what is left")
    checks.holds(all(of[k] != of.get(k + 1) and "#d55e00" not in of[k] for k in of if k), name, of)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        for name, wanted in WANTED.items():
            rings, witness, root, record, point = draw(checks, args.graze, folder, name)
            checks.equal([r[:2] for r in rings], [w[:2] for w in wanted], name, "rings")
            for (contact, side, found, _), (_, _, sectors) in zip(rings, wanted):
                checks.holds(same(found, sectors), name, contact, side, found, sectors)
            check_witness(checks, name, witness, record, point)
            check_colours(checks, name, rings)
            shown = " ".join(t.text for t in root.iter(SVG + "text"))
            checks.holds(all(word in shown for word in ("P = (", record["topo"], record["topo_level"])), name, shown)
            signs = {f"{c}{ {'at': '', 'before': '-', 'after': '+'}[s] }" for c, s, *_ in rings if c}
            texts = {t.text for t in root.iter(SVG + "text")}
            checks.equal(signs - texts, set(), name, "names of rings")
        rings, witness, root, record, point = draw(checks, args.graze, folder, "34")
        found = [(side, sector) for _, side, sectors, _ in rings for sector in sectors if side in ("turning", "open")]
        checks.equal(len(found), len(TURNED), "34", found)
        checks.holds(all(f[0] == w[0] and is_sector(f[1], w[1]) for f, w in zip(found, TURNED)), "34", found)
        check_witness(checks, "34", witness, record, point)
        # at the irrational time sqrt 2 a pinch moves along (-1, sqrt 2): what is swept ends near there, and nothing is left
        rings, *_ = draw(checks, args.graze, folder, "31")
        checks.equal([r[:2] for r in rings][-1], (0, "open"), "31")
        checks.equal(rings[-1][2], [], "31", "nothing is left")
    checks.finish()


if __name__ == "__main__":
    main()
