"""Messages that name arguments, files that are what their name says, tables that keep their columns, and progress.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import io
import os
import sys
import tempfile
import unittest
from unittest import mock

import common
import graze


class Table:
    """Columns with names, as a DataFrame offers them."""

    def __init__(self, **columns):
        self.columns, self._by = list(columns), columns

    def __getitem__(self, name):
        return self._by[name]


class Messages(unittest.TestCase):
    def said(self, wanted, function, *given, **more):
        with self.assertRaises((graze.GrazeError, TypeError)) as caught:
            function(*given, **more)
        self.assertIn(wanted, str(caught.exception))
        return caught.exception

    def test_poses(self):
        """Poses are counted from 0, and no line is named where there was no file."""
        still, zero = (0, 0, 0, 1, 0, 0, 0), (1, 0, 0, 0, 0, 0, 0)
        error = self.said("poses[1]: the quaternion is zero", graze.Motion.poses, [still, zero], quaternions="wxyz")
        self.assertEqual((error.file, error.line, error.item, error.index), ("", 0, "pose", 1))
        self.said("poses[2]: the time is not after that of poses[1]", graze.Motion.poses, [still] * 3, times=[0, 1, 1], quaternions="wxyz")
        error = self.said("poses: has 1 poses", graze.Motion.poses, [still], quaternions="wxyz")
        self.assertEqual((error.item, error.index), ("", 0))

    def test_motion(self):
        """A dict has no lines; a text has."""
        bad = {"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["q", "0", "0"]}}]}
        error = self.said("motion: pieces[0].transform.translate[0]: 'q', character 1", graze.Motion, bad)
        self.assertEqual((error.file, error.line), ("", 0))
        self.said("motion:2: ", graze.Motion, '{"dimension": 3,\n "pieces": [}')

    def test_no_list_of_points(self):
        scene = common.cube_scene()
        self.said("point 0 is 5, no row of numbers; expected a list of points, as [[5, 1, 1]]", scene.classify, [5, 1, 1])
        self.said("point 1 is 'abc', no row of numbers", scene.classify, [[5, 1, 1], "abc"])


class Files(unittest.TestCase):
    def test_endings(self):
        """SVG goes into .svg and HTML into .html, or nothing is written."""
        with tempfile.TemporaryDirectory() as folder:
            for made, good, bad in ((graze.Picture("<svg/>", lambda: b"", lambda: b""), "a.SVG", "a.gif"), (graze.Page("<html>"), "a.html", "a.svg")):
                path = os.path.join(folder, bad)
                with self.assertRaisesRegex(graze.UseError, r"a\.(gif|svg): what is saved is (SVG, PNG or PDF|HTML); expected a name that ends with"):
                    made.save(path)
                self.assertFalse(os.path.exists(path))
                made.save(os.path.join(folder, good))
                self.assertTrue(os.path.exists(os.path.join(folder, good)))


class Columns(unittest.TestCase):
    points = Table(name=["a", "b"], z=[1.0, 1.0], x=[5.0, 5.0], pmc=["?", "!"], y=[1.0, 4.0])

    def test_others_are_kept(self):
        """Other columns come last, under another name where the answer has theirs."""
        scene = common.cube_scene()
        out = graze.columns(scene.classify(self.points), self.points)
        self.assertEqual(list(out), ["x", "y", "z", "pmc", "class", "definition", "case", "i", "t", "name", "pmc_in"])
        self.assertEqual((out["pmc"], out["name"], out["pmc_in"]), (["in", "out"], ["a", "b"], ["?", "!"]))

    def test_distances(self):
        """(5, 4, 1) is 2 above the box [0, 10] x [0, 2]^2, and (5, 1, 1) 1 deep."""
        out = graze.columns(common.cube_scene().distance(self.points, 1e-9), self.points)
        self.assertEqual(list(out), ["x", "y", "z", "pmc", "sdf_low", "sdf_high", "sdf_t", "name", "pmc_in"])
        self.assertEqual(out["pmc"], ["in", "out"])
        for low, high, right in zip(out["sdf_low"], out["sdf_high"], (-1, 2)):
            self.assertTrue(low <= right <= high and high - low <= 1e-9, (low, high))


class Progress(unittest.TestCase):
    def test_without_tqdm(self):
        """The last number is that of all points, whether tqdm is there or not."""
        said = io.StringIO()
        with mock.patch.dict(sys.modules, {"tqdm": None, "tqdm.auto": None}), contextlib.redirect_stderr(said):
            common.cube_scene().classify([[5, 1, 1]] * 300, progress=True)
        self.assertTrue(said.getvalue().endswith("300 of 300 points\n"), said.getvalue())
