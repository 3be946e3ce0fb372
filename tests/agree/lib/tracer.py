"""A second tracer for the plane: contacts, word and cells of one point by another road.

SPDX-License-Identifier: GPL-3.0-or-later

Every edge gives polynomials along the trajectory: on which side of its line the point is, and how
far along the edge. Their roots (Sturm sequences) cut the piece; the state at each cut follows from
exact signs there, the state between two cuts from a rational sample by an even-odd count. Nothing
is taken from the program but its conventions on cells and words.
"""
from fractions import Fraction as F

from algebra import Root, add, between, roots, scale, sort_roots, sub, value


class Contact:
    def __init__(self, start, end, left, cells):
        self.start, self.end, self.left, self.right, self.cells = start, end, left, None, cells

    @property
    def kind(self):
        present = [s for s in (self.left, self.right) if s]
        if len(present) == 2:
            return "intersection" if present[0] != present[1] else "tangency"
        return "intersection" if present == ["I"] else "tangency"


def locate(polygon, point):
    """'I', 'B' or 'O', and the cells that hold the point."""
    x, y = point
    cells, inside = set(), False
    for (u, v) in polygon.edges:
        (ax, ay), (bx, by) = polygon.vertices[u], polygon.vertices[v]
        turn = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
        along = (bx - ax) * (x - ax) + (by - ay) * (y - ay)
        whole = (bx - ax) ** 2 + (by - ay) ** 2
        if turn == 0 and 0 < along < whole:
            cells.add(("edge", min(u, v), max(u, v)))
        if (ay > y) != (by > y) and (turn > 0) == (by > ay):
            inside = not inside
    cells |= {("vertex", k) for k, p in enumerate(polygon.vertices) if p == point}
    return ("B" if cells else "I" if inside else "O"), cells


def edge_forms(polygon, xs, w):
    """Per edge: side, progress from the first vertex, and to the second, as polynomials."""
    for (u, v) in polygon.edges:
        a, b = polygon.vertices[u], polygon.vertices[v]
        den = 1
        for c in a + b:
            den *= c.denominator
        ax, ay, bx, by = (int(c * den) for c in a + b)
        dx, dy = bx - ax, by - ay
        x, y = scale(xs[0], den), scale(xs[1], den)
        from_a = sub(x, scale(w, ax)), sub(y, scale(w, ay))
        from_b = sub(x, scale(w, bx)), sub(y, scale(w, by))
        yield ((u, v), sub(scale(from_a[1], dx), scale(from_a[0], dy)),
               add(scale(from_a[0], dx), scale(from_a[1], dy)),
               scale(add(scale(from_b[0], dx), scale(from_b[1], dy)), -1))


def cells_at(forms, t):
    """The cells met at a root, from the signs of the forms."""
    cells = set()
    for (u, v), side, first, second in forms:
        if t.sign_of(side):
            continue
        s1, s2 = t.sign_of(first), t.sign_of(second)
        if s1 > 0 and s2 > 0:
            cells.add(("edge", min(u, v), max(u, v)))
        elif s1 == 0:
            cells.add(("vertex", u))
        elif s2 == 0:
            cells.add(("vertex", v))
    return cells


def trace_piece(polygon, piece, point):
    """[(kind, start, end, state, cells)] of cuts and gaps on one piece."""
    xs, w = piece.trajectory(point)
    forms = list(edge_forms(polygon, xs, w))
    marks = [Root(value=piece.lo), Root(value=piece.hi)]
    for _, side, first, second in forms:
        for q in ([side] if side else [first, second]):
            if q:
                marks += roots(q, piece.lo, piece.hi)
    marks = sort_roots(marks)
    out = []
    for k, t in enumerate(marks):
        cells = cells_at(forms, t)
        out.append((t, t, "B" if cells else None, cells))
        if k + 1 < len(marks):
            s = between(t, marks[k + 1])
            ws = value(w, s)
            out.append((t, marks[k + 1]) + locate(polygon, tuple(value(x, s) / ws for x in xs)))
    # off the boundary a cut has the state of the gap beside it
    for k, item in enumerate(out):
        if item[2] is None:
            near = out[k + 1] if k + 1 < len(out) else out[k - 1]
            out[k] = (item[0], item[1], near[2], set())
    return out


def trace(polygon, motion, point):
    """(word, contacts) of the inverted trajectory."""
    word, contacts, last = "", [], None
    for piece in motion.pieces:
        for start, end, state, cells in trace_piece(polygon, piece, point):
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
