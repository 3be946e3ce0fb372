"""A second refinement, by sets of cells, and convex sets whose every answer is known.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import itertools
import math

from exact import Fraction as F


class Convex:
    """A convex polygon, counter-clockwise, or by `planes` a box: the points with all values <= 0."""

    def __init__(self, corners):
        self.corners = [tuple(map(F, c)) for c in corners]
        self.planes = []
        pairs = list(zip(self.corners, self.corners[1:] + self.corners[:1]))
        for (ax, ay), (bx, by) in pairs:
            normal = (by - ay, ax - bx)
            self.planes.append((normal, normal[0] * ax + normal[1] * ay))
        self.volume = sum(a[0] * b[1] - a[1] * b[0] for a, b in pairs) / 2
        self.area = F(sum(math.dist(a, b) for a, b in pairs))

    def pmc(self, point):
        """The set is the open sweep with its boundary: on is where some value is 0, none over."""
        most = max(sum(n * x for n, x in zip(normal, point)) - offset
                   for normal, offset in self.planes)
        return "in" if most < 0 else "on" if most == 0 else "out"

    def distance_squared(self, point):
        """Squared distance from the boundary: the nearest point of all edges."""
        return min(segment_distance(point, a, b)
                   for a, b in zip(self.corners, self.corners[1:] + self.corners[:1]))


def segment_distance(p, a, b):
    along = [y - x for x, y in zip(a, b)]
    s = sum((x - o) * w for x, o, w in zip(p, a, along)) / sum(w * w for w in along)
    s = min(max(s, F(0)), F(1))
    return sum((x - o - s * w)**2 for x, o, w in zip(p, a, along))


class Box(Convex):
    def __init__(self, low, high):
        self.low, self.high = [F(x) for x in low], [F(x) for x in high]
        d = len(low)
        self.planes = []
        for k in range(d):
            unit = [F(i == k) for i in range(d)]
            self.planes += [(unit, self.high[k]), ([-u for u in unit], -self.low[k])]
        sides = [b - a for a, b in zip(self.low, self.high)]
        self.volume = F(1)
        for s in sides:
            self.volume *= s
        self.area = 2 * sum(self.volume / s for s in sides)

    def distance_squared(self, point):
        """Inside: to the nearest side; outside: to the nearest point of the box."""
        if self.pmc(point) != "out":
            return min(min(x - a, b - x) for x, a, b in zip(point, self.low, self.high))**2
        return sum(max(a - x, x - b, F(0))**2 for x, a, b in zip(point, self.low, self.high))


def box_set(low, high):
    return Box(low, high)


class Refinement:
    """Cells as (level, place); a cell is a leaf if it is in `cells` and not in `cut`."""

    def __init__(self, truth, low, high, depth):
        self.truth, self.low, self.high, self.depth = truth, low, high, depth
        self.d = len(low)
        self.asked = {}
        self.cut, self.cells = set(), {(0, (0,) * self.d)}

    def pmc(self, level, place):
        """The answer at a place counted in cells of a level."""
        point = tuple(a + (b - a) * F(k) / 2**level for a, b, k in zip(self.low, self.high, place))
        if point not in self.asked:
            self.asked[point] = self.truth.pmc(point)
        return self.asked[point]

    def corners(self, cell):
        level, place = cell
        return {bits: self.pmc(level, [p + b for p, b in zip(place, bits)])
                for bits in itertools.product((0, 1), repeat=self.d)}

    def split(self, cell):
        level, place = cell
        self.cut.add(cell)
        new = [(level + 1, tuple(2 * p + b for p, b in zip(place, bits)))
               for bits in itertools.product((0, 1), repeat=self.d)]
        self.cells.update(new)
        for child in new:
            self.corners(child)
        return new

    def differs(self, cell):
        answers = set(self.corners(cell).values())
        if len(answers) == 1:
            answers.add(self.pmc(cell[0], [p + F(1, 2) for p in cell[1]]))
        return len(answers) > 1

    def neighbours(self, cell):
        """The neighbouring cells across sides whose corners are partly out."""
        level, place = cell
        corners = self.corners(cell)
        for axis in range(self.d):
            for upper in (0, 1):
                side = {pmc == "out" for bits, pmc in corners.items() if bits[axis] == upper}
                to = place[axis] + (1 if upper else -1)
                if len(side) == 2 and 0 <= to < 2**level:
                    yield level, place[:axis] + (to,) + place[axis + 1:]

    def above(self, cell):
        """The leaf that holds the place of a cell."""
        level, place = cell
        while (level, place) not in self.cells:
            level, place = level - 1, tuple(p // 2 for p in place)
        return level, place


def cells_of(truth, low, high, coarse, depth):
    """({lowest corner: level} of the leaves, the points asked for)."""
    r = Refinement(truth, low, high, depth)
    r.corners((0, (0,) * r.d))
    new = set(r.cells)
    for target in range(1, depth + 1):
        while new:
            cell = new.pop()
            if cell in r.cut:
                continue
            if cell[0] < target and (cell[0] < coarse or r.differs(cell)):
                new.update(r.split(cell))
            elif cell[0] == target >= coarse:
                for other in r.neighbours(cell):
                    while other not in r.cells:
                        new.update(r.split(r.above(other)))
        new = {c for c in r.cells - r.cut if c[0] == target}
    leaves = {tuple(a + (b - a) * F(k) / 2**level for a, b, k in zip(low, high, place)): level
              for level, place in r.cells - r.cut}
    return leaves, set(r.asked)
