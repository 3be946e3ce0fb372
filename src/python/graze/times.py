"""Exact times: rational, or a real root of an integer polynomial.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import functools
import math
from fractions import Fraction
from typing import Any, Sequence, Tuple, Union


@functools.total_ordering
class AlgebraicNumber:
    """An irrational real number: the one root of its minimal polynomial in an open interval.

    Numbers are compared exactly, with each other and with int, Fraction and float (taken as the
    dyadic rational it is). They are immutable, hashable and may be shared by threads.

    Attributes:
        coefficients: c0, c1, ... of the polynomial c0 + c1 t + ..., of degree 2 or more.
    """

    __slots__ = ("coefficients", "_interval", "_narrow", "_rising")

    def __init__(self, coefficients: Sequence[int], low: Fraction, high: Fraction) -> None:
        """The root of an irreducible polynomial in (low, high), which holds no other root of it.

        Raises:
            ValueError: the degree is below 2, or the polynomial has no change of sign there.
        """
        self.coefficients: Tuple[int, ...] = tuple(int(c) for c in coefficients)
        self._interval = self._narrow = (Fraction(low), Fraction(high))
        if len(self.coefficients) < 3 or self.coefficients[-1] == 0:
            raise ValueError("the degree is below 2; such a number is a Fraction")
        signs = [self._sign_at(end.numerator, end.denominator) for end in self._interval]
        if signs[0] * signs[1] != -1 or low >= high:
            raise ValueError(f"the polynomial does not change its sign from {low} to {high}")
        self._rising = signs[1] > 0

    def _sign_at(self, numerator: int, denominator: int) -> int:
        """The sign of the polynomial at a rational, in integers; the denominator is positive."""
        value, power = 0, 1
        for c in reversed(self.coefficients):
            value = value * numerator + c * power
            power *= denominator
        return (value > 0) - (value < 0)

    @property
    def degree(self) -> int:
        """The degree of the minimal polynomial."""
        return len(self.coefficients) - 1

    @property
    def interval(self) -> Tuple[Fraction, Fraction]:
        """The open interval that the number was given by."""
        return self._interval

    def refine(self, bits: int) -> Tuple[Fraction, Fraction]:
        """An open interval that holds the number and is no wider than 2^-bits."""
        low, high = self._narrow
        scale = math.lcm(low.denominator, high.denominator)
        a, b = int(low * scale), int(high * scale)
        while (b - a) << max(bits, 0) > scale << max(-bits, 0):
            a, b, scale = 2 * a, 2 * b, 2 * scale
            middle = (a + b) // 2
            if (self._sign_at(middle, scale) > 0) == self._rising:
                b = middle
            else:
                a = middle
        # One assignment: another thread sees the old interval or the new one.
        self._narrow = Fraction(a, scale), Fraction(b, scale)
        return self._narrow

    def __float__(self) -> float:
        """The nearest float."""
        bits = 64
        while True:
            low, high = self.refine(bits)
            if float(low) == float(high):
                return float(low)
            bits *= 2

    def decimal(self, digits: int = 17) -> str:
        """The number rounded to nearest at 1 to 1000 significant digits (see `decimal`)."""
        _check_digits(digits)
        bits = 16 + 4 * digits
        while True:
            low, high = (_digits(end, digits) for end in self.refine(bits))
            if low == high:
                return _layout(low)
            bits *= 2

    def _above(self, q: Fraction) -> bool:
        """Whether the number is larger than a rational, which it never equals."""
        low, high = self._narrow
        if q <= low or q >= high:
            return q <= low
        return bool((self._sign_at(q.numerator, q.denominator) > 0) != self._rising)

    def __eq__(self, other: Any) -> bool:
        if not isinstance(other, AlgebraicNumber):
            if isinstance(other, (int, float, Fraction)):
                return False
            return NotImplemented
        low, high = other._interval
        return (self.coefficients == other.coefficients and self._above(low)
                and not self._above(high))

    def __hash__(self) -> int:
        return hash(self.coefficients)

    def __lt__(self, other: Any) -> bool:
        if isinstance(other, float) and math.isinf(other):
            return other > 0
        if isinstance(other, (int, float, Fraction)):
            return not self._above(Fraction(other))
        if not isinstance(other, AlgebraicNumber):
            return NotImplemented
        if self == other:
            return False
        bits = 8
        while True:
            mine, theirs = self.refine(bits), other.refine(bits)
            if mine[1] <= theirs[0] or theirs[1] <= mine[0]:
                return mine[1] <= theirs[0]
            bits *= 2

    def __repr__(self) -> str:
        return (f"AlgebraicNumber({list(self.coefficients)}, {self._interval[0]!r}, "
                f"{self._interval[1]!r})")

    def __str__(self) -> str:
        return self.decimal(17)


Time = Union[Fraction, AlgebraicNumber]


def decimal(time: Time, digits: int = 17) -> str:
    """A time rounded to nearest (ties to even) at 1 to 1000 significant decimal digits.

    Trailing zeros are left out where the decimal is the number itself. Numbers below 10^-5 and
    those with more places than digits have an exponent.

    Raises:
        ValueError: `digits` is out of its range.
    """
    _check_digits(digits)
    if isinstance(time, AlgebraicNumber):
        return time.decimal(digits)
    rounded = _digits(Fraction(time), digits)
    sign, figures, exponent = rounded
    exact = sign * int(figures) * Fraction(10) ** (exponent - digits) == time
    if exact:
        return _layout((sign, figures.rstrip("0") or "0", exponent), digits)
    return _layout(rounded)


def _check_digits(digits: int) -> None:
    if not 1 <= digits <= 1000:
        raise ValueError(f"{digits} digits; expected 1 to 1000")


def _digits(value: Fraction, digits: int) -> Tuple[int, str, int]:
    """Sign, figures and exponent of 0.FIGURES * 10^exponent, rounded to nearest, ties to even."""
    if value == 0:
        return 1, "0" * digits, 1
    size = abs(value)
    exponent = math.floor((size.numerator.bit_length() - size.denominator.bit_length()) * 0.30103)
    while size >= Fraction(10) ** exponent:
        exponent += 1
    while size < Fraction(10) ** (exponent - 1):
        exponent -= 1
    figures = str(round(size * Fraction(10) ** (digits - exponent)))
    # Rounding up 99...9 gives one figure more.
    exponent += len(figures) > digits
    return (1 if value > 0 else -1), figures[:digits], exponent


def _layout(rounded: Tuple[int, str, int], digits: int = 0) -> str:
    sign, figures, exponent = rounded
    count = digits or len(figures)
    lead = "-" if sign < 0 else ""
    if exponent > count or exponent < -4:
        return f"{lead}{figures[0]}{'.' if figures[1:] else ''}{figures[1:]}e{exponent - 1}"
    if exponent <= 0:
        return f"{lead}0.{'0' * -exponent}{figures}"
    figures = figures.ljust(exponent, "0")
    return lead + figures[:exponent] + ("." + figures[exponent:] if figures[exponent:] else "")
