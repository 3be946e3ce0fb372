"""Strategies for Hypothesis: scenes of small integers, and points on contacts of every kind::

    @given(graze.strategies.models(3), st.data())
    def test_mine(model, data):
        point = data.draw(graze.strategies.points(model.scene()))
        graze.strategies.check_point(mine, model, point, folder="wrong")

Hypothesis makes and shrinks; the folder holds the last failure, which is the smallest. It needs
Hypothesis 6, python3-hypothesis of Debian. SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import importlib
import itertools
import os
import shutil
from dataclasses import replace
from fractions import Fraction
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from . import testing
from ._hull import Point, hull
from ._judges import kind_of_label, representable
from ._plain import Model, Piece, trimmed
from ._reductions import ONE, ZERO, line, quarter_turn
from ._write import write_folder
from .errors import GrazeError, UseError
from .inputs import Solid
from .scene import Scene

st: Any = importlib.import_module("hypothesis.strategies")
_assume: Any = importlib.import_module("hypothesis").assume
MOST = 8      # of the numbers of solids and motions
POINTS = 300  # made in a scene; one is drawn

Mesh = Tuple[Sequence[Point], Sequence[Sequence[int]]]


def _whole(low: int, high: int) -> Any:
    return st.integers(low, high).map(Fraction)


def _vector(d: int, low: int = -MOST, high: int = MOST) -> Any:
    return st.tuples(*[_whole(low, high)] * d)


def _box(low: Sequence[Fraction], sides: Sequence[Fraction]) -> Mesh:
    made = hull([tuple(a + b * s for a, b, s in zip(low, bits, sides)) for bits in itertools.product((0, 1), repeat=len(low))])
    assert made is not None
    return made


def boxes(d: int = 3) -> Any:
    """Boxes along the axes; in the plane rectangles."""
    return st.builds(_box, _vector(d, 0, 4), _vector(d, 1, 4))


def simplices(d: int = 3) -> Any:
    """Tetrahedra; in the plane triangles."""
    return st.lists(_vector(d, 0, MOST), min_size=d + 1, max_size=d + 1, unique=True).map(hull).filter(lambda made: made is not None)


def hulls(d: int = 3) -> Any:
    """Hulls of a few points."""
    return st.lists(_vector(d, 0, MOST), min_size=d + 1, max_size=d + 5, unique=True).map(hull).filter(lambda made: made is not None)


def prisms() -> Any:
    """Upright prisms over a convex polygon."""
    return st.builds(_prism, hulls(2), _whole(1, MOST))


def _prism(base: Mesh, height: Fraction) -> Mesh:
    made = hull([(*p, z) for p in base[0] for z in (ZERO, height)])
    assert made is not None
    return made


def polycubes(d: int = 3) -> Any:
    """Unions of unit cells that hang together by sides."""
    return st.lists(st.tuples(st.integers(0, 5), st.integers(0, 2 * d - 1)), max_size=5).map(lambda steps: _polycube(d, steps))


def _polycube(d: int, steps: Sequence[Tuple[int, int]]) -> Mesh:
    cells: List[Tuple[int, ...]] = [(0,) * d]
    for at, way in steps:
        cell = cells[at % len(cells)]
        step = tuple(x + (way % 2 * 2 - 1) * (k == way // 2) for k, x in enumerate(cell))
        if step not in cells:
            cells.append(step)
    corners: Dict[Tuple[int, ...], int] = {}
    sides: List[List[int]] = []
    for cell in cells:
        vertices, facets = _box([Fraction(x) for x in cell], [ONE] * d)
        for facet in facets if d == 3 else [[a, b] for a, b in zip(facets[0], [*facets[0][1:], facets[0][0]])]:
            points = [vertices[k] for k in facet]
            middle = [sum(p[k] for p in points) / len(points) - cell[k] for k in range(d)]
            beyond = tuple(x + (1 if m == 1 else -1 if m == 0 else 0) for x, m in zip(cell, middle))
            if beyond not in cells:
                sides.append([corners.setdefault(tuple(map(int, p)), len(corners)) for p in points])
    places = [tuple(map(Fraction, corner)) for corner in corners]
    return places, sides if d == 3 else _rings(sides)


def _rings(sides: List[List[int]]) -> List[List[int]]:
    """Rings of directed sides of the plane; at a corner of four sides, where a ring may go on by two, it takes either."""
    onward: Dict[int, List[int]] = {}
    for a, b in sides:
        onward.setdefault(a, []).append(b)
    rings = []
    while any(onward.values()):
        first = next(a for a, ends in onward.items() if ends)
        ring = [first]
        while True:
            after = onward[ring[-1]].pop()
            if after in ring:
                rings.append(ring[ring.index(after):])
                ring = ring[:ring.index(after) + 1]
                if len(ring) == 1:
                    break
            else:
                ring.append(after)
    return rings


def polygons() -> Any:
    """Rectangles with a rectangular hole, and convex polygons."""
    return st.one_of(hulls(2), st.builds(_holed, _vector(2, 3, 6), _vector(2, 1, 2)))


def _holed(sides: Tuple[Fraction, ...], hole: Tuple[Fraction, ...]) -> Mesh:
    outer, inner = _box((ZERO, ZERO), sides), _box((ONE, ONE), [min(a - 2, b) for a, b in zip(sides, hole)])
    return [*outer[0], *inner[0]], [list(outer[1][0]), [k + len(outer[0]) for k in reversed(inner[1][0])]]


def solids(d: int = 3) -> Any:
    """Polyhedra, or polygons, of every kind here as pairs (vertices, facets), the simplest first."""
    return st.one_of(boxes(3), simplices(3), prisms(), hulls(3), polycubes(3)) if d == 3 else st.one_of(boxes(2), simplices(2), polygons(), polycubes(2))


def curved(d: int = 3) -> Any:
    """Curved solids: balls and boxes along the axes, joined, cut and subtracted."""
    node = st.one_of(st.builds(lambda r, c: Solid.ball(r, c), _whole(1, 4), _vector(d, 0, 4)),
                     st.builds(lambda low, sides: Solid.box(low, [a + b for a, b in zip(low, sides)]), _vector(d, 0, 4), _vector(d, 1, 4)))
    return st.recursive(node, lambda inner: st.builds(_joined, inner, inner, st.sampled_from("|&-")), max_leaves=3)


def _joined(a: Solid, b: Solid, how: str) -> Solid:
    return a | b if how == "|" else a & b if how == "&" else a - b


def legs(d: int = 3) -> Any:
    """One to three straight legs."""
    return st.lists(_vector(d).filter(any), min_size=1, max_size=3).map(_joined_pieces)


def _joined_pieces(ways: Sequence[Sequence[Fraction]]) -> List[Piece]:
    pieces, at = [], [ZERO] * len(ways[0])
    for k, way in enumerate(ways):
        piece = line(way)
        rows = tuple((*row[:-1], trimmed((a - k * x, x))) for row, a, x in zip(piece.entries, at, way))
        pieces.append(replace(piece, start=Fraction(k), end=Fraction(k + 1), entries=rows))
        at = [a + x for a, x in zip(at, way)]
    return pieces


def polynomials(d: int = 3) -> Any:
    """Translations of degree 1 to 3."""
    return st.lists(_vector(d), min_size=1, max_size=3).filter(lambda rows: any(map(any, rows))).map(lambda rows: [_polynomial(rows)])


def _polynomial(rows: Sequence[Sequence[Fraction]]) -> Piece:
    piece = line(rows[0])
    return replace(piece, entries=tuple((*row[:-1], trimmed((ZERO, *column))) for row, column in zip(piece.entries, zip(*rows))))


def quarter_turns(d: int = 3) -> Any:
    """Quarter turns about an axis through the origin."""
    return st.integers(0, 2 if d == 3 else 0).map(lambda axis: [quarter_turn(2 - axis, [ZERO] * d)])


def screws() -> Any:
    """Quarter turns that move along their axis meanwhile."""
    return st.builds(lambda axis, pitch: [quarter_turn(axis, [pitch * (k == axis) for k in range(3)])], st.integers(0, 2), _whole(1, MOST))


def motions(d: int = 3) -> Any:
    """Motions of every kind here, the simplest first."""
    return st.one_of(legs(d), polynomials(d), quarter_turns(d), *([screws()] if d == 3 else []))


def models(d: int = 3, *, solid: Any = None, motion: Any = None, options: Optional[Mapping[str, Any]] = None) -> Any:
    """Models (`graze.shrink.Model`) of the strategies of solids and motions that are given, else of all; each is legal."""
    return st.builds(lambda mesh, pieces: Model(tuple(mesh[0]), tuple(map(tuple, mesh[1])), tuple(pieces), dict(options or {})),
                     solids(d) if solid is None else solid, motions(d) if motion is None else motion).filter(_legal)


def _legal(model: Model) -> bool:
    try:
        model.scene()
    except GrazeError:
        return False
    return True


def points(scene: Scene) -> Any:
    """Points of a scene that floats hold: of integers in its box, then on contacts of every kind, beside them, and anywhere."""
    low, high = scene.box()
    made = [sample.point for sample in scene.generate(POINTS, representable=True)]
    whole = st.tuples(*[_whole(int(a // 1), int(b // 1) + 1) for a, b in zip(low, high)])
    return st.one_of(whole, st.sampled_from(sorted(made, key=lambda p: (max(x.denominator for x in p), p)))) if made else whole


def check_point(classify: Callable[..., Any], model: Union[Model, Scene], point: Sequence[Any], on: Optional[str] = None, *,
                tolerance: Any = None, labels: Optional[Mapping[Any, str]] = None, folder: Any = None) -> None:
    """Hold the label of one point against the exact answer.

    Args:
        classify: a function of points and what `model` is; else as for `graze.testing.check`.
        model: a Model, or a Scene, whose solid may be curved.
        point: numbers that floats hold.
        on, tolerance, labels: as for `graze.testing.check`.
        folder: a failure is written there, as `graze.shrink` does, in place of an earlier one.
    Raises:
        WrongLabels: an AssertionError, if the label is wrong.
    """
    __tracebackhide__ = True  # pytest shows the line of the test
    exact = tuple(map(Fraction, point))
    _assume(all(map(representable, exact)))
    scene = model.scene() if isinstance(model, Model) else model
    wrong, checked = testing.wrong_rows(lambda array: classify(array, model), scene, on=on, points=[exact], tolerance=tolerance, labels=labels)
    if not wrong:
        return
    if folder is not None:
        _renew(os.fspath(folder))
        write_folder(os.fspath(folder), model if isinstance(model, Model) else _model_of(scene), scene, exact,
                     kind_of_label(wrong[0].expected, wrong[0].given), "", [])
    raise testing.WrongLabels(testing.message(scene, wrong, checked, 1, ""), wrong, checked)


def _model_of(scene: Scene) -> Optional[Model]:
    return None if scene.solid.primitives else Model.of(scene)


def _renew(folder: str) -> None:
    """Remove what an earlier failure has left there. A folder of other files stays, and writing into it is refused."""
    if os.path.exists(os.path.join(folder, "reason.txt")):
        shutil.rmtree(folder)
    if os.path.isdir(folder) and os.listdir(folder):
        raise UseError(f"{folder} holds other files; expected a folder of failures, or none")
