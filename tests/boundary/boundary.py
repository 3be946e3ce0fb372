#!/usr/bin/env python3
# suite
"""`graze boundary` against scenes whose sweep is a convex polygon or box known by hand.

The exact set gives every point's answer; a second refinement (second.py) gives the set of cells;
the surface must be closed, turned outwards, near the known boundary, and enclose about its volume.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from files import read_faces, read_ply, read_points, read_vtk  # noqa: E402
from harness import Checks, options  # noqa: E402
from second import Convex, box_set, cells_of  # noqa: E402

COMMON = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "refuse", "common")
checks = Checks()
check = checks.holds


class Run:
    """One run of the command with all its files."""

    def __init__(self, graze, folder, solid, motion, *options):
        path = os.path.join(folder, "motion.json")
        with open(path, "w", encoding="utf-8") as file:
            file.write(motion)
        names = {kind: os.path.join(folder, kind + ext)
                 for kind, ext in (("surface", ".ply"), ("cells", ".vtk"), ("points", ".csv"))}
        command = [graze, "boundary", solid, path, *options]
        for kind, name in names.items():
            command += ["--" + kind, name]
        done = harness.run(command, 300)
        check(done.returncode == 0, command, done.stderr)
        self.says = done.stdout
        self.points = read_points(names["points"])
        self.vertices, self.faces = read_ply(names["surface"])
        self.cell_points, self.cells = read_vtk(names["cells"])
        for name in names.values():
            with open(name, encoding="utf-8") as file:
                check("not seen" in file.read(400), name, "does not say what it can miss")

    def number(self, pattern):
        return int(re.search(pattern, self.says)[1])


def move(dimension, *entries):
    words = ", ".join(f'"{e}"' for e in entries)
    return ('{"dimension": %d, "pieces": [{"t": ["0", "1"], "transform": {"translate": [%s]}}]}'
            % (dimension, words))


def test_answers(run, truth):
    """Every point of the sample, and the counts printed."""
    counts = collections.Counter(run.points.values())
    for name in ("in", "on", "out"):
        check(run.number(rf"{name} (\d+)[,\n]") == counts[name], name, counts, run.says)
    for point, pmc in run.points.items():
        if truth.pmc(point) != pmc:
            return check(False, "pmc of", point, pmc)
    check(True)
    check(run.number(r"points: (\d+)") == len(run.points), run.says)


def test_cells(run, truth, low, high, coarse, depth):
    """The cells are those of the second refinement, and their data are right."""
    want, asked = cells_of(truth, low, high, coarse, depth)
    got = {}
    for corners, level, pmc, _ in run.cells:
        cell = [run.cell_points[k] for k in corners]
        check(len(set(cell)) == len(cell), "corners of a cell", cell)
        got[cell[0]] = level
        size = [(b - a) / 2**level for a, b in zip(low, high)]
        d = len(low)
        shape = [tuple(c + s * (k >> i & 1) for i, (c, s) in enumerate(zip(cell[0], size)))
                 for k in range(2**d)]
        check(shape == cell, "shape of a cell", cell)
        answers = {truth.pmc(p) for p in cell}
        check(pmc == ({"in": 1, "on": 2, "out": 3}[answers.pop()] if len(answers) == 1 else 0),
              "pmc of a cell", cell)
    check(got == want, "cells", len(got), len(want),
          sorted(set(got.items()) ^ set(want.items()))[:4])
    check(set(run.points) == asked, "points", len(run.points), len(asked))


def test_surface(run, truth, size, euler):
    """Closed, without a border, turned outwards, near the boundary."""
    d = len(size)
    sides = collections.Counter()
    for face in run.faces:
        if d == 2:
            sides[(face[0], 0)] += 1
            sides[(face[1], 1)] += 1
        else:
            for k in range(3):
                sides[(face[k], face[(k + 1) % 3])] += 1
    turned = {(a, 1 - b) if d == 2 else (b, a): n for (a, b), n in sides.items()}
    check(sides == turned and set(sides.values()) == {1}, "the surface is not closed")
    check("closed" in run.says, run.says)
    edges = len(sides) // 2
    check(len(run.vertices) - (len(run.faces) if d == 2 else edges - len(run.faces)) == euler,
          "Euler's number", len(run.vertices), edges, len(run.faces))
    half = sum(x * x for x in size) / 4
    far = max(truth.distance_squared(v) for v in run.vertices)
    check(far <= half, "a vertex is far from the boundary", to_double(far), to_double(half))
    volume = enclosed(run)
    wrong = F(truth.area) * F(str(to_double(half) ** 0.5 + 1e-9))
    check(abs(volume - truth.volume) <= wrong * F(3, 2), "volume", to_double(volume), truth.volume)


def enclosed(run):
    """The volume that the surface encloses, positive if it is turned outwards, by the divergence theorem."""
    total = F(0)
    for face in run.faces:
        a, *rest = [run.vertices[k] for k in face]
        if len(rest) == 1:
            (b,) = rest
            total += (a[0] * b[1] - a[1] * b[0]) / 2
        else:
            b, c = rest
            total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                      + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return total


# The square [0, 2]^2 along (4, 2): the hull of its first and last position, a hexagon.
HEXAGON = Convex([(0, 0), (2, 0), (6, 2), (6, 4), (4, 4), (0, 2)])


def scenes():
    """name, solid, motion, truth, box (low, high) or None, options, coarse, depth, Euler's number."""
    cube, square = os.path.join(COMMON, "cube.off"), os.path.join(COMMON, "square.wkt")
    plane = ([F(-1), F(-1)], [F(7), F(7)])
    space = ([F(-1)] * 3, [F(7), F(3), F(3)])
    odd = ([F(-11, 8)] * 3, [F(213, 32), F(111, 32), F(105, 32)])
    along = move(3, "4*t", "0", "0")
    yield "hexagon", square, move(2, "4*t", "2*t"), HEXAGON, plane, [], 2, 6, 0
    yield "square", square, move(2, "4*t", "0"), box_set([0, 0], [6, 2]), plane, [], 3, 5, 0
    yield "box", cube, along, box_set([0] * 3, [6, 2, 2]), space, [], 2, 4, 2
    yield "box, odd lattice", cube, along, box_set([0] * 3, [6, 2, 2]), odd, [], 1, 4, 2
    unsweep = ["--operation", "unsweep"]
    yield ("unsweep", cube, move(3, "t", "0", "0"), box_set([0] * 3, [1, 2, 2]), space, unsweep, 3,
           4, 2)
    yield ("unsweep in the plane", square, move(2, "t", "-t/2"),
           box_set([0, F(1, 2)], [1, 2]), plane, unsweep, 3, 7, 0)


def test_scenes(graze, folder):
    for name, solid, motion, truth, box, options, coarse, depth, euler in scenes():
        print("scene", name)
        corners = ",".join(str(x) for x in box[0] + box[1])
        run = Run(graze, folder, solid, motion, "--depth", str(depth), "--coarse", str(coarse),
                  "--contacts", "0", "--box", corners, *options)
        test_answers(run, truth)
        test_cells(run, truth, *box, coarse, depth)
        test_surface(run, truth, [(b - a) / 2**depth for a, b in zip(*box)], euler)


def test_default_box(graze, folder):
    """Without --box the surface is closed too; contact points add cells and take nothing away."""
    cube = os.path.join(COMMON, "cube.off")
    truth = box_set([0] * 3, [6, 2, 2])
    run = Run(graze, folder, cube, move(3, "4*t", "0", "0"), "--depth", "5", "--coarse", "2")
    test_answers(run, truth)
    low, high = ([f(p[k] for p in run.points) for k in range(3)] for f in (min, max))
    check(all(a < 0 and b > c for a, b, c in zip(low, high, (6, 2, 2))), "box", low, high)
    test_surface(run, truth, [(b - a) / 32 for a, b in zip(low, high)], 2)
    check(sum(F(1, 8**level) for _, level, _, _ in run.cells) == 1, "the cells fill the box")
    check(run.number(r"points: (\d+)") > 0 and "budget: enough" in run.says, run.says)


def test_vtk(graze, folder):
    """The surface and the points say the same as VTK."""
    for solid, motion, depth in (("cube.off", move(3, "4*t", "0", "0"), "3"),
                                 ("square.wkt", move(2, "4*t", "2*t"), "5")):
        solid = os.path.join(COMMON, solid)
        run = Run(graze, folder, solid, motion, "--depth", depth)
        names = [os.path.join(folder, name) for name in ("s.vtk", "p.vtk")]
        done = harness.run([graze, "boundary", solid, os.path.join(folder, "motion.json"), "--depth",
                            depth, "--surface", names[0], "--points", names[1]])
        check(done.returncode == 0, "boundary as VTK", done.stderr)
        d = len(run.vertices[0])
        vertices, faces, _ = read_faces(names[0], d)
        check((vertices, faces) == (run.vertices, run.faces), "surface as VTK")
        points, alone, pmc = read_faces(names[1], d)
        words = {1: "in", 2: "on", 3: "out"}
        check({p: words[k] for p, k in zip(points, pmc)} == run.points, "points as VTK")
        check(alone == [(k,) for k in range(len(points))], "vertices of VTK")


def test_nearest(graze, folder):
    """Coordinates that are no doubles are the nearest ones; past the range of doubles no file is left."""
    square, path = os.path.join(COMMON, "square.wkt"), os.path.join(folder, "p.vtk")
    run = Run(graze, folder, square, move(2, "t", "0"), "--depth", "4", "--box", "-1/3,-1/7,10/3,22/7")
    command = [graze, "boundary", square, os.path.join(folder, "motion.json"), "--depth", "4",
               "--points", path, "--box"]
    done = harness.run([*command, "-1/3,-1/7,10/3,22/7"])
    check(done.returncode == 0, "a box of thirds", done.stderr)
    points, _, _ = read_faces(path, 2)
    read = {tuple(map(to_double, p)) for p in points}
    near = {tuple(map(to_double, p)) for p in run.points}
    check(read == near, "the nearest doubles", sorted(read - near)[:3])
    check(any(F(x) != y for p in run.points for x, y in zip(map(to_double, p), p)), "no coordinate needs rounding")
    done = harness.run([*command, "-1e400,-1,1e400,1"])
    check(done.returncode == 3 and "past the range of binary64" in done.stderr, done.returncode, done.stderr)
    check(os.path.getsize(path) == 0, "the file is left empty")


def test_budget(graze, folder):
    """Spent in the midst of a level: the surface is that of a level before, and still closed."""
    square = os.path.join(COMMON, "square.wkt")
    options = ["--box", "-1,-1,7,7", "--coarse", "2", "--contacts", "0"]
    whole = Run(graze, folder, square, move(2, "4*t", "2*t"), "--depth", "9", *options)
    for budget in (25, 100, 400, 1000):
        run = Run(graze, folder, square, move(2, "4*t", "2*t"), "--depth", "9", "--budget",
                  str(budget), *options)
        check(len(run.points) <= budget, "budget", budget, len(run.points))
        check("spent before the depth" in run.says, run.says)
        level = run.number(r"surface: level (\d+)")
        check(2 <= level < 9, "level", level)
        test_answers(run, HEXAGON)
        test_surface(run, HEXAGON, [F(8, 2**level)] * 2, 0)
        check(len(run.points) < len(whole.points), "the whole has more points")


def test_thin(graze, folder):
    """A plate of 1/1000 between the lattice's planes: without contact points nothing is seen, as
    --help says; with them it is found, at the finest level at least."""
    path = os.path.join(folder, "plate.off")
    z = ("0.3001", "0.3011")
    rows = [f"{x} {y} {h}" for h in z for y in (0, 1) for x in (0, 1)]
    with open(os.path.join(COMMON, "cube.off"), encoding="utf-8") as file:
        facets = file.read().splitlines()[10:16]
    with open(path, "w", encoding="utf-8") as file:
        file.write("OFF\n8 6 0\n" + "\n".join(rows + facets) + "\n")
    options = ["--depth", "5", "--coarse", "3", "--box", "-1,-1,-1,3,3,3"]
    blind = Run(graze, folder, path, move(3, "t", "0", "0"), "--contacts", "0", *options)
    check(blind.faces == [] and set(blind.points.values()) == {"out"}, "nothing is seen")
    check(len(blind.cells) == 8**3, "only the coarse cells")
    seen = Run(graze, folder, path, move(3, "t", "0", "0"), "--contacts", "300", *options)
    missed = seen.number(r"without surface: (\d+)")
    check(missed > 0 and any(level == 5 and contact for _, level, _, contact in seen.cells),
          "contact points lead to the plate", seen.says)
    fine = ["--depth", "13", "--coarse", "3", "--box", "-1,-1,-1,3,3,3", "--budget", "60000"]
    fine = Run(graze, folder, path, move(3, "t", "0", "0"), "--contacts", "60", *fine)
    check("closed" in fine.says, fine.says)


def test_border(graze, folder):
    """A box that cuts the sweep: the surface is open, and the summary says so."""
    run = Run(graze, folder, os.path.join(COMMON, "square.wkt"), move(2, "4*t", "0"), "--depth",
              "5", "--box", "1,-1,4,1", "--contacts", "0")
    check("open at the border" in run.says, run.says)


def main():
    graze = options(__doc__).graze
    with tempfile.TemporaryDirectory() as folder:
        test_scenes(graze, folder)
        test_default_box(graze, folder)
        test_vtk(graze, folder)
        test_nearest(graze, folder)
        test_budget(graze, folder)
        test_thin(graze, folder)
        test_border(graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
