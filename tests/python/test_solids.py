"""Curved solids made in Python: constructors, operators, maps; words by hand, files that the program reads.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import subprocess
import tempfile
import unittest
from fractions import Fraction as F

import common
import graze
from common import numpy

S = graze.Solid
SHIFT = [[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0]]


def word(solid, point, motion=None):
    """The word where the solid moves by 10 along x."""
    d = solid.dimension
    return graze.Scene(solid, common.moved(*["10*t", "0", "0"][:d]) if motion is None else motion).trace(point).word


class Solids(unittest.TestCase):
    def test_generate(self):
        """Points of a bead with a bore: kinds of them, and a contact with the primitive at the time."""
        scene = graze.Scene(S.ball(1) - S.cylinder("3/5", low=-2, high=2), common.moved("10*t", "0", "0"))
        made = list(scene.generate(60, seed=1))
        self.assertEqual(len({sample.point for sample in made}), 60)
        self.assertLessEqual({"face", "edge", "crossing", "start", "end", "near", "miss"}, {sample.stratum for sample in made})
        for sample in made:
            trace = scene.trace(sample.point)
            self.assertNotIn("?", trace.word)
            if sample.cell and not sample.k:
                self.assertTrue(any(contact.start <= sample.time <= contact.end and sample.cell in contact.cells for contact in trace.contacts), sample)

    def test_primitives(self):
        """Each touches the line of (5, 1, 0), or of (5, 1), once from outside."""
        one = {
            "halfspace": S.halfspace((0, 1, 0), 1) & S.halfspace((0, 0, 1)) & S.halfspace((0, 0, -1), 1) & S.halfspace((1, 1, 0), 1)
            & S.halfspace((-1, 1, 0), 1), "box": S.box((0, 0, 0), (1, 1, 1)), "ball": S.ball(1), "ellipsoid": S.ellipsoid((2, 1, 3)),
            "cylinder": S.cylinder(1, low=-1, high=1), "cone": S.cone(1, (0, -1, 0), (0, 1, 0), high=1),
            "torus": S.torus("3/4", F(1, 4)), "capsule": S.capsule(0.5, (0, 0, 1), (0, 0.5, 0)),
            "quadric": S.quadric({(2, 0, 0): 1, (0, 2, 0): 1, (0, 0, 2): 4, (0, 0, 0): -1}),
            "polynomial": S.polynomial({(4, 0, 0): 1, (0, 1, 0): 1, (0, 0, 2): 1, (0, 0, 0): -1}),
            "polygon": S.polygon([(0, 0), (2, 0), (1, 1)], extrude=(0, 1), scale=(2, 2)),
            "revolved": S.polygon([(0, 0), (1, 0), ("1/2", 1)], revolve=True),
            "polyhedron": S.polyhedron([(-1, 0, -1), (1, 0, -1), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])}
        for name, solid in one.items():
            self.assertEqual(word(solid, (5, 1, 0)), "OBO", name)
            self.assertEqual(word(solid, (5, F(10001, 10000), 0)), "O", name)
        for solid in (S.ball(1, (0, 0)), S.capsule(1, (0, -2)), S.polygon([(0, 0), (2, 0), (1, 1)], [[(1, "1/4"), (1, "1/2"), ("5/4", "1/4")]])):
            self.assertEqual((solid.dimension, word(solid, (5, 1))), (2, "OBO"))

    def test_scad(self):
        """A ball turned by six digits is an ellipsoid that does not reach y = 1, and a ball as a rotation."""
        sphere = "sphere($fn = %d, $fa = 12, $fs = 2, r = 1);"
        turned = "multmatrix([[0.866025, -0.5, 0, 0], [0.5, 0.866025, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { %s }" % (sphere % 0)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "ball.csg")

            def scad(text, **options):
                with open(path, "w", encoding="ascii") as file:
                    file.write(text)
                return S.scad(path, **options)

            self.assertEqual((word(scad(turned), (5, 1, 0)), S.scad(path).report), ("O", ""))
            ball = scad(turned, near_rotation="1e-6")
            self.assertEqual([word(ball, (5, y, 0)) for y in (1, -1, F(10001, 10000))], ["OBO", "OBO", "O"])
            self.assertRegex(ball.report, r"^maps taken as rotations: 1; no point moves by more than [\d./e-]+$")
            self.assertEqual(word(ball - S.ball(1), (5, 0, 0)), "O")
            self.assertEqual(word(scad(turned, near_rotation=1e-8), (5, 1, 0)), "O")
            with self.assertRaises(graze.UseError):
                S.scad(path, near_rotation=0)
            with self.assertRaises(graze.InputError):
                scad(sphere % 48)
            self.assertEqual(word(S.scad(path, smooth=True), (5, 1, 0)), "OBO")

    def test_operators(self):
        """A plate with a hole, its parts, a chain, a name."""
        plate, hole = S.box((-3, -3, 0), (3, 3, 1)), S.cylinder(1)
        self.assertEqual(word(plate - hole, (5, 0, "1/2")), "OBIBOBIBO")
        self.assertEqual(word(plate & hole, (5, 0, "1/2")), "OBIBO")
        self.assertEqual(word(plate | S.ball(1, (0, 0, 1)), (5, 0, 2)), "OBO")
        chain = S.ball(1)
        for k in range(1, 9):
            chain = chain | S.ball(1, (3 * k, 0, 0)).named(f"bead {k}")
        self.assertEqual(len(json.loads(chain.json())["solid"]["union"]), 9)
        self.assertEqual(chain.primitives[8], 'ball 8 "bead 8"')
        self.assertEqual(repr(chain), "<graze.Solid in E^3: 9 primitives>")
        self.assertEqual(word(chain.moved(SHIFT), (5, 1, 0)), "BO")
        cell, = graze.Scene(chain, common.moved("10*t", "0", "0")).trace((31, 1, 0)).contacts[0].cells[:1]
        self.assertEqual(str(cell), "primitive 8")

    def test_moved(self):
        """An image by rows, by a square matrix and by arrays; the file of it is read by the program."""
        for matrix in (SHIFT, SHIFT + [[0, 0, 0, 1]], [["1", 0, 0, F(5)], [0, 1.0, 0, 0], [0, 0, 1, 0]]):
            self.assertEqual(word(S.ball(1).moved(matrix), (10, 1, 0)), "OBO")
        if numpy:
            self.assertEqual(word(S.ball(1).moved(numpy.array(SHIFT, float)), (10, 1, 0)), "OBO")
        made = S.ball(1).moved(SHIFT) - S.ball(1, (6, 0, 0))
        for again in (S(made.json()), S(json.loads(made.json())), S(made.json()) & made):
            self.assertEqual(word(again, (10, 0, 0)), word(made, (10, 0, 0)))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "made.csg.json")
            with open(path, "w", encoding="utf-8") as file:
                file.write(made.json())
            done = subprocess.run([common.GRAZE, "check", path, os.path.join(common.ROOT, "tests", "refuse", "common", "move3.json")],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(word(S(path), (10, 0, 0)), word(made, (10, 0, 0)))

    def test_undecided(self):
        """The table is the program's, with the number of rows that are undecided: two surfaces that touch in order 4, then a box."""
        flat = {"difference": [{"polynomial": {"0,0,1": 1, "4,0,0": 1, "0,4,0": 1, "2,2,0": -1}}, {"halfspace": {"normal": [0, 0, 1], "offset": 0}}]}
        solid = S({"dimension": 3, "solid": {"union": [flat, {"box": {"low": [2, -1, -1], "high": [3, 1, 1]}}]}})
        scene = graze.Scene(solid, graze.Motion({"dimension": 3, "pieces": [{"t": [-1, 4], "transform": {"translate": ["-t", 0, 0]}}]}))
        verdict = scene.trace((0, 0, 0)).verdict
        self.assertEqual((verdict.pmc, verdict.class_, verdict.i), (graze.Pmc.IN, graze.Class.UNDECIDED, 0))
        lines = scene.table([(0, 0, 0), (0, 0, 5)]).splitlines()
        self.assertEqual(lines[-4:], ["0,0,0,in,undecided,,,,,O?OBIBO", "0,0,5,out,exterior,9,1,0,0,O", "# undecided 1", "# complete 2"])
        self.assertEqual(lines[1], "# contract 2")

    def test_refusals(self):
        with self.assertRaisesRegex(graze.IllegalError, "radius.*positive"):
            S.ball(0)
        with self.assertRaisesRegex(graze.IllegalError, "singular"):
            S.ball(1).moved([[1, 0, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0]])
        with self.assertRaises(graze.InputError):
            S({"dimension": 3, "solid": {"sphere": {}}})
        with self.assertRaisesRegex(ValueError, "E.3, the other in E.2"):
            S.ball(1) | S.ball(1, (0, 0))
        with self.assertRaises(TypeError):
            S.ball(1) | 3
        with self.assertRaisesRegex(TypeError, "operators"):
            S(common.CUBE) | S.ball(1)
        with self.assertRaisesRegex(ValueError, "at least one"):
            S.polynomial({})
