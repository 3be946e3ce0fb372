"""Exact numbers between Python and GMP, and points as the library takes them.

A float is the dyadic rational it is, an int and a Fraction are themselves, a str is a number token
(`0.1`, `22/7`, `1.5e-3`), a Decimal is its text. Where the context rounds, every one of them is
rounded, once. Nothing else is a number.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import array
import ctypes
import decimal
import math
import numbers
import operator
from fractions import Fraction
from typing import Any, Iterable, List, Tuple

from ._abi import C
from ._context import Context
from ._frames import (by_name, column_names, coordinate_names, named_entries, read_columns,
                      refuse_masked)
from ._library import library
from .errors import GrazeError, InputError, UseError

numpy: Any = None
try:
    import numpy
except ImportError:
    pass

_BINARY32 = 2
_MPQ = C.__mpq_struct
_SIZE = ctypes.sizeof(_MPQ)


class Rationals:
    """An array of `count` GMP rationals, all 0 at first; freed with this object."""

    def __init__(self, count: int) -> None:
        self._array = (_MPQ * count)()
        self.address = ctypes.addressof(self._array)
        self._clear = library().mpq_clear
        self.count = 0
        init = library().mpq_init
        for k in range(count):
            init(self.address + k * _SIZE)
            self.count = k + 1

    def __del__(self) -> None:
        for k in range(getattr(self, "count", 0)):
            self._clear(self.address + k * _SIZE)

    def at(self, index: int) -> int:
        """The address of one of them."""
        return self.address + index * _SIZE

    def __getitem__(self, index: int) -> Fraction:
        text = self._text(index, 16).split("/")
        return Fraction(int(text[0], 16), int(text[1], 16) if len(text) > 1 else 1)

    def _text(self, index: int, base: int) -> str:
        at, size = self.at(index), library().mpz_sizeinbase
        room = ctypes.create_string_buffer(size(at, base) + size(at + _SIZE // 2, base) + 3)
        library().mpq_get_str(room, base, at)
        return room.value.decode("ascii")

    def set(self, index: int, value: Any, context: Context) -> None:
        """Set one of them to a number, rounded as the context says.

        Raises:
            TypeError: the value is none of the kinds of number.
            InputError, LimitError: it is no number token, not finite, or too large to be rounded.
        """
        at = self.at(index)
        if isinstance(value, decimal.Decimal):
            value = str(value)
        if isinstance(value, str):
            self._parse(at, value, context)
            return
        if isinstance(value, float):
            if not math.isfinite(value):
                raise InputError(f"{value} is not a number; expected a finite one")
            library().mpq_set_d(at, value)
        else:
            numerator, denominator = _ratio(value)
            text = f"{numerator:x}/{denominator:x}".encode()
            library().mpq_set_str(at, text, 16)
        if context.rounding:
            self._parse(at, self._text(index, 10), context)

    @staticmethod
    def _parse(at: int, text: str, context: Context) -> None:
        token = text.encode("utf-8", "surrogateescape")
        context.check(library().graze_number_parse(at, context.pointer, token, len(token)))


def _ratio(value: Any) -> Tuple[int, int]:
    """Numerator and denominator, in lowest terms, of what is neither text nor a float."""
    if isinstance(value, bool):
        pass
    elif isinstance(value, numbers.Rational):
        return int(value.numerator), int(value.denominator)
    elif isinstance(value, numbers.Real) and hasattr(value, "as_integer_ratio"):
        try:
            numerator, denominator = value.as_integer_ratio()
        except (ValueError, OverflowError):
            raise InputError(f"{value} is not a number; expected a finite one") from None
        return int(numerator), int(denominator)
    raise TypeError(f"{type(value).__name__} is no exact number; expected float, int, Fraction, "
                    "Decimal or str")


class Points:
    """n points of d coordinates: as doubles where all of them are, else as rationals."""

    def __init__(self, dimension: int, doubles: Any, rationals: "Rationals | None") -> None:
        self.dimension = dimension
        self._doubles = doubles
        self._rationals = rationals
        self.count = (len(doubles) if rationals is None else rationals.count) // dimension

    @property
    def are_doubles(self) -> bool:
        """Whether `address` leads to doubles."""
        return self._rationals is None

    def address(self, first: int) -> int:
        """The address of the first coordinate of a point."""
        index = first * self.dimension
        if self._rationals is not None:
            return self._rationals.at(index)
        if isinstance(self._doubles, array.array):
            return self._doubles.buffer_info()[0] + 8 * index
        return int(self._doubles.ctypes.data) + 8 * index

    def exact(self, first: int, count: int) -> Tuple[Rationals, int]:
        """`count` points from `first` as rationals: an array, and where in it they begin."""
        low, high = first * self.dimension, (first + count) * self.dimension
        if self._rationals is not None:
            return self._rationals, low
        out = Rationals(high - low)
        for k in range(low, high):
            library().mpq_set_d(out.at(k - low), self._doubles[k])
        return out, 0


def read_points(points: Any, dimension: int, context: Context, what: str = "point") -> Points:
    """Points from an array of numpy, rows of numbers, or what has columns with names.

    Args:
        points: n rows of d numbers. A DataFrame, or a row that is a Series or a named tuple, is
            read by the names x, y and z, others being left out; what else offers `__array__` is
            taken as an array of numpy.
        dimension: d; 0 takes it from the rows.
        what: the word for a row in messages.
    Raises:
        TypeError: something is no number, or no row.
        UseError: the shape is wrong, or a column is missing.
        InputError, LimitError: a number cannot be read or is masked, named by row and coordinate.
    """
    names = column_names(points)
    if names is not None:
        wanted = coordinate_names(names, dimension, what)
        dimension = len(wanted)
        points = _from_columns(read_columns(points, wanted, what))
        if numpy is not None and isinstance(points, numpy.ndarray):
            return _from_array(points, dimension, context, what)
    elif numpy is not None and hasattr(points, "__array__"):
        given = points if isinstance(points, numpy.ndarray) else numpy.asarray(points)
        if given.ndim != 2 and given.size:
            raise UseError(f"an array of the shape {given.shape}; expected (n, {dimension or 'd'})")
        refuse_masked(given, what, given.shape[-1])
        if _holds_doubles(given):
            return _from_array(given, dimension, context, what)
        points = given.tolist() if given.size else []
    flat: List[Any] = []
    for k, row in enumerate(points):
        if isinstance(row, (str, bytes)) or not isinstance(row, Iterable):
            raise TypeError(f"{what} {k} is {row!r:.40}, no row of numbers; expected a list of {what}s, "
                            f"as [[5, 1{', 1' if dimension != 2 else ''}]]")
        before = len(flat)
        entries = named_entries(row)
        if entries is not None:
            row = by_name(row, coordinate_names(entries, dimension, what))
        flat.extend(row)
        dimension = dimension or len(flat)
        if len(flat) - before != dimension:
            raise UseError(f"{what} {k} has {len(flat) - before} coordinates; expected {dimension}")
    if all(type(value) is float for value in flat) and context.rounding != _BINARY32:
        doubles = array.array("d", flat)
        for k, value in enumerate(flat):
            if not math.isfinite(value):
                raise _not_finite(what, k, dimension, value)
        return Points(dimension or 1, doubles, None)
    rationals = Rationals(len(flat))
    for k, value in enumerate(flat):
        try:
            rationals.set(k, value, context)
        except (GrazeError, TypeError) as problem:
            place = f"{what} {k // dimension}, coordinate {k % dimension}: "
            raise type(problem)(place + str(problem)) from None
    return Points(dimension or 1, None, rationals)


def _holds_doubles(given: Any) -> bool:
    """Longer integers and floats may not be doubles."""
    return given.dtype.kind in "fiu" and given.itemsize <= (8 if given.dtype.kind == "f" else 4)


def _from_columns(columns: List[Any]) -> Any:
    """One array of doubles where all columns hold doubles, else rows."""
    if numpy is None:
        return list(zip(*columns))
    if not all(map(_holds_doubles, columns)):
        return list(zip(*(column.tolist() for column in columns)))
    out = numpy.empty((len(columns[0]), len(columns)), numpy.float64)
    for k, column in enumerate(columns):
        out[:, k] = column
    return out


def _from_array(given: Any, dimension: int, context: Context, what: str) -> Points:
    if given.size and dimension and given.shape[1] != dimension:
        raise UseError(f"an array of the shape {given.shape}; expected (n, {dimension})")
    dimension = dimension or (given.shape[1] if given.size else 1)
    flat = numpy.ascontiguousarray(given, dtype=numpy.float64).reshape(-1)
    if context.rounding == _BINARY32:
        with numpy.errstate(over="ignore"):
            flat = flat.astype(numpy.float32).astype(numpy.float64)
    finite = numpy.isfinite(flat)
    if not finite.all():
        k = int(numpy.argmin(finite))
        raise _not_finite(what, k, dimension, given.reshape(-1)[k])
    return Points(dimension, flat, None)


def _not_finite(what: str, k: int, dimension: int, value: Any) -> InputError:
    return InputError(f"{what} {k // dimension}, coordinate {k % dimension}: {value} is not a "
                      "finite number, or too large for the rounding")


def whole(name: str, value: Any, least: int, most: int) -> int:
    """An integer within bounds; ctypes would take others modulo 2^64."""
    try:
        number = operator.index(value)
    except TypeError:
        number = least - 1
    if not least <= number <= most:
        raise UseError(f"{name} is {value!r}; expected an integer from {least} to {most}")
    return number


def rounded(name: str, value: Any, towards: float) -> float:
    """A positive number as a double, rounded towards another one; None is 0."""
    if value is None:
        return 0.0
    try:
        exact = Fraction(value)
        near = float(exact)
        wrong = near > exact if towards == 0 else near < exact
        near = math.nextafter(near, towards) if wrong else near
    except (ValueError, ZeroDivisionError, OverflowError):
        exact, near = Fraction(0), 0.0
    if exact <= 0 or not 0 < near < math.inf:
        raise UseError(f"{name} is {value!r}; expected a positive number in the range of floats")
    return near
