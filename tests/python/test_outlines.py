"""Outlines: numbers that are derived in tests/outline/scenes.py, rings as polylines, the picture.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import copy
import math
import pickle
import unittest
import xml.dom.minidom
from fractions import Fraction

import graze

SQUARE = ([(0, 0), (1, 0), (1, 1), (0, 1)], [[0, 1, 2, 3]])
TURN = {"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"rotate": {"tan_half": "t"}}}]}
FRAME = ([(0, 0), (4, 0), (4, 4), (0, 4), (1, 1), (1, 3), (3, 3), (3, 1)], [[0, 1, 2, 3], [4, 5, 6, 7]])


def along(x, y):
    return {"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": [x, y]}}]}


def area(points):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:] + points[:1])) / 2


class Outlines(unittest.TestCase):
    def test_turn(self):
        """1 + pi/2; a polyline of 400 points lacks less than 10^-5."""
        outline = graze.Scene(SQUARE, TURN).outline()
        low, high = outline.area_bounds
        self.assertIsNone(outline.area)
        self.assertTrue(low <= 1 + math.pi / 2 <= high and high - low < 1e-11)
        ring, = outline.rings(400)
        self.assertTrue(0 < 1 + math.pi / 2 - area(ring.points) < 1e-5)
        self.assertEqual((ring.hole, ring.within, outline.components, outline.euler), (False, None, 1, 1))

    def test_hole(self):
        """The frame moved by 1: its hole is [2, 3] x [1, 3]."""
        outline = graze.Scene(FRAME, along("t", "0")).outline()
        self.assertEqual((outline.area, outline.holes, outline.undecided), (Fraction(18), 1, 0))
        hole, = [ring for ring in outline.rings() if ring.hole]
        self.assertEqual(area(hole.points), -2)
        self.assertFalse(outline.rings()[hole.within].hole)

    def test_picture(self):
        for motion in (TURN, along("2*t", "2*t")):
            svg = graze.Scene(SQUARE, motion).outline()._repr_svg_()
            self.assertEqual(xml.dom.minidom.parseString(svg).documentElement.tagName, "svg")

    def test_unsweep(self):
        """A side that dangles, and no area."""
        outline = graze.Scene(SQUARE, along("t", "0"), operation="unsweep").outline()
        self.assertEqual((outline.area, outline.components, outline.lower_arcs, outline.rings()), (0, 0, 1, []))

    def test_polygon(self):
        """The frame's corners are doubles, so its polygon is the outline: [0, 5] x [0, 4] without [2, 3] x [1, 3]."""
        outline = graze.Scene(FRAME, along("t", "0")).outline()
        shape = outline.to_geojson(0.5)
        (shell, hole), = shape["coordinates"]
        self.assertEqual(shape["type"], "MultiPolygon")
        self.assertEqual((area(shell[:-1]), area(hole[:-1])), (20, -2))
        self.assertTrue({(0, 0), (5, 0), (5, 4), (0, 4)} <= {tuple(p) for p in shell} and all(x in (0, 5) or y in (0, 4) for x, y in shell))
        self.assertTrue({(2, 1), (3, 1), (3, 3), (2, 3)} <= {tuple(p) for p in hole} and all(x in (2, 3) or y in (1, 3) for x, y in hole))
        for form, begins in (("wkt", "MULTIPOLYGON ((("), ("svg", "<svg "), ("vtk", "# vtk DataFile Version 3.0")):
            self.assertTrue(outline.polygon(0.5, form).startswith(begins), form)
        for within, form in ((0, "wkt"), (1, "off"), (math.inf, "wkt")):
            with self.assertRaises(graze.UseError):
                outline.polygon(within, form)
        with self.assertRaises(graze.LimitError):
            graze.Scene(SQUARE, TURN).outline().polygon(1e-20)

    def test_polygon_on_a_side(self):
        """The set is [0, 5] x [0, 4] without [2, 3] x [1, 3], area 18: corners are strictly inside or outside both rings."""
        outline = graze.Scene(FRAME, along("t", "0")).outline()
        for side, sign in (("inside", 1), ("outside", -1)):
            (shell, hole), = outline.to_geojson(0.25, side)["coordinates"]
            self.assertTrue(0 < sign * (18 - area(shell[:-1]) - area(hole[:-1])) <= 2 * 0.25 * 24, side)
            self.assertTrue(all((0 < x < 5 and 0 < y < 4) == (side == "inside") for x, y in shell), side)
            self.assertTrue(all((2 < x < 3 and 1 < y < 3) == (side == "outside") for x, y in hole), side)
        with self.assertRaises(graze.UseError):
            outline.polygon(0.25, side="left")

    def test_polygon_of_a_turn(self):
        """Radii of the far corner's arc are sqrt 2; a chord within 10^-3 of it is no nearer to the centre."""
        shape = graze.Scene(SQUARE, TURN).outline().to_geojson(1e-3)
        (shell,), = shape["coordinates"]
        radii = [math.hypot(x, y) for x, y in shell]
        self.assertTrue(abs(max(radii) - math.sqrt(2)) <= 1e-3 and abs(area(shell[:-1]) - 1 - math.pi / 2) < 4 * 1e-3 * 6.3)

    def test_samples(self):
        """Both sides of each piece, and of the seam x = 3, 1 < y < 3, points beside and on it; their pmc is decided anew."""
        scene = graze.Scene(FRAME, along("2*t", "0"))
        samples = scene.outline().samples()
        found = list(graze.pmc_names(scene.classify([s.point for s in samples])))
        self.assertEqual(found, [s.side for s in samples])
        seam = [s for s in samples if s.lower is not None]
        self.assertEqual([s.side for s in seam], ["in", "on", "in"] * (len(seam) // 3))
        self.assertTrue(seam and all(s.point[0] == 3 and 1 < s.point[1] < 3 for s in seam if s.side == "on"))
        self.assertEqual({s.arc for s in samples} - {None}, set(range(len(scene.outline().record["arcs"]))))

    def test_copies(self):
        """A copy keeps the numbers, and says why it has no polygon."""
        outline = graze.Scene(SQUARE, TURN).outline()
        for again in (copy.deepcopy(outline), pickle.loads(pickle.dumps(outline))):
            self.assertEqual((again, again.rings()), (outline, outline.rings()))
            with self.assertRaisesRegex(graze.UseError, "copied or pickled"):
                again.polygon(0.1)

    def test_refusals(self):
        with self.assertRaises(graze.UseError):
            graze.Scene(SQUARE, TURN).outline(width=1)

    def test_shapely(self):
        try:
            import shapely.geometry  # noqa: F401
        except ImportError:
            self.skipTest("shapely is not installed")
        shape = graze.Scene(FRAME, along("t", "0")).outline().to_shapely()
        self.assertEqual((shape.area, shape.is_valid), (18, True))
        exact = graze.Scene(FRAME, along("t", "0")).outline().to_shapely(within=0.5)
        self.assertEqual((exact.geom_type, exact.area, exact.is_valid), ("MultiPolygon", 18, True))
