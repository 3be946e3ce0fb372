# suite
"""`graze outline --polygon --side`: valid polygons of doubles inside and outside, on the scenes that are derived by hand and on random ones.

SPDX-License-Identifier: GPL-3.0-or-later

`classify` says on which side each corner and points of each edge are, and winding numbers about points of the outline's arcs that the arcs are on the other
side of all rings: so the polygon is a subset of the set, or the set of it. All coordinates are integers of one unit, in which no two edges meet but at
common ends. Where the area is known, the polygon's is not on the wrong side of it, nor farther off than a strip of the width T along the outline. Each
corner is within T of chords of the outline's arcs. Where shapely is installed it says that the polygons are valid.
"""
import json
import math
import os

from byhand import SCENES, box, plane
from drawn import scene as random_scene
from exact import Fraction as F
from motion import build, rotation, translate
from outlines import Checks, Outline, Program, middle, options
from polygons import area, rings_of
from solids import ring

try:
    import shapely.wkt as wkt
except ImportError:
    wkt = None

CHORDS = 64  # of each arc
ROUNDS = 20


def turn(a, b, c):
    side = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (side > 0) - (side < 0)


def integers(rings):
    """Corners without the last of each ring, as integers of one unit."""
    exact = [[tuple(F(x) for x in p) for p in r[:-1]] for r in rings]
    unit = max([x.denominator for r in exact for p in r for x in p], default=1)  # powers of 2
    return [[tuple(int(x * unit) for x in p) for p in r] for r in exact]


def meetings(rings):
    """Pairs of edges that have a point in common, but for common ends of neighbours."""
    edges = []
    for number, r in enumerate(integers(rings)):
        edges += [(min(a[0], b[0]), max(a[0], b[0]), a, b, number, k, len(r)) for k, (a, b) in enumerate(zip(r, r[1:] + r[:1]))]
    edges.sort()
    for i, (_, high, a, b, ring_a, k, count) in enumerate(edges):
        for low, _, c, d, ring_b, m, _ in edges[i + 1:]:
            if low > high:
                break
            sides = turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)
            if ring_a == ring_b and (m - k) % count in (1, count - 1):
                if not any(sides) and (c[0] - a[0]) * (d[0] - b[0]) + (c[1] - a[1]) * (d[1] - b[1]) < 0:
                    yield a, b, c, d
            elif sides[0] * sides[1] <= 0 and sides[2] * sides[3] <= 0 and max(a[1], b[1]) >= min(c[1], d[1]) and max(c[1], d[1]) >= min(a[1], b[1]):
                yield a, b, c, d


def winding(rings, x):
    """The sum of the rings' winding numbers about a point of doubles, exactly."""
    number, p = 0, [F(c) for c in x]
    for r in rings:
        for a, b in zip(r, r[1:]):
            if (a[1] > x[1]) != (b[1] > x[1]):
                up = 1 if b[1] > a[1] else -1
                number += up if turn([F(c) for c in a], [F(c) for c in b], p) == up else 0
    return number


def distance(p, chords):
    """From a point to the nearest of some chords."""
    best = math.inf
    for (ax, ay), (bx, by) in chords:
        vx, vy, x, y = bx - ax, by - ay, p[0] - ax, p[1] - ay
        square = vx * vx + vy * vy
        s = min(max((vx * x + vy * y) / square, 0), 1) if square else 0
        best = min(best, math.hypot(x - s * vx, y - s * vy))
    return best


def beside(program, solid, motion, near, side, unsweep, *flags, ending="wkt"):
    """(text, warnings, Outline), or the status and the message."""
    path = os.path.join(program.folder.name, "beside." + ending)
    files = program.write("s.wkt", solid.text()), program.write("m.json", motion.text())
    out = program.call("outline", *files, "--polygon", path, "--within", repr(near), "--side", side, "--format", "json",
                       *(("--operation", "unsweep") if unsweep else ()), *flags)
    if out.returncode:
        return out.returncode, out.stderr, None
    with open(path, encoding="ascii") as file:
        return file.read(), out.stderr, Outline(json.loads(out.stdout))


def check(checks, program, name, solid, motion, near, side, unsweep, known=None):
    text, said, outline = beside(program, solid, motion, near, side, unsweep)
    where = name, near, side
    if not checks.holds(outline is not None, *where, text, said):
        return
    inside = side == "inside"
    rings = [r for p in rings_of(text) for r in p]
    checks.holds(all(r[0] == r[-1] and len(r) > 3 for r in rings), *where, "closed rings")
    checks.equal(next(meetings(rings), None), None, *where, "edges that meet")
    if wkt:
        checks.holds(wkt.loads(text).is_valid, *where, "shapely: is_valid")
    # Notes: exactly where the numbers of rings differ.
    count = len(outline.rings)
    checks.equal(f"rings: {len(rings)}, of the outline: {count}; " in said, len(rings) != count, *where, "note", said)
    # The rings are on the side ...
    points = [tuple(F(x) for x in p) for r in rings for p in r[:-1]]
    points += [tuple(F(x) + (F(y) - F(x)) * s / 3 for x, y in zip(a, b)) for r in rings for a, b in zip(r, r[1:]) for s in (1, 2)]
    words = program.pmc(name, solid, motion, points, unsweep) if points else []
    held = {"in"} if unsweep else {"in", "on"}  # `on` beside a dangling part is not of the closure of the interior
    for p, word in zip(points, words or []):
        checks.holds((word in held) == inside, *where, "a point of an edge", p, word)
    # ... and the outline on the other side of all rings.
    curves = [[c.at(k / CHORDS) for k in range(CHORDS + 1)] for c in outline.curves]
    for c in curves:
        for p in c[::16]:
            checks.equal(winding(rings, p), 0 if inside else 1, *where, "rings about a point of the outline", p)
    # Corners are near: a chord is off its arc by no more than the sagitta of a strongly curved one.
    chords = [pair for c in curves for pair in zip(c, c[1:])]
    slack = max([math.dist(*pair) for pair in chords], default=0)
    for r in rings:
        for p in r[::max(1, len(r) // 40)]:
            checks.holds(distance(p, chords) <= near + slack / 2, *where, "a corner's distance", p)
    if known is not None:
        got, length = sum(map(area, rings)), middle((float(outline.record["length"]["low"]), float(outline.record["length"]["high"])))
        bound = 2 * near * length + math.pi * near ** 2 * count + 1e-12
        lost = (float(known) - got) * (1 if inside else -1)
        checks.holds(-1e-12 <= lost <= bound, *where, "area", got, known)


def by_hand(checks, program, args):
    for k, s in enumerate(SCENES):
        if args.only in s.name:
            for side in ("inside", "outside"):
                check(checks, program, s.name, s.solid, s.motion, (1e-1, 1e-3)[(k + (side == "inside")) % 2], side, s.unsweep, s.area)


def at_random(checks, program, args):
    for k in args.rounds(ROUNDS, "random scenes"):
        name, solid, motion, unsweep = random_scene(args.random, k)
        for side in ("inside", "outside"):
            check(checks, program, name, solid, motion, args.random.choice((0.3, 0.05, 0.01)), side, unsweep)


def thin(checks, program):
    """Rings are shifted by T / 2. A bar of [0, 4] x [0, 1/8] is within 1/16 of its outline, so none of it is left for T = 1; a frame of [0, 4]² with a hole of
    side 1/8 has no hole then. For T = 1/32 both are there: points of the bar's axis are 1/16 from the outline, so is the hole's middle."""
    rest = build([(0, 1, translate([[], []]))])
    bar, frame = box(0, 0, 4, F(1, 8)), plane(ring((0, 0), (4, 0), (4, 4), (0, 4)), ring((2, 2), (2, F(17, 8)), (F(17, 8), F(17, 8)), (F(17, 8), 2)))
    text, said, _ = beside(program, bar, rest, 1.0, "inside", False)
    checks.equal(text, "MULTIPOLYGON EMPTY\n", "bar", said)
    checks.holds("rings: 0, of the outline: 1; left out is what is thinner than TOL" in said, "bar: note", said)
    for ending, empty in (("geojson", '"coordinates": []'), ("svg", 'd=""'), ("vtk", "POINTS 0 double\nLINES 0 0\n")):
        text, said, _ = beside(program, bar, rest, 1.0, "inside", False, ending=ending)
        checks.holds(empty in text, "bar", ending, text, said)
    text, said, _ = beside(program, frame, rest, 1.0, "outside", False)
    checks.equal([len(p) for p in rings_of(text)], [1], "frame", text)
    checks.holds("rings: 1, of the outline: 2; filled is what is thinner than TOL" in said, "frame: note", said)
    for solid, side, point, number in ((bar, "inside", (2.0, 0.0625), 1), (frame, "outside", (2.0625, 2.0625), 0)):
        text, said, _ = beside(program, solid, rest, 1 / 32, side, False)
        checks.equal(winding([r for p in rings_of(text) for r in p], point), number, side, text)
        checks.equal(said, "", side, "note")
    # The near side is the default.
    turned = build([(0, 1, rotation([0, 1]))])
    near = beside(program, bar, turned, 0.01, "near", False)[0]
    path = os.path.join(program.folder.name, "default.wkt")
    program.call("outline", program.write("s.wkt", bar.text()), program.write("m.json", turned.text()), "--polygon", path, "--within", "0.01")
    with open(path, encoding="ascii") as file:
        checks.equal(file.read(), near, "near is the default")


def sizes(checks, program):
    """A distance far beyond the outline: none inside; outside one ring, whose corners doubles hold. Distances below 2^13 units of doubles are refused."""
    turned = build([(0, 1, rotation([0, 1]))])
    for side in ("inside", "outside"):
        text, said, outline = beside(program, box(0, 0, 1, 1), turned, 1e300, side, False)
        checks.equal(len(rings_of(text)) if outline else said, int(side == "outside"), "1e300", side)
        code, said, _ = beside(program, box(0, 0, 1, 1), turned, 2.0 ** -41, side, False)
        checks.equal((code, f"a polygon {side} the outline: none is found whose coordinates are doubles" in said), (6, True), side, said)
    for scale in (F(1, 2 ** 20), F(2 ** 40)):
        solid = box(0, 0, scale, scale)
        check(checks, program, f"size {float(scale)}", solid, build([(0, 1, translate([[0, scale], [0, 0, scale]]))]), float(scale) / 64, "outside", False)


def main():
    args = options(__doc__.splitlines()[0], ("--only", {"default": "", "help": "scenes whose name contains this text"}))
    checks = Checks()
    program = Program(args, checks)
    if args.derived:
        by_hand(checks, program, args)
    if not args.only:
        at_random(checks, program, args)
        thin(checks, program)
        sizes(checks, program)
    checks.finish()


if __name__ == "__main__":
    main()
