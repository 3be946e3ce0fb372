"""Simpler scenes to try in place of one: solids, motions and points, the simplest first.

Nothing here decides whether a scene is legal or an answer wrong: `graze.shrink` asks about each.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import itertools
import math
import random
from dataclasses import replace
from fractions import Fraction
from typing import Dict, Iterator, List, Sequence, Set, Tuple

from ._hull import Point, cut, hull, spread
from ._plain import Model, Piece, Poly, trimmed, value_at

SIZE = 8       # extent of scenes of integers, up to twice as much
FAR = 48       # greatest displacement of one of their motions
LATTICE = 1500 # points of a lattice that are tried at once
CORNERS = 24   # of a hull, at most
ONE, ZERO = Fraction(1), Fraction(0)


def nearest(value: Fraction, unit: Fraction = ONE) -> Fraction:
    """The nearest multiple of a unit."""
    return round(value / unit) * unit


def box_of(points: Sequence[Point]) -> Tuple[Point, Point]:
    """The lowest and the highest corner."""
    return tuple(map(min, zip(*points))), tuple(map(max, zip(*points)))


def added(p: Poly, q: Poly, factor: Fraction = ONE) -> Poly:
    """p + factor q."""
    return trimmed([a + factor * b for a, b in itertools.zip_longest(p, q, fillvalue=ZERO)])


def scaled(poly: Poly, factor: Fraction) -> Poly:
    """A polynomial times a number."""
    return trimmed([factor * c for c in poly])


def times(p: Poly, q: Poly) -> Poly:
    """The product of two polynomials."""
    out = [ZERO] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] += a * b
    return trimmed(out)


def to_integers(model: Model, points: Sequence[Point]) -> Tuple[Model, List[Point]]:
    """The scene with its solid from the origin on and of an extent between SIZE and twice as much, by a power of 2,
    and the points in it; coordinates are not rounded yet."""
    low, high = box_of(model.vertices)
    extent, scale = max(b - a for a, b in zip(low, high)), ONE
    while extent * scale > 2 * SIZE:
        scale /= 2
    while extent * scale <= SIZE:
        scale *= 2
    first = model.pieces[0]
    shift = tuple(nearest(scale * x) for x in first.at(first.start, low))

    def moved(piece: Piece) -> Piece:
        rows = []
        for row, w in zip(piece.entries, shift):
            way = row[-1]
            for p, x in zip(row, low):
                way = added(way, p, x)
            rows.append((*row[:-1], added(scaled(way, scale), piece.weight, -w)))
        return replace(piece, entries=tuple(rows))

    vertices = [tuple((x - a) * scale for x, a in zip(v, low)) for v in model.vertices]
    out = model.shaped(vertices, model.facets, model.convex).moved([moved(piece) for piece in model.pieces])
    return out, [tuple(scale * x - w for x, w in zip(point, shift)) for point in points]


def small_solids(model: Model) -> Iterator[Model]:
    """Convex solids of few corners with integer coordinates, near that of a scene of `to_integers`."""
    seen: Set[Tuple[Point, ...]] = set()
    for count in ((3, 4, 6) if model.dimension == 2 else (4, 6, 9)):
        found = rounded_hull(model, spread(model.vertices, count), ONE)
        if found and found.vertices not in seen:
            seen.add(found.vertices)
            yield found


def rounded_hull(model: Model, points: Sequence[Point], unit: Fraction) -> "Model | None":
    """The hull of points, rounded; None where that is flat."""
    made = hull([tuple(nearest(x, unit) for x in point) for point in points])
    return model.shaped(*made) if made else None


def _translation(start: Fraction, end: Fraction, way: Sequence[Poly]) -> Piece:
    d = len(way)
    rows = tuple((*((ONE,) if i == j else (ZERO,) for j in range(d)), trimmed(way[i])) for i in range(d))
    return Piece(start, end, rows)


def line(by: Sequence[Fraction]) -> Piece:
    """A straight piece for t from 0 to 1."""
    return _translation(ZERO, ONE, [(ZERO, x) for x in by])


def _near(by: Sequence[Fraction]) -> List[Fraction]:
    """A displacement of integers that is not too long."""
    most = max(abs(x) for x in by)
    factor = min(ONE, Fraction(FAR) / most) if most else ONE
    return [nearest(x * factor) for x in by]


def small_motions(model: Model) -> Iterator[List[Piece]]:
    """Motions of few small integers like that of a scene of `to_integers`: a line, a parabola, legs, quarter turns."""
    low, high = box_of(model.vertices)
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    places = [model.pieces[0].at(model.start, middle)] + [piece.at(piece.end, middle) for piece in model.pieces]
    piece = model.pieces[len(model.pieces) // 2]
    half = piece.at((piece.start + piece.end) / 2, middle)

    def between(p: Point, q: Point) -> List[Fraction]:
        return _near([b - a for a, b in zip(p, q)])

    by = between(places[0], places[-1])
    if not any(by):
        by = between(places[0], half)
    if not any(by):
        by = [Fraction(SIZE)] + [ZERO] * (model.dimension - 1)
    yield [line(by)]
    bend = between(places[0], half)
    if any(2 * b != a for a, b in zip(by, bend)):
        yield [_translation(ZERO, ONE, [(ZERO, 4 * b - a, 2 * a - 4 * b) for a, b in zip(by, bend)])]
    if len(model.pieces) > 1:
        yield _legs([between(p, q) for p, q in zip(places, places[1:])][:8])
    if not all(piece.translates for piece in model.pieces):
        for way in ([ZERO] * model.dimension, by):
            for axis in (2, 0, 1)[:1 if model.dimension == 2 else 3]:
                yield [quarter_turn(axis, way)]


def _legs(legs: Sequence[Sequence[Fraction]]) -> List[Piece]:
    at = [ZERO] * len(legs[0])
    out = []
    for k, leg in enumerate(legs):
        out.append(_translation(Fraction(k), Fraction(k + 1), [(a - k * x, x) for a, x in zip(at, leg)]))
        at = [a + x for a, x in zip(at, leg)]
    return out


def quarter_turn(axis: int, by: Sequence[Fraction]) -> Piece:
    """A quarter turn about an axis through the origin while it moves by a displacement, for t from 0 to 1."""
    d = len(by)
    weight: Poly = (ONE, ZERO, ONE)
    u, v = (0, 1) if d == 2 else [(axis + 1) % 3, (axis + 2) % 3]
    turn: Dict[Tuple[int, int], Poly] = {(u, u): (ONE, ZERO, -ONE), (u, v): (ZERO, Fraction(-2)), (v, u): (ZERO, Fraction(2)),
                                         (v, v): (ONE, ZERO, -ONE)}
    rows = []
    for i in range(d):
        row: List[Poly] = [turn.get((i, j), weight if i == j else (ZERO,)) for j in range(d)]
        rows.append((*row, times((ZERO, by[i]), weight)))
    return Piece(ZERO, ONE, tuple(rows), weight)


def simpler_motions(model: Model) -> Iterator[List[Piece]]:
    """Motions that lack something: pieces, times, terms, digits."""
    pieces = model.pieces
    if len(pieces) > 1:
        middle = len(pieces) // 2
        yield from (list(pieces[:middle]), list(pieces[middle:]), list(pieces[1:]), list(pieces[:-1]))
        return
    piece = pieces[0]
    if piece.translates:
        yield from _simpler_ways(piece)
        return
    still = _translation(piece.start, piece.end, [row[-1] for row in piece.entries])
    if piece.weight == (ONE,):
        yield [still]
    level = replace(piece, entries=tuple((*row[:-1], (ZERO,)) for row in piece.entries))
    if level != piece:
        yield [level]
    rows = tuple(tuple(_rounded(p, ONE) for p in row) for row in piece.entries)
    if piece.weight == (ONE,) and rows != piece.entries:
        yield [replace(piece, entries=rows)]
    half = (piece.start + piece.end) / 2
    if half.denominator < 16:
        yield from ([replace(piece, end=half)], [replace(piece, start=half)])


def _rounded(poly: Poly, unit: Fraction) -> Poly:
    return trimmed([nearest(c, unit) for c in poly])


def _simpler_ways(piece: Piece) -> Iterator[List[Piece]]:
    """A translation with fewer terms, then with smaller numbers."""
    way = [row[-1] for row in piece.entries]
    if piece.degree > 1:
        start, end = (tuple(value_at(p, t) for p in way) for t in (piece.start, piece.end))
        if start != end:
            yield [line([b - a for a, b in zip(start, end)])]
        yield [_translation(piece.start, piece.end, [p[:-1] if len(p) == piece.degree + 1 else p for p in way])]
    for i in range(len(way)):
        if any(way[i]) and sum(map(any, way)) > 1:
            yield [_translation(piece.start, piece.end, [(ZERO,) if i == j else p for j, p in enumerate(way)])]
    for smaller in ([_rounded(p, ONE) for p in way], [_rounded(scaled(p, ONE / 2), ONE) for p in way]):
        if smaller != way and any(map(any, smaller)):
            yield [_translation(piece.start, piece.end, smaller)]


def components(model: Model) -> List[List[int]]:
    """Facets that hang together by corners, the numbers of each part."""
    part = list(range(len(model.vertices)))

    def root(k: int) -> int:
        while part[k] != k:
            part[k] = part[part[k]]
            k = part[k]
        return k

    for facet in model.facets:
        for corner in facet[1:]:
            part[root(corner)] = root(facet[0])
    found: Dict[int, List[int]] = {}
    for k, facet in enumerate(model.facets):
        found.setdefault(root(facet[0]), []).append(k)
    return list(found.values())


def _kept(model: Model, facets: Sequence[Sequence[int]]) -> Model:
    """The solid of these facets, without corners that none has."""
    used = sorted({corner for facet in facets for corner in facet})
    place = {corner: k for k, corner in enumerate(used)}
    return model.shaped([model.vertices[k] for k in used], [[place[corner] for corner in facet] for facet in facets], False)


def simpler_solids(model: Model, chance: random.Random) -> Iterator[Model]:
    """Solids that lack something: components, hollows, corners, halves, digits."""
    if model.convex:
        yield from _simpler_hulls(model)
        return
    parts = components(model)
    if len(parts) > 1:
        for chosen in parts[:6]:
            yield _kept(model, [model.facets[k] for k in chosen])
            yield _kept(model, [facet for k, facet in enumerate(model.facets) if k not in set(chosen)])
    made = hull(spread(model.vertices, CORNERS))
    if made:
        yield model.shaped(*made)
    for unit in (ONE, ONE / 16, ONE / 1024):
        vertices = [tuple(nearest(x, unit) for x in v) for v in model.vertices]
        if tuple(vertices) != model.vertices:
            yield model.shaped(vertices, model.facets, False)
    share = len(model.vertices) // 2
    while share:
        yield _collapsed(model, share, chance)
        share //= 2


def _simpler_hulls(model: Model) -> Iterator[Model]:
    simplest = model.dimension + 1
    if len(model.vertices) > simplest + 2:
        yield from filter(None, (rounded_hull(model, spread(model.vertices, count), ONE) for count in (simplest, simplest + 2)))
        low, high = box_of(model.vertices)
        for axis in range(model.dimension):
            for above in (False, True):
                made = hull(cut(model.vertices, axis, (low[axis] + high[axis]) / 2, above))
                if made and len(made[0]) < len(model.vertices):
                    yield model.shaped(*made)
    if len(model.vertices) > simplest:
        for k in range(len(model.vertices)):
            made = hull(model.vertices[:k] + model.vertices[k + 1:])
            if made:
                yield model.shaped(*made)
    whole = rounded_hull(model, model.vertices, ONE)
    if whole and whole.vertices != model.vertices:
        yield whole
    smaller = rounded_hull(model, [tuple(x / 2 for x in v) for v in model.vertices], ONE)
    if smaller and smaller.facet_count <= model.facet_count and smaller.vertices != model.vertices:
        yield smaller


def _collapsed(model: Model, count: int, chance: random.Random) -> Model:
    """`count` corners, no two of one facet, are moved onto a neighbour each."""
    near: Dict[int, Set[int]] = {}
    for facet in model.facets:
        for a, b in zip(facet, facet[1:] + facet[:1]):
            near.setdefault(a, set()).add(b)
            near.setdefault(b, set()).add(a)
    order = list(near)
    chance.shuffle(order)
    onto: Dict[int, int] = {}
    fixed: Set[int] = set()
    for corner in order:
        if len(onto) < count and corner not in fixed and not near[corner] & set(onto):
            onto[corner] = min(near[corner], key=lambda k: sum(float(a - b) ** 2 for a, b in zip(model.vertices[k], model.vertices[corner])))
            fixed |= near[corner] | {corner}
    facets = []
    for facet in model.facets:
        ring = [onto.get(corner, corner) for corner in facet]
        ring = [corner for k, corner in enumerate(ring) if corner != ring[k - 1]]
        if len(ring) > 2 and len(set(ring)) == len(ring):
            facets.append(ring)
    return _kept(model, facets)


def simpler_points(found: Sequence[Point], low: Sequence[Fraction], high: Sequence[Fraction], chance: random.Random) -> List[Point]:
    """Points of fewer digits: multiples of 1 down to 1/64 in the box of the sweep, and roundings of the points that were found."""
    out: List[Point] = []
    for power in (0, 1, 2, 4, 6):
        unit = ONE / 2 ** power
        ranges = [range(math.ceil(a / unit), int(b // unit) + 1) for a, b in zip(low, high)]
        if math.prod(map(len, ranges)) <= LATTICE:
            out += [tuple(unit * k for k in place) for place in itertools.product(*ranges)]
        elif all(map(len, ranges)):
            out += [tuple(unit * chance.choice(steps) for steps in ranges) for _ in range(LATTICE // 2)]
    for point in found[:20]:
        for power in (*range(12), *range(12, 100, 8)):
            near = tuple(nearest(x, ONE / 2 ** power) for x in point)
            out.append(near)
            out += [point[:k] + (near[k],) + point[k + 1:] for k in range(len(point))]
            out += [near[:k] + (point[k],) + near[k + 1:] for k in range(len(point))]
    return list(dict.fromkeys(out))


def to_whole_point(model: Model, point: Point) -> "Tuple[Model, Point] | None":
    """The scene enlarged until the coordinates of the point are integers; None where numbers become large."""
    factor = Fraction(math.lcm(*(x.denominator for x in point)))
    if factor == 1 or max(abs(x) for p in (*model.vertices, point) for x in p) * factor >= 100:
        return None
    pieces = [replace(piece, entries=tuple((*row[:-1], scaled(row[-1], factor)) for row in piece.entries)) for piece in model.pieces]
    vertices = [tuple(x * factor for x in v) for v in model.vertices]
    return model.shaped(vertices, model.facets, model.convex).moved(pieces), tuple(x * factor for x in point)


def digits(values: Sequence[Fraction]) -> int:
    """How long numbers are: binary digits, those of a denominator twice."""
    return sum(abs(x.numerator).bit_length() + 2 * (x.denominator.bit_length() - 1) for x in values)
