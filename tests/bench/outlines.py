"""Exact outlines of planar sweeps beside shapely's union of 1,000 positions of the same polygon, and that union's error of the area.

`graze outline` with its start and the areas to the default width, against `unary_union` alone, in CPU seconds.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import os
import random
import re
import statistics
import subprocess
import time
from fractions import Fraction as F

from measure import run_cpu

try:
    from shapely.affinity import affine_transform
    from shapely.geometry import Polygon
    from shapely.ops import unary_union
except ImportError:
    unary_union = None

SAMPLES = 1000
REPEATS = 3
FOOTPRINT = [(-1, -1), (2, -1), ("5/2", "-1/2"), ("5/2", "1/2"), (2, 1), (-1, 1), ("-5/4", "3/4"), ("-5/4", "-3/4")]


def star(points):
    """A star, half of its corners reflex, as dyadic numbers."""
    return [tuple(F(round(1024 * r * f(2 * math.pi * k / points)), 1024) for f in (math.cos, math.sin))
            for k, r in enumerate([1, F(1, 2)] * (points // 2))]


def polynomial(*coefficients):
    return lambda t: sum(float(c) * t ** k for k, c in enumerate(coefficients))


def cubic():
    """Along (4t, 3t - 9t^2 + 6t^3): rows of the matrix at a time, and the motion's file."""
    x, y = polynomial(0, 4), polynomial(0, 3, -9, 6)
    text = [{"t": [0, 1], "transform": {"translate": ["4*t", "3*t - 9*t^2 + 6*t^3"]}}]
    return lambda t: (1, 0, 0, 1, x(t), y(t)), 1, text


def turned(half, x, y):
    cos, sin = (1 - half * half) / (1 + half * half), 2 * half / (1 + half * half)
    return cos, -sin, sin, cos, x, y


def quarter():
    """A quarter turn about (3, 0)."""
    def rows(t):
        a, b, c, d, *_ = turned(t, 0, 0)
        return a, b, c, d, 3 - 3 * a, -3 * c
    return rows, 1, [{"t": [0, 1], "transform": {"rotate": {"tan_half": "t", "center": [3, 0]}}}]


def log_of_poses():
    """A hundred poses of a vehicle that wanders, about its rear axle; between them the tangent of half its heading and its place run evenly."""
    rng, x, y, half, poses = random.Random(5), F(0), F(0), F(0), []
    for _ in range(100):
        poses.append((half, x, y))
        cos, sin, *_ = turned(float(half), 0, 0)[0], turned(float(half), 0, 0)[2]
        x, y = x + F(round(256 * cos), 512), y + F(round(256 * sin), 512)
        half = min(F(1), max(F(-1), half + F(rng.randint(-16, 16), 256)))
    pieces = []
    for k, (one, other) in enumerate(zip(poses, poses[1:])):
        h, u, v = (f"({a}) + ({b - a})*s" for a, b in zip(one, other))
        pieces.append({"t": [k, k + 1], "transform": {"compose": [{"rotate": {"tan_half": h}}, {"translate": [u, v]}]}})

    def rows(t):
        k = min(int(t), len(poses) - 2)
        return turned(*(float(a) + (t - k) * float(b - a) for a, b in zip(poses[k], poses[k + 1])))
    return rows, len(poses) - 1, pieces


# name, polygon, motion, greatest ratio
SCENES = (("a star of 40 along a cubic", star(40), cubic, 1), ("a star of 200 by a quarter turn", star(200), quarter, 10),
          ("8 corners along a log of 100 poses", FOOTPRINT, log_of_poses, 10))


def union(corners, rows, end):
    """Seconds of the union of all positions, and its area."""
    polygon = Polygon([[float(F(x)) for x in p] for p in corners])
    positions = [affine_transform(polygon, rows(end * k / (SAMPLES - 1))) for k in range(SAMPLES)]
    start = time.process_time()
    area = unary_union(positions).area
    return time.process_time() - start, area


def run(table, graze, folder):
    table.head(f"Exact outlines, against shapely's union of {SAMPLES:,} positions")
    if not unary_union:
        table.note("shapely is left out: python3-shapely is not installed")
    solid, motion, answer = (os.path.join(folder, name) for name in ("outline.wkt", "outline.json", "outline-answer.txt"))
    for name, corners, made, most in SCENES:
        rows, end, pieces = made()
        with open(solid, "w", encoding="ascii") as file:
            file.write("POLYGON ((" + ", ".join(f"{x} {y}" for x, y in [*corners, corners[0]]) + "))\n")
        with open(motion, "w", encoding="ascii") as file:
            json.dump({"dimension": 2, "pieces": pieces}, file)
        words = [graze, "outline", solid, motion, "-o", answer]
        if not unary_union:
            table.row(f"{name}, seconds", run_cpu(words)[0], unit=" s")
            continue
        pairs = [(run_cpu(words)[0], *union(corners, rows, end)) for _ in range(REPEATS)]
        table.row(name, statistics.median(a / b for a, b, _ in pairs), most=most, graze=pairs[0][0], peer=pairs[0][1])
        with open(answer, encoding="ascii") as file:
            area = float(re.search(r"^area: .*(?:about| and) ([-+.e\d]+)$", file.read(), re.M)[1])
        table.note(f"area {area:.9g}; shapely's union has {pairs[0][2]:.9g}, {(pairs[0][2] - area) / area:+.2g} of it")
