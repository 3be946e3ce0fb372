"""The distance of two solids at a time, and the cells between which it is reached, by nearest points of convex pieces.

SPDX-License-Identifier: GPL-3.0-or-later

All functions take fractions, and give exact answers then, or doubles. Points have three coordinates, that of the plane z = 0. Two convex
pieces are at the distance of a vertex of one from the other, or of two edges, unless an edge of one passes through the other; a nearest point is
found by projection and clamping. At a rational time the nearest difference w of two pieces is rational, and relatively
open cells are at the distance |w| if and only if the one and the other moved by w have a point in common (meeting.py).
"""
from meeting import Piece, dot, lifted, meet, pieces_of  # noqa: F401

from refine import ears, turns  # noqa: E402
from solids import cross, minus  # noqa: E402


def plus(p, q, s):
    return tuple(a + s * b for a, b in zip(p, q))


def to_segment(p, a, b):
    """The point of the segment that is nearest to p."""
    u = minus(b, a)
    length, s = dot(u, u), dot(minus(p, a), u)
    return a if s <= 0 else b if s >= length else plus(a, u, s / length)


def to_triangle(p, corners):
    """The point of the triangle that is nearest to p."""
    a, b, c = corners
    n = cross(minus(b, a), minus(c, a))
    foot = plus(p, n, -dot(minus(p, a), n) / dot(n, n))
    if all(dot(cross(n, minus(y, x)), minus(foot, x)) >= 0 for x, y in ((a, b), (b, c), (c, a))):
        return foot
    return min((to_segment(p, x, y) for x, y in ((a, b), (b, c), (c, a))), key=lambda x: dot(minus(x, p), minus(x, p)))


def between_segments(p, q, a, b):
    """The way from the first segment to the second where they are nearest."""
    ways = [minus(to_segment(x, a, b), x) for x in (p, q)] + [minus(x, to_segment(x, p, q)) for x in (a, b)]
    u, v, r = minus(q, p), minus(b, a), minus(a, p)
    uu, uv, vv = dot(u, u), dot(u, v), dot(v, v)
    det = uu * vv - uv * uv
    if det > 0:
        s, t = (dot(r, u) * vv - dot(r, v) * uv) / det, (dot(r, u) * uv - dot(r, v) * uu) / det
        if 0 <= s <= 1 and 0 <= t <= 1:
            ways.append(minus(plus(a, v, t), plus(p, u, s)))
    return min(ways, key=lambda w: dot(w, w))


def passes(p, q, corners):
    """Does the segment pass through the closed triangle, from one side of its plane to the other?"""
    a, b, c = corners
    n = cross(minus(b, a), minus(c, a))
    if dot(n, minus(p, a)) * dot(n, minus(q, a)) >= 0:
        return False
    turn = [dot(cross(minus(x, p), minus(y, p)), minus(q, p)) for x, y in ((a, b), (b, c), (c, a))]
    return min(turn) >= 0 or max(turn) <= 0


def sides(corners):
    return list(zip(corners, corners[1:] + corners[:1])) if len(corners) > 2 else [tuple(corners)] if len(corners) == 2 else []


def to_piece(p, corners):
    return corners[0] if len(corners) == 1 else to_segment(p, *corners) if len(corners) == 2 else to_triangle(p, corners)


def way(one, other):
    """The nearest difference, from a convex piece of one to three corners to another."""
    zero = (0, 0, 0)
    for here, there in ((one, other), (other, one)):
        if len(there) == 3 and any(passes(p, q, there) for p, q in sides(here)):
            return zero
    ways = [minus(to_piece(p, other), p) for p in one] + [minus(q, to_piece(q, one)) for q in other]
    ways += [between_segments(p, q, a, b) for p, q in sides(one) for a, b in sides(other)]
    return min(ways, key=lambda w: dot(w, w))


class Body:
    """Triangles (the plane: edges) of a solid, and a vertex of each component; or one point, or one segment, with a radius."""

    def __init__(self, solid=None, base=None, radius=0):
        self.solid, self.radius = solid, radius
        if base is not None:
            self.points, self.cells, self.starts = [lifted(p) for p in base], [tuple(range(len(base)))], [0]
            return
        self.points = [lifted(p) for p in solid.vertices]
        self.cells = list(solid.edges) if solid.dimension == 2 else [t for f in solid.facets for t in triangles(solid, self.points, f)]
        self.starts = starts(self.cells)

    def closed(self):
        return self.solid is not None


def triangles(solid, points, facet):
    return [tuple(t) for t in (ears(solid, facet) if -1 in turns([points[k] for k in facet]) else
                               [(facet[0], a, b) for a, b in zip(facet[1:], facet[2:])]) if area(points, t)]


def area(points, t):
    return any(cross(*(minus(points[k], points[t[0]]) for k in t[1:])))


def starts(cells):
    """A vertex of each component of a boundary, which cells with vertices in common make up."""
    part = {v: v for cell in cells for v in cell}

    def root(v):
        while part[v] != v:
            v = part[v]
        return v
    for cell in cells:
        for v in cell[1:]:
            part[root(v)] = root(cell[0])
    return sorted({root(v) for v in part})


def holds(points, cells, x, d):
    """Is a point that is not on the boundary inside it? The crossings of a ray of no special direction are counted."""
    far = plus(x, (1000003, 10007 if d == 3 else 20011, 30011 if d == 3 else 0), 1000)
    if d == 2:
        def left(a, b, c):
            return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        return sum((left(x, far, points[a]) > 0) != (left(x, far, points[b]) > 0) and
                   (left(points[a], points[b], x) > 0) != (left(points[a], points[b], far) > 0) for a, b in cells) % 2 == 1
    return sum(passes(x, far, [points[k] for k in t]) for t in cells) % 2 == 1


def square_distance(moving, at, fixed, to, d, inside=False):
    """The squared distance of two bodies whose points are `at` and `to`; with `inside` of the first from the other's complement."""
    others, least = [(t, box(t)) for t in ([to[k] for k in cell] for cell in fixed.cells)], None
    for s in ([at[k] for k in cell] for cell in moving.cells):
        here = box(s)
        for t, there in others:
            if least is None or square_gap(here, there) < least:
                w = way(s, t)
                least = dot(w, w) if least is None else min(least, dot(w, w))
    if least and any(holds(to, fixed.cells, at[k], d) != inside for k in moving.starts if fixed.closed()):
        return 0
    if least and not inside and any(holds(at, moving.cells, to[k], d) for k in fixed.starts if moving.closed()):
        return 0
    return least


def near_cells(moving, motion, fixed, time, square, motion_of_fixed=None):
    """{(moving cell, fixed cell)} at a squared distance at a rational time, which is that of the boundaries."""
    def placed(solid, by):
        return pieces_of(solid if by is None else solid.mapped(lambda p: by.map(p, time)))
    found, others = set(), [(b, other, box(other.corners)) for b, other in placed(fixed, motion_of_fixed)]
    for a, one in placed(moving, motion):
        here = box(one.corners)
        for b, other, there in others:
            if square_gap(here, there) > square:
                continue  # no nearer than their boxes
            w = min((way(s, t) for s in fans(one.corners) for t in fans(other.corners)), key=lambda w: dot(w, w))
            if dot(w, w) == square and meet(one, Piece([minus(p, w) for p in other.corners])):
                found.add((a, b))
    return found


def box(corners):
    return [(min(xs), max(xs)) for xs in zip(*corners)]


def square_gap(one, other):
    """The squared distance of two boxes."""
    return sum(max(a - d, c - b, 0) ** 2 for (a, b), (c, d) in zip(one, other))


def fans(corners):
    """A convex piece as points, segments and triangles, without triangles that have no area."""
    if len(corners) < 3:
        return [corners]
    return [[corners[0], p, q] for p, q in zip(corners[1:], corners[2:]) if any(cross(minus(p, corners[0]), minus(q, corners[0])))]
