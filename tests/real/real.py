#!/usr/bin/env python3
# suite
"""Real meshes, where they lie beside the checkout: legal ones pass and illegal ones are refused for the right reason,
and the law of time reversal holds on generated points.

The meshes are not part of the project; without them this is one skip, `SKIP shared-data`.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import Checks, options, run  # noqa: E402

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "shared", "data")

# The number of facets of each file as its OFF header or STL size gives it, and components by the data's README.
LEGAL = {"cgal_bunny00.off": 75408, "cgal_hole.off": 28, "cgal_joint.off": 446, "cgal_knot2.off": 11520,
         "cgal_rotor.off": 1200, "cgal_star.off": 24, "igltut_bunny.off": 6966, "manifold_88566.stl": 5344}
# Why each of these bounds no solid: seen with an independent program, as the data's README says.
ILLEGAL = {"cgal_cow.off": "facets ", "cgal_cube-ouvert.off": "open", "cgal_degtri_sliding.off": "facet",
           "cgal_tetrahedron.off": "inside out", "manifold_boxNotManifold.obj": "edge"}

FORWARD = ('{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"compose": ['
           '{"rotate": {"axis": ["0", "0", "1"], "tan_half": "t"}}, {"translate": ["t", "t/2", "t^2/4"]}]}}]}')
BACKWARD = ('{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"compose": ['
            '{"rotate": {"axis": ["0", "0", "1"], "tan_half": "1-t"}}, '
            '{"translate": ["1-t", "(1-t)/2", "(1-t)^2/4"]}]}}]}')
REVERSED_CASE = {1: 1, 2: 4, 3: 7, 4: 2, 5: 5, 6: 8, 7: 3, 8: 6, 9: 9}

checks = Checks()
check = checks.holds


def graze(program, *arguments):
    return run([program, *arguments], 600)


def rows(table):
    return [line.split(",") for line in table.splitlines() if not line.startswith("#")][1:]


def reverse(program, solid, folder, points):
    forward, backward = os.path.join(folder, "f.json"), os.path.join(folder, "b.json")
    for path, text in ((forward, FORWARD), (backward, BACKWARD)):
        with open(path, "w", encoding="ascii") as file:
            file.write(text)
    made = graze(program, "generate", solid, forward, "-n", str(points), "--seed", "11")
    check(made.returncode == 0, f"{solid}: generate: {made.stderr}")
    query = os.path.join(folder, "points.csv")
    with open(query, "w", encoding="ascii") as file:
        file.write(made.stdout)
    there = rows(graze(program, "classify", solid, forward, query).stdout)
    back = rows(graze(program, "classify", solid, backward, query).stdout)
    check(len(there) == points and len(back) == points, f"{solid}: {len(there)}, {len(back)} rows")
    for a, b in zip(there, back):
        same = (a[:5] == b[:5] and a[7:9] == b[7:9] and a[9] == b[9][::-1] and
                int(b[6]) == REVERSED_CASE[int(a[6])])
        check(same, f"{solid}: {a} reversed is {b}")


def main():
    args = options(__doc__)
    if not os.path.isdir(DATA):
        checks.skip("shared-data", "the real meshes do not lie beside the checkout")
        checks.finish()
    with tempfile.TemporaryDirectory() as folder:
        motion = os.path.join(folder, "motion.json")
        with open(motion, "w", encoding="ascii") as file:
            file.write(FORWARD)
        for name, facets in LEGAL.items():
            solid = os.path.join(DATA, "valid", name)
            done = graze(args.graze, "check", solid, motion)
            check(done.returncode == 0 and f" {facets} facets" in done.stdout,
                  f"{name}: {done.stdout}{done.stderr}")
            reverse(args.graze, solid, folder, 20 * max(1, int(args.scale)))
        for name, reason in ILLEGAL.items():
            done = graze(args.graze, "check", os.path.join(DATA, "refused", name), motion)
            check(done.returncode == 1 and reason in done.stderr,
                  f"{name}: exit {done.returncode}: {done.stderr}")
    checks.finish()


if __name__ == "__main__":
    main()
