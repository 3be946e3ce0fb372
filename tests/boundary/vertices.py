#!/usr/bin/env python3
# suite
"""The vertices of the surface of `graze boundary`, by exact answers on both sides of each.

The lattice's edge of a vertex is found from its place. The points 2^-20 of a cell before and after it on
that edge are classified by `graze classify --no-filter`: towards one end the answer is out, towards the
other it is not. For scenes known by hand the faces are flat. A surface in STL has the triangles of that in
PLY and is a legal solid for `graze check`, which looks for every crossing of two triangles.
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
from files import read_ply, read_points  # noqa: E402
from harness import Checks, options  # noqa: E402
from second import box_set  # noqa: E402

COMMON = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "refuse", "common")
CUBE, SQUARE = os.path.join(COMMON, "cube.off"), os.path.join(COMMON, "square.wkt")
NEAR = F(1, 2**20)   # of a cell
BLUR = F(1, 2**30)   # more than rounding to binary64 moves a vertex here, of a cell
checks = Checks()
check = checks.holds


def motion(folder, dimension, transform):
    path = os.path.join(folder, "motion.json")
    with open(path, "w", encoding="utf-8") as file:
        file.write('{"dimension": %d, "pieces": [{"t": ["0", "1"], "transform": %s}]}' % (dimension, transform))
    return path


SLIDE = '{"translate": ["4*t", "0", "0"]}'
TURN = ('{"compose": [{"rotate": {"axis": ["0", "0", "1"], "center": ["0", "0", "0"], "tan_half": "s"}}, '
        '{"translate": ["3*t", "0", "t"]}]}')
TURN_2 = '{"compose": [{"rotate": {"tan_half": "s", "times": 2}}, {"translate": ["3*t", "t^2"]}]}'
# name, solid, dimension, transform, box, depth, options
SCENES = [
    ("turn", CUBE, 3, TURN, [-3, -1, -1, 6, 4, 4], 4, []),
    ("slide", CUBE, 3, SLIDE, [-1, -1, -1, 7, 3, 3], 4, []),
    ("turn in the plane", SQUARE, 2, TURN_2, [-3, -3, 7, 5], 7, []),
    ("unsweep", CUBE, 3, '{"translate": ["t", "0", "t^2/3"]}', [-1, -1, -1, 3, 3, 3], 4, ["--operation", "unsweep"]),
    ("unsweep in the plane", SQUARE, 2, '{"rotate": {"tan_half": "s", "center": ["1", "1"]}}', [-1, -1, 3, 3], 6,
     ["--operation", "unsweep"]),
]


class Surface:
    """One run: the surface in PLY, the sample, and what the program says."""

    def __init__(self, graze, folder, scene, *more):
        self.name, self.solid, self.dimension, transform, box, self.depth, self.options = scene
        self.motion = motion(folder, self.dimension, transform)
        self.low, high = [F(x) for x in box[:self.dimension]], [F(x) for x in box[self.dimension:]]
        self.cell = [(b - a) / 2**self.depth for a, b in zip(self.low, high)]
        paths = [os.path.join(folder, name) for name in ("s.ply", "p.csv")]
        done = harness.run([graze, "boundary", self.solid, self.motion, "--depth", self.depth, "--contacts", 0,
                            "--box", ",".join(map(str, box)), "--surface", paths[0], "--points", paths[1],
                            *self.options, *more], 300)
        check(done.returncode == 0, scene[0], done.stderr)
        self.says = done.stdout
        self.vertices, self.faces = read_ply(paths[0])
        self.points = read_points(paths[1])

    def edge(self, vertex):
        """The ends of the edge that holds a vertex: along the axes on which it is between two lattice planes."""
        at = [(x - a) / c for x, a, c in zip(vertex, self.low, self.cell)]
        ends = []
        for up in (0, 1):
            ends.append(tuple(F(round(x)) if abs(x - round(x)) < BLUR else F(x // 1 + up) for x in at))
        shares = {round(to_double(x - low), 7) for x, low, high in zip(at, *ends) if low != high}
        check(len(shares) == 1, self.name, "a vertex is on no edge", tuple(map(to_double, at)))
        return ends

    def place(self, lattice):
        return tuple(a + c * x for a, c, x in zip(self.low, self.cell, lattice))


def classify(graze, surface, points, folder):
    path = os.path.join(folder, "points.csv")
    with open(path, "w", encoding="utf-8") as file:
        file.write("".join(",".join(map(str, p)) + "\n" for p in points))
    done = harness.run([graze, "classify", surface.solid, surface.motion, path, "--no-filter", "--columns", "pmc",
                        *surface.options], 300)
    rows = [line for line in done.stdout.splitlines() if line and not line.startswith("#")]
    return [row.split(",")[surface.dimension] for row in rows[1:]]


def test_sides(graze, folder, surface):
    """Exact answers 2^-20 of a cell before and after each vertex on its edge."""
    asked = []
    for vertex in surface.vertices:
        ends = [surface.place(end) for end in surface.edge(vertex)]
        step = [(b - a) * (NEAR + BLUR) for a, b in zip(*ends)]
        for sign in (-1, 1):
            asked.append(tuple(x + sign * s for x, s in zip(vertex, step)))
        # A vertex next to the end of its edge: the end itself.
        for k, end in enumerate(ends):
            if max(abs(x - y) / c for x, y, c in zip(vertex, end, surface.cell)) < NEAR:
                asked[2 * (len(asked) // 2 - 1) + k] = end
    answers = classify(graze, surface, asked, folder)
    check(len(answers) == len(asked) > 0, surface.name, "rows", len(answers), len(asked))
    for k, vertex in enumerate(surface.vertices):
        pair = answers[2 * k:2 * k + 2]
        check((pair[0] == "out") != (pair[1] == "out"), surface.name, "no boundary at", tuple(map(to_double, vertex)), pair)


def test_manifold(surface):
    """Each side of a face has one other face, turned the other way; the faces at a vertex are one fan."""
    d = surface.dimension
    if d == 2:
        check(collections.Counter(f[0] for f in surface.faces) == collections.Counter(f[1] for f in surface.faces),
              surface.name, "the polygon is open")
        check(max(collections.Counter(f[0] for f in surface.faces).values()) == 1, surface.name, "a vertex of two rings")
        return
    sides = collections.Counter((f[k], f[(k + 1) % 3]) for f in surface.faces for k in range(3))
    check(set(sides.values()) == {1} and all((b, a) in sides for a, b in sides), surface.name, "the surface is open")
    fans = collections.defaultdict(dict)
    for face in surface.faces:
        for k in range(3):
            fans[face[k]][face[(k + 1) % 3]] = face[(k + 2) % 3]
    for vertex, after in fans.items():
        first = at = next(iter(after))
        count = 0
        while count == 0 or at != first:
            at, count = after[at], count + 1
        check(count == len(after), surface.name, "several fans at a vertex", vertex)
    check(len(set(surface.vertices)) == len(surface.vertices), surface.name, "two vertices in one place")


def test_middles(graze, folder):
    """--middles: each vertex is halfway between a point of the sample that is out and one that is not."""
    for scene in (SCENES[0], SCENES[2]):
        surface = Surface(graze, folder, scene, "--middles")
        for vertex in surface.vertices:
            ends = [surface.place(end) for end in surface.edge(vertex)]
            check(all(abs(2 * x - a - b) < BLUR for x, a, b in zip(vertex, *ends)), surface.name, "not halfway", vertex)
            check(sorted(surface.points[end] == "out" for end in ends) == [False, True], surface.name, ends)
        check(" 0 points classified for them" in surface.says, surface.says)


def test_flat(graze, folder):
    """A box that slides: without --box the lattice does not meet its faces, and every vertex is on them."""
    path = os.path.join(folder, "s.ply")
    slide = motion(folder, 3, SLIDE)
    done = harness.run([graze, "boundary", CUBE, slide, "--depth", 4, "--surface", path])
    vertices, _ = read_ply(path)
    truth = box_set([0] * 3, [6, 2, 2])
    on = sum(truth.pmc(v) == "on" for v in vertices)
    check(on == len(vertices) > 1000, "vertices on the faces of the box", on, len(vertices))
    said = re.search(r"vertices on the boundary: (\d+)", done.stdout)
    check(said and int(said[1]) == len(vertices), done.stdout)
    # With lattice planes in the faces, too, nothing is farther from them than 2^-20 of a cell.
    aligned = Surface(graze, folder, SCENES[1])
    far = max(truth.distance_squared(v) for v in aligned.vertices)
    check(far <= (NEAR * max(aligned.cell))**2, "a vertex is off the box", to_double(far))


def read_stl(path):
    with open(path, encoding="utf-8") as file:
        words = file.read().split("\n")
    check(words[0].startswith("solid ") and words[-2] == "endsolid", path, words[0], words[-2:])
    corners = [tuple(F(x) for x in line.split()[1:]) for line in words if line.startswith("vertex ")]
    normals = [tuple(float(x) for x in line.split()[2:]) for line in words if line.startswith("facet normal ")]
    return [tuple(corners[k:k + 3]) for k in range(0, len(corners), 3)], normals


def test_jobs(graze, folder):
    """Two threads place the vertices as one does, also those at edges and corners."""
    for scene in (SCENES[0], SCENES[2]):
        for sharp in ([], ["--sharp"]):
            one, two = (Surface(graze, folder, scene, *sharp, "--jobs", jobs) for jobs in (1, 2))
            check((one.vertices, one.faces, one.says) == (two.vertices, two.faces, two.says), one.name, "--jobs", sharp)


def test_stl(graze, folder):
    for scene in SCENES[:2]:
        surface = Surface(graze, folder, scene)
        path = os.path.join(folder, "s.stl")
        box = [str(x) for x in scene[4]]
        done = harness.run([graze, "boundary", scene[1], surface.motion, "--depth", scene[5], "--contacts", 0, "--box",
                            ",".join(box), "--surface", path])
        check(done.returncode == 0, scene[0], done.stderr)
        facets, normals = read_stl(path)
        check(facets == [tuple(surface.vertices[k] for k in face) for face in surface.faces], scene[0], "triangles")
        check(len(normals) == len(facets), scene[0], "normals", len(normals))
        for facet, normal in zip(facets, normals):
            sides = [[to_double(b - a) for a, b in zip(facet[0], facet[k])] for k in (1, 2)]
            across = [sum(x * n for x, n in zip(side, normal)) for side in sides]
            check(abs(sum(n * n for n in normal) - 1) < 1e-6 and max(map(abs, across)) < 1e-6, scene[0], normal)
        done = harness.run([graze, "check", path, surface.motion], 300)
        check(done.returncode == 0 and done.stdout.startswith("legal"), scene[0], done.stdout, done.stderr)


def main():
    graze = options(__doc__).graze
    with tempfile.TemporaryDirectory() as folder:
        for scene in SCENES:
            print("scene", scene[0])
            surface = Surface(graze, folder, scene)
            test_sides(graze, folder, surface)
            test_manifold(surface)
        test_middles(graze, folder)
        test_flat(graze, folder)
        test_stl(graze, folder)
        test_jobs(graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
