#!/usr/bin/env python3
"""Marks, arrowheads, legend and colours of pictures, and pages of PDF.

SPDX-License-Identifier: GPL-3.0-or-later

Scenes are a U and a square that move along x, so that places of contacts and their cells are read off. An arrowhead keeps
clear of every mark, in pictures of the cases too. A row of the legend has a trace in the picture, and a trace a row. Colours of
classes are compared as people without green or red cones see them. Names keep off scale bars.
"""
import itertools
import json
import math
import os
import re
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from draw import COLOURS, SVG, check, check_texts, checks, excuse_fonts, files, group, rings, run, text_box  # noqa: E402
from harness import options  # noqa: E402

SLIDE, HOLLOW, FULL = ("#cc79a7", "#222222"), ("#ffffff", "#d55e00"), ("#222222", "#ffffff")
U = "0 0, 4 0, 4 3, 3 3, 3 1, 1 1, 1 3, 0 3, 0 0"
SQUARE = "0 0, 1 0, 1 1, 0 1, 0 0"
NUMBER = re.compile(r"-?[\d.]+")


def draw(graze, folder, ring, way, *more, kind="svg"):
    """The file of a picture of a polygon that moves along x."""
    paths = [os.path.join(folder, name) for name in ("s.wkt", "m.json", "out." + kind)]
    with open(paths[0], "w", encoding="utf-8") as file:
        file.write(f"POLYGON (({ring}))")
    with open(paths[1], "w", encoding="utf-8") as file:
        json.dump({"dimension": 2, "pieces": [{"t": ["0", "1"], "transform": {"translate": [way, "0"]}}]}, file)
    done = run(graze, "draw", *paths[:2], "--grid", "12", *more, "-o", paths[2])
    check(done.returncode == 0, ring, way, more, done.stderr.decode())
    return paths[2]


def nodes(path):
    """The corners of a path as SVG writes it, with H and V."""
    x, y, out = 0.0, 0.0, []
    for verb, rest in re.findall(r"([MLHV])([^MLHVz]*)", path.get("d")):
        numbers = [float(n) for n in NUMBER.findall(rest)]
        x, y = numbers if verb in "ML" else (numbers[0], y) if verb == "H" else (x, numbers[0])
        out.append((x, y))
    return out


class Sign:
    """A mark of a contact or of the end of a slide: its shape, its paints and its middle."""

    def __init__(self, element):
        self.paints = element.get("fill"), element.get("stroke")
        if element.tag == SVG + "circle":
            self.shape, self.radius = "circle", float(element.get("r"))
            self.at = float(element.get("cx")), float(element.get("cy"))
            return
        corners = nodes(element)
        self.shape = {3: "triangle", 4: "square"}[len(corners)]
        xs, ys = zip(*corners)
        self.radius = (max(xs) - min(xs)) / 2
        # A triangle stands with 5.4 of its 8.8 units of height above its place.
        share = .5 if self.shape == "square" else 5.4 / 8.8
        self.at = (min(xs) + max(xs)) / 2, min(ys) + share * (max(ys) - min(ys))


def signs(panel):
    """Marks of a panel; a disk where a trajectory begins has the paints of its class and is among them."""
    return [Sign(e) for e in panel if e.tag == SVG + "circle"
            or e.tag == SVG + "path" and (e.get("fill"), e.get("stroke")) in (SLIDE, HOLLOW, FULL)]


def heads(panel):
    """Arrowheads: filled triangles without a rim."""
    return [nodes(e) for e in panel.iter(SVG + "path") if e.get("fill") == "#222222" and not e.get("stroke") and len(nodes(e)) == 3]


def legend(root):
    return [t.text for t in group(root, "legend").iter(SVG + "text")]


def check_slides(graze, folder):
    """(6, 3) slides along the tops of the U, from x = 4 to 3 and from 1 to 0; (6, 1) along the floor within, from 3 to 1, and crosses
    the outer sides at 4 and 0. At all ends of slides there is a vertex."""
    for point, middles, ends, full in (("6,3", [3.5, .5], [4, 3, 1, 0], []), ("6,1", [2], [3, 1], [4, 0])):
        root = ElementTree.parse(draw(graze, folder, U, "8*t", "-p", point)).getroot()
        panel = group(root, "trajectories")
        found, start = signs(panel), next(s for s in signs(panel) if s.radius == 8)
        small = [s for s in found if s.paints == SLIDE]
        hollow = [s for s in found if s.paints == HOLLOW]
        crossed = [s for s in found if s.paints == FULL]
        check([s.shape for s in small] == ["triangle"] * len(ends), point, "ends of slides", [s.shape for s in small])
        check([s.shape for s in hollow] == ["square"] * len(middles), point, "insides of slides", [s.shape for s in hollow])
        check([s.shape for s in crossed] == ["square"] * len(full), point, "crossings", [s.shape for s in crossed])
        # Pixels from the beginning at x = 6 to the left, in units of the width of one slide's ends.
        unit = abs(small[0].at[0] - small[1].at[0]) / abs(ends[0] - ends[1])
        for name, some, want in (("ends", small, ends), ("insides", hollow, middles), ("crossings", crossed, full)):
            got = sorted(6 - (start.at[0] - s.at[0]) / unit for s in some)
            check(all(abs(a - b) < .05 for a, b in zip(got, sorted(want))) and len(got) == len(want), point, name, got, want)
            check(all(abs(s.at[1] - start.at[1]) < .1 for s in some), point, name, "beside the line")
        rows = legend(root)
        check("tangency, edge" in rows and "tangency, vertex" not in rows and "end of a slide, vertex" in rows, point, rows)


def check_slide_of_half(graze, folder):
    """(1/2, 1) begins in the middle of the square's upper edge and slides to its corner (0, 1)."""
    root = ElementTree.parse(draw(graze, folder, SQUARE, "1/2*t", "-p", "1/2,1")).getroot()
    small = [s for s in signs(group(root, "trajectories")) if s.paints == SLIDE]
    check(sorted(s.shape for s in small) == ["square", "triangle"], "ends", [s.shape for s in small])
    right, left = sorted(small, key=lambda s: -s.at[0])
    check((right.shape, left.shape) == ("square", "triangle"), "the vertex is on the left", right.shape, left.shape)
    rows = legend(root)
    check({"end of a slide, edge", "end of a slide, vertex", "tangency, edge"} <= set(rows), rows)


def check_arrowheads(root, name, least):
    panel = group(root, "trajectories")
    marks, found = signs(panel), heads(panel)
    check(len(found) >= least, name, "arrowheads", len(found))
    for head in found:
        for s in marks:
            near = min(math.dist(s.at, (a[0] + (b[0] - a[0]) * k / 8, a[1] + (b[1] - a[1]) * k / 8))
                       for a, b in itertools.combinations(head, 2) for k in range(9))
            check(near > s.radius, name, "an arrowhead under a mark", head, s.at)
    for a, b in itertools.combinations(found, 2):
        check(min(math.dist(p, q) for p in a for q in b) > .5, name, "arrowheads on one another", a, b)


def check_legend(graze, folder):
    """Rows of the legend, with and without what they explain."""
    far, near = ("-p", "6,4"), ("-p", "6,1")
    sliding, inside, ends = "sliding on S", "inside S", ("at the start", "between", "at the end")
    for more, there, missing in (
            ((*near, "--times", "2"), ("at the start", "at the end", sliding, inside, "outside S"), ("between",)),
            (near, ends, ("plane of the cells",)),
            (far, ("outside S",), (inside, sliding, "Contacts", "boundary", "fold_boundary")),
            ((*near, "--box=5,0,7,1/2"), ("between", inside, "regular"), ("at the start", "at the end", "exterior", "fold")),
            (("--box=6,5,7,6",), ("exterior",), (*ends, "Positions of S", "Trajectories", "regular")),
            (("--by", "distance"), ("at the start", "at the end"), ("between",))):
        rows = legend(ElementTree.parse(draw(graze, folder, U, "8*t", *more)).getroot())
        check(set(there) <= set(rows), more, "missing rows", set(there) - set(rows))
        check(not set(missing) & set(rows), more, "rows without a trace", set(missing) & set(rows))
    solid, motion, _ = files("bracket")
    for plane, there, missing in (("z=3", ("at the start", "plane of the cells"), ()),
                                  # The bracket turns in z from 1 up and ends above: its last place is cut by no plane below 2.
                                  ("z=9/4", ("at the start", "at the end"), ()), ("z=1/2", ("at the start",), ("at the end",))):
        path = os.path.join(folder, "plane.svg")
        run(graze, "draw", solid, motion, "--plane", plane, "--grid", "12", "-o", path)
        rows = legend(ElementTree.parse(path).getroot())
        check(set(there) <= set(rows) and not set(missing) & set(rows), plane, rows)


# Machado, Oliveira and Fernandes, "A physiologically-based model for simulation of color vision deficiency", IEEE Transactions on
# Visualization and Computer Graphics 15 (2009), 1291-1298: severity 1, for linear RGB.
BLIND = {"deuteranopia": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
         "protanopia": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]}
# Linear sRGB to XYZ under D65 (IEC 61966-2-1), the white that the rows add up to.
XYZ = [[.4124564, .3575761, .1804375], [.2126729, .7151522, .0721750], [.0193339, .1191920, .9503041]]


def lab(linear):
    """CIE L*a*b* of a linear RGB colour."""
    def curve(x):
        return x ** (1 / 3) if x > 216 / 24389 else (24389 / 27 * x + 16) / 116
    x, y, z = (curve(sum(a * b for a, b in zip(row, linear)) / sum(row)) for row in XYZ)
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def seen(colour, matrix):
    linear = [x / 12.92 if x <= .04045 else ((x + .055) / 1.055) ** 2.4 for x in (int(colour[k:k + 2], 16) / 255 for k in (1, 3, 5))]
    return lab([min(1, max(0, sum(a * b for a, b in zip(row, linear)))) for row in matrix])


def check_colours():
    """Any two classes are 30 units of L*a*b* apart, thirteen times what is just noticed; and regular and fold_boundary, which meet at
    borders, have hues on both sides: blue, and yellow or green."""
    classes = [name for name in COLOURS if name not in ("in", "on", "out")]
    one = [[float(i == j) for j in range(3)] for i in range(3)]
    white = seen("#ffffff", one)
    check(max(abs(a - b) for a, b in zip(white, (100, 0, 0))) < .1, "white", white)
    for name, matrix in (("all cones", one), *BLIND.items()):
        there = {c: seen(COLOURS[c], matrix) for c in classes}
        for a, b in itertools.combinations(classes, 2):
            if {a, b} != {"fold", "boundary"}:
                check(math.dist(there[a], there[b]) > 30, name, a, b, math.dist(there[a], there[b]))
        # Orange and vermilion are of one hue without red or green cones; their lightness differs.
        check(abs(there["fold"][0] - there["boundary"][0]) > 14, name, "fold and boundary", there["fold"], there["boundary"])
        hue = [math.degrees(math.atan2(there[c][2], there[c][1])) for c in ("regular", "fold_boundary")]
        apart = abs((hue[0] - hue[1] + 180) % 360 - 180)
        check(apart > 80, name, "hues of regular and fold_boundary", hue)
        check(all(math.hypot(*there[c][1:]) > 8 for c in ("regular", "fold_boundary")), name, "a grey has no hue", there)


def check_planes(graze, folder):
    solid, motion, _ = files("bracket")
    for plane, want in (("z=2263/2048", "z = 2263/2048 ≈ 1.10498"), ("z=3", "z = 3"), ("x=3.5", "x = 7/2 = 3.5"), ("y=-1/3", "y = -1/3 ≈ -0.333333")):
        path = os.path.join(folder, "plane.svg")
        run(graze, "draw", solid, motion, "--plane", plane, "--grid", "6", "-o", path)
        texts = [t.text for t in ElementTree.parse(path).getroot().iter(SVG + "text")]
        check(f"The sweep by class in the plane {want}" in texts, plane, texts)


def check_pdf(graze, folder):
    """One page of the size of the SVG, 72 points to 96 pixels, alike each time."""
    root = ElementTree.parse(draw(graze, folder, U, "8*t", "-p", "6,1")).getroot()
    made = []
    for _ in range(2):
        with open(draw(graze, folder, U, "8*t", "-p", "6,1", kind="pdf"), "rb") as file:
            made.append(file.read())
    done = run(graze, "draw", os.path.join(folder, "s.wkt"), os.path.join(folder, "m.json"), "--grid", "12", "-p", "6,1", "-o", "-", "--format", "pdf")
    check(made[0] == made[1] and b"CreationDate" not in made[0], "two pages of one scene differ")
    check(len(done.stdout) == len(made[0]) and done.stdout.startswith(b"%PDF-"), "a page on standard output", len(done.stdout))
    box = re.search(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", made[0])
    check(made[0].startswith(b"%PDF-") and made[0].rstrip().endswith(b"%%EOF") and box, "a page", made[0][:20])
    check(box and [float(n) for n in box.groups()] == [.75 * float(root.get(side)) for side in ("width", "height")], "size", box)


def check_scale_bar(graze, folder):
    """Names of a crowded picture keep off scale bars and their numbers."""
    path = os.path.join(folder, "crowded.svg")
    run(graze, "draw", *files("curved-plate-hole"), "--grid", "12", "-o", path)
    root = ElementTree.parse(path).getroot()
    check_texts(root, "crowded")
    bars = [[xy for ring in rings(p) for xy in ring] for p in root.iter(SVG + "path") if p.get("class") == "scale"]
    check(len(bars) == 2, "scale bars", len(bars))
    for bar in bars:
        (u0, u1), (v0, v1) = ((min(a), max(a)) for a in zip(*bar))
        for text in root.iter(SVG + "text"):
            x0, y0, x1, y1 = text_box(text)
            check(x1 <= u0 or u1 <= x0 or y1 <= v0 or v1 <= y0, repr(text.text), "covers a scale bar")


def main():
    args = options(__doc__)
    graze = args.graze
    with tempfile.TemporaryDirectory() as folder:
        excuse_fonts(folder)
        check_slides(graze, folder)
        check_slide_of_half(graze, folder)
        check_legend(graze, folder)
        check_colours()
        check_planes(graze, folder)
        check_pdf(graze, folder)
        check_scale_bar(graze, folder)
        for point in ("6,1/2", "6,1", "6,2", "6,3", "6,4"):
            check_arrowheads(ElementTree.parse(draw(graze, folder, U, "8*t", "-p", point)).getroot(), point, 1)
        for name, least in (("figures-5-7-8", 18), ("figure4", 5), ("bracket", 20), ("disk-offset", 5)):
            path = os.path.join(folder, name + ".svg")
            check(run(graze, "draw", *files(name), "--grid", "12", "-o", path).returncode == 0, name)
            check_arrowheads(ElementTree.parse(path).getroot(), name, least)
    checks.finish()


if __name__ == "__main__":
    main()
