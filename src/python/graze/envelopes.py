"""Events of an envelope: when the contact of the moving solid with it changes.

One thread uses an envelope at a time.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Dict, Optional, Tuple

from ._abi import C
from ._library import Handle, library
from ._numbers import Rationals
from ._traces import cell_of, time_of
from .patches import CurvePart, Patch, PatchJoint, read_curve, read_patches
from .results import Cell
from .times import Time

if TYPE_CHECKING:
    from .scene import Number, Scene


@dataclass(frozen=True)
class Event:
    """A time at which the contact points change, as a row of `graze envelope --events`.

    `kind` is `saddle`, `reach`, `meet`, `cusp`, `turn` or `singular`. `other` is the second facet of a
    `meet`. `before` and `after` are signs, None beyond an end of the motion and for `singular`.
    """

    kind: str
    time: Time
    facet: Optional[Cell]
    other: Optional[Cell]
    cell: Optional[Cell]
    before: Optional[int]
    after: Optional[int]


@dataclass(frozen=True)
class Envelope:
    """All events in order of time, and whether the envelope is decomposable.

    `decomposable` is `yes`, `no` or `undecided`, `reason` says why in words; `facet`, `cell` and
    `time` are where and when, None where it is about no cell or time. `facets`, `edges` and
    `vertices` are numbers of cells by position.
    """

    decomposable: str
    reason: str
    facet: Optional[Cell]
    cell: Optional[Cell]
    time: Optional[Time]
    facets: int
    edges: int
    vertices: int
    events: Tuple[Event, ...]
    _scene: Scene = field(repr=False, compare=False)
    _handle: Handle = field(repr=False, compare=False)

    def curve(self, time: Number) -> Tuple[CurvePart, ...]:
        """The contact points at a time within the motion that is no break: slices and whole
        facets, runs, points.

        Raises:
            InputError: another time; UseError, LimitError, InternalError.
        """
        context, pointer, when = self._scene._context(), ctypes.c_void_p(), Rationals(1)
        when.set(0, time, context)
        context.run(library().graze_curve_create, ctypes.byref(pointer), context.pointer,
                    self._handle.pointer, when.address)
        with Handle(pointer, library().graze_curve_destroy) as curve:
            return read_curve(curve, self._scene.dimension)

    def patches(self) -> Tuple[Tuple[Patch, ...], Tuple[PatchJoint, ...]]:
        """The cells over the intervals in which they carry contact, and which of them meet; joints
        have the places of patches in the first of both. Raises LimitError, InternalError."""
        context, pointer = self._scene._context(), ctypes.c_void_p()
        context.run(library().graze_patches_create, ctypes.byref(pointer), context.pointer,
                    self._handle.pointer)
        with Handle(pointer, library().graze_patches_destroy) as patches:
            return read_patches(patches, self._scene.dimension)


def read_envelope(handle: Handle, scene: Scene) -> Envelope:
    """Everything that an envelope holds, which keeps its handle."""
    call, envelope = library(), handle.pointer
    facts = call.graze_envelope_get(envelope)
    times: Dict[int, Time] = {}
    events = []
    for index in range(call.graze_envelope_event_count(envelope)):
        made = call.graze_envelope_event(envelope, index)
        if made.time not in times:
            times[made.time] = time_of(made.time)
        before, after = (None if sign == C.GRAZE_SIGN_ABSENT else sign for sign in (made.before, made.after))
        events.append(Event(call.graze_event_kind_name(made.kind).decode(), times[made.time],
                            cell_of(made.facet), cell_of(made.other), cell_of(made.cell), before,
                            after))
    return Envelope(call.graze_decomposable_name(facts.decomposable).decode(),
                    call.graze_decomposable_reason_name(facts.reason).decode(),
                    cell_of(facts.facet), cell_of(facts.cell),
                    time_of(facts.time) if facts.time else None, facts.facets, facts.edges,
                    facts.vertices, tuple(events), scene, handle)
