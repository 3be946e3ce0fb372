# suite
"""The first contact of all motions within an error: pairs by hand, and random motions near others, whose exact contacts lie between the times.

SPDX-License-Identifier: GPL-3.0-or-later

Above each scene stands its derivation: the gap of both solids, or its negative, the depth of the named point of one in the other. `low` is where the gap falls to
R + ETA, `high` where the depth passes ETA - R (the gap falls below R - ETA where that is positive); None: never. Second method: a motion N with
|N(t)x - M(t)x| <= ETA, by its own first contact and its own first time in I, of `graze collide` without an error. Laws: enclosures are nested, low is
`--first` at the clearance R + ETA, high of R >= ETA is the first I at R - ETA.
"""
import json
from collections import Counter

from clearance import along_x
from distances import solid
from exact import Fraction as F
from hand import BAR, CUBE, FULL_TURN, OCTA, POST, ROOF, SLAB, SPIKE, SQUARE, TINY, TURN, UPSIDE_DOWN, WALL, across, along, moved, plane, ring, root
from pairs import Checks, Collide, options, time_is
from round import Round, ball, capsule
from times import time_root

from algebra import Root, compare  # noqa: E402
from motion import build, compose, legs, matrix, rotation, scaling, translate  # noqa: E402
from solids import Mesh, block, box_ring  # noqa: E402

ERRORS = ("0", "1/64", "1/16", "1/4", "1", "4")
PAIRS = {2: 20, 3: 16}
SCENES = []


def scene(name, moving, motion, fixed, error, low, high, clearance=0, frame=None):
    SCENES.append((name, moving, motion, fixed, F(error), low, high, F(clearance), frame))


# ------------------------------------------------------------------------------------------ head on

# S = [t, t + 1] x [0, 1]^2 against Q = [3, 4] x [0, 1]^2: the gap is 2 - t; the middle of the face that comes first is t - 2 deep up to 1/2
scene("head on", CUBE, along_x(0, 3), WALL, F(1, 4), F(7, 4), F(9, 4))
scene("an error of 2^-60", CUBE, along_x(0, 3), WALL, TINY, 2 - TINY, 2 + TINY)
scene("the motion ends too early", CUBE, along_x(0, F(17, 8)), WALL, F(1, 4), F(7, 4), None)
scene("as deep as the error at the end, not deeper", CUBE, along_x(0, F(9, 4)), WALL, F(1, 4), F(7, 4), None)
scene("they only come near", CUBE, along_x(0, F(15, 8)), WALL, F(1, 4), F(7, 4), None)
scene("near at the end alone", CUBE, along_x(0, F(7, 4)), WALL, F(1, 4), F(7, 4), None)
scene("never near", CUBE, along_x(0, 1), WALL, F(1, 4), None, None)
scene("near at the start", CUBE, along_x(F(15, 8), 3), WALL, F(1, 4), F(15, 8), F(9, 4))
# S begins in [5/2, 7/2]: a third of its first face's triangle is 1/3 from the border and 1/2 from x = 3
scene("deep at the start", CUBE, along_x(F(5, 2), 4), WALL, F(1, 4), F(5, 2), F(5, 2))
scene("an error above all sizes", CUBE, along_x(0, 3), WALL, 100, 0, None)
# Q is 18 x 18 x 17: the same middle is t - 2 deep
scene("an error above the moving solid's size", CUBE, along_x(-1, 6), block(3, -9, -9, 20, 9, 9), 2, 0, 4)
scene("in the plane", SQUARE, moved(0, 3, [0, 1], [0]), plane(box_ring(3, 0, 4, 1)), F(1, 4), F(7, 4), F(9, 4))
# the gap is 2 - t^2
scene("at irrational times", CUBE, moved(0, 2, [0, 0, 1], [0], [0]), WALL, F(1, 8), root([-15, 0, 8], 1, 2), root([-17, 0, 8], 1, 2))
# two units of time a unit from x = 1 on: 2 - t until t = 1, then (3 - t)/2
scene("in two pieces", CUBE, legs([(0, 0, 0), (1, 0, 0), (3, 0, 0)], [0, 1, 5]), WALL, F(1, 4), F(5, 2), F(7, 2))
# x = 2 t until t = 1, then back: the gap is 0 at t = 1 alone, at most 1/4 from 7/8
scene("a touch and back", CUBE, legs([(0, 0, 0), (2, 0, 0), (0, 0, 0)]), WALL, F(1, 4), F(7, 8), None)
# x = 5/2 at t = 1 after 5 t / 2: the gap is 1/4 at 7/10, the depth 1/4 at 9/10
scene("in and back", CUBE, legs([(0, 0, 0), (F(5, 2), 0, 0), (0, 0, 0)]), WALL, F(1, 4), F(7, 10), F(9, 10))

# ------------------------------------------------------------------------------------------ no error, and a clearance

scene("no error", CUBE, along_x(0, 3), WALL, 0, 2, 2)
scene("no error, and a touch at the end", CUBE, along_x(0, 2), WALL, 0, 2, None)
# x = t until 2, there for 1, on again: B from 2 to 3
scene("no error, and a touch that lasts", CUBE, legs([(0, 0, 0), (2, 0, 0), (2, 0, 0), (3, 0, 0)], [0, 2, 3, 4]), WALL, 0, 2, 3)
scene("no error and a clearance", CUBE, along_x(0, 3), WALL, 0, F(3, 2), F(3, 2), F(1, 2))
# R > ETA: gaps of 3/4 and 1/4; R = ETA: 1/2 and 0; R < ETA: 3/8 and a depth of 1/8
scene("a clearance above the error", CUBE, along_x(0, 3), WALL, F(1, 4), F(5, 4), F(7, 4), F(1, 2))
scene("a clearance as the error", CUBE, along_x(0, 3), WALL, F(1, 4), F(3, 2), 2, F(1, 4))
scene("a clearance below the error", CUBE, along_x(0, 3), WALL, F(1, 4), F(13, 8), F(17, 8), F(1, 8))

# ------------------------------------------------------------------------------------------ vertices and edges

# the lowest vertex of OCTA is 4 - t above SLAB, which is 1 thick
scene("a vertex into a face", OCTA, moved(0, 6, [0], [0], [5, -1]), SLAB, F(1, 8), F(31, 8), F(33, 8))
# a slab whose floor is at 4 - t falls on the vertex (0, 0, 1)
scene("a face onto a vertex", block(-9, -9, 4, 9, 9, 5), moved(0, 6, [0], [0], [0, -1]), OCTA, F(1, 4), F(11, 4), F(13, 4))
# The ridges cross at (0, 0, 0), 1 - t apart; a point t - 1 below the fixed one is (t - 1)/5^(1/2) from its sides, which have the slope 2:
# (t - 1)^2 = 5/16
scene("crossed ridges", ROOF, moved(0, 2, [0], [0], [-1, 1]), UPSIDE_DOWN, F(1, 4), F(3, 4), root([11, -32, 16], 1, 2))
# Sides have the slope 3/4, so that the point h = t - 1 below the other's ridge is 4 h/5 deep: h = 5/16. The roof slides along both ridges, so that no point of
# either solid stays at the crossing
scene("crossed ridges that slide", along(30)(ring((0, 0), (-8, -6), (8, -6))), moved(0, 2, [-2, 2], [-3, 3], [-1, 1]), across(ring((0, 0), (8, 6), (-8, 6)), 30),
      F(1, 4), F(3, 4), F(21, 16))
# Bars along y and x cross over [-1, 1]^2, far from their middles: z = 5 - t and 4
LONG = block(-1, -1, 5, 1, 30, 7)
scene("crossed bars", LONG, moved(0, 4, [0], [0], [0, -1]), block(-30, -1, 2, 1, 1, 4), F(1, 4), F(3, 4), F(5, 4))
# the bar's long side at the angle 2 arctan t, POST's corner (5/2, 33/2): 33/2 (1 - t^2) - 5 t = (5/2 + gap)(1 + t^2), for gaps of 1/2 and -1/2
scene("a bar turns into a post", plane(BAR), TURN, plane(POST), F(1, 2), root([-27, 10, 39], 0, 1), root([-29, 10, 37], 0, 1))
# the tip 5 from the centre, at the angle pi/2 + 2 arctan u, u = t - 1: x = -10 u/(1 + u^2), against x <= -9/2
scene("a tip turns into a wall", SPIKE, FULL_TURN, plane(box_ring(-9, -9, F(-9, 2), 9)), F(1, 4), root([74, -74, 17], 1, 2), root([78, -78, 19], 1, 2))
# Unit cubes, DART's spline (-2, 2) (-2, -2) (2, -2) (2, 2) against (0, -1): x = -2 + 12 t^2 - 8 t^3, so the gap is 1 - 12 t^2 + 8 t^3 (roots of it
# - 1/64 and + 1/64, times 64), while y + 1 = 12 (t - 1/2)^2 is below 1/2: the middle of the patch is further than 1/64 from its border
BOX = block(F(-1, 2), F(-1, 2), F(-1, 2), F(1, 2), F(1, 2), F(1, 2))
scene("two cubes along a spline", BOX, moved(0, 1, [-2, 0, 12, -8], [2, -12, 12], [0]), BOX.mapped(lambda p: (p[0], p[1] - 1, p[2])), F(1, 64),
      root([63, 0, -768, 512], F(1, 4), F(1, 2)), root([65, 0, -768, 512], F(1, 4), F(1, 2)))

# ------------------------------------------------------------------------------------------ other motions

# one moves by t, the other by -t: 5 - 2 t
scene("both move", CUBE, along_x(0, 4), block(6, 0, 0, 7, 1, 1), F(1, 4), F(19, 8), F(21, 8), frame=moved(0, 4, [0, -1], [0], [0]))
# Q = [-1, 1]^3 times 1 + t, S from x = 3: 2 - t in the world
scene("a frame that grows", block(3, 0, 0, 4, 1, 1), moved(0, 3, [0], [0], [0]), block(-1, -1, -1, 1, 1, 1), F(1, 4), F(7, 4), F(9, 4),
      frame=build([(0, 3, scaling([[1, 1]] * 3))]))
# S = [0, 1 + t] x [0, 1]^2 against x = 3: no similarity
STRETCH = build([(0, 3, scaling([[1, 1], [1], [1]]))])
scene("a solid that is stretched", CUBE, STRETCH, block(3, -1, -1, 6, 2, 2), F(1, 4), F(7, 4), F(9, 4))
# [0, 1 + t] x [-9, 9]^2 comes over the vertex (3, 0, 0): 2 - t
scene("a vertex in a solid that is stretched", block(0, -9, -9, 1, 9, 9), STRETCH, OCTA.mapped(lambda p: (p[0] + 4, p[1], p[2])), F(1, 4),
      F(7, 4), F(9, 4))

# ------------------------------------------------------------------------------------------ balls and capsules

# the centre is 3 - t from Q's side, its radius is 1: 5/4 and 3/4; as the error: 2, and in Q; above: 9/4, and no bound
for tag, error, low, high in (("below", F(1, 4), F(7, 4), F(9, 4)), ("as", 1, 1, 3), ("above", F(5, 4), F(3, 4), None)):
    scene(f"a ball with an error {tag} its radius", ball(1, 0, F(1, 2), F(1, 2)), along_x(0, 4), WALL, error, low, high)
# In a large solid the far point of the ball is t - 2 deep, convex or with a notch beyond y = 9
LARGE = plane(ring((3, -9), (20, -9), (20, 30), (15, 30), (15, 9), (3, 9)))
scene("a ball in a large block", ball(1, 0, F(1, 2), F(1, 2)), along_x(0, 4), block(3, -9, -9, 20, 9, 9), F(5, 4), F(3, 4), F(13, 4))
scene("a disk in a polygon with a notch", ball(1, 0, 0), moved(0, 4, [0, 1], [0]), LARGE, F(5, 4), F(3, 4), F(13, 4))
# Q is the ball, S, [t - 9, t - 1] x [-9, 9]^2, comes: the gap is 4 - t - 1, and the ball's far point as deep as t - 5 + 1
scene("a block around a ball", block(-9, -9, -9, -1, 9, 9), along_x(0, 8), ball(1, 3, 0, 0), F(5, 4), F(7, 4), F(17, 4))
scene("a ball at a clearance", ball(1, 0, F(1, 2), F(1, 2)), along_x(0, 4), WALL, F(1, 4), F(5, 4), F(7, 4), F(1, 2))
# centres (t^2 + 9)^(1/2) apart, radii 2 and 3: 6 and 4
scene("two balls", ball(2, 0, 0, 0), moved(-6, 6, [0, 1], [3], [0]), ball(3, 0, 0, 0), 1, root([-27, 0, 1], -6, -5), root([-7, 0, 1], -3, -2))
# axes along x and y, 2 - t apart, radii 1/2 and 1/4: 7/8 and 5/8
scene("two capsules", capsule(F(1, 2), (0, -3, 0), (0, 3, 0)), moved(0, 2, [0], [0], [-2, 1]), capsule(F(1, 4), (-3, 0, 0), (3, 0, 0)), F(1, 8),
      F(9, 8), F(11, 8))
# balls of 1/2 at (0, 1/2, 1/2) and of 1 at (-9, ...): the first one at 3 - t
scene("a union", Round(([(F(0), F(1, 2), F(1, 2))], F(1, 2)), ([(F(-9), F(1, 2), F(1, 2))], F(1))), along_x(0, 4), WALL, F(1, 4), F(9, 4), F(11, 4))
# The error is above R and sizes grow, so that no bound is sought: the side of [-1, 1]^3 (1 + t) is 4 - t from the centre at 5, less 1
scene("a frame of a ball grows", ball(1, 5, 0, 0), moved(0, 4, [0], [0], [0]), block(-1, -1, -1, 1, 1, 1), F(1, 4), F(11, 4), None,
      frame=build([(0, 4, scaling([[1, 1]] * 3))]))
scene("a frame of a ball grows at a clearance", ball(1, 5, 0, 0), moved(0, 4, [0], [0], [0]), block(-1, -1, -1, 1, 1, 1), F(1, 4), F(9, 4), F(11, 4),
      F(1, 2), frame=build([(0, 4, scaling([[1, 1]] * 3))]))


# ------------------------------------------------------------------------------------------ checks

def bounds(collide, name, moving, motion, fixed, error, clearance=0, frame=None):
    """Both times as Roots or None; None after a failed check."""
    tag = name.replace(" ", "_")
    words = [collide.file(tag + "_moving", moving, moving.suffix), collide.file(tag, motion, ".json"), collide.file(tag + "_fixed", fixed, fixed.suffix)]
    if frame is not None:
        words += ["--motion-of-fixed", collide.file(tag + "_frame", frame, ".json")]
    words += ["--clearance", str(clearance)] if clearance else []
    out = collide.graze.call("collide", *words, "--motion-error", str(error), "--format", "json")
    if out.returncode not in (0, 1):
        collide.checks.fail(name, error, f"exit {out.returncode}: {out.stderr.strip()[:300]}")
        return None
    record = json.loads(out.stdout)
    first = record.pop("first")
    expected = {"motion_error": str(error), **({"clearance": str(clearance)} if clearance else {})}
    collide.checks.equal((record, sorted(first), out.returncode), (expected, ["high", "low"], int(first["low"] is not None)), name, "record")
    return first["low"], first["high"]


def as_root(x):
    return x if isinstance(x, Root) or x is None else Root(value=F(x))


def is_before(x, y):
    """x <= y for TIMEs; None is after all."""
    return y is None or (x is not None and compare(time_root(x), time_root(y)) <= 0)


def check_nested(checks, name, wider, narrower):
    checks.holds(is_before(wider[0], narrower[0]) and is_before(narrower[0], narrower[1]) and is_before(narrower[1], wider[1]), name, "nested",
                 wider, narrower)


def check_scene(collide, checks, name, moving, motion, fixed, error, low, high, clearance, frame):
    found = bounds(collide, name, moving, motion, fixed, error, clearance, frame)
    if found is None:
        return
    for got, want, side in zip(found, (as_root(low), as_root(high)), ("low", "high")):
        checks.holds(got is None if want is None else got is not None and time_is(got, want), name, side, got)
    # Half and twice the error.
    narrow, wide = (bounds(collide, name + tag, moving, motion, fixed, factor * error, clearance, frame) for tag, factor in ((" half", F(1, 2)), (" twice", 2)))
    if narrow and wide:
        check_nested(checks, name, found, narrow)
        check_nested(checks, name, wide, found)
    check_laws(collide, checks, name, (moving, motion, fixed), error, found, clearance, frame)


def check_laws(collide, checks, name, parts, error, found, clearance, frame=None):
    """low is the first contact at R + ETA, high that in I at R - ETA >= 0."""
    first = collide.ask(name, *parts, "--first", "--clearance", str(clearance + error), motion_of_fixed=frame)
    if first is not None:
        checks.equal(found[0], first.first and first.first["from"], name, "low")
    if clearance >= error:
        full = collide.ask(name, *parts, "--clearance", str(clearance - error), motion_of_fixed=frame)
        if full is not None:
            checks.equal(found[1], first_inside(full), name, "high")


def first_inside(answer):
    """The time at which the first I begins, or None."""
    if answer.word[0] == "I":
        return answer.first["from"]
    at = answer.word.find("I")
    return None if at < 0 else answer.contacts[answer.word[:at].count("B") - 1]["to"]


# ------------------------------------------------------------------------------------------ random motions near others

def small_vector(rng, d, error):
    """A vector of a length of at most `error`, often near it."""
    while True:
        v = [F(rng.randint(-8, 8), 8) for _ in range(d)]
        if sum(x * x for x in v) <= 1:
            return [x * error for x in v]


def deformation(rng, moving, error):
    """A matrix 1 + E with |E x| <= error at all vertices, so everywhere in their hull."""
    d = moving.dimension
    e = [[F(rng.randint(-8, 8), 8) for _ in range(d)] for _ in range(d)]
    most = max(sum(abs(sum(row[j] * x[j] for j in range(d))) for row in e) for x in moving.vertices)  # |v|_1 >= |v|_2
    factor = error / most if most else 0
    return matrix([[[e[i][j] * factor + (i == j)] for j in range(d)] + [[]] for i in range(d)], [1])


def motions(rng, moving, error):
    """M, and some motions within the error of it: displaced, by a constant, a line or a parabola, or deformed first."""
    d = moving.dimension
    polys = [[F(rng.randint(-9, 9), 3) - F(b, 2), F(b), F(rng.randint(-4, 4)) * rng.randint(0, 1)] for b in (rng.randint(-20, 20) for _ in range(d))]
    turn = rng.choice([[], [rotation([0, 1])] if d == 2 else [rotation([0, 1], axis=[1, 2, 2], length=3)]])
    near = []
    for k in range(4):
        v = small_vector(rng, d, error)
        shape = [[1], [1, -2], [0, 0, 1], [0, 4, -4]][k]  # at most 1 in absolute value on [0, 1]
        way = [[a + x * (shape + [0, 0])[i] for i, a in enumerate(p)] for p, x in zip(polys, v)]
        near.append(build([(0, 1, compose(*turn, translate(way)))]))
    for _ in range(2):
        near.append(build([(0, 1, compose(deformation(rng, moving, error), *turn, translate(polys)))]))
    return build([(0, 1, compose(*turn, translate(polys)))]), near


def is_between(found, time):
    """The first contact of a motion, or None, is not before low, and not after high."""
    return is_before(found[0], time) and is_before(time, found[1])


def one_pair(collide, checks, name, rng, d, tally):
    moving, fixed = solid(rng, d, rng.choice([1, 1, 2])), solid(rng, d, 1)
    error, clearance = F(rng.randint(1, 8), 16), rng.choice([F(0), F(0), F(0), F(1, 4), F(1)])
    motion, near = motions(rng, moving, error)
    found = bounds(collide, name, moving, motion, fixed, error, clearance)
    if found is None:
        return
    tally["none" if found[0] is None else "low alone" if found[1] is None else "both"] += 1
    check_laws(collide, checks, name, (moving, motion, fixed), error, found, clearance)
    for k, other in enumerate([motion] + near):
        answer = collide.ask(f"{name} {k}", moving, other, fixed, "--clearance", str(clearance))
        if answer is None:
            continue
        touch, inside = answer.first and answer.first["from"], first_inside(answer)
        checks.holds(is_between(found, touch) and is_between(found, inside), name, k, found, touch, inside)
        tally["motions"] += 1


def forms(collide, checks):
    """The text, and a row of a log; all errors, nested."""
    words = [collide.file("text" + tag, thing, end) for tag, thing, end in (("a", CUBE, ".off"), ("m", along_x(0, 3), ".json"), ("b", WALL, ".off"))]
    for error, status, text in (("1/4", 1, "first contact between 7/4 (1.75) and 9/4 (2.25)"), ("0.5", 1, "first contact between 3/2 (1.5) and none"),
                                ("0", 1, "first contact between 2 and 2")):
        out = collide.graze.call("collide", *words, "--motion-error", error)
        checks.equal((out.stdout, out.returncode), (text + "\n", status), "text", error)
    away = collide.file("away", along_x(0, 1), ".json")
    out = collide.graze.call("collide", words[0], away, words[2], "--motion-error", "1/4")
    checks.equal((out.stdout, out.returncode), ("first contact between none and none\n", 0), "text")
    for name, moving, motion, fixed in (("cubes", CUBE, along_x(0, 9), block(3, -9, -9, 20, 9, 9)), ("ridges", ROOF, moved(0, 2, [0], [0], [-1, 1]), UPSIDE_DOWN),
                                        ("a bar", plane(BAR), TURN, plane(POST))):
        all_of = [bounds(collide, name, moving, motion, fixed, e) for e in ERRORS]
        for narrower, wider in zip(all_of, all_of[1:]):
            if narrower and wider:
                check_nested(checks, name, wider, narrower)


def many_facets(collide, checks):
    """A prism of 514 facets, some of whose vertices give points: its floor z = 2 - t comes to the plate's top z = 0 over all of its middle."""
    n = 512
    at = [(F(1 - k * k, 1 + k * k) * 4, F(2 * k, 1 + k * k) * 4) for k in (F(2 * i - n, n) * 3 for i in range(n))]
    points = [(x, y, F(z)) for z in (2, 3) for x, y in at]
    sides = [[k, (k + 1) % n, n + (k + 1) % n, n + k] for k in range(n)]
    prism = Mesh(points, [list(range(n))[::-1], [n + k for k in range(n)], *sides])
    found = bounds(collide, "many facets", prism, moved(0, 4, [0], [0], [0, -1]), block(-9, -9, -2, 9, 9, 0), F(1, 8))
    checks.equal(found, ("15/8", "17/8"), "many facets")


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    collide = Collide(args, checks)
    if args.derived:
        for one in SCENES:
            check_scene(collide, checks, *one)
        forms(collide, checks)
        many_facets(collide, checks)
    for d, count in PAIRS.items():
        for k in args.rounds(count, str(d)):
            one_pair(collide, checks, f"{d} {k}", args.random, d, tally)
    print(f"{len(SCENES)} pairs by hand; random: {dict(tally)}")
    checks.finish()


if __name__ == "__main__":
    main()
