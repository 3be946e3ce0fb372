"""The folder of a scene in which a candidate is wrong.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import os
import shlex
from typing import Any, List, Optional

from ._context import Context, settings
from ._hull import Point
from ._judges import Kind
from ._library import Handle, library, take_text
from ._numbers import Rationals
from ._plain import Model, motion_of, number, written_ending
from .errors import GrazeError
from .inputs import source_of
from .scene import Scene
from .testing import why


def write_folder(folder: str, model: Optional[Model], given: Scene, point: Point, kind: Kind, candidate: str, options: List[str]) -> None:
    """Write solid, motion, point, expected row, reason, certificate and README. Without a model the scene is given, of a curved solid."""
    os.makedirs(folder, exist_ok=True)
    ending = written_ending(source_of(given.solid), model.dimension) if model else ".csg.json"
    solid, d = "solid" + ending, given.dimension
    of = dict(model.options) if model else {"operation": given.operation, "folds": given.folds, "overlap": given.overlap}

    def path(name: str) -> str:
        return os.path.join(folder, name)

    _write(path(solid), model.solid_text(ending) if model else given.solid.json())
    _write(path("motion.json"), model.motion_text() if model else motion_of(given).json())
    scene = Scene(path(solid), path("motion.json"), **of)
    names = "x,y,z"[:2 * d - 1]
    _write(path("point.csv"), f"{names},id\n{','.join(map(number, point))},1\n")
    _write(path("expected.csv"), scene.table([point]))
    _write(path("reason.txt"), scene.explain(point))
    certified = _certificate(scene, point) if model else ""
    if certified:
        _write(path("certificate.txt"), certified)
    trace = scene.trace(point)
    asked = [word for name, usual in (("operation", "sweep"), ("folds", "separate")) for word in (f"--{name}", str(of.get(name, usual)))
             if of.get(name, usual) != usual]
    explain = shlex.join(["graze", "explain", solid, "motion.json", *map(number, point), *asked])
    again = shlex.join(["graze", "validate", solid, "motion.json", "--points", "point.csv", *options, "--candidate", candidate])
    check = f"; `graze-check {solid} motion.json certificate.txt expected.csv` proves it" if certified else ""
    _write(path("README.md"),
           f"({', '.join(map(str, point))}) is `{kind[1]}`, given {_given(kind)}. {why(trace, scene.operation)}\n"
           f"`{explain}` has the whole reasoning{check}.\n"
           + (f"`{again}` shows it.\n" if candidate else "`expected.csv` has the row that a test expects of the point in `point.csv`.\n"))


def _given(kind: Kind) -> str:
    """The wrong answer in words."""
    if kind[0] == "pmc":
        return kind[2]
    return f"another {kind[0]}" if kind[0] != "sdf" else "the distance 0" if kind[2] == "0" else f"a wrong, {kind[2]} distance"


def _write(path: str, text: str) -> None:
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def _certificate(scene: Scene, point: Point) -> str:
    """The certificate of one row; "" where there is none, as of formats that graze-check does not read."""
    call, context, made = library(), Context(settings("none", None, True)), ctypes.c_void_p()
    place = Rationals(len(point))
    for k, value in enumerate(point):
        place.set(k, value, context)
    try:
        context.run(call.graze_certifier_create, ctypes.byref(made), context.pointer, scene._handle.pointer, 0)
        texts = []
        with Handle(made, call.graze_certifier_destroy) as certifier:
            for function, more in ((call.graze_certificate_head, ()), (call.graze_certificate_row, (place.address,))):
                out: Any = ctypes.c_void_p()
                context.run(function, ctypes.byref(out), context.pointer, certifier, *more)
                texts.append(take_text(out))
    except GrazeError:
        return ""
    return "".join(texts) + "complete 1\n"
