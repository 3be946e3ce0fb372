# suite
"""Unions of unit cells of the integer grid that translate along polynomials, decided by their coordinates.

SPDX-License-Identifier: GPL-3.0-or-later

Let a cell of the moving union be [a, a + 1], of the fixed one [b, b + 1], and x the translation. Their interiors meet
where |x + a - b| < 1 in every coordinate, they themselves where it is at most 1. Interiors of the unions meet where
those of two cells do: an open set that is not empty has points on no side of a cell. So the state hangs on the set
D of all b - a, and for each coordinate on its floor and on whether it is whole. It changes at roots of x_i - n alone,
which are isolated by Sturm's sequences. Cells of the boundaries, too, are products of points and of open intervals.
A third of the paths pass at whole distances by design. Half of the pairs are then given in oblique coordinates.
`--scale 80` asks 20,000 pairs.
"""
import itertools
import math
import os
import sys
from collections import Counter

from pairs import Checks, Collide, Trace, agrees, cell_pairs, first_agrees, options

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "unsweep"))

from algebra import Root, between, compare, integral, roots  # noqa: E402
from cells import block, solid_of  # noqa: E402
from exact import Fraction as F  # noqa: E402
from motion import build, legs, translate  # noqa: E402

PAIRS = 250


# ---------------------------------------------------------------------------------------- oracle

def differences(moving, fixed):
    return {tuple(q - p for p, q in zip(a, b)) for a in moving for b in fixed}


def state(found, codes):
    """The letter where coordinate k of the translation is codes[k] / 2 if that is whole, else between its neighbours."""
    def meets(choices):
        return any(d in found for d in itertools.product(*choices))
    open_ = [(c // 2,) if c % 2 == 0 else (c // 2, c // 2 + 1) for c in codes]
    closed = [(c // 2 - 1, c // 2, c // 2 + 1) if c % 2 == 0 else (c // 2, c // 2 + 1) for c in codes]
    return "I" if meets(open_) else "B" if meets(closed) else "O"


def code(x):
    return 2 * int(x) if x.denominator == 1 else 2 * math.floor(x) + 1


def crossings(poly, low, high, least, most):
    """(Root, n) in order of time: where the coordinate is the whole number n."""
    out = []
    for n in range(least, most + 1):
        p = integral([F(poly[0] if poly else 0) - n] + [F(c) for c in poly[1:]])
        out += [(root, n) for root in roots(p, low, high)]
    return out


def piece_codes(polys, low, high, found):
    """Times of a piece with the codes at them, and the codes of the gaps."""
    events = [(Root(value=low), None, 0), (Root(value=high), None, 0)]
    for axis, poly in enumerate(polys):
        span = [d[axis] for d in found]
        events += [(root, axis, n) for root, n in crossings(poly, low, high, min(span) - 1, max(span) + 1)]
    times = []              # [Root, {axis: n}] in order
    for root, axis, n in events:
        k = 0
        while k < len(times) and compare(times[k][0], root) < 0:
            k += 1
        if k == len(times) or compare(times[k][0], root):
            times.insert(k, [root, {}])
        if axis is not None:
            times[k][1][axis] = n
    gaps = []
    for (one, _), (other, _) in zip(times, times[1:]):
        t = between(one, other)
        gaps.append([code(value_of(poly, t)) for poly in polys])
    at = []
    for k, (_, whole) in enumerate(times):
        near = gaps[min(k, len(gaps) - 1)]
        at.append([2 * whole[axis] if axis in whole else near[axis] for axis in range(len(polys))])
    return [t for t, _ in times], at, gaps


def value_of(poly, t):
    return sum((F(c) * t ** k for k, c in enumerate(poly)), F(0))


def oracle(found, pieces):
    """The Trace, and the codes at each of its times; pieces are (low, high, polynomials)."""
    times, codes, gaps = [], [], []
    for low, high, polys in pieces:
        t, c, g = piece_codes(polys, low, high, found)
        keep = 1 if times else 0
        times, codes, gaps = times + t[keep:], codes + c[keep:], gaps + g
    trace = Trace(times, [state(found, c) for c in codes], [state(found, c) for c in gaps])
    return trace, codes


def named_cells(solid):
    """(name, twice the lowest corner, extent 0 or 1 by coordinate) of every vertex, edge and facet."""
    out = [(("vertex", k), [p]) for k, p in enumerate(solid.vertices)]
    out += [(("edge", min(e), max(e)), [solid.vertices[k] for k in e]) for e in solid.edges]
    out += [(("face", k), [solid.vertices[v] for v in f]) for k, f in enumerate(getattr(solid, "facets", []))]
    return [(name, [2 * int(min(x)) for x in zip(*points)], [int(max(x) > min(x)) for x in zip(*points)])
            for name, points in out]


def meeting(moving, fixed, codes):
    """Pairs of cells with a common point, by coordinates: points are equal, a point is in an open interval of length 1,
    or two of them are less than 1 apart. All lengths are doubled, and an odd code is a place between two whole ones."""
    def one(a, long_a, b, long_b, c):
        apart = a + c - b
        if long_a and long_b:
            return abs(apart) < 2
        if long_a or long_b:
            return (-2 < apart < 0) if long_a else (0 < apart < 2)
        return apart == 0
    return {(m, f) for m, a, la in moving for f, b, lb in fixed
            if all(map(one, a, la, b, lb, codes))}


# ----------------------------------------------------------------------------------------- pairs

def blob(rng, d, most):
    """Cells that grow from one, seldom across an edge or a corner alone."""
    cells = {(0,) * d}
    for _ in range(rng.randrange(most)):
        step = [0] * d
        for axis in rng.sample(range(d), 1 if rng.random() < 0.8 else rng.randint(2, d)):
            step[axis] = rng.choice((-1, 1))
        cells.add(tuple(x + s for x, s in zip(rng.choice(sorted(cells)), step)))
    return cells


def housing(rng, d):
    """A block with a cavity or a tunnel in it, one to three cells wide."""
    size = [rng.randint(3, 5 if d == 2 else 4) for _ in range(d)]
    low = [1] * d
    high = [n - 1 for n in size]
    if rng.random() < 0.6:
        high[rng.randrange(d)] += 1
    return block([0] * d, size) - block(low, high)


def small(rng):
    return F(rng.randint(-6, 6), rng.choice((1, 1, 2, 3, 4)))


def through(rng, x, t):
    """A random polynomial with the value x at t."""
    poly = [F(0)] + [small(rng) for _ in range(rng.randint(1, 3))]
    return [x - value_of(poly, t)] + poly[1:]


def to(rng, n, t, outward):
    """A polynomial with the value n at t that stays there, turns there, goes through, or, if t is an end, ends there."""
    c = rng.choice((F(1), F(1, 3), F(5, 2))) * (outward if rng.random() < 0.8 else -outward)
    how = rng.randrange(4)
    if how == 0:
        return [n]
    if how == 1:
        return [n + c * t * t, -2 * c * t, c]
    if how == 2:
        return [n - c * t ** 3, 3 * c * t * t, -3 * c * t, c]
    return [n - c * t, c]


def touching_path(rng, found, d, t):
    """At t a cell of each union touch across one to d coordinates, most often cells that nothing is behind."""
    touched = rng.sample(range(d), rng.randint(1, d))
    signs = [rng.choice((-1, 1)) for _ in range(d)]
    outermost = max(signs[touched[0]] * x[touched[0]] for x in found)
    base = rng.choice(sorted(x for x in found if signs[touched[0]] * x[touched[0]] == outermost))
    return [to(rng, F(base[k] + signs[k]), t, signs[k]) if k in touched
            else through(rng, base[k] + F(rng.randint(-3, 3), 4), t) for k in range(d)]


def lattice_path(rng, found, d):
    """Legs along the axes between whole places; some stand still, some close."""
    spans = [[x[k] for x in found] for k in range(d)]
    points = [[F(rng.randint(min(s) - 1, max(s) + 1)) for s in spans]]
    for _ in range(rng.randint(1, 4)):
        step = [F(0)] * d
        if rng.random() < 0.85:
            step[rng.randrange(d)] = F(rng.randint(-4, 4))
        points.append([x + y for x, y in zip(points[-1], step)])
    motion = legs(points + points[:1] if rng.random() < 0.3 else points)
    return [(p.lo, p.hi, [[F(c, p.w[0]) for c in b] for b in p.b]) for p in motion.pieces]


def random_path(rng, found, d):
    """Pieces (low, high, polynomials)."""
    kind, t = rng.randrange(6), F(rng.randint(0, 6), 3)
    if kind == 0:
        return lattice_path(rng, found, d)
    if kind < 4:
        polys = touching_path(rng, found, d, t)
    else:
        base = rng.choice(sorted(found))
        polys = [through(rng, x + F(rng.randint(-5, 5), 4), t) for x in base]
    return [(F(0), F(2), polys)]


def sheared(rng, d, solids, pieces):
    """Solids and motion in affinely changed coordinates: the answers stay the same."""
    rows = [[F(int(i == j)) + (F(rng.randint(-2, 2), 3) if i < j else 0) for j in range(d)] for i in range(d)]
    rng.shuffle(rows)
    if determinant(rows) < 0:
        rows[0] = [-x for x in rows[0]]

    def f(p):
        return tuple(sum(c * x for c, x in zip(row, p)) for row in rows)

    def g(polys):
        size = max(1, *map(len, polys))
        return [list(c) for c in zip(*[f(q) for q in zip(*[[F(x) for x in p] + [F(0)] * (size - len(p)) for p in polys])])]
    return [s.mapped(f) for s in solids], [(low, high, g(polys)) for low, high, polys in pieces]


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    return sum((-1) ** k * x * determinant([r[:k] + r[k + 1:] for r in rows[1:]]) for k, x in enumerate(rows[0]))


def one_pair(collide, checks, rng, name, tally):
    d = rng.choice((2, 3))
    moving = blob(rng, d, 6 if d == 3 else 8)
    fixed = housing(rng, d) if rng.random() < 0.3 else blob(rng, d, 8)
    found = differences(moving, fixed)
    pieces = random_path(rng, found, d)
    trace, codes = oracle(found, pieces)
    tally[trace.word()] += 1
    solids = [solid_of(moving), solid_of(fixed)]
    named = [named_cells(s) for s in solids]
    if rng.random() < 0.5:
        solids, pieces = sheared(rng, d, solids, pieces)
    motion = build([(low, high, translate(polys)) for low, high, polys in pieces])
    answer = collide.ask(name, solids[0], motion, solids[1])
    if answer is None or not agrees(checks, answer, trace, name):
        return
    for c, (_, _, _, k) in zip(answer.contacts, trace.contacts()):
        checks.equal(cell_pairs(c), meeting(*named, codes[k]), name, "cells")
    first = collide.ask(name, solids[0], motion, solids[1], "--first")
    if first is not None:
        first_agrees(checks, first, answer, name)


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    collide = Collide(args, checks)
    for k in args.rounds(PAIRS):
        one_pair(collide, checks, args.random, f"pair {args.seed} {k}", tally)
    touching = sum(n for word, n in tally.items() if "B" in word and "I" not in word)
    slid = sum(n for word, n in tally.items() if "OBO" in word or "IBI" in word or word[0] == "B" or word[-1] == "B")
    print(f"{len(tally)} words: " + ", ".join(f"{word} {n}" for word, n in tally.most_common(20)))
    checks.holds(touching * 6 > PAIRS * args.share and slid * 4 > PAIRS * args.share, "too few pairs touch", touching, slid)
    checks.finish()


if __name__ == "__main__":
    main()
