"""The exact boundary of a planar sweep or unsweep (graze/outline.h).

One thread uses an outline at a time.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import csv
import ctypes
import importlib
import json
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Callable, Dict, List, NamedTuple, Optional, Tuple

from ._abi import C
from ._context import choice
from ._library import Handle, library, take_text
from .errors import UseError

if TYPE_CHECKING:
    from .scene import Scene


class Ring(NamedTuple):
    """A simple ring as a polyline of floats, for pictures and other programs, without proof.

    Attributes:
        points: pairs x, y, with the set on the left; the first one is not repeated.
        hole: True if the ring is around a hole.
        within: the place of the ring around a hole, else None.
    """

    points: List[Tuple[float, float]]
    hole: bool
    within: Optional[int]


class OutlineSample(NamedTuple):
    """A point that shows a side of a piece of an outline, as a row of `graze outline --samples`.

    Attributes:
        point: its coordinates.
        arc: the place of its arc in `record["arcs"]`; None beside a lower arc.
        lower: the place of its lower arc in `record["lower"]["arcs"]`, else None.
        side: `in` or `out`; `on` for a point of a lower arc.
    """

    point: Tuple[Fraction, Fraction]
    arc: Optional[int]
    lower: Optional[int]
    side: str


@dataclass(frozen=True)
class Outline:
    """The boundary of a planar sweep or of the closure of an unsweep's interior; a notebook shows it.

    Attributes:
        components: numbers of the closed set, of its interior, and of holes.
        area: a Fraction where the area is known as one, else None.
        area_bounds: two floats between which the area lies; length_bounds: likewise the length.
        lower_arcs: seams of a sweep, dangling parts of an unsweep, between cuts; lower_points; undecided:
            how many arcs and points may be such.
        record: all that `graze outline --format json` prints, with exact numbers as texts.
    """

    components: int
    interior_components: int
    holes: int
    euler: int
    area: Optional[Fraction]
    area_bounds: Tuple[float, float]
    length_bounds: Tuple[float, float]
    lower_arcs: int
    lower_points: int
    undecided: int
    record: Dict[str, Any]
    _scene: Optional[Scene] = field(repr=False, compare=False)
    _handle: Optional[Handle] = field(repr=False, compare=False)

    def __getstate__(self) -> Dict[str, Any]:
        return {**self.__dict__, "_scene": None, "_handle": None}

    def _text(self, function: Callable[..., int], *more: Any, also: Tuple[Any, ...] = ()) -> str:
        """The text that a function of the library makes of the outline; `also`: its further outputs."""
        if not self._scene or not self._handle:
            raise UseError("an outline that was copied or pickled has its numbers alone; expected the one of Scene.outline")
        context, text = self._scene._context(), ctypes.c_void_p()
        context.run(function, ctypes.byref(text), *also, context.pointer, self._handle.pointer, *more)
        return take_text(text)

    def polygon(self, within: float, form: str = "wkt", side: str = "near") -> str:
        """Valid polygons of doubles, as `graze outline --polygon` writes them: `wkt`, `geojson`, `svg` or `vtk`. Each point of
        an edge is within `within` of the outline. With the side `inside` the polygon is a subset of the set, with `outside` it
        contains the set; with `near` it is on both sides, and each point of the outline is within `within` of the edges.

        Raises:
            UseError: the form, the side, or a distance that is not above 0; LimitError: doubles are too far apart for such polygons.
        """
        numbers = choice("side", side, "graze_polygon_side"), choice("form", form, "graze_polygon_format")
        return self._text(library().graze_outline_polygon, within, *numbers, also=(None,))

    def to_geojson(self, within: float, side: str = "near") -> Dict[str, Any]:
        """These polygons as a geometry of GeoJSON: a dict of `type` and `coordinates`. Raises as `polygon`."""
        shape: Dict[str, Any] = json.loads(self.polygon(within, "geojson", side))
        return shape

    def samples(self) -> List[OutlineSample]:
        """Rational points on both sides of each piece of the boundary, and on and beside each lower arc. Raises MachineError."""
        rows = csv.DictReader(self._text(library().graze_outline_samples).splitlines())
        return [OutlineSample((Fraction(row["x"]), Fraction(row["y"])), int(row["arc"]) if row["arc"] else None,
                              int(row["lower"]) if row["lower"] else None, row["side"]) for row in rows]

    def rings(self, points: int = 32) -> List[Ring]:
        """All rings, with `points` points on each curved arc."""
        arcs = [_along(arc, self.record["vertices"], points) for arc in self.record["arcs"]]
        return [Ring([p for k in ring["arcs"] for p in arcs[k]], ring["hole"], ring["within"]) for ring in self.record["rings"]]

    def to_shapely(self, points: int = 32, within: Optional[float] = None, side: str = "near") -> Any:
        """A MultiPolygon of shapely, which must be installed: one polygon for each component of the interior. With `within` those
        of `polygon`, near the outline or on a side of it by proof; else of `rings`, without."""
        geometry = importlib.import_module("shapely.geometry")
        if within is not None:
            return geometry.shape(self.to_geojson(within, side))
        rings = self.rings(points)
        return geometry.MultiPolygon([geometry.Polygon(r.points, [h.points for h in rings if h.within == k]) for k, r in enumerate(rings) if not r.hole])

    def _repr_svg_(self) -> str:
        rings = self.rings()
        xs, ys = ([p[axis] for r in rings for p in r.points] or [0.0, 1.0] for axis in (0, 1))
        size = max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0
        path = " ".join("M" + " L".join(f"{x:.9g} {-y:.9g}" for x, y in r.points) + " Z" for r in rings)
        view = f"{min(xs) - size / 20:.9g} {-max(ys) - size / 20:.9g} {max(xs) - min(xs) + size / 10:.9g} {max(ys) - min(ys) + size / 10:.9g}"
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="400" viewBox="{view}"><path d="{path}" fill="#dde8f5" '
                f'fill-rule="evenodd" stroke="#225588" stroke-width="{size / 200:.9g}"/></svg>')


def _near(number: Any) -> float:
    return float(Fraction(number)) if isinstance(number, str) else float(number["approx"])


def _along(arc: Dict[str, Any], vertices: List[Dict[str, Any]], points: int) -> List[Tuple[float, float]]:
    """Points of an arc, its end left out."""
    start, end = (vertices[arc[k]]["near"] for k in ("from", "to"))
    source, curve = arc["sources"][0], arc["curve"]
    if source["kind"] == "edge":
        return [(float(start[0]), float(start[1]))]
    low, high = _near(source["from"]), _near(source["to"])
    x, y = (compile(curve[axis].replace("^", "**"), "curve", "eval") for axis in "xy")

    def at(t: float) -> Tuple[float, float]:
        return tuple(float(eval(f, {"__builtins__": {}}, {"t": t})) for f in (x, y))  # type: ignore[return-value]  # the library's own text

    def gap(p: Tuple[float, float], q: Any) -> float:
        return abs(p[0] - float(q[0])) + abs(p[1] - float(q[1]))

    if gap(at(low), start) + gap(at(high), end) > gap(at(low), end) + gap(at(high), start):
        low, high = high, low
    inner = [at(low + (high - low) * k / points) for k in range(1, points)]
    return [(float(start[0]), float(start[1])), *inner]


def read_outline(scene: Scene, width: float) -> Outline:
    """The outline of a scene, which keeps its handle."""
    call, context, pointer, text = library(), scene._context(), ctypes.c_void_p(), ctypes.c_void_p()
    options = C.graze_outline_options(size=ctypes.sizeof(C.graze_outline_options), width=width)
    context.run(call.graze_outline_create, ctypes.byref(pointer), context.pointer, scene._handle.pointer, ctypes.byref(options))
    handle = Handle(pointer, call.graze_outline_destroy, scene._handle)
    facts = call.graze_outline_get(pointer)
    context.run(call.graze_outline_json, ctypes.byref(text), context.pointer, pointer)
    record = json.loads(take_text(text))
    exact = record["area"].get("exact")
    return Outline(facts.components, facts.interior_components, facts.holes, facts.euler, Fraction(exact) if exact else None,
                   (facts.area_low, facts.area_high), (facts.length_low, facts.length_high), facts.lower_arcs, facts.lower_points,
                   facts.undecided, record, scene, handle)
