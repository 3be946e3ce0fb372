"""Pictures of scenes, as SVG (graze/draw.h).

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import os
import tempfile
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

from ._context import Context
from ._library import CDrawOptions, Handle, library
from ._numbers import Points, Rationals
from .errors import UseError
from .results import Class


class Picture(NamedTuple):
    """A picture; a notebook shows it.

    Attributes:
        svg: its text.
    """

    svg: str

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, path: Any) -> None:
        """Write it into a file, whose name ends with .svg."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.svg)

    def __repr__(self) -> str:
        return f"<graze.Picture, {len(self.svg)} characters of SVG>"


def class_colours() -> Dict[str, str]:
    """The colour of each class in every picture of Graze, as `#rrggbb`."""
    return {class_.name.lower(): f"#{library().graze_class_colour(class_):06x}"
            for class_ in Class if class_ != Class.NONE}


def draw(context: Context, scene: Handle, points: Optional[Points], names: Optional[Sequence[str]],
         box: Optional[Tuple[Rationals, Rationals]], **options: Any) -> Picture:
    """A picture of a scene; `options` are title, grid, times and by."""
    keep: List[Any] = []
    chosen = CDrawOptions(size=ctypes.sizeof(CDrawOptions), grid=options["grid"],
                          times=options["times"], title=options["title"].encode(),
                          by=options["by"])
    if box:
        chosen.low, chosen.high = box[0].address, box[1].address
    if points:
        exact, first = points.exact(0, points.count)
        labels = list(names) if names is not None else [str(k) for k in range(points.count)]
        if len(labels) != points.count:
            raise UseError(f"{len(labels)} names for {points.count} points; expected as many")
        texts = (ctypes.c_char_p * points.count)(*(label.encode() for label in labels))
        keep += [exact, texts]
        chosen.points, chosen.point_count = exact.at(first), points.count
        chosen.names = ctypes.addressof(texts)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "picture.svg")
        context.run(library().graze_draw, context.pointer, scene.pointer, os.fsencode(path),
                    ctypes.byref(chosen))
        with open(path, encoding="utf-8") as file:
            return Picture(file.read())
