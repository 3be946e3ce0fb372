"""Algebraic numbers and decimals, against roots and digits that are known.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import decimal
import math
import random
import unittest
from fractions import Fraction as F

import common
from graze import AlgebraicNumber, decimal as decimal_of

ROOT2 = AlgebraicNumber([-2, 0, 1], 1, 2)


class Algebraic(unittest.TestCase):
    def test_refine_brackets_root_two(self):
        """sqrt 2 is in (a, b) exactly if a^2 < 2 < b^2, for positive a and b."""
        for bits in (-3, 0, 1, 53, 54, 300, 2000):
            low, high = AlgebraicNumber([-2, 0, 1], 1, 2).refine(bits)
            self.assertTrue(0 < low and low ** 2 < 2 < high ** 2, bits)
            self.assertLessEqual(high - low, F(2) ** -bits)
        self.assertEqual(ROOT2.interval, (1, 2))

    def test_refine_falling_polynomial_and_odd_ends(self):
        """-sqrt 2 in (-5/3, -1), where the polynomial falls."""
        low, high = AlgebraicNumber([-2, 0, 1], F(-5, 3), -1).refine(200)
        self.assertTrue(high < 0 and high ** 2 < 2 < low ** 2)
        self.assertLessEqual(high - low, F(1, 1 << 200))

    def test_float_and_decimal_against_integer_roots(self):
        """Digits of square roots by isqrt, correctly rounded floats by math.sqrt (IEEE)."""
        rng = random.Random(common.SEED)
        for _ in range(50 * common.SCALE):
            n = rng.choice([k for k in range(2, 10 ** 6, 37) if math.isqrt(k) ** 2 != k])
            whole = math.isqrt(n)
            x = AlgebraicNumber([-n, 0, 1], whole, whole + 1)
            self.assertEqual(float(x), math.sqrt(n), n)
            digits = rng.choice([1, 2, 17, 60])
            with decimal.localcontext(decimal.Context(prec=digits)):
                exact = decimal.Decimal(n).sqrt()
            self.assertEqual(F(x.decimal(digits)), F(exact), (n, digits))

    def test_compare(self):
        root3 = AlgebraicNumber([-3, 0, 1], 1, 2)
        self.assertTrue(ROOT2 < root3 and root3 > ROOT2 and ROOT2 <= root3 and ROOT2 != root3)
        fresh = AlgebraicNumber([-2, 0, 1], 1, 2)
        self.assertTrue(F(7, 5) < fresh < F(3, 2))
        self.assertTrue(F(7, 5) < ROOT2 < F(3, 2) and ROOT2 > 1 and ROOT2 < 2.0 and 0 < ROOT2)
        self.assertTrue(-math.inf < ROOT2 < math.inf)
        self.assertFalse(ROOT2 == F(math.sqrt(2)))
        self.assertEqual(ROOT2 < math.sqrt(2), F(math.sqrt(2)) ** 2 > 2)
        minus = AlgebraicNumber([-2, 0, 1], -2, -1)
        self.assertTrue(minus < ROOT2 and minus != ROOT2 and ROOT2 != minus)
        self.assertTrue(F(-3, 2) < minus < F(-7, 5))
        wide = AlgebraicNumber([2, -4, 1], 2, 4), AlgebraicNumber([2, -4, 1], 0, 1)
        self.assertTrue(wide[1] != wide[0] != wide[1] and wide[1] < wide[0], "2 + sqrt 2, 2 - sqrt 2")
        same = AlgebraicNumber([-2, 0, 1], F(7, 5), F(3, 2))
        self.assertEqual(same, ROOT2)
        self.assertEqual(hash(same), hash(ROOT2))
        self.assertNotEqual(ROOT2, "sqrt 2")
        with self.assertRaises(TypeError):
            self.assertTrue(ROOT2 < "2")

    def test_close_roots_are_told_apart(self):
        """sqrt 2 and the root of 10^60 t^2 - (2 10^60 + 1), which is larger by about 10^-61."""
        near = AlgebraicNumber([-2 * 10 ** 60 - 1, 0, 10 ** 60], 1, 2)
        self.assertTrue(ROOT2 < near and not near < ROOT2 and float(near) == float(ROOT2))

    def test_refused(self):
        for arguments in (([-2, 1], 1, 3), ([-2, 0, 1], 2, 3), ([-2, 0, 1], 2, 1), ([-2, 0, 1, 0], 2, 3),
                          ([1, 0, 1], 0, 1)):
            with self.assertRaises(ValueError, msg=arguments):
                AlgebraicNumber(*arguments)
        for digits in (0, 1001):
            with self.assertRaises(ValueError):
                ROOT2.decimal(digits)

    def test_text(self):
        """sqrt 2 = 1.41421356237309504880..., 17 digits of it by default."""
        self.assertEqual(str(ROOT2), "1.4142135623730950")
        self.assertEqual(repr(ROOT2), "AlgebraicNumber([-2, 0, 1], Fraction(1, 1), Fraction(2, 1))")


class Decimals(unittest.TestCase):
    def test_rationals(self):
        for value, digits, text in [
                (F(3, 8), 17, "0.375"), (F(1, 3), 5, "0.33333"), (F(2, 3), 5, "0.66667"),
                (F(3, 20), 1, "0.2"), (F(1, 4), 1, "0.2"), (F(-22, 7), 3, "-3.14"), (F(0), 5, "0"),
                (F(1000), 2, "1e3"), (F(1200), 4, "1200"), (F(99996, 10), 4, "1.000e4"),
                (F(12345), 3, "1.23e4"), (F(1, 10 ** 5), 3, "0.00001"), (F(1, 10 ** 6), 3, "1e-6"),
                (F(1, 3 * 10 ** 6), 3, "3.33e-7"), (F(-5), 17, "-5")]:
            self.assertEqual(decimal_of(value, digits), text, (value, digits))
        with self.assertRaises(ValueError):
            decimal_of(F(1), 0)
