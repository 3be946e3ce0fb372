#!/usr/bin/env python3
# suite
"""Solids of planes, and of lines in the plane, become polyhedra and polygons, which every command takes (C133).

Second methods: random trees beside the same tree within a ball that holds it, whose surfaces keep it a curved solid: the
classes and words of points are the same; and volumes of unions of boxes by their cells, of differences too, beside the volume
that the facets enclose. Facets and vertices of small solids are counted by hand.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import itertools
import json
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

from scenes import Checks, Curved, Graze, along, ball, box, common, halfspace, minus, options, union  # noqa: E402
from exact import Fraction as F  # noqa: E402
from harness import run, without_leaks  # noqa: E402

TETRAHEDRON = {"polyhedron": {"points": [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]],
                              "faces": [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]}}
PLACES = ["0", "1/2", "1", "-1", "3/2", "2", "-3", "-2", "1/3", "5/2"]
O3, CUBE = (0, 0, 0), box((0, 0, 0), (3, 3, 3))


def simplex(d):
    """x >= 0 in each coordinate, and their sum at most 1."""
    sides = [halfspace([-(i == k) for i in range(d)]) for k in range(d)]
    return common(*sides, halfspace([1] * d, 1))


def prism(points, low, high):
    return {"polygon": {"points": points, "extrude": [low, high]}}


# name, dimension, node, vertices, facets (in the plane edges); corners along one line count.
COUNTS = [
    ("cube", 3, CUBE, 8, 6),
    ("simplex of half-spaces", 3, simplex(3), 4, 4),
    ("triangle of half-planes", 2, simplex(2), 3, 3),
    ("cavity", 3, minus(CUBE, box((1, 1, 1), (2, 2, 2))), 16, 12),
    ("pocket", 3, minus(CUBE, box((1, 1, 1), (2, 2, 4))), 16, 11),          # its top is open; the cube's has a hole
    ("tunnel", 3, minus(CUBE, box((1, 1, -1), (2, 2, 4))), 16, 10),
    ("boxes that share a face", 3, union(CUBE, box((3, 0, 0), (6, 3, 3))), 8, 6),
    ("boxes that share an edge", 3, union(CUBE, box((3, 3, 0), (6, 6, 3))), 14, 12),
    ("boxes that share a corner", 3, union(CUBE, box((3, 3, 3), (6, 6, 6))), 15, 12),
    ("edge on a face", 3, union(CUBE, prism([[3, 1], [4, 0], [4, 2]], 1, 2)), 14, 11),
    ("three axes", 3, union(box((-2, -1, -1), (2, 1, 1)), box((-1, -2, -1), (1, 2, 1)), box((-1, -1, -2), (1, 1, 2))), 32, 30),
    ("frame", 2, minus(box((0, 0), (3, 3)), box((1, 1), (2, 2))), 8, 8),
    ("squares that share a corner", 2, union(box((0, 0), (1, 1)), box((1, 1), (2, 2))), 7, 8),
    ("quadrics that are planes", 3, common({"quadric": {"2,0,0": 1, "0,0,0": -1}}, {"quadric": {"0,2,0": 1, "0,0,0": -1}},
                                           {"quadric": {"0,0,2": 1, "0,0,0": -1}}), 8, 6),
    ("star of five points", 2, {"polygon": {"points": [[0, 3], [2, -3], [-3, 1], [3, 1], [-2, -3]]}}, 10, 15),      # its middle is out: five triangles
]
# Solids without facets, and why.
OTHERS = [
    ("half-space", 3, halfspace((1, 0, 0)), "unbounded"),
    ("half-plane", 2, halfspace((1, 2), 3), "unbounded"),
    ("all but a cube", 3, minus(union(halfspace((1, 0, 0)), halfspace((-1, 0, 0))), CUBE), "unbounded"),
    ("slab", 3, common(halfspace((1, 1, 0), 1), halfspace((-1, -1, 0), 1)), "unbounded"),
    ("boxes apart", 3, common(CUBE, box((4, 4, 4), (5, 5, 5))), "empty"),
    ("boxes side by side", 3, common(CUBE, box((3, 0, 0), (5, 5, 5))), "empty"),
    ("a box of 10^300", 3, box((0, 0, 0), (1, 1, 10**300)), "too large for a mesh"),
    ("nothing left", 2, minus(box((0, 0), (1, 1)), box((-1, -1), (2, 2))), "empty"),
]


def mesh_of(text):
    """Vertices and triangles of an OFF file."""
    words = text.split()
    count, faces = int(words[1]), int(words[2])
    points = [tuple(map(F, words[4 + 3 * k:7 + 3 * k])) for k in range(count)]
    at = 4 + 3 * count
    return points, [tuple(map(int, words[at + 4 * k + 1:at + 4 * k + 4])) for k in range(faces)]


def volume(text):
    points, triangles = mesh_of(text)
    total = F(0)
    for a, b, c in ([points[i] for i in t] for t in triangles):
        total += sum(a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]) for i in range(3))
    return total / 6


def random_box(random, d):
    low = [random.randint(-3, 2) for _ in range(d)]
    return box(low, [x + random.randint(1, 3) for x in low])


def random_prim(random, d):
    kind = random.randint(0, d)
    if kind == 1:
        normal = [random.randint(-2, 2) for _ in range(d)]
        half = halfspace(normal if any(normal) else [1] + [0] * (d - 1), F(random.randint(-2, 2), random.randint(1, 3)))
        return common(half, box([-2] * d, [2] * d)) if random.random() < 0.7 else common(half, simplex(d))
    if kind == 2:
        points = [[random.randint(-3, 3), random.randint(-3, 3)] for _ in range(random.randint(3, 5))]
        if len({p[0] for p in points}) == 1:
            return random_box(random, d)
        return {"polygon": {"points": points}} if d == 2 else prism(points, random.randint(-2, 0), random.randint(1, 2))
    return TETRAHEDRON if kind == 3 else random_box(random, d)


def random_node(random, d, depth):
    kind = random.randint(0, 4)
    if depth == 0 or kind == 0:
        return random_prim(random, d)
    if kind == 1:
        rows = [[random.randint(-1, 1) for _ in range(d)] for _ in range(d)]
        det = (rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0] if d == 2 else
               sum(rows[0][i] * (rows[1][(i + 1) % 3] * rows[2][(i + 2) % 3] - rows[1][(i + 2) % 3] * rows[2][(i + 1) % 3])
                   for i in range(3)))
        if det == 0:
            return random_node(random, d, depth - 1)
        matrix = [[str(x) for x in row] + [str(F(random.randint(-2, 2), random.randint(1, 3)))] for row in rows]
        return {"affine": {"matrix": matrix, "of": random_node(random, d, depth - 1)}}
    return [union, common, minus][kind - 2](*(random_node(random, d, depth - 1) for _ in range(random.randint(2, 3))))


def check_counts(checks, convert):
    for name, d, node, vertices, facets in COUNTS:
        done = convert(d, node)
        kind = "facets, cut" if d == 3 else "edges, written"
        checks.holds(done.returncode == 0 and f": {vertices} vertices and {facets} {kind}" in done.stderr, name,
                     f"{vertices} vertices, {facets} facets", done.stderr)
    for name, d, node, word in OTHERS:
        done = convert(d, node)
        where = "space: all its surfaces are planes" if d == 3 else "the plane: all its surfaces are lines"
        checks.holds(done.returncode == 3 and f"is a curved solid in {where}, but it is {word}, so it is taken as a curved "
                     "solid; convert takes polygons and polyhedra" in done.stderr, name, word, done.stderr)


def check_trees(args, checks, graze, convert):
    """Random trees by their facets, and within a ball by their signs."""
    taken = rows = 0
    for n in args.rounds(70, "trees"):
        d = args.random.choice((2, 3))
        node = random_node(args.random, d, args.random.randint(1, 3))
        points = [[args.random.choice(PLACES) for _ in range(d)] for _ in range(25)]
        motion = along(0, 1, "t", "t/2", *["0"] * (d - 2))
        done = convert(d, node)
        if done.returncode != 0:
            checks.holds("but it is empty" in done.stderr or "but it is unbounded" in done.stderr, json.dumps(node), done.stderr)
            continue
        taken += 1
        flat = graze.classify(f"tree {n}", Curved(d, node), motion, points)
        curved = graze.classify(f"tree {n} in a ball", Curved(d, common(node, ball([0] * d, 1000))), motion, points)
        for point, a, b in zip(points, flat, curved):
            rows += 1
            checks.equal((a.counts(), a.times()), (b.counts(), b.times()), json.dumps(node), *point)
    print(f"{taken} trees, {rows} rows")
    checks.holds(taken >= 30 * args.share, "too few trees have facets", taken)


def check_volumes(args, checks, convert):
    """A union of boxes without another one, by the cells of the lattice of integers."""
    for _ in args.rounds(6, "volumes"):
        some, others = ([random_box(args.random, 3) for _ in range(n)] for n in (12, 6))
        done = convert(3, minus(union(*some), union(*others)))

        def holds(parts, cell):
            return any(all(int(p["box"]["low"][i]) <= x < int(p["box"]["high"][i]) for i, x in enumerate(cell)) for p in parts)
        cells = sum(holds(some, c) and not holds(others, c) for c in itertools.product(range(-3, 6), repeat=3))
        checks.equal(done.returncode == 0 and volume(done.stdout), cells or False, "volume", done.stderr)


def check_commands(checks, graze, folder):
    """Commands that refuse curved solids take a pocket, and certificates of the converted file hold."""
    at = {name: os.path.join(folder, name) for name in ("s.csg.json", "b.csg.json", "m.json", "p.csv", "c.txt", "c.txt.off", "c.txt.json")}
    for name, d, node in (("s.csg.json", 3, minus(CUBE, box((1, 1, 1), (2, 2, 4)))), ("b.csg.json", 3, box((5, 1, 1), (6, 2, 2)))):
        with open(at[name], "w", encoding="ascii") as file:
            file.write(Curved(d, node).text())
    with open(at["m.json"], "w", encoding="ascii") as file:
        file.write(along(0, 1, "-4*t", "0", "0").text())
    with open(at["p.csv"], "w", encoding="ascii") as file:
        file.write("x,y,z\n0,0,0\n7,1,1\n9,0,0\n3/2,3/2,5/2\n")

    def taken(*words, says="", status=0):
        done = run([graze, *words])
        checks.holds(done.returncode == status and says in done.stdout, *words, done.stdout[:300], done.stderr)
    solid, motion, points = at["s.csg.json"], at["m.json"], at["p.csv"]
    taken("check", solid, motion, says="16 vertices")
    taken("classify", solid, motion, points, "--topo", says="\n9,0,0,out")
    taken("classify", solid, motion, points, "--sdf", "1/100", says="sdf_low")
    taken("collide", solid, motion, at["b.csg.json"], says="contact 1/2 ", status=1)     # x = 5
    taken("envelope", solid, motion)
    taken("boundary", solid, motion, "--depth", "3", says="closed")
    taken("certify", solid, motion, points, "-o", at["c.txt"])
    taken("judge", solid, motion, at["c.txt.off"], says="distance")
    done = run([graze + "-check", at["c.txt.off"], at["c.txt.json"], at["c.txt"]], env=without_leaks())
    checks.holds(done.returncode == 0, "graze-check", done.stdout, done.stderr)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "solid.csg.json")

        def convert(d, node):
            with open(path, "w", encoding="ascii") as file:
                file.write(Curved(d, node).text())
            return run([args.graze, "convert", path])
        if args.derived:
            check_counts(checks, convert)
            check_commands(checks, args.graze, folder)
        check_trees(args, checks, graze, convert)
        check_volumes(args, checks, convert)
    checks.finish()


if __name__ == "__main__":
    main()
