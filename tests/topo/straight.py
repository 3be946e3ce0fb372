#!/usr/bin/env python3
# suite
"""The position in the closed sweep along straight legs, against CGAL's Minkowski sums.

SPDX-License-Identifier: GPL-3.0-or-later

A plane scene is a prism over [0, 2] in CGAL, and its points lie at height 1: near these the closed sweep is that of
the plane times an interval. Boxes that walk on a lattice make many seams: `on`, and yet interior.
"""
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import Fraction as F  # noqa: E402
from motion import legs  # noqa: E402
from oracle import Oracle  # noqa: E402
from points import degenerate  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from shells import shells_text  # noqa: E402
from solids import Polygon, block, box_ring, extruded, joined, meshes, polygons, prism, ring  # noqa: E402
from witnesses import check_witness  # noqa: E402

POINTS = 150
# The least share of seams and of decided points among those that are `on`, of all scenes.
SEAMS, SPACE_DECIDED = 0.001, 1


def walk(rng, dimension, steps, size):
    path = [tuple(rng.randint(-size, size) for _ in range(dimension))]
    while len(path) < steps:
        step = [0] * dimension
        if rng.random() < 0.6:
            step[rng.randrange(dimension)] = rng.choice([-4, -2, -1, 1, 2, 4])
        else:
            step = [rng.randint(-3, 3) for _ in range(dimension)]
        if any(step):
            path.append(tuple(a + b for a, b in zip(path[-1], step)))
    return path


def unit_steps(rng, dimension, steps):
    """Steps of a unit box along the axes."""
    path = [(0,) * dimension]
    while len(path) < steps:
        step = [0] * dimension
        step[rng.randrange(dimension)] = rng.choice([-1, 1])
        path.append(tuple(a + b for a, b in zip(path[-1], step)))
    return path


# Boundary points of a scene whose witness is looked at.
WITNESSES = 2


def lattice(rng, solid, path, count):
    """Points of the lattice, and halves, near vertices carried to corners of the path."""
    out = []
    for _ in range(count):
        v, b = rng.choice(solid.vertices), rng.choice(path)
        out.append(("lattice", tuple(x + y + F(rng.randint(-2, 2), 2) for x, y in zip(v, b))))
    return out


def plane_scenes(args, passes):
    rng, boxes = args.random, Polygon([[box_ring(0, 0, 2, 2)]])
    pair = Polygon([[box_ring(0, 0, 1, 1)], [box_ring(1, 1, 2, 2)]])
    two = Polygon([[box_ring(0, 0, 1, 1)], [box_ring(3, 0, 4, 2)]])
    chosen = {"box": boxes, "pair": pair, "two": two, "tips": Polygon(
        [[ring((0, 0), (-1, -2), (1, -2))], [ring((0, 6), (1, 8), (-1, 8))]]), **polygons()}
    for name in ("star", "islands", "touch", "pinch"):
        del chosen[name]
    ways = [(name, solid, lambda: walk(rng, 2, rng.randint(3, 6), 3)) for name, solid in chosen.items()]
    ways.append(("long walk", boxes, lambda: walk(rng, 2, 10, 1)))
    ways.append(("unit steps", Polygon([[box_ring(0, 0, 1, 1)]]), lambda: unit_steps(rng, 2, 16)))
    for k, (name, solid, way) in args.cycle(ways, passes, "plane"):
        yield f"{name} {k}", solid, way()


def space_scenes(args, passes):
    rng, all_meshes = args.random, meshes()
    chosen = {"box": block(0, 0, 0, 2, 2, 2),
              **{name: all_meshes[name] for name in ("ell3", "arrow", "octahedron")}}
    ways = [(name, solid, lambda: walk(rng, 3, rng.randint(2, 4), 2)) for name, solid in chosen.items()]
    ways.append(("unit steps", block(0, 0, 0, 1, 1, 1), lambda: unit_steps(rng, 3, 16)))
    for k, (name, solid, way) in args.cycle(ways, passes, "space"):
        yield f"{name} {k}", solid, way()


def positions_of(oracle, solid, path, points):
    if solid.dimension == 2:
        holes = any(len(part) > 1 for part in solid.parts)
        solid = extruded(solid, [0, 2])[0] if holes else joined(*(prism(part[0], 0, 2) for part in solid.parts))
        path = [p + (0,) for p in path]
        points = [p + (F(1),) for p in points]
    lines = [shells_text(solid), str(len(path) - 1)]
    lines += [" ".join(str(F(x)) for x in p + q) for p, q in zip(path, path[1:])]
    lines += [str(len(points))] + [" ".join(str(x) for x in p) for p in points]
    answer = oracle.ask("\n".join(lines) + "\n")
    return [line.split() for line in answer.text.splitlines()] if answer else []


def check_scene(checks, graze, oracle, rng, seen, name, solid, path):
    motion = legs(path)
    points = lattice(rng, solid, path, POINTS) + degenerate(solid, motion, rng, POINTS // 3)
    points = [p for _, p in points]
    answers = graze.classify(name, solid, motion, points, "--topo")
    on = [(a.record, p) for a, p in zip(answers or [], points) if a.record["pmc"] == "on"]
    space = solid.dimension == 3
    positions = positions_of(oracle, solid, path, [p for _, p in on])
    checks.equal(len(positions), len(on), name, "positions")
    for (record, p), (pmc, position) in zip(on, positions):
        where = (name, path, ",".join(str(x) for x in p), record["word"], record.get("topo_level"))
        checks.equal(pmc, "on", *where)
        seen[space, position, record.get("topo_level", "undecided")] += 1
        if record["topo"] == "undecided":
            checks.holds(space, *where, "undecided in the plane")
        else:
            checks.equal(record["topo"], position, *where)
    witnessed = [(record, p) for record, p in on if record["topo"] == "boundary"][:WITNESSES]
    for record, p in witnessed:
        check_witness(checks, graze, name, (solid, motion), p, record)


def check_shares(checks, seen, args):
    for space in (False, True):
        of = {key: n for key, n in seen.items() if key[0] == space}
        total = sum(of.values())
        seams = sum(n for key, n in of.items() if key[1] == "interior")
        decided = total - sum(n for key, n in of.items() if key[2] == "undecided")
        checks.holds(total > 0 and (seams >= SEAMS * total or not args.ample), "space" if space else "plane", f"{seams} seams of {total}")
        boundary = {key[2] for key in of if key[1] == "boundary"}
        checks.holds(boundary <= {"first_order", "undecided"}, f"a direction is the witness of all on the boundary: {boundary}")
        checks.holds(decided >= (SPACE_DECIDED if space else 1) * total, f"{decided} of {total} decided")


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    oracle = Oracle(args, checks, "minkowski")
    seen = Counter()
    for name, solid, path in plane_scenes(args, 2):
        check_scene(checks, graze, oracle, args.random, seen, name, solid, path)
    for name, solid, path in space_scenes(args, 1):
        check_scene(checks, graze, oracle, args.random, seen, "space " + name, solid, path)
    for (space, position, level), n in sorted(seen.items()):
        print("space" if space else "plane", f"{position:10} {level:10}", n)
    check_shares(checks, seen, args)
    oracle.finish()
    checks.finish()


if __name__ == "__main__":
    main()
