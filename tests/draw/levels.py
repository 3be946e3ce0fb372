#!/usr/bin/env python3
"""Pictures by distance against distances to a rectangle.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

The square [0, 1]^2 that moves by 3 along y sweeps [0, 1] x [0, 4]; outside, s is the distance to that rectangle,
inside -s is min(1/2, x, 1 - x, y, 4 - y). The colour of every cell, the border between cells of different answers and
the places of level lines follow. Lightness alone tells the bands of one side apart.
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


def corner(cells, i, j):
    """The pixel of the corner that parts (i - 1, j - 1) and (i, j) share."""
    x, y, width, height = cells.frame
    return x + i * width / cells.count[0] / cells.parts, y + height - j * height / cells.count[1] / cells.parts


def check_border(root, cells, s):
    """It runs between parts; those of a cell whose neighbours are on one side are on that side."""
    def sign(value):
        return (value > 0) - (value < 0)

    def edge(a, b):
        return tuple(sorted(tuple(round(v, 1) for v in p) for p in (a, b)))

    n, signs = cells.parts, {}
    for i, j in s:
        around = {sign(s[u, v]) for u in (i - 1, i, i + 1) for v in (j - 1, j, j + 1) if (u, v) in s}
        for u, v in [(i * n + u, j * n + v) for u in range(n) for v in range(n)]:
            signs[u, v] = sign(distance(*cells.centre(u, v, n))) if len(around) > 1 else sign(s[i, j])
    wanted = set()
    for i, j in signs:
        if i and signs[i - 1, j] != signs[i, j]:
            wanted.add(edge(corner(cells, i, j), corner(cells, i, j + 1)))
        if j and signs[i, j - 1] != signs[i, j]:
            wanted.add(edge(corner(cells, i, j), corner(cells, i + 1, j)))
    paths = [p for p in group(root, "levels").iter(SVG + "path") if p.get("class") == "border"]
    drawn = {edge(a, b) for p in paths for a, b in segments(p.get("d"))}
    checks.equal(drawn, wanted, "the border")


def check_lines(root, cells, step):
    """Level lines are where their levels are, but for a cell's side."""
    x, y, width, height = cells.frame
    seen = set()
    for path in group(root, "levels").iter(SVG + "path"):
        if path.get("class") != "level":
            continue
        for pair in segments(path.get("d")):
            for px, py in pair:
                at = (float(cells.low[0]) + (px - x) / width * cells.count[0] * float(cells.side),
                      float(cells.low[1]) + (y + height - py) / height * cells.count[1] * float(cells.side))
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
        check_border(root, cells, s)
        check_lines(root, cells, step)
        texts = {t.text for t in root.iter(SVG + "text") if t.text}
        said = {f"{float(k * step):g} to {float((k + 1) * step):g}" for k in range(-1, 3)}
        checks.holds(said <= texts and "Signed distance" in texts and "Distance to the sweep" in texts, said - texts)
        done = run(args.graze, *ask[:3], "--by", "height", "-o", path["out.svg"])
        checks.holds(done.returncode == 2 and b"--by height: expected class or distance" in done.stderr, done.stderr)
    checks.finish()


if __name__ == "__main__":
    main()
