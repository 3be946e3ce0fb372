"""Solids that do not move: `Solid.contains`, and scenes without a motion.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import subprocess
import tempfile
import unittest
from fractions import Fraction as F

import common
import graze
from common import numpy
from graze import Pmc

# Points and where they are in the cube [0, 2]^3.
POINTS = [((1, 1, 1), Pmc.IN), ((2, F(1, 3), 1), Pmc.ON), ((0, 0, 2), Pmc.ON), ((3, 1, 1), Pmc.OUT), ((1, 1, "2.000000000000000000001"), Pmc.OUT)]
# Where the surface of degree 4 meets its tangent plane no rule decides the origin.
FLAT = {"dimension": 3, "solid": {"difference": [{"polynomial": {"0,0,1": 1, "4,0,0": 1, "0,4,0": 1, "2,2,0": -1}},
                                                {"halfspace": {"normal": [0, 0, 1], "offset": 0}}]}}


class Rest(unittest.TestCase):
    def test_contains(self):
        cube, points = graze.Solid(common.CUBE), [p for p, _ in POINTS]
        closed, inside = cube.contains(points), cube.contains(points, boundary=False)
        self.assertEqual(list(closed), [True, True, True, False, False])
        self.assertEqual(list(inside), [True, False, False, False, False])
        ball = graze.Solid.ball(5)
        self.assertEqual(list(ball.contains([(3, 4, 0), (3, 4, "1e-30"), (0, 0, 5)])), [True, False, True])
        self.assertEqual(list(ball.contains([])), [])
        with self.assertRaisesRegex(graze.InputError, "point 1"):
            cube.contains([(0.0, 0.0, 0.0), (0.0, float("nan"), 0.0)])
        # The nearest float of binary32 to 2 + 2^-30 is 2.
        self.assertEqual(list(graze.Solid(common.CUBE, round="binary32").contains([("2.000000001", 1, 1)])), [True])

    def test_arrays(self):
        if numpy is None:
            self.skipTest("numpy")
        given = numpy.array([[1.0, 1, 1], [2, 1, 1], [3, 1, 1]] * 700)
        for jobs in (1, 2):
            found = graze.Solid(common.CUBE).contains(given, jobs=jobs)
            self.assertEqual((found.dtype, found.shape, found.tolist()), (numpy.dtype(bool), (2100,), [True, True, False] * 700))

    def test_undecided(self):
        solid = graze.Solid(FLAT)
        with self.assertRaisesRegex(graze.GrazeError, "^point 1: whether it is in the solid is not decided$"):
            solid.contains([(0, 0, 1), (0, 0, 0)])
        answers = graze.Scene(solid, None).classify([(0, 0, 1), (0, 0, 0)])
        self.assertEqual([answer["pmc"] if numpy is not None else answer.pmc for answer in answers], [Pmc.OUT, Pmc.UNDECIDED])

    def test_scene(self):
        """Verdicts, distances, a grid, rows and the table of the program."""
        scene = graze.Scene(common.CUBE, None, sdf="1e-9")
        self.assertIn("at rest", repr(scene))
        self.assertIsNone(scene.motion)
        points = [p for p, _ in POINTS]
        self.assertEqual([Pmc(int(v["pmc"] if numpy is not None else v.pmc)) for v in scene.classify(points)], [pmc for _, pmc in POINTS])
        one = scene.distance([(1, 1, 1)], 1e-9)[0]
        self.assertTrue((one["low"] if numpy is not None else one.low) <= -1 <= (one["high"] if numpy is not None else one.high))
        grid = graze.Scene(common.CUBE, None).grid((3, 3, 3))
        flat = list(grid if numpy is None else grid.flatten(order="F"))
        self.assertEqual((flat.count(Pmc.ON), flat.count(Pmc.IN)), (26, 1))
        self.assertEqual(scene.rows([(2, 1, 1)], format="jsonl"), ['{"point":["2","1","1"],"pmc":"on","sdf_low":0,"sdf_high":0}'])
        with tempfile.TemporaryDirectory() as folder:
            with open(folder + "/p.csv", "w", encoding="utf-8") as file:
                file.writelines(",".join(map(str, p)) + "\n" for p in points)
            with open(folder + "/c.off", "w", encoding="utf-8") as file:
                file.write("OFF\n8 6 0\n" + "".join("%d %d %d\n" % p for p in common.CUBE[0]) + "".join("4 %d %d %d %d\n" % f for f in common.CUBE[1]))
            done = subprocess.run([common.GRAZE, "classify", folder + "/c.off", folder + "/p.csv", "--at-rest", "--sdf", "1e-9", "--coordinates", "exact"],
                                  capture_output=True, text=True, check=True)
        mine = [line for line in scene.table(points).splitlines() if not line.startswith("# solid-sha256")]
        self.assertEqual(mine, [line for line in done.stdout.splitlines() if not line.startswith("# solid-sha256")])

    def test_refused(self):
        for more in ({"topo": True}, {"moments": True}, {"regular": True}, {"sdf": 1, "boundary_distance": True}, {"sdf": 1, "motion_error": 1}):
            with self.assertRaisesRegex(graze.UseError, "rows of a solid at rest have pmc and sdf, and no other answer"):
                graze.Scene(common.CUBE, None, **more)
        for more in ({"operation": "unsweep"}, {"overlap": "reject"}, {"folds": "combined"}):
            with self.assertRaisesRegex(graze.UseError, "^operation, overlap and folds need a motion; expected one$"):
                graze.Scene(common.CUBE, None, **more)
