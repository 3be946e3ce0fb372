"""Pairs of cells of two solids that have a point in common, at one rational time, by clipping in fractions.

SPDX-License-Identifier: GPL-3.0-or-later

A cell is a union of relatively open convex pieces: a point, a segment without its ends, a convex facet without its
border; a facet that is not convex is cut into triangles and the diagonals between them. The closed pieces meet in a
convex polygon; relatively open ones meet if and only if the mean of its corners is in both. The plane is z = 0.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import Fraction as F  # noqa: E402
from refine import ears, turns  # noqa: E402
from solids import cross, minus  # noqa: E402


def lifted(p):
    return tuple(p) + (F(0),) * (3 - len(p))


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


class Piece:
    """Corners in order, and affine forms (n, c) with n x + c: `zero` on it, `positive` inside it."""

    def __init__(self, corners):
        self.corners, self.zero, self.positive = corners, [], []
        p = corners[0]
        axes = [tuple(F(int(i == j)) for j in range(3)) for i in range(3)]
        if len(corners) == 1:
            self.zero = [through(n, p) for n in axes]
        elif len(corners) == 2:
            u = minus(corners[1], p)
            self.zero = [through(n, p) for n in (cross(u, a) for a in axes) if any(n)]
            self.positive = [through(u, p), through(minus(p, corners[1]), corners[1])]
        else:
            n = next(n for n in (cross(minus(q, p), minus(r, p)) for q, r in zip(corners[1:], corners[2:])) if any(n))
            if dot(n, area(corners)) < 0:
                n = minus((0, 0, 0), n)
            self.zero = [through(n, p)]
            self.positive = [through(cross(n, minus(b, a)), a) for a, b in zip(corners, corners[1:] + corners[:1])]
        self.low, self.high = [min(x) for x in zip(*corners)], [max(x) for x in zip(*corners)]

    def holds(self, x):
        return all(value(f, x) == 0 for f in self.zero) and all(value(f, x) > 0 for f in self.positive)


def through(n, p):
    return n, -dot(n, p)


def value(form, x):
    return dot(form[0], x) + form[1]


def area(corners):
    total = (F(0),) * 3
    for a, b in zip(corners, corners[1:] + corners[:1]):
        total = tuple(x + y for x, y in zip(total, cross(minus(a, corners[0]), minus(b, corners[0]))))
    return total


def clipped(corners, form):
    """The part of a convex polygon, segment or point where the form is not negative."""
    out = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        u, v = value(form, a), value(form, b)
        if u >= 0:
            out.append(a)
        if u * v < 0:
            out.append(tuple(x + (y - x) * u / (u - v) for x, y in zip(a, b)))
    return out


def meet(one, other):
    if any(a > b for a, b in zip(one.low, other.high)) or any(a > b for a, b in zip(other.low, one.high)):
        return False
    rest = one.corners
    for form in other.positive + other.zero + [(minus((0, 0, 0), n), -c) for n, c in other.zero]:
        rest = clipped(rest, form)
        if not rest:
            return False
    mean = tuple(sum(x) / len(rest) for x in zip(*rest))
    return one.holds(mean) and other.holds(mean)


def pieces_of(solid):
    """(name of a cell, Piece) for every vertex, edge and facet of a Polygon or Mesh."""
    at = [lifted(p) for p in solid.vertices]
    out = [(("vertex", k), Piece([p])) for k, p in enumerate(at)]
    out += [(("edge", min(e), max(e)), Piece([at[k] for k in e])) for e in solid.edges]
    for number, facet in enumerate(getattr(solid, "facets", [])):
        parts = [facet]
        if -1 in turns([at[k] for k in facet]):
            parts = ears(solid, facet)
        border = {frozenset(e) for e in zip(facet, facet[1:] + facet[:1])}
        diagonals = {frozenset(e) for part in parts for e in zip(part, part[1:] + part[:1])} - border
        out += [(("face", number), Piece([at[k] for k in part])) for part in parts + [tuple(e) for e in diagonals]]
    return out


def meeting_cells(moving, motion, fixed, time, motion_of_fixed=None):
    """{(moving cell, fixed cell)} with a common point at a rational time."""
    def placed(solid, by):
        return pieces_of(solid if by is None else solid.mapped(lambda p: by.map(p, time)))
    others = placed(fixed, motion_of_fixed)
    return {(a, b) for a, one in placed(moving, motion) for b, other in others if meet(one, other)}
