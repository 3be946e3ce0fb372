#!/usr/bin/env python3
# suite
"""`classify --at-rest` against CGAL's locator of Nef polyhedra: membership and signed distance, of meshes and polygons.

SPDX-License-Identifier: GPL-3.0-or-later

Points are vertices, points of edges and faces, those moved by 2^-40 along an axis, and points of a box around. A polygon
is asked as a prism from z = 0 to 2 at z = 1, where the floor and the roof are at a distance of 1; its own distance is
compared where CGAL's is less than that. CGAL reads no solid whose parts share a vertex: it is asked for each part alone,
and a point is in or on the solid where it is in or on one, as their interiors are apart. The polygon whose hole touches
its outer ring has no such parts, and is left out.
"""
import csv
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
for folder in ("lib", os.path.join("agree", "lib"), "agree"):
    sys.path.insert(0, os.path.join(HERE, "..", folder))

from exact import Fraction as F, to_double  # noqa: E402
from minkowski import spiked  # noqa: E402
from oracle import Oracle  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from shells import components, shells_text  # noqa: E402
from solids import Mesh, Polygon, extruded, meshes, polygons  # noqa: E402

PLACE = {"in": "interior", "on": "boundary", "out": "exterior"}
APART = {"tip_on_face": "tip_on_face", "edge_shared": "edge_touch", "corner_shared": "corner_touch"}
POINTS = 40            # of a box around each solid
NEAR = F(1, 2 ** 40)
TOLERANCE = F(1, 10 ** 9)


def solids():
    """(name, solid, the meshes that CGAL is given)"""
    known = {**meshes(), "spiked": spiked()}
    for name, mesh in known.items():
        apart = known[APART.get(name, name)]
        yield name, mesh, [Mesh(apart.vertices, part) for part in components(apart)] if name in APART else [mesh]
    for name, polygon in polygons().items():
        if name != "touch":
            parts = [Polygon([part]) for part in polygon.parts] if name == "pinch" else [polygon]
            yield name, polygon, [extruded(part, [0, 2])[0] for part in parts]


def chosen(rng, solid):
    """Points on the boundary, near it, and anywhere around."""
    points = [p for _, p in solid.cell_points(rng)]
    for p in list(points):
        axis, side = rng.randrange(solid.dimension), rng.choice((-1, 1))
        points.append(tuple(x + side * NEAR if k == axis else x for k, x in enumerate(p)))
    ends = [(min(v[k] for v in solid.vertices), max(v[k] for v in solid.vertices)) for k in range(solid.dimension)]
    points += [tuple(F(round(64 * a) + rng.randint(-32, round(64 * (b - a)) + 32), 64) for a, b in ends) for _ in range(POINTS)]
    return points


def asked_of(oracle, parts, points):
    """(place, square of the distance) of each point."""
    lifted = "\n".join(" ".join(map(str, (*p, *([1] * (3 - len(p)))))) for p in points)
    found = []
    for mesh in parts:
        answer = oracle.ask(f"{shells_text(mesh)}{len(points)}\n{lifted}\n")
        rows = [line.split() for line in answer.text.splitlines()] if answer else []
        found.append([(place, F(square)) for place, square in rows])
    return [(min((place for place, _ in row), key=["interior", "boundary", "exterior"].index), min(square for _, square in row))
            for row in zip(*found)]


def check(checks, graze, oracle, name, solid, parts, points):
    asked = graze.write("points.csv", "".join(",".join(map(str, p)) + "\n" for p in points))
    done = graze.call("classify", graze.write("solid" + solid.suffix, solid.text()), asked, "--at-rest", "--quiet", "--sdf", str(TOLERANCE))
    checks.equal((done.returncode, done.stderr), (0, ""), name)
    rows = list(csv.DictReader(line for line in done.stdout.splitlines() if not line.startswith("#")))
    places = asked_of(oracle, parts, points)
    checks.equal((len(rows), len(places)), (len(points), len(points)), name, "rows")
    for p, row, (place, square) in zip(points, rows, places):
        where = name, ",".join(map(str, p))
        low, high = sorted((abs(F(row["sdf_low"])), abs(F(row["sdf_high"]))))
        checks.equal(PLACE[row["pmc"]], place, *where)
        checks.holds(F(row["sdf_high"]) - F(row["sdf_low"]) <= TOLERANCE, *where, row)
        checks.holds((F(row["sdf_high"]) <= 0) if place == "interior" else (F(row["sdf_low"]) >= 0), *where, row)
        if solid.dimension == 3 or square < 1:
            checks.holds(low * low <= square <= high * high, *where, row, to_double(square) ** .5)
    return {place for place, _ in places}


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    oracle = Oracle(args, checks, "places")
    for _, (name, solid, parts) in args.cycle(solids(), 1, "solids"):
        kinds = check(checks, graze, oracle, name, solid, parts, chosen(args.random, solid))
        checks.equal(len(kinds), 3, name, "answers of every kind")
    oracle.finish()
    checks.finish()


if __name__ == "__main__":
    main()
