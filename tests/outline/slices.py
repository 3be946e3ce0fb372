"""A second method for planar sweeps and unsweeps: area and topology from slices along parallel lines, in doubles.

SPDX-License-Identifier: GPL-3.0-or-later

The scene is turned by an angle that no scene has. On the line at x the moving solid is at each time a few intervals; over
times between which the same edges meet the line, each of them covers one interval, whose ends are extrema of an edge's
height over these times. Their union is the slice of the sweep, with a label for each end: the event that it comes from.
Between two lines where labels change the slice is analytic, so Gauss's rule finds the area; lines of change are found by
bisection, and cells of neighbouring slabs that overlap are joined. No curve is intersected with another one, and nothing
of the program's candidates, equations or cuts is used.
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from algebra import add, common, integral, mul, scale  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from motion import Motion, Piece, adjugate  # noqa: E402

TURN = (171, 140, 221)  # cosine, sine and radius of 2 atan(5/14), about 39 degrees
INFINITE = float("inf")
TINY = 1e-12         # of the scene's width: where a line of change lies
CLOSE = 1e-12        # of the width: ends of intervals that are one
THIN = 1e-9          # of the width: slabs that rounding has made
EXACT = 1e-9         # of the width squared: the area of a slab
DEEP = 12            # halvings of a slab
WIDE = 1e-4          # of the width: cells that overlap by more are joined
NODES = ((0.1252334085114689, 0.2491470458134028), (0.3678314989981802, 0.2334925365383548), (0.5873179542866175, 0.2031674267230659),
         (0.7699026741943047, 0.1600783285433462), (0.9041172563704749, 0.1069393259953184), (0.9815606342467192, 0.0471753363865118))


def turned(motion, cosine, sine, whole):
    """The motion followed by a rotation; the three numbers are integers."""
    rows = [(cosine, -sine), (sine, cosine)]

    def mix(row, column):
        return add(scale(column[0], row[0]), scale(column[1], row[1]))
    return Motion([Piece(p.lo, p.hi, [[mix(row, [p.a[0][j], p.a[1][j]]) for j in (0, 1)] for row in rows],
                         [mix(row, p.b) for row in rows], scale(p.w, whole)) for p in motion.pieces], {})


def inverse(motion):
    """The inverse maps as a motion."""
    pieces = []
    for p in motion.pieces:
        adj, det = adjugate(p.a)
        shift = [scale(add(mul(adj[i][0], p.b[0]), mul(adj[i][1], p.b[1])), -1) for i in (0, 1)]
        pieces.append(Piece(p.lo, p.hi, [[mul(p.w, adj[i][j]) for j in (0, 1)] for i in (0, 1)], shift, det))
    return Motion(pieces, {})


# ------------------------------------------------------------------------------- polynomials in doubles

def local(p, lo, hi):
    """An integer polynomial in t as one in s, t = lo + s (hi − lo), with Fractions."""
    out = []
    for c in reversed(p):
        shifted = [F(0)] + [x * (hi - lo) for x in out]
        for k, x in enumerate(out):
            shifted[k] += x * lo
        shifted[0] += c
        out = shifted
    while out and out[-1] == 0:
        out.pop()
    return out


def times(p, q):
    out = [F(0)] * (len(p) + len(q) - 1) if p and q else []
    for i, x in enumerate(p):
        for j, y in enumerate(q):
            out[i + j] += x * y
    return out


def minus(p, q):
    out = [(p[k] if k < len(p) else F(0)) - (q[k] if k < len(q) else F(0)) for k in range(max(len(p), len(q)))]
    while out and out[-1] == 0:
        out.pop()
    return out


def slope(p):
    return [k * c for k, c in enumerate(p)][1:]


def floats(p):
    """Highest power first, for `at`."""
    return [to_double(c) for c in reversed(p)]


def at(p, s):
    total = 0.0
    for c in p:
        total = total * s + c
    return total


def zeros(p):
    """Real roots in the open interval (0, 1) where a polynomial of Fractions changes its sign, between those of its derivative."""
    if len(p) < 2:
        return []
    marks, f = [0.0, *zeros(slope(p)), 1.0], floats(p)
    return [crossing(f, None, 0.0, a, b) for a, b in zip(marks, marks[1:]) if at(f, a) * at(f, b) < 0]


def crossing(p, q, x, a, b):
    """A root of p + x q in [a, b], where it changes its sign, by regula falsi with halving."""
    def value(s):
        return at(p, s) + x * at(q, s) if q else at(p, s)
    fa, fb, side = value(a), value(b), 0
    for _ in range(200):
        if abs(b - a) < 1e-15 or fa == fb:
            break
        s = (a * fb - b * fa) / (fb - fa)
        if not a < s < b:
            s = (a + b) / 2
        fs = value(s)
        if fs == 0:
            return s
        if (fs > 0) == (fb > 0):
            if b - s < 1e-16:
                return s
            b, fb = s, fs
            fa = fa / 2 if side == 1 else fa
            side = 1
        else:
            if s - a < 1e-16:
                return s
            a, fa = s, fs
            fb = fb / 2 if side == -1 else fb
            side = -1
    return (a + b) / 2


class Branch:
    """Times s at which p(s) + x q(s) = 0: one for each x in (low, high), as −p/q is monotone on (a, b)."""

    def __init__(self, p, q, a, b):
        self.p, self.q, self.a, self.b = p, q, a, b
        ends = [self.x_at(a, b), self.x_at(b, a)]
        self.low, self.high = min(ends), max(ends)

    def x_at(self, s, inner):
        q = at(self.q, s)
        if abs(q) > 1e-12 * max(map(abs, self.q)):
            return -at(self.p, s) / q
        s += 1e-7 * (inner - s)
        return math.copysign(INFINITE, -at(self.p, s) * at(self.q, s))

    def time(self, x):
        return crossing(self.p, self.q, x, self.a, self.b)


def divided(p, g):
    """p / g, which divides it."""
    p, out = list(p), []
    for shift in range(len(p) - len(g), -1, -1):
        out.append(p[shift + len(g) - 1] / g[-1])
        for k, c in enumerate(g):
            p[k + shift] -= out[-1] * c
    return out[::-1]


def branches(p, q):
    """The branches of −p/q, polynomials with Fractions; none where it is constant."""
    speed = minus(times(slope(p), q), times(p, slope(q)))
    if not speed:
        return []
    marks = sorted({0.0, 1.0, *zeros(speed), *zeros(q)})
    return [Branch(floats(p), floats(q), a, b) for a, b in zip(marks, marks[1:]) if b - a > 1e-12]


class Run:
    """One piece of motion: vertices' paths, and for each edge the times at which its height over a line is least or greatest."""

    def __init__(self, number, piece, solid):
        def part(p):
            return local(p, piece.lo, piece.hi)
        w = part(piece.w)
        paths = []
        for v in solid.vertices:
            # integer coordinates first: add() and scale() are of integers
            den = v[0].denominator * v[1].denominator
            ints = [int(c * den) for c in v]
            paths.append(tuple([c / den for c in part(add(add(scale(piece.a[i][0], ints[0]), scale(piece.a[i][1], ints[1])),
                                                              scale(piece.b[i], den)))] for i in (0, 1)))
        self.number, self.edges = number, solid.edges
        self.w = floats(w)
        self.paths = [(floats(x), floats(y)) for x, y in paths]
        self.corners = [(v, k, b) for v, (x, _) in enumerate(paths) for k, b in enumerate(branches(x, minus([], w)))]
        self.turning = [self.extrema(e, *paths[e[0]], *paths[e[1]], w) for e in solid.edges]

    @staticmethod
    def extrema(_, x0, y0, x1, y1, w):
        """(times for every x, branches). The height is (c + x w dy) / (w dx)."""
        dx, dy = minus(x1, x0), minus(y1, y0)
        c, e = minus(times(y0, dx), times(x0, dy)), times(w, dx)
        p = minus(times(slope(c), e), times(c, slope(e)))
        q = times(times(w, w), minus(times(slope(dy), dx), times(dy, slope(dx))))
        if not p or not q:
            return zeros(p or q), []
        rests = common(integral(p), integral(q))  # at its roots the body stands still for an instant
        return zeros([F(c) for c in rests]), branches(divided(p, rests), divided(q, rests))

    def height(self, edge, s, x):
        (x0, y0), (x1, y1) = self.paths[edge[0]], self.paths[edge[1]]
        w = at(self.w, s)
        a, b = at(x0, s), at(x1, s)
        u, v = at(y0, s), at(y1, s)
        return (u + (x * w - a) * (v - u) / (b - a)) / w if a != b else u / w

    def intervals(self, x, outside):
        """[(low, label, high, label)] that the solid, or what is outside of it, covers on the line at x in this piece."""
        events = sorted((b.time(x), ("vertex", self.number, v, k)) for v, k, b in self.corners if b.low < x < b.high)
        events = [(0.0, ("begin", self.number)), *events, (1.0, ("end", self.number))]
        stops = [[(s, ("flat", self.number, e, k)) for k, s in enumerate(fixed)]
                 + [(b.time(x), ("envelope", self.number, e, k)) for k, b in enumerate(moving) if b.low < x < b.high]
                 for e, (fixed, moving) in enumerate(self.turning)]
        out = []
        for first, last in zip(events, events[1:]):
            if last[0] - first[0] < 1e-14:
                continue
            middle = (first[0] + last[0]) / 2
            far = x * at(self.w, middle)
            right = [at(path[0], middle) > far for path in self.paths]
            met = sorted((self.height(e, middle, x), k) for k, e in enumerate(self.edges) if right[e[0]] != right[e[1]])
            met = [k for _, k in met]
            if outside:
                met = [None, *met, None]
            for lower, upper in zip(met[0::2], met[1::2]):
                out.append((*self.extreme(lower, first, last, stops, x, min), *self.extreme(upper, first, last, stops, x, max)))
        return out

    def extreme(self, k, first, last, stops, x, least):
        if k is None:
            return (-INFINITE if least is min else INFINITE), ()
        spots = [first, last] + [stop for stop in stops[k] if first[0] < stop[0] < last[0]]
        found = [(self.height(self.edges[k], s, x), (*label, k) if label[0] in ("begin", "end") else label) for s, label in spots]
        best = least(found)[0]
        return best, least(label for y, label in found if abs(y - best) < self.near)


# -------------------------------------------------------------------------------------------- slices

class Cells:
    """Numbers of cells of slabs, joined into components."""

    def __init__(self):
        self.parent = {}

    def root(self, x):
        self.parent.setdefault(x, x)
        while self.parent[x] != x:
            x = self.parent[x]
        return x

    def join(self, x, y):
        self.parent[self.root(x)] = self.root(y)

    def count(self):
        return len({self.root(x) for x in self.parent})


class Slices:
    """A sweep, or a regularised unsweep: `area`, `components` of the closed set, `interior_components`, `holes`."""

    def __init__(self, solid, motion, unsweep=False, spots=7):
        """`spots`: lines of each stretch between extrema of paths at which signatures are compared; parts between two are missed."""
        self.outside, self.spots = unsweep, spots
        maps = turned(inverse(motion) if unsweep else motion, *TURN)
        self.runs = [Run(k, p, solid) for k, p in enumerate(maps.pieces)]
        ends = [b for r in self.runs for _, _, b in r.corners]
        rest = [at(x, 0.0) / at(r.w, 0.0) for r in self.runs for x, _ in r.paths]
        self.low = min([b.low for b in ends] + rest)
        self.high = max([b.high for b in ends] + rest)
        self.width = self.high - self.low
        for r in self.runs:
            r.near = CLOSE * self.width
        self.slabs = self.cut()
        self.area = sum(self.integral(a, b, self.gauss(a, b)) for a, b in self.slabs)
        self.topology()

    def at(self, x):
        """The slice of the set as [(low, label, high, label)], in order."""
        return self.cover(x)[0]

    def cover(self, x):
        """The slice, and where two intervals only touch: points of seams, or of the dangling part of an unsweep."""
        covered = sorted(i for r in self.runs for i in r.intervals(x, self.outside))
        out, touches, near = [], [], CLOSE * self.width
        for low, a, high, b in covered:
            if not out or low > out[-1][2] + near:
                out.append([low, a, high, b])
                continue
            if abs(low - out[-1][2]) <= near < high - low and out[-1][2] - out[-1][0] > near:
                touches.append(low)
            elif touches and touches[-1] > low + near:
                touches.pop()
            if low <= out[-1][0] + near and a < out[-1][1]:
                out[-1][1] = a
            if high > out[-1][2] + near or high > out[-1][2] - near and b < out[-1][3]:
                out[-1][2:] = high, b
        if self.outside:
            out = [[p[2], p[3], q[0], q[1]] for p, q in zip(out, out[1:])]
        return out, touches

    def signature(self, x):
        cells, touches = self.cover(x)
        return [(i[1], i[3]) for i in cells], len(touches)

    def cut(self):
        """(a, b) of slabs with one signature each."""
        marks = {b.low for r in self.runs for _, _, b in r.corners} | {b.high for r in self.runs for _, _, b in r.corners}
        marks |= {x for r in self.runs for _, moving in r.turning for b in moving for x in (b.low, b.high) if self.low < x < self.high}
        marks = sorted({self.low, self.high, *marks})
        step, out = TINY * self.width, []
        for a, b in zip(marks, marks[1:]):
            if b - a < 8 * step:
                continue
            spots = [a + step + (b - a - 2 * step) * k / (self.spots - 1) for k in range(self.spots)]
            signs = [self.signature(x) for x in spots]
            begin = a
            for (x, p), (y, q) in zip(zip(spots, signs), zip(spots[1:], signs[1:])):
                for change in self.changes(x, p, y, q, step):
                    out.append((begin, change))
                    begin = change
            out.append((begin, b))
        return [(a, b) for a, b in out if b - a > 4 * step]

    def changes(self, x, p, y, q, step, most=12):
        """Lines of change between x and y with the signatures p and q."""
        if p == q or most == 0:
            return
        a, b, r = x, y, q
        while b - a > step:
            middle = (a + b) / 2
            s = self.signature(middle)
            if s == p:
                a = middle
            else:
                b, r = middle, s
        yield (a + b) / 2
        yield from self.changes(b, r, y, q, step, most - 1)

    def integral(self, a, b, whole, depth=0):
        """The integral of the measure of the slice; halves show whether the rule is good enough, and what no signature has shown."""
        middle = (a + b) / 2
        left, right = self.gauss(a, middle), self.gauss(middle, b)
        if abs(left + right - whole) < EXACT * self.width ** 2 or depth == DEEP:
            return left + right
        return self.integral(a, middle, left, depth + 1) + self.integral(middle, b, right, depth + 1)

    def gauss(self, a, b):
        """x = middle + half (3 u − u³) / 2 makes roots at the ends smooth."""
        middle, half, total = (a + b) / 2, (b - a) / 2, 0.0
        for node, weight in NODES:
            for u in (-node, node):
                measure = sum(high - low for low, _, high, _ in self.at(middle + half * (3 * u - u ** 3) / 2))
                total += weight * measure * half * 1.5 * (1 - u * u)
        return total

    def lengths(self, step=1e-7):
        """Lengths of the boundary and of the lower part, to about 1e-5: in a slab both are graphs, whose slopes are differences."""
        def heights(x):
            cells, touches = self.cover(x)
            return [y for cell in cells for y in (cell[0], cell[2])], touches
        total = [0.0, 0.0]
        for a, b in self.slabs:
            middle, half = (a + b) / 2, (b - a) / 2
            for node, weight in NODES:
                for u in (-node, node):
                    x = middle + half * (3 * u - u ** 3) / 2
                    h = min(step * self.width, (x - a) / 4, (b - x) / 4)
                    for k, (p, q) in enumerate(zip(heights(x - h), heights(x + h))):
                        if len(p) == len(q):
                            total[k] += sum(math.hypot(1, (d - c) / (2 * h)) for c, d in zip(p, q)) * weight * half * 1.5 * (1 - u * u)
        return total

    def topology(self):
        """Cells of neighbouring slabs are one where they overlap, or where they have an end of one label; of gaps likewise."""
        closed, inner, free = Cells(), Cells(), Cells()
        free.root("all")
        slabs = [slab for slab in self.slabs if slab[1] - slab[0] > THIN * self.width]
        sides = [[]] + [self.side(*ends) for a, b in slabs for ends in ((a, b), (b, a))] + [[]]
        for k, (left, right) in enumerate(zip(sides[0::2], sides[1::2])):
            for m, p in enumerate(left):
                for n, q in enumerate(right):
                    overlap = self.overlap(p, q)
                    if overlap > -WIDE:
                        closed.join((k, m), (k + 1, n))
                    if self.one(p, q, overlap):
                        inner.join((k, m), (k + 1, n))
            for n in range(len(right)):
                closed.root((k + 1, n)), inner.root((k + 1, n))
            gaps = [self.gaps(left), self.gaps(right)]
            for m, p in enumerate(gaps[0]):
                for n, q in enumerate(gaps[1]):
                    if self.one(p, q, self.overlap(p, q)):
                        free.join(self.gap(k, m, p), self.gap(k + 1, n, q))
            for n, q in enumerate(gaps[1]):
                free.root(self.gap(k + 1, n, q))
        self.components, self.interior_components, self.holes = closed.count(), inner.count(), free.count() - 1

    def side(self, a, b):
        """The slice of a slab next to its end a, at which none of its cells has closed yet."""
        count, step = len(self.at((a + b) / 2)), TINY * self.width
        while 4 * step < abs(b - a):
            cells = self.at(a + math.copysign(step, b - a))
            if len(cells) == count:
                return cells
            step *= 8
        return self.at((a + b) / 2)

    def overlap(self, p, q):
        return (min(p[2], q[2]) - max(p[0], q[0])) / self.width

    @staticmethod
    def one(p, q, overlap):
        return overlap > WIDE or overlap > 0 and (p[1] == q[1] != () or p[3] == q[3] != ())

    @staticmethod
    def gap(slab, number, cell):
        return "all" if INFINITE in (-cell[0], cell[2]) else (slab, number)

    @staticmethod
    def gaps(cells):
        """The stretches between the cells of a slice, in the same form."""
        ends = [(-INFINITE, ()), *((x, label) for cell in cells for x, label in (cell[:2], cell[2:])), (INFINITE, ())]
        return [(*p, *q) for p, q in zip(ends[0::2], ends[1::2])]
