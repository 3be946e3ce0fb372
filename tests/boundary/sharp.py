#!/usr/bin/env python3
# suite
"""`graze boundary --sharp`: edges and corners of the sweep in the surface.

The sweeps of a cube along an axis, straight and turned, are boxes whose planes, edges and corners are
known. With the lattice off the planes each face of the surface of the straight one lies in a side of the
box, so its edges are the box's, its corners vertices, and it encloses the box's volume to the last digit.
Of the turned one the share of the edges that the surface has is measured. Everywhere the surface is a
manifold, and legal for `graze check`, which looks for every crossing of two triangles.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import itertools
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from boundary import enclosed  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from files import read_ply  # noqa: E402
from harness import Checks, options  # noqa: E402
from vertices import CUBE, SCENES, SLIDE, SQUARE, motion, test_manifold  # noqa: E402

NEAR = F(1, 2**20)
checks = Checks()
check = checks.holds
# The cube turned by the angle of 3-4-5 and moved by 4 along z: |3x + 4y - 5| and |-4x + 3y - 5| at most 5, 0 <= z <= 6.
TURNED = ('{"matrix": [["3/5", "-4/5", "0", "0"], ["4/5", "3/5", "0", "0"], ["0", "0", "1", "4*t"],'
          ' ["0", "0", "0", "1"]]}')
TURNED_PLANES = [((F(3, 5), F(4, 5), F(0)), F(2)), ((F(-3, 5), F(-4, 5), F(0)), F(0)),
                 ((F(-4, 5), F(3, 5), F(0)), F(2)), ((F(4, 5), F(-3, 5), F(0)), F(0)),
                 ((F(0), F(0), F(1)), F(6)), ((F(0), F(0), F(-1)), F(0))]
STRAIGHT_PLANES = [(tuple(F(s * (i == k)) for i in range(3)), F((6, 2, 2)[k] if s > 0 else 0))
                   for k in range(3) for s in (1, -1)]


class Run:
    """The surface of one run, and the number of its last vertices that are features."""

    def __init__(self, graze, folder, solid, dimension, transform, *more):
        path = os.path.join(folder, "s.ply")
        self.motion, self.dimension, self.name = motion(folder, dimension, transform), dimension, more
        done = harness.run([graze, "boundary", solid, self.motion, "--surface", path, *more], 300)
        check(done.returncode == 0, more, done.stderr)
        self.says = done.stdout
        self.vertices, self.faces = read_ply(path)
        said = re.search(r"corners of the sweep: (\d+)", self.says)
        self.features = int(said[1]) if said else 0
        check(bool(said) == ("--sharp" in more), "features are counted with --sharp alone", self.says)


def heights(planes, point):
    """How far a point is above each plane."""
    return [sum(n * x for n, x in zip(normal, point)) - offset for normal, offset in planes]


def covered(run, planes, near):
    """The squared lengths of the surface's edges that lie in two of the planes, by pairs of planes."""
    out = {}
    flat = [{k for k, h in enumerate(heights(planes, v)) if abs(h) <= near} for v in run.vertices]
    for face in run.faces:
        for a, b in itertools.combinations(sorted(face), 2):
            for pair in itertools.combinations(sorted(flat[a] & flat[b]), 2):
                out.setdefault(pair, set()).add((a, b))
    return out


def length(run, edges):
    return sum(to_double(sum((x - y)**2 for x, y in zip(run.vertices[a], run.vertices[b])))**0.5 for a, b in edges)


def test_box(graze, folder, depth):
    """Off the lattice: all of the box, exactly."""
    run = Run(graze, folder, CUBE, 3, SLIDE, "--sharp", "--depth", depth)
    test_manifold(run)
    corners = set(itertools.product((0, 6), (0, 2), (0, 2)))
    check(corners <= set(run.vertices), "corners", corners - set(run.vertices))
    for face in run.faces:
        sides = [{k for k, h in enumerate(heights(STRAIGHT_PLANES, run.vertices[v])) if h == 0} for v in face]
        if not set.intersection(*sides):
            return check(False, "a face is in no side of the box", [tuple(map(to_double, run.vertices[v])) for v in face])
    check(enclosed(run) == 24, "volume", to_double(enclosed(run)))
    edges = covered(run, STRAIGHT_PLANES, 0)
    long = sum(length(run, e) for e in edges.values())
    check(len(edges) == 12 and abs(long - 4 * (6 + 2 + 2)) < 1e-9, "edges", len(edges), long)
    plain = Run(graze, folder, CUBE, 3, SLIDE, "--depth", depth)
    check(plain.features == 0 and enclosed(plain) < 24, "cut off without --sharp", to_double(enclosed(plain)))
    return True


def test_turned(graze, folder, depth, share, part):
    """A lattice at an angle: where an edge passes a cell's corner region unseen, it is cut off there.

    The features are on the edges, to 2^-20 of a cell; of the edges' length at least `share` is in the
    surface, and of the volume that is cut off without --sharp at most `part` is left."""
    box = [F(-17, 8), F(-5, 8), F(-5, 8), F(15, 8), F(29, 8), F(53, 8)]
    options_ = ["--box", ",".join(map(str, box)), "--contacts", "0", "--depth", depth]
    run = Run(graze, folder, CUBE, 3, TURNED, "--sharp", *options_)
    plain = Run(graze, folder, CUBE, 3, TURNED, *options_)
    test_manifold(run)
    near = NEAR * max(box[3 + k] - box[k] for k in range(3)) / 2**int(depth)
    for v in run.vertices:
        check(abs(max(heights(TURNED_PLANES, v))) <= near, "a vertex is off the boundary", tuple(map(to_double, v)))
    for v in run.vertices[-run.features:]:
        check(sum(abs(h) <= near for h in heights(TURNED_PLANES, v)) >= 2, "a feature is on no edge", v)
    edges = covered(run, TURNED_PLANES, near)
    long = sum(length(run, e) for e in edges.values()) / (8 * 2 + 4 * 6)
    lost, lost_before = (24 - to_double(enclosed(r)) for r in (run, plain))
    print(f"depth {depth}: {long:.3f} of the edges, {lost:.5f} of the volume lost, {lost_before:.5f} without --sharp")
    check(long >= share, "share of the edges", long)
    check(0 <= lost + 1e-4 and lost <= part * lost_before, "volume", lost, lost_before)


def test_diagonal(graze, folder):
    """The cube along (4, 2, 1): the sides are squares of its ends and parallelograms that its edges sweep, whose planes
    are those of support along the axes and across an axis and the way. 8 + 4 (4 + 2 + 1) is the volume."""
    way = (4, 2, 1)
    points = [tuple(2 * x + s * w for x, w in zip(bits, way)) for bits in itertools.product((0, 1), repeat=3) for s in (0, 1)]
    axes = [tuple(F(int(i == k)) for i in range(3)) for k in range(3)]
    turn = [(F(0), way[2], -way[1]), (-way[2], F(0), way[0]), (way[1], -way[0], F(0))]
    normals = [tuple(F(s * x) for x in n) for n in axes + turn for s in (1, -1)]
    planes = [(n, max(sum(a * b for a, b in zip(n, p)) for p in points)) for n in normals]
    run, plain = (Run(graze, folder, CUBE, 3, '{"translate": ["4*t", "2*t", "t"]}', "--depth", "4", "--contacts", "0", *more)
                  for more in (["--sharp"], []))
    test_manifold(run)
    near = NEAR * 7 / 2**4  # the default box is 6 + 6/8 long, and a plane's normal at most 5
    for v in run.vertices:
        check(abs(max(heights(planes, v))) <= 5 * near, "a vertex is off the boundary", tuple(map(to_double, v)))
    for v in run.vertices[-run.features:]:
        check(sum(abs(h) <= 5 * near for h in heights(planes, v)) >= 2, "a feature is on no edge", tuple(map(to_double, v)))
    lost, before = (36 - to_double(enclosed(r)) for r in (run, plain))
    print(f"diagonal: {run.features} features, {lost:.5f} of the volume lost, {before:.5f} without --sharp")
    check(run.features > 100 and -1e-4 <= lost <= .5 * before, "volume", lost, before)


def test_plane(graze, folder):
    """E^2: the square along (4, 2) sweeps a hexagon, whose six corners are vertices."""
    run = Run(graze, folder, SQUARE, 2, '{"translate": ["4*t", "2*t"]}', "--sharp", "--depth", "6")
    test_manifold(run)
    corners = {(0, 0), (2, 0), (6, 2), (6, 4), (4, 4), (0, 2)}
    check(run.features > 0 and corners <= set(run.vertices), "corners of the hexagon", corners - set(run.vertices))


def test_scenes(graze, folder):
    """Curved sweeps and unsweeps, and lattice planes in the faces, where no edge is inside a cell: legal solids."""
    for name, solid, dimension, transform, box, depth, more in SCENES:
        corners = ["--box", ",".join(map(str, box))] if name == "slide" else []
        path = os.path.join(folder, "s.stl")
        run = Run(graze, folder, solid, dimension, transform, "--sharp", "--depth", depth, *corners, *more)
        test_manifold(run)
        print(name, run.features, "features")
        smooth = name in ("slide", "unsweep in the plane")  # the latter is the disc in a square that turns
        check((run.features == 0) == smooth, name, "features", run.features)
        if dimension == 3:
            done = harness.run([graze, "boundary", solid, run.motion, "--surface", path, "--sharp", "--depth", depth,
                                *corners, *more])
            check(done.returncode == 0, name, done.stderr)
            done = harness.run([graze, "check", path, run.motion], 300)
            check(done.returncode == 0 and done.stdout.startswith("legal"), name, done.stdout, done.stderr)


def test_refused(graze):
    done = harness.run([graze, "boundary", CUBE, os.devnull, "--depth", "2", "--sharp", "--middles"])
    check(done.returncode == 2 and "--sharp" in done.stderr and "--middles" in done.stderr, done.stderr)


def main():
    given = options(__doc__)
    graze = given.graze
    with tempfile.TemporaryDirectory() as folder:
        for depth in ("3", "4"):
            test_box(graze, folder, depth)
        for depth in ("3", "4", "5")[:3 if given.scale > 1 else 2]:
            test_turned(graze, folder, depth, .9, .1)
        test_diagonal(graze, folder)
        test_plane(graze, folder)
        test_scenes(graze, folder)
        test_refused(graze)
    checks.finish()


if __name__ == "__main__":
    main()
