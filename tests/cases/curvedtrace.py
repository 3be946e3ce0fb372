"""The word of one trajectory through a curved solid, for recompute.py: exact polynomials in t, and points beside it.

SPDX-License-Identifier: GPL-3.0-or-later

A time at which something can change is a root of a polynomial of the solid along the trajectory. Between them the
expression is evaluated at a rational point. On a surface, and at a root between equal states, lines are laid through rational
points nearby: along each the surfaces that vanish are crossed where Newton's method says, and the expression is
evaluated between the crossings. Two truths so near together are a boundary; where no point shows the other truth there is
none (which is no proof, and needs none: words are derived by hand). Along a slide on two surfaces a change at no root is
bracketed by bisection.
"""
import itertools

from exact import Fraction as F
from algebra import add, between, integral, mul, power, roots, scale, sort_roots
from algebra import Root

NEAR = F(1, 2 ** 36)
NARROW = F(1, 2 ** 260)
GRID = 2 ** 320
STEPS, HALVINGS = 7, 12


def truth(tree, negative):
    """The value of the tree where polynomial k is negative iff negative[k]."""
    if isinstance(tree, int):
        return negative[tree]
    how, parts = tree
    values = (truth(part, negative) for part in parts)
    return all(values) if how == "all" else any(values) if how == "any" else not next(values)


def value(f, x):
    out = F(0)
    for powers, c in f.items():
        for e, y in zip(powers, x):
            c = c * y ** e
        out += c
    return out


def gradient(f, x):
    return [value({tuple(e - (i == k) for k, e in enumerate(p)): c * p[i] for p, c in f.items() if p[i]}, x)
            for i in range(len(x))]


def rounded(x):
    return F(round(x * GRID), GRID)


class Neighbours:
    """Truths of the expression at points near x, those of `zero` being the surfaces that may change sign."""

    def __init__(self, solid, x, zero):
        self.solid, self.x, self.zero = solid, x, zero
        self.negative = [None if k in zero else value(f, x) < 0 for k, f in enumerate(solid.polynomials)]
        normals = [gradient(solid.polynomials[k], x) for k in zero]
        self.ways = [[F(round(c * 2 ** 40 / max(map(abs, n))), 2 ** 40) for c in n] for n in normals if any(n)]
        d = len(x)
        self.steps = [e for e in itertools.product((-2, -1, 0, 1, 2), repeat=d) if sum(map(abs, e)) in (1, 2, 3)]

    def at(self, y):
        """The truth at y, None on a surface."""
        negative = list(self.negative)
        for k in self.zero:
            v = value(self.solid.polynomials[k], y)
            if v == 0:
                return None
            negative[k] = v < 0
        return truth(self.solid.tree, negative)

    def with_signs(self, signs):
        negative = list(self.negative)
        for k, s in zip(self.zero, signs):
            negative[k] = s
        return negative

    def crossings(self, y, way, far):
        """Where the surfaces cross the line y + s way, about; those that do so beyond `far` are left out."""
        found = set()
        for k in self.zero:
            f, s = self.solid.polynomials[k], F(0)
            for _ in range(4):
                p = [a + s * b for a, b in zip(y, way)]
                slope = sum(a * b for a, b in zip(gradient(f, p), way))
                if slope == 0:
                    break
                s = rounded(s - value(f, p) / slope)
            if abs(s) < far:
                found.add(s)
        return sorted(found)

    def truths(self):
        for e in self.steps:
            y = [a + NEAR * b for a, b in zip(self.x, e)]
            yield self.at(y)
            for way in self.ways:
                # The foot of the step in the plane across the normal.
                off = sum(a * b for a, b in zip(e, way)) / sum(a * a for a in way)
                foot = [rounded(a - NEAR * off * b) for a, b in zip(y, way)]
                s = self.crossings(foot, way, NEAR / 16)
                for a, b in zip([-NEAR / 8, *s], [*s, NEAR / 8]):
                    yield self.at([p + (a + b) / 2 * q for p, q in zip(foot, way)])

    def state(self, known=frozenset()):
        """B if truths differ, those of the gaps beside among them; at once if the surfaces through x do not matter."""
        seen = set(known)
        if len(self.zero) <= 8:
            signs = itertools.product((False, True), repeat=len(self.zero))
            any_way = {truth(self.solid.tree, self.with_signs(s)) for s in signs}
            if len(any_way) == 1:
                return "I" if any_way.pop() else "O"
        for one in self.truths():
            if one is not None:
                seen.add(one)
            if len(seen) == 2:
                return "B"
        return "I" if True in seen else "O"


class Trajectory:
    """c = X / W on a piece."""

    def __init__(self, solid, lo, hi, xs, w):
        self.solid, self.lo, self.hi, self.xs, self.w = solid, lo, hi, xs, w
        self.pullbacks = [self.pullback(f) for f in solid.polynomials]
        self.still = [k for k, p in enumerate(self.pullbacks) if not p]

    def pullback(self, f):
        degree = max(map(sum, f))
        common = 1
        for c in f.values():
            common *= c.denominator
        out = []
        for powers, c in f.items():
            term = scale(power(self.w, degree - sum(powers)), int(c * common))
            for e, x in zip(powers, self.xs):
                term = mul(term, power(x, e))
            out = add(out, term)
        return integral(out)

    def at(self, t):
        def poly(p):
            out = F(0)
            for c in reversed(p):
                out = out * t + c
            return out
        w = poly(self.w)
        return [poly(x) / w for x in self.xs]

    def gap(self, t):
        return Neighbours(self.solid, self.at(t), self.still).state() if self.still else "I" if truth(
            self.solid.tree, [value(f, self.at(t)) < 0 for f in self.solid.polynomials]) else "O"

    def changes(self, a, b):
        """Brackets of times between a and b at which a slide changes."""
        if len(self.still) < 2:
            return []
        t = [a + (b - a) * F(k, STEPS) for k in range(1, STEPS)]
        state = [self.gap(x) for x in t]
        out = []
        for k in range(len(t) - 1):
            if state[k] != state[k + 1]:
                low, high = t[k], t[k + 1]
                for _ in range(HALVINGS):
                    mid = (low + high) / 2
                    low, high = (mid, high) if self.gap(mid) == state[k] else (low, mid)
                out.append((low, high))
        return out

    def events(self):
        """Times in order: Roots, and brackets of changes along slides."""
        found = [Root(value=self.lo), Root(value=self.hi)]
        for p in self.pullbacks:
            if p:
                found += roots(p, self.lo, self.hi)
        out = []
        found = sort_roots(found)
        for x, y in zip(found, found[1:]):
            mid = between(x, y)
            x.narrow(F(1, 2 ** 30)), y.narrow(F(1, 2 ** 30))
            out += [x, *self.changes(min(mid, x.bounds()[1]), max(mid, y.bounds()[0]))]
        return out + [found[-1]]

    def zeros(self, root):
        return [k for k, p in enumerate(self.pullbacks) if not p or root.sign_of(p) == 0]

    def state(self, event, known):
        """The state at an event: its neighbours', and its own."""
        if isinstance(event, tuple) or "B" in known or len(known) == 2:
            return "B"
        zero = self.zeros(event)
        if not zero:
            return next(iter(known))
        event.narrow(NARROW)
        x = self.at(sum(event.bounds()) / 2)
        if event.value is None:
            x = [rounded(y) for y in x]
        return Neighbours(self.solid, x, zero).state({s == "I" for s in known})


def between_events(a, b):
    a, b = (Root(value=sum(x) / 2) if isinstance(x, tuple) else x for x in (a, b))
    return between(a, b)


def follow(solid, motion, point, unsweep):
    """(word, [(from, to)]) of a point; a time is a Root or a bracket."""
    line = []
    for piece in motion:
        if unsweep:
            # The w of a piece is positive, and so is the common denominator of the point.
            d = 1
            for x in point:
                d *= x.denominator
            xs = [add(integral_sum(row, [int(x * d) for x in point]), scale(b, d)) for row, b in zip(piece.a, piece.b)]
            w = scale(piece.w, d)
        else:
            xs, w = piece.trajectory(point)
        c = Trajectory(solid, piece.lo, piece.hi, xs, w)
        events = c.events()
        gaps = [c.gap(between_events(x, y)) for x, y in zip(events, events[1:])]
        for k, event in enumerate(events):
            known = {gaps[i] for i in (k - 1, k) if 0 <= i < len(gaps)}
            if k == 0 and line:
                known.add(line[-2][0])
            state = c.state(event, known)
            if k == 0 and line:
                line.pop()
            line.append((state, event, event))
            if k < len(gaps):
                line.append((gaps[k], event, events[k + 1]))
    word, spans = "", []
    for state, low, high in line:
        if word[-1:] != state:
            word += state
            if state == "B":
                spans.append((low, high))
        elif state == "B":
            spans[-1] = spans[-1][0], high
    return word, spans


def integral_sum(row, point):
    out = []
    for p, x in zip(row, point):
        out = add(out, scale(p, x))
    return out
