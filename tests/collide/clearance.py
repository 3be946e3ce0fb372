# suite
"""Pairs at a clearance whose words and times are derived by hand, in the plane and in space; cells by nearest points.

SPDX-License-Identifier: GPL-3.0-or-later

S is the moving solid, Q the fixed one, b the translation, R the clearance. Above each scene stands its derivation: the distance of S and Q, which is R at
the times given. A contact is (from, to), with the number of pairs of cells by type where that is told. At rational times the names of all
pairs are compared with those that nearest points give (nearness.py). A clearance of 0 changes no byte of any pair of hand.py.
"""
from collections import Counter

from nearness import near_cells
from exact import Fraction as F, to_double
from hand import (CUBE, DIAMOND, FULL_FACE, FULL_TURN, HOLLOW, INSIDE, OCTA, PLATE, ROOF, ROOM, SCENES, SLAB, SPIKE, SQUARE, TINY,
                  UPSIDE_DOWN, WALL, moved, plane, root, sides_of)
from pairs import Checks, Collide, cell_pairs, first_agrees, kind_of, options, time_is

from algebra import Root  # noqa: E402
from motion import build, compose, legs, matrix, scaling, translate, turn  # noqa: E402
from solids import block, box_ring, joined, prism, ring  # noqa: E402

NEAR = []


def near(name, moving, motion, fixed, clearance, word, *contacts, frame=None, flags=()):
    NEAR.append((name, moving, motion, fixed, F(clearance), word, contacts, frame, flags))


def along_x(low, high, y=0, z=0):
    return moved(low, high, [0, 1], [y], [z])


# ------------------------------------------------------------------------------- faces, edges, corners

# S = [t, t + 1] x [0, 1]^2 and Q = [3, 4] x [0, 1]^2: their distance is 2 - t before 2, t - 4 after 4
near("a face comes to a face", CUBE, along_x(0, 6), WALL, F(1, 2), "OBIBO", (F(3, 2), F(3, 2), FULL_FACE), (F(9, 2), F(9, 2), FULL_FACE))
near("a face ends at a face", CUBE, along_x(0, F(3, 2)), WALL, F(1, 2), "OB", (F(3, 2), F(3, 2), FULL_FACE))
near("a face begins at a face", CUBE, moved(0, 1, [F(3, 2), -1], [0], [0]), WALL, F(1, 2), "BO", (0, 0, FULL_FACE))
near("a face comes and goes", CUBE, moved(0, 2, [F(3, 2), -2, 1], [0], [0]), WALL, F(1, 2), "BOB", (0, 0), (2, 2))
near("far enough", CUBE, along_x(0, 1), WALL, F(1, 2), "O")
near("near all the time", CUBE, along_x(2, 4), WALL, F(1, 2), "I")
# R from 2^-1100 to 2^300, past all doubles that bound it
for tag, r in (("tiny", F(1, 2 ** 1100)), ("large", F(1000)), ("huge", F(2 ** 300)), ("large enough", F(2 ** 400))):
    near(f"a {tag} clearance", CUBE, along_x(2 - 2 * r, 2), WALL, r, "OBI", (2 - r, 2 - r, FULL_FACE))
# In the plane Q = [3, 4] x [2, 3]: the corners (t + 1, 1) and (3, 2) are ((2 - t)^2 + 1)^(1/2) apart until t = 2, then the
# parallel sides are 1 apart until t = 4. R = 1: B from 2 to 4. R = 5/4: 2 - t = 3/4. R = 3/2: (2 - t)^2 = 5/4.
SHELF = plane(box_ring(3, 2, 4, 3))
GLIDE = moved(0, 6, [0, 1], [0])
near("a slide at the clearance", SQUARE, GLIDE, SHELF, 1, "OBO", (2, 4, {"vertex-vertex": 1}))
near("a slide 2^-60 too far", SQUARE, GLIDE, SHELF, 1 - TINY, "O")
# (2 - t)^2 = 2 e + e^2 for R = 1 + e: 2^120 t^2 - 2^122 t + 2^122 - 2^61 - 1
near("a slide 2^-60 too near", SQUARE, GLIDE, SHELF, 1 + TINY, "OBIBO", *[
    (root([m * m * 2 ** 120 - 2 ** 61 - 1, -m * 2 ** 121, 2 ** 120], *ends),) * 2 for m, ends in ((2, (1, 2)), (4, (4, 5)))])
near("a Pythagorean corner", SQUARE, GLIDE, SHELF, F(5, 4), "OBIBO", (F(5, 4), F(5, 4), {"vertex-vertex": 1}),
     (F(19, 4), F(19, 4), {"vertex-vertex": 1}))
near("a corner at roots", SQUARE, GLIDE, SHELF, F(3, 2), "OBIBO", (root([11, -16, 4], 0, 2),) * 2, (root([59, -32, 4], 4, 6),) * 2)
# in space: gaps of y and z of 2 and 2, R = 3: the gap of x is 1 at t = 1 and 5, and 8 < 9 between; of 3 and 4, R = 5: two parallel
# edges along x are 5 apart from 2 to 4
near("a corner past a corner", CUBE, along_x(0, 6), block(3, 3, 3, 4, 4, 4), 3, "OBIBO", (1, 1, {"vertex-vertex": 1}), (5, 5, {"vertex-vertex": 1}))
near("an edge along an edge", CUBE, along_x(0, 6), block(3, 4, 5, 4, 5, 6), 5, "OBO", (2, 4, {"vertex-vertex": 1}))
# S on its way over Q = [2, 4] x [0, 1]^2 at height R over it: B while [t, t + 1] meets [2, 4]; first along an edge
near("faces slide at the clearance", CUBE, moved(0, 6, [0, 1], [0], [F(4, 3)]), block(2, 0, 0, 4, 1, 1), F(1, 3), "OBO",
     (1, 4, {"edge-edge": 1, "vertex-vertex": 2}))
near("faces slide 2^-60 too far", CUBE, moved(0, 6, [0, 1], [0], [F(4, 3) + TINY]), block(2, 0, 0, 4, 1, 1), F(1, 3), "O")
# askew, and then down into it: at x = 2 on leg 1 to 2 it is 1/3 over Q, and goes down from t = 2
near("a slide that dives", CUBE, legs([(F(1, 3), 0, F(4, 3)), (F(7, 3), 0, F(4, 3)), (F(7, 3), 0, 0)]), block(2, 0, 0, 4, 1, 1), F(1, 3), "OBI",
     (F(1, 3), 1, {"edge-edge": 1, "vertex-vertex": 2}))
# the octahedron's vertex 5 is at height R + t^2, and R + t^2 - e^2, over the slab
near("a vertex grazes", OCTA, moved(-1, 1, [0, 1], [0], [F(3, 2), 0, 1]), SLAB, F(1, 2), "OBO", (0, 0, {"vertex-facet": 1}))
near("a vertex grazes 2^-120 too deep", OCTA, moved(-1, 1, [0, 1], [0], [F(3, 2) - TINY ** 2, 0, 1]), SLAB, F(1, 2), "OBIBO",
     (-TINY, -TINY, {"vertex-facet": 1}), (TINY, TINY, {"vertex-facet": 1}))
# S = |x - t| + |y - 3| <= 1 over Q = |x| + |y| <= 1: the tips (t, 2) and (0, 1) are nearest while |t| <= 1. R = 1: at 0; R = 5/4: at 3/4
OVER = moved(-1, 1, [0, 1], [3])
near("tip over tip", DIAMOND, OVER, DIAMOND, 1, "OBO", (0, 0, {"vertex-vertex": 1}))
near("tip past tip", DIAMOND, OVER, DIAMOND, F(5, 4), "OBIBO", *[(t, t, {"vertex-vertex": 1}) for t in (F(-3, 4), F(3, 4))])

# ----------------------------------------------------------------------------------- edges against edges

# the ridges (hand.py) at heights t - 2 and 0: EE alone
near("crossed ridges", ROOF, moved(0, 2, [0], [0], [-2, 1]), UPSIDE_DOWN, F(1, 2), "OBI", (F(3, 2), F(3, 2), {"edge-edge": 1}))
# 1/2 apart while the ridge x = t passes that of |x| <= 3; beyond, the vertex is further away than 1/2
near("crossed ridges slide", ROOF, moved(-4, 4, [0, 1], [0], [F(-1, 2)]), UPSIDE_DOWN, F(1, 2), "OBO", (-3, 3, {"edge-vertex": 1}))
# half a turn about the common perpendicular, parallel at a quarter: always 1/2 apart
near("crossed ridges turn", ROOF, build([(0, 2, compose(turn(2, axis=[0, 0, 1], length=1), translate([[0], [0], [F(-1, 2)]])))]),
     UPSIDE_DOWN, F(1, 2), "B", (0, 2, {"edge-edge": 1}))
# The edge of a wedge from (c, s, -1) to (c, -s, 1), c^2 + s^2 = 1, s = 2 t / (1 + t^2): its ends are always 1 from the edge x = y = 0 of Q,
# its middle c away, so nearer than 1 but at t = 0, where both edges are parallel and all of it is at distance 1
WEDGE = prism(ring((0, 0), (5, -1), (5, 1)), -1, 1)
SHEAR = build([(F(-1, 2), F(1, 2), matrix([[[1, 0, 1], [], [], [1, 0, -1]], [[], [1, 0, 1], [0, -2], []], [[], [], [1, 0, 1], []]], [1, 0, 1]))])
near("an edge twists on a cylinder", WEDGE, SHEAR, prism(ring((0, 0), (-5, 1), (-5, -1)), -3, 3), 1, "IBI",
     (0, 0, {"edge-edge": 1, "vertex-edge": 2}))
# c = (1 - t^2) / (1 + t^2) is R = (2^60 - 1) / (2^60 + 1) at 2^-30 to both sides; between, the edges are parallel and farther away
near("an edge twists 2^-59 outside a cylinder", WEDGE, SHEAR, prism(ring((0, 0), (-5, 1), (-5, -1)), -3, 3), F(2 ** 60 - 1, 2 ** 60 + 1), "IBOBI",
     *[(t, t, {"edge-edge": 1}) for t in (F(-1, 2 ** 30), F(1, 2 ** 30))])

# ------------------------------------------------------------------------ through, in, and around

# a bar's edges pierce a wall whose borders are far away: no features are nearest anywhere
near("a bar through a wall", block(-10, 0, 0, 10, 1, 1), moved(0, 9, [0], [0, 1], [0]), block(0, -50, -50, 1, 51, 51), F(1, 4), "I")
# its end at x = -12 + 2 t comes to the wall x = 0 at 1/4 when t = 47/8, within that face; through at t = 6
near("a bar comes to a wall", block(-20, 0, 0, -12, 1, 1), moved(0, 9, [0, 2], [0], [0]), block(0, -50, -50, 1, 51, 51), F(1, 4), "OBI",
     (F(47, 8), F(47, 8), {"facet-facet": 1, "edge-facet": 4, "vertex-facet": 4}))
near("deep inside", CUBE, moved(0, 1, [8, 1], [8], [8]), block(0, 0, 0, 20, 20, 20), F(1, 4), "I")
near("deep around", block(0, 0, 0, 20, 20, 20), moved(0, 1, [0, 1], [0], [0]), block(9, 9, 9, 10, 10, 10), F(1, 4), "I")
# A cube [x, x + 1] x [3/2, 5/2]^2 in the cavity [1, 3]^3, x = (3 + t)/2: 1/2 from four walls, (1 - t)/2 from the wall x = 3
NESTED = moved(0, 1, [F(3, 2), F(1, 2)], [F(3, 2)], [F(3, 2)])
near("in a cavity", CUBE, NESTED, HOLLOW, F(1, 4), "OBI", (F(1, 2), F(1, 2)))
near("in a cavity of exact size", CUBE, NESTED, HOLLOW, F(1, 2), "BI", (0, 0))
near("at rest in a cavity", CUBE, moved(0, 1, [F(3, 2)], [F(3, 2)], [F(3, 2)]), HOLLOW, F(1, 2), "B", (0, 1))
# A needle [11/4, 13/4]^2 goes down through the hole [2, 4]^2 of a plate, 3/4 from all its walls: from where its floor 2 - t is at z = 1 until
# its top 5 - t is at z = 0; its floor's corners are 3/4 from two edges of the rim each
NEEDLE = block(F(11, 4), F(11, 4), 2, F(13, 4), F(13, 4), 5)
near("a needle in a pinhole", NEEDLE, moved(0, 7, [0], [0], [0, -1]), PLATE, F(3, 4), "OBO", (1, 5, {"edge-edge": 4, "vertex-edge": 8}))
near("a needle in a hole", NEEDLE, moved(0, 7, [0], [0], [0, -1]), PLATE, F(3, 4) - TINY, "O")
# Two posts at x <= 0 and x >= 5 and [t, t + 1] between: 1 from one at t = 1, from the other at t = 3
POSTS = joined(block(-1, 0, 0, 0, 1, 1), block(5, 0, 0, 6, 1, 1))
near("from post to post", CUBE, along_x(0, 4), POSTS, 1, "IBOBI", (1, 1, FULL_FACE), (3, 3, FULL_FACE))
# 2 from both at t = 2 alone, else nearer to one of them
near("between two posts", CUBE, along_x(1, 3), POSTS, 2, "IBI", (2, 2, {"facet-facet": 2, "edge-edge": 8, "vertex-vertex": 8}))
near("too near to both posts", CUBE, along_x(1, 3), POSTS, 2 + TINY, "I")

# ------------------------------------------------------------------------------ turns, growth, mirrors

# the spike's tip, 5 from the centre, points at the wall x <= -11/2 after half a turn
near("a full turn past a wall", SPIKE, FULL_TURN, plane(box_ring(-8, -2, F(-11, 2), 2)), F(1, 2), "OBO", (2, 2, {"vertex-edge": 1}))
near("a full turn 2^-60 too far", SPIKE, FULL_TURN, plane(box_ring(-8, -2, F(-11, 2), 2)), F(1, 2) - TINY, "O")
# the side x = 1 + t of [-1, 1]^3 times 1 + t, and x = 3
near("a growing cube", block(-1, -1, -1, 1, 1, 1), build([(0, 2, scaling([[1, 1]] * 3))]), block(3, 0, 0, 4, 1, 1), F(1, 2), "OBI", (F(3, 2), F(3, 2)))
# times 1 + t along x alone: no similarity
near("a cube that grows one way", block(-1, -1, -1, 1, 1, 1), build([(0, 2, scaling([[1, 1], [1], [1]]))]), block(3, 0, 0, 4, 1, 1), F(1, 2), "OBI",
     (F(3, 2), F(3, 2)))
# mirrored, [t - 1, t]: 3 - t is 1/2 at 5/2
near("a mirrored square", SQUARE, build([(0, 4, compose(scaling([[-1], [1]]), translate([[0, 1], [0]])))]), plane(box_ring(3, 0, 4, 1)), F(1, 2), "OBI",
     (F(5, 2), F(5, 2), {"edge-edge": 1, "vertex-vertex": 2}))

# --------------------------------------------------------------------------- both move; margins of a room

# [t, t + 1] and [6 - t, 7 - t]: 5 - 2 t is 1 at t = 2
near("two cubes towards each other", CUBE, along_x(0, 3), block(6, 0, 0, 7, 1, 1), 1, "OBI", (2, 2, FULL_FACE), frame=moved(0, 3, [0, -1], [0], [0]))
near("two cubes side by side", CUBE, along_x(0, 9), block(0, 2, 0, 1, 3, 1), 1, "B", (0, 9, FULL_FACE), frame=along_x(0, 9))
# Q = [-1, 1]^3 grows by 1 + t, and its distance from x = 3 falls: 2 - t is 1/2 at 3/2; then its parts at 1/2 of one piece's way
GROWN = build([(0, 1, scaling([[1, 1]] * 3)), (1, 4, scaling([[1, 1]] * 3))])
near("a frame that grows", block(3, 0, 0, 4, 1, 1), moved(0, 2, [0], [0], [0]), block(-1, -1, -1, 1, 1, 1), F(1, 2), "OBI", (F(3, 2), F(3, 2)), frame=GROWN)
# S = [x, x + 1] x [1, 2]^2 in [0, 4]^3: x = 1 + t has the margin 1/2 at t = 3/2; x = 1 + 3 (2 t - t^2)/2 is 5/2 at most, at t = 1
near("the margin of a room", CUBE, moved(0, 3, [1, 1], [1], [1]), ROOM, F(1, 2), "OBI", (F(3, 2), F(3, 2)), flags=INSIDE)
near("to the margin of a room", CUBE, moved(0, 2, [1, 3, F(-3, 2)], [1], [1]), ROOM, F(1, 2), "OBO", (1, 1), flags=INSIDE)
near("out of a room", CUBE, along_x(8, 9, 1, 1), ROOM, F(1, 2), "I", flags=INSIDE)
near("well inside a room", CUBE, moved(0, 1, [1, 1], [1], [1]), ROOM, F(1, 2), "O", flags=INSIDE)


# ---------------------------------------------------------------------------------------- checks

def check_contact(checks, got, want, sides, name, parts):
    low, high, *counts = want
    moving, motion, fixed, frame, clearance = parts
    for key, t in (("from", low), ("to", high)):
        t = t if isinstance(t, Root) else Root(value=F(t))
        checks.holds(time_is(got[key], t), name, key, got[key], to_double(t))
    checks.equal(got["kind"], kind_of(*sides), name, "kind")
    if counts:
        checks.equal(Counter(x["type"] for x in got["cells"]), Counter(counts[0]), name, "types")
    if not isinstance(low, Root):
        checks.equal(cell_pairs(got), near_cells(moving, motion, fixed, F(low), clearance ** 2, frame), name, "cells")


def check_near(collide, checks, name, moving, motion, fixed, clearance, word, contacts, frame, flags):
    flags = ("--clearance", str(clearance), *flags)
    full = collide.ask(name, moving, motion, fixed, *flags, motion_of_fixed=frame)
    if full is None or not checks.equal(full.word, word, name, "word"):
        return
    checks.equal(full.record["clearance"], str(clearance), name, "clearance")
    for got, want, sides in zip(full.contacts, contacts, sides_of(word)):
        check_contact(checks, got, want, sides, name, (moving, motion, fixed, frame, clearance))
    first = collide.ask(name, moving, motion, fixed, "--first", *flags, motion_of_fixed=frame)
    if first is not None:
        first_agrees(checks, first, full, name)
    collide.ask(name, moving, motion, fixed, "--ask", "overlap", *flags, motion_of_fixed=frame)


def same_at_zero(collide, checks, name, moving, motion, fixed, word, contacts, frame, flags):
    """Without the option, and with a clearance of 0."""
    files = [collide.file("zero" + tag, thing, end) for tag, thing, end in (
        ("a", moving, moving.suffix), ("m", motion, ".json"), ("b", fixed, fixed.suffix))]
    more = ["--motion-of-fixed", collide.file("zerof", frame, ".json")] if frame else []
    plain, zero = (collide.graze.call("collide", *files, *more, *flags, "--format", "json", *r) for r in ((), ("--clearance", "0.0")))
    checks.equal((zero.returncode, zero.stdout), (plain.returncode, plain.stdout), name, "clearance 0")


def text(collide, checks):
    """The clearance follows the verdict, in lowest terms; exit statuses as without."""
    cube, wall = (collide.file(name, thing, ".off") for name, thing in (("cube", CUBE), ("wall", WALL)))
    for low, high, flags, status, told in ((0, 6, (), 1, "overlap at clearance 1/2"), (0, F(3, 2), (), 1, "touch at clearance 1/2"),
                                           (0, 1, (), 0, "clear at clearance 1/2"), (0, 6, ("--first",), 1, "meets at clearance 1/2"),
                                           (0, F(3, 2), ("--ask", "overlap"), 0, "touch at clearance 1/2")):
        way = collide.file("way", along_x(low, high), ".json")
        out = collide.graze.call("collide", cube, way, wall, "--clearance", "0.50", *flags)
        checks.equal((out.returncode, out.stdout.splitlines()[0]), (status, told), "text", low, high, *flags)
    room = collide.file("room", ROOM, ".off")
    way = collide.file("way", moved(0, 3, [1, 1], [1], [1]), ".json")
    out = collide.graze.call("collide", cube, way, room, "--clearance", "0.5", "--inside")
    checks.equal((out.returncode, out.stdout.splitlines()[0]), (1, "leaves at 3/2 (1.5) at clearance 1/2"), "text")


def refusals(collide, checks):
    """Negative clearances, and frames that keep no ratios of distances, are refused by name."""
    cube, wall = (collide.file(name, thing, ".off") for name, thing in (("cube", CUBE), ("wall", WALL)))
    way = collide.file("way", along_x(0, 6), ".json")
    frame = collide.file("frame", build([(0, 6, scaling([[1, 1], [1], [1]]))]), ".json")
    for words, status, says in (
            (("--clearance", "-1/3"), 2, "graze: --clearance -1/3: expected a number from 0 up, such as 0.001 or 1e-6"),
            (("--clearance", "1/3", "--motion-of-fixed", frame), 3,
             "graze: piece 0 of the fixed solid's motion changes ratios of distances; expected similarities where there is a clearance")):
        out = collide.graze.call("collide", cube, way, wall, *words)
        checks.equal((out.returncode, out.stderr.splitlines()[0]), (status, says), *words)
    # [t, t + 1] never meets [3 + 3 t, 4 + 4 t]
    checks.equal(collide.graze.call("collide", cube, way, wall, "--motion-of-fixed", frame).returncode, 0, "frame without clearance")


def main():
    args = options(__doc__.splitlines()[0], ("--only", {"default": "", "help": "pairs whose name contains this text"}))
    checks = Checks()
    collide = Collide(args, checks)
    for one in NEAR:
        if args.only in one[0]:
            check_near(collide, checks, *one)
    if not args.only:
        for one in SCENES:
            same_at_zero(collide, checks, *one)
        text(collide, checks)
        refusals(collide, checks)
    print(f"{len(NEAR)} pairs")
    checks.finish()


if __name__ == "__main__":
    main()
