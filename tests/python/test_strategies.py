"""Strategies for Hypothesis: what they make is legal, and a planted bug is found and made small.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import importlib.util
import os
import tempfile
import unittest

import common
import graze
import graze.testing
from common import numpy

if importlib.util.find_spec("hypothesis"):
    from hypothesis import HealthCheck, Phase, given, seed, settings
    from hypothesis import strategies as st
    import graze.strategies as ours
    few = settings(max_examples=12, deadline=None, database=None, derandomize=False, suppress_health_check=list(HealthCheck),
                   phases=(Phase.generate, Phase.shrink))  # nobody reads an explanation


@unittest.skipIf(numpy is None, "numpy")
class Strategies(unittest.TestCase):
    def each(self, strategy, check):
        @seed(7)
        @few
        @given(strategy)
        def run(made):
            check(made)
        run()

    def test_solids(self):
        """Every solid of each kind is legal, and occurs in its own size: a polycube of n cells has the volume n."""
        def legal(mesh):
            self.assertGreater(graze.Solid(mesh).facet_count, 2)

        def cubes(mesh):
            legal(mesh)
            volume = 0
            for facet in mesh[1]:
                a, b, c = (mesh[0][k] for k in facet[:3])
                n = ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]))
                volume += n * a[0]  # faces across x, by Gauss's theorem
            self.assertEqual(volume.denominator, 1)
            self.assertTrue(1 <= volume <= 6, mesh)

        for d in (2, 3):
            for kind in (ours.boxes, ours.simplices, ours.hulls, ours.solids):
                self.each(kind(d), legal)
        self.each(ours.prisms(), legal)
        self.each(ours.polygons(), legal)
        self.each(ours.polycubes(2), legal)
        self.each(ours.polycubes(3), cubes)

    def test_motions(self):
        """Every motion moves a box legally; the kinds are what their names say."""
        for d in (2, 3):
            for kind in (ours.legs, ours.polynomials, ours.quarter_turns, ours.motions):
                self.each(ours.models(d, solid=ours.boxes(d), motion=kind(d)), lambda model: model.scene())
        self.each(ours.models(motion=ours.screws()), lambda model: self.assertFalse(model.pieces[0].translates))
        self.each(ours.legs(3), lambda pieces: self.assertTrue(all(piece.degree == 1 for piece in pieces)))

    def test_curved(self):
        def decided(solid):
            try:
                scene = graze.Scene(solid, {"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": ["t", 0]}}]})
            except graze.GrazeError:
                return  # a difference may be empty
            self.assertEqual(len(graze.pmc_names(scene.classify([[0.5, 0.25]]))), 1)
        self.each(ours.curved(2), decided)

    def test_planted(self):
        """Points with y = 0 are called `out` by mistake: the failure that is written has small integers and is wrong."""
        def mine(points, model):
            return [word if row[1] else "out" for row, word in zip(points, graze.pmc_names(model.scene().classify(points)))]

        with tempfile.TemporaryDirectory() as folder:
            place = os.path.join(folder, "wrong")

            @seed(3)
            @settings(few, max_examples=80)
            @given(ours.models(3), st.data())
            def run(model, data):
                ours.check_point(mine, model, data.draw(ours.points(model.scene())), folder=place)

            with self.assertRaises(graze.testing.WrongLabels):
                run()
            solid, motion = (os.path.join(place, name) for name in ("solid.off", "motion.json"))
            row = common.read_rows(os.path.join(place, "expected.csv"))[0]
            self.assertIn(row["pmc"], ("in", "on"))
            self.assertEqual(row["y"], "0")
            self.assertTrue(all("/" not in row[name] for name in "xyz"), row)
            self.assertEqual(graze.Scene(solid, motion).trace(common.coordinates(row)).word, row["word"])
            self.assertLessEqual(graze.Solid(solid).facet_count, 6)
            with open(os.path.join(folder, "mine.txt"), "w", encoding="ascii"):
                pass
            with self.assertRaisesRegex(graze.UseError, "expected a folder of failures, or none"):
                ours.check_point(lambda points, scene: ["out"], common.cube_scene(), (1, 1, 1), folder=folder)
            ball = graze.Scene(graze.Solid.ball(1), graze.Motion.line(4, 0, 0))
            with self.assertRaises(graze.testing.WrongLabels):
                ours.check_point(lambda points, scene: ["out"], ball, (0, 0, 0), folder=place)
            self.assertIn("solid.csg.json", os.listdir(place))
