"""How far a mesh is from the boundary of a sweep (graze/judge.h).

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import array
import ctypes
import json
import operator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Dict, Optional, Tuple

from ._abi import C
from ._context import Context
from ._frames import refuse_masked
from ._library import Handle, library, take_text
from ._numbers import numpy, whole
from ._parallel import threads
from .errors import UseError


@dataclass(frozen=True)
class Greatest:
    """The greatest of some distances is in [low, high]: bounds that are proved. `at` is a point of the
    mesh at which it is at least `low`, of `sweep` one near the sweep's boundary, from which the nearest place of
    that is at least `low` away from the mesh; `t` is a time at which the solid is nearest to it, or it deepest in the solid;
    both None where `low` is 0; `open` is a point near which it is perhaps `high`, None if the
    width was reached. `stuck`: the search cannot refine there, perhaps as a seam of the sweep is there."""

    low: float
    high: float
    at: Optional[Tuple[float, ...]]
    t: Optional[float]
    reached: bool
    open: Optional[Tuple[float, ...]]
    stuck: bool


@dataclass(frozen=True)
class Judgement:
    """A mesh against the boundary of a sweep.

    Attributes:
        outside: how far the mesh is from the sweep, where it is outside.
        inside: how far it is from the outside, where it is inside the sweep.
        sweep: how far the boundary of the sweep is from the mesh; None for an empty mesh.
        volume: bounds of the sweep's volume.
        missing, excess: bounds of the volumes in the sweep and not in the mesh, and in the mesh and not in the sweep; None
            unless the mesh is closed.
        mesh_volume: that of the mesh, exact; None unless it is closed and oriented.
        closed, oriented: whether every edge has an even number of triangles, and as many either way.
        windings: the least and the greatest winding number found, 0 and 1 of a mesh that bounds a solid; None unless
            it is closed and oriented.
        reached: whether all distances have the width that was asked for.
        report: all of it, as of `graze judge --format json`.
        text: the report for a person.
    """

    outside: Greatest
    inside: Greatest
    sweep: Optional[Greatest]
    volume: Tuple[float, float]
    missing: Optional[Tuple[float, float]]
    excess: Optional[Tuple[float, float]]
    mesh_volume: Optional[Fraction]
    closed: bool
    oriented: bool
    windings: Optional[Tuple[int, int]]
    reached: bool
    report: Dict[str, Any]
    text: str

    def __str__(self) -> str:
        return self.text


def _greatest(found: Optional[Dict[str, Any]]) -> Optional[Greatest]:
    if found is None:
        return None
    at, near = found["at"], found.get("open")
    return Greatest(found["low"], found["high"], tuple(at) if at else None, found["t"], found["reached"],
                    tuple(near) if near else None, found.get("stuck", False))


def _bounds(found: Optional[Dict[str, float]]) -> Optional[Tuple[float, float]]:
    return (found["low"], found["high"]) if found else None


def _array(name: str, rows: Any, kind: str) -> Any:
    """Rows of three numbers as an array of the standard library; arrays of numpy are copied fast."""
    if numpy is not None and isinstance(rows, numpy.ndarray):
        refuse_masked(rows, name, 3)
        if rows.dtype.kind not in ("fiu" if kind == "d" else "iu"):
            raise UseError(f"{name}: an array of {rows.dtype}; "
                           f"expected one of {'real numbers' if kind == 'd' else 'integers'}")
        made = numpy.ascontiguousarray(rows, dtype=numpy.float64 if kind == "d" else numpy.uint64)
        if made.ndim != 2 or made.shape[1] != 3 or (kind == "Q" and (rows < 0).any()):
            raise UseError(f"{name}: expected rows of 3 numbers{'' if kind == 'd' else ' from 0 up'}")
        return array.array(kind, made.tobytes())
    out: Any = array.array(kind)
    for k, row in enumerate(rows):
        try:
            numbers = [float(x) if kind == "d" else operator.index(x) for x in row]
            if len(numbers) != 3:
                raise ValueError
            out.extend(numbers)
        except (TypeError, ValueError, OverflowError) as wrong:
            raise UseError(f"{name} {k} is {row!r}; expected 3 numbers") from wrong
    return out


def _mesh(context: Context, vertices: Any, faces: Any) -> Handle:
    places, corners, pointer = _array("vertex", vertices, "d"), _array("face", faces, "Q"), ctypes.c_void_p()
    context.run(library().graze_mesh_create, ctypes.byref(pointer), context.pointer, places.buffer_info()[0],
                len(places) // 3, corners.buffer_info()[0], len(corners) // 3)
    return Handle(pointer, library().graze_mesh_destroy)


def _read(context: Context, path: Any) -> Handle:
    pointer = ctypes.c_void_p()
    context.run(library().graze_mesh_read, ctypes.byref(pointer), context.pointer, path, 0)
    return Handle(pointer, library().graze_mesh_destroy)


def _compared(context: Context, scene: Handle, mesh: Handle, points: int, seed: int,
              jobs: Optional[int]) -> Optional[Handle]:
    """The mesh's answers for generated points; None for no points, or where the mesh is not closed."""
    if not points or not library().graze_mesh_get_facts(mesh.pointer).rule:
        return None
    asked = C.graze_mesh_points(count=points, seed=seed, on_as=C.GRAZE_ON_AS_ANY, threads=threads(jobs))
    pointer = ctypes.c_void_p()
    context.run(library().graze_compare_mesh, ctypes.byref(pointer), context.pointer, scene.pointer, mesh.pointer,
                ctypes.byref(asked))
    return Handle(pointer, library().graze_comparison_destroy)


def _report(context: Context, judged: ctypes.c_void_p, compared: Optional[Handle], form: int) -> str:
    out = ctypes.c_void_p()
    context.run(library().graze_judgement_report, ctypes.byref(out), context.pointer, judged,
                compared.pointer if compared else None, form)
    return take_text(out)


def judge(context: Context, scene: Handle, vertices: Any, faces: Any, within: float, budget: Optional[int],
          points: int, seed: int, jobs: Optional[int]) -> Judgement:
    """Judge a mesh: arrays, or a file's name where `faces` is None."""
    budget = 0 if budget is None else whole("budget", budget, 1, 2 ** 64 - 1)
    points, seed = whole("points", points, 0, 10 ** 9), whole("seed", seed, 0, 2 ** 64 - 1)
    mesh = _mesh(context, vertices, faces) if faces is not None else _read(context, vertices)
    options = C.graze_judge_options(within=within, budget=budget, threads=threads(jobs))
    pointer = ctypes.c_void_p()
    with mesh:
        context.run(library().graze_judge, ctypes.byref(pointer), context.pointer, scene.pointer, mesh.pointer,
                    ctypes.byref(options))
        with Handle(pointer, library().graze_judgement_destroy, scene, mesh) as judged:
            compared = _compared(context, scene, mesh, points, seed, jobs)
            report = json.loads(_report(context, judged, compared, C.GRAZE_JUDGEMENT_JSON))
            text = _report(context, judged, compared, C.GRAZE_JUDGEMENT_TEXT)
    found, volume = report["distance"], report["volume"]
    outside, inside = _greatest(found["mesh_to_sweep_outside"]), _greatest(found["mesh_to_sweep_inside"])
    assert outside is not None and inside is not None
    windings = report["mesh"]["windings"]
    return Judgement(outside, inside, _greatest(found["sweep_to_mesh"]),
                     (volume["sweep"]["low"], volume["sweep"]["high"]), _bounds(volume["missing"]), _bounds(volume["excess"]),
                     None if volume["mesh"] is None else Fraction(volume["mesh"]),
                     report["mesh"]["closed"], report["mesh"]["oriented"],
                     (windings[0], windings[1]) if windings else None, report["budget"]["reached"], report, text)
