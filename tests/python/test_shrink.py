"""`graze.shrink`: planted bugs are found in a smaller scene, and only what they need is left.

A bug is a function of points and a model that answers exactly but where it is planted to be wrong, so that what must
stay in the scene is known. SPDX-License-Identifier: GPL-3.0-or-later
"""
import itertools
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from fractions import Fraction as F

import common
import graze
import graze.shrink
import graze.testing
from common import numpy
from graze._hull import cut, hull
from graze._plain import Model, number

LIBRARY = os.path.join(os.path.dirname(os.path.abspath(common.GRAZE)), "libgraze.so")
ENVIRONMENT = {**os.environ, "PYTHONPATH": os.path.join(common.ROOT, "src", "python"), "GRAZE_LIBRARY": LIBRARY}


def words(points, model):
    return graze.pmc_names(model.scene().classify(points))


def wrong_if(condition):
    """A classifier that calls `in` points `out` in models of a condition, else is right."""
    def answers(points, model):
        said = "out" if condition(model) else "in"
        return [said if word == "in" else word for word in words(points, model)]

    return answers


def turns(model):
    return any(not piece.translates for piece in model.pieces)


def hollow(model):
    """Does a corner of a polygon bend inwards?"""
    for ring in model.facets:
        points = [model.vertices[k] for k in ring]
        for a, b, c in zip(points, points[1:] + points[:1], points[2:] + points[:2]):
            if (b[0] - a[0]) * (c[1] - b[1]) < (b[1] - a[1]) * (c[0] - b[0]):
                return True
    return False


class Hulls(unittest.TestCase):
    def test_hulls(self):
        """Legal solids of the points' own corners, outward: no point is outside a facet."""
        chance = random.Random(5)
        solids = 0
        for _ in range(150):
            d = chance.choice((2, 3))
            points = [tuple(F(chance.randint(-3, 3)) for _ in range(d)) for _ in range(chance.randint(1, 12))]
            made = hull(points)
            if made is None:
                continue
            solids += 1
            vertices, facets = made
            self.assertTrue(set(vertices) <= set(points))
            self.assertEqual(graze.Solid(made).component_count, 1)
            for facet in facets if d == 3 else [[a, b] for a, b in zip(facets[0], facets[0][1:] + facets[0][:1])]:
                a, b = vertices[facet[0]], vertices[facet[1]]
                for p in points:
                    if d == 2:
                        side = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
                        self.assertGreaterEqual(side, 0, points)
                    else:
                        c = vertices[facet[2]]
                        u, v, w = ([y - x for x, y in zip(a, q)] for q in (b, c, p))
                        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
                        self.assertLessEqual(sum(x * y for x, y in zip(n, w)), 0, points)
        self.assertGreater(solids, 80)
        cube = list(itertools.product((F(0), F(2)), repeat=3))
        self.assertEqual([len(facet) for facet in hull(cube)[1]], [4] * 6)
        low, high = (hull(cut(cube, 0, F(1), above)) for above in (False, True))
        self.assertEqual(sorted(low[0]), sorted(itertools.product((F(0), F(1)), (F(0), F(2)), (F(0), F(2)))))
        self.assertEqual(min(v[0] for v in high[0]), 1)

    def test_numbers(self):
        for value, text in ((F(3), "3"), (F(-1, 4), "-0.25"), (F(1, 80), "0.0125"), (F(2, 3), "2/3"), (F(-7, 2), "-3.5")):
            self.assertEqual(number(value), text)
            self.assertEqual(F(text), value)

    def test_models(self):
        """A model is the scene that it was made of."""
        for name in ("bracket", "gear", "figure2-parts-2d", "unsweep-figure6a", "family-stationary-whole"):
            case = graze.testing.case(name)
            model = Model.of(case.scene)
            self.assertEqual(graze.pmc_names(model.scene().classify(case.points)), case.labels, name)
            with tempfile.TemporaryDirectory() as folder:
                for ending in (".wkt",) if model.dimension == 2 else (".off", ".obj", ".ply", ".stl"):
                    path, motion = os.path.join(folder, "solid" + ending), os.path.join(folder, "motion.json")
                    for place, text in ((path, model.solid_text(ending)), (motion, model.motion_text())):
                        with open(place, "w", encoding="ascii") as file:
                            file.write(text)
                    if ending != ".stl" or all(x.denominator in (1, 2, 4, 5, 20) for v in model.vertices for x in v):
                        scene = graze.Scene(path, motion, **model.options)
                        self.assertEqual(graze.pmc_names(scene.classify(case.points)), case.labels, (name, ending))


@unittest.skipIf(numpy is None, "numpy")
class Planted(unittest.TestCase):
    def shrunk(self, classify, scene, **options):
        """The result is a legal scene in which the classifier is wrong at the point, as the result says."""
        found = graze.shrink.shrink(classify, scene, n=200, **options)
        exact = graze.pmc_names(found.model.scene().classify([found.point]))[0]
        given = classify([tuple(map(float, found.point))] if numpy is None else numpy.array([list(map(float, found.point))]), found.model)[0]
        self.assertEqual((exact, str(given)), found.kind[1:])
        self.assertNotEqual(exact, given)
        return found

    def test_sampled(self):
        """20 positions in place of a motion: wrong in the first scene of small integers."""
        def sampled(points, model):
            scene, out = model.scene(), ["out"] * len(points)
            last = model.pieces[-1]
            for k in range(21):
                t = model.start + (model.end - model.start) * F(k, 20)
                piece = next((p for p in model.pieces if t <= p.end), last)
                weight = sum(c * t ** i for i, c in enumerate(piece.weight))
                entries = [[str(sum(c * t ** i for i, c in enumerate(p)) / weight) for p in row] for row in piece.entries]
                still = {"dimension": model.dimension, "pieces": [{"t": [0, 1], "transform": {"matrix": entries}}]}
                here = graze.Scene(scene.solid, still).classify(points)
                out = ["in" if word == "in" else old for word, old in zip(graze.pmc_names(here), out)]
            return out

        found = self.shrunk(sampled, graze.testing.case("bracket").scene, on="any", seconds=60)
        self.assertLessEqual((found.model.facet_count, len(found.model.pieces)), (4, 1))
        self.assertTrue(all(x.denominator == 1 and abs(x) < 100 for v in found.model.vertices for x in v), found)
        self.assertLess(found.runs, 80)
        self.assertTrue(found.finished)

    def test_needed(self):
        """A turn, a hollow corner, two pieces stay where the bug needs them; else a triangle and a straight piece are left."""
        gear, steps = (graze.testing.case(name).scene for name in ("gear-half", "figure2-parts-2d"))
        found = self.shrunk(wrong_if(lambda model: True), gear)
        self.assertEqual((found.model.facet_count, len(found.model.pieces), found.model.pieces[0].translates), (3, 1, True))
        self.assertTrue(all(x.denominator == 1 for x in found.point), found)
        found = self.shrunk(wrong_if(turns), gear)
        self.assertEqual((found.model.facet_count, len(found.model.pieces), turns(found.model)), (3, 1, True))
        found = self.shrunk(wrong_if(hollow), gear)
        self.assertEqual((len(found.model.pieces), hollow(found.model)), (1, True))
        self.assertLessEqual(found.model.facet_count, 8)
        found = self.shrunk(wrong_if(lambda model: len(model.pieces) > 1), graze.testing.case("gear").scene)
        self.assertEqual((found.model.facet_count, len(found.model.pieces)), (3, 2))
        found = self.shrunk(wrong_if(lambda model: len(model.facets) > 1), steps)
        self.assertEqual(len(found.model.facets), 2)

    def test_bounds(self):
        """The best so far at the end of the runs; nothing where nothing is wrong; a folder that holds something is refused."""
        gear = graze.testing.case("gear").scene
        found = self.shrunk(wrong_if(turns), gear, runs=12)
        self.assertEqual((found.runs, found.finished, turns(found.model)), (12, False, True))
        with tempfile.TemporaryDirectory() as folder:
            place = os.path.join(folder, "small")
            self.assertIsNone(graze.shrink.shrink(words, gear, place, n=50))
            self.assertFalse(os.path.exists(place))
            graze.shrink.shrink(wrong_if(turns), gear, place, n=50)
            self.assertEqual(sorted(os.listdir(place)), ["README.md", "certificate.txt", "expected.csv", "motion.json", "point.csv", "reason.txt",
                                                         "solid.wkt"])
            with self.assertRaisesRegex(graze.UseError, "expected a folder that does not exist or is empty"):
                graze.shrink.shrink(wrong_if(turns), gear, place, n=50)
        with self.assertRaisesRegex(graze.UseError, "is curved; expected a polyhedron or polygon"):
            graze.shrink.shrink(words, graze.testing.case("curved-two-balls").scene)


# Right but for points above the middle of the solid's box at the start, which it calls `out`.
CANDIDATE = """
import csv, sys, time
import graze
solid, motion, points, out = sys.argv[1:5]
time.sleep(float(sys.argv[5]) if len(sys.argv) > 5 else 0)
scene = graze.Scene(solid, motion)
rows = list(csv.DictReader(open(points)))
answers = graze.pmc_names(scene.classify([[row[k] for k in "xyz" if k in row] for row in rows]))
with open(out, "w") as file:
    file.write("id,pmc\\n")
    for row, word in zip(rows, answers):
        file.write(row["id"] + "," + ("out" if word == "in" and float(row["y"]) > 1 else word) + "\\n")
"""


@unittest.skipIf(numpy is None, "numpy")
class Command(unittest.TestCase):
    """`graze validate --shrink`."""

    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.folder = made.name
        with open(os.path.join(self.folder, "candidate.py"), "w", encoding="ascii") as file:
            file.write(CANDIDATE)
        self.small = os.path.join(self.folder, "small")

    def command(self, *more, pause=()):
        case = os.path.join(common.ROOT, "cases", "bracket")
        words = " ".join(["python3", os.path.join(self.folder, "candidate.py"), "{solid}", "{motion}", "{points}", "{out}", *pause])
        return [os.path.abspath(common.GRAZE), "validate", os.path.join(case, "solid.off"), os.path.join(case, "motion.json"), "-n", "60",
                "--representable", "binary64", "--candidate", words, "--shrink", self.small, *more]

    def run_it(self, command):
        done = subprocess.run(command, env=ENVIRONMENT, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", check=False)
        return done.returncode, done.stdout, done.stderr

    def test_command(self):
        status, report, said = self.run_it(self.command())
        self.assertEqual(status, 1, said)
        self.assertIn("verdict: differs", report)
        self.assertRegex(said, r"graze: shrunk to 4 facets and 1 piece in \d+ runs of the candidate and \S+ s: ")
        with open(os.path.join(self.small, "README.md"), encoding="utf-8") as file:
            lines = file.read().splitlines()
        self.assertEqual(len(lines), 3)
        self.assertRegex(lines[0], r"^\(.*\) is `in`, given out\. The point is in the interior of the solid from")
        again = lines[2].split("`")[1].replace("graze validate", self.command()[0] + " validate", 1)
        done = subprocess.run(["sh", "-c", again], cwd=self.small, env=ENVIRONMENT, stdout=subprocess.PIPE, encoding="utf-8", check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("1 of 1 rows wrong", done.stdout)
        check = [common.GRAZE + "-check", "solid.off", "motion.json", "certificate.txt", "expected.csv"]
        status, report, said = self.run_it([os.path.abspath(check[0]), *(os.path.join(self.small, name) for name in check[1:])])
        self.assertEqual((status, report), (0, "verified: 1 rows\n"), said)
        with open(os.path.join(self.small, "motion.json"), encoding="utf-8") as file:
            self.assertEqual(len(json.load(file)["pieces"]), 1)

    def test_nothing_wrong(self):
        """`on` points may be called `in` or `out`, and no point of the bracket is `in` below y = 1 where it is asked."""
        with open(os.path.join(self.folder, "candidate.py"), "a", encoding="ascii") as file:
            file.write("import re; text = open(out).read(); open(out, 'w').write('id,pmc\\n' + ''.join(r['id'] + ',' + a + '\\n' "
                       "for r, a in zip(rows, answers)))\n")
        status, report, said = self.run_it(self.command())
        self.assertEqual(status, 0, said)
        self.assertIn("no difference", report)
        self.assertFalse(os.path.exists(self.small))

    def test_signal(self):
        """A signal leaves the best so far, and ends the program."""
        child = subprocess.Popen(self.command("--quiet", "-o", os.path.join(self.folder, "report"), pause=["0.3"]), env=ENVIRONMENT, cwd=self.folder,
                                 stderr=subprocess.PIPE, encoding="utf-8")
        began = time.monotonic()
        while not os.path.exists(os.path.join(self.folder, "report.json")) and time.monotonic() - began < 60:
            time.sleep(0.05)
        time.sleep(2)
        child.send_signal(signal.SIGTERM)
        said = child.communicate(timeout=60)[1]
        self.assertEqual(child.returncode, -signal.SIGTERM, said)
        self.assertIn("not to the end", said)
        self.assertIn("README.md", os.listdir(self.small))
