#!/usr/bin/env python3
# suite
"""boundary_low: within it of a point, all points have its pmc (C120); and it is no trifle where the way is known.

SPDX-License-Identifier: GPL-3.0-or-later

*Law.* Points at less than boundary_low from a point, in directions of the axes and others, are asked exactly. *By hand.* [0, 2]^3 along x by 8
sweeps [0, 10] x [0, 2]^2: the distance of a point from its boundary is that from the nearest of the six faces, inside and beyond a face. The plate
[0, 1/100] x [0, 10]^2 along x by 10 sweeps a block 10 deep whose middle is (5 + 1/200, 5, 5), though no pose is deeper than 1/200. The square
[0, 2]^2 along y by 4 sweeps [0, 2] x [0, 6]. The points that stay in [0, 4]^2
along 1 of x are [0, 3] x [0, 4]. Those that stay in [0, 10]^2 along 3 of x, less [4, 4 + 1/50] x [2, 8], are [0, 7] x [0, 10] less [1, 4 + 1/50] x [2, 8]; in space so.
The plate [0, 3] x [0, 1/50] along (t, 4 t) sweeps a hexagon with sides on 4 x - y = -1/50 and 4 x - y = 12, from which a point has the distance of these forms over
the root of 17, and on y = 0, y = 4 + 1/50. The bar [1, 2] x [-1/200, 1/200] by a quarter turn sweeps 1 <= r <= 2 between the axes, and less than 1/200 more.
A block with a hollow whose lowest point (0, 0) rests inside the lower side, along y by 4: a point (0, y), 0 < y < 2, begins in the hollow and leaves it by that point
alone, `on`; others with 0 < y < 3 are in the block just before they leave it, `in`: so these are |x| or y from where that ends.
Convex plates along a line sweep their Minkowski sum with a segment: the distances are those from its sides' lines, whose normals are the plate's, and the line's.
A bound is not asked to be sharp: half the way, where cubes decide, and where one pose does all of it but the enclosure's width.
"""
import csv
import json
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
for folder in ("lib", os.path.join("agree", "lib")):
    sys.path.insert(0, os.path.join(HERE, "..", folder))

from exact import Fraction as F, to_double  # noqa: E402
from motion import build, rotation, translate  # noqa: E402
from points import mixed  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from scenes import scenes  # noqa: E402
from solids import Mesh, Polygon, block, box_ring, inside_out, joined, ring  # noqa: E402

SCENES = 4
POINTS = 20
CONVEX = 20
ASK = ("--quiet", "--sdf", "1e-6r", "--boundary-distance")
LESS = 1 - F(1, 2 ** 30)
TINY = F(1, 2 ** 40)

ROOT_17 = F(4123105625617, 10 ** 12)        # below it
QUARTER = build([(0, 1, rotation([0, 1]))])

HOLLOW = inside_out(Mesh([(1, 0, 1), (-1, 0, 1), (0, 1, 1), (0, -1, 1), (0, 0, 2), (0, 0, 0)],
                         [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]))

WORKED = [  # name, solid, motion, operation, [(point, pmc, how far, what is asked for at least)]
    ("box", block(0, 0, 0, 2, 2, 2), [[0, 8], [0], [0]], "sweep",
     [((5, 1, 1), "in", 1, F(99, 100)), ((5, 1, 2 - TINY), "in", TINY, TINY / 2), ((5, 1, 2 + TINY), "out", TINY, TINY / 2), ((5, 1, 2), "on", 0, 0),
      ((5, 1, 4), "out", 2, F(199, 100)), ((F(1, 2), 1, 1), "in", F(1, 2), F(1, 4)), ((F(1, 3), F(1, 3), F(1, 3)), "in", F(1, 3), F(1, 6)),
      ((11, 1, 1), "out", 1, F(99, 100)), ((F(1, 3) + 10 ** 30, 1, 1), "out", 10 ** 30, 10 ** 29)]),
    ("plate", block(0, 0, 0, F(1, 100), 10, 10), [[0, 10], [0], [0]], "sweep",
     [((5, 5, 5), "in", 5, F(5, 2)), ((5, 1, 5), "in", 1, F(1, 2)), ((F(1, 10 ** 6), 5, 5), "in", F(1, 10 ** 6), F(1, 2 * 10 ** 6))]),
    ("square", Polygon([[box_ring(0, 0, 2, 2)]]), [[0], [0, 4]], "sweep", [((1, 3), "in", 1, F(1, 2)), ((1, 7), "out", 1, F(99, 100))]),
    ("stays", Polygon([[box_ring(0, 0, 4, 4)]]), [[0, 1], [0]], "unsweep",
     [((F(3, 2), 2), "in", F(3, 2), F(3, 4)), ((F(7, 2), 2), "out", F(1, 2), F(49, 100)), ((3, 2), "on", 0, 0)]),
    ("slit", Polygon([[box_ring(0, 0, 10, 10), box_ring(4, 2, F(201, 50), 8)]]), [[0, 3], [0]], "unsweep",
     [((F(5, 2), 5), "out", F(3, 2), F(3, 4)), ((2, F(5, 2)), "out", F(1, 2), F(1, 4)), ((5, 5), "in", F(49, 50), F(49, 100)), ((1, 5), "on", 0, 0)]),
    ("slit in space", joined(block(0, 0, 0, 10, 10, 10), inside_out(block(4, 2, 2, F(201, 50), 8, 8))), [[0, 3], [0], [0]], "unsweep",
     [((F(5, 2), 5, 5), "out", F(3, 2), F(3, 4)), ((2, F(5, 2), 5), "out", F(1, 2), F(1, 4))]),
    ("askew", Polygon([[box_ring(0, 0, 3, F(1, 50))]]), [[0, 1], [0, 4]], "sweep",
     [((2, 2), "in", 6 / ROOT_17, F(3, 4)), ((1, 2), "in", F(101, 50) / ROOT_17, F(1, 4)), ((F(5, 2), 2), "in", 4 / ROOT_17, F(1, 2)),
      ((2, F(1, 100)), "in", F(1, 100), F(1, 200)), ((F(3, 2), F(401, 100)), "in", F(1, 100), F(1, 200))]),
    ("resting", Polygon([[box_ring(-9, 0, 7, 3), ring((0, 0), (1, 1), (0, 2), (-1, 1))]]), [[0], [0, 4]], "sweep",
     [((F(1, 2), 1), "in", F(1, 2), F(1, 10)), ((F(1, 4), F(3, 2)), "in", F(1, 4), F(1, 20)), ((0, 1), "on", 0, 0)]),
    ("resting in space", joined(block(-9, -8, 0, 7, 8, 3), HOLLOW), [[0], [0], [0, 4]], "sweep",
     [((F(1, 2), 0, 1), "in", F(1, 2), F(1, 10)), ((F(1, 4), 0, F(3, 2)), "in", F(1, 4), F(1, 20)), ((0, 0, 1), "on", 0, 0)]),
    ("bar", Polygon([[box_ring(1, F(-1, 200), 2, F(1, 200))]]), QUARTER, "sweep", [((F(9, 10), F(6, 5)), "in", F(1, 2), F(1, 8))]),
]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def ask(graze, checks, name, solid, motion, points, *flags):
    """The rows, by name."""
    paths = (graze.write("solid" + solid.suffix, solid.text()), graze.write("motion.json", motion.text()),
             graze.write("points.csv", "".join(",".join(map(str, p)) + "\n" for p in points)))
    out = graze.call("classify", *paths, *flags)
    rows = list(csv.DictReader(line for line in out.stdout.splitlines() if not line.startswith("#")))
    checks.equal((out.returncode, len(rows)), (0, len(points)), name, out.stderr)
    return rows


def worked(graze, checks):
    for name, solid, way, operation, points in WORKED:
        motion = build([(0, 1, translate(way))]) if isinstance(way, list) else way
        rows = ask(graze, checks, name, solid, motion, [p for p, *_ in points], *ASK, "--operation", operation)
        for row, (p, pmc, far, least) in zip(rows, points):
            low = F(row["boundary_low"])
            checks.holds(row["pmc"] == pmc and least <= low <= far, name, p, row["pmc"], to_double(low), f"expected {to_double(least)} to {to_double(far)}")


def convex(graze, checks, args):
    """Thin parallelograms and triangles far along a line; points within, in shares of the corners and of the way."""
    rng = args.random
    for k in args.rounds(CONVEX, "convex"):
        along, across, way = ([F(rng.randint(-8, 8)) for _ in range(2)] for _ in range(3))
        if 0 in (along[0] * across[1] - along[1] * across[0], along[0] * way[1] - along[1] * way[0]):
            continue
        thin = [x / rng.choice((30, 200, 1000)) for x in across]
        corners = [(F(0), F(0)), tuple(along), tuple(map(sum, zip(along, thin))), tuple(thin)][:rng.choice((3, 4))]
        if along[0] * thin[1] < along[1] * thin[0]:
            corners.reverse()
        normals = [(b[1] - a[1], a[0] - b[0]) for a, b in zip(corners, corners[1:] + corners[:1])] + [(way[1], -way[0]), (-way[1], way[0])]
        limits = [max(dot(n, p) for p in corners) + max(0, dot(n, way)) for n in normals]
        points = []
        for _ in range(6):
            shares = [F(rng.randint(1, 40)) for _ in corners]
            t = F(rng.randint(1, 31), 32)
            points.append(tuple(sum(s * p[i] for s, p in zip(shares, corners)) / sum(shares) + t * way[i] for i in range(2)))
        motion = build([(0, 1, translate([[0, x] for x in way]))])
        for row, p in zip(ask(graze, checks, f"convex {k}", Polygon([[corners]]), motion, points, *ASK), points):
            squares = [(c - dot(n, p)) ** 2 / dot(n, n) for n, c in zip(normals, limits)]
            low = F(row["boundary_low"])
            checks.holds(row["pmc"] == "in" and min(squares) / 4 <= low ** 2 <= min(squares), f"convex {k}", corners, way, p, to_double(low),
                         to_double(min(squares)) ** 0.5)


def neighbours(p, low, rng):
    """Places nearer than `low`: along the axes, and in another direction u, |u| <= sum |u_i|."""
    for axis in range(len(p)):
        for sign in (-1, 1):
            yield tuple(x + sign * low * LESS * (k == axis) for k, x in enumerate(p))
    way = [F(rng.randint(-9, 9)) for _ in p]
    whole = sum(map(abs, way)) or 1
    yield tuple(x + low * LESS * u / whole for x, u in zip(p, way))


def law(graze, checks, scene, rng, operation):
    name, solid, motion = scene
    points = [p for _, p in mixed(solid, motion, rng, POINTS)]
    rows = ask(graze, checks, name, solid, motion, points, *ASK, "--operation", operation)
    near = [(q, row["pmc"], p) for p, row in zip(points, rows) if F(row["boundary_low"]) > 0 for q in neighbours(p, F(row["boundary_low"]), rng)]
    told, bounded = sum(row["pmc"] != "on" for row in rows), sum(F(row["boundary_low"]) > 0 for row in rows)
    checks.holds(2 * bounded >= told, name, operation, "most points have a bound", bounded, told)
    for row, (q, pmc, p) in zip(ask(graze, checks, name, solid, motion, [q for q, _, _ in near], "--quiet", "--columns", "pmc",
                                    "--operation", operation), near):
        checks.equal(row["pmc"], pmc, name, operation, ",".join(map(str, q)), "near", ",".join(map(str, p)))


def forms(graze, checks):
    """The column stands behind sdf_t in every form; the head says so, and the table continues and is read again."""
    paths = (graze.write("cube.off", block(0, 0, 0, 2, 2, 2).text()), graze.write("move.json", build([(0, 1, translate([[0, 8], [0], [0]]))]).text()),
             graze.write("points.csv", "x,y,z,id\n5,1,1,a\n5,1,4,b\n5,1,2,c\n"))
    ask_all = (*paths, *ASK, "--motion-error", "1/2", "--topo")
    whole = graze.call("classify", *ask_all).stdout
    lines = [line for line in whole.splitlines() if line[0] != "#"]
    checks.holds(lines[0].endswith(",word,id,sdf_low,sdf_high,sdf_t,boundary_low,certain,topo"), "columns", lines[0])
    checks.holds("# boundary-distance yes\n" in whole, "head", whole)
    again = graze.call("classify", *paths[:2], graze.write("table.csv", whole), *ASK, "--motion-error", "1/2", "--topo").stdout
    checks.equal([line for line in again.splitlines() if line[0] != "#"], lines, "the table as points")
    part = graze.write("part.csv", whole[:whole.index(lines[3])])
    graze.call("classify", *ask_all, "--resume", part)
    with open(part, encoding="utf-8") as file:
        checks.equal(file.read(), whole, "continued")
    records = [json.loads(line, parse_float=F, parse_int=F) for line in graze.call("classify", *ask_all, "--format", "jsonl").stdout.splitlines()]
    checks.equal([F(r["boundary_low"]) for r in records], [F(line.split(",")[-3]) for line in lines[1:]], "JSON Lines")
    out = graze.call("classify", *paths, "--boundary-distance")
    checks.equal((out.returncode, out.stderr), (2, "graze: --boundary-distance needs distances; expected --sdf beside it\n"), "without --sdf")


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    if args.derived:
        worked(graze, checks)
        forms(graze, checks)
    convex(graze, checks, args)
    for scene in scenes(args, SCENES):
        for operation in ("sweep", "unsweep"):
            law(graze, checks, scene, args.random, operation)
    checks.finish()


if __name__ == "__main__":
    main()
