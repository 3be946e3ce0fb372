#!/usr/bin/env python3
# suite
"""Pictures of curved solids: the outline is near the surfaces, cells have the class of their centre, and cells
that are undecided are blank and counted.

A ring with the radii 1 and 2 moves by (8, 0): it sweeps the points nearer than 2 to the segment, but for the last hole. So
does a shell in space, in a plane through its centre.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

from scenes import Checks, Curved, Motion, ball, box, common, minus, options, union  # noqa: E402

RING = minus(ball((0, 0), 2), ball((0, 0), 1))
SHELL = minus(ball((0, 0, 0), 2), ball((0, 0, 0), 1))
AWAY = Motion(2, [(0, 1, {"translate": ["8*t", "0"]})])
AWAY_IN_SPACE = Motion(3, [(0, 1, {"translate": ["8*t", "0", "0"]})])
REST = Motion(2, [(0, 1, {"translate": ["0", "0"]})])
TRIPLES = [(3, 4, 5), (4, 3, 5), (5, 12, 13), (12, 5, 13), (8, 15, 17), (15, 8, 17), (7, 24, 25)]
PATH = re.compile(r'<path (?:class="(\w+)" )?fill="([^"]*)"[^>]*? d="([^"]*)"')


class Picture:
    """Cells and lines of an SVG, in the coordinates of the scene."""

    def __init__(self, text):
        self.text = text
        head = re.search(r'<g class="cells"[^>]*>', text).group()
        data = {k: v.split() for k, v in re.findall(r'data-(\w+)="([^"]*)"', head)}
        self.count = [int(x) for x in data["count"]]
        self.low = [eval_ratio(x) for x in data["low"]]
        self.side = eval_ratio(data["side"][0])
        self.frame = [float(x) for x in data["frame"]]

    def point(self, x, y):
        scale = self.side * self.count[0] / self.frame[2]
        return (self.low[0] + (x - self.frame[0]) * scale, self.low[1] + (self.frame[1] + self.frame[3] - y) * scale)

    def lines(self, marks):
        """Closed lines of the path with these marks: lists of points."""
        path = re.search(rf'<path fill="none" {marks} d="([^"]*)"', self.text).group(1)
        rings, at = [], [0, 0]
        for letter, numbers in re.findall(r"([MLHV])([-\d. ]+)", path):
            values = [float(v) for v in numbers.split()]
            at = values if letter in "ML" else [values[0], at[1]] if letter == "H" else [at[0], values[0]]
            if letter == "M":
                rings.append([])
            rings[-1].append(self.point(*at))
        return rings, path

    def cells(self):
        """(column, row) of the cells that are painted, by class; rows from below."""
        group = self.text[self.text.index('<g class="cells"'):]
        width = self.frame[2] / self.count[0]
        out = {}
        for name, _, d in PATH.findall(group[:group.index("</g>")]):
            for x, y, right, below in re.findall(r"M([\d.]+) ([\d.]+)H([\d.]+)V([\d.]+)", d):
                first, last = (round((float(v) - self.frame[0]) / width) for v in (x, right))
                top, bottom = (round((float(v) - self.frame[1]) / width) for v in (y, below))
                out.setdefault(name, set()).update(
                    (i, self.count[1] - 1 - j) for i in range(first, last) for j in range(top, bottom))
        return out

    def regions(self):
        """(column, row) of the cells whose centres lie in the closed polygons that are filled, by class."""
        group = self.text[self.text.index('<g class="cells"'):]
        out = {}
        for name, _, d in PATH.findall(group[:group.index("</g>")]):
            sides = []
            for part in d.split("M")[1:]:
                ring, at = [], [0, 0]
                for letter, numbers in re.findall(r"([MLHV])([-\d. ]+)", "M" + part):
                    values = [float(v) for v in numbers.split()]
                    at = values if letter in "ML" else [values[0], at[1]] if letter == "H" else [at[0], values[0]]
                    ring.append(self.point(*at))
                sides += zip(ring, ring[1:] + ring[:1])
            for cell in ((i, j) for i in range(self.count[0]) for j in range(self.count[1])):
                x, y = self.centre(cell)
                right = sum((b > y) != (f > y) and a + (y - b) * (e - a) / (f - b) > x for (a, b), (e, f) in sides)
                if right % 2:
                    out.setdefault(name, set()).add(cell)
        return out

    def centre(self, cell):
        return [self.low[k] + (cell[k] + .5) * self.side for k in range(2)]


def eval_ratio(text):
    up, _, down = text.partition("/")
    return int(up) / int(down or 1)


def check_outline(checks, picture, marks, x):
    rings, path = picture.lines(marks)
    checks.equal((len(rings), path.count("z")), (2, 2), marks, path[:100])
    radii = [[((a - x) ** 2 + b * b) ** .5 for a, b in ring] for ring in rings]
    checks.equal(sorted(round(max(r)) for r in radii), [1, 2], marks)
    for r in radii:
        checks.holds(max(abs(v - round(v)) for v in r) < .02 and len(r) > 200, marks, str((min(r), max(r), len(r))))


def check_cells(checks, picture, cells):
    swept = set()
    for i in range(picture.count[0]):
        for j in range(picture.count[1]):
            x, y = picture.centre((i, j))
            nearest = min(max(x, 0), 8)
            if (x - nearest) ** 2 + y * y < 4:
                swept.add((i, j))
    painted = cells.get("regular", set()) | cells.get("fold", set())
    checks.equal(len(painted ^ swept), 0, "cells", sorted(painted ^ swept)[:5])
    checks.holds(len(cells.get("fold", ())) > 10, "cells that the ring passes twice")


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        def draw(node, motion, *more):
            paths = [os.path.join(folder, name) for name in ("s.csg.json", "m.json", "out.svg")]
            for path, text in zip(paths, (Curved(motion.dimension, node).text(), motion.text())):
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
            done = subprocess.run([os.path.abspath(args.graze), "draw", *paths[:2], *more, "-o", paths[2]],
                                  capture_output=True, text=True, timeout=300)
            if not checks.equal(done.returncode, 0, done.stderr):
                return None
            with open(paths[2], encoding="utf-8") as file:
                return Picture(file.read())

        points = os.path.join(folder, "p.csv")
        with open(points, "w", encoding="utf-8") as file:
            file.write("5,1\n")
        for picture, cells in ((draw(RING, AWAY, points, "--grid", "40"), Picture.cells),
                               (draw(SHELL, AWAY_IN_SPACE, "-p", "5,1,0", "--plane", "z=0", "--grid", "40"), Picture.regions),
                               (draw(SHELL, AWAY_IN_SPACE, "-p", "5,1,0", "--plane", "0,0,3,0", "--grid", "40"), Picture.regions)):
            if picture:
                check_outline(checks, picture, 'stroke="#222222" stroke-width="2" stroke-linejoin="round"', 0)
                check_outline(checks, picture, 'stroke="#222222" stroke-width="2" stroke-linejoin="round" stroke-dasharray="5"', 8)
                check_cells(checks, picture, cells(picture))
                checks.holds("blank" not in picture.text and 'class="trajectories"' in picture.text)
                checks.holds("made for the eye" in picture.text)
        # Edges stay sharp: the section of a box has its corners.
        picture = draw(box((0, 0, 0), (3, 2, 1)), AWAY_IN_SPACE, "--plane", "z=1/2", "--grid", "9")
        if picture:
            (ring, *_), _ = picture.lines('stroke="#222222" stroke-width="2" stroke-linejoin="round"')
            for x, y in ((0, 0), (3, 0), (3, 2), (0, 2)):
                checks.holds(min(abs(a - x) + abs(b - y) for a, b in ring) < .03, "a corner", str((x, y)))
        # The origin lies on 14 circles, more than the limit allows; its cell alone is blank.
        disks = [ball((f"{s * a}/{c}", f"{b}/{c}"), 1) for a, b, c in TRIPLES for s in (1, -1)]
        many = common(*(union(a, b) for a, b in zip(disks[::2], disks[1::2])))
        picture = draw(many, REST, "--grid", "5", "--box=-1,-1,1,1", "--limit", "work=20000")
        if picture:
            checks.holds("undecided and blank: 1 " in picture.text, picture.text[:600])
            checks.holds(all((2, 2) not in cells for cells in picture.cells().values()), "a blank cell")
    checks.finish()


if __name__ == "__main__":
    main()
