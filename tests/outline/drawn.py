"""Scenes of the plane drawn at random: solids with holes and several parts, motions of every sort.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from byhand import CUP, ELL, FRAME, JAR, PAIR, STAR, F, box, plane
from motion import build, compose, matrix, rotation, scaling, translate, turn
from solids import Polygon, box_ring, ring

SOLIDS = {"box": box(0, 0, 2, 1), "ell": ELL, "cup": CUP, "frame": FRAME, "jar": JAR, "pair": PAIR, "star": STAR,
          "arrow": plane(ring((0, 0), (4, -2), (2, 0), (4, 2))),
          "two": Polygon([[box_ring(0, 0, 1, 3)], [ring((2, 0), (4, 1), (2, 2))]])}


def simple(rng, most, den):
    return F(rng.randint(-most * den, most * den), den)


def polynomial(rng, degree, most=3, den=7):
    return [simple(rng, most, den) for _ in range(degree + 1)]


def convex(rng, count):
    """The hull of random points, counter-clockwise."""
    points = sorted({(simple(rng, 3, 4), simple(rng, 3, 4)) for _ in range(count)})
    chains = []
    for run in (points, points[::-1]):
        chain = []
        for p in run:
            while len(chain) > 1 and ((chain[-1][0] - chain[-2][0]) * (p[1] - chain[-2][1])
                                      <= (chain[-1][1] - chain[-2][1]) * (p[0] - chain[-2][0])):
                chain.pop()
            chain.append(p)
        chains.append(chain[:-1])
    return plane(chains[0] + chains[1])


def path(rng, legs, whole=True):
    """Points of a polygonal path, some of them visited again."""
    out = [(F(0), F(0))]
    while len(out) <= legs:
        if len(out) > 1 and rng.random() < 0.2:
            out.append(rng.choice(out))
        else:
            out.append((simple(rng, 4, 1 if whole else 7), simple(rng, 4, 1 if whole else 7)))
    return out


def piece(rng, sort, start):
    """A transform on [0, 1] that begins with a translation by `start`, and the sort."""
    shift = translate([[start[0]], [start[1]]])
    # on no line of a solid's side: turned about the middle of one, two parts may touch with one tangent, which no slice shows
    center = [simple(rng, 2, 3) + F(1, 11), simple(rng, 2, 3) + F(1, 13)]
    move = translate([[0] + polynomial(rng, 1)[:1], [0] + polynomial(rng, 1)[:1]])
    if sort == "polynomial":
        return translate([[start[0]] + polynomial(rng, rng.randint(0, 2)), [start[1]] + polynomial(rng, rng.randint(0, 2))])
    if sort == "turn":
        return compose(turn(rng.choice((-1, 1, 2)), center=center), shift)
    if sort == "rotation":
        return compose(rotation([0, F(rng.randint(1, 4), 3)], center=center), move, shift)
    if sort == "scaling":
        return compose(scaling([[1, F(rng.randint(-2, 4), 5)]] * 2, center=center), move, shift)
    if sort == "shear":
        return compose(matrix([[[1], [0, simple(rng, 1, 3)], []], [[0, F(rng.randint(-2, 2), 5)], [1], []]], [1]), shift)
    return compose(matrix([[[1, 2, 1], [], []], [[], [1], []]], [1, 1]), shift)  # diag(1 + t, 1 / (1 + t))


SORTS = ("polynomial", "turn", "rotation", "scaling", "shear", "squeeze")


def motion(rng, number):
    """(sort, a motion of one piece, or of a translation and one more); its sort goes with `number`."""
    sort = SORTS[number % len(SORTS)]
    if rng.random() < 0.6:
        return sort, build([(0, 1, piece(rng, sort, (simple(rng, 1, 3), simple(rng, 1, 3))))])
    x, y = ([F(0)] + polynomial(rng, rng.randint(0, 1)) for _ in "xy")
    return sort, build([(0, 1, translate([x, y])), (1, 2, in_s(piece(rng, sort, (sum(x), sum(y)))))])


def in_s(transform):
    """A transform on [0, 1] as one on [1, 2]: t becomes s."""
    document, makes = transform

    def renamed(value):
        if isinstance(value, dict):
            return {k: renamed(v) for k, v in value.items()}
        if isinstance(value, list):
            return [renamed(v) for v in value]
        return value.replace("t", "s") if isinstance(value, str) else value

    def shifted(made):
        def make(lo, hi, *rest):
            if hasattr(made, "quarters"):
                return made(lo, hi, *rest)
            a, b, w = made(F(0), F(1))
            return [[moved(p) for p in row] for row in a], [moved(p) for p in b], moved(w)
        if hasattr(made, "quarters"):
            make.quarters = made.quarters
        return make

    def moved(p):
        """p(t − 1)."""
        out = []
        for c in reversed(p):
            out = [(out[k - 1] if k else 0) - (out[k] if k < len(out) else 0) for k in range(len(out) + 1)]
            out[0] += c
        while out and out[-1] == 0:
            out.pop()
        return out
    makes = makes if isinstance(makes, list) else [makes]
    return renamed(document), [shifted(m) for m in makes]


def scene(rng, number):
    """(name, solid, motion, unsweep): every third is an unsweep."""
    solid = rng.choice(list(SOLIDS))
    sort, moves = motion(rng, number)
    return f"{number} {solid} {sort}", SOLIDS[solid], moves, number % 3 == 2
