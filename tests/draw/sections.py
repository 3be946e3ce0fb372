#!/usr/bin/env python3
# suite
"""`graze draw --plane` with planes that are not the axes'.

The picture gives origin and directions of u and v in exact numbers. Origin and directions lie in the plane, are
orthogonal and of length 1 to within 2^-49; the origin is the nearest point to that of space. Each cell's centre,
computed from them, is classified by `graze classify` on its own and has the colour of its class, in bands of the
distance the colour of its side. The cells cover what the plane has of the box. A plane across an axis gives the
same file however it is written, and the same plane in other words the same cells.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from draw import COLOURS, Cells, group, run, table  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from harness import ROOT, Checks, options  # noqa: E402

CUBE = os.path.join(ROOT, "tests", "refuse", "common", "cube.off")
TURN = """{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"compose": [{"rotate": {"axis": ["0", "0", "1"],
 "center": ["0", "0", "0"], "tan_half": "s"}}, {"translate": ["3*t", "0", "t"]}]}}]}"""
checks = Checks()
check = checks.holds


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def draw(graze, motion, path, plane, *more):
    done = run(graze, "draw", CUBE, motion, "--plane", plane, "-o", path, *more)
    check(done.returncode == 0, plane, done.stderr)
    return ElementTree.parse(path).getroot()


def test_frame(cells, normal, place):
    """Origin and directions of u and v."""
    origin, u, v = cells.section
    check(dot(normal, origin) == place and dot(normal, u) == dot(normal, v) == dot(u, v) == 0, normal, "off the plane")
    check(all(abs(dot(w, w) - 1) < F(1, 2**49) for w in (u, v)), normal, "length", to_double(dot(u, u)), to_double(dot(v, v)))
    check(dot(origin, u) == dot(origin, v) == 0, normal, "the origin is not the nearest point")
    check(u[2] == 0, normal, "u is not horizontal", u)
    turn = [u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3] for k in range(3)]
    check(dot(turn, normal) > 0, normal, "u, v and the normal are left-handed")


def test_cells(graze, motion, path, plane, normal, place, *more):
    """The cells' classes, and the box: corners of the part of the plane in it are inside the cells' rectangle."""
    root = draw(graze, motion, path, plane, "--grid", "24", *more)
    cells = Cells(root)
    test_frame(cells, normal, place)
    places = [(i, j) for j in range(cells.count[1]) for i in range(cells.count[0])]
    centres = [cells.centre(*p) for p in places]
    check(all(dot(normal, c) == place for c in centres), plane, "a centre is off the plane")
    rows = table(graze, CUBE, motion, "-", text="".join(",".join(map(str, c)) + "\n" for c in centres).encode())
    check(len(rows) == len(places) >= 24 * 6, plane, "rows", len(rows))
    check(len({row["class"] for row in rows}) > 1, plane, "cells of one class only")
    distance = "distance" in more
    for spot, row in zip(places, rows):
        got = cells.colour.get(spot, "#ffffff")
        if distance:
            blue, red = int(got[5:], 16), int(got[1:3], 16)
            side = "in" if blue > red else "out" if red > blue or got == "#ffffff" else "on"
            check(row["pmc"] == "on" or side == row["pmc"], plane, spot, got, row["pmc"])
        else:
            check(got == COLOURS[row["class"]], plane, "cell", spot, got, row["class"])
    return cells, root


def test_box(graze, motion, path):
    """The diagonal plane of a box that is given: its corners are the cells' corners, to 2^-11 of the rectangle."""
    root = draw(graze, motion, path, "1,-1,0,0", "--grid", "16", "--box", "0,0,0,4,4,2")
    cells = Cells(root)
    span = [cells.side * n for n in cells.count]
    # In the plane x = y the box has the rectangle of width 4 sqrt 2 and height 2.
    length = 2**.5 * 4
    for got, want in zip(map(to_double, span), (length, 2)):
        check(want <= got <= want + 2 * to_double(cells.side) + want / 1000, "size of the rectangle", got, want)
    for corner in ((0, 0, 0), (4, 4, 0), (0, 0, 2), (4, 4, 2)):
        at = [dot(corner, w) / dot(w, w) for w in cells.section[1:]]
        check(all(low <= x <= low + s for x, low, s in zip(at, cells.low, span)), "corner", corner, at)


def test_same(graze, motion, path):
    """One plane in several forms."""
    files = []
    for plane in ("z=3/2", "0,0,1,1.5", "0,0,-2,-3", "7,7,3/2,0,0,5", "0,0,3/2,1,0,3/2,0,1,3/2"):
        draw(graze, motion, path, plane, "--grid", "12", "-p", "1,1,3/2")
        with open(path, "rb") as file:
            files.append(file.read())
    check(len(set(files)) == 1, "the plane z = 3/2 in several forms", [len(f) for f in files])
    cells = []
    for plane in ("1,2,2,4", "4,0,0,1,2,2", "4,0,0,0,2,0,2,0,1"):
        got = Cells(draw(graze, motion, path, plane, "--grid", "12"))
        cells.append((got.section, got.low, got.side, got.colour))
    check(cells[0] == cells[1] == cells[2], "the plane x + 2 y + 2 z = 4 in several forms")


def test_points(graze, motion, path):
    """The panel of the cells shows the points that lie in the plane, and only these."""
    root = draw(graze, motion, path, "1,1,1,3", "--grid", "12", "-p", "1,1,1", "-p", "1,1,1000001/1000000", "-p", "2,1,0")
    inside = [t.text for t in group(root, "classes").iter() if t.text and t.text.strip().startswith("P")]
    check(inside == ["P1", "P3"], "points in the plane", inside)
    texts = [t.text or "" for t in root.iter()]
    check(any("in the plane x + y + z = 3" in t for t in texts), "the title", texts[:6])
    check(any("u from (1, 1, 1) along (" in t for t in texts), "origin and directions", texts[:6])
    root = draw(graze, motion, path, "1/123456789012345,1,1/98765432109876543,1", "--grid", "12")
    check(any("in an oblique plane" in (t.text or "") for t in root.iter()), "a long equation")


def main():
    graze = options(__doc__).graze
    with tempfile.TemporaryDirectory() as folder:
        motion, path = os.path.join(folder, "motion.json"), os.path.join(folder, "picture.svg")
        with open(motion, "w", encoding="utf-8") as file:
            file.write(TURN)
        for normal, place in (((1, 2, -1), F(1, 2)), ((F(-3, 7), 0, F(1, 10**6)), F(-1, 3)), ((1, 1, 0), 3), ((0, -1, 5), 2)):
            plane = ",".join(map(str, (*normal, place)))
            test_cells(graze, motion, path, plane, normal, place)
        test_cells(graze, motion, path, "1,2,-1,1/2", (1, 2, -1), F(1, 2), "--by", "distance")
        test_box(graze, motion, path)
        test_same(graze, motion, path)
        test_points(graze, motion, path)
    checks.finish()


if __name__ == "__main__":
    main()
