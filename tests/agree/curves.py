# suite
"""Trajectories drawn by hand: any polynomial curve through any chosen place of the boundary.

SPDX-License-Identifier: GPL-3.0-or-later

With M(t) = R(t) after the translation by -c(t), the origin's inverted trajectory is c, whatever the
rotation R. So c may be written down: c = a + p(u) d1 + q(u) d2 + r(u) d3 with a on the boundary (a
vertex, in an edge, in a facet), the directions along edges, in facets or askew, and u a polynomial
with a root of degree one, two or three, rational or not. The curve slides along edges and facets,
leaves them at reflex corners, touches to any order, goes through vertices of many facets at an
irrational time, passes twice through one place, and turns at break points on the boundary. The
second tracer says what the answer is.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from agreement import Tally, compare  # noqa: E402
from exact import Fraction as F  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from motion import build, compose, fadd, fmul, rotation, translate  # noqa: E402
from solids import Mesh, Polygon, box_ring, meshes, minus, polygons, ring  # noqa: E402
from tracer import trace  # noqa: E402

CURVES = 8

# u(t) on an interval: roots 0, -1/2 and 1/3, sqrt 2, the cube root of 2, the golden ratio, +-sqrt 2
CLOCKS = [([0, 1], -1, 1), ([F(-1, 6), F(1, 6), 1], -1, 1), ([-2, 0, 1], 0, 2),
          ([-2, 0, 0, 1], 0, 2), ([-1, -1, 1], 0, 2), ([-2, 0, 1], -2, 2)]
# p(u): how fast the curve leaves along a direction
SPEEDS = [[], [0, 1], [0, -1], [0, 0, 1], [0, 0, -1], [0, 0, 0, 1], [0, 1, 1], [0, 0, 2, -1],
          [0, F(1, 2)], [0, 0, F(1, 2**40)]]


def cone(sides):
    """A pyramid over a star: its apex is on 2 * sides facets, half of its edges are reflex."""
    turns = [(1, 0), (F(3, 5), F(4, 5)), (F(-7, 25), F(24, 25)), (-1, 0),
             (F(-7, 25), F(-24, 25)), (F(3, 5), F(-4, 5))][:sides]
    base = []
    for k, (x, y) in enumerate(turns):
        z = turns[(k + 1) % len(turns)]
        base += [(4 * F(x), 4 * F(y), F(0)), (F(x + z[0]) / 2, F(y + z[1]) / 2, F(0))]
    n = len(base)
    return Mesh(base + [(0, 0, 3)], [list(range(n))[::-1]]
                + [[k, (k + 1) % n, n] for k in range(n)])


def thin():
    """Two walls 2^-300 apart: their contact times differ by less than doubles resolve."""
    e = F(1, 2 ** 300)
    return Polygon([[box_ring(0, 0, e, 4)], [ring((2 * e, 0), (5, 0), (5, 4), (2 * e, 4))]])


def solids():
    out = dict(polygons())
    out["thin"] = thin()
    out.update(meshes())
    out["cone"] = cone(6)
    return out


def directions(solid, rng):
    """Edges of the solid, differences of its vertices (in facets, or across), and one askew."""
    v = solid.vertices
    def along():
        a, b = rng.choice(solid.edges)
        return minus(v[b], v[a])
    def across():
        if isinstance(solid, Polygon):
            return minus(rng.choice(v), rng.choice(v))
        f = rng.choice(solid.facets)
        return minus(v[rng.choice(f)], v[rng.choice(f)])
    def askew():
        return tuple(F(rng.randint(-3, 3)) for _ in v[0])
    return [rng.choice((along, across, askew))() for _ in v[0]]


def composed(p, u):
    out, x = [F(0)], [F(1)]
    for c in p:
        out = fadd(out, [F(c) * y for y in x])
        x = fmul(x, u)
    return out


def drawn(a, ways, speeds, clock):
    """The coordinates of c as polynomials in t."""
    out = [[x] for x in a]
    for d, p in zip(ways, speeds):
        q = composed(p, clock)
        out = [fadd(c, [y * x for x in q]) for c, y in zip(out, d)]
    return out


def piece(curve, turning, dimension):
    back = translate([[-x for x in c] for c in curve])
    if not turning:
        return back
    axis = {"axis": [2, -1, 2], "length": 3} if dimension == 3 else {}
    return compose(back, rotation(turning, **axis))


def random_curve(solid, rng):
    """A motion whose origin's trajectory goes through a place of the boundary, in one piece, or
    in two with the break at that place."""
    d = solid.dimension
    _, a = rng.choice(solid.cell_points(rng))
    turning = rng.choice([None, [0, 1], [1, F(-1, 2)]])
    def speeds():
        return [rng.choice(SPEEDS) for _ in range(d)]
    if rng.random() < 0.3:
        first = drawn(a, directions(solid, rng), speeds(), [0, 1])
        second = drawn(a, directions(solid, rng), speeds(), [0, 1])
        return build([(-1, 0, piece(first, turning, d)), (0, 1, piece(second, turning, d))])
    clock, lo, hi = rng.choice(CLOCKS)
    return build([(lo, hi, piece(drawn(a, directions(solid, rng), speeds(), clock), turning, d))])


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Tally()
    graze = Graze(args, checks)
    for name, solid in solids().items():
        path = graze.write(name + solid.suffix, solid.text())
        origin = (F(0),) * solid.dimension
        for k in args.rounds(CURVES, name):
            motion = random_curve(solid, args.random)
            answers = graze.classify(f"{name} {k}", path, motion, [origin])
            if answers:
                word, contacts = trace(solid, motion, origin)
                compare(checks, tally, answers[0], word, contacts, name, motion.text())
                tally.add(answers[0])
    tally.report(checks)
    checks.finish()


if __name__ == "__main__":
    main()
