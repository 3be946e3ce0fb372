#!/usr/bin/env python3
# suite
"""Golden polygons as `polygon`, convex golden polyhedra as intersections of half-spaces: words, times, classes are those of
the meshes, in both operations, folds and overlaps (C94 to C97).

The meshes are traced by their simplices, the expressions by signs of planes: nothing but the roots of polynomials is shared. A
ball around all keeps them from becoming meshes.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

from scenes import Checks, Curved, Graze, ball, common, halfspace, options, union  # noqa: E402
from exact import Fraction as F  # noqa: E402

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
LARGEST = 24  # facets


def polygon_of(text):
    """The polygons of a WKT file."""
    parts = []
    for body in re.findall(r"\((\s*\([^()]*\)(?:\s*,\s*\([^()]*\))*\s*)\)", text):
        rings = [[p.split() for p in ring.split(",")] for ring in re.findall(r"\(([^()]*)\)", body)]
        parts.append({"polygon": {"points": rings[0][:-1], "holes": [r[:-1] for r in rings[1:]]}})
    return parts


def halfspaces_of(text):
    """The half-spaces of a convex OFF file, or None."""
    words = [w for line in text.splitlines() for w in line.split("#")[0].split()]
    if words[0] != "OFF":
        return None
    count, faces = int(words[1]), int(words[2])
    at = 4
    points = [tuple(F(w) for w in words[at + 3 * k:at + 3 * k + 3]) for k in range(count)]
    at += 3 * count
    planes = set()
    if faces > LARGEST:
        return None
    for _ in range(faces):
        size = int(words[at])
        corners = [points[int(w)] for w in words[at + 1:at + 1 + size]]
        at += 1 + size
        a, b, c = corners[:3]
        u, v = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        offset = sum(x * y for x, y in zip(n, a))
        if any(sum(x * y for x, y in zip(n, p)) > offset for p in points):
            return None
        planes.add((n, offset))
    return [halfspace(n, d) for n, d in sorted(planes)]


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    scenes = rows = 0
    for folder in args.once(sorted(glob.glob(os.path.join(ROOT, "cases", "*", "")))):
        name = os.path.basename(os.path.dirname(folder))
        readme, flat = read(folder + "README.md"), os.path.exists(folder + "solid.wkt")
        if not os.path.exists(folder + "motion.json") or not flat and not os.path.exists(folder + "solid.off"):
            continue
        parts = polygon_of(read(folder + "solid.wkt")) if flat else halfspaces_of(read(folder + "solid.off"))
        if not parts:
            continue
        node = union(*parts) if flat else common(*parts)
        flags, around = [], (0, 0) if flat else (0, 0, 0)
        for line in re.findall(r"^options: (.*)$", readme, re.M):
            words = line.split()
            for k in range(0, len(words) - 1):
                if words[k] in ("--folds", "--operation"):
                    flags += words[k:k + 2]
        points = [line.split(",")[:2 if flat else 3] for line in read(folder + "points.csv").splitlines()[1:]]
        mesh = folder + ("solid.wkt" if flat else "solid.off")
        for operation in ("sweep", "unsweep"):
            more = flags if "--operation" in flags else [*flags, "--operation", operation]
            want = graze.classify(name, mesh, folder + "motion.json", points, *more)
            got = graze.classify(name + " curved", Curved(len(around), common(node, ball(around, 10**6))), folder + "motion.json", points, *more)
            if not want or not got:
                continue
            scenes += 1
            for point, a, b in zip(points, want, got):
                rows += 1
                checks.equal(b.counts(), a.counts(), name, operation, *point)
                checks.equal((b.times(), b.kinds()), (a.times(), a.kinds()), name, operation, *point, "times")
    print(f"{scenes} scenes, {rows} rows")
    checks.holds(scenes >= 60 * args.share and rows >= 700 * args.share, f"only {scenes} scenes, {rows} rows")
    checks.finish()


if __name__ == "__main__":
    main()
