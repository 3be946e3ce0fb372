"""Curved solids beside polyhedra: rows of `graze classify` for one tool, points near boundaries, designed degenerate
points, and many balls.

The tool is a ball-end mill of five primitives; its mesh is turned from the same profile. CPU seconds a row, reading and
printing included on both sides.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import random
import statistics
import subprocess
from fractions import Fraction as F

import scenes
from measure import Stream, run_cpu

REPEATS = 5
# The rims of the tool from the tip up, as (radius, height), the hemisphere's first.
RIMS = [(1, 1), (1, 4), (F(3, 2), 5), (F(3, 2), 8), (2, 8), (2, 9)]
FLAT = {"translate": ["3*t", "0", "0"]}
PRISM = scenes.prism([(0, 0), (3, 0), (0, 3)], 0, 3)   # five facets


def tool():
    def cylinder(radius, low, high):
        return {"cylinder": {"point": ["0", "0", str(low)], "axis": ["0", "0", "1"], "radius": str(radius), "from": "0",
                             "to": str(high - low)}}
    cone = {"cone": {"point": ["0", "0", "2"], "axis": ["0", "0", "1"], "slope": "1/2", "from": "2", "to": "3"}}
    ball = {"ball": {"center": ["0", "0", "1"], "radius": "1"}}
    return {"union": [ball, cylinder(1, 1, 4), cone, cylinder(F(3, 2), 5, 8), cylinder(2, 8, 9)]}


def mesh(around):
    """The tool's profile turned, the hemisphere by 20 rings: about 50 * around triangles."""
    rings = [(math.sin(a), 1 - math.cos(a)) for a in (k * math.pi / 40 for k in range(1, 20))]
    rings += [(float(r), float(h)) for r, h in RIMS]
    at = lambda k, j: 2 + k * around + j % around
    points = [(0.0, 0.0, 0.0), (0.0, 0.0, 9.0)]
    points += [(r * math.cos(2 * math.pi * j / around), r * math.sin(2 * math.pi * j / around), h)
               for r, h in rings for j in range(around)]
    last, facets = len(rings) - 1, []
    for j in range(around):
        facets += [(0, at(0, j + 1), at(0, j)), (1, at(last, j), at(last, j + 1))]
        for k in range(last):
            facets += [(at(k, j), at(k, j + 1), at(k + 1, j + 1)), (at(k, j), at(k + 1, j + 1), at(k + 1, j))]
    return points, facets


def balls(count):
    """Balls on the points of a lattice, none touching another."""
    side = round(count ** (1 / 3) + 0.5)
    rng = random.Random(1)
    places = [(k % side, k // side % side, k // side // side) for k in range(count)]
    return {"union": [{"ball": {"center": [str(2 * x) for x in p], "radius": str(F(rng.randrange(60, 95), 100))}} for p in places]}


def near(rng, motion, surface, width):
    """A point that a place of a surface, displaced by at most `width` along each axis, passes at some time."""
    return motion.forward(rng.random(), [x + rng.uniform(-width, width) for x in surface(rng)])


def on_tool(rng):
    """A place on the side of the tool, or on its tip."""
    a = rng.uniform(0, 2 * math.pi)
    if rng.random() < 0.3:
        b = rng.uniform(0, math.pi / 2)
        return math.sin(b) * math.cos(a), math.sin(b) * math.sin(a), 1 - math.cos(b)
    radius, low, high = rng.choice([(1, 1, 4), (1.5, 5, 8), (2, 8, 9)])
    return radius * math.cos(a), radius * math.sin(a), rng.uniform(low, high)


def on_prism(rng):
    """A place on a facet of the prism."""
    side, x, y = rng.randrange(5), rng.uniform(0, 3), rng.uniform(0, 3)
    x, y = (x, y) if side > 1 or x + y < 3 else (3 - x, 3 - y)
    return [(x, y, 0), (x, y, 3), (x, 0, y), (0, x, y), (x, 3 - x, y)][side]


def circle(rng):
    s = F(rng.randrange(-64, 65), 32)
    return (1 - s * s) / (1 + s * s), 2 * s / (1 + s * s)


def designed(rng, turns):
    """Rational points at rational times: along FLAT tangent to the tip or the side; else at a rim, at the ends too."""
    t = F(rng.choice([0, 16, *range(17)]), 16)
    c, s = circle(rng)
    if not turns and rng.random() < 0.5:
        y = (F(0), c, 1 - abs(s)) if rng.random() < 0.5 else (F(0), F(1), F(rng.randrange(17, 63), 16))
    else:
        radius, height = rng.choice(RIMS)
        y = (radius * c, radius * s, F(height))
    if not turns:
        return y[0] + 3 * t, y[1], y[2]
    # ROTATION: about the axis (2, 3, 6)/7 through (1/2, 0, 0), the half angle's tangent t; then a translation.
    cosine, sine = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    rows = scenes.turned((F(2, 7), F(3, 7), F(6, 7)), cosine, sine)
    d = (y[0] - F(1, 2), y[1], y[2])
    shift = (F(1, 2) + F(7, 10) * t, t * t / 2, t / 4)
    return tuple(sum(a * b for a, b in zip(row, d)) + m for row, m in zip(rows, shift))


class Rows:
    """CPU seconds a row of one scene, on lines of its own."""

    def __init__(self, bench, name, solid, motion, points):
        path, moving = bench.path(name), bench.path(name + ".move.json")
        with open(moving, "w", encoding="ascii") as file:
            file.write(motion)
        if isinstance(solid, dict):
            path += ".csg.json"
            with open(path, "w", encoding="ascii") as file:
                json.dump({"dimension": 3, "solid": solid}, file)
        else:
            path += ".off"
            scenes.write_off(path, solid)
        self.paths = path, moving
        self.lines = [",".join(map(str, p)) + "\n" for p in points] if points else self.generated(bench)
        self.stream = Stream(bench.graze, *self.paths)
        self.count = self.stream.fitting(self.lines, bench.target / 2, REPEATS)

    def generated(self, bench):
        """Degenerate points of a polyhedron, no random ones."""
        strata = "face=1,edge=1,vertex=1,crossing=1,start=1,end=1,slide=1"
        text = subprocess.run([bench.graze, "generate", *self.paths, "-n", str(6 * Stream.BLOCK), "--seed", "1", "--strata", strata, "--plain"],
                              capture_output=True, text=True, check=True).stdout.splitlines()
        lines = [",".join(line.split(",")[:3]) + "\n" for line in text[1:] if line]
        return (lines * 6)[:6 * Stream.BLOCK]

    def each(self):
        """Seconds a row of every repeat."""
        for r in range(REPEATS):
            part = self.lines[r * self.count:(r + 1) * self.count]
            yield self.stream.rows(part) / len(part)


def compare(bench, work, curved, other, most):
    one, two = Rows(bench, "curved", *curved), Rows(bench, "other", *other)
    times = list(zip(one.each(), two.each()))
    one.stream.close()
    two.stream.close()
    bench.table.row(f"{work} ({one.count:,} rows)", statistics.median(a / b for a, b in times), most=most,
                    graze=statistics.median(a for a, _ in times), peer=statistics.median(b for _, b in times))


def ring(major, x=0, z=0):
    return {"torus": {"point": [str(x), "0", str(z)], "axis": ["0", "0", "1"], "major": str(major), "minor": "1"}}


def touching():
    """Scenes in which a ring touches another surface along a circle, and the same with that one displaced: name, motion,
    points, both solids."""
    turn = lambda quarters: {"turn": {"quarters": quarters, "axis": ["0", "0", "1"]}}
    slid = lambda u: {"translate": [u, f"-({u})", f"2*({u})"]}
    around = {"translate": ["-2*t/(1+t^2)", "0", "-2*t^2/(1+t^2)"]}
    ball = lambda x, z, radius: {"ball": {"center": [str(x), "0", str(z)], "radius": str(radius)}}
    rings = [{"union": [ring(2), ring(4, 0, d)]} for d in (0, "1/100")]
    for name, motion, points, solids in (
            ("two rings, quarter turn", turn(1), ["0,3,0"], rings),
            ("two rings, t^2 - 1/2", slid("t^2-1/2"), ["9/5,12/5,0"], rings),
            ("two rings, a cubic", slid("(t-1)^3-(t-1)-1/7"), ["9/5,12/5,0"], rings),
            ("ball less ring", turn(1), ["0,3,0"], [{"difference": [ball(0, d, 3), ring(2)]} for d in (0, "1/100")]),
            ("ball in ring", around, ["0,0,0"],
             [{"difference": [ring(2, -2, 1), ball(0, z, 1)]} for z in (1, "101/100")]),
            ("ring below a height, five turns", turn(20), ["0,2,1", "2,0,1", "6/5,8/5,1", "-6/5,8/5,1"],
             [{"union": [ring(2), {"halfspace": {"normal": ["0", "0", "-1"], "offset": z}}]} for z in ("-1", "-101/100")])):
        yield name, motion, points, solids


def measure_touching(bench):
    """Whole runs, CPU seconds, the least of REPEATS."""
    bench.table.head("Surfaces that touch along a circle: whole runs; the peer is the same scene with one displaced by 1/100")
    for name, motion, points, solids in touching():
        paths = [bench.path(n) for n in ("touching.csg.json", "touching.json", "touching.csv")]
        times = []
        for solid in solids:
            texts = ({"dimension": 3, "solid": solid}, {"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": motion}]})
            for path, text in zip(paths, [*map(json.dumps, texts), "\n".join(points) + "\n"]):
                with open(path, "w", encoding="ascii") as file:
                    file.write(text)
            times.append(min(run_cpu([bench.graze, "classify", "--jobs", "1", *paths])[0] for _ in range(REPEATS)))
        bench.table.row(f"{name} ({len(points)} points)", times[0] / times[1], most=10, graze=times[0], peer=times[1])


def measure(bench):
    measure_touching(bench)
    bench.table.head("Curved solids: rows of graze classify; the peer is Graze on a polyhedron, or on fewer balls")
    rng = random.Random(7)
    count = (10 if bench.options.quick else 40) * Stream.BLOCK
    turning = scenes.ROTATION
    around = scenes.points_crossing(turning, ((-2, -2, 0), (2, 2, 9)), count, 1)
    compare(bench, "ball-end mill, random points, against its mesh of 10,000 triangles", (tool(), turning.json, around),
            (mesh(200), turning.json, around), 1)
    small = [(near(rng, turning, on_tool, 0.01), near(rng, turning, on_prism, 0.005)) for _ in range(count)]
    compare(bench, "points within 1e-3 of the boundary, against a prism of 5 facets",
            (tool(), turning.json, [a for a, _ in small]), (PRISM, turning.json, [b for _, b in small]), 2)
    flat = json.dumps({"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": FLAT}]})
    ring = scenes.torus(*scenes.TORUS_SIZES[10000])
    for name, motion, moving, turns in (("translation", flat, scenes.TRANSLATION.json, 0), ("rotation", turning.json, turning.json, 1)):
        points = [designed(rng, turns) for _ in range(6 * Stream.BLOCK)]
        compare(bench, f"designed degenerate points in {name}, against a torus", (tool(), motion, points), (ring, moving, None), 2)
    scattered = [scenes.points_crossing(turning, ((-1, -1, -1), (2 * n, 2 * n, 2 * n)), count, 1) for n in (10, 3)]
    compare(bench, "1,000 balls, random points, against 10 balls", (balls(1000), turning.json, scattered[0]),
            (balls(10), turning.json, scattered[1]), 20)
