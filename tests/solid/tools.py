#!/usr/bin/env python3
# suite
"""graze solid: the polyhedra are convex, legal, inside and outside of the body, and as near as is said.

The body is that of the numbers on the command line, in decimals of 60 digits: its profile is a bottom, an arc and a
side, tangent to one another. Facets are looked at in fractions: every vertex lies on the inner side of every plane.
Corners inside are in the profile; each plane outside has the body behind it, by the body's support function; corners
outside are near the profile, and in many directions the support functions of body and inner polyhedron are near.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import re
import sys
import tempfile
from decimal import Decimal as D
from decimal import getcontext

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "lib"), os.path.join(HERE, "..", "motioncmd")]

import harness  # noqa: E402
from exact import Fraction as F  # noqa: E402
from harness import Checks, options  # noqa: E402
from truth import cos_sin, dec  # noqa: E402

checks = Checks()
check = checks.holds
getcontext().prec = 60
NOTHING = D("1e-50")
MOVE = '{"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["8*t", 0, 0]}}]}'

# Kind, diameter, length, corner, taper, tolerance.
TOOLS = [("ball", "6", None, "3", None, None), ("ball", "1/3", None, "1/6", None, "1/100"),
         ("cylinder", "6", "10", "0", "0", "0.05"), ("cutter", "6", "20", "3", "0", None),
         ("cutter", "10", "20", "1", "0", "0.01"), ("cutter", "3", "15", "1.5", "5", None),
         ("cutter", "10", "15", "0", "-10", "0.2"), ("cutter", "10", "15", "0.5", "-10", None),
         ("cutter", "1", "2", "1/7", "45", "0.02"), ("cutter", "10", "30", "4", "12.5", "1/9")]


class Body:
    """The profile: bottom (flat, 0), arc about (flat, corner) up to the normal (c, -s), side, top."""

    def __init__(self, kind, diameter, length, corner, taper):
        self.ball, self.corner = kind == "ball", dec(F(corner))
        self.flat = dec(F(diameter)) / 2 - self.corner
        self.height = dec(F(diameter)) if self.ball else dec(F(length))
        self.c, self.s = (D(0), D(-1)) if self.ball else cos_sin(D(taper))
        self.top = D(0) if self.ball else self.flat + (self.corner + (self.height - self.corner) * self.s) / self.c

    def support(self, nr, nz):
        """The largest nr r + nz z, nr >= 0."""
        most = max(nr * self.flat, nr * self.top + nz * self.height, nz * self.height)
        # The arc's normals run from (0, -1) to (c, -s).
        if self.ball or nz * self.c <= -self.s * nr:
            most = max(most, nr * self.flat + nz * self.corner + self.corner * (nr * nr + nz * nz).sqrt())
        return most

    def excess(self, r, z):
        """The distance of a point outside the profile; where 0 or less, at most its distance to the profile."""
        x, y = r - self.flat, z - self.corner
        if self.ball:
            return (x * x + y * y).sqrt() - self.corner
        outside = [-z, z - self.height, x * self.c - y * self.s - self.corner]
        if x > 0 and y <= -self.corner * self.s:
            outside.append((x * x + y * y).sqrt() - self.corner)
        return max(outside)

    def distance(self, r, z):
        """The distance of a point to the profile, by its nearest point on bottom, arc, side and top."""
        if self.excess(r, z) <= 0:
            return D(0)
        ends = [(self.flat + self.corner * self.c, self.corner - self.corner * self.s), (self.top, self.height)]
        near = [segment(r, z, (D(0), D(0)), (self.flat, D(0))), segment(r, z, (D(0), self.height), (self.top, self.height))]
        near += [] if self.ball else [segment(r, z, *ends)]
        x, y = r - self.flat, z - self.corner
        if x >= 0 and (self.ball or y * self.c <= -self.s * x):
            near.append(abs((x * x + y * y).sqrt() - self.corner))
        return min(near)


def segment(r, z, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    square = dx * dx + dy * dy
    share = min(D(1), max(D(0), ((r - a[0]) * dx + (z - a[1]) * dy) / square)) if square else D(0)
    return ((r - a[0] - share * dx) ** 2 + (z - a[1] - share * dy) ** 2).sqrt()


def read_off(path):
    with open(path, encoding="ascii") as file:
        lines = file.read().split("\n")
    n, m, _ = map(int, lines[1].split())
    return [[F(x) for x in line.split()] for line in lines[2:2 + n]], [list(map(int, line.split()))[1:] for line in lines[2 + n:2 + n + m]]


def normal_of(vertices, facet):
    a, b, c = (vertices[k] for k in facet[:3])
    u, v = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
    return [u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3] for k in range(3)]


def planes_of(vertices, facets, words):
    """Outward normals and heights; no vertex is beyond a plane, and a facet's are on it."""
    planes, unit = [], math.lcm(*(x.denominator for v in vertices for x in v))
    whole = [[int(x * unit) for x in v] for v in vertices]
    for facet in facets:
        n = normal_of(whole, facet)
        heights = [n[0] * x + n[1] * y + n[2] * z for x, y, z in whole]
        height = F(heights[facet[0]], unit)
        inside = max(heights) == heights[facet[0]]
        flat = all(heights[k] == heights[facet[0]] for k in facet)
        check(any(n) and inside and flat, words, "a facet of a convex polyhedron", facet)
        planes.append((n, height))
    return planes


def polar(v):
    return dec(v[0] * v[0] + v[1] * v[1]).sqrt(), dec(v[2])


def words_of(kind, diameter, length, corner, taper, tolerance):
    words = [kind, "--diameter", diameter] + (["--length", length] if length else [])
    words += ["--corner", corner, "--taper", taper] if kind == "cutter" else []
    return words + (["--tolerance", tolerance] if tolerance else [])


def test_tool(graze, folder, rng, tool):
    paths, words = [os.path.join(folder, name) for name in ("in.off", "out.off", "move.json")], words_of(*tool)
    done = harness.run([graze, "solid", *words, "--inside", paths[0], "--outside", paths[1]])
    if not check(done.returncode == 0, words, done.stderr):
        return
    told = D(re.search(r"^error: .* at most (\S+)$", done.stderr, re.M)[1])
    body = Body(*tool[:5])
    check(told <= dec(F(tool[5]) if tool[5] else F(tool[1]) / 200) * D("1.005"), words, told, "the tolerance")
    for path in paths[:2]:
        legal = harness.run([graze, "check", path, paths[2]])
        check(legal.returncode == 0 and legal.stdout.startswith("legal"), words, legal.stderr)
    inner, facets = read_off(paths[0])
    planes_of(inner, facets, words)
    outer, facets = read_off(paths[1])
    for n, height in planes_of(outer, facets, words):
        nr, nz = polar(n)
        check(body.support(nr, nz) <= dec(height) + NOTHING * (nr + abs(nz)), words, "the body lies behind a plane", n)
    check(all(body.excess(*polar(v)) <= NOTHING for v in inner), words, "corners inside")
    check(max(body.distance(*polar(v)) for v in outer) <= told, words, "corners outside are near")
    for _ in range(60):
        n = [F(rng.randint(-9, 9)) for _ in range(3)]
        size = (dec(sum(x * x for x in n))).sqrt()
        gap = body.support(*polar(n)) - max(dec(sum(x * y for x, y in zip(n, v))) for v in inner)
        check(-NOTHING <= gap <= told * size, words, "the inner polyhedron is near", n, gap, told)


def test_moved(graze):
    """--at adds; a box is exact, and its facets look outward."""
    for words in (["cutter", "--diameter", "1", "--length", "2"], ["box", "--size", "1,2,1/3"]):
        plain = harness.run([graze, "solid", *words]).stdout.split("\n")
        moved = harness.run([graze, "solid", *words, "--at", "1,-2,0.25"]).stdout.split("\n")
        n = int(plain[1].split()[0])
        for a, b in zip(plain[2:2 + n], moved[2:2 + n]):
            check([F(x) + d for x, d in zip(a.split(), (1, -2, F(1, 4)))] == [F(x) for x in b.split()], words, a, b)
        check(plain[2 + n:] == moved[2 + n:] and plain[:2] == moved[:2], words)
    vertices = [[F(x) for x in line.split()] for line in plain[2:10]]
    check(sorted(vertices) == sorted([x, y, z] for x in (0, 1) for y in (0, 2) for z in (0, F(1, 3))), plain)
    planes = planes_of(vertices, [list(map(int, line.split()))[1:] for line in plain[10:16]], "box")
    check(len({tuple(x > 0 for x in n) + tuple(x < 0 for x in n) for n, _ in planes}) == 6, planes)


def on_profile(body, words):
    """Points of the surface, by the numbers of the profile."""
    out = [(0, 0, 0), (0, 0, body["height"])]
    if body["flat"] > 0:
        out.append((0, body["flat"], 0))
    if body["corner"] > 0:
        for c, s in ((F(3, 5), F(4, 5)), (F(5, 13), F(12, 13))):
            out.append((body["flat"] + body["corner"] * c, 0, body["corner"] - body["corner"] * s))
    if words[4] == "0":
        out.append((0, -body["flat"] - body["corner"], (body["corner"] + body["height"]) / 2))
    return out


def test_exact(graze, folder, rng, words):
    """The body itself: points of the profile are on it, others in and out as by the profile in decimals."""
    kind, diameter, length, corner, taper, _ = words
    numbers = [["--" + name, value] for name, value in (("diameter", diameter), ("length", length), ("corner", corner), ("taper", taper))
               if value is not None and not (kind != "cutter" and name in ("corner", "taper"))]
    at = rng.choice([(0, 0, 0), (F(1, 3), -2, F(5, 4))])
    done = harness.run([graze, "solid", kind, "--exact", *sum(numbers, []), "--at", ",".join(map(str, at))])
    check(done.returncode == 0, words, done.stderr)
    tilted = kind == "cutter" and taper != "0"
    check(done.stderr == ("exact but for the taper, which is less by at most 1e-9 degrees\n" if tilted else "exact\n"), done.stderr)
    solid, points = os.path.join(folder, "exact.csg.json"), os.path.join(folder, "exact.csv")
    with open(solid, "w", encoding="ascii") as file:
        file.write(done.stdout)
    body = Body(kind, diameter, length, corner, taper or "0")
    size = F(diameter) if kind == "ball" else F(length)
    wide = F(diameter) / 2 + (size if tilted else 0)
    wanted = [(p, "on") for p in on_profile({"flat": F(diameter) / 2 - F(corner), "corner": F(corner), "height": size}, words)]
    for _ in range(150):
        p = tuple(F(rng.randint(-100, 100)) * wide / 80 for _ in range(2)) + (F(rng.randint(-10, 110)) * size / 100,)
        if rng.random() < 0.5:
            p = tuple(x / 3 for x in p)
        excess = body.excess(*polar(p))
        if abs(excess) > D("1e-8") * dec(size):
            wanted.append((p, "out" if excess > 0 else "in"))
    with open(points, "w", encoding="ascii") as file:
        file.write("x,y,z\n" + "".join(",".join(str(a + b) for a, b in zip(p, at)) + "\n" for p, _ in wanted))
    done = harness.run([graze, "classify", solid, os.path.join(folder, "rest.json"), points])
    rows = [line.split(",") for line in done.stdout.split("\n") if line and line[0] not in "#x"]
    check(len(rows) == len(wanted), words, done.stderr)
    for row, (p, want) in zip(rows, wanted):
        check(row[3] == want, words, *p, row[3], want)


def main():
    args = options(__doc__, seed=1)
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "move.json"), "w", encoding="ascii") as file:
            file.write(MOVE)
        with open(os.path.join(folder, "rest.json"), "w", encoding="ascii") as file:
            file.write(MOVE.replace("8*t", "0"))
        for tool in TOOLS:
            test_tool(args.graze, folder, args.random, tool)
            test_exact(args.graze, folder, args.random, tool)
        # Corners that are wider than the bottom: their torus meets itself.
        for tool in (("cutter", "10", "20", "4", "0", None), ("cutter", "10", "20", "2.5", "0", None), ("cutter", "10", "7", "4", "0", None)):
            test_exact(args.graze, folder, args.random, tool)
    test_moved(args.graze)
    checks.finish()


if __name__ == "__main__":
    main()
