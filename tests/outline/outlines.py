"""Runs of `graze outline`, and what its JSON says: numbers, curves of arcs, areas, winding numbers.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import ast
import json
import math
import os
import sys
from decimal import Decimal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from closed import number  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from program import Checks, Graze, options  # noqa: E402,F401  (suites take them from here)
from slices import at, crossing, floats, local, minus, slope, times, zeros  # noqa: E402
from times import time_root  # noqa: E402


# ------------------------------------------------------------------------------------ rational functions

class Ratio:
    """p / q, polynomials of Fractions, lowest power first."""

    def __init__(self, p, q=(F(1),)):
        self.p, self.q = list(p), list(q)

    def __add__(self, other):
        return Ratio(minus(times(self.p, other.q), [-c for c in times(other.p, self.q)]), times(self.q, other.q))

    def __neg__(self):
        return Ratio([-c for c in self.p], self.q)

    def __sub__(self, other):
        return self + -other

    def __mul__(self, other):
        return Ratio(times(self.p, other.p), times(self.q, other.q))

    def __truediv__(self, other):
        return Ratio(times(self.p, other.q), times(self.q, other.p))

    def __pow__(self, n):
        out = Ratio([F(1)])
        for _ in range(n):
            out = out * self
        return out


OPERATIONS = {ast.Add: Ratio.__add__, ast.Sub: Ratio.__sub__, ast.Mult: Ratio.__mul__, ast.Div: Ratio.__truediv__}


def ratio(text, parameter):
    """An expression of formats.md in one parameter."""
    def of(node):
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
            return of(node.left) ** node.right.value
        if isinstance(node, ast.BinOp):
            return OPERATIONS[type(node.op)](of(node.left), of(node.right))
        if isinstance(node, ast.UnaryOp):
            return -of(node.operand)
        if isinstance(node, ast.Name) and node.id == parameter:
            return Ratio([F(0), F(1)])
        if isinstance(node, ast.Constant) and isinstance(node.value, int):
            return Ratio([F(node.value)] if node.value else [])
        raise ValueError(f"{text}: {ast.dump(node)}")
    return of(ast.parse(text.replace("^", "**"), mode="eval").body)


def near(num):
    """A NUM or TIME as a Fraction that is it, or at most 2^-80 away."""
    root = time_root(num)
    root.narrow(F(1, 2 ** 80))
    low, high = root.bounds()
    return (low + high) / 2


# ------------------------------------------------------------------------------------------------ arcs

class Curve:
    """An arc in doubles, on [0, 1]; `y` is monotone between neighbours of `marks`."""

    def __init__(self, arc, ends):
        self.ends = ends
        if arc["curve"] is None or arc["sources"][0]["from"] is None:  # a flat: straight
            self.x, self.y = ([b - a, a] for a, b in zip(*ends))
            self.w, self.marks = [1.0], [0.0, 1.0]
            return
        source = arc["sources"][0]
        low, high = near(source["from"]), near(source["to"])
        x, y = (ratio(arc["curve"][name], arc["curve"]["parameter"]) for name in "xy")
        if x.q != y.q:
            x, y = Ratio(times(x.p, y.q), times(x.q, y.q)), Ratio(times(y.p, x.q), times(x.q, y.q))
        x, y, w = (local(p, low, high) for p in (x.p, y.p, x.q))
        rising = minus(times(slope(y), w), times(y, slope(w)))
        self.x, self.y, self.w = floats(x), floats(y), floats(w)
        self.marks = [0.0, *zeros(rising), 1.0]
        # arcs run from `from` to `to`, parameters may run against them
        start = self.at(0.0)
        if math.dist(start, ends[0]) > math.dist(start, ends[1]) or ends[0] == ends[1] and self.backward(arc):
            self.x, self.y, self.w = (floats(local(p, F(1), F(0))) for p in (x, y, w))
            self.marks = [1 - s for s in reversed(self.marks)]

    def backward(self, arc):
        """Does a loop run against its parameter? The set is on the left of it, so where the sample's segment crosses it."""
        (a, b), (c, d) = ([to_double(F(x)) for x in arc["sample"][side]] for side in ("out", "in"))
        spot = min((k / 1024 for k in range(1, 1024)), key=lambda s: math.dist(self.at(s), ((a + c) / 2, (b + d) / 2)))
        (x, y), (u, v) = self.at(spot - 1 / 4096), self.at(spot + 1 / 4096)
        return (u - x) * (d - b) - (v - y) * (c - a) < 0

    def at(self, s):
        w = at(self.w, s)
        return at(self.x, s) / w, at(self.y, s) / w

    def crossings(self, y):
        """[(x, 1 or -1)]: where the arc crosses the line at y upwards or downwards."""
        heights = [self.ends[0][1], *(self.at(s)[1] for s in self.marks[1:-1]), self.ends[1][1]]
        for a, b, low, high in zip(self.marks, self.marks[1:], heights, heights[1:]):
            if (low <= y) != (high <= y):
                yield self.at(crossing(self.y, [-c for c in self.w], y, a, b) if len(self.w) == len(self.y) else self.solve(y, a, b))[0], \
                    1 if low <= y else -1

    def solve(self, y, a, b):
        for _ in range(80):
            middle = (a + b) / 2
            if (self.at(middle)[1] > y) == (self.at(b)[1] > y):
                b = middle
            else:
                a = middle
        return (a + b) / 2

    def length(self, parts=64):
        """By chords, extrapolated: good to about 1e-9 where there is no cusp."""
        def chords(n):
            points = [self.at(k / n) for k in range(n + 1)]
            return sum(math.dist(p, q) for p, q in zip(points, points[1:]))
        one, two, four = chords(parts), chords(2 * parts), chords(4 * parts)
        first, second = (4 * two - one) / 3, (4 * four - two) / 3
        return (16 * second - first) / 15


class Outline:
    """The answer to one scene; `where` names it in messages."""

    def __init__(self, record):
        self.record = record
        self.places = [tuple(v["near"]) for v in record["vertices"]]
        self.curves = [Curve(a, (self.places[a["from"]], self.places[a["to"]])) for a in record["arcs"]]

    def __getattr__(self, name):
        return self.record[name]

    def numbers(self):
        return [self.record[name] for name in ("components", "interior_components", "holes", "euler")]

    def area(self):
        return enclosure(self.record["area"])

    def length(self):
        return enclosure(self.record["length"])

    def lower_length(self):
        return sum(Curve(a, (tuple(a["from"]["near"]), tuple(a["to"]["near"]))).length() for a in self.record["lower"]["arcs"])

    def row(self, y):
        """Sorted (x, step) of the row at y: to the right of an x the winding number is less by its step."""
        return sorted(c for curve in self.curves for c in curve.crossings(y))


def places(source, solid, motion, unsweep):
    """Where a source says that its arc ends, as pairs of doubles; of an envelope two segments that hold these ends."""
    def image(t, point):
        t = min(max(t, motion.start), motion.end)
        p = motion.back(point, t) if unsweep else motion.map(point, t)
        return tuple(map(to_double, p))
    if source["from"] is None:
        return [tuple(image(near(source["at"]), solid.vertices[k]) for k in source["edge"])] * 2
    first, last = near(source["from"]), near(source["to"])
    if source["kind"] == "path":
        return [image(t, solid.vertices[source["vertex"]]) for t in (first, last)]
    u, v = (solid.vertices[k] for k in source["edge"])
    if source["kind"] == "edge":
        return [image(near(source["at"]), tuple(a + s * (b - a) for a, b in zip(u, v))) for s in (first, last)]
    return [(image(t, u), image(t, v)) for t in (first, last)]


def off(place, end):
    """The distance of an end of an arc from a place, a point or a segment."""
    if not isinstance(place[0], tuple):
        return math.dist(place, end)
    (a, b), (c, d) = place
    square = (c - a) ** 2 + (d - b) ** 2
    s = min(max(((end[0] - a) * (c - a) + (end[1] - b) * (d - b)) / square, 0), 1)
    return math.dist((a + s * (c - a), b + s * (d - b)), end)


def enclosure(value):
    """(low, high): Fractions, equal, where the value is exact, else Decimals of the doubles, which are bounds themselves."""
    if "exact" in value:
        return F(value["exact"]), F(value["exact"])
    return Decimal(value["low"]), Decimal(value["high"])


def middle(value):
    low, high = value
    return (to_double(low) if low == high else float(low) / 2 + float(high) / 2)


def within(expected, value, relative):
    """Is a number in an enclosure, which is equal to it or of at most the relative width?"""
    low, high = value
    if low == high and not isinstance(low, Decimal):
        return low == expected
    x = number(expected)
    return low <= x <= high and high - low <= Decimal(relative) * max(abs(x), Decimal("1e-300"))


class Program(Graze):
    """The program under test."""

    def outline(self, name, solid, motion, *flags, unsweep=False):
        """An Outline, or None after a failed check."""
        tag = name.replace(" ", "_").replace("/", "_")
        solid = self.write(tag + solid.suffix, solid.text())
        motion = self.write(tag + ".json", motion if isinstance(motion, str) else motion.text())
        if unsweep:
            flags = ("--operation", "unsweep", *flags)
        out = self.call("outline", solid, motion, "--format", "json", *flags)
        if out.returncode:
            self.checks.fail(name, *flags, f"exit {out.returncode}: {out.stderr.strip()[:300]}")
            return None
        return Outline(json.loads(out.stdout))

    def pmc(self, name, solid, motion, points, unsweep=False):
        """The word pmc of each point, or None after a failed check."""
        tag = name.replace(" ", "_").replace("/", "_")
        solid = self.write(tag + solid.suffix, solid.text())
        motion = self.write(tag + ".json", motion.text())
        csv = self.write(tag + ".csv", "".join(f"{x},{y}\n" for x, y in points))
        out = self.call("classify", solid, motion, csv, "--columns", "pmc", *(("--operation", "unsweep") if unsweep else ()))
        rows = [line.split(",")[2] for line in out.stdout.splitlines() if not line.startswith("#")][1:]
        if out.returncode or len(rows) != len(points):
            self.checks.fail(name, f"classify: exit {out.returncode}, {len(rows)} rows: {out.stderr.strip()[:300]}")
            return None
        return rows
