"""Answers: verdicts, and the contacts behind one of them.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import enum
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

from ._abi import C, words
from ._frames import by_name, column_names, coordinate_names, named_entries, read_columns
from ._numbers import numpy
from .errors import GrazeError
from .times import Time


class Pmc(enum.IntEnum):
    """Point membership; `NONE` is never a verdict, `UNDECIDED` one of curved solids alone."""

    NONE = C.GRAZE_PMC_NONE
    IN = C.GRAZE_IN
    ON = C.GRAZE_ON
    OUT = C.GRAZE_OUT
    UNDECIDED = C.GRAZE_PMC_UNDECIDED


class Class(enum.IntEnum):
    """The class by Definitions 5 to 11; `NONE` for unsweep, `UNDECIDED` for curved solids alone.

    Where it is `UNDECIDED`, pmc may be decided, and counts, case and definition are 0.
    """

    NONE = C.GRAZE_CLASS_NONE
    REGULAR = C.GRAZE_REGULAR
    FOLD = C.GRAZE_FOLD
    FOLD_BOUNDARY = C.GRAZE_FOLD_BOUNDARY
    BOUNDARY = C.GRAZE_BOUNDARY
    EXTERIOR = C.GRAZE_EXTERIOR
    UNDECIDED = C.GRAZE_CLASS_UNDECIDED


class Verdict(NamedTuple):
    """Verdict of one point.

    `definition` is 5 to 11, or 0: for cases 5, 6, 8, 9, which tables call `ext`, and for unsweep.
    `case` is the position case 1 to 9, 0 for unsweep. i and t count intersections and tangencies.
    """

    pmc: Pmc
    class_: Class
    definition: int
    case: int
    i: int
    t: int


class Enclosure(NamedTuple):
    """Enclosure of one point's signed distance to the sweep, negative where the point is `in`.

    low <= s <= high. `time` is a double nearest to a time at which the signed distance to the solid
    is at most high (for an unsweep at least low). `wide`: high - low is more than the tolerance.
    """

    low: float
    high: float
    time: float
    pmc: Pmc
    wide: bool


class Topology(NamedTuple):
    """Where a point lies relative to the closed sweep, or to the regularised unsweep.

    `position` is `interior`, `boundary`, `exterior` or `undecided`, `level` what decided it (`word`,
    `first_order`, `closed_cones`, `edges`, `leading_terms`, `section`, `curves`, else `none`),
    `reason` why it is undecided, else "". `witness` is a point that is `out`, for an `on` point that
    is `boundary`; of `Scene.regularised` one that is `in`, and so are all below. By first order it is point + epsilon * direction, and all nearer ones are `out`
    too. By leading terms it is point + s**order * direction + s**(order + 1) * z * normal with
    s = `epsilon`, and all with 0 < s < epsilon are `out` too. Else it is point + x a + y b with (a, b) = `plane` and x or y of size
    `rho`, none larger, and every smaller square has such a point too.
    """

    position: str
    level: str
    reason: str
    witness: Optional[Tuple[Fraction, ...]]
    direction: Optional[Tuple[int, ...]] = None
    epsilon: Optional[Fraction] = None
    plane: Optional[Tuple[Tuple[int, ...], Tuple[int, ...]]] = None
    rho: Optional[Fraction] = None
    normal: Optional[Tuple[int, ...]] = None
    z: Optional[Fraction] = None
    order: Optional[int] = None


PMC_NAMES: Tuple[str, ...] = tuple(words("graze_pmc"))
CLASS_NAMES: Tuple[str, ...] = tuple(words("graze_class"))


def _dtype(made: Any) -> Any:
    """The dtype of arrays of a structure; None without numpy."""
    if numpy is None:
        return None
    names, formats = zip(*made._fields_)
    return numpy.dtype({"names": [name.rstrip("_") for name in names], "formats": formats}, align=True)


#: The dtype of classify's arrays, whose layout is graze_verdict; None without numpy.
VERDICT_DTYPE: Any = _dtype(C.graze_verdict)
#: The dtype of distance's arrays, whose layout is graze_enclosure; None without numpy.
ENCLOSURE_DTYPE: Any = _dtype(C.graze_enclosure)


@dataclass(frozen=True)
class Cell:
    """A boundary cell in the numbering of the input, from 0.

    `kind` is `face`, `edge` or `vertex`; `indices` is (face,), (u, v) with u < v, or (vertex,).
    """

    kind: str
    indices: Tuple[int, ...]

    def __str__(self) -> str:
        return f"{self.kind} {'-'.join(map(str, self.indices))}"


@dataclass(frozen=True)
class Contact:
    """A maximal interval of times, perhaps one instant, at which the trajectory is on the boundary.

    `kind` is `intersection` or `tangency`. `left` and `right` are the states `I` or `O` beside it,
    None at an end of the motion. `start` and `end` are exact and equal for an instant. `cells` are
    the boundary cells met, sorted.
    """

    kind: str
    left: Optional[str]
    right: Optional[str]
    start: Time
    end: Time
    cells: Tuple[Cell, ...]

    @property
    def is_instant(self) -> bool:
        """Whether the contact is one instant and not a slide."""
        return self.start is self.end or self.start == self.end


@dataclass(frozen=True)
class Trace:
    """A point, the word of its trajectory, its verdict and all contacts in order of time."""

    point: Tuple[Fraction, ...]
    word: str
    verdict: Verdict
    contacts: Tuple[Contact, ...]


@dataclass(frozen=True)
class Sample:
    """A generated query point and how it was made.

    Attributes:
        point: its coordinates.
        stratum: `random`, `near`, `face`, ... as `graze generate` names them.
        time: the time of the contact it was made by; None without one.
        cell: the boundary cell of that contact; None without one.
        order: the order of contact with that cell's plane; -1 a slide in it, 0 without a contact.
        k: the point was displaced by 2^-k along the normal; 0 if it was not.
        outward: whether it was displaced to the outside.
        decade: of the stratum `level`: 10^decade <= |s| < 10^(decade + 1); else None.
        pmc: of points beside a contact, `rounded-...`: the exact answer; else None.
    """

    point: Tuple[Fraction, ...]
    stratum: str
    time: Optional[Fraction]
    cell: Optional[Cell]
    order: int
    k: int
    outward: bool
    decade: Optional[int] = None
    pmc: Optional[Pmc] = None


def _field(results: Any, name: str) -> List[int]:
    if hasattr(results, "dtype"):
        return list(results[name].tolist())
    return [getattr(verdict, "class_" if name == "class" else name) for verdict in results]


def pmc_names(results: Any) -> List[str]:
    """`in`, `on` or `out` for each verdict of `Scene.classify`."""
    return [PMC_NAMES[value] for value in _field(results, "pmc")]


def class_names(results: Any) -> List[str]:
    """`regular`, `fold`, `fold_boundary`, `boundary` or `exterior` for each verdict."""
    return [CLASS_NAMES[value] for value in _field(results, "class")]


def definition_names(results: Any) -> List[str]:
    """`5` to `11`, or `ext` where no definition of the paper says it; empty for unsweep."""
    return [str(definition) if definition else "ext" if case else ""
            for definition, case in zip(_field(results, "definition"), _field(results, "case"))]


def _coordinates(points: Any) -> Dict[str, Any]:
    """x, y and in space z of points as `Scene.classify` takes them: named columns and entries by
    their names, others by position."""
    names = column_names(points)
    if names is not None:
        wanted = coordinate_names(names, 0, "point")
        return dict(zip(wanted, read_columns(points, wanted, "point")))
    if numpy is not None and hasattr(points, "__array__"):
        array = numpy.asarray(points)
        return {name: array[:, k] for k, name in enumerate("xyz"[:array.shape[1]])}
    rows = []
    for row in points:
        entries = named_entries(row)
        rows.append(row if entries is None
                    else by_name(row, coordinate_names(entries, 0, "point")))
    return {name: [row[k] for row in rows]
            for k, name in enumerate("xyz"[:len(rows[0]) if rows else 0])}


def _are_enclosures(results: Any) -> bool:
    """Are these answers of `Scene.distance`?"""
    if hasattr(results, "dtype"):
        return "high" in (results.dtype.names or ())
    return len(results) > 0 and hasattr(results[0], "high")


def _others(out: Dict[str, Any], points: Any) -> None:
    """Add the other columns of a table with names, under another name where theirs is taken."""
    for given in (column_names(points) or []) if points is not None else []:
        name = given
        if given in ("x", "y", "z")[:3 if "z" in out else 2]:
            continue
        while name in out:
            name = f"{name}_in"
        out[name] = points[given]


def columns(results: Any, points: Any = None) -> Dict[str, Any]:
    """Answers as columns in the words of the tables, after x, y, z of the points if given.

    Args:
        results: what `Scene.classify` returned (pmc, class, definition, case, i, t), or
            `Scene.distance` (pmc, sdf_low, sdf_high, sdf_t).
        points: the points; the other columns of a table with names come last, with `_in` behind a
            name that is taken.
    """
    out: Dict[str, Any] = {} if points is None else _coordinates(points)
    for name, column in out.items():
        if len(column) != len(results):
            raise ValueError(f"{len(column)} points for {len(results)} verdicts")
    out["pmc"] = pmc_names(results)
    if _are_enclosures(results):
        for name, field in (("sdf_low", "low"), ("sdf_high", "high"), ("sdf_t", "time")):
            out[name] = _field(results, field)
    else:
        out["class"] = class_names(results)
        out["definition"] = definition_names(results)
        for name in ("case", "i", "t"):
            out[name] = _field(results, name)
    _others(out, points)
    return out


def to_dataframe(results: Any, points: Any = None) -> Any:
    """Answers as a pandas DataFrame, pmc and class as categories; needs pandas.

    Args:
        results, points: as for `columns`; the index is that of points, if they are a DataFrame.
    Raises:
        GrazeError: pandas is not installed.
    """
    try:
        import pandas  # type: ignore
    except ImportError:
        raise GrazeError("to_dataframe needs pandas; `columns` gives the same as a dict") from None
    out = columns(results, points)
    out["pmc"] = pandas.Categorical(out["pmc"], categories=PMC_NAMES[1:])
    if not _are_enclosures(results):
        out["class"] = pandas.Categorical(out["class"], categories=CLASS_NAMES[1:])
    if isinstance(points, pandas.DataFrame):
        return pandas.DataFrame(out, index=points.index)
    return pandas.DataFrame(out)
