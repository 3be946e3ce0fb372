"""Numbers on their way in and out, rounding, and what is refused, with the place named.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import decimal
import math
import os
import random
import struct
import tempfile
import unittest
from fractions import Fraction as F

import common
import graze

SCENE = common.root_scene()


def through(value, scene=SCENE):
    """A coordinate after it went in and came out."""
    return scene.trace([value, 0]).point[0]


class Places(unittest.TestCase):
    def test_file_and_line(self):
        """An error has the place of its message as data."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bad.off")
            with open(path, "w", encoding="utf-8") as file:
                file.write("OFF\n4 4 0\n0 0 0\nx 0 0\n0 1 0\n0 0 1\n")
            with self.assertRaises(graze.InputError) as raised:
                graze.Solid(path)
        error = raised.exception
        self.assertEqual((error.file, error.line, error.item, error.index, error.field),
                         (path, 4, "vertex", 1, ""))


class Kinds(unittest.TestCase):
    def test_exact(self):
        big = 3 ** 5000
        for value, exact in [(3, F(3)), (-7, F(-7)), (0, F(0)), (F(22, 7), F(22, 7)), ("22/7", F(22, 7)),
                             ("0.1", F(1, 10)), (0.1, F(3602879701896397, 1 << 55)), (".5", F(1, 2)),
                             ("-1.5e-3", F(-3, 2000)), (decimal.Decimal("0.1"), F(1, 10)),
                             (decimal.Decimal("1E+3"), F(1000)), (5e-324, F(1, 1 << 1074)), (-0.0, F(0)),
                             (F(-big, big + 1), F(-big, big + 1)), (1e308, F(1e308))]:
            self.assertEqual(through(value), exact, value)

    def test_random_ratios(self):
        rng = random.Random(common.SEED)
        for _ in range(100 * common.SCALE):
            bits = rng.choice([1, 8, 63, 64, 65, 128, 2000])
            value = F(rng.getrandbits(bits) - (1 << bits - 1), rng.getrandbits(bits) + 1)
            self.assertEqual(through(value), value)

    @unittest.skipIf(common.numpy is None, "numpy")
    def test_numpy_scalars(self):
        np = common.numpy
        for value in (np.float64(0.1), np.float32(0.1), np.int64(-5), np.uint8(200)):
            self.assertEqual(through(value), F(value.item()), repr(value))

    def test_refused(self):
        for value, kind in [("x", graze.InputError), ("", graze.InputError), ("1/0", graze.InputError),
                            ("1 ", graze.InputError), ("nan", graze.InputError), (None, TypeError),
                            (True, TypeError), (1j, TypeError), (b"1", TypeError),
                            (math.nan, graze.InputError), (math.inf, graze.InputError),
                            (decimal.Decimal("nan"), graze.InputError), ("1e99999", graze.LimitError),
                            (decimal.Decimal("1e999999999"), graze.LimitError)]:
            with self.assertRaises(kind, msg=str(type(value))) as raised:
                SCENE.classify([(0.5, 0.5), (1, value)])
            self.assertIn("point 1, coordinate 1", str(raised.exception))

    def test_large_ints_meet_the_limit(self):
        with self.assertRaises(graze.LimitError):
            SCENE.classify([(0, 10 ** 10001)])

    def test_limits_can_be_raised(self):
        loose = common.root_scene(limits={"digits": 200000})
        self.assertEqual(through("1e99999", loose), 10 ** 99999)
        for limits in ({"digit": 3}, {"digits": 0}, {"digits": 1 << 64}):
            with self.assertRaises(graze.UseError, msg=limits):
                common.root_scene(limits=limits)


class Rounding(unittest.TestCase):
    def test_binary64(self):
        """Python's own division of ints is correctly rounded."""
        scene = common.root_scene(round="binary64")
        for value in ("0.1", "1/3", F(1, 3), decimal.Decimal("0.1"), 0.1, 2 ** 53 + 1, 7):
            ratio = F(str(value) if isinstance(value, decimal.Decimal) else value)
            self.assertEqual(through(value, scene), F(ratio.numerator / ratio.denominator), value)
        with self.assertRaises(graze.InputError):
            through("1e309", scene)

    def test_binary32(self):
        """struct rounds to binary32, in arrays, lists of floats and single numbers alike."""
        scene = common.root_scene(round="binary32")
        for value in (0.1, 1 / 3, 16777217.0, 1e-45, 3.5):
            single = F(struct.unpack("f", struct.pack("f", value))[0])
            self.assertEqual(through(value, scene), single, value)
            self.assertEqual(scene.rows([[value, 0.25]])[0].split(",")[0], str(single))
            if common.numpy is not None:
                array = common.numpy.array([[value, 0.25]])
                self.assertEqual(scene.rows(array)[0].split(",")[0], str(single))
                with self.assertRaises(graze.InputError):
                    scene.classify(array * 1e60)
        with self.assertRaises(graze.InputError):
            scene.classify([[1e60, 0.5]])

    def test_parts_must_be_rounded_alike(self):
        solid = graze.Solid(common.SQUARE, round="binary32")
        motion = common.moved("t", "0")
        with self.assertRaises(graze.UseError):
            graze.Scene(solid, motion)
        self.assertEqual(graze.Scene(solid, motion, round="binary32").round, "binary32")


class Shapes(unittest.TestCase):
    def test_rows(self):
        for points, kind in [([1, 2], TypeError), (["12"], TypeError), ([[1]], graze.UseError),
                             ([[1, 2], [1, 2, 3]], graze.UseError), (7, TypeError)]:
            with self.assertRaises(kind, msg=points):
                SCENE.classify(points)
        for empty in ([], (), iter(())):
            self.assertEqual(len(SCENE.classify(empty)), 0)
            self.assertEqual(SCENE.rows([]), [])

    def test_any_rows_will_do(self):
        want = common.tuples(SCENE.classify([(0.5, 0.5), (3.0, 0.25)]))
        for points in (iter([[0.5, 0.5], [3.0, 0.25]]), [["1/2", 0.5], (3, F(1, 4))], ((0.5, 0.5), (3, 0.25))):
            self.assertEqual(common.tuples(SCENE.classify(points)), want)

    @unittest.skipIf(common.numpy is None, "numpy")
    def test_arrays(self):
        """Every layout and dtype of the same values gives the same verdicts."""
        np = common.numpy
        rng = np.random.default_rng(common.SEED)
        values = rng.integers(-8, 40, (300, 2))
        want = common.tuples(SCENE.classify(values.tolist()))
        for dtype in "int64 int32 int8 float64 float32 float16 longdouble object".split():
            self.assertEqual(common.tuples(SCENE.classify(values.astype(dtype))), want, dtype)
        floats = values.astype(float)
        wide = np.zeros((600, 4))
        wide[::2, ::2] = floats
        single = np.array([[2.0, 9.0, 0.5, 9.0]])[:, ::2]
        self.assertEqual(graze.pmc_names(SCENE.classify(single)), ["in"])
        for array in (np.asfortranarray(floats), wide[::2, ::2], floats.astype(">f8"), values.astype(str),
                      floats[::-1][::-1]):
            self.assertEqual(common.tuples(SCENE.classify(array)), want, array.flags)
        unsigned = np.array([[2 ** 64 - 1, 0]], dtype=np.uint64)
        self.assertEqual(SCENE.rows(unsigned)[0].split(",")[0], str(2 ** 64 - 1))
        for bad in (np.zeros(2), np.zeros((2, 3)), np.zeros((1, 2, 2))):
            with self.assertRaises(graze.UseError):
                SCENE.classify(bad)
        for bad in (np.zeros((2, 2), bool), np.zeros((2, 2), complex), np.zeros((1, 2), "M8[s]")):
            with self.assertRaises(TypeError):
                SCENE.classify(bad)
        floats[7, 1] = np.nan
        with self.assertRaises(graze.InputError) as raised:
            SCENE.classify(floats)
        self.assertIn("point 7, coordinate 1", str(raised.exception))
        self.assertEqual(len(SCENE.classify(np.zeros((0, 2)))), 0)
