"""Curves of contact at a time, patches of the envelope, and how these meet.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
from dataclasses import dataclass
from fractions import Fraction
from typing import Dict, Optional, Tuple

from ._abi import C
from ._library import library
from ._numbers import Rationals
from ._traces import cell_of, time_of
from .results import Cell
from .times import Time


@dataclass(frozen=True)
class CurvePart:
    """A part of the contact points at a time, as a row of `graze envelope --curve`.

    `kind` is `slice`, `run`, `point` or `whole`; `a` and `b` are its ends in the solid's frame, of a
    whole facet a point within it. `theta_a` and `theta_b` are signs, None but for slices.
    `orientation` and `status` are those of its middle. Parts with a common end have one `chain`;
    its `form` is `closed`, `open` or `branching`, None for a point and in the plane.
    """

    kind: str
    cell: Cell
    a: Tuple[Fraction, ...]
    b: Tuple[Fraction, ...]
    theta_a: Optional[int]
    theta_b: Optional[int]
    orientation: Optional[str]
    status: str
    chain: int
    form: Optional[str]


@dataclass(frozen=True)
class Patch:
    """A cell over an interval in which it carries contact and no event concerns it, as a row of
    `graze envelope --patches`.

    `start` and `end` bound the open interval. `a` and `b` are where it ends: a vertex; of a slice
    an edge, of a run a facet whose slice ends there; None for a point and a whole facet. The
    sample is the contact point `body`, `point` in the world, at `time`.
    """

    kind: str
    cell: Cell
    start: Time
    end: Time
    a: Optional[Cell]
    b: Optional[Cell]
    theta_a: Optional[int]
    theta_b: Optional[int]
    orientation: Optional[str]
    time: Fraction
    body: Tuple[Fraction, ...]
    point: Tuple[Fraction, ...]
    status: str


@dataclass(frozen=True)
class PatchJoint:
    """Numbers of patches that meet at a vertex or edge, from `start` to `end`, or where these are
    equal at an event or break. `form` is as in CurvePart, None at events and in the plane."""

    cell: Cell
    start: Time
    end: Time
    form: Optional[str]
    patches: Tuple[int, ...]


def _sign(sign: int) -> Optional[int]:
    return None if sign == C.GRAZE_SIGN_ABSENT else sign


def _known(name: bytes) -> Optional[str]:
    text = name.decode()
    return None if text == "none" else text


def _cell(made: ctypes.Structure) -> Cell:
    cell = cell_of(made)
    assert cell is not None
    return cell


def _point(values: Rationals, dimension: int) -> Tuple[Fraction, ...]:
    return tuple(values[k] for k in range(dimension))


def read_curve(curve: ctypes.c_void_p, dimension: int) -> Tuple[CurvePart, ...]:
    """All parts of a curve; the handle stays the caller's."""
    call, a, b, parts = library(), Rationals(dimension), Rationals(dimension), []
    for index in range(call.graze_curve_count(curve)):
        made = call.graze_curve_at(curve, index)
        call.graze_curve_ends(a.address, b.address, curve, index)
        parts.append(CurvePart(
            call.graze_curve_kind_name(made.kind).decode(), _cell(made.cell), _point(a, dimension),
            _point(b, dimension), _sign(made.theta_a), _sign(made.theta_b),
            _known(call.graze_orientation_name(made.orientation)),
            call.graze_trim_name(made.trim).decode(), made.chain,
            _known(call.graze_chain_form_name(made.form))))
    return tuple(parts)


class _Times:
    """Times by their handles, each read once."""

    def __init__(self) -> None:
        self._known: Dict[int, Time] = {}

    def get(self, handle: int) -> Time:
        if handle not in self._known:
            self._known[handle] = time_of(handle)
        return self._known[handle]


def read_patches(patches: ctypes.c_void_p,
                 dimension: int) -> Tuple[Tuple[Patch, ...], Tuple[PatchJoint, ...]]:
    """All patches and joints; the handle stays the caller's."""
    call, times, found, joints = library(), _Times(), [], []
    when, body, world = Rationals(1), Rationals(dimension), Rationals(dimension)
    for index in range(call.graze_patches_count(patches)):
        made = call.graze_patches_at(patches, index)
        call.graze_patches_sample(when.address, body.address, world.address, patches, index)
        found.append(Patch(
            call.graze_curve_kind_name(made.kind).decode(), _cell(made.cell),
            times.get(made.from_), times.get(made.to), cell_of(made.a), cell_of(made.b),
            _sign(made.theta_a), _sign(made.theta_b),
            _known(call.graze_orientation_name(made.orientation)), when[0],
            _point(body, dimension), _point(world, dimension),
            call.graze_trim_name(made.trim).decode()))
    for index in range(call.graze_patches_joint_count(patches)):
        made = call.graze_patches_joint(patches, index)
        joints.append(PatchJoint(_cell(made.cell), times.get(made.from_), times.get(made.to),
                                 _known(call.graze_chain_form_name(made.form)),
                                 tuple(made.patch[:made.count])))
    return tuple(found), tuple(joints)
