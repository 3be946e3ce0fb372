#!/usr/bin/env python3
# suite
"""Random germs of dependent surfaces: what rational points near them show is never excluded (C95 to C100, C129).

SPDX-License-Identifier: GPL-3.0-or-later

Through the origin go z + ... = 0 and a second surface that is the first one times a unit plus F(x, y): F definite, indefinite,
of rank 1, flat, in two degrees, alone or with planes and a ball; or three surfaces through an edge, or a quadratic cone with
planes. The solid asks whether one pattern of their signs occurs, or all others. Points are found on the surfaces by Newton's
iteration in fractions, then displaced by far less than their distance: the patterns that they have occur. A state O
or I that they contradict is wrong. A B is shown by them, too, but where they are too few; how many is told. Near an apex of
several cones and planes all directions of small integers are looked along; such germs are always decided.
"""
import collections
import itertools
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

import branches  # noqa: E402
from scenes import Checks, Curved, Graze, Motion, minus, options  # noqa: E402
from exact import Fraction as F  # noqa: E402
from program import merged  # noqa: E402

GERMS, PLANE = 600, 300
CONES = 60
SPAN = range(-5, 6)                  # of the coordinates of directions
PLACES = 240                         # points are rounded to 2^-PLACES,
NUDGE = 1 << 40                      # and displaced by so much
SCALES = (1 << PLACES - 12, 1 << PLACES - 20)
SLOPES = [(1, 0), (0, 1), (1, 1), (1, -1), (1, 3), (3, -1), (2, 5), (5, -2)]


class Poly(branches.Poly):
    """Coefficients by powers of x, y, z."""

    def ready(self):
        """Integer coefficients, for points that are integers over 2^PLACES."""
        if not hasattr(self, "terms"):
            common = math.lcm(*(c.denominator for c in self.values())) if self else 1
            top = self.degree()
            self.terms = [(int(c * common), *k, PLACES * (top - sum(k))) for k, c in self.items()]
        return self.terms

    def at(self, p):
        """The value, times a positive number that depends on the polynomial alone."""
        out = 0
        x, y, z = p
        for c, i, j, k, shift in self.ready():
            if i:
                c *= x ** i
            if j:
                c *= y ** j
            if k:
                c *= z ** k
            out += c << shift
        return out

    def slope(self, i):
        return Poly({tuple(e - (n == i) for n, e in enumerate(k)): c * k[i] for k, c in self.items() if k[i]})

    def gradient(self):
        """Its three derivatives, with the integer factor of its own coefficients."""
        if not hasattr(self, "slopes"):
            common = math.lcm(*(c.denominator for c in self.values()))
            self.slopes = [Poly({k: c * common for k, c in self.slope(i).items()}) for i in range(3)]
        return self.slopes


def some(rng, keys, chance=0.6, span=3):
    return Poly({k: F(rng.choice([-1, 1]) * rng.randint(1, span), rng.choice([1, 1, 2])) for k in keys if rng.random() < chance})


def keys(low, high, only_xy=False):
    return [k for k in itertools.product(range(high + 1), repeat=3) if low <= sum(k) <= high and not (only_xy and k[2])]


def linear(rng):
    out = Poly()
    while not out:
        out = some(rng, keys(1, 1), 0.7, 2)
    return out


def remainder(rng, kind, most):
    """F(x, y) by the form it begins with."""
    sign = rng.choice([-1, 1])
    higher = some(rng, keys(3, most, True), 0.3)
    square = Poly({(2, 0, 0): F(sign)})
    if kind == "definite":
        return square + Poly({(0, 2, 0): F(sign * rng.randint(1, 3)), (1, 1, 0): F(rng.randint(-1, 1))}) + higher
    if kind == "indefinite":
        return square + Poly({(0, 2, 0): F(-sign * rng.randint(1, 3))}) + higher
    if kind == "rank 1":
        rest = [Poly(), Poly({(0, 3, 0): F(sign)}), Poly({(0, 4, 0): F(1)}), Poly({(0, 4, 0): F(-1)}),
                Poly({(1, 2, 0): F(2), (0, 4, 0): F(rng.choice([sign, 2 * sign, F(sign, 2)]))})]
        return square + rng.choice([r for r in rest if r.degree() <= most])
    return rng.choice([Poly({(0, 3, 0): F(1)}), Poly({(2, 1, 0): F(1), (0, 3, 0): F(1)}),
                       Poly({(4, 0, 0): F(sign), (0, 4, 0): F(sign)}), Poly({(4, 0, 0): F(1), (0, 4, 0): F(-1)})][:2 if most < 4 else 4])


def touching(rng):
    """Two surfaces that touch, and company."""
    kind = rng.choice(["definite", "indefinite", "rank 1", "flat"])
    company = rng.choice([0, 0, 1, 2])
    z = Poly({(0, 0, 1): F(1)})
    first = z + some(rng, keys(2, 2), 0.5)
    # A unit of degree 1 times a surface of degree 2 has degree 3.
    unit = Poly({(0, 0, 0): F(rng.choice([-2, -1, 1, 2]))}) + some(rng, keys(1, 1), 0.5)
    second = first * unit + remainder(rng, kind, rng.choice([2, 3, 4]) if kind == "definite" or kind == "indefinite" else 4)
    others = [rng.choice([linear(rng), linear(rng) + some(rng, keys(2, 2), 0.5)]) for _ in range(company)]
    return f"touching, {kind}, {'alone' if not company else 'in company'}", [first, second] + others


def at_an_edge(rng):
    """Three surfaces whose gradients lie in one plane."""
    y, z = Poly({(0, 1, 0): F(1)}), Poly({(0, 0, 1): F(1)})
    a, b = y + some(rng, keys(2, 2), 0.4), z + some(rng, keys(2, 2), 0.4)
    phi = rng.choice([Poly({(2, 0, 0): F(1)}), Poly({(2, 0, 0): F(-1)}), Poly({(3, 0, 0): F(1)}), Poly({(4, 0, 0): F(-1)}), Poly()])
    scale = [Poly({(0, 0, 0): F(rng.choice([-2, -1, 1, 3]))}) + some(rng, keys(1, 1), 0.3) for _ in range(2)]
    return "edge", [a, b, a * scale[0] + b * scale[1] + phi]


def general(rng):
    count = rng.randint(2, 5)
    surfaces = [linear(rng) + some(rng, keys(2, 2), 0.4) for _ in range(count)]
    normals = [[f.get(tuple(int(n == i) for n in range(3)), F(0)) for i in range(3)] for f in surfaces]
    touch = any(all(a[i] * b[j] == a[j] * b[i] for i in range(3) for j in range(i))
                for a, b in itertools.combinations(normals, 2))
    if not touch and count > 3 and any(det(*three) == 0 for three in itertools.combinations(normals, 3)):
        return "general, three at an edge in company", surfaces
    return "general, two touching" if touch else "general", surfaces


def det(a, b, c):
    return sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))


def apex(rng):
    form = Poly()
    while not form:
        form = some(rng, keys(2, 2), 0.6, 3)
    return "apex", [form] + [linear(rng) for _ in range(rng.randint(0, 3))]


def cones(rng):
    """Two cones or three with one apex, coaxial or not, of degree 2 to 4, and planes through it."""
    out = []
    for _ in range(rng.choice([2, 2, 3])):
        axis = [rng.randint(-2, 2) for _ in range(3)] if rng.random() < 0.5 else [0, 0, 1]
        square = Poly({tuple(2 * (n == i) for n in range(3)): F(sum(a * a for a in axis) or 1) for i in range(3)})
        along = Poly({tuple(int(n == i) for n in range(3)): F(a) for i, a in enumerate(axis) if a})
        slope = Poly({(0, 0, 0): F(-rng.randint(2, 9), rng.choice([1, 2, 4]))})
        out.append(rng.choice([square + along * along * slope] * 3 + [some(rng, keys(k, k), 0.6, 3) for k in (2, 2, 3, 4)]))
    return "cones", [f for f in out if f] + [linear(rng) for _ in range(rng.choice([0, 0, 1, 2]))]


def along_directions(surfaces):
    """Patterns that homogeneous polynomials have along directions."""
    signs = ([(v > 0) - (v < 0) for v in (f.at(p) for f in surfaces)] for p in itertools.product(SPAN, repeat=3))
    return {tuple(s) for s in signs if all(s)}


def germs(args):
    rng, kinds = args.random, [touching, touching, touching, at_an_edge, general, apex]
    for _ in args.rounds(GERMS, "germs"):
        name, surfaces = rng.choice(kinds)(rng)
        if all(f and f.degree() <= 4 for f in surfaces):
            yield name, surfaces, patterns(surfaces, rng)
    for _ in args.rounds(CONES, "cones"):
        name, surfaces = cones(rng)
        yield name, surfaces, along_directions(surfaces)


def solve(base, free, axes):
    """A point with base = 0 whose coordinates but `axes` are `free`; None where Newton's iteration fails."""
    p, rest = [0, 0, 0], [i for i in range(3) if i not in axes]
    for i, value in zip(rest, free):
        p[i] = value
    for _ in range(9):
        # Values and slopes have one common factor if their degrees are made equal: 2^PLACES is a unit of length.
        values = [f.at(p) for f in base]
        slopes = [[f.gradient()[i].at(p) << PLACES * (f.degree() - 1 - f.gradient()[i].degree()) for i in axes] for f in base]
        if len(axes) == 1:
            if not slopes[0][0]:
                return None
            step = [values[0] // slopes[0][0]]
        else:
            det = slopes[0][0] * slopes[1][1] - slopes[0][1] * slopes[1][0]
            if not det:
                return None
            step = [(values[0] * slopes[1][1] - values[1] * slopes[0][1]) // det,
                    (values[1] * slopes[0][0] - values[0] * slopes[1][0]) // det]
        for i, s in zip(axes, step):
            p[i] -= s
    return p if all(abs(x) < 1 << PLACES - 6 for x in p) else None


def patterns(surfaces, rng):
    """Patterns of signs that points near the origin have."""
    out = set()

    def look(p):
        signs = tuple((v > 0) - (v < 0) for v in (f.at(p) for f in surfaces))
        if all(signs):
            out.add(signs)

    smooth = [f for f in surfaces if any(f.get(tuple(int(n == i) for n in range(3))) for i in range(3))]
    for scale in SCALES:
        for _ in range(60):
            look([scale * rng.randint(-40, 40) // 40 for _ in range(3)])
        for a in smooth:
            axis = max(range(3), key=lambda i: abs(a.get(tuple(int(n == i) for n in range(3)), 0)))
            for slope in SLOPES:
                for way in (1, -1):
                    p = solve([a], [way * scale * s for s in slope], [axis])
                    for nudge in (NUDGE, -NUDGE):
                        if p:
                            look([x + nudge * (n == axis) for n, x in enumerate(p)])
            for b in smooth:
                if b is a or rng.random() < 0.3:
                    continue
                for axes in ((0, 1), (0, 2), (1, 2)):
                    for way in (1, -1):
                        p = solve([a, b], [way * scale], axes)
                        for nudges in itertools.product((0, NUDGE, -NUDGE), repeat=3):
                            if p:
                                look([x + n for x, n in zip(p, nudges)])
        # Where the second of two touching surfaces bends away along a curve x = k y^2.
        for k in (-4, -2, -1, 0, 1, 2, 4):
            for way in (1, -1):
                for a in smooth[:2]:
                    p = solve([a], [k * scale * scale >> PLACES + 1, way * scale], [2])
                    for nudge in (NUDGE, -NUDGE):
                        if p:
                            look([p[0], p[1], p[2] + nudge])
    return out


def node_of(f):
    return {"polynomial": {",".join(map(str, k)): str(c) for k, c in f.items()}}


def path_to(rng, name):
    """A path to the place: expressions, the half paths in s = t - time or X, or points near the time where it is no series."""
    _, _, time, path = branches.PLACES[name]
    if path:
        return path, None
    u = [F(rng.randint(-3, 3), rng.choice([1, 2])) for _ in range(4)] if rng.random() < 0.8 else [F(0)] * 4
    if name == "rational":   # at rest with both halves zero, one in five
        return [f"({a})*t+({b})*t^2" for a, b in (u[:2], u[2:])], branches.halves(branches.line(0, *u[:2]), branches.line(0, *u[2:]))
    return ["t", f"({u[0]})*(t^2-2)+({u[1]})*(t^2-2)^2"], branches.halves(branches.line(0, 1), branches.line(0, *u[:2]))


def beside(curves, truth, way):
    """The state of a gap on the path to root 2 and root 3, at a time between that and an end of the motion."""
    t = branches.PLACES["roots of 2 and 3"][2] + F(way, 10 ** 10)
    x, y = ((t ** 3 - 9 * t) / 2) ** 2 - 2, ((11 * t - t ** 3) / 2) ** 2 - 3
    signs = [(v > 0) - (v < 0) for v in (sum(c * x ** i * y ** j for (i, j), c in f.items()) for f, _ in curves)]
    return None if 0 in signs else branches.state([tuple(signs)], truth)


def in_the_plane(number, checks, graze, rng, told):
    """A scene of curves through one point of the plane: the word near it, from the patterns beside branches."""
    name = rng.choice(["rational", "rational", "root of 2", "roots of 2 and 3"])
    both = branches.drawn(rng, name, rng.choice([2, 2, 3, 3, 4, 5, 14 if name == "rational" else 3]))
    curves = [curve for curve, _ in both]
    shown = branches.patterns(curves)
    if shown is None:
        return
    # A rational point may lie anywhere: stacks are at windows whose sides are multiples of powers of 1/2.
    by = [F(rng.choice([rng.randint(-40, 40), rng.randint(-12, -9)]), 64) if name == "rational" else 0 for _ in "xy"]
    if name == "rational":
        displaced = [branches.plane(x1y0=1, x0y0=-by[0]), branches.plane(x0y1=1, x0y0=-by[1]), branches.UNIT]
        both = [(curve, there.into(*displaced)) for curve, there in both]
    nodes = [(k, node_of(there)) for k, (_, there) in enumerate(both)]
    solid, truth = branches.tree(rng, nodes)
    rest = [p for p in itertools.islice(itertools.product((-1, 1), repeat=len(curves)), 64) if p not in shown]
    if rest and rng.random() < 0.5:
        wanted = rng.choice(rest)
        solid = {"intersection": [node_of(there.times(-s)) for (_, there), s in zip(both, wanted)]}
        whole = rng.random() < 0.5
        solid = minus({"box": {"low": ["-9"] * 2, "high": ["9"] * 2}}, solid) if whole else solid
        truth = lambda signs: (tuple(signs) == wanted) != whole  # noqa: E731
    path, sides = path_to(rng, name)
    gaps = [branches.gap(curves, half, truth) for half in reversed(sides)] if sides else [beside(curves, truth, w) for w in (-1, 1)]
    at, time, span = branches.state(shown, truth), branches.PLACES[name][2], F(1, 10 ** 9)
    if sides and not any(sides[0]):
        gaps = [at, at]
    if None in gaps:
        return
    word = merged(gaps[0] + at + gaps[1])
    motion = Motion(2, [(time - span, time + span, {"translate": [f"-({p})-({b})" for p, b in zip(path, by)]})])
    answers = graze.classify(f"plane {number}", Curved(2, solid), motion, [(0, 0)])
    told[f"plane, {name}"][at] += 1
    if answers:
        checks.equal(answers[0].word, word, number, name, [dict(f) for f, _ in curves], solid, path)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    rng = args.random
    told = collections.defaultdict(collections.Counter)
    for number, (name, surfaces, shown) in enumerate(germs(args)):
        wanted = tuple(rng.choice([-1, 1]) for _ in surfaces)
        rest = [p for p in itertools.product((-1, 1), repeat=len(surfaces)) if p not in shown]
        if rest and rng.random() < 0.7:
            wanted = rng.choice(rest)
        # The set where all signs are as wanted, or its complement.
        both = {"intersection": [node_of(Poly({k: c * (-s) for k, c in f.items()})) for f, s in zip(surfaces, wanted)]}
        whole = rng.random() < 0.5
        solid = minus({"box": {"low": ["-9"] * 3, "high": ["9"] * 3}}, both) if whole else both
        way = [F(rng.randint(-3, 3), 2) for _ in range(3)]
        bend = [F(rng.randint(-2, 2)) for _ in range(3)]
        if not any(way):
            way[0] = F(1)
        path = [f"-(({a})*t+({b})*t^2)" for a, b in zip(way, bend)]
        answers = graze.classify(f"germ {number}", Curved(3, solid),
                                 Motion(3, [("-1/1024", "1/1024", {"translate": path})]), [(0, 0, 0)])
        if not answers:
            continue
        state = state_at_zero(answers[0])
        inside = {(p == wanted) != whole for p in shown}
        told[name][state] += 1
        what = (number, name, [dict(f) for f in surfaces], wanted, whole, way, bend, answers[0].word)
        checks.holds(not (state == "O" and True in inside), *what, "is not outside")
        checks.holds(not (state == "I" and False in inside), *what, "is not inside")
        if state == "B" and len(inside) < 2:
            told[name]["B, not shown"] += 1
        if name in DECIDED:
            # Away from the origin the path may run in a surface, and along another singularity.
            checks.holds(state != "?" or answers[0].record["undecided"]["t"] != "0", *what, "is undecided")
    for number in args.rounds(PLANE, "plane"):
        in_the_plane(number, checks, graze, rng, told)
    for name in sorted(told):
        print(f"{name}: " + ", ".join(f"{count} {state}" for state, count in sorted(told[name].items())))
    checks.holds(told["cones"]["B, not shown"] * 10 <= CONES * args.share, "cones", dict(told["cones"]))
    checks.finish()


DECIDED = {"touching, definite, alone", "touching, indefinite, alone", "touching, rank 1, alone", "edge", "general", "apex", "cones"}


def state_at_zero(answer):
    """The state at t = 0: of an undecided trace that at its place."""
    if "undecided" in answer.record:
        return "?"
    for contact in answer.contacts:
        low, high = (F(x) if isinstance(x, str) else None for x in (contact["from"], contact["to"]))
        if low is not None and high is not None and low <= 0 <= high:
            return "B"
        if low is None or high is None:
            near = [F(x) if isinstance(x, str) else (F(x["lo"]) + F(x["hi"])) / 2 for x in (contact["from"], contact["to"])]
            if near[0] < 0 < near[1]:
                return "B"
    # Contacts are before or behind; the letter at 0 is that behind the last one before it.
    behind = sum(1 for c in answer.contacts if (F(c["to"]) if isinstance(c["to"], str) else F(c["to"]["hi"])) <= 0)
    letters = [c for c in answer.word if c != "B"]
    if not letters:
        return "B"
    return letters[behind - (answer.word[0] == "B")] if behind else letters[0]


if __name__ == "__main__":
    main()
