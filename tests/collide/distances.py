# suite
"""Random tetrahedra, triangles and their unions against a clearance: each letter is the sign of the distance minus it.

SPDX-License-Identifier: GPL-3.0-or-later

The second method is the distance at single times, by nearest points of simplices (nearness.py): at times of a grid, between the
program's times and near them, in doubles where these are sure, else in fractions. At rational times of contact the distance is R exactly, and the
cells are those that the nearest points lie in; at irrational ones it is R up to 1e-7. Laws: exchanged, R as a growth of lengths, --first.
"""
from collections import Counter

from nearness import Body, near_cells, square_distance
from exact import Fraction as F, to_double
from pairs import Checks, Collide, cell_pairs, exchanged_cells, first_agrees, options, trace_of
from times import time_root

from algebra import Root, between  # noqa: E402
from motion import build, compose, rotation, translate  # noqa: E402
from solids import Mesh, Polygon, cross, joined, minus, ring  # noqa: E402

PAIRS = {2: 30, 3: 30}
GRID = 30
SURE = 1e-7


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def tetrahedron(rng, reach, shift):
    while True:
        p = [tuple(F(rng.randint(-reach, reach)) + s for s in shift) for _ in range(4)]
        volume = dot(cross(minus(p[1], p[0]), minus(p[2], p[0])), minus(p[3], p[0]))
        if volume:
            faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
            return Mesh(p, faces if volume > 0 else [f[::-1] for f in faces])


def triangle(rng, reach, shift):
    while True:
        p = [tuple(F(rng.randint(-reach, reach)) + s for s in shift) for _ in range(3)]
        area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0])
        if area:
            return ring(*(p if area > 0 else p[::-1]))


def solid(rng, d, parts):
    """One simplex, or two far apart."""
    shifts = [(F(9 * k),) + (F(0),) * (d - 1) for k in range(parts)]
    if d == 2:
        return Polygon([[triangle(rng, 3, s)] for s in shifts])
    return joined(*(tetrahedron(rng, 3, s) for s in shifts))


def some_motion(rng, d):
    """Along polynomials, in half of all cases after a turn by at most a right angle about an axis of rational length."""
    polys = [[F(rng.randint(-10, 10)), F(rng.randint(-20, 20)), F(rng.randint(-12, 12)) * rng.randint(0, 1)] for _ in range(d)]
    way = translate(polys)
    if rng.random() < .5:
        return build([(0, 1, way)])
    if d == 2:
        return build([(0, 1, compose(rotation([0, 1]), way))])
    axis, length = rng.choice([((0, 0, 1), 1), ((1, 2, 2), 3), ((2, -3, 6), 7), ((1, 0, 0), 1)])
    return build([(0, 1, compose(rotation([0, rng.choice([1, -1])], axis=list(axis), length=length), way))])


class Scene:
    def __init__(self, moving, motion, fixed, clearance, inside):
        self.moving, self.motion, self.fixed, self.clearance, self.inside = moving, motion, fixed, clearance, inside
        self.bodies = Body(moving), Body(fixed)
        self.rough = [tuple(map(to_double, p)) for p in self.bodies[1].points]

    def square(self, t, exact):
        moved = [self.motion.map(p, t) for p in self.moving.vertices]
        moved = [tuple(p) + (F(0),) * (3 - len(p)) for p in moved]
        at, to = (moved, self.bodies[1].points) if exact else ([tuple(map(to_double, p)) for p in moved], self.rough)
        return square_distance(self.bodies[0], at, self.bodies[1], to, self.moving.dimension, self.inside)

    def letter(self, t):
        least, limit = self.square(t, False), to_double(self.clearance) ** 2
        if abs(least - limit) < SURE * (1 + limit):
            least, limit = self.square(t, True), self.clearance ** 2
        return "I" if least < limit else "O" if least > limit else "B"


def one_pair(collide, checks, name, scene, tally):
    flags = ("--clearance", str(scene.clearance)) + ("--inside",) * scene.inside
    full = collide.ask(name, scene.moving, scene.motion, scene.fixed, *flags)
    if full is None:
        return
    tally[full.word] += 1
    start, end = scene.motion.start, scene.motion.end
    trace = trace_of(full, start, end)
    times = [start + (end - start) * F(k, GRID) for k in range(GRID + 1)] + [between(a, b) for a, b in zip(trace.times, trace.times[1:])]
    for root in trace.times:
        root.narrow(F(1, 2 ** 40))
        times += [t for t in root.bounds() if start <= t <= end]
    for t in times:
        if not checks.equal(trace.state(Root(value=t)), scene.letter(t), name, "letter", t, full.word):
            return
    for c in full.contacts:
        if isinstance(c["from"], str):
            t = F(c["from"])
            checks.equal(scene.square(t, True), scene.clearance ** 2, name, "distance", t)
            checks.equal(cell_pairs(c), near_cells(scene.moving, scene.motion, scene.fixed, t, scene.clearance ** 2), name, "cells", t)
        else:
            root = time_root(c["from"])
            root.narrow(F(1, 2 ** 60))
            off = scene.square(root.bounds()[0], False) - to_double(scene.clearance) ** 2
            checks.holds(abs(off) < 1e-6, name, "distance", c["near"], off)
    first = collide.ask(name, scene.moving, scene.motion, scene.fixed, "--first", *flags)
    if first is not None:
        first_agrees(checks, first, full, name)
    if not scene.inside:
        exchanged(collide, checks, name, scene, full, flags)


def exchanged(collide, checks, name, scene, full, flags):
    """The fixed solid stands still and the other moves, or it moves and the other is its frame."""
    still = build([(scene.motion.start, scene.motion.end, translate([[F(0)]] * scene.moving.dimension))])
    other = collide.ask(name, scene.fixed, still, scene.moving, *flags, motion_of_fixed=scene.motion)
    if other is not None:
        checks.equal((other.word, other.times()), (full.word, full.times()), name, "exchanged")
        checks.equal([exchanged_cells(c) for c in other.cells()], full.cells(), name, "exchanged")


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    collide = Collide(args, checks)
    for d, count in PAIRS.items():
        for k in args.rounds(count, str(d)):
            rng = args.random
            scene = Scene(solid(rng, d, rng.choice([1, 1, 2])), some_motion(rng, d), solid(rng, d, rng.choice([1, 1, 2])),
                          F(rng.randint(1, 9), rng.choice([1, 2, 3, 7])), rng.random() < .1)
            one_pair(collide, checks, f"{d} {k}", scene, tally)
    print(f"{len(tally)} words: " + ", ".join(f"{word} {n}" for word, n in tally.most_common(20)))
    checks.finish()


if __name__ == "__main__":
    main()
