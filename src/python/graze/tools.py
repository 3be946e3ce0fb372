"""Meshes of tools and of simple solids, as `graze solid` makes them (graze/convert.h).

Each function gives the pair (vertices, facets) that `graze.Solid` takes: exact numbers, and for each
facet its vertices from 0. All are convex. Round ones are within `tolerance` of the shape and a part
of it, or with `outside` hold it; both is proved for the very numbers that are given.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
from fractions import Fraction
from typing import Any, List, Optional, Sequence, Tuple

from ._abi import C
from ._context import Context, settings
from ._library import library, take_text
from ._numbers import Rationals
from .errors import UseError

Mesh = Tuple[List[Tuple[Fraction, ...]], List[List[int]]]


def box(x: Any, y: Any, z: Any, *, at: Optional[Sequence[Any]] = None) -> Mesh:
    """A box with these sides, from the origin along the axes; `at` moves it. Exact."""
    return _made(C.GRAZE_SHAPE_BOX, False, at, None, box=(x, y, z))


def ball(diameter: Any, *, tolerance: Any, outside: bool = False,
         at: Optional[Sequence[Any]] = None) -> Mesh:
    """A ball that touches the plane z = 0 from above in the origin."""
    return _made(C.GRAZE_SHAPE_BALL, outside, at, tolerance, diameter=diameter)


def cylinder(diameter: Any, length: Any, *, tolerance: Any, outside: bool = False,
             at: Optional[Sequence[Any]] = None) -> Mesh:
    """A cylinder about the z axis, its bottom in the plane z = 0."""
    return _made(C.GRAZE_SHAPE_CYLINDER, outside, at, tolerance, diameter=diameter, length=length)


def cutter(diameter: Any, length: Any, *, tolerance: Any, corner: Any = 0, taper: Any = 0,
           outside: bool = False, at: Optional[Sequence[Any]] = None) -> Mesh:
    """A milling tool, its tip in the origin, its axis z.

    Args:
        diameter: where its corner is widest; without a corner at its tip.
        corner: radius of its corner: half the diameter is a ball end.
        taper: degrees between its side and the axis, positive where it is wider above.
    Raises:
        UseError: there is no such tool, or the tolerance is too fine.
    """
    return _made(C.GRAZE_SHAPE_CUTTER, outside, at, tolerance, diameter=diameter, length=length, corner=corner,
                 taper=taper)


def _made(kind: int, outside: bool, at: Optional[Sequence[Any]], tolerance: Any,
          **numbers: Any) -> Mesh:
    context, shape = Context(settings("none", None, True)), C.graze_shape(kind=kind)
    keep: List[Rationals] = []

    def exact(values: Sequence[Any]) -> int:
        keep.append(Rationals(len(values)))
        for k, value in enumerate(values):
            keep[-1].set(k, value, context)
        return keep[-1].address

    for name, value in numbers.items():
        setattr(shape, name, exact(value if name == "box" else [value]))
    if at is not None:
        if len(at) != 3:
            raise UseError(f"at has {len(at)} numbers; expected 3")
        shape.at = exact(at)
    goal = None if tolerance is None else exact([tolerance])
    text = ctypes.c_void_p()
    chosen = (None, ctypes.byref(text)) if outside else (ctypes.byref(text), None)
    context.run(library().graze_solid_write_shape, *chosen, None, context.pointer,
                ctypes.byref(shape), goal)
    return _read_off(take_text(text))


def _read_off(text: str) -> Mesh:
    """Vertices and facets of an OFF file that the library has written."""
    lines = [line.split() for line in text.splitlines() if line and not line.startswith("#")][1:]
    count = int(lines[0][0])
    vertices = [tuple(Fraction(number) for number in line) for line in lines[1:count + 1]]
    return vertices, [[int(k) for k in line[1:]] for line in lines[count + 1:]]
