"""Motion files made by the library: turns, screws and joints (graze/convert.h).

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
from typing import Any, Callable, Iterable, List, Mapping, NamedTuple, Sequence, Tuple

from ._abi import C
from ._context import Context, settings
from ._library import library, take_text
from ._numbers import Rationals
from .errors import UseError


class Joint(NamedTuple):
    """One joint of a chain, as it stands at t = 0; it moves uniformly for t from 0 to 1.

    Attributes:
        degrees: the angle of a turn, counter-clockwise; None for a slide.
        axis: the direction of a turn in space (in the plane None), the way of a slide.
        center: a point on the axis; None is the origin.
        pitch: the way along the axis for 360 degrees.
    """

    degrees: Any
    axis: Any = None
    center: Any = None
    pitch: Any = 0


def turn(degrees: Any, axis: Any = None, center: Any = None, pitch: Any = 0) -> Joint:
    """A joint that turns; with a pitch a screw."""
    return Joint(degrees, axis, center, pitch)


def slide(*way: Any) -> Joint:
    """A joint that slides by d numbers."""
    return Joint(None, way)


def written(make: Callable[..., int], *arguments: Any, context: Context) -> Tuple[str, str]:
    """Motion file and report of a function that writes both."""
    json, report = ctypes.c_void_p(), ctypes.c_void_p()
    context.run(make, ctypes.byref(json), ctypes.byref(report), context.pointer, *arguments)
    return take_text(json), take_text(report)


def filled(values: Sequence[Any], count: int, context: Context, what: str) -> Rationals:
    if len(values) != count:
        raise UseError(f"{what} has {len(values)} numbers; expected {count}")
    out = Rationals(count)
    for k, value in enumerate(values):
        out.set(k, value, context)
    return out


def by_gcode(path: bytes, tolerance: Any, start: "Sequence[Any] | None",
             limits: "Mapping[str, int] | None") -> Tuple[str, str]:
    """The motion of a G-code program."""
    context = Context(settings("none", limits, True))
    goal = filled([tolerance], 1, context, "the tolerance")
    options = C.graze_gcode_options(tolerance=goal.address)
    if start is not None:
        at = filled(start, 3, context, "start")
        options.start = at.address
    return written(library().graze_motion_write_gcode, path, ctypes.byref(options), context=context)


def _dimension(joints: Sequence[Joint]) -> int:
    for joint in joints:
        if joint.axis is not None:
            return len(joint.axis)
        if joint.center is not None:
            return len(joint.center)
    return 2


def by_joints(joints: Iterable[Joint], uniform: bool, tolerance: Any, radius: Any,
              limits: "Mapping[str, int] | None") -> Tuple[str, str]:
    """A chain of joints, or with `uniform` false one turn whose speed is not."""
    given = list(joints)
    context = Context(settings("none", limits, True))
    d = _dimension(given)
    array, keep = (C.graze_joint * max(len(given), 1))(), []  # type: Tuple[Any, List[Rationals]]
    for out, joint in zip(array, given):
        def address(values: Any, count: int, what: str) -> int:
            keep.append(filled(values, count, context, what))
            return keep[-1].address
        out.kind = C.GRAZE_JOINT_SLIDE if joint.degrees is None else C.GRAZE_JOINT_TURN
        if joint.degrees is not None:
            out.degrees = address([joint.degrees], 1, "an angle")
            out.pitch = address([joint.pitch], 1, "a pitch") if d == 3 else None
            if d == 2 and joint.pitch != 0:
                raise UseError("a turn in the plane has no pitch; expected an axis of 3 numbers")
        if joint.axis is not None:
            out.axis = address(joint.axis, d, "an axis")
        if joint.center is not None:
            out.center = address(joint.center, d, "a center")
    goal = filled([tolerance, radius], 2, context, "the goal")
    if uniform:
        return written(library().graze_motion_write_joints, d, array, len(given), goal.at(0),
                       goal.at(1), context=context)
    return written(library().graze_motion_write_rotation, d, array, goal.at(0), goal.at(1),
                   context=context)
