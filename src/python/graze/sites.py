"""Contact points of the envelope: what a boundary point at a given time is for the sweep.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
from dataclasses import dataclass
from fractions import Fraction
from typing import Optional, Tuple

from ._library import library
from ._numbers import Rationals
from ._traces import cell_of, read_trace, time_of
from .results import Cell, Trace
from .times import Time


@dataclass(frozen=True)
class SiteFacet:
    """A facet through a site on one side of its time, -1 before it and 1 after it.

    With n the outward normal of coprime integers, `speed` is n A^-1 (A'y + b'), `drift` its
    derivative by time at fixed y, `theta` the second derivative of n c(t). `order` and `sign` are
    those of n c(t) - d next to the time; order -1 and sign 0 where that vanishes.
    """

    facet: Cell
    side: int
    order: int
    sign: int
    speed: Fraction
    drift: Fraction
    theta: Fraction


@dataclass(frozen=True)
class Site:
    """A boundary point of the solid at a time, as a row of `graze contact`.

    `body` is the point in the solid's frame, `point` where it is at that time. `role` is `contact`,
    `egress`, `ingress` or `hidden`, `status` one of `slides`, `simple`, `meets`, `trimmed_near`,
    `trimmed_far`. `theta` (a sign), `order` (-1 where the contact does not end) and `orientation`
    are None but in the interior of one facet with g = 0 away from breaks. `left` and `right` are
    the states next to the time, None beyond an end. `near` and `near_in` are None where there is
    none.
    """

    time: Fraction
    body: Tuple[Fraction, ...]
    point: Tuple[Fraction, ...]
    cell: Cell
    role: str
    status: str
    trimmed: bool
    theta: Optional[int]
    order: Optional[int]
    orientation: Optional[str]
    left: Optional[str]
    right: Optional[str]
    near: Optional[Time]
    near_in: Optional[Time]
    facets: Tuple[SiteFacet, ...]
    trace: Trace


def _facet(site: ctypes.c_void_p, index: int) -> SiteFacet:
    values = Rationals(3)
    made = library().graze_site_germ_at(values.at(0), values.at(1), values.at(2), site, index)
    cell = cell_of(made.facet)
    assert cell is not None
    return SiteFacet(cell, made.side, made.order, made.sign, values[0], values[1], values[2])


def read_site(site: ctypes.c_void_p, time: Fraction, dimension: int) -> Site:
    """Everything that a site holds; the handle stays the caller's."""
    call, body, point = library(), Rationals(dimension), Rationals(dimension)
    facts = call.graze_site_get(site)
    call.graze_site_point(body.address, point.address, site)
    world = tuple(point[k] for k in range(dimension))
    near, near_in = call.graze_site_near(site), call.graze_site_near_in(site)
    status = call.graze_trim_name(facts.trim).decode()
    cell = cell_of(facts.cell)
    assert cell is not None
    return Site(
        time, tuple(body[k] for k in range(dimension)), world, cell,
        call.graze_role_name(facts.role).decode(), status, status.startswith("trimmed"),
        facts.theta if facts.on_slice else None, facts.order if facts.on_slice else None,
        call.graze_orientation_name(facts.orientation).decode() if facts.on_slice else None,
        chr(facts.left) if facts.left else None, chr(facts.right) if facts.right else None,
        time_of(near) if near else None, time_of(near_in) if near_in else None,
        tuple(_facet(site, k) for k in range(call.graze_site_germ_count(site))),
        read_trace(call.graze_site_trace(site), world))
