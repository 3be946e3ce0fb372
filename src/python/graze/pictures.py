"""Pictures of scenes as SVG, and pages of HTML (graze/draw.h).

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import html
import os
import tempfile
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple

from ._abi import C
from ._context import Context
from ._library import Handle, library
from ._numbers import Points, Rationals
from .errors import UseError
from .results import Class


def _check_ending(path: Any, ending: str, form: str, other: str = "") -> None:
    if not os.fsdecode(path).lower().endswith(ending):
        raise UseError(f"{os.fsdecode(path)}: what is saved is {form}; expected a name that ends "
                       f"with {ending}{other}")


class Picture(NamedTuple):
    """A picture; a notebook shows it.

    Attributes:
        svg: its text.
        png: draws it again, as the bytes of a PNG image.
        pdf: the same, of a page of PDF.
    """

    svg: str
    png: Callable[[], bytes]
    pdf: Callable[[], bytes]

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, path: Any) -> None:
        """Write it into a file, whose name ends with .svg, .png or .pdf.

        Raises:
            UseError: another ending.
            MachineError: a PNG or a PDF without libgraze-png, which needs cairo.
        """
        drawn = {".png": self.png, ".pdf": self.pdf}.get(os.fsdecode(path)[-4:].lower())
        if not drawn:
            _check_ending(path, ".svg", "SVG, PNG or PDF", ", .png or .pdf")
        data = drawn() if drawn else self.svg.encode()
        with open(path, "wb") as file:
            file.write(data)

    def __repr__(self) -> str:
        return f"<graze.Picture, {len(self.svg)} characters of SVG>"


class Page(NamedTuple):
    """A page to turn and to ask, with all it needs; a notebook shows it in a frame.

    Attributes:
        html: its text.
    """

    html: str

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.html)}" width="100%" height="640" '
                'style="border: 0"></iframe>')

    def save(self, path: Any) -> None:
        """Write it into a file, whose name ends with .html; any browser opens it.

        Raises:
            UseError: another ending.
        """
        _check_ending(path, ".html", "HTML")
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.html)

    def __repr__(self) -> str:
        return f"<graze.Page, {len(self.html)} characters of HTML>"


def class_colours() -> Dict[str, str]:
    """The colour of each class in every picture of Graze, as `#rrggbb`."""
    return {class_.name.lower(): f"#{library().graze_class_colour(class_):06x}"
            for class_ in Class if class_ != Class.NONE}


def picture(drawn: Callable[[str], bytes]) -> Picture:
    """The picture that a function draws into a file of a name."""
    return Picture(drawn("picture.svg").decode(), lambda: drawn("picture.png"),
                   lambda: drawn("picture.pdf"))


def draw(name: str, context: Context, scene: Handle, points: Optional[Points],
         names: Optional[Sequence[str]], box: Optional[Tuple[Rationals, Rationals]],
         plane: Optional[Rationals], **options: Any) -> bytes:
    """A scene as a file; `plane` is a normal and a number, `options` are title, grid, times, by."""
    chosen = C.graze_draw_options(grid=options["grid"], times=options["times"],
                                  title=options["title"].encode(), by=options["by"])
    if plane:
        chosen.normal, chosen.plane = plane.address, plane.at(3)
    return _drawn(name, context, scene, chosen, points, names, None, box)


def cones(name: str, context: Context, scene: Handle, point: Rationals, trace: Any) -> bytes:
    """The directions that the contacts of a point cover, as a file."""
    return _written(name, context, library().graze_draw_cones, scene, (point.address, trace))


def _written(name: str, context: Context, write: Any, scene: Handle, more: Tuple[Any, ...]) -> bytes:
    """The bytes of the file that a function of the library writes."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, name)
        context.run(write, context.pointer, scene.pointer, os.fsencode(path), *more)
        with open(path, "rb") as file:
            return file.read()


def page(context: Context, scene: Handle, points: Optional[Points], names: Optional[Sequence[str]],
         strata: Optional[Sequence[str]], box: Optional[Tuple[Rationals, Rationals]],
         proof: Optional[Sequence[Any]], **options: Any) -> Page:
    """A page of a scene; `proof`: solid, motion, certificate, and the checker's page or None;
    `options` are title, times and surface, -1 for none."""
    chosen = C.graze_draw_options(times=options["times"], surface=options["surface"],
                                  title=options["title"].encode())
    files = (ctypes.c_char_p * 4)(*(path and os.fsencode(path) for path in proof or ()))
    if proof:
        chosen.proof = ctypes.addressof(files)
    return Page(_drawn("scene.html", context, scene, chosen, points, names, strata, box).decode())


def _texts(what: str, given: Sequence[str], count: int) -> Any:
    """One text a point, as an array of C."""
    if len(given) != count:
        raise UseError(f"{len(given)} {what} for {count} points; expected as many")
    return (ctypes.c_char_p * count)(*(str(text).encode() for text in given))


def _drawn(name: str, context: Context, scene: Handle, chosen: ctypes.Structure,
           points: Optional[Points], names: Optional[Sequence[str]],
           strata: Optional[Sequence[str]], box: Optional[Tuple[Rationals, Rationals]]) -> bytes:
    """The file that graze_draw writes with these options."""
    keep: List[Any] = []
    if box:
        chosen.low, chosen.high = box[0].address, box[1].address
    if points:
        exact, first = points.exact(0, points.count)
        labels = list(names) if names is not None else [str(k) for k in range(points.count)]
        keep += [exact, _texts("names", labels, points.count)]
        chosen.points, chosen.point_count = exact.at(first), points.count
        chosen.names = ctypes.addressof(keep[-1])
        if strata is not None:
            keep.append(_texts("strata", list(strata), points.count))
            chosen.strata = ctypes.addressof(keep[-1])
    return _written(name, context, library().graze_draw, scene, (ctypes.byref(chosen),))
