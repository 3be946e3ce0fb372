"""Outlines: numbers that are derived in tests/outline/scenes.py, rings as polylines, the picture.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
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
