"""Traces of the library as objects of Python.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
from fractions import Fraction
from typing import Any, Optional, Tuple

from ._abi import C, words
from ._library import library
from ._numbers import Rationals
from .results import Cell, Class, Contact, Pmc, Topology, Trace, Verdict
from .times import AlgebraicNumber, Time

_CELLS = words("graze_cell_kind")
_CELL_NAMES = {number: word for word, number in _CELLS.items()}
_KIND_NAMES = {number: word for word, number in words("graze_kind").items()}


def verdict_of(made: ctypes.Structure) -> Verdict:
    """A verdict as a tuple."""
    return Verdict(Pmc(made.pmc), Class(made.class_), made.definition, made.case_, made.i, made.t)


def kind_of(kind: int) -> str:
    """The word of a kind of contact; "" for 0."""
    return _KIND_NAMES.get(kind, "")


def cell_of(made: ctypes.Structure) -> Optional[Cell]:
    """A cell; None if its kind is 0."""
    if not made.kind:
        return None
    kind = _CELL_NAMES[made.kind]
    return Cell(kind, (made.a, made.b) if kind == "edge" else (made.a,))


def cell_given(cell: Cell) -> Any:
    """A cell for a call; kind 0 if its kind is none."""
    return C.graze_cell(_CELLS.get(cell.kind, 0), *(tuple(cell.indices) + (0, 0))[:2])


def read_trace(trace: ctypes.c_void_p, point: Tuple[Fraction, ...]) -> Trace:
    """Everything that a trace holds; the handle stays the caller's."""
    contacts = []
    for index in range(library().graze_trace_contact_count(trace)):
        made = library().graze_trace_contact(trace, index)
        start = time_of(made.from_)
        end = start if made.to == made.from_ else time_of(made.to)
        cells = tuple(cell for cell in map(cell_of, made.cells[:made.cell_count]) if cell)
        contacts.append(Contact(kind_of(made.kind), chr(made.left) if made.left else None,
                                chr(made.right) if made.right else None, start, end, cells))
    return Trace(point, library().graze_trace_word(trace).decode(),
                 verdict_of(library().graze_trace_verdict(trace)), tuple(contacts))


def _integers(values: Rationals, start: int, count: int) -> Tuple[int, ...]:
    return tuple(values[k].numerator for k in range(start, start + count))


def read_topology(topology: ctypes.c_void_p, dimension: int) -> Topology:
    """A position relative to the closed sweep, or the regularised unsweep; the handle stays the caller's."""
    call, witness, far, along = library(), Rationals(dimension), Rationals(1), Rationals(2 * dimension)
    found = call.graze_topology_witness(witness.address, topology)
    made = Topology(call.graze_topo_name(call.graze_topology_position(topology)).decode(),
                    call.graze_topo_level_name(call.graze_topology_level(topology)).decode(),
                    call.graze_topology_reason(topology).decode(),
                    tuple(witness[k] for k in range(dimension)) if found else None)
    if call.graze_topology_ray(along.address, far.address, topology):
        return made._replace(direction=_integers(along, 0, dimension), epsilon=far[0])
    normal, z, order = Rationals(dimension), Rationals(1), ctypes.c_size_t()
    if call.graze_topology_path(along.address, normal.address, z.address, ctypes.byref(order), far.address, topology):
        return made._replace(direction=_integers(along, 0, dimension), normal=_integers(normal, 0, dimension), z=z[0],
                             order=order.value, epsilon=far[0])
    if call.graze_topology_square(along.address, far.address, topology):
        return made._replace(plane=(_integers(along, 0, dimension), _integers(along, dimension, dimension)), rho=far[0])
    return made


def time_of(time: int) -> Time:
    """The time of a handle."""
    ends = Rationals(2)
    if library().graze_time_rational(ends.at(0), time):
        return ends[0]
    library().graze_time_interval(ends.at(0), ends.at(1), time)
    # A coefficient becomes the numerator of a rational whose denominator is 1.
    scratch, coefficients = Rationals(1), []
    for k in range(library().graze_time_degree(time) + 1):
        library().graze_time_coefficient(scratch.address, time, k)
        coefficients.append(scratch[0].numerator)
    return AlgebraicNumber(coefficients, ends[0], ends[1])
