"""Convex hulls of a few points, exactly, with whole facets.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import itertools
from fractions import Fraction
from typing import List, Optional, Sequence, Tuple

Point = Tuple[Fraction, ...]
Mesh = Tuple[List[Point], List[List[int]]]


def hull(points: Sequence[Point]) -> Optional[Mesh]:
    """Corners and facets, counterclockwise from outside, of the hull; in the plane one ring. None: it is flat.

    Every triple of points is tried as a facet: some dozens of points are enough here.
    """
    distinct = sorted(set(points))
    if len(distinct) <= (len(distinct[0]) if distinct else 0):
        return None
    facets = _ring(distinct) if len(distinct[0]) == 2 else _facets(distinct)
    if not facets:
        return None
    used = sorted({corner for facet in facets for corner in facet})
    place = {corner: k for k, corner in enumerate(used)}
    return [distinct[k] for k in used], [[place[corner] for corner in facet] for facet in facets]


def _turn(a: Point, b: Point, c: Point) -> Fraction:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _ring(points: List[Point]) -> List[List[int]]:
    """The corners of sorted points of the plane, counterclockwise, without those in the middle of a side."""
    chains: List[List[int]] = []
    for order in (range(len(points)), range(len(points) - 1, -1, -1)):
        chain: List[int] = []
        for k in order:
            while len(chain) > 1 and _turn(points[chain[-2]], points[chain[-1]], points[k]) <= 0:
                chain.pop()
            chain.append(k)
        chains.append(chain[:-1])
    ring = chains[0] + chains[1]
    return [ring] if len(ring) > 2 else []


def normal(a: Point, b: Point, c: Point) -> Point:
    """The normal of the plane of three points, by the right hand."""
    u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def _facets(points: List[Point]) -> List[List[int]]:
    found: List[List[int]] = []
    seen = set()
    for triple in itertools.combinations(range(len(points)), 3):
        a, b, c = (points[k] for k in triple)
        n = normal(a, b, c)
        if not any(n):
            continue
        heights = [sum(x * (p - q) for x, p, q in zip(n, point, a)) for point in points]
        low, high = min(heights), max(heights)
        if low < 0 < high:
            continue
        if low == high:
            return []
        on = tuple(k for k, height in enumerate(heights) if height == 0)
        if on not in seen:
            seen.add(on)
            found.append(_facet(points, on, n if high == 0 else tuple(-x for x in n)))
    return found


def _facet(points: List[Point], on: Tuple[int, ...], n: Point) -> List[int]:
    """The corners of a facet with this outer normal."""
    axis = max(range(3), key=lambda k: abs(n[k]))
    u, v = [k for k in range(3) if k != axis]
    if (n[axis] > 0) != (axis != 1):  # x, z for y: the left hand
        u, v = v, u
    flat = sorted((points[k][u], points[k][v], k) for k in on)
    ring = _ring([point[:2] for point in flat])[0]
    return [flat[k][2] for k in ring]


def cut(points: Sequence[Point], axis: int, place: Fraction, above: bool) -> List[Point]:
    """Points whose hull is that of a half of a convex solid: its corners on one side, and where its edges and
    diagonals pass the plane."""
    side = [(point[axis] - place) * (1 if above else -1) for point in points]
    out = [point for point, value in zip(points, side) if value >= 0]
    for (p, a), (q, b) in itertools.combinations(list(zip(points, side)), 2):
        if a * b < 0:
            out.append(tuple(x + (y - x) * a / (a - b) for x, y in zip(p, q)))
    return out


def spread(points: Sequence[Point], count: int) -> List[Point]:
    """`count` of the points that are far from one another: the first is the lowest."""
    chosen = [min(points)]
    nearest = {point: _square(point, chosen[0]) for point in points}
    while len(chosen) < count:
        point = max(points, key=lambda p: (nearest[p], p))
        if not nearest[point]:
            break
        chosen.append(point)
        for other in points:
            nearest[other] = min(nearest[other], _square(other, point))
    return chosen


def _square(p: Point, q: Point) -> float:
    return sum(float(a - b) ** 2 for a, b in zip(p, q))
