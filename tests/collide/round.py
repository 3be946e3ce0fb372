# suite
"""Balls, capsules, disks and unions of them against solids and one another: by hand, and by the trace of a centre.

SPDX-License-Identifier: GPL-3.0-or-later

Scenes have a derivation above them, as in clearance.py. Random scenes: a ball moves as its centre does through the solid that the fixed one, grown
by the radius, is, a union of capsules about its edges and of itself grown along its normals; `graze classify` traces that point. So does a
capsule, grown by a fixed ball's radius, over the ball's centre. Words and exact times are equal. A union is in the largest state of its parts.
"""
import json

from meeting import Piece  # noqa: F401  (finds the folders of the others)
from exact import Fraction as F
from clearance import check_contact
from hand import FULL_TURN, INSIDE, PLATE, ROOF, ROOM, SLAB, SQUARE, WALL, moved, plane, root, sides_of
from pairs import Checks, Collide, agrees, first_agrees, larger, options, time_is, together, trace_of

from algebra import Root  # noqa: E402
from motion import build, compose, matrix, rotation, scaling, translate, turn  # noqa: E402
from solids import block, box_ring  # noqa: E402

BALLS, DISKS, CAPSULES, UNIONS = 24, 20, 12, 6


class Round:
    """A union of balls and capsules: (ends, radius) of each."""
    suffix = ".csg.json"

    def __init__(self, *bodies):
        self.bodies, self.dimension = bodies, len(bodies[0][0][0])
        self.vertices = [tuple(F(x) for x in p) for ends, _ in bodies for p in ends]
        self.edges = [(0, 1)] if len(self.vertices) == 2 and len(bodies) == 1 else []

    def mapped(self, f):
        out = Round(*self.bodies)
        out.vertices = [f(p) for p in self.vertices]
        return out

    def nodes(self, grown=0):
        def text(p):
            return [str(x) for x in p]
        return [{"ball": {"center": text(ends[0]), "radius": str(r + grown)}} if len(ends) == 1 else
                {"capsule": {"point": text(ends[0]), "axis": text(b - a for a, b in zip(*ends)), "radius": str(r + grown)}}
                for ends, r in self.bodies]

    def text(self):
        nodes = self.nodes()
        return json.dumps({"dimension": self.dimension, "solid": nodes[0] if len(nodes) == 1 else {"union": nodes}})


def ball(radius, *center):
    return Round(([tuple(map(F, center))], F(radius)))


def capsule(radius, one, other):
    return Round(([tuple(map(F, one)), tuple(map(F, other))], F(radius)))


class Offset:
    """A node in a dimension, as a file."""
    suffix = ".csg.json"

    def __init__(self, dimension, node):
        self.dimension, self.node = dimension, node

    def text(self):
        return json.dumps({"dimension": self.dimension, "solid": self.node})


SCENES = []


def scene(name, moving, motion, fixed, rho, word, *contacts, clearance=0, frame=None, flags=()):
    """`rho` is the sum of radii and clearance at the contacts' rational times, by which cells are found; None where it varies."""
    SCENES.append((name, moving, motion, fixed, rho, word, contacts, F(clearance), frame, flags))


# ------------------------------------------------------------------------------------- a ball and a block

def through(y, z):
    return moved(0, 7, [0, 1], [y], [z])


# WALL is [3, 4] x [0, 1]^2; the centre is (t, y, z)
B, H = ball(1, 0, 0, 0), F(1, 2)
scene("a ball comes to a face", ball(H, 0, 0, 0), through(H, H), WALL, H, "OBIBO", (F(5, 2), F(5, 2), {"vertex-facet": 1}),
      (F(9, 2), F(9, 2), {"vertex-facet": 1}))
scene("a ball and a clearance", ball(F(1, 3), 0, 0, 0), through(H, H), WALL, H, "OBIBO", (F(5, 2), F(5, 2)), (F(9, 2), F(9, 2)), clearance=F(1, 6))
# (3 - t)^2 + 9/25 = 1; (3 - t)^2 + 1/4 = 1; (3 - t)^2 + 4/9 + 4/9 = 1
scene("a ball past an edge", B, through(F(-3, 5), H), WALL, 1, "OBIBO", (F(11, 5), F(11, 5), {"vertex-edge": 1}), (F(24, 5), F(24, 5)))
scene("a ball past an edge at roots", B, through(-H, H), WALL, 1, "OBIBO", (root([33, -24, 4], 2, 3),) * 2, (root([61, -32, 4], 4, 5),) * 2)
scene("a ball past a corner", B, through(F(-2, 3), F(-2, 3)), WALL, 1, "OBIBO", (F(8, 3), F(8, 3), {"vertex-vertex": 1}), (F(13, 3), F(13, 3)))
# at distance 1 from the face y = 0 while its foot is in it; 4/5 from the edge y = z = 0 in z, 3/5 in y
scene("a ball rolls along a face", B, through(-1, H), WALL, 1, "OBO", (3, 4, {"vertex-edge": 1}))
scene("a ball rolls along an edge", B, through(F(-3, 5), F(-4, 5)), WALL, 1, "OBO", (3, 4, {"vertex-vertex": 1}))
scene("a ball passes 2^-60 too far", B, through(-1 - F(1, 2 ** 60), H), WALL, 1, "O")
# z = 1 - t over the slab [-1, 0]: at 1/2; at t = 3/2 its centre is 1/2 deep, from both faces
scene("a ball dives", ball(H, 0, 0, 1), moved(0, F(3, 2), [0], [0], [0, -1]), SLAB, H, "OBI", (H, H, {"vertex-facet": 1}))
# the hole [2, 4]^2 of a plate of height 1 has inradius 1: B while the centre (3, 3, 3 - t) is in it
scene("a ball in a pinhole", B, moved(0, 5, [3], [3], [3, -1]), PLATE, 1, "OBO", (2, 3, {"vertex-edge": 4}))
# the room's walls are at 0 and 4: 1 + t + 1/2 = 4, and 1/2 before with a margin, which the centre's x = 1 has too
scene("a ball in a room", ball(H, 0, 2, 2), moved(0, 3, [1, 1], [0], [0]), ROOM, H, "OBI", (F(5, 2), F(5, 2)), flags=INSIDE)
scene("a ball in a room with a margin", ball(H, 0, 2, 2), moved(0, 3, [1, 1], [0], [0]), ROOM, 1, "BOBI", (0, 0), (2, 2), clearance=H, flags=INSIDE)
scene("a wall comes to a ball", WALL, moved(0, 9, [0, -1], [0], [0]), ball(H, 0, H, H), H, "OBIBO", (F(5, 2), F(5, 2), {"facet-vertex": 1}), (F(9, 2), F(9, 2)))

# ---------------------------------------------------------------------------------------- maps of a ball

BIG_WALL = block(3, -9, -9, 4, 9, 9)
# its radius is (1 + t)/2; its centre 1 + t: 3 (1 + t)/2 = 3
scene("a ball grows", ball(H, 0, 0, 0), build([(0, 6, scaling([[1, 1]] * 3))]), BIG_WALL, 3, "OBI", (5, 5, {"vertex-facet": 1}))
scene("a ball grows away", ball(H, 1, 0, 0), build([(0, 2, scaling([[1, 1]] * 3))]), BIG_WALL, 1, "OBI", (1, 1, {"vertex-facet": 1}))
# its centre is t - 1
scene("a mirrored ball", ball(H, 1, 0, 0), build([(0, 4, compose(scaling([[-1], [1], [1]]), translate([[0, 1], [0], [0]])))]), BIG_WALL, H, "OBI",
      (F(7, 2), F(7, 2)))
# its radius is (1 - t/2)/2, its centre 4 - 2 t from the wall x <= 0: 4 - 2 t = 2 + 1/2 - t/4
scene("a ball shrinks, and a clearance", ball(H, 4, 0, 0), build([(0, 1, scaling([[1, F(-1, 2)]] * 3))]), block(-1, -9, -9, 0, 9, 9), None, "OBI",
      (F(6, 7), F(6, 7)), clearance=2)
# a fixed ball of radius 1 grows by 1 + t: 3 - (1 + t) = 1/2
scene("a frame that grows a ball", BIG_WALL, moved(0, 2, [0], [0], [0]), B, None, "OBI", (F(3, 2), F(3, 2)), clearance=H,
      frame=build([(0, 2, scaling([[1, 1]] * 3))]))
# both grow by 1 + t: 3 - 1 - 1 in the frame of the one, (3 + 3 t) - 2 (1 + t) in the world's, is R = 3/2 at 1/2
scene("two balls that grow", ball(1, 3, 0, 0), build([(0, 1, scaling([[1, 1]] * 3))]), B, None, "IBO", (H, H), clearance=F(3, 2),
      frame=build([(0, 1, scaling([[1, 1]] * 3))]))
# radius (1 + t^2)^(1/2) / 2 about the origin is 1 where t^2 = 3: a square that is rational is enough for one radius alone
SPIN = build([(0, 2, matrix([[[1], [0, -1], []], [[0, 1], [1], []]], [1]))])
scene("a disk grows irrationally", ball(H, 0, 0), SPIN, plane(box_ring(1, -9, 2, 9)), None, "OBI", (root([-3, 0, 1], 1, 2),) * 2)

# --------------------------------------------------------------------------------- round against round

# (t, 3, 0) and 0 are 5 apart at -4 and 4, 3 apart at 0
PASS = moved(-6, 6, [0, 1], [3], [0])
scene("a ball past a ball", ball(2, 0, 0, 0), PASS, ball(3, 0, 0, 0), 5, "OBIBO", *[(t, t, {"vertex-vertex": 1}) for t in (-4, 4)])
scene("a ball grazes a ball", B, PASS, ball(2, 0, 0, 0), 3, "OBO", (0, 0, {"vertex-vertex": 1}))
# 5 apart, by 3 and 4, in units of 10^13: boxes around centres are just at the sum of the radii
scene("large balls that touch", ball(25 * 10 ** 12, 0, 0, 0), moved(0, 1, [0], [0], [0]), ball(25 * 10 ** 12, 3 * 10 ** 13, 4 * 10 ** 13, 0), 5 * 10 ** 13, "B",
      (0, 1, {"vertex-vertex": 1}))
scene("a ball in a ball", B, moved(0, 1, [0, 1], [0], [0]), ball(9, 0, 0, 0), 10, "I")
# axes along y at height t - 2 and along x at 0; along z at x = t and 3, [0, 4] and [1, 9] having [1, 4] in common; in one line
scene("capsules cross", capsule(H, (0, -3, 0), (0, 3, 0)), moved(0, 2, [0], [0], [-2, 1]), capsule(H, (-3, 0, 0), (3, 0, 0)), 1, "OBI",
      (1, 1, {"edge-edge": 1}))
scene("capsules side by side", capsule(H, (0, 0, 0), (0, 0, 4)), moved(0, 7, [0, 1], [0], [0]), capsule(H, (3, 0, 1), (3, 0, 9)), 1, "OBIBO",
      (2, 2, {"edge-edge": 1, "vertex-edge": 1, "edge-vertex": 1}), (4, 4))
scene("capsules end to end", capsule(H, (0, 0, 0), (2, 0, 0)), moved(0, 4, [0, 1], [0], [0]), capsule(H, (6, 0, 0), (9, 0, 0)), 1, "OBI",
      (3, 3, {"vertex-vertex": 1}))
# A capsule from 0 to (5, 0) turns by a, tan(a/2) = t; the centre (3, 4) is at the angle p, cos p = 3/5, from its axis at distance 5 sin(p - a):
# 3 where sin(p - a) = 3/5, so sin a = 4/5 4/5 - 3/5 3/5 = 7/25, cos a = 24/25, t = 1/7
scene("a capsule turns into a disk", capsule(2, (0, 0), (5, 0)), build([(0, H, rotation([0, 1]))]), ball(1, 3, 4), 3, "OBI",
      (F(1, 7), F(1, 7), {"edge-vertex": 1}))
# over a ridge along y at height 0, its axis at height 1, parallel to the ridge at a quarter of a turn
scene("a capsule turns over an edge", capsule(1, (-2, 0, 1), (2, 0, 1)), build([(0, 2, turn(2, axis=[0, 0, 1], length=1))]), ROOF, 1, "B",
      (0, 2, {"edge-edge": 1}))
# a capsule whose axis passes through the wall, its ends far away
scene("a capsule through a wall", capsule(F(1, 8), (-30, 0, 0), (30, 0, 0)), moved(0, 1, [0, 1], [0], [0]), block(0, -50, -50, 1, 50, 50), F(1, 8), "I")

# ------------------------------------------------------------------------------------------- the plane

FRAME = plane(box_ring(0, 0, 6, 6), box_ring(2, 2, 4, 4)[::-1])
# in the hole [2, 4]^2, x = 5/2 + t: 1/2 from the left side at 0, from the right at 1
HOLED = type(FRAME)([[box_ring(0, 0, 6, 6), box_ring(2, 2, 4, 4)]])
scene("a disk in a hole", ball(H, 0, 3), moved(0, F(3, 2), [F(5, 2), 1], [0]), HOLED, H, "BOBI", (0, 0), (1, 1))
scene("a square comes to a disk", SQUARE, moved(0, 6, [0, 1], [0]), ball(H, 3, H), H, "OBIBO", (F(3, 2), F(3, 2), {"edge-vertex": 1}), (F(7, 2), F(7, 2)))
# (3, 0) turns about 0, and is at (-3, 0) after half a turn, 5/2 from x = -11/2
scene("a disk turns past a wall", ball(F(5, 2), 3, 0), FULL_TURN, plane(box_ring(-8, -2, F(-11, 2), 2)), F(5, 2), "OBO", (2, 2, {"vertex-edge": 1}))


# ---------------------------------------------------------------------------------------- checks

def check_scene(collide, checks, name, moving, motion, fixed, rho, word, contacts, clearance, frame, flags):
    flags = (*flags, *(("--clearance", str(clearance)) if clearance else ()))
    full = collide.ask(name, moving, motion, fixed, *flags, motion_of_fixed=frame)
    if full is None or not checks.equal(full.word, word, name, "word"):
        return
    for got, want, sides in zip(full.contacts, contacts, sides_of(word)):
        if rho is None:
            for key, t in zip(("from", "to"), want):
                checks.holds(time_is(got[key], t if isinstance(t, Root) else Root(value=F(t))), name, key, got[key])
        else:
            check_contact(checks, got, want, sides, name, (moving, motion, fixed, frame, F(rho)))
    first = collide.ask(name, moving, motion, fixed, "--first", *flags, motion_of_fixed=frame)
    if first is not None:
        first_agrees(checks, first, full, name)


def grown_block(low, high, r):
    """A box in space, grown along each axis, and capsules about its edges."""
    nodes, d = [], len(low)
    for k in range(d):
        a, b = [list(map(str, x)) for x in (low, high)]
        a[k], b[k] = str(low[k] - r), str(high[k] + r)
        nodes.append({"box": {"low": a, "high": b}})
        for corner in range(4):
            ends = [[(low, high)[corner >> (i - (i > k)) & 1][i] if i != k else end[k] for i in range(d)] for end in (low, high)]
            nodes += capsule(r, *ends).nodes()
    return Offset(d, {"union": nodes})


def grown_polygon(polygon, r):
    """Itself, and capsules about its edges."""
    rings = [[[str(x) for x in p] for p in ring] for ring in polygon.parts[0]]
    nodes = [{"polygon": {"points": rings[0], "holes": rings[1:]}}]
    return Offset(2, {"union": nodes + [node for a, b in polygon.edges for node in capsule(r, polygon.vertices[a], polygon.vertices[b]).nodes()]})


def some_motion(rng, d):
    polys = [[F(rng.randint(-8, 8)), F(rng.randint(-16, 16)), F(rng.randint(-10, 10)) * rng.randint(0, 1)] for _ in range(d)]
    if rng.random() < .5:
        return build([(0, 1, translate(polys))])
    spin = rotation([0, 1]) if d == 2 else rotation([0, 1], axis=[1, 2, 2], length=3)
    return build([(0, 1, compose(spin, translate(polys)))])


def some_point(rng, d):
    return tuple(F(rng.randint(-6, 6), 2) for _ in range(d))


def same_as_trace(collide, checks, name, answer, offset, motion, point, *flags):
    traced = collide.graze.classify(name + " trace", offset, motion, [point], "--columns", "all", *flags)
    if answer is None or not traced:
        return
    record = traced[0].record
    checks.equal(answer.word, record["word"], name, "word")
    checks.equal(answer.times(), [(c["from"], c["to"]) for c in record["contacts"]], name, "times")


def random_scenes(collide, checks, args):
    rng = args.random
    for k in args.rounds(BALLS, "balls"):
        low = [F(rng.randint(-5, 2)) for _ in range(3)]
        high = [x + rng.randint(1, 5) for x in low]
        center, r, name, motion = some_point(rng, 3), F(rng.randint(1, 12), rng.choice([1, 2, 5])), f"ball {k}", some_motion(rng, 3)
        answer = collide.ask(name, ball(r, *center), motion, block(*low, *high))
        same_as_trace(collide, checks, name, answer, grown_block(low, high, r), motion, center, "--operation", "unsweep")
        answer = collide.ask(name + " still", block(*low, *high), motion, ball(r / 3, *center), "--clearance", str(2 * r / 3))
        same_as_trace(collide, checks, name + " still", answer, grown_block(low, high, r), motion, center)
    for k in args.rounds(DISKS, "disks"):
        x, y, size = rng.randint(-5, 0), rng.randint(-5, 0), rng.randint(4, 7)
        hole = [box_ring(x + 1, y + 1, x + size - 1, y + 2)] * rng.randint(0, 1)
        polygon = type(FRAME)([[box_ring(x, y, x + size, y + size), *hole]])
        center, r, name, motion = some_point(rng, 2), F(rng.randint(1, 12), rng.choice([3, 5, 7])), f"disk {k}", some_motion(rng, 2)
        if hole and r == F(1, 2):
            continue        # as wide as the hole: the trace has an interior where the distance is r
        answer = collide.ask(name, ball(r, *center), motion, polygon)
        same_as_trace(collide, checks, name, answer, grown_polygon(polygon, r), motion, center, "--operation", "unsweep")
    for k in args.rounds(CAPSULES, "capsules"):
        d = rng.choice([2, 3])
        one, other = some_point(rng, d), some_point(rng, d)
        if one == other:
            continue
        center, r, s, name, motion = some_point(rng, d), F(rng.randint(1, 9), 4), F(rng.randint(1, 9), 5), f"capsule {k}", some_motion(rng, d)
        answer = collide.ask(name, capsule(r, one, other), motion, ball(s, *center))
        same_as_trace(collide, checks, name, answer, Offset(d, capsule(r + s, one, other).nodes()[0]), motion, center)
    for k in args.rounds(UNIONS, "unions"):
        one, other = ([([some_point(rng, 3) for _ in range(rng.choice([1, 2]))], F(rng.randint(1, 6), 4)) for _ in range(2)] for _ in range(2))
        if any(len(ends) == 2 and ends[0] == ends[1] for ends, _ in one + other):
            continue
        name, motion = f"union {k}", some_motion(rng, 3)
        whole, trace = collide.ask(name, Round(*one), motion, Round(*other)), None
        for i, a in enumerate(one):
            for j, b in enumerate(other):
                part = collide.ask(f"{name} {i} {j}", Round(a), motion, Round(b))
                found = trace_of(part, motion.start, motion.end)
                trace = together(trace, found, larger) if trace else found
        if whole is not None:
            agrees(checks, whole, trace, name)


def unions(collide, checks):
    """Cells of a union have the number of the ball or capsule, with vertices of its own. The second ball (0, 3, 0), of radius 1, meets
    x = 5 at t = 4, by its centre; the first one, of radius 1/2, is too far below."""
    robot = Round(([(0, 0, 0)], F(1, 2)), ([(0, 3, 0)], F(1)), ([(0, 9, 0), (0, 9, 1)], F(1)))
    answer = collide.ask("robot", robot, moved(0, 9, [0, 1], [0], [0]), block(5, 2, -1, 6, 4, 1))
    checks.equal((answer.word, answer.times()), ("OBIBO", [("4", "4"), ("7", "7")]), "robot")
    checks.equal(answer.contacts[0]["cells"], [{"moving": {"vertex": 0, "body": 1}, "fixed": {"face": 4}, "type": "vertex-facet"}], "robot")
    # the capsule's axis, z in [0, 1], is in the wall's z; its end 0 at z = 0 is within the wall, its end 1 at z = 1 on the border of the facet
    answer = collide.ask("robot arm", block(5, 8, -1, 6, 10, 1), moved(0, 9, [0, -1], [0], [0]), robot)
    checks.equal([(c["fixed"], c["type"]) for c in answer.contacts[0]["cells"]],
                 [({"edge": [0, 1], "body": 2}, "facet-edge"), ({"vertex": 0, "body": 2}, "facet-vertex"), ({"vertex": 1, "body": 2}, "edge-vertex")], "arm")
    files = [collide.file("words" + tag, thing, end) for tag, thing, end in (
        ("a", robot, ".csg.json"), ("m", moved(0, 9, [0, 1], [0], [0]), ".json"), ("b", block(5, 2, -1, 6, 4, 1), ".off"))]
    out = collide.graze.call("collide", *files).stdout.splitlines()
    checks.equal(out[2], "contact 4, intersection: vertex 0 of body 1 of MOVING with face 4", "text")
    # an affine image of a ball by a similarity, which turns and doubles lengths: radius 1 about (2, 0, 0), and OpenSCAD's file of it
    image = Offset(3, {"affine": {"matrix": [[0, -2, 0, 2], [2, 0, 0, 0], [0, 0, 2, 0]], "of": {"ball": {"radius": "1/2"}}}})
    for tag, thing in (("image", image), ("scad", collide.graze.write("image.csg", "multmatrix([[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n"
                                                            "sphere($fn = 0, $fa = 12, $fs = 2, r = 1);\n}\n"))):
        answer = collide.ask(tag, thing, moved(0, 9, [0, 1], [0], [0]), block(5, -1, -1, 6, 1, 1))
        checks.equal(answer and (answer.word, answer.times()), ("OBIBO", [("2", "2"), ("5", "5")]), tag)


def refusals(collide, checks):
    """Other curved solids, a round room, and maps that make no balls of balls are refused by name."""
    still, shear = moved(0, 1, [0], [0], [0]), build([(0, 1, matrix([[[1], [0, 1], [], []], [[], [1], [], []], [[], [], [1], []]], [1]))])
    torus = Offset(3, {"torus": {"point": [0, 0, 0], "axis": [0, 0, 1], "major": 3, "minor": 1}})
    cut = Offset(3, {"intersection": B.nodes() + B.nodes()})
    squashed = Offset(3, {"affine": {"matrix": [[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]], "of": B.nodes()[0]}})
    curved = "solid is curved and no union of balls and capsules, with rational radii; expected such a union, a polygon or a polyhedron"
    for moving, motion, fixed, flags, says in (
            (torus, still, WALL, (), "graze: the moving " + curved), (WALL, still, cut, (), "graze: the fixed " + curved),
            (WALL, still, squashed, (), "graze: the fixed " + curved),
            (WALL, still, B, ("--inside",), "graze: the fixed solid has balls or capsules, and the question is whether the moving one stays inside; "
             "expected a polygon or a polyhedron"),
            (B, shear, WALL, (), "graze: piece 0 of the motion makes no balls of balls; expected similarities for a round solid"),
            (ball(H, 0, 0), SPIN, ball(H, 5, 0), (), "graze: piece 0 of the motion multiplies lengths by an irrational factor; expected a rational one for a "
             "sum of a radius and other lengths")):
        files = [collide.file("no" + tag, thing, end) for tag, thing, end in (
            ("a", moving, moving.suffix), ("m", motion, ".json"), ("b", fixed, fixed.suffix))]
        out = collide.graze.call("collide", *files, *flags)
        checks.equal((out.returncode, out.stderr.splitlines()[:1]), (3, [says]), says)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    collide = Collide(args, checks)
    if args.start == 0:
        for one in SCENES:
            check_scene(collide, checks, *one)
        unions(collide, checks)
        refusals(collide, checks)
    random_scenes(collide, checks, args)
    print(f"{len(SCENES)} pairs by hand")
    checks.finish()


if __name__ == "__main__":
    main()
