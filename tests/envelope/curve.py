#!/usr/bin/env python3
# suite
"""`graze envelope --at --curve` and `--points`: slices and runs against the pullback, chains of convex solids, an edge with
two runs, contact points by chance.

SPDX-License-Identifier: GPL-3.0-or-later

At the ends of a slice g = -phi' is 0 and theta = phi'' has the sign told, both by the pullback; each edge of a facet on
which g changes its sign is the end of one slice. On an edge contact is asked between all zeros of g, and runs cover just
the parts of it that are contacts. The contacts of a convex solid at a time without whole facets are closed curves.
"""
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contact"))

import oracle  # noqa: E402
from exact import Fraction as F  # noqa: E402
from hand import moves, prism_of, shift  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from reading import named, sign, table  # noqa: E402
from scenes import scenes  # noqa: E402
from solids import Mesh, Polygon, block, cross, joined, minus  # noqa: E402

TIMES, POINTS = 2, 24
SIGNS = {"+": 1, "-": -1, "0": 0}
CONVEX = ("cube", "octahedron", "tip")


def g_of(motion, side, t, y):
    piece = oracle.pieces_beside(motion, t)[0][1]
    return -oracle.pullback(piece, side, motion.map(y, t), t, 1)[1]


def theta_of(motion, side, t, y):
    piece = oracle.pieces_beside(motion, t)[0][1]
    return sign(oracle.pullback(piece, side, motion.map(y, t), t, 2)[2])


def ends_of(row, d):
    return [tuple(F(row[k + x]) for x in "xyz"[:d]) for k in "ab"]


def along(p, q, s):
    return tuple(a + s * (b - a) for a, b in zip(p, q))


def is_on(p, q, x):
    """Is x strictly between p and q on their line?"""
    d, to = minus(q, p), minus(x, p)
    flat = d[0] * to[1] == d[1] * to[0] if len(p) == 2 else not any(cross(d, to))
    s = sum(a * b for a, b in zip(d, to))
    return flat and 0 < s < sum(a * a for a in d)


def check_slices(checks, tally, rows, solid, motion, sides, t, *where):
    d, found = solid.dimension, Counter()
    by_name = {s.name: s for s in sides}
    for row in rows:
        if row["kind"] != "slice" or F(row["time"]) != t:
            continue
        side = by_name[named(row["cell"])]
        for x, theta in zip(ends_of(row, d), (row["theta_a"], row["theta_b"])):
            checks.equal(g_of(motion, side, t, x), 0, *where, row)
            checks.equal(theta_of(motion, side, t, x), SIGNS[theta], *where, row)
            checks.holds(oracle.cells_at(side, x), *where, row, "the end is in the facet")
            found[side.name, x] += 1
        tally["slices"] += 1
    if d == 2:
        return
    for side, facet in zip(sides, solid.facets):
        for a, b in zip(facet, facet[1:] + facet[:1]):
            p, q = solid.vertices[a], solid.vertices[b]
            gp, gq = g_of(motion, side, t, p), g_of(motion, side, t, q)
            if gp * gq < 0:
                x = along(p, q, gp / (gp - gq))
                checks.equal(found[side.name, x], 1, *where, side.name, "slices that end at", [str(c) for c in x])


def check_runs(checks, tally, rows, solid, motion, sides, t, *where):
    """Edges of two facets, away from vertices of other parts: parts between zeros of g and ends."""
    edges = {}
    for side, facet in zip(sides, solid.facets):
        for a, b in zip(facet, facet[1:] + facet[:1]):
            edges.setdefault(frozenset((solid.vertices[a], solid.vertices[b])), []).append(side)
    for pair, two in edges.items():
        p, q = sorted(pair)
        if len(two) != 2 or len(oracle.at_point(sides, along(p, q, F(1, 2)))) != 2 or any(is_on(p, q, v) for v in solid.vertices):
            continue
        toward = next(v for v in (solid.vertices[i] for i in solid.facets[sides.index(two[1])])
                      if oracle.dot(two[1].normal, v) == two[1].offset and any(cross(minus(v, p), minus(q, p))))
        if oracle.dot(two[0].normal, toward) >= two[0].offset:
            continue  # flat or reflex
        name = oracle.lowest(sides, along(p, q, F(1, 2)))
        runs = [ends_of(r, 3) for r in rows if r["kind"] == "run" and F(r["time"]) == t and named(r["cell"]) == name]
        cuts = {F(0), F(1)}
        for side in two:
            gp, gq = g_of(motion, side, t, p), g_of(motion, side, t, q)
            if gp * gq < 0:
                cuts.add(gp / (gp - gq))
        cuts = sorted(cuts)
        for low, high in zip(cuts, cuts[1:]):
            x = along(p, q, (low + high) / 2)
            signs = [sign(g_of(motion, side, t, x)) for side in two]
            covered = sum(is_on(a, b, x) for a, b in runs)
            checks.equal(covered, int(min(signs) <= 0 <= max(signs)), *where, name, str(low), str(high))
            tally["parts of edges"] += 1


def run_scene(checks, tally, graze, rng, name, solid, motion):
    tag = name.replace(" ", "_")
    files = graze.write(tag + solid.suffix, solid.text()), graze.write(tag + ".json", motion.text())
    piece = rng.choice(motion.pieces)
    times = [piece.lo + (piece.hi - piece.lo) * F(2 * k + 1, 64) for k in rng.sample(range(32), TIMES)]
    out, points = graze.write(tag + "-curve.csv", ""), graze.write(tag + "-points.csv", "")
    done = graze.call("envelope", *files, "--at", ",".join(map(str, times)), "--curve", out, "-n", str(POINTS), "--seed", "7",
                      "--points", points)
    if not checks.equal(done.returncode, 0, name, done.stderr):
        return
    rows, sites = table(out), table(points)
    if not checks.holds(rows is not None and sites is not None, name, "the tables are whole"):
        return
    sides = oracle.sides_of(solid)
    for t in times:
        check_slices(checks, tally, rows, solid, motion, sides, t, name, str(t))
        if not isinstance(solid, Polygon):
            check_runs(checks, tally, rows, solid, motion, sides, t, name, str(t))
    if name.split(" ")[0] in CONVEX and not any(r["kind"] == "whole" for r in rows):
        checks.equal({r["form"] for r in rows if r["kind"] != "point"} - {"closed"}, set(), name, "chains")
        tally["convex"] += 1
    for r in rows:
        tally[r["kind"], r["form"]] += 1
    checks.equal(len(sites), POINTS, name, "contact points")
    checks.equal({r["role"] for r in sites}, {"contact"}, name, "roles")
    again = graze.call("contact", *files, points, "--quiet").stdout
    checks.equal(again, open(points, encoding="utf-8").read(), name, "the rows are those of graze contact")
    tally["times of points"] += len({r["time"] for r in sites})


def two_runs(checks, graze):
    """Unit cube, quaternion (1, t, t, 0), b = (-2t/3, 4t/3, 0). At t = 0 the velocity at (x, y, z) is (2z - 2/3, 4/3 - 2z,
    2y - 2x): on the edge x = y = 1 g is 2z - 2/3 of x = 1 and 4/3 - 2z of y = 1, of different signs up to z = 1/3 and
    from 2/3. Of x = y = 0 the signs are the opposite ones."""
    cube = graze.write("unit.off", prism_of([[(0, 0), (1, 0), (1, 1), (0, 1)]], 0, 1))
    turn = {"compose": [{"quaternion": ["1", "t", "t", "0"]}, shift("-2/3*t", "4/3*t", "0")]}
    motion, out = graze.write("unit.json", moves(3, (-1, 1, turn))), graze.write("unit.csv", "")
    done = graze.call("envelope", cube, motion, "--at", "0", "--curve", out)
    checks.equal(done.returncode, 0, done.stderr)
    rows = table(out)
    for edge, at in (("edge 2-6", "1"), ("edge 0-4", "0")):
        runs = [[r[k] for k in ("ax", "ay", "az", "bx", "by", "bz")] for r in rows if (r["kind"], r["cell"]) == ("run", edge)]
        checks.equal(runs, [[at, at, "0", at, at, "1/3"], [at, at, "2/3", at, at, "1"]], edge)


def tips(*corners, base=3):
    """Tetrahedra above z = 1, each on one corner."""
    vertices, faces = [], []
    for x, y in corners:
        n = len(vertices)
        vertices += [(x, y, 1), (x - F(1, 4), y - F(1, 4), base), (x + F(1, 4), y - F(1, 4), base), (x, y + F(1, 4), base)]
        faces += [[n, n + 2, n + 1], [n, n + 3, n + 2], [n, n + 1, n + 3], [n + 1, n + 2, n + 3]]
    return Mesh(vertices, faces)


# A square on whose top, y = 1, the corner of a triangle rests, in its middle.
RESTING = "MULTIPOLYGON (((0 0, 2 0, 2 1, 0 1, 0 0)), ((1 1, 2 2, 0 2, 1 1)))\n"


def resting(checks, graze):
    """Corners of other parts rest within facets: no contact point is given there, and a slice ends there."""
    middles = [(x, y) for x in (1, 2) for y in (1, 2)]  # of the halves of the top, however it is cut
    block4, block3 = block(0, 0, 0, 4, 4, 1), block(0, 0, 0, 3, 3, 1)
    turn = {"rotate": {"tan_half": "t", "axis": ["0", "1", "0"], "center": ["2", "2", "1"]}}
    for number, (text, suffix, motion) in enumerate((
            (RESTING, ".wkt", moves(2, (0, 1, shift("t", "0")))),
            (joined(block3, tips(*middles)).text(), ".off", moves(3, (0, 1, shift("t", "0", "0")))),
            # The top's g is 0 on x = 2 all the time, and the corner (2, 2) is there.
            (joined(block4, tips((2, 2))).text(), ".off", moves(3, (0, 1, turn))))):
        files = graze.write(f"resting{number}{suffix}", text), graze.write(f"resting{number}.json", motion)
        points, curve = graze.write("points.csv", ""), graze.write("curve.csv", "")
        done = graze.call("envelope", *files, "-n", "60", "--points", points, "--at", "1/3", "--curve", curve)
        if not checks.equal(done.returncode, 0, "resting", number, done.stderr):
            continue
        checks.equal(Counter(row["role"] for row in table(points)), {"contact": 60}, "resting", number)
        rows = [row for row in table(curve) if row.get("az") == row.get("bz") == "1"]
        if number == 1:
            found = [(F(row["ax"]), F(row["ay"])) for row in rows if row["kind"] == "whole"]
            checks.holds(len(found) == 1 and found[0] not in middles, "of the whole top", found)
        if number == 2:
            ends = [(row["ax"], row["ay"], row["bx"], row["by"]) for row in rows if row["kind"] == "slice"]
            checks.equal(ends, [("2", "0", "2", "2"), ("2", "2", "2", "4")], "slices of the top")


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    graze = Graze(args, checks)
    if args.derived:
        two_runs(checks, graze)
        resting(checks, graze)
    for name, solid, motion in scenes(args):
        run_scene(checks, tally, graze, args.random, name, solid, motion)
    for key, number in sorted(tally.items(), key=str):
        print(key, number)
    for kind in ("slices", "parts of edges", "convex", "times of points"):
        checks.holds(tally[kind], "there are some", kind)
    checks.finish()


if __name__ == "__main__":
    main()
