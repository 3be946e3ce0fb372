"""Points from DataFrames and from rows with names, read by name, and masked arrays, refused.

The frame here has what Graze asks of one, names of columns and the columns by name, and no more; the
same tests run with those of pandas where it is installed.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
import math
import unittest
from fractions import Fraction as F

import common
import graze

try:
    import pandas
except ImportError:
    pandas = None

np = common.numpy
CUBE = common.cube_scene()  # [0, 2]^3 moved by 8 along x: the sweep is [0, 10] x [0, 2] x [0, 2]
SQUARE = common.root_scene()


class Frame:
    """Columns by name, as a DataFrame has them."""

    def __init__(self, columns):
        self._columns = columns
        self.columns = list(columns)

    def __getitem__(self, name):
        column = self._columns[name]
        return column if np is None else np.asarray(column)


class Arrow(Frame):
    """A table of pyarrow: `columns` are data, and the names stand elsewhere."""

    def __init__(self, columns):
        super().__init__(columns)
        self.column_names, self.columns = self.columns, list(columns.values())


class Series:
    """A row of a DataFrame."""

    def __init__(self, entries):
        self._entries, self.index = entries, list(entries)

    def __iter__(self):
        return iter(self._entries.values())

    def __getitem__(self, name):
        return self._entries[name]


FRAMES = [Frame, Arrow] + ([pandas.DataFrame] if pandas is not None and np is not None else [])
SERIES = [Series] + ([pandas.Series] if pandas is not None and np is not None else [])

# In a sweep 10 long and 2 wide and high: read as x, y, z the first is in, the second out; by any
# other order of the columns the first is out.
POINTS = [(9.0, 1.0, 1.5), (1.0, 9.0, 1.0)]


def columns(order, points=POINTS, **more):
    """The columns of points in an order of their names, others among them."""
    return {**more, **{name: [p["xyz".index(name)] for p in points] for name in order}}


def pmcs(verdicts):
    """The answers, from an array of numpy or a list."""
    return [graze.Pmc(int(v)) for v in (verdicts["pmc"] if np is not None
                                        else [verdict.pmc for verdict in verdicts])]


class ByName(unittest.TestCase):
    def test_any_order(self):
        for make in FRAMES:
            for order in ("xyz", "zyx", "yzx", "zxy"):
                got = CUBE.classify(make(columns(order)))
                self.assertEqual(pmcs(got), [graze.Pmc.IN, graze.Pmc.OUT], (make, order))

    def test_other_columns_are_left_out(self):
        for make in FRAMES:
            frame = make(columns("zyx", name=["a", "b"], weight=[0.5, math.nan]))
            self.assertEqual(pmcs(CUBE.classify(frame)), [graze.Pmc.IN, graze.Pmc.OUT], make)

    def test_in_the_plane_z_is_another(self):
        """c(t) = (x - t^2, y), t in [0, 2]: (4.5, 0.5) comes into the square, (0.5, 4.5) does not."""
        for make in FRAMES:
            frame = make(columns("zyx", [(4.5, 0.5, 7.0), (0.5, 4.5, 7.0)]))
            self.assertEqual(pmcs(SQUARE.classify(frame)), [graze.Pmc.IN, graze.Pmc.OUT], make)

    def test_exact_entries(self):
        """Integers past 2^53, ratios and text stay what they are, in a frame as in rows."""
        rows = [(2 ** 53 + 1, F(1, 3), "0.1"), (9, 1, "3/2")]
        plain = CUBE.rows(rows)
        for make in FRAMES:
            self.assertEqual(CUBE.rows(make(columns("yzx", rows))), plain, make)
        integers = [(2 ** 53 + 1, 1, 0), (1, 1, 1)]
        for make in FRAMES:
            self.assertEqual(CUBE.rows(make(columns("zyx", integers))), CUBE.rows(integers), make)

    def test_missing(self):
        for make in FRAMES:
            for order, name in (("xy", "z"), ("zy", "x"), ("xz", "y")):
                with self.assertRaises(graze.UseError, msg=make) as raised:
                    CUBE.classify(make(columns(order, tx=[1.0, 2.0])))
                self.assertIn(f"the column {name} of the points is missing", str(raised.exception))
                self.assertIn("'tx'", str(raised.exception))
            with self.assertRaises(graze.UseError) as raised:
                CUBE.classify(make({"X": [1.0], "Y": [1.0], "Z": [1.0]}))
            self.assertIn("the column x of the points is missing", str(raised.exception))

    def test_numbered_columns_are_not_names(self):
        for make in FRAMES:
            with self.assertRaises(graze.UseError) as raised:
                CUBE.classify(make({0: [9.0], 1: [1.0], 2: [1.5]}))
            self.assertIn("the column x of the points is missing", str(raised.exception))

    def test_twice(self):
        frame = Frame(columns("xyz"))
        frame.columns.append("y")
        with self.assertRaises(graze.UseError) as raised:
            CUBE.classify(frame)
        self.assertIn("the column y of the points stands there twice", str(raised.exception))

    def test_lengths_differ(self):
        for short in ([1.0], [1.0, 1.0, 1.0]):
            with self.assertRaises(graze.UseError) as raised:
                CUBE.classify(Frame({"x": [9.0, 1.0], "y": short, "z": [1.0, 1.0]}))
            self.assertIn(f"the column y of the points has {len(short)} rows", str(raised.exception))

    def test_bad_entries_are_named(self):
        for make in FRAMES:
            for bad, kind in ((math.nan, graze.InputError), (math.inf, graze.InputError),
                              (None, (graze.InputError, TypeError))):
                for others in ([1.0, 1.0], [F(1), F(1)]):
                    frame = make({"z": others, "y": [1.0, bad], "x": others})
                    with self.assertRaises(kind, msg=(make, bad)) as raised:
                        CUBE.classify(frame)
                    self.assertIn("point 1, coordinate 1", str(raised.exception))

    def test_no_rows(self):
        for make in FRAMES:
            self.assertEqual(len(CUBE.classify(make(columns("zyx", [])))), 0, make)

    def test_vertices(self):
        corners, facets = common.CUBE
        for make in FRAMES:
            solid = graze.Solid((make(columns("zxy", corners)), facets))
            self.assertEqual((solid.dimension, solid.vertex_count), (3, 8), make)
            made = graze.Scene(solid, common.moved("8*t", "0", "0"))
            self.assertEqual(pmcs(made.classify(POINTS)), [graze.Pmc.IN, graze.Pmc.OUT], make)
        flat, ring = common.SQUARE
        self.assertEqual(graze.Solid((Frame(columns("yx", flat)), ring)).dimension, 2)


class Rows(unittest.TestCase):
    def test_series(self):
        for make in SERIES:
            row = make({"z": 1.5, "weight": 3.0, "y": 1.0, "x": 9.0})
            self.assertEqual(CUBE.trace(row).point, (F(9), F(1), F(3, 2)), make)
            self.assertEqual(pmcs(CUBE.classify([row])), [graze.Pmc.IN], make)
            with self.assertRaises(graze.UseError) as raised:
                CUBE.trace(make({"z": 1.5, "y": 1.0, "u": 9.0}))
            self.assertIn("the column x of the points is missing", str(raised.exception))
            counted = make({0: 9.0, 1: 1.0, 2: 1.5})
            self.assertEqual(CUBE.trace(counted).point, (F(9), F(1), F(3, 2)), make)

    def test_named_tuples(self):
        turned = collections.namedtuple("turned", "z y x")(1.5, 1.0, 9.0)
        self.assertEqual(CUBE.trace(turned).point, (F(9), F(1), F(3, 2)))
        plain = collections.namedtuple("plain", "east north up")(9.0, 1.0, 1.5)
        self.assertEqual(CUBE.trace(plain).point, (F(9), F(1), F(3, 2)))


@unittest.skipIf(np is None, "numpy")
class Masked(unittest.TestCase):
    def test_points(self):
        for dtype in (float, "f4", int, object):
            points = np.ma.array([(9, 1, 1), (1, 1, 1)], dtype=dtype)
            self.assertEqual(pmcs(CUBE.classify(points)), [graze.Pmc.IN, graze.Pmc.IN], dtype)
            points[1, 2] = np.ma.masked
            with self.assertRaises(graze.InputError, msg=dtype) as raised:
                CUBE.classify(points)
            self.assertIn("point 1, coordinate 2: the value is masked", str(raised.exception))

    def test_beside_verdicts(self):
        """Points that are read by name stand beside their verdicts by name, whatever their order."""
        for make in FRAMES:
            frame = make(columns("zyx", name=["a", "b"]))
            verdicts = CUBE.classify(frame)
            made = graze.columns(verdicts, frame)
            self.assertEqual(list(made)[:4], ["x", "y", "z", "pmc"])
            self.assertEqual([tuple(map(float, p)) for p in zip(made["x"], made["y"], made["z"])], POINTS, make)
            self.assertEqual(made["pmc"], ["in", "out"])
        for make in SERIES:
            rows = [make({"z": p[2], "name": "n", "x": p[0], "y": p[1]}) for p in POINTS]
            made = graze.columns(CUBE.classify(rows), rows)
            self.assertEqual([tuple(p) for p in zip(made["x"], made["y"], made["z"])], POINTS, make)

    def test_rows_and_columns(self):
        row = np.ma.array([9.0, 1.0, 1.0], mask=[False, True, False])
        with self.assertRaises(TypeError) as raised:
            CUBE.classify([(1, 1, 1), row])
        self.assertIn("point 1, coordinate 1", str(raised.exception))
        frame = Frame({})
        frame.columns = ["z", "y", "x"]
        frame.__class__ = type("Table", (Frame,), {"__getitem__": lambda self, name: (
            np.ma.array([1.0, 1.0], mask=[False, name == "y"]))})
        with self.assertRaises(graze.InputError) as raised:
            CUBE.classify(frame)
        self.assertIn("point 1, coordinate 1: the value is masked", str(raised.exception))

    def test_facets(self):
        facets = np.ma.array(common.CUBE[1], mask=False)
        facets[2, 3] = np.ma.masked
        with self.assertRaises(graze.InputError) as raised:
            graze.Solid((common.CUBE[0], facets))
        self.assertIn("facet 2, coordinate 3: the value is masked", str(raised.exception))
