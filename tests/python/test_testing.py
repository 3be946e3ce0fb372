"""`graze.testing.check` and the plugin of pytest, on the cube [0, 2]^3 that moves by 8 along x: it sweeps
[0, 10] x [0, 2]^2, by which each label is derived.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction as F

import common
import graze
import graze.testing
from common import numpy

SIDES = ((0, 10), (0, 2), (0, 2))
# Inside, on a face and on an edge of the sweep, outside; the first is 1/4 deep, the last 3 away.
POINTS = [(5, 0.25, 1), (5, 2, 1), (0, 2, 1), (5, 5, 1)]


def distance(point):
    """The exact signed distance to [0, 10] x [0, 2]^2."""
    out = [max(low - x, x - high) for x, (low, high) in zip(point, SIDES)]
    beyond = [max(value, 0) for value in out]
    return max(out) if max(out) <= 0 else sum(value * value for value in beyond) ** 0.5


def words(points):
    return ["in" if distance(p) < 0 else "on" if distance(p) == 0 else "out" for p in points]


class Labels(unittest.TestCase):
    """Right labels of each kind pass; what is no label is refused by its index."""

    def check(self, classify, **options):
        return graze.testing.check(classify, common.cube_scene(), **{"n": 200, "seed": 3, **options})

    def test_kinds(self):
        number = {"in": -1, "on": 0, "out": 1}
        self.assertEqual(self.check(words).rows, 200)
        self.assertEqual(self.check(words).undecided, 0)
        self.check(lambda points: [number[word] for word in words(points)])
        self.check(lambda points: [word == "in" for word in words(points)])
        self.check(lambda points: [distance(p) for p in points])
        self.check(lambda points: [distance(p) + 0.01 for p in points], tolerance="0.02")
        self.check(lambda points: [{"in": 7, "on": 8, "out": 9}[w] for w in words(points)], labels={7: "in", 8: "on", 9: "out"})
        if numpy is not None:
            self.check(lambda points: numpy.array(words(points)))
            self.check(lambda points: numpy.array([number[word] for word in words(points)], "i1"))

    def test_refusals(self):
        for made, text in ((lambda n: ["in"] * (n - 1) + ["inside"], r"labels\[199\] is 'inside'; expected in, on or out"),
                           (lambda n: ["in"] * 7, "returned 7 labels; expected 200"), (lambda n: [True] * (n - 1) + [1.0], "labels of one kind"),
                           (lambda n: [0, 1] * (n // 2), "the integers 0 and 1 alone"), (lambda n: [2] * n, r"labels\[0\] is 2; expected -1"),
                           (lambda n: [float("nan")] * n, "expected a signed distance"), (lambda n: [None] * n, r"labels\[0\] is None"),
                           (lambda n: 5, "returned a int")):
            with self.assertRaisesRegex(graze.UseError, text):
                self.check(lambda points, made=made: made(len(points)))
        for options, text in (({"on": "maybe"}, "on is 'maybe'; expected one of on, any, in, out"), ({"tolerance": 1}, "tolerance is for floats"),
                              ({"labels": {"in": "inside"}}, "'in' stands for 'inside'"), ({"labels": {1: "in"}}, r"labels\[0\] is '\w+'; expected one of 1")):
            with self.assertRaisesRegex(graze.UseError, text):
                self.check(words, **options)
        with self.assertRaisesRegex(graze.UseError, "tolerance is 0; expected a positive number"):
            self.check(lambda points: [1.0] * len(points), tolerance=0)
        with self.assertRaisesRegex(TypeError, "scene is a int; expected a Scene or a pair"):
            graze.testing.check(words, 5)

    def test_conventions(self):
        """An `on` point may be called anything by who cannot say `on`; `in` and `out` hold it to one answer."""
        closed = lambda points: [distance(p) <= 0 for p in points]
        self.check(closed)
        self.check(closed, on="in")
        with self.assertRaises(graze.testing.WrongLabels) as failed:
            self.check(closed, on="out", points=POINTS)
        self.assertEqual([row.number for row in failed.exception.wrong], [1, 2])
        with self.assertRaises(graze.testing.WrongLabels) as failed:
            self.check(lambda points: ["out"] * len(points), on="any", points=POINTS)
        self.assertEqual([row.number for row in failed.exception.wrong], [0])


class Failure(unittest.TestCase):
    """The message has the confusion, then the deepest row with its word, the reason and a command."""

    def test_message(self):
        with tempfile.TemporaryDirectory() as folder:
            solid, motion = os.path.join(folder, "cube.off"), os.path.join(folder, "move it.json")
            with open(solid, "w", encoding="ascii") as file:
                file.write(common.program("solid", "box", "--size", "2,2,2"))
            with open(motion, "w", encoding="ascii") as file:
                file.write(common.program("motion", "line", "--by", "8,0,0"))
            with self.assertRaises(graze.testing.WrongLabels) as failed:
                graze.testing.check(lambda points: ["out"] * len(points), (solid, motion), points=POINTS)
            text, wrong = str(failed.exception), failed.exception.wrong
            command = next(line for line in text.splitlines() if "graze explain" in line)
            self.assertIn("'" + motion + "' 5 1/4 1", command)
        self.assertEqual([row.number for row in wrong][0], 0)
        self.assertTrue(F(249, 1000) <= wrong[0].depth <= F(1, 4), wrong)
        self.assertEqual(sorted(wrong[k].depth for k in (1, 2)), [0, 0])
        self.assertEqual(text.splitlines()[0], "3 of 4 labels are wrong")
        # x = 5 is between 8t and 8t + 2 for 3/8 < t < 5/8.
        self.assertIn("word OBIBO", text)
        self.assertRegex(text, r"in the interior of the solid from t = 3/8 \(face \d\) to t = 5/8 \(face \d\)\. One such time is enough")
        self.assertEqual(failed.exception.checked.confusion, {("in", "out"): 1, ("on", "out"): 2, ("out", "out"): 1})

    def test_reasons(self):
        scene = common.cube_scene()
        reason = lambda *point: graze.testing.why(scene.trace(point), scene.operation)
        self.assertRegex(reason(5, 2, 1), r"meets the point from t = 3/8 to t = 5/8 \(face \d.*Its interior never does")
        self.assertRegex(reason(10, 1, 1), r"meets the point at t = 1 \(face \d\)")
        self.assertIn("not even its boundary", reason(5, 5, 1))
        stays = common.cube_scene(operation="unsweep")
        self.assertIn("outside the solid from", graze.testing.why(stays.trace((1, 1, 1)), "unsweep"))
        self.assertIn("scene.explain(['5', '1', '2'])", graze.testing.explains(scene, (F(5), F(1), F(2))))
        with self.assertRaises(graze.testing.WrongLabels):  # far beyond any tolerance
            graze.testing.check(lambda points: [float("inf")] * len(points), scene, points=POINTS, tolerance=1)

    def test_undecided(self):
        """Points of a curved solid that are undecided are left out and counted."""
        case = graze.testing.case("curved-two-balls")
        labels = graze.pmc_names(case.scene.classify(case.points))
        self.assertEqual(labels, case.labels)


TESTS = '''
import graze.testing

def test_right(graze_check, graze_case, graze_scene):
    case = graze_case("figure2-cube-corner")
    right = lambda points: graze.pmc_names(case.scene.classify(points))
    assert graze_check(right, case.scene).rows == 30
    box = graze_scene("box-along-axis")
    assert graze_check(lambda points: graze.pmc_names(box.classify(points)), box).rows == 30

def test_wrong(graze_check, graze_case):
    graze_check(lambda points: ["out"] * len(points), graze_case("bracket").scene)

def test_golden(graze_golden):
    assert graze.pmc_names(graze_golden.scene.classify(graze_golden.points)) == graze_golden.labels
'''


@unittest.skipIf(numpy is None, "numpy")
class Plugin(unittest.TestCase):
    """The fixtures in a run of pytest: one test fails with the message, golden cases are one test each."""

    def test_plugin(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "test_it.py"), "w", encoding="utf-8") as file:
                file.write(TESTS)
            environment = {**os.environ, "PYTHONPATH": os.path.join(common.ROOT, "src", "python"), "GRAZE_PROGRAM": os.path.abspath(common.GRAZE)}

            def run(*words):
                done = subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "graze.pytest_plugin", *words], cwd=folder, env=environment,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", check=False)
                return done.returncode, done.stdout

            status, said = run("--graze-n", "30", "--graze-seed", "9", "-k", "right or wrong or golden and figure2", "--junit-xml", "report.xml")
            self.assertEqual(status, 1, said)
            golden = sum("figure2" in name for name in graze.testing.case_names())
            self.assertIn(f"1 failed, {golden + 1} passed", said)
            self.assertRegex(said, r"labels are wrong \(n=30, seed=9\)")
            self.assertTrue(os.path.exists(os.path.join(folder, "report.xml")))
            status, said = run("--graze-n", "0")
            self.assertEqual(status, 4, said)
            self.assertIn("--graze-n", said)


class Cases(unittest.TestCase):
    def test_names(self):
        self.assertIn("bracket", graze.testing.case_names())
        with self.assertRaisesRegex(graze.UseError, "there is no golden case 'brackets'; expected one of those"):
            graze.testing.case("brackets")
        with self.assertRaisesRegex(graze.UseError, "the benchmark has no scene 'gears'; expected one of those"):
            graze.testing.write_benchmark("gears", tempfile.gettempdir())
        before = os.environ.get("GRAZE_CASES")
        os.environ["GRAZE_CASES"] = os.devnull
        try:
            with self.assertRaisesRegex(graze.MachineError, "golden cases are not installed; expected `make install`"):
                graze.testing.case_names()
        finally:
            os.environ.pop("GRAZE_CASES") if before is None else os.environ.update(GRAZE_CASES=before)
