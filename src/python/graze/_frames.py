"""Rows of coordinates from tables with named columns, and what must not be read by position.

A DataFrame of pandas or polars, a table of astropy or pyarrow is known by what it offers, and none
of these packages is imported. Columns are taken by their names, in whatever order they stand.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

from typing import Any, List, Optional, Sequence, Tuple

from .errors import InputError, UseError

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

_NAMES = ("x", "y", "z")


def column_names(points: Any) -> Optional[List[Any]]:
    """The names of the columns, or None of what has none."""
    names = getattr(points, "column_names", None)
    if names is None:
        names = getattr(points, "columns", None)
    return None if names is None or callable(names) else list(names)


def coordinate_names(names: Sequence[Any], dimension: int, what: str) -> Tuple[str, ...]:
    """The names to read by: x, y and in E^3 z, each once among the columns.

    Args:
        dimension: 2 or 3; 0: 3 where there is a column z.
    Raises:
        UseError: one of them is missing or stands there twice.
    """
    wanted = _NAMES[:dimension or (3 if "z" in names else 2)]
    for name in wanted:
        count = sum(1 for given in names if isinstance(given, str) and given == name)
        if count != 1:
            found = ", ".join(repr(given) for given in names[:20])
            raise UseError(f"the column {name} of the {what}s "
                           f"{'stands there twice' if count else 'is missing'}; expected the "
                           f"columns {', '.join(wanted)} once each among others, not {found}")
    return wanted


def read_columns(points: Any, wanted: Sequence[str], what: str) -> List[Any]:
    """The columns of these names: arrays where numpy is, else lists; none is masked.

    Raises:
        UseError: they are not of one length.
        InputError: an entry is masked.
    """
    columns: List[Any] = []
    for place, name in enumerate(wanted):
        column = points[name]
        if numpy is None:
            column = list(column)
        elif not isinstance(column, numpy.ndarray):
            column = numpy.asarray(column)
        if numpy is not None and column.ndim != 1:
            raise UseError(f"the column {name} of the {what}s has the shape {column.shape}; "
                           "expected one number a row")
        if columns and len(column) != len(columns[0]):
            raise UseError(f"the column {name} of the {what}s has {len(column)} rows; expected "
                           f"{len(columns[0])}, as the column {wanted[0]} has")
        refuse_masked(column, what, len(wanted), place)
        columns.append(column)
    return columns


def named_entries(row: Any) -> Optional[List[Any]]:
    """The names of a row's entries: a Series has an index of them, a named tuple fields; else None.

    A named tuple without x, y and z is a tuple like any other, and so is a Series that counts.
    """
    if type(row) in (list, tuple):
        return None
    fields = getattr(row, "_fields", None)
    if isinstance(fields, tuple):
        return list(fields) if any(name in fields for name in _NAMES) else None
    index = getattr(row, "index", None)
    if index is None or callable(index):
        return None
    names = list(index)
    return names if any(isinstance(name, str) for name in names) else None


def by_name(row: Any, wanted: Sequence[str]) -> List[Any]:
    """The entries of these names of a Series or a named tuple."""
    if isinstance(row, tuple):
        return [getattr(row, name) for name in wanted]
    return [row[name] for name in wanted]


def refuse_masked(given: Any, what: str, width: int, first: int = 0) -> None:
    """A masked array's masked entries hold arbitrary numbers, so it is refused.

    Args:
        given: an array; a column of coordinate `first`, or rows of `width`.
    Raises:
        InputError: an entry is masked, named by row and coordinate.
    """
    if numpy is None or not isinstance(given, numpy.ma.MaskedArray):
        return
    mask: Any = numpy.ma.getmaskarray(given)  # type: ignore[no-untyped-call]
    if not mask.any():
        return
    k = int(numpy.argmax(mask.reshape(-1)))
    row, place = (k, first) if given.ndim == 1 else divmod(k, width)
    raise InputError(f"{what} {row}, coordinate {place}: the value is masked; expected a number")
