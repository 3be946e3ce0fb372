"""Words and times of pairs of convex solids of cases/contacts, asked of separating axes at single times.

SPDX-License-Identifier: GPL-3.0-or-later

Two convex polyhedra have no interior point in common if and only if their shadows have none along a normal of a facet of either or
along a product of two edges, and no point at all if and only if the shadows are apart along one. So the state at a rational time is
exact and knows nothing of features that come near. It is asked in the middle of each gap between contacts, at both ends and in
the middle of each contact whose ends are rational, and beside each contact by 2^-40: at a root, on either side of the interval
that holds it, narrowed to that width by signs of its polynomial.
"""
from itertools import chain

from motions import motion_of, value
from exact import Fraction as F  # noqa: E402

NEAR = F(1, 2 ** 40)


def read_off(path):
    """Vertices, and facets as lists of numbers of vertices."""
    with open(path, encoding="ascii") as file:
        lines = [line.split() for line in file if line.strip() and not line.startswith("#")]
    vertices, facets = int(lines[1][0]), int(lines[1][1])
    body = lines[2:]
    return [tuple(map(F, row[:3])) for row in body[:vertices]], [list(map(int, row[1:])) for row in body[vertices:vertices + facets]]


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def distinct(vectors):
    """One of each direction; the opposite one is the same."""
    out = {}
    for v in vectors:
        lead = next((x for x in v if x), None)
        if lead is not None:
            out[tuple(x / lead for x in v)] = v
    return list(out.values())


class Convex:
    """A mesh: vertices, one vector of each edge's direction, one normal of each facet."""

    def __init__(self, vertices, facets):
        self.vertices = vertices
        sides = ((f[k - 1], f[k]) for f in facets for k in range(len(f)))
        self.edges = distinct(minus(vertices[b], vertices[a]) for a, b in sides)
        self.corners = [f[:3] for f in facets]
        self.normals = distinct(self.normal(f) for f in self.corners)

    def normal(self, corners):
        a, b, c = (self.vertices[k] for k in corners)
        return cross(minus(b, a), minus(c, a))

    def is_convex(self):
        """Is no vertex before the plane of a facet?"""
        return all(dot(self.normal(f), minus(v, self.vertices[f[0]])) <= 0 for f in self.corners for v in self.vertices)

    def moved(self, pieces, t):
        """The solid at a time; a piece's matrix is regular, so that edges and normals are those of moved corners."""
        rows, weight = next((rows, weight) for t0, t1, rows, weight in pieces if t0 <= t <= t1)
        at = [[value(entry, t) / value(weight, t) for entry in row] for row in rows]
        out = Convex.__new__(Convex)
        out.vertices = [tuple(dot(row[:3], v) + row[3] for row in at) for v in self.vertices]
        out.corners = self.corners
        out.edges = [tuple(dot(row[:3], e) for row in at) for e in self.edges]
        out.normals = distinct(out.normal(f) for f in self.corners)
        return out


def state(one, other):
    """O: apart; B: they touch; I: their interiors meet."""
    found = "I"
    for axis in chain(one.normals, other.normals, distinct(cross(e, f) for e in one.edges for f in other.edges)):
        p, q = [dot(axis, v) for v in one.vertices], [dot(axis, v) for v in other.vertices]
        common = min(max(p), max(q)) - max(min(p), min(q))
        if common < 0:
            return "O"
        if common == 0:
            found = "B"
    return found


def bounds(time):
    """The time twice, or an interval of width 2^-40 that holds the root."""
    if isinstance(time, str):
        return F(time), F(time)
    poly, low, high = [F(c) for c in time["poly"]], F(time["lo"]), F(time["hi"])
    rises = value(poly, low) < 0
    while high - low > NEAR:
        middle = (low + high) / 2
        if (value(poly, middle) < 0) == rises:
            low = middle
        else:
            high = middle
    return low, high


def stations(found, start, end):
    """(time, state that the answer's word and contacts give it), in order."""
    out, before, contacts = [], start, iter(found["contacts"])
    for k, letter in enumerate(found["word"]):
        if letter == "B":
            contact = next(contacts)
            first, last = bounds(contact["from"]), bounds(contact["to"])
            out += [(t, "B") for t in {first[0], (first[0] + last[1]) / 2, last[1]}
                    if first[0] == first[1] and last[0] == last[1] or first[1] < t < last[0]]
            before = last[1]
        else:
            after = min((t for c in found["contacts"] for t in bounds(c["from"])[:1] if t >= before and bounds(c["to"])[1] > before), default=end)
            after = after if "B" in found["word"][k:] else end
            gap = after - before
            out += [(t, letter) for t in (before + min(NEAR, gap / 4), before + gap / 2, after - min(NEAR, gap / 4)) if gap > 0]
    return out


def check_pair(checks, out, pair, found, most):
    """Asks each station of a pair of convex solids with at most `most` facets in all; else nothing."""
    one, other = (Convex(*read_off(f"{out}/{pair[name]}")) for name in ("moving", "fixed"))
    if len(one.corners) + len(other.corners) > most or not (one.is_convex() and other.is_convex()):
        return False
    with open(f"{out}/{pair['motion']}", encoding="ascii") as file:
        pieces = motion_of(file.read())
    for t, letter in stations(found, pieces[0][0], pieces[-1][1]):
        checks.equal(state(one.moved(pieces, t), other), letter, f"{pair['id']}: state at {t} by separating axes")
    return True
