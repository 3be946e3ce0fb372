"""A second tracer: contacts, word and cells of one point by another road than the program's.

SPDX-License-Identifier: GPL-3.0-or-later

Every facet (in the plane: edge) gives polynomials along the trajectory: on which side of its plane
the point is, on which side of the lines of its edges, and how far along them. Their roots (Sturm
sequences) cut the piece; the state at each cut follows from exact signs there, the state between
two cuts from a rational sample, by parity. Facets are taken whole, with any number of corners;
nothing is taken from the program but its conventions on cells and words.
"""
from exact import Fraction as F

from algebra import Root, add, between, roots, scale, sort_roots, value
from solids import Polygon, cross, edge, minus


class Contact:
    def __init__(self, start, end, left, cells):
        self.start, self.end, self.left, self.right, self.cells = start, end, left, None, cells

    @property
    def kind(self):
        present = [s for s in (self.left, self.right) if s]
        if len(present) == 2:
            return "intersection" if present[0] != present[1] else "tangency"
        return "intersection" if present == ["I"] else "tangency"


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def whole(numbers):
    """Fractions times a positive number, as ints."""
    den = 1
    for x in numbers:
        den *= F(x).denominator
    return [int(x * den) for x in numbers]


class Line:
    """An edge seen in a plane of two coordinates: forms in (X, W), each an int list a with value
    a[0] X0 + a[1] X1 + a[2] W. `turn` > 0 is the left side of p -> q; `rise` is the height of the
    point over p, `fall` over q."""

    def __init__(self, cell, ends, p, q):
        d = q[0] - p[0], q[1] - p[1]
        self.cell, self.ends = cell, ends
        self.turn = whole([-d[1], d[0], d[1] * p[0] - d[0] * p[1]])
        self.first = whole([d[0], d[1], -dot(d, p)])
        self.second = whole([-d[0], -d[1], dot(d, q)])
        self.rise, self.fall = whole([0, 1, -p[1]]), whole([0, 1, -q[1]])
        self.up = q[1] > p[1]


class Facet:
    """A facet's plane form and its edges, seen along an axis its normal is not square to."""

    def __init__(self, mesh, number):
        cycle = mesh.facets[number]
        p, q, r = mesh.basis(cycle)
        self.normal = cross(minus(q, p), minus(r, p))
        self.plane = whole(list(self.normal) + [-dot(self.normal, p)])
        drop = next(k for k in range(3) if self.normal[k])
        self.axes = [k for k in range(3) if k != drop]
        def flat(k):
            return [mesh.vertices[k][a] for a in self.axes]
        self.lines = [Line(edge(u, v), (u, v), flat(u), flat(v))
                      for u, v in zip(cycle, cycle[1:] + cycle[:1])]
        self.cell = ("face", number)


class Edge:
    """An edge of a polygon: the plane is the whole drawing, so it has no form."""
    plane, axes, cell = None, [0, 1], None

    def __init__(self, polygon, u, v):
        self.lines = [Line(edge(u, v), (u, v), polygon.vertices[u], polygon.vertices[v])]


def along(form, xs, w):
    """A form on the trajectory X / W."""
    total = scale(w, form[-1])
    for c, x in zip(form, xs):
        total = add(total, scale(x, c))
    return total


class View:
    """A solid's facets on one trajectory: pulled-back forms, made when first asked for."""

    def __init__(self, facets, xs, w):
        self.facets, self.xs, self.w, self.made = facets, xs, w, {}

    def pull(self, facet, form):
        key = id(form)
        if key not in self.made:
            xs = self.xs if form is facet.plane else [self.xs[a] for a in facet.axes]
            self.made[key] = along(form, xs, self.w)
        return self.made[key]

    def critical(self):
        """Polynomials between whose roots no cell can change."""
        for facet in self.facets:
            plane = self.pull(facet, facet.plane) if facet.plane else []
            if plane:
                yield plane
                continue
            for line in facet.lines:
                turn = self.pull(facet, line.turn)
                for q in [turn] if turn else [self.pull(facet, line.first),
                                              self.pull(facet, line.second)]:
                    if q:
                        yield q

    def cells(self, t):
        out = set()
        for facet in self.facets:
            if facet.plane and t.sign_of(self.pull(facet, facet.plane)):
                continue
            here = self.on_lines(facet, t)
            if not here and facet.cell and self.within(facet, t):
                here = {facet.cell}
            out |= here
        return out

    def on_lines(self, facet, t):
        out = set()
        for line in facet.lines:
            if t.sign_of(self.pull(facet, line.turn)):
                continue
            first = t.sign_of(self.pull(facet, line.first))
            second = t.sign_of(self.pull(facet, line.second))
            if first > 0 and second > 0:
                out.add(line.cell)
            elif first == 0 or second == 0:
                out.add(("vertex", line.ends[0] if first == 0 else line.ends[1]))
        return out

    def within(self, facet, t):
        """Even-odd: edges crossed by the ray in the direction of the first axis."""
        inside = False
        for line in facet.lines:
            above = t.sign_of(self.pull(facet, line.rise)) >= 0
            if above != (t.sign_of(self.pull(facet, line.fall)) >= 0):
                inside ^= (t.sign_of(self.pull(facet, line.turn)) > 0) == line.up
        return inside


NOW = Root(value=F(0))


def fixed(facets, point):
    """The view of a point that stands still."""
    *xs, w = whole(list(point) + [F(1)])
    return View(facets, [[x] if x else [] for x in xs], [w])


def parity(solid, facets, point):
    """I or O of a point off the boundary."""
    if isinstance(solid, Polygon):
        view = fixed(facets, point)
        inside = False
        for facet in facets:
            inside ^= view.within(facet, NOW)
        return "I" if inside else "O"
    for k in range(1, 100):
        direction = (F(1), F(k, 101), F(k * k, 1009))
        crossed = ray(facets, point, direction)
        if crossed is not None:
            return "I" if crossed % 2 else "O"
    raise ArithmeticError("no ray in general position")


def ray(facets, point, direction):
    """The number of facets a ray crosses, or None where it meets an edge or runs in a plane."""
    count = 0
    for facet in facets:
        height = dot(facet.plane[:3], point) + facet.plane[3]
        speed = dot(facet.plane[:3], direction)
        if speed == 0:
            if height == 0:
                return None
            continue
        s = -height / speed
        if s > 0:
            view = fixed([facet], [p + s * d for p, d in zip(point, direction)])
            if view.on_lines(facet, NOW):
                return None
            count += view.within(facet, NOW)
    return count


def facets_of(solid):
    if isinstance(solid, Polygon):
        return [Edge(solid, u, v) for u, v in solid.edges]
    return [Facet(solid, k) for k in range(len(solid.facets))]


def trace_piece(solid, facets, piece, point):
    """[(start, end, state, cells)] of cuts and gaps on one piece."""
    view = View(facets, *piece.trajectory(point))
    marks = [Root(value=piece.lo), Root(value=piece.hi)]
    for q in view.critical():
        marks += roots(q, piece.lo, piece.hi)
    marks = sort_roots(marks)
    out = []
    for k, t in enumerate(marks):
        cells = view.cells(t)
        out.append((t, t, "B" if cells else None, cells))
        if k + 1 < len(marks):
            s = between(t, marks[k + 1])
            cells = view.cells(Root(value=s))
            place = tuple(value(x, s) / value(view.w, s) for x in view.xs)
            out.append((t, marks[k + 1], "B" if cells else parity(solid, facets, place), cells))
    # off the boundary a cut has the state of the gap beside it
    for k, item in enumerate(out):
        if item[2] is None:
            near = out[k + 1] if k + 1 < len(out) else out[k - 1]
            out[k] = (item[0], item[1], near[2], set())
    return out


def trace(solid, motion, point):
    """(word, contacts) of the inverted trajectory."""
    word, contacts, last = "", [], None
    facets = facets_of(solid)
    for piece in motion.pieces:
        for start, end, state, cells in trace_piece(solid, facets, piece, point):
            if state == "B":
                if last != "B":
                    contacts.append(Contact(start, end, last, set(cells)))
                else:
                    contacts[-1].end = end
                    contacts[-1].cells |= cells
            elif last == "B":
                contacts[-1].right = state
            if state != last:
                word += state
            last = state
    return word, contacts
