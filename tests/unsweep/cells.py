"""Solids made of unit cells of the integer grid, so that Boolean operations are set operations.

SPDX-License-Identifier: GPL-3.0-or-later

A solid is a set of cells (integer tuples); the cell c is the box from c to c + 1. It is regular
closed. State of a point: I where every cell around the point belongs to the set, O where none does,
else B.
"""
import itertools
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import Fraction as F  # noqa: E402
from solids import Mesh, Polygon  # noqa: E402


def around(point):
    """The cells whose closed boxes hold the point."""
    choices = [(x - 1, x) if x.denominator == 1 else (math.floor(x),) for x in map(F, point)]
    return {tuple(int(c) for c in cell) for cell in itertools.product(*choices)}


def state(cells, point):
    near = around(point)
    return "I" if near <= cells else "B" if near & cells else "O"


def shifted(cells, by):
    return {tuple(a + b for a, b in zip(c, by)) for c in cells}


def random_cells(rng, d):
    """A blob with holes: most cells of a small box, never none."""
    size = (6, 6) if d == 2 else (4, 4, 3)
    density = rng.choice([0.6, 0.85, 0.95])
    out = {c for c in itertools.product(*map(range, size)) if rng.random() < density}
    return out or {(0,) * d}


def block(low, high):
    return set(itertools.product(*(range(a, b) for a, b in zip(low, high))))


def meet_regularly(a, b):
    """Is the plain intersection of the two closed solids regular closed? Half-integer points stand
    for all faces, edges and vertices."""
    both = a & b
    d = len(next(iter(a)))
    corners = {tuple(x + F(k, 2) for x, k in zip(c, step)) for c in a | b
               for step in itertools.product(range(3), repeat=d)}
    return all(state(both, p) != "O" for p in corners
               if state(a, p) != "O" and state(b, p) != "O")


def sharing(rng, cells, tries):
    """Two solids whose plain intersection is `cells`: other cells are added to one of them where no
    contact comes of it outside of `cells`."""
    pair = [set(cells), set(cells)]
    for _ in range(tries):
        near = rng.choice(sorted(cells))
        cell = tuple(x + rng.randint(-1, 1) for x in near)
        k = rng.randrange(2)
        if cell not in pair[1 - k] and meet_regularly(pair[k] | {cell}, pair[1 - k]):
            pair[k].add(cell)
    return pair


def touch(a, b):
    return any(state(b, tuple(x + k for x, k in zip(c, step))) != "O" for c in a
               for step in itertools.product(range(2), repeat=len(c)))


def solid_of(cells):
    return polygon_of(cells) if len(next(iter(cells))) == 2 else mesh_of(cells)


def mesh_of(cells):
    """One square facet per side that no other cell covers, outward oriented."""
    index, facets = {}, []
    for c in sorted(cells):
        for axis, side in itertools.product(range(3), range(2)):
            beside = tuple(x + (2 * side - 1) * (k == axis) for k, x in enumerate(c))
            if beside in cells:
                continue
            u, v = (axis + 1) % 3, (axis + 2) % 3
            cycle = []
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                p = list(c)
                p[axis], p[u], p[v] = p[axis] + side, p[u] + a, p[v] + b
                cycle.append(index.setdefault(tuple(p), len(index)))
            facets.append(cycle if side else cycle[::-1])
    return Mesh(list(index), facets)


def components(cells):
    """cell -> number of its part, parts being joined through sides."""
    home = {}
    for start in sorted(cells):
        stack = [] if start in home else [start]
        while stack:
            c = stack.pop()
            home[c] = home.get(c, start)
            for axis, step in itertools.product(range(2), (-1, 1)):
                n = tuple(x + step * (k == axis) for k, x in enumerate(c))
                if n in cells and n not in home:
                    home[n] = home[c]
                    stack.append(n)
    return home


def polygon_of(cells):
    """The boundary edges, the solid on their left, joined to rings. Where two cells meet in a
    corner only, a ring goes on along the cell it came along; one that comes back to a vertex of its
    own is cut there, so that rings are simple and touch in vertices."""
    home, edges = components(cells), {}
    for x, y in sorted(cells):
        corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
        beside = [(x, y - 1), (x + 1, y), (x, y + 1), (x - 1, y)]
        for k in range(4):
            if beside[k] not in cells:
                edges[corners[k], corners[(k + 1) % 4]] = (x, y)
    parts = {}
    while edges:
        (start, to), cell = next(iter(edges.items()))
        path = [start]
        while path:
            del edges[path[-1], to]
            if to in path:
                ring = path[path.index(to):]
                parts.setdefault(home[cell], []).append([tuple(map(F, p)) for p in ring])
                path = path[:path.index(to)]
                if not path:
                    break
            path.append(to)
            follow = [(c != cell, end, c) for (a, end), c in edges.items() if a == to]
            _, to, cell = min(follow)
    return Polygon([sorted(rings, key=turning, reverse=True) for rings in parts.values()])


def turning(ring):
    """Twice the signed area: the outer ring of a part has the only positive one."""
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(ring, ring[1:] + ring[:1]))
