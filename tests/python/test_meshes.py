"""Solids of other packages by what they have, the boundary of a sweep, and progress of long calls.

The classes here have what those of trimesh, meshio and shapely have, and no more.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import subprocess
import sys
import tempfile
import threading
import unittest
from collections import namedtuple
from unittest import mock

import common
import graze
from common import numpy

Trimesh = namedtuple("Trimesh", "vertices faces")
Block = namedtuple("Block", "type data")
Mesh = namedtuple("Mesh", "points cells")
Ring = namedtuple("Ring", "coords")
RISE = {"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": [0, 0, "t"]}}]}
STEP = {"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": ["2*t", 0]}}]}


class Polygon:
    geom_type = "Polygon"

    def __init__(self, exterior, *interiors):
        self.exterior, self.interiors = closed(exterior), [closed(ring) for ring in interiors]


class MultiPolygon:
    geom_type = "MultiPolygon"

    def __init__(self, *geoms):
        self.geoms = geoms


def closed(corners):
    return Ring([*corners, corners[0]])


def square(low, high):
    return [(low, low), (high, low), (high, high), (low, high)]


def triangles(quads):
    return [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


class Meshes(unittest.TestCase):
    def word(self, solid, motion, point):
        return graze.Scene(solid, motion).trace(point).word

    def test_trimesh(self):
        vertices, quads = common.CUBE
        faces = triangles(quads)
        if numpy is not None:
            vertices, faces = numpy.array(vertices, float), numpy.array(faces)
        solid = graze.Solid(Trimesh(vertices, faces))
        self.assertEqual(repr(solid), "<graze.Solid in E^3: 8 vertices, 12 facets, 1 component>")
        self.assertEqual(self.word(Trimesh(vertices, faces), RISE, (1, 1, 2)), "BI")

    def test_meshio(self):
        """Blocks by name or as pairs; lines and vertices are left out, volumes refused."""
        vertices, quads = common.CUBE
        blocks = [Block("line", [[0, 1]]), Block("quad", quads[:2]), ("triangle", triangles(quads[2:4])),
                  Block("polygon4", quads[4:]), Block("vertex", [[0]])]
        self.assertEqual(self.word(Mesh(vertices, blocks), RISE, (1, 1, 3)), "OB")
        for kind in ("tetra", "triangle6", "quad8", "hexahedron"):
            with self.assertRaisesRegex(graze.InputError, f"cells of type {kind}; expected triangles"):
                graze.Solid(Mesh(vertices, [Block(kind, [[0, 1, 2, 3]])]))

    def test_shapely(self):
        """A square with a hole, and two squares; the hole moves along with its polygon."""
        ring = Polygon(square(0, 6), square(1, 5))
        self.assertEqual(self.word(ring, STEP, (6, 3)), "BIBO")
        self.assertEqual(self.word(ring, STEP, (4, 3)), "O")
        two = MultiPolygon(Polygon(square(0, 1)), Polygon(square(4, 5)))
        self.assertEqual(self.word(two, STEP, (3, "1/2")), "OB")
        self.assertEqual(self.word(two, STEP, (6, "9/2")), "OBIB")
        self.assertEqual(graze.Solid(two).component_count, 2)
        flat = Polygon([(0, 0, 1), (1, 0, 1), (1, 1, 1)])
        with self.assertRaisesRegex(graze.InputError, "has heights; expected x and y alone"):
            graze.Solid(flat)
        line = mock.Mock(geom_type="LineString")
        with self.assertRaisesRegex(graze.InputError, "a LineString is no solid; expected a Polygon"):
            graze.Solid(line)
        with self.assertRaisesRegex(TypeError, "a mesh or polygon of trimesh, meshio or shapely"):
            graze.Solid(7)


class Boundaries(unittest.TestCase):
    def test_beside_the_program(self):
        """Vertices and faces of `graze boundary` at the same depth."""
        with tempfile.TemporaryDirectory() as folder:
            solid, motion, out = (os.path.join(folder, name) for name in ("s.wkt", "m.json", "b.ply"))
            with open(solid, "w") as file:
                file.write("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))")
            with open(motion, "w") as file:
                file.write(str(STEP).replace("'", '"'))
            done = subprocess.run([common.GRAZE, "boundary", solid, motion, "--depth", "5", "--surface", out],
                                  capture_output=True, text=True, timeout=300)
            self.assertEqual(done.returncode, 0, done.stderr)
            made = graze.Scene(solid, motion).boundary(depth=5)
            with open(out, "rb") as file:
                head = file.read().split(b"end_header")[0].decode()
        self.assertIn(f"element vertex {len(made.vertices)}\n", head)
        self.assertTrue(made.complete and made.closed)

    def test_where_it_is(self):
        """The sweep of the cube that rises by 1 is [0, 2]^2 x [0, 3]: vertices are near its sides."""
        made = graze.Scene(common.CUBE, RISE).boundary(depth=4, coarse=2)
        self.assertGreater(len(made.faces), 100)
        self.assertEqual(repr(made), f"<graze.Boundary: {len(made.vertices)} vertices, {len(made.faces)} faces>")
        for x, y, z in made.vertices:
            inside = 0 <= x <= 2 and 0 <= y <= 2 and 0 <= z <= 3
            deep = min(x, 2 - x, y, 2 - y, z, 3 - z)
            self.assertLess(abs(deep) if inside else -deep, 1e-5)
        self.assertEqual({int(v) for face in made.faces for v in face}, set(range(len(made.vertices))))
        sharp = graze.Scene(common.CUBE, RISE).boundary(depth=4, coarse=2, sharp=True)
        corners = {(x, y, z) for x in (0, 2) for y in (0, 2) for z in (0, 3)}
        self.assertLessEqual(corners, {tuple(map(float, v)) for v in sharp.vertices})
        self.assertFalse(corners <= {tuple(map(float, v)) for v in made.vertices})
        with self.assertRaises(graze.UseError):
            graze.Scene(common.CUBE, RISE).boundary(depth=99)
        cut = graze.Scene(common.CUBE, RISE).boundary(depth=3, box=((-1, -1, -1), (1, 1, 1)))
        self.assertFalse(cut.closed)
        self.assertIn(", open>", repr(cut))


class Progress(unittest.TestCase):
    POINTS = [(k / 100.0, 0.5) for k in range(1500)]

    def test_told(self):
        """Every point is told of once, in order, by one thread or several; what is raised ends the call."""
        scene = graze.Scene(common.SQUARE, STEP)
        for jobs in (1, 3):
            for call in (scene.classify, scene.rows, lambda points, **more: scene.distance(points, 0.1, **more)):
                told = []
                call(self.POINTS, jobs=jobs, progress=lambda done, total: told.append((done, total)))
                self.assertEqual(told[-1], (1500, 1500))
                self.assertEqual([done for done, _ in told], sorted({done for done, _ in told}))
                self.assertEqual(len(told), 3)

            before = threading.active_count()

            def stop(done, total):
                raise RuntimeError(f"stopped at {done}")

            with self.assertRaisesRegex(RuntimeError, "stopped at 512|stopped at 476"):
                scene.classify(self.POINTS, jobs=jobs, progress=stop)
            self.assertLessEqual(threading.active_count(), before)

    def test_bar(self):
        """With tqdm there is a bar, without it none."""
        scene = graze.Scene(common.SQUARE, STEP)
        bar = mock.Mock()
        module = mock.Mock(tqdm=mock.Mock(return_value=bar))
        with mock.patch.dict(sys.modules, {"tqdm": mock.Mock(auto=module), "tqdm.auto": module}):
            scene.classify(self.POINTS, progress=True)
        module.tqdm.assert_called_once_with(total=1500, unit="points")
        self.assertEqual([call.args for call in bar.update.call_args_list], [(512,), (512,), (476,)])
        bar.close.assert_called_once_with()
        with mock.patch.dict(sys.modules, {"tqdm": None, "tqdm.auto": None}):
            scene.classify(self.POINTS, progress=True)
