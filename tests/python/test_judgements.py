"""Meshes against the sweep of a cube, a box: distances and volumes derived here.

The cube [0, 2]^3 moved by 8 along x sweeps [0, 10] x [0, 2]^2. A box that ends at x = 9 has the middle of that face 1
inside, and the corners of x = 10 are 1 from it; one that ends at 11 has that face 1 outside.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import inspect
import os
import tempfile
import unittest
from fractions import Fraction

import common
import graze

FACES = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
         (1, 3, 7), (1, 7, 5)]
MOTION = {"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["8*t", "0", "0"]}}]}


def corners(end):
    return [(x, y, z) for z in (0, 2) for y in (0, 2) for x in (0, end)]


class Judgements(unittest.TestCase):
    def setUp(self):
        self.scene = graze.Scene(graze.Solid((corners(2), FACES)), MOTION)

    def holds(self, found, true):
        self.assertTrue(found.reached)
        self.assertLessEqual(found.low, true)
        self.assertLessEqual(true, found.high)
        self.assertLessEqual(found.high - found.low, 0.5)

    def test_short(self):
        found = self.scene.judge(corners(9), FACES, within=0.5)
        self.holds(found.outside, 0)
        self.holds(found.inside, 1)
        self.holds(found.sweep, 1)
        self.assertAlmostEqual(found.inside.at[0], 9)
        self.assertAlmostEqual(found.inside.t, 1)
        self.assertEqual((found.outside.at, found.outside.t), (None, None))
        self.assertLessEqual(found.volume[0], 40)
        self.assertLessEqual(40, found.volume[1])
        self.assertEqual(found.mesh_volume, Fraction(36))
        self.assertEqual(found.windings, (0, 1))
        self.assertTrue(found.missing[0] <= 4 <= found.missing[1] and found.excess[0] == 0)  # [9, 10] x [0, 2]^2
        self.assertTrue(found.closed and found.oriented and found.reached)
        self.assertEqual(found.report["confusion"]["rows"], 1000)
        self.assertEqual(str(found), found.text)

    def test_open(self):
        found = self.scene.judge(corners(11), FACES[:-1], within="0.1r", points=7)
        self.holds(found.outside, 1)
        self.assertFalse(found.closed or found.oriented)
        self.assertIsNone(found.mesh_volume)
        self.assertEqual((found.windings, found.missing, found.excess), (None, None, None))
        self.assertIsNone(found.report["confusion"])

    def test_misuse(self):
        for arguments, word in (({"budget": -1}, "budget"), ({"budget": 2 ** 64}, "budget"), ({"points": -1}, "points"), ({"points": 2 ** 40}, "points"),
                                ({"seed": -1}, "seed"), ({"seed": 2 ** 64}, "seed"), ({"seed": 0.5}, "seed")):
            with self.assertRaisesRegex(graze.UseError, word + " is .*; expected an integer"):
                self.scene.judge(corners(9), FACES, within=0.5, **arguments)
        with self.assertRaisesRegex(graze.UseError, "face 0 is"):
            self.scene.judge(corners(9), [[0.5, 1, 2]])
        with self.assertRaisesRegex(graze.UseError, "without faces"):
            self.scene.judge(corners(9))

    @unittest.skipIf(common.numpy is None, "numpy")
    def test_misuse_of_arrays(self):
        with self.assertRaisesRegex(graze.UseError, "vertex: an array of complex128; expected one of real numbers"):
            self.scene.judge(common.numpy.array(corners(9)) * 1j, FACES)
        hidden = common.numpy.ma.masked_equal(common.numpy.array(corners(9)), 9)
        with self.assertRaisesRegex(graze.InputError, "mask"):
            self.scene.judge(hidden, FACES)
        with self.assertRaisesRegex(graze.UseError, "face: an array of float64; expected one of integers"):
            self.scene.judge(corners(9), common.numpy.array(FACES) * 1.0)

    def test_budget(self):
        found = self.scene.judge(corners(9), FACES, within=1e-3, budget=50, points=0)
        self.assertFalse(found.reached)
        self.assertLessEqual(found.inside.low, 1)
        self.assertLessEqual(1, found.inside.high)
        self.assertIsNotNone(found.inside.open)

    def test_empty(self):
        found = self.scene.judge([], [], within="1e-1r")  # a finer width, as without it, takes a hundred times as long
        self.assertEqual(inspect.signature(self.scene.judge).parameters["within"].default, "1e-2r")
        self.assertIsNone(found.sweep)
        self.assertEqual((found.outside.high, found.inside.high), (0, 0))

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mesh.off")
            with open(path, "w", encoding="utf-8") as file:
                file.write("OFF\n8 12 0\n" + "".join("%d %d %d\n" % p for p in corners(11)) +
                           "".join("3 %d %d %d\n" % f for f in FACES))
            self.holds(self.scene.judge(path, within=0.5, points=0).outside, 1)
            self.assertRaises(graze.MachineError, self.scene.judge, os.path.join(folder, "none.off"))

    @unittest.skipIf(common.numpy is None, "numpy")
    def test_numpy(self):
        places, faces = common.numpy.array(corners(11), float), common.numpy.array(FACES)
        self.holds(self.scene.judge(places, faces, within=0.5, points=0).outside, 1)
        self.assertRaises(graze.UseError, self.scene.judge, places[:, :2], faces)
        self.assertRaises(graze.UseError, self.scene.judge, places, -faces)

    def test_refused(self):
        self.assertRaises(graze.UseError, self.scene.judge, [(0, 0)], FACES)
        self.assertRaises(graze.UseError, self.scene.judge, corners(9), [(0, 1)])
        self.assertRaises(graze.InputError, self.scene.judge, corners(9), [(0, 1, 8)])
        self.assertRaises(graze.InputError, self.scene.judge, [(float("nan"), 0, 0)], [])
        self.assertRaises(graze.UseError, self.scene.judge, corners(9), FACES, within=0)
        plane = graze.Scene(common.SQUARE, common.moved("t", "0"))
        self.assertRaises(graze.IllegalError, plane.judge, corners(9), FACES)
