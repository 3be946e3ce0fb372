#!/usr/bin/env python3
"""Pictures by distance against distances to a rectangle.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

The square [0, 1]^2 that moves by 3 along y sweeps [0, 1] x [0, 4]; outside, s is the distance to that rectangle,
inside -s is min(1/2, x, 1 - x, y, 4 - y). The colour of every cell, the border and the places of level
lines follow. Lightness alone tells the bands of one side apart.
"""
import json
import math
import os
import re
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from fractions import Fraction as F

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from draw import SVG, Cells, checks, excuse_fonts, group, options, run  # noqa: E402

LIFT = {"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": [0, "3*t"]}}]}


def distance(x, y):
    dx, dy = max(-x, x - 1, 0), max(-y, y - 4, 0)
    if dx or dy:
        return math.hypot(dx, dy)
    return -min(F(1, 2), x, 1 - x, y, 4 - y)


def nice_step(values):
    """The least of 1, 2, 5 of a power of ten by which six bands reach to the farthest value."""
    wanted = max(abs(v) for v in values) / 6
    return min(s for s in (m * F(10) ** e for e in range(-9, 9) for m in (1, 2, 5)) if s >= wanted)


def lightness(colour):
    red, green, blue = (int(colour[k:k + 2], 16) for k in (1, 3, 5))
    return .2126 * red + .7152 * green + .0722 * blue


def segments(path):
    """The straight parts of a path of M, L, H and V."""
    out, at = [], None
    for verb, numbers in re.findall(r"([MLHV])([-\d. ]+)", path):
        n = [float(v) for v in numbers.split()]
        to = (n[0], n[1]) if verb in "ML" else (n[0], at[1]) if verb == "H" else (at[0], n[0])
        if verb != "M":
            out.append((at, to))
        at = to
    return out


def palette(root):
    """Band -> colour, of the paths of cells."""
    return {path.get("class"): path.get("fill") for path in group(root, "cells").iter(SVG + "path")}


def check_colours(root, cells, s, step):
    colours = palette(root)
    for side in ("inner", "outer"):
        shades = [lightness(colours[f"{side}-{k}"]) for k in range(1, 7) if f"{side}-{k}" in colours]
        checks.holds(len(shades) > 1 and all(a > b + 15 for a, b in zip(shades, shades[1:])), side, shades)
    doubtful = 0
    for place, value in s.items():
        got = cells.colour[place]
        if value == 0:
            checks.equal(got, colours["on"], "on", place)
            continue
        side, size = "inner" if value < 0 else "outer", abs(value) / step
        near = abs(size - round(size)) * step < cells.side / 32
        doubtful += near
        names = {min(5, int(size))} if not near else {min(5, max(0, round(size) - 1)), min(5, round(size))}
        checks.holds(got in {colours.get(f"{side}-{k + 1}") for k in names}, place, float(value), got)
    checks.holds(doubtful < len(s) / 5, "cells at the border of bands", doubtful)


def check_parts(root, cells):
    """Parts that differ from their cells have the colour of their own side."""
    names = {path.get("fill"): path.get("class")[:2] for path in group(root, "parts").iter(SVG + "path")}
    checks.holds(cells.parts > 1 and len(cells.part) > 100, "parts", cells.parts, len(cells.part))
    for place, colour in cells.part.items():
        value = distance(*cells.centre(*place, cells.parts))
        checks.equal(names[colour], "in" if value < 0 else "ou" if value else "on", "part", place)


def place_at(cells, px, py):
    """The point of a pixel, and the distance in cells of the pixel from the frame, less half a cell."""
    x, y, width, height = cells.frame
    i, j = (px - x) / width * cells.count[0], (y + height - py) / height * cells.count[1]
    inside = min(i, j, cells.count[0] - i, cells.count[1] - j) - .5
    return (float(cells.low[0]) + i * float(cells.side), float(cells.low[1]) + j * float(cells.side)), inside


def check_border(root, cells):
    """Its nodes lie on the rectangle, to a 64th of a pixel and two decimals of SVG."""
    pixel = float(cells.side) * cells.count[0] / cells.frame[2]
    paths = [p for p in group(root, "levels").iter(SVG + "path") if p.get("class") == "border"]
    nodes = [place_at(cells, *at)[0] for path in paths for pair in segments(path.get("d")) for at in pair]
    checks.holds(len(paths) == 1 and len(nodes) > 100, "the border", len(paths), len(nodes))
    for node in nodes:
        checks.holds(abs(float(distance(*node))) <= pixel * (1 / 64 + .0072), "node", node)


def check_lines(root, cells, step):
    """Level lines are where their levels are, but for a cell's side."""
    seen = set()
    for path in group(root, "levels").iter(SVG + "path"):
        if path.get("class") != "level":
            continue
        for pair in segments(path.get("d")):
            for px, py in pair:
                at, inside = place_at(cells, px, py)
                if inside < -1e-3:  # a line goes straight on to the frame
                    continue
                level = round(float(distance(*at)) / float(step))
                seen.add(level)
                off = abs(float(distance(*at)) - level * float(step))
                checks.holds(level and off <= float(cells.side) / 4, at, off)
    checks.holds({1, 2, -1} <= seen, "levels", seen)


def main():
    args = options(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        excuse_fonts(folder)
        path = {name: os.path.join(folder, name) for name in ("square.wkt", "lift.json", "out.svg", "out.png")}
        with open(path["square.wkt"], "w", encoding="utf-8") as f:
            f.write("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n")
        with open(path["lift.json"], "w", encoding="utf-8") as f:
            json.dump(LIFT, f)
        ask = ["draw", path["square.wkt"], path["lift.json"], "--by", "distance", "--grid", "56", "--box=-15/16,-1,49/16,6"]
        for out in ("out.svg", "out.png"):
            done = run(args.graze, *ask, "-o", path[out])
            checks.equal(done.returncode, 0, out, done.stderr.decode())
        root = ElementTree.parse(path["out.svg"]).getroot()
        cells = Cells(root)
        s = {(i, j): distance(*cells.centre(i, j)) for j in range(cells.count[1]) for i in range(cells.count[0])}
        step = nice_step(s.values())
        checks.holds(any(v == 0 for v in s.values()), "centres on the boundary are drawn too")
        check_colours(root, cells, s, step)
        check_parts(root, cells)
        check_border(root, cells)
        check_lines(root, cells, step)
        texts = {t.text for t in root.iter(SVG + "text") if t.text}
        said = {f"{float(k * step):g} to {float((k + 1) * step):g}" for k in range(-1, 3)}
        checks.holds(said <= texts and "Signed distance" in texts and "Distance to the sweep" in texts, said - texts)
        done = run(args.graze, *ask[:3], "--by", "height", "-o", path["out.svg"])
        checks.holds(done.returncode == 2 and b"--by height: expected class or distance" in done.stderr, done.stderr)
    checks.finish()


if __name__ == "__main__":
    main()
