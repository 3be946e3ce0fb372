"""The cells of a solid and where a point lies among them, read from OFF or WKT.

SPDX-License-Identifier: GPL-3.0-or-later

Cells are named as in a table of points: `face 3`, `edge 0-4`, `vertex 2`, by the file's numbering.
A facet (in the plane: an edge) has a plane normal . y = offset with an outward normal.
"""
import re

from exact import Fraction as F


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def area(corners):
    """Twice the vector area of a cycle in space: its normal, whether it is convex or not."""
    out = [F(0)] * 3
    for a, b in zip(corners, corners[1:] + corners[:1]):
        for k in range(3):
            i, j = (k + 1) % 3, (k + 2) % 3
            out[k] += a[i] * b[j] - a[j] * b[i]
    return out


def between(y, a, b):
    """Strictly between two points of one line through y?"""
    along = [q - p for p, q in zip(a, b)]
    off = [x - p for p, x in zip(a, y)]
    s = dot(off, along) / dot(along, along)
    return 0 < s < 1 and all(x == s * w for x, w in zip(off, along))


class Facet:
    def __init__(self, cycle, corners, normal, offset):
        self.cycle, self.corners, self.normal, self.offset = cycle, corners, normal, offset

    def sides(self):
        return list(zip(self.corners, self.corners[1:] + self.corners[:1]))

    def holds(self, y):
        """Is y in the facet's relative interior?"""
        if dot(self.normal, y) != self.offset:
            return False
        if len(y) == 2:
            return between(y, *self.corners)
        if any(y == a or between(y, a, b) for a, b in self.sides()):
            return False
        i, j = [k for k in range(3) if k != next(m for m in range(3) if self.normal[m])]
        odd = False
        for a, b in self.sides():
            if (a[j] > y[j]) != (b[j] > y[j]):
                odd ^= a[i] + (b[i] - a[i]) * (y[j] - a[j]) / (b[j] - a[j]) > y[i]
        return odd


class Solid:
    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            text = re.sub(r"#[^\n]*", "", file.read())
        self.vertices, self.facets = [], []
        (self.read_off if path.endswith(".off") else self.read_wkt)(text)
        self.dimension = len(self.vertices[0])

    def read_off(self, text):
        lines = [line.split() for line in text.splitlines() if line.strip()]
        lines = lines[1:] if lines[0] == ["OFF"] else lines
        count, facets = int(lines[0][0]), int(lines[0][1])
        self.vertices = [tuple(map(F, line[:3])) for line in lines[1:1 + count]]
        for line in lines[1 + count:1 + count + facets]:
            cycle = [int(k) for k in line[1:1 + int(line[0])]]
            corners = [self.vertices[k] for k in cycle]
            normal = area(corners)
            self.facets.append(Facet(cycle, corners, normal, dot(normal, corners[0])))

    def read_wkt(self, text):
        for ring in re.findall(r"\(([^()]+)\)", text):
            corners = [tuple(map(F, c.split())) for c in ring.split(",")][:-1]
            base, n = len(self.vertices), len(corners)
            self.vertices += corners
            for k in range(n):
                a, b = corners[k], corners[(k + 1) % n]
                normal = [b[1] - a[1], a[0] - b[0]]
                self.facets.append(Facet([base + k, base + (k + 1) % n], [a, b], normal,
                                         dot(normal, a)))
        for f in self.facets:
            if self.covered(f):
                f.normal, f.offset = [-x for x in f.normal], -f.offset

    def covered(self, facet):
        """Does the solid lie on the normal's side of an edge? A ray along the normal from a point
        of the edge, which misses all vertices, then crosses an odd number of other edges."""
        a, b = facet.corners
        n = facet.normal
        for k in range(1, 200):
            at = [p + F(k, 200) * (q - p) for p, q in zip(a, b)]
            level = n[1] * at[0] - n[0] * at[1]
            side = [n[1] * v[0] - n[0] * v[1] - level for v in self.vertices]
            if all(side):
                break
        odd = False
        for f in self.facets:
            u, v = f.cycle
            if f is facet or (side[u] > 0) == (side[v] > 0):
                continue
            s = side[u] / (side[u] - side[v])
            hit = [p + s * (q - p) for p, q in zip(self.vertices[u], self.vertices[v])]
            odd ^= dot(n, hit) > facet.offset
        return odd

    def holds(self, cell, y):
        """Does the cell's relative interior hold y?"""
        kind, name = cell.split()
        if kind == "vertex":
            return self.vertices[int(name)] == tuple(y)
        if kind == "face":
            return self.facets[int(name)].holds(tuple(y))
        return between(tuple(y), *(self.vertices[int(k)] for k in name.split("-")))

    def facets_at(self, cell):
        """The facets that have the cell, cells of equal position being one."""
        kind, name = cell.split()
        if kind == "face":
            return [self.facets[int(name)]]
        spots = {self.vertices[int(k)] for k in name.split("-")}
        if kind == "vertex":
            return [f for f in self.facets if spots <= set(f.corners)]
        return [f for f in self.facets if any({a, b} == spots for a, b in f.sides())]
