# suite
"""`graze outline` on scenes whose area, length, components, holes and lower parts are derived by hand; refusals and limits.

SPDX-License-Identifier: GPL-3.0-or-later

Each scene stands with its derivation. A rational area must be given as that ratio; any other must lie in the enclosure, whose width is at most
the one asked for. Numbers that are no ratio are decimals of 50 digits, of pi and square roots.
"""
import json
import math
import os
import re
import sys
from decimal import Decimal, getcontext
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))

from program import Checks, Graze, options  # noqa: E402

getcontext().prec = 50
PI = Decimal("3.14159265358979323846264338327950288419716939937510")
WIDTH = Decimal("1e-12")
NEAR = 1 / 64  # of polygons
SQUARE = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"
FRAME = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))"
TETRAHEDRON = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"


def box(x, y, left=0, low=0):
    return f"POLYGON (({left} {low}, {x} {low}, {x} {y}, {left} {y}, {left} {low}))"


def motion(*transforms):
    """One piece a transform, each over a unit of time."""
    pieces = [{"t": [k, k + 1], "transform": t} for k, t in enumerate(transforms)]
    return json.dumps({"dimension": 2, "pieces": pieces})


def along(x, y):
    return {"translate": [x, y]}


def root(x):
    return Decimal(x).sqrt()


def arctan(n):
    """The angle whose tangent is 1/n, by its series."""
    return sum(Decimal((-1) ** k) / (2 * k + 1) / n ** (2 * k + 1) for k in range(60))


QUARTER = {"rotate": {"tan_half": "t"}}
SECOND_QUARTER = {"compose": [{"matrix": [["0", "-1", "0"], ["1", "0", "0"]]}, {"rotate": {"tan_half": "t - 1"}}]}
ELSEWHEN = "2*t^3/(t^3 + (1 - t)^3) - 1"
LOOP = [along("4*t", "0"), along("4", "4*(t - 1)"), along("4 - 4*(t - 2)", "4"), along("0", "4 - 4*(t - 3)")]

# name, solid, motion, operation, area, length, components, components of the interior, holes, ends of lower arcs, lower points
SCENES = [
    # A hexagon: the square, and a parallelogram of width 3 + 2 across (3, 2), over the path's length. Sides: 4, and two of the path's length.
    ("leg", SQUARE, motion(along("3*t", "2*t")), "sweep", Fraction(6), 4 + 2 * root(13), 1, 1, 0, [], 0),
    # The far corner sweeps a quarter of the disk of radius sqrt 2, between the diagonals of both ends: pi/2. Beside it are half of the first
    # square and half of the last one. A quarter of the circle, and four sides of 1.
    ("quarter turn", SQUARE, motion(QUARTER), "sweep", 1 + PI / 2, PI * root(2) / 2 + 4, 1, 1, 0, [], 0),
    # [0, 5]^2 without the open square between 1 and 4.
    ("square path", SQUARE, motion(*LOOP), "sweep", Fraction(16), Decimal(32), 1, 1, 1, [], 0),
    # Over X the path y = u^2/4 has u in [max(-4, X-1), min(4, X)]; the height is 1 + the greatest y - the least. From -4 to -3 it is
    # 5 - X^2/4, as from 4 to 5: together 23/6. From 1 to 4 it is 1 + (2X-1)/4, as from -3 to 0: 12. From 0 to 1 it is 1 + max(X, 1-X)^2/4: 55/48.
    ("parabola", SQUARE, motion(along("8*t - 4", "4*(2*t - 1)^2")), "sweep", Fraction(815, 48), None, 1, 1, 0, [], 0),
    # [0, 3/2] x [0, 1] along (u, u^2), u = -1 + 2 q, where q = t^3/(t^3 + (1 - t)^3) rises from 0 to 1. Over X u is in [X - 3/2, X] and [-1, 1]; the height is
    # 1 + the greatest u^2 - the least. The greatest is 1 but from 1/2 to 1, where it is that of X^2 and (X - 3/2)^2, together 37/96; the least is X^2
    # up to 0 and (X - 3/2)^2 from 3/2 on, together 2/3, else 0: 7/2 + 3 + 37/96 - 2/3.
    ("parabola at another speed", box("1.5", 1), motion(along(f"{ELSEWHEN}", f"({ELSEWHEN})^2")), "sweep", Decimal(199) / 32, None, 1, 1, 0, [], 0),
    # f = 3t - 5t^3 rises to 2/sqrt 5 at a = 1/sqrt 5 and falls to -2. Over X in [0, 1] t is in [0, X], over [1, 2] in [X-1, 1]. The greatest
    # values sum up to 1/4 + (1-a) 2 a and 2 a^2 + 0, the least ones to -1/5 and -2; the square's height adds 2.
    ("cubic", SQUARE, motion(along("t", "3*t - 5*t^3")), "sweep", Decimal("4.45") + 2 / root(5), None, 1, 1, 0, [], 0),
    # The intersection of [0, 4]^2 and [-1, 3] x [-2, 2].
    ("unsweep", box(4, 4), motion(along("t", "2*t")), "unsweep", Fraction(6), Decimal(10), 1, 1, 0, [], 0),
    # [0, 2]^2 and [-2, 0] x [0, 2] have a side in common.
    ("dangling side", box(2, 2), motion(along("2*t", "0")), "unsweep", Fraction(0), Decimal(0), 0, 0, 0, [((0, 0), (0, 2))], 0),
    # They have a corner in common.
    ("dangling point", box(2, 2), motion(along("2*t", "2*t")), "unsweep", Fraction(0), Decimal(0), 0, 0, 0, [], 1),
    # [0, 5] x [0, 4] without the part of the hole that is never covered, (2, 3) x (1, 3).
    ("smaller hole", FRAME, motion(along("t", "0")), "sweep", Fraction(18), Decimal(24), 1, 1, 1, [], 0),
    # [0, 6] x [0, 4]: the hole closes. (3, y) is on a side of the hole at both ends and in it between, for 1 < y < 3; a seam.
    ("seam", FRAME, motion(along("2*t", "0")), "sweep", Fraction(24), Decimal(20), 1, 1, 0, [((3, 1), (3, 3))], 0),
    # Two squares with a corner in common, at rest.
    ("corner", "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((1 1, 2 1, 2 2, 1 2, 1 1)))", motion(along("0", "0")), "sweep", Fraction(2),
     Decimal(8), 1, 2, 0, [], 0),
    # A point at distance r <= 1 covers its whole circle, from 0 to 2 pi, and meets itself on the right: a seam from the centre to (1, 0). For
    # 1 < r <= sqrt 2 angles from acos(1/r) to 2 pi - acos(1/r): the area is pi + pi - 2 times the integral of r acos(1/r), pi/4 - 1/2.
    ("half turn", box(1, 1, -1), motion(QUARTER, SECOND_QUARTER), "sweep", 1 + 3 * PI / 2, None, 1, 1, 0, [((0, 0), (1, 0))], 0),
    # At radius r the box holds angles of its own; a turn by pi/2 adds pi/2 for 2 <= r <= sqrt 10, and fills the gap of 2 acos(3/r) for r > 3. So
    # the area is 2 + 3 pi/2 + twice the integral of r acos(3/r), 5 atan(1/3) - 3/2. The inner border is an envelope, of radius 2.
    ("about a far point", box(3, 1, 2, -1), motion(QUARTER), "sweep", 3 * PI / 2 + 10 * arctan(3) - 1, None, 1, 1, 0, [], 0),
    # [0, 2]^2.
    ("growth", SQUARE, motion({"scale": "1 + t"}), "sweep", Fraction(4), Decimal(8), 1, 1, 0, [], 0),
]


def encloses(checks, name, got, want):
    """A ratio stands as such; another number lies between two near bounds."""
    if isinstance(want, Fraction):
        checks.equal(got, {"exact": str(want)}, name)
        return
    low, high = Decimal(str(got["low"])), Decimal(str(got["high"]))
    checks.holds(low <= want <= high and high - low <= WIDTH * max(abs(low), abs(high)), name, got, want)


def chained(arcs):
    """The ends of lower arcs, arcs that follow each other joined, as sets of two points."""
    ends = [tuple(tuple(Fraction(a[end][axis]) for axis in "xy") for end in ("from", "to")) for a in arcs]
    points = [p for pair in ends for p in pair]
    return sorted(p for p in set(points) if points.count(p) == 1)


def consistent(checks, name, got):
    """Rings use each arc once, are closed, and their areas and counts sum up."""
    used = [a for ring in got["rings"] for a in ring["arcs"]]
    checks.equal(sorted(used), list(range(len(got["arcs"]))), name, "arcs of rings")
    for ring in got["rings"]:
        arcs = [got["arcs"][k] for k in ring["arcs"]]
        checks.holds(all(a["to"] == b["from"] for a, b in zip(arcs, arcs[1:] + arcs[:1])), name, "a ring is not closed", ring)
        checks.equal(ring["within"] is not None, ring["hole"], name, "within")
    checks.equal(got["euler"], got["components"] - got["holes"], name, "euler")
    checks.equal(sum(not ring["hole"] for ring in got["rings"]), got["interior_components"], name, "outer rings")
    if "exact" in got["area"]:
        checks.equal(sum(Fraction(ring["area"]["exact"]) for ring in got["rings"]), Fraction(got["area"]["exact"]), name, "sum of areas")


def polygons(graze, checks, name, words, area, got):
    """Polygons differ from the set by a strip along the outline, on one side of it if they are inside or outside."""
    path = os.path.join(graze.folder.name, "polygon.wkt")
    strip = 2 * NEAR * float(got["length"]["high"]) + math.pi * NEAR ** 2 * len(got["rings"])
    for side, least, most in (("near", -strip, strip), ("inside", -strip, 1e-12), ("outside", -1e-12, strip)):
        out = graze.call("outline", *words, "--polygon", path, "--within", str(NEAR), "--side", side)
        if not checks.equal(out.returncode, 0, name, side, out.stderr):
            continue
        with open(path, encoding="ascii") as file:
            rings = [[tuple(map(float, p.split())) for p in ring.split(",")] for ring in re.findall(r"\(([^()]+)\)", file.read())]
        found = sum((a[0] * b[1] - a[1] * b[0]) / 2 for ring in rings for a, b in zip(ring, ring[1:]))
        if side == "near":
            checks.equal(len(rings), len(got["rings"]), name, "rings")
        checks.holds(least <= found - float(area) <= most, name, side, "area", found, area)


def scenes(graze, checks):
    for number, (name, solid, moves, operation, area, length, components, inner, holes, lower, points) in enumerate(SCENES):
        words = graze.write(f"{number}.wkt", solid), graze.write(f"{number}.json", moves), "--operation", operation
        out = graze.call("outline", *words, "--format", "json")
        if not checks.equal(out.returncode, 0, name, out.stderr):
            continue
        got = json.loads(out.stdout)
        encloses(checks, name + ", area", got["area"], area)
        if length:
            encloses(checks, name + ", length", got["length"], length)
        checks.equal((got["components"], got["interior_components"], got["holes"]), (components, inner, holes), name, "counts")
        checks.equal(chained(got["lower"]["arcs"]), sorted(p for pair in lower for p in pair), name, "lower arcs")
        checks.equal((len(got["lower"]["points"]), got["lower"]["undecided"]), (points, 0), name, "lower points")
        consistent(checks, name, got)
        polygons(graze, checks, name, words, area, got)


def forms(graze, checks):
    """The text, the table of arcs, and a narrower width."""
    files = graze.write("square.wkt", SQUARE), graze.write("turn.json", motion(QUARTER))
    table = os.path.join(graze.folder.name, "arcs.csv")
    out = graze.call("outline", *files, "--arcs", table)
    checks.equal(out.stdout.splitlines()[:4], ["components: 1, of the interior 1", "holes: 0", "Euler characteristic: 1",
                                               "boundary: 5 arcs, 5 vertices, 1 rings"], "text")
    checks.equal(out.stdout.splitlines()[-1], "seams: 0 arcs, 0 points", "text")
    # Three quarters about a far point, and back: four sides of the first square and the last, of both circles an arc of each quarter, which other
    # curves cut
    turned = [{}, {"matrix": [["0", "-1", "0"], ["1", "0", "0"]]}, {"matrix": [["-1", "0", "0"], ["0", "-1", "0"]]}]
    halves = "t", "t - 1", "t - 2", "4 - t", "5 - t", "6 - t"
    ways = [{"compose": [m or along("0", "0"), {"rotate": {"tan_half": u}}]} for m, u in zip(turned + turned[::-1], halves)]
    far = graze.call("outline", graze.write("far.wkt", box(3, 1, 2)), graze.write("far.json", motion(*ways)))
    checks.holds("boundary: 10 arcs, 10 vertices, 1 rings\n" in far.stdout, "arcs about a far point", far.stdout, far.stderr)
    with open(table, encoding="utf-8") as file:
        lines = [line for line in file.read().splitlines() if line[0] != "#" or "complete" in line]
    checks.equal((lines[0].split(",")[:3], len(lines), lines[-1]), (["arc", "ring", "from_x"], 7, "# complete 5"), "table")
    got = json.loads(graze.call("outline", *files, "--format", "json", "--width", "1e-40").stdout, parse_float=Decimal)
    low, high = got["area"]["low"], got["area"]["high"]
    checks.holds(low <= 1 + PI / 2 <= high and high - low < Decimal("1e-39"), "width 1e-40", low, high)


def undecided(graze, checks):
    """A seam on an irrational line is counted, neither shown nor left out. A box below y = 0 rises by t - t^3, at most to H = 2/(3 sqrt 3) at 1/sqrt 3. One
    above y = 0, 10 to the right, comes to its place: 5 to the left, up by 1, 5 to the left, then by q(s) = s - s^3 + (3 s^2 - 1)^2, which on [0, 1] is
    least at 1/sqrt 3, where it is H: q' = (3 s^2 - 1)(12 s - 1), q(0) = 1. Neither ever has a point of y = H, 0 < x < 4, inside: the first is below or at
    x < 0, the second above or at x > 4."""
    boxes = "MULTIPOLYGON (((0 -4, 4 -4, 4 0, 0 0, 0 -4)), ((10 0, 14 0, 14 4, 10 4, 10 0)))"
    moves = motion(along("0", "t - t^3"), along("-5*(t - 1)", "0"), along("-5", "t - 2"), along("-5*(t - 2)", "1"),
                   along("-10", "(t - 4) - (t - 4)^3 + (3*(t - 4)^2 - 1)^2"))
    got = json.loads(graze.call("outline", graze.write("boxes.wkt", boxes), graze.write("up.json", moves), "--format", "json").stdout)
    checks.equal((got["lower"]["undecided"] > 0, got["lower"]["arcs"], got["lower"]["points"]), (True, [], []), "undecided", got["lower"])


def refusals(graze, checks):
    square, turn = graze.write("square.wkt", SQUARE), graze.write("turn.json", motion(QUARTER))
    body, disk = graze.write("body.off", TETRAHEDRON), graze.write("disk.csg.json", json.dumps({"dimension": 2, "solid": {"ball": {"center": [0, 0], "radius": 1}}}))
    space = graze.write("space.json", json.dumps({"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["t", "0", "0"]}}]}))
    for words, status, said in (
            ((body, space), 3, "body.off: the solid is a polyhedron; outline takes polygons, boundary samples others"),
            ((disk, turn), 3, "disk.csg.json: the solid is a curved solid; outline takes polygons, draw shows others"),
            ((square, turn, "--width", "1"), 2, "--width 1: expected a number from 1e-300 to 0.1"),
            ((square, turn, "--overlap", "reject"), 3, "S^0 and S^1"),
            ((square, turn, "--limit", "arcs=3"), 6, "the pieces of curves of an outline: more than the limit arcs=3 allows"),
            ((square, turn, "--limit", "curve=1"), 6, "the degree of a curve's parameter: more than the limit curve=1 allows"),
    ):
        out = graze.call("outline", *words)
        checks.holds(out.returncode == status and said in out.stderr, words, out.returncode, out.stderr)


def main():
    args = options(__doc__)
    checks = Checks()
    graze = Graze(args, checks)
    scenes(graze, checks)
    forms(graze, checks)
    undecided(graze, checks)
    refusals(graze, checks)
    checks.finish()


if __name__ == "__main__":
    main()
