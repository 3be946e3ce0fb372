"""A moving solid against a fixed one: do they meet, when, and with which cells.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import os
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Tuple, Union

from ._abi import C
from ._context import Context, settings
from ._library import Handle, library
from ._motions import filled
from ._numbers import rounded
from ._traces import cell_of, kind_of, time_of
from .errors import UseError
from .inputs import Motion, Solid, input_handle, input_settings
from .results import Cell
from .times import Time

MotionLike = Union[Motion, str, "os.PathLike[str]", Mapping[str, Any]]


@dataclass(frozen=True)
class CellPair:
    """Two relatively open cells that have a point in common; `type` is `vertex-facet`, `edge-edge`, ...,
    the moving one first."""

    moving: Cell
    fixed: Cell
    type: str


@dataclass(frozen=True)
class PairContact:
    """A maximal interval [start, end] of times at which the solids touch only. `cells` are all pairs that
    meet at `start`, `row` is that of the first piece of the motion that has `start`, None if it has none. `kind` is `intersection` or `tangency`; `kind`, `left`, `right` and `end` are None
    where only the first contact was asked for, `left` and `right` beyond an end of the motion."""

    kind: Optional[str]
    left: Optional[str]
    right: Optional[str]
    start: Time
    end: Optional[Time]
    cells: Tuple[CellPair, ...]
    row: Optional[int] = None


@dataclass(frozen=True)
class Closest:
    """How near two solids come: the least distance lies in [low, high]. At `time` it is at most `high`; `at` has decimals of
    a point of each solid, the moving one's first, that far apart. Where they meet `low` and `high` are 0, `time` is the
    first time and `at` is None. `wide`: high - low is more than was asked for."""

    low: float
    high: float
    time: Time
    at: Optional[Tuple[Tuple[float, ...], Tuple[float, ...]]]
    wide: bool


@dataclass(frozen=True)
class FirstContact:
    """Times between which all motions within an error have their first contact: before `low` none meets, None if none ever does;
    at `high` all have met, or do at once after, None where that is not proved."""

    low: Optional[Time]
    high: Optional[Time]


@dataclass(frozen=True)
class Collision:
    """How two solids meet. `verdict` is `clear`, `touch` or `overlap`; `word` has a letter for each state
    in order of time: `O` apart, `B` the boundaries alone meet, `I` the interiors meet. `overlap` is the
    time at which the first `I` begins, None if there is none.

    With `first` the word ends with the letter just after the first instant of contact, `next`: `B` where
    the contact lasts, None where the motion ends there. `verdict` is `clear` (with `inside`: `inside`),
    `overlap` where the motion begins in `I`, else `meets`; `next` is None but for `meets`. With `motion_error` all but
    `first_contact` is as with `first` at that much more clearance."""

    verdict: str
    word: str
    contacts: Tuple[PairContact, ...]
    overlap: Optional[Time]
    next: Optional[str] = None
    closest: Optional[Closest] = None
    first_contact: Optional[FirstContact] = None

    def __bool__(self) -> bool:
        """Whether the closed solids meet."""
        return self.word != "O"


def _cells(made: ctypes.Structure) -> Tuple[CellPair, ...]:
    out = []
    for k in range(made.cell_count):
        pair = made.cells[k]
        moving, fixed = cell_of(pair.moving), cell_of(pair.fixed)
        if moving and fixed:
            name = library().graze_cell_pair_name(ctypes.byref(pair)).decode()
            out.append(CellPair(moving, fixed, name))
    return tuple(out)


def _contact(made: ctypes.Structure) -> PairContact:
    start = time_of(made.from_)
    end = start if made.to == made.from_ else time_of(made.to) if made.to else None
    return PairContact(kind_of(made.kind) or None, chr(made.left) if made.left else None,
                       chr(made.right) if made.right else None, start, end, _cells(made),
                       int(library().graze_time_row(made.from_)) or None)


def _closest(made: ctypes.Structure, dimension: int) -> Optional[Closest]:
    if not made.time:
        return None
    at = (tuple(made.at[:dimension]), tuple(made.at[3:3 + dimension])) if made.placed else None
    return Closest(made.low, made.high, time_of(made.time), at, bool(made.wide))


def collide(moving: Any, motion: MotionLike, fixed: Any, motion_of_fixed: Optional[MotionLike] = None,
            *, first: bool = False, inside: bool = False, clearance: Any = 0, closest: Any = None,
            motion_error: Any = None, round: str = "none", limits: Optional[Mapping[str, int]] = None) -> Collision:
    """Decide exactly how a moving solid meets a fixed one.

    Args:
        moving, fixed: a `Solid`, or what one is made of; both may be one object. Curved ones are unions of balls and
            capsules; in cells vertices are counted through these, one of a ball, two of a capsule.
        motion: a `Motion`, or what one is made of.
        motion_of_fixed: if given, `fixed` moves too; times are those that both motions have.
        first: end just after the first contact begins, which is much cheaper.
        inside: put the closure of the complement of `fixed` in its place: `moving` stays inside unless
            the verdict is `overlap`; with `first`, up to the contact and, unless `next` is `I`, after it.
        clearance: a number R >= 0. Above 0, letters tell the distance: `O` above R, `B` at R, `I` below; cells are
            those with points at distance R.
        closest: a width, a number or text such as `1e-10r`, relative to the sum of both sizes: the least distance is
            enclosed too. It goes without `first` and `inside`.
        motion_error: a number ETA >= 0: `first_contact` encloses the first contact of all motions that carry each point of
            `moving` at most ETA from where `motion` does. It goes with `clearance` alone.
        round: `binary64` or `binary32` rounds every number of solids and motions first.
        limits: limits by name, as of `graze --limit`.
    Raises:
        InputError: another curved solid; IllegalError: dimensions differ, or no time is in both motions;
        LimitError; and what `Solid` and `Motion` raise.
    """
    chosen = settings(round, limits, True)
    relative = isinstance(closest, str) and closest.endswith("r")
    width = rounded("closest", closest[:-1] if relative else closest, 0.0)
    made = [part if isinstance(part, kind) else kind(part, round=round, limits=limits)
            for kind, part in ((Solid, moving), (Motion, motion), (Solid, fixed))]
    if motion_of_fixed is not None:
        made.append(motion_of_fixed if isinstance(motion_of_fixed, Motion)
                    else Motion(motion_of_fixed, round=round, limits=limits))
    if any(input_settings(part).rounding != chosen.rounding for part in made):
        raise UseError("solids and motions must be rounded alike")
    parts = [input_handle(part) for part in made]
    context, pointer, call = Context(chosen), ctypes.c_void_p(), library()
    goal = filled([clearance], 1, context, "the clearance")
    error = None if motion_error is None else filled([motion_error], 1, context, "the motion error")
    options = C.graze_pair_options(question=C.GRAZE_PAIR_INSIDE if inside else C.GRAZE_PAIR_MEETS, first=int(first),
                                   clearance=goal.address, closest=width, closest_relative=int(relative),
                                   motion_error=None if error is None else error.address)
    context.run(call.graze_pair_create, ctypes.byref(pointer), context.pointer, *(part.pointer for part in parts[:3]),
                parts[3].pointer if len(parts) > 3 else None, ctypes.byref(options))
    with Handle(pointer, call.graze_pair_destroy, *parts) as pair:
        contacts = tuple(_contact(call.graze_pair_get_contact(pair, k))
                         for k in range(call.graze_pair_contact_count(pair)))
        overlap = call.graze_pair_overlap_time(pair)
        verdict = call.graze_pair_verdict_name(call.graze_pair_get_verdict(pair)).decode()
        if first and inside and verdict == "clear":
            verdict = "inside"
        after, reached = call.graze_pair_next(pair), call.graze_pair_get_first(pair)
        bounds = FirstContact(*(time_of(t) if t else None for t in (reached.low, reached.high)))
        return Collision(verdict, call.graze_pair_word(pair).decode(), contacts, time_of(overlap) if overlap else None,
                         chr(after) if after else None,
                         _closest(call.graze_pair_get_closest(pair), made[1].dimension), None if error is None else bounds)
