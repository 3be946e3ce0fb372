#!/usr/bin/env python3
"""Arcs of exact outlines in pictures: places, lengths and sources.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

Each scene has its outline derived: for each source the length of its arcs, and the distance of any place from it. A line
is within 1/16 of a pixel of its arc, and coordinates are written with two decimals.
"""
import json
import math
import os
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from draw import SVG, Cells, checks, excuse_fonts, group, options, run  # noqa: E402
from levels import segments  # noqa: E402

NEAR = 1 / 16 + .011
COLOURS = {"path": "#0072b2", "edge": "#d55e00", "envelope": "#cc79a7"}
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
LADDER = [(0, 0), (.5, -.5), (1, 0)]


def to_segment(p, a, b):
    """The distance of a place from a segment."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    s = min(1, max(0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)))
    return math.hypot(p[0] - a[0] - s * dx, p[1] - a[1] - s * dy)


def to_segments(*ends):
    return lambda p: min(to_segment(p, a, b) for a, b in ends)


def to_circle(p):
    return abs(math.hypot(*p) - math.sqrt(2))


def to_astroid(p):
    """To the astroid (cos^3, sin^3) of the first quadrant, by its nearest of many chords; these are within 1e-6 of it."""
    if not hasattr(to_astroid, "places"):
        to_astroid.places = [(math.cos(a) ** 3, math.sin(a) ** 3) for a in (math.pi / 2 * k / 2000 for k in range(2001))]
    places = to_astroid.places
    k = min(range(2001), key=lambda i: math.dist(p, places[i]))
    return min(to_segment(p, places[i], places[i + 1]) for i in (max(k - 1, 0), min(k, 1999)))


def translated(x, y):
    return {"translate": [x, y]}


# name, corners, transform, words, source -> (length, distance), whether path and edge may stand for each other
SCENES = [
    # Sides of the first square on the left and below, of the last one, at (3, 2), on the right and above; between them two paths.
    ("leg", SQUARE, translated("3*t", "2*t"), [], {
        "edge": (4, to_segments(((0, 0), (0, 1)), ((0, 0), (1, 0)), ((4, 2), (4, 3)), ((3, 3), (4, 3)))),
        "path": (2 * math.sqrt(13), to_segments(((0, 1), (3, 3)), ((1, 0), (4, 2))))}),
    # The far corner runs from (1, 1) to (-1, 1) on its circle; of both ends' squares the lower sides, which lie on y = 0, and the outer ones.
    ("quarter turn", SQUARE, {"rotate": {"tan_half": "t"}}, [], {
        "edge": (4, to_segments(((-1, 0), (1, 0)), ((1, 0), (1, 1)), ((-1, 0), (-1, 1)))),
        "path": (math.pi / math.sqrt(2), to_circle)}),
    # The long side falls along the astroid; below it four sides of length sqrt(1/2), two of them on the path y = -x of the third corner.
    ("ladder", LADDER, {"matrix": [["(1-t^2)/(1+t^2)", "2*t/(1+t^2)", "0"], ["-2*t/(1+t^2)", "(1-t^2)/(1+t^2)", "2*t/(1+t^2)"]]}, [], {
        "envelope": (1.5, to_astroid),
        "straight": (2 * math.sqrt(2), to_segments(((0, 0), (.5, -.5)), ((.5, -.5), (1, 0)), ((0, 0), (-.5, .5)), ((-.5, .5), (0, 1))))}),
    # Points that stay in the square while they go 1/4 to the right: [0, 3/4] x [0, 1].
    ("unsweep", SQUARE, translated("t/4", "0"), ["--operation", "unsweep"], {
        "straight": (3.5, to_segments(((0, 0), (.75, 0)), ((0, 1), (.75, 1)), ((0, 0), (0, 1)), ((.75, 0), (.75, 1))))}),
]


def places(cells, ends):
    """Ends of lines in the plane, from their pixels."""
    x, y, width, height = cells.frame
    low, side = [float(v) for v in cells.low], float(cells.side)
    scale = side * cells.count[0] / width
    return [[(low[0] + (u - x) * scale, low[1] + (y + height - v) * scale) for u, v in line] for line in ends], scale


def check_scene(graze, folder, name, corners, transform, words, expected):
    solid, motion = (os.path.join(folder, file) for file in ("s.wkt", "m.json"))
    with open(solid, "w", encoding="ascii") as file:
        file.write("POLYGON ((" + ", ".join(f"{x} {y}" for x, y in [*corners, corners[0]]) + "))\n")
    with open(motion, "w", encoding="ascii") as file:
        json.dump({"dimension": 2, "pieces": [{"t": [0, 1], "transform": transform}]}, file)
    done = run(graze, "draw", solid, motion, "-o", "-", *words)
    checks.equal(done.returncode, 0, name, done.stderr)
    root = ElementTree.fromstring(done.stdout)
    cells, found = Cells(root), {}
    for path in group(root, "arcs").iter(SVG + "path"):
        source = path.get("class")
        checks.equal(path.get("stroke"), COLOURS[source], name, source)
        found.setdefault(source if source in expected else "straight", []).extend(segments(path.get("d")))
    checks.equal(set(found), set(expected), name, "sources")
    said = "".join(root.itertext())
    for source, words_of in (("path", "path of a vertex"), ("edge", "edge at one time"), ("envelope", "envelope of an edge")):
        if source in expected:
            checks.holds(words_of in said, name, words_of)
        elif "straight" not in expected or source == "envelope":
            checks.holds(words_of not in said, name, words_of)
    for source, (length, distance) in expected.items():
        lines, scale = places(cells, found.get(source, []))
        total = sum(math.dist(a, b) for a, b in lines)
        checks.holds(abs(total - length) < .01 * length, name, source, "length", total, length)
        for a, b in lines:
            for p in (a, b, ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)):
                checks.holds(distance(p) < NEAR * scale, name, source, p, distance(p) / scale)


def main():
    args = options(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        excuse_fonts(folder)
        for scene in SCENES:
            check_scene(args.graze, folder, *scene)
        # Elsewhere there are none: by distance, of curved solids.
        case = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "cases", "curved-crescent")
        for words in ([os.path.join(folder, "s.wkt"), os.path.join(folder, "m.json"), "--by", "distance", "--grid", "20"],
                      [os.path.join(case, "solid.csg.json"), os.path.join(case, "motion.json"), "--grid", "20"]):
            done = run(args.graze, "draw", *words, "-o", "-")
            checks.equal(done.returncode, 0, words, done.stderr)
            checks.holds(group(ElementTree.fromstring(done.stdout), "arcs") is None, words)
    checks.finish()


if __name__ == "__main__":
    main()
