"""Scenes as exact numbers that can be changed: facets, and pieces of rational entries.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import json
import re
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

from ._context import Context
from ._hull import Point, normal
from ._library import library, take_text
from .errors import UseError
from .inputs import Motion, Solid, input_handle, input_settings
from .scene import Scene

Poly = Tuple[Fraction, ...]  # coefficients, the constant first
_ONE: Poly = (Fraction(1),)


def value_at(poly: Poly, t: Fraction) -> Fraction:
    """A polynomial's value."""
    out = Fraction(0)
    for c in reversed(poly):
        out = out * t + c
    return out


def trimmed(poly: Sequence[Fraction]) -> Poly:
    """A polynomial without leading zeros; one coefficient at least."""
    out = list(poly) or [Fraction(0)]
    while len(out) > 1 and not out[-1]:
        out.pop()
    return tuple(out)


def _poly(text: str) -> Poly:
    out: Dict[int, Fraction] = {}
    for term in re.findall(r"-?[^\s+-]\S*", text.replace("- ", "-")):
        c, _, power = term.partition("*t")
        out[0 if not _ else int(power[1:] or 1)] = Fraction(c)
    return trimmed([out.get(k, Fraction(0)) for k in range(max(out) + 1)])


def _text(poly: Poly) -> str:
    terms = [(number(c) if not k else "t" if c == 1 else number(c) + "*t") + (f"^{k}" if k > 1 else "") for k, c in enumerate(poly) if c]
    return " + ".join(terms).replace("+ -", "- ") or "0"


def number(value: Fraction) -> str:
    """A decimal where there is a finite one of a moderate length, else a ratio."""
    twos, fives, rest = 0, 0, value.denominator
    while rest % 2 == 0:
        rest, twos = rest // 2, twos + 1
    while rest % 5 == 0:
        rest, fives = rest // 5, fives + 1
    places = max(twos, fives)
    if rest != 1 or places > 1100:
        return str(value)
    if not places:
        return str(value.numerator)
    digits = str(abs(value.numerator) * 10 ** places // value.denominator).rjust(places + 1, "0")
    return ("-" if value < 0 else "") + digits[:-places] + "." + digits[-places:]


def motion_of(scene: Scene) -> Motion:
    """The motion of a scene, which must have one."""
    if scene.motion is None:
        raise UseError("the solid is at rest; expected a scene with a motion")
    return scene.motion


@dataclass(frozen=True)
class Piece:
    """A piece of a motion: its times, d rows of d + 1 numerators, their common denominator."""

    start: Fraction
    end: Fraction
    entries: Tuple[Tuple[Poly, ...], ...]
    weight: Poly = _ONE

    @property
    def degree(self) -> int:
        """The greatest degree of a numerator or the denominator."""
        return max(len(poly) for poly in (self.weight, *(p for row in self.entries for p in row))) - 1

    @property
    def translates(self) -> bool:
        """Is it a translation whose entries are polynomials?"""
        d = len(self.entries)
        return self.weight == _ONE and all(self.entries[i][j] == (Fraction(int(i == j)),) for i in range(d) for j in range(d))

    def at(self, t: Fraction, point: Sequence[Fraction]) -> Point:
        """Where a point of the solid is at a time."""
        weight = value_at(self.weight, t)
        return tuple(sum((value_at(p, t) * x for p, x in zip(row, (*point, Fraction(1)))), Fraction(0)) / weight for row in self.entries)

    def transform(self) -> Dict[str, Any]:
        """The transform of a motion file."""
        if self.translates:
            return {"translate": [_text(row[-1]) for row in self.entries]}
        under = "" if self.weight == _ONE else f"/({_text(self.weight)})"
        return {"matrix": [[f"({_text(p)}){under}" if under else _text(p) for p in row] for row in self.entries]}


@dataclass(frozen=True)
class Model:
    """A scene as exact numbers.

    Attributes:
        vertices, facets: corners of the solid, and for each facet, in the plane each ring, its corners from 0.
        pieces: the pieces of the motion, one after the other.
        options: `operation`, `folds`, `overlap` of its `Scene`.
        convex: whether the solid is known to be convex.
    """

    vertices: Tuple[Point, ...]
    facets: Tuple[Tuple[int, ...], ...]
    pieces: Tuple[Piece, ...]
    options: Mapping[str, Any] = field(default_factory=dict)
    convex: bool = False

    @classmethod
    def of(cls, scene: Scene) -> "Model":
        """The model of a scene of a polyhedron or polygon; facets are triangles."""
        text = _solid_text(scene.solid)
        vertices, facets = _read_wkt(text) if scene.dimension == 2 else _read_off(text)
        pieces = []
        for piece in json.loads(motion_of(scene).json())["pieces"]:
            rows = [[entry[1:-1].split(")/(") if entry.startswith("(") else [entry, "1"] for entry in row] for row in piece["transform"]["matrix"]]
            weight = _poly(rows[0][0][1])
            pieces.append(Piece(Fraction(piece["t"][0]), Fraction(piece["t"][1]), tuple(tuple(_poly(e[0]) for e in row) for row in rows), weight))
        options = {"operation": scene.operation, "folds": scene.folds, "overlap": scene.overlap}
        return cls(tuple(vertices), tuple(map(tuple, facets)), tuple(pieces), options)

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return len(self.pieces[0].entries)

    @property
    def facet_count(self) -> int:
        """Facets, in the plane edges."""
        return sum(map(len, self.facets)) if self.dimension == 2 else len(self.facets)

    @property
    def motion(self) -> Dict[str, Any]:
        """The motion as a file has it."""
        return {"dimension": self.dimension,
                "pieces": [{"t": [number(p.start), number(p.end)], "transform": p.transform()} for p in self.pieces]}

    def motion_text(self) -> str:
        """The motion file, a line for each piece."""
        lines = ",\n  ".join(json.dumps(piece) for piece in self.motion["pieces"])
        return f'{{"dimension": {self.dimension}, "pieces": [\n  {lines}]}}\n'

    def solid_text(self, ending: str) -> str:
        """The solid in the format of an ending: .off .obj .ply .stl .wkt."""
        return _WRITERS[ending](self)

    def scene(self) -> Scene:
        """The scene of these numbers. Raises IllegalError and others: it is not legal, or meets a limit."""
        return Scene((self.vertices, self.facets), self.motion, **self.options)

    def pose(self, t: float) -> List[List[float]]:
        """The matrix at a time, d rows of d + 1 floats."""
        when = Fraction(t)
        piece = next((p for p in self.pieces if when <= p.end), self.pieces[-1])
        weight = value_at(piece.weight, when)
        return [[float(value_at(p, when) / weight) for p in row] for row in piece.entries]

    @property
    def start(self) -> Fraction:
        """The first time of the motion."""
        return self.pieces[0].start

    @property
    def end(self) -> Fraction:
        """Its last time."""
        return self.pieces[-1].end

    def moved(self, pieces: Sequence[Piece]) -> "Model":
        """This solid with another motion."""
        return replace(self, pieces=tuple(pieces))

    def shaped(self, vertices: Sequence[Point], facets: Sequence[Sequence[int]], convex: bool = True) -> "Model":
        """Another solid with this motion."""
        return replace(self, vertices=tuple(vertices), facets=tuple(map(tuple, facets)), convex=convex)


def _solid_text(solid: Solid) -> str:
    context, out = Context(input_settings(solid)), ctypes.c_void_p()
    context.run(library().graze_solid_text, ctypes.byref(out), context.pointer, input_handle(solid).pointer)
    return take_text(out)


def _read_off(text: str) -> Tuple[List[Point], List[List[int]]]:
    words = " ".join(line.split("#")[0] for line in text.splitlines()).split()
    count, facets, at = int(words[1]), int(words[2]), 4
    numbers = list(map(Fraction, words[at:at + 3 * count]))
    vertices: List[Point] = [tuple(numbers[k:k + 3]) for k in range(0, 3 * count, 3)]
    at, out = at + 3 * count, []
    for _ in range(facets):
        size = int(words[at])
        out.append([int(word) for word in words[at + 1:at + 1 + size]])
        at += size + 1
    return vertices, out


def _read_wkt(text: str) -> Tuple[List[Point], List[List[int]]]:
    vertices: List[Point] = []
    rings = []
    for ring in re.findall(r"\(([^()]+)\)", text):
        points = [tuple(map(Fraction, point.split())) for point in ring.split(",")][:-1]
        rings.append(list(range(len(vertices), len(vertices) + len(points))))
        vertices += points
    return vertices, rings


def _off(model: Model) -> str:
    lines = ["OFF", f"{len(model.vertices)} {len(model.facets)} 0", *(" ".join(map(number, v)) for v in model.vertices)]
    return "\n".join(lines + [" ".join(map(str, (len(f), *f))) for f in model.facets]) + "\n"


def _obj(model: Model) -> str:
    lines = ["v " + " ".join(map(number, v)) for v in model.vertices]
    return "\n".join(lines + ["f " + " ".join(str(k + 1) for k in f) for f in model.facets]) + "\n"


def _ply(model: Model) -> str:
    head = ["ply", "format ascii 1.0", f"element vertex {len(model.vertices)}", *(f"property double {x}" for x in "xyz"),
            f"element face {len(model.facets)}", "property list uchar int vertex_indices", "end_header"]
    lines = [" ".join(map(number, v)) for v in model.vertices]
    return "\n".join(head + lines + [" ".join(map(str, (len(f), *f))) for f in model.facets]) + "\n"


def _stl(model: Model) -> str:
    lines = ["solid graze"]
    for facet in model.facets:
        for k in range(1, len(facet) - 1):
            corners = [model.vertices[i] for i in (facet[0], facet[k], facet[k + 1])]
            n = [float(x) for x in normal(*corners)]
            size = sum(x * x for x in n) ** 0.5 or 1
            lines += ["facet normal " + " ".join(f"{x / size:.9g}" for x in n), "outer loop",
                      *("vertex " + " ".join(map(number, corner)) for corner in corners), "endloop", "endfacet"]
    return "\n".join(lines + ["endsolid graze"]) + "\n"


def _wkt(model: Model) -> str:
    """One polygon, or several: a ring that turns clockwise is a hole of the ring before it that does not."""
    polygons: List[List[str]] = []
    for ring in model.facets:
        points = [model.vertices[k] for k in ring]
        area = sum((a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:] + points[:1])), Fraction(0))
        text = "(" + ", ".join(" ".join(map(number, p)) for p in points + points[:1]) + ")"
        if area > 0 or not polygons:
            polygons.append([text])
        else:
            polygons[-1].append(text)
    texts = ["(" + ", ".join(rings) + ")" for rings in polygons]
    return (f"POLYGON {texts[0]}" if len(texts) == 1 else f"MULTIPOLYGON ({', '.join(texts)})") + "\n"


_WRITERS = {".off": _off, ".obj": _obj, ".ply": _ply, ".stl": _stl, ".wkt": _wkt}


def written_ending(path: Optional[str], dimension: int) -> str:
    """The ending of the solids that are written for a candidate: that of its own file where it is one of those."""
    found = next((ending for ending in _WRITERS if path and path.endswith(ending)), ".off")
    return ".wkt" if dimension == 2 else found if found != ".wkt" else ".off"
