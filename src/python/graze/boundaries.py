"""Boundaries of sweeps by adaptive sampling (graze/boundary.h).

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Optional, Tuple

from ._abi import C
from ._context import Context
from ._library import Handle, library
from ._numbers import Rationals, numpy
from ._parallel import threads

DEPTH, BUDGET, CONTACTS = 6, 1_000_000, 1000


class Boundary(NamedTuple):
    """A surface (in the plane: a curve) between the points that are `out` and the others.

    Attributes:
        vertices: n rows of d floats, an array of numpy where it is installed; the nearest floats.
        faces: rows of d vertices, with `out` on the side of the normal (in the plane on the right).
        points: how many points were classified for the cells.
        complete: False if the budget ended before the depth was reached.
        closed: False if the surface ends at the border of the box.
    """

    vertices: Any
    faces: Any
    points: int
    complete: bool
    closed: bool

    def __repr__(self) -> str:
        return (f"<graze.Boundary: {len(self.vertices)} vertices, {len(self.faces)} faces"
                f"{'' if self.complete else ', not complete'}{'' if self.closed else ', open'}>")


def boundary(context: Context, scene: Handle, dimension: int, depth: int, coarse: Optional[int],
             budget: int, contacts: int, seed: int, sharp: bool, jobs: Optional[int],
             box: Optional[Tuple[Rationals, Rationals]]) -> Boundary:
    """Sample the scene. Raises UseError, CanceledError, LimitError."""
    if coarse is None:
        coarse = min(depth, 5 if dimension == 2 else 4)
    chosen = C.graze_boundary_options(coarse=coarse, depth=depth, budget=budget, contacts=contacts,
                                      seed=seed, sharp=sharp, threads=threads(jobs))
    if box:
        chosen.low, chosen.high = box[0].address, box[1].address
    pointer = ctypes.c_void_p()
    context.run(library().graze_boundary_create, ctypes.byref(pointer), context.pointer,
                scene.pointer, ctypes.byref(chosen))
    with Handle(pointer, library().graze_boundary_destroy, scene) as made:
        summary = library().graze_boundary_summarize(made)
        place = Rationals(dimension)
        vertices, faces = [], []
        for k in range(summary.vertices):
            library().graze_boundary_vertex(place.address, made, k)
            vertices.append([float(place[i]) for i in range(dimension)])
        for k in range(summary.faces):
            faces.append(list(library().graze_boundary_face(made, k)[:dimension]))
    counts = summary.points, bool(summary.complete), bool(summary.closed)
    if numpy is None:
        return Boundary(vertices, faces, *counts)
    shape = (-1, dimension)
    return Boundary(numpy.array(vertices, float).reshape(shape),
                    numpy.array(faces, int).reshape(shape), *counts)
