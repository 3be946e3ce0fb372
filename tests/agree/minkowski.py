# suite
"""Straight translations against CGAL's Minkowski sum of the Nef polyhedron with the segment.

SPDX-License-Identifier: GPL-3.0-or-later

For one leg or several the open sweep is the union of int S + leg and the closed one of S + leg:
`in`, `on` and `out` of the program must be membership in these. CGAL's position in the closed
sweep as a point set must fit proofs/claims.md C18: `out` is exterior, `in` is interior, and every boundary
point is `on`.
"""
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import Fraction as F  # noqa: E402
from oracle import Oracle  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from motion import legs  # noqa: E402
from points import mixed  # noqa: E402
from shells import shells_text  # noqa: E402
from solids import Mesh, block, polygons, prism  # noqa: E402

POINTS = 30

# on in the open sweep, yet inside the closed one: the parts swept on two sides close (proofs/claims.md C19)
SEAM = {"cube closing a seam": [("seam", (F(4), F(1), F(1))), ("seam", (F(4), F(1, 3), F(7, 4)))]}


def spiked():
    """A cube with a pyramid on every side: 24 triangles, twelve reflex edges."""
    cube = block(-1, -1, -1, 1, 1, 1)
    vertices, facets = list(cube.vertices), []
    for f in cube.facets:
        middle = [sum(cube.vertices[k][i] for k in f) / 4 for i in range(3)]
        tip = len(vertices)
        vertices.append(tuple(F(5, 2) * x for x in middle))
        facets += [[a, b, tip] for a, b in zip(f, f[1:] + f[:1])]
    return Mesh(vertices, facets)


def scenes():
    ell = prism(polygons()["ell"].parts[0][0], 0, 2)
    cube = block(0, 0, 0, 2, 2, 2)
    return [
        ("cube along an axis", cube, [(0, 0, 0), (8, 0, 0)]),
        ("cube askew", cube, [(4, -4, 1), (-4, 4, F(1, 2))]),
        ("cube there and back by a corner", cube, [(0, 0, 0), (4, 4, 4), (4, 0, 4)]),
        ("cube closing a seam", cube, [(0, 0, 0), (2, 0, 0), (0, 4, 0), (8, 4, 0), (4, 0, 0),
                                       (8, 0, 0)]),
        ("ell along an edge", ell, [(0, 0, 0), (6, 0, 0)]),
        ("ell into its notch and out", ell, [(0, 0, 0), (-3, -3, 0), (-3, -3, 5)]),
        ("ell askew", ell, [(0, 0, 0), (5, 3, F(7, 3))]),
        ("star askew", spiked(), [(0, 0, 0), (5, 2, 1)]),
        ("star along a diagonal", spiked(), [(-3, -3, -3), (3, 3, 3)]),
    ]


def positions_of(oracle, solid, path, points):
    lines = [shells_text(solid), str(len(path) - 1)]
    lines += [" ".join(str(F(x)) for x in p + q) for p, q in zip(path, path[1:])]
    lines += [str(len(points))] + [" ".join(str(x) for x in p) for p in points]
    answer = oracle.ask("\n".join(lines) + "\n")
    return [line.split() for line in answer.text.splitlines()] if answer else []


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    oracle = Oracle(args, checks, "minkowski")
    seen = Counter()
    for _, (name, solid, path) in args.cycle(scenes()):
        motion = legs(path)
        points = mixed(solid, motion, args.random, POINTS) + SEAM.get(name, [])
        answers = graze.classify(name, solid, motion, [p for _, p in points])
        positions = positions_of(oracle, solid, path, [p for _, p in points])
        checks.equal(len(positions), len(points), name, "positions")
        for (kind, p), answer, (pmc, topological) in zip(points, answers or [], positions):
            where = (name, kind, ",".join(str(x) for x in p))
            checks.equal(answer.record["pmc"], pmc, *where, answer.word)
            allowed = {"in": ["interior"], "on": ["boundary", "interior"], "out": ["exterior"]}
            checks.holds(topological in allowed[answer.record["pmc"]], *where, answer.word,
                        topological)
            if kind == "seam":
                checks.equal((pmc, topological), ("on", "interior"), *where, "seam")
            seen[(kind, pmc, topological)] += 1
    for key, n in sorted(seen.items()):
        print(" ".join(f"{x:10}" for x in key), n)
    oracle.finish()
    checks.finish()


if __name__ == "__main__":
    main()
