#!/usr/bin/env python3
# suite
"""Contours of `graze draw` in planes of space, and borders by distance, against outlines in closed form.

A node of a contour lies on a side between two grid points, where bisection leaves 1/32 of a pixel: each is within
1/64 of a pixel of the outline along that side, and two decimals of SVG add 1/200 to each coordinate. The chord of
an arc of radius r over a cell's diagonal d is off by d^2 / (8 r) at most. Grid points have the colours of their
classes. Two opposite corners of a square are in one polygon
if its middle is in the sweep, else in two.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import os
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from draw import SVG, Cells, checks, group, options, rings, run  # noqa: E402
from exact import to_double  # noqa: E402
from harness import ROOT  # noqa: E402

NEF = os.path.join(ROOT, "tests", "refuse", "common", "nef3", "cavity.nef3")
NEAR = 1 / 64 + math.hypot(1 / 200, 1 / 200) + 1e-6  # pixels
check = checks.holds


def rectangle(low, high):
    """The signed distance to a rectangle."""
    def value(u, v):
        x, y = (max(a - p, p - b) for a, b, p in zip(low, high, (u, v)))
        return math.hypot(max(x, 0), max(y, 0)) + min(max(x, y), 0)
    return value


def stadium(length, radius):
    return lambda u, v: math.hypot(u - min(max(u, 0), length), v) - radius


def disk(radius):
    return lambda u, v: math.hypot(u, v) - radius


def hollow(outer, inner):
    return lambda u, v: max(outer(u, v), -inner(u, v))


def write(folder, name, value):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(value, file)
    return path


def solid(folder, node):
    return write(folder, "solid.csg.json", {"dimension": 3, "solid": node})


def draw(graze, folder, shape, transform, *more):
    move = write(folder, "motion.json", {"dimension": 3, "pieces": [{"t": [0, 1], "transform": transform}]})
    path = os.path.join(folder, "picture.svg")
    done = run(graze, "draw", shape, move, *more, "-o", path)
    check(done.returncode == 0, more, done.stderr)
    return ElementTree.parse(path).getroot()


def check_outline(root, path, value, radius, name):
    """Nodes lie on the outline; where it has a radius of curvature at least, chords are near it."""
    cells = Cells(root)
    x, y, width, height = cells.frame
    side, low = to_double(cells.side), [to_double(cells.low[k]) for k in cells.axes]
    pixel = side * cells.count[0] / width
    seen = 0
    for ring in rings(path):
        places = [(low[0] + (u - x) * pixel, low[1] + (y + height - v) * pixel) for u, v in ring]
        for (u, v), (a, b) in zip(places, places[1:] + places[:1]):
            off = abs(value(u, v))
            check(off <= NEAR * pixel, name, "node", u, v, "is off by pixels", off / pixel)
            check(math.hypot(a - u, b - v) <= math.sqrt(2) * side + 2 * NEAR * pixel, name, "a node is left out", u, v)
            chord = abs(value((u + a) / 2, (v + b) / 2))
            check(radius is None or chord <= NEAR * pixel + side**2 / (4 * radius), name, "chord", u, v, chord / pixel)
            seen += 1
    check(seen >= 30, name, "nodes", seen)
    return cells, low, side


def check_region(graze, folder, name, shape, transform, plane, value, radius, first="regular"):
    root = draw(graze, folder, shape, transform, "--plane", plane, "--grid", "30")
    paths = list(group(root, "cells").iter(SVG + "path"))
    if not check(paths and paths[0].get("class") == first, name, "regions", [p.get("class") for p in paths]):
        return
    cells, low, side = check_outline(root, paths[0], value, radius, name)
    for i in range(cells.count[0]):
        for j in range(cells.count[1]):
            off = value(low[0] + (i + .5) * side, low[1] + (j + .5) * side)
            blank = cells.colour.get((i, j), "#ffffff") == "#ffffff"
            check(blank == (off > 0) or abs(off) < 1e-9, name, "grid point", i, j, off, blank)


def check_regions(graze, folder):
    right, quarter = {"translate": ["3*t", 0, 0]}, {"rotate": {"axis": [0, 0, 1], "center": [0, 0, 0], "tan_half": "t"}}
    ball = {"ball": {"radius": 1}}
    flat = math.sqrt(8) / 3
    check_region(graze, folder, "ball", solid(folder, ball), right, "z=1/3", stadium(3, flat), flat)
    # 3 y + 4 z = 1 contains the way, is 1/5 from it, and has u = -x.
    slant = stadium(3, math.sqrt(.96))
    check_region(graze, folder, "ball, slanting", solid(folder, ball), right, "0,3,4,1", lambda u, v: slant(-u, v), .9)
    check_region(graze, folder, "ball, across", solid(folder, ball), right, "x=1", disk(1), 1)
    rod = {"cylinder": {"point": [0, 0, 0], "axis": [0, 0, 1], "radius": 1, "from": -1, "to": 1}}
    check_region(graze, folder, "cylinder", solid(folder, rod), right, "z=1/7", stadium(3, 1), 1)
    check_region(graze, folder, "cylinder, along", solid(folder, rod), right, "y=3/5", rectangle((-.8, -1), (3.8, 1)), None)
    box = {"box": {"low": [-1, -1, -1], "high": [1, 1, 1]}}
    # Each of four edges turns by a quarter about the axis, at a distance of sqrt 2.
    check_region(graze, folder, "turned box", solid(folder, box), quarter, "z=1/3", disk(math.sqrt(2)), math.sqrt(2))
    cube = os.path.join(ROOT, "tests", "refuse", "common", "cube.off")
    check_region(graze, folder, "cube", cube, right, "z=1/3", rectangle((0, 0), (5, 2)), None)
    check_region(graze, folder, "in a facet", cube, right, "z=0", rectangle((0, 0), (5, 2)), None, first="boundary")
    hole = hollow(rectangle((0, 0), (6.5, 6)), rectangle((2.5, 2), (4, 4)))
    check_region(graze, folder, "Nef polyhedron with a cavity", NEF, {"translate": ["t/2", 0, 0]}, "z=3", hole, None)


def check_middle(graze, folder):
    """Grid points at -3/2 to 3/2 by 1; of the square about the origin two that are opposite are in."""
    boxes = [{"box": {"low": [low, low, -1], "high": [high, high, 1]}} for low, high in ((-2, -.25), (.25, 2), (-.375, .375))]
    for parts, want in ((boxes[:2], 2), (boxes, 1)):
        root = draw(graze, folder, solid(folder, {"union": parts}), {"translate": [0, 0, "t"]}, "--plane", "z=1/3",
                    "--grid", "4", "--box=-2,-2,-1,2,2,2")
        got = [len(rings(path)) for path in group(root, "cells").iter(SVG + "path")]
        checks.equal(got, [want], "polygons of two squares")


def check_border(graze, folder):
    """Pictures by distance have the same contour, between in or on and out."""
    cube = os.path.join(ROOT, "tests", "refuse", "common", "cube.off")
    root = draw(graze, folder, cube, {"translate": ["3*t", 0, 0]}, "--plane", "z=1/3", "--grid", "30", "--by", "distance")
    path = next(p for p in group(root, "levels").iter(SVG + "path") if p.get("class") == "border")
    check_outline(root, path, rectangle((0, 0), (5, 2)), None, "border by distance")


def main():
    graze = options(__doc__).graze
    with tempfile.TemporaryDirectory() as folder:
        check_regions(graze, folder)
        check_middle(graze, folder)
        check_border(graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
