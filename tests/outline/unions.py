"""A second method for translations along legs: the union of polygons, exactly, by slabs.

SPDX-License-Identifier: GPL-3.0-or-later

The sweep along a leg is the solid at its start and the parallelogram of each side with the leg. All sides of all these are cut by
upright lines through their ends and crossings; between two lines nothing crosses, so the order in the middle is that of the slab.
"""
from slices import Cells, F


class Union:
    """`area`, `components`, `interior_components` and `holes` of a union of polygons, each a list of directed sides; of what lies between
    the border of the union and its unbounded cells, if `outside`."""

    def __init__(self, polygons, outside=False):
        self.polygons, self.outside = polygons, outside
        sides = {(min(s), max(s)) for polygon in polygons for s in polygon}
        xs = sorted({p[0] for s in sides for p in s} | set(crossings([s for s in sides if s[0][0] != s[1][0]])))
        self.slabs = [(a, b, self.cells(a, b)) for a, b in zip(xs, xs[1:])]
        self.area = sum((b - a) * (height(top, (a + b) / 2) - height(bottom, (a + b) / 2))
                        for a, b, cells in self.slabs for bottom, top in cells)
        self.count()

    def cells(self, a, b):
        """(bottom side, top side) of the cells between two lines, in order."""
        middle, spans = (a + b) / 2, []
        for polygon in self.polygons:
            met = sorted((height(s, middle), s) for s in polygon if min(s)[0] <= a and max(s)[0] >= b and s[0][0] != s[1][0])
            spans += [(*p, *q) for p, q in zip(met[0::2], met[1::2])]
        out = []
        for low, bottom, high, top in sorted(spans):
            if out and low <= out[-1][2]:
                if high > out[-1][2]:
                    out[-1][2:] = high, top
            else:
                out.append([low, bottom, high, top])
        if self.outside:
            return [(p[3], q[1]) for p, q in zip(out, out[1:])]
        return [(cell[1], cell[3]) for cell in out]

    def count(self):
        closed, inner, free = Cells(), Cells(), Cells()
        free.root("all")
        ends = [(None, None, []), *self.slabs, (None, None, [])]
        for k, (left, right) in enumerate(zip(ends, ends[1:])):
            x = right[0] if right[0] is not None else left[1]
            before, after = ([(height(p, x), height(q, x)) for p, q in slab[2]] for slab in (left, right))
            for n in range(len(after)):
                closed.root((k + 1, n)), inner.root((k + 1, n))
            for m, p in enumerate(before):
                for n, q in enumerate(after):
                    overlap = min(p[1], q[1]) - max(p[0], q[0])
                    if overlap >= 0:
                        closed.join((k, m), (k + 1, n))
                    if overlap > 0:
                        inner.join((k, m), (k + 1, n))
            self.join_gaps(free, k, gaps(before), gaps(after))
        self.components, self.interior_components, self.holes = closed.count(), inner.count(), free.count() - 1

    @staticmethod
    def join_gaps(free, k, before, after):
        for n, q in enumerate(after):
            free.root(name(k + 1, n, q))
        for m, p in enumerate(before):
            for n, q in enumerate(after):
                low = max((x for x in (p[0], q[0]) if x is not None), default=None)
                high = min((x for x in (p[1], q[1]) if x is not None), default=None)
                if low is None or high is None or low < high:
                    free.join(name(k, m, p), name(k + 1, n, q))


def name(slab, number, cell):
    return "all" if None in cell else (slab, number)


def gaps(cells):
    marks = [None, *(x for cell in cells for x in cell), None]
    return list(zip(marks[0::2], marks[1::2]))


def height(side, x):
    (a, b), (c, d) = side
    return b + (d - b) * (x - a) / (c - a)


def crossings(sides):
    """x of the inner crossings of sides that are not upright."""
    sides = sorted((min(s), max(s)) for s in sides)
    for k, p in enumerate(sides):
        for q in sides[k + 1:]:
            if q[0][0] >= p[1][0]:
                break
            slopes = [(s[1][1] - s[0][1]) / (s[1][0] - s[0][0]) for s in (p, q)]
            if slopes[0] != slopes[1]:
                x = (q[0][1] - p[0][1] + slopes[0] * p[0][0] - slopes[1] * q[0][0]) / (slopes[0] - slopes[1])
                if max(p[0][0], q[0][0]) < x < min(p[1][0], q[1][0]):
                    yield x


def swept(solid, path):
    """The polygons of a sweep along legs between the points of `path`."""
    out = []
    for (a, b), (c, d) in zip(path, path[1:]):
        sides = [(solid.vertices[u], solid.vertices[v]) for u, v in solid.edges]
        out.append([((p[0] + a, p[1] + b), (q[0] + a, q[1] + b)) for p, q in sides])
        for p, q in sides:
            if (q[0] - p[0]) * (d - b) != (q[1] - p[1]) * (c - a):
                ring = [(p[0] + a, p[1] + b), (q[0] + a, q[1] + b), (q[0] + c, q[1] + d), (p[0] + c, p[1] + d)]
                out.append(list(zip(ring, ring[1:] + ring[:1])))
    a, b = path[-1]
    out.append([tuple((solid.vertices[k][0] + a, solid.vertices[k][1] + b) for k in e) for e in solid.edges])
    return out


def along(solid, path):
    return Union(swept(solid, [(F(x), F(y)) for x, y in path]))


def unswept(solid, path, complement, size):
    """The set of points that stay in the solid: what no sweep of its complement in a box of `size` back along the path covers."""
    around, _ = complement(solid, F(size))
    return Union(swept(around, [(F(-x), F(-y)) for x, y in path]), outside=True)
