#!/usr/bin/env python3
# suite
"""`graze envelope --patches` and `--joints` on scenes derived by hand: a cube along a line, a turning block, a dart, slides, an edge with two runs, breaks.

SPDX-License-Identifier: GPL-3.0-or-later

Each case has its derivation above it: patches as (kind, cell, from, to, a, b, theta_a, theta_b), with statuses where they are evident, and joints as
(cell, from, to, form, cells of its patches).
"""
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contact"))

import hand as contact  # noqa: E402
from hand import moves, prism_of, shift  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from reading import table  # noqa: E402

CUSP = "root(-2 3 0 1;0;1)"
CUBE = prism_of([[(0, 0), (2, 0), (2, 2), (0, 2)]], 0, 2)
CORNERS = [(x, y, z) for z in (0, 2) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
UNIT = prism_of([[(0, 0), (1, 0), (1, 1), (0, 1)]], 0, 1)
QUARTER = {"rotate": {"tan_half": "1"}}


def point(cell, start, end):
    return ("point", cell, start, end, "", "", "", "")


def outline():
    """Along (8, 4, 2) the facets x = 2, y = 2, z = 2 move out and the others in: in contact are the edges between one of each and the corners that have
    both, all but (2, 2, 2) and (0, 0, 0). They are a hexagon, which is simple: every other position is somewhere else on the line."""
    edges = [(i, j) for i in range(8) for j in range(i) if sum(a != b for a, b in zip(CORNERS[i], CORNERS[j])) == 1]
    kept = [sorted(e) for e in edges if {a for a, b in zip(CORNERS[e[0]], CORNERS[e[1]]) if a == b} == {0, 2}]
    corners = [k for k in range(8) if set(CORNERS[k]) == {0, 2}]
    patches = [("run", "edge %d-%d" % tuple(e), "0", "1") + tuple(sorted(f"vertex {k}" for k in e)) + ("", "") for e in kept]
    joints = [(f"vertex {k}", "0", "1", "closed",
               tuple(sorted([f"vertex {k}"] + ["edge %d-%d" % tuple(e) for e in kept if k in e]))) for k in corners]
    return patches + [point(f"vertex {k}", "0", "1") for k in corners], joints


CASES = [
    (CUBE, moves(3, (0, 1, shift("8*t", "4*t", "2*t"))), *outline(), "simple"),
    # The slice of x = 2 is at y = 1 - t^2, with theta of the sign of 2 - 3t - t^3; that of x = 4 at the same y, theta < 0 (tests/envelope/hand.py). g at the corners: at
    # (4, 1) - of x = 4 and + of y = 1; at (4, -1) the opposite; at (2, -1) both -; at (2, 1) both +.
    (contact.BLOCK, contact.ALONG,
     [("slice", "edge 0-3", "0", CUSP, "edge 0-3", "edge 0-3", "+", "+"), ("slice", "edge 0-3", CUSP, "1", "edge 0-3", "edge 0-3", "-", "-"),
      ("slice", "edge 1-2", "0", "1", "edge 1-2", "edge 1-2", "-", "-"), point("vertex 1", "0", "1"), point("vertex 2", "0", "1")],
     [("edge 0-3", CUSP, CUSP, "", ("edge 0-3", "edge 0-3"))], None),
    # b' = (1, t). g is 1 - t of the edge 1-2, and -1 - t of 2-3, -3 + t of 0-1, 3 + t of 3-0: the corners 0 and 3 have both signs all the time, 1 up to t = 1; 2 is the
    # reflex one.
    (contact.DART, moves(2, ("1/2", "3/2", shift("t", "t^2/2"))),
     [point("vertex 0", "1/2", "3/2"), point("vertex 1", "1/2", "1"), point("vertex 3", "1/2", "3/2")], [], None),
    # Top and bottom slide, from corner to corner.
    (contact.SQUARE, contact.RIGHT,
     [("whole", edge, "0", "1", "", "", "", "") for edge in ("edge 0-1", "edge 2-3")] + [point(f"vertex {k}", "0", "1") for k in range(4)],
     [(f"vertex {k}", "0", "1", "", ("edge %s" % ("0-1" if k < 2 else "2-3"), f"vertex {k}")) for k in range(4)], "slides"),
]

# The unit cube of tests/envelope/curve.py, two_runs, with t^2 for t: at t = 0 every g vanishes, once. Of the velocity over 2t the limit is (2z - 2/3, 4/3 - 2z, 2y - 2x), so the
# slice of x = 1 (face 3) comes to z = 1/3 and that of y = 1 (face 4) to z = 2/3, from both sides of t = 0; on the edge between them runs from z = 0 to 1/3 and from 2/3 to 1.
TWICE = moves(3, ("-1/16", "1/16", {"compose": [{"quaternion": ["1", "t^2", "t^2", "0"]}, shift("-2/3*t^2", "4/3*t^2", "0")]}))
# A block turns about the origin, and its slice of x = 2 stays at (2, 0); then it turns on, at another speed, while it moves by p. With s = t - 1 and w = 2/(1+s^2), in the frame of
# a quarter turn g of x = 2 is -w y + p' (1-s^2)/(1+s^2), up to its sign: with p = s^2 the slice goes on from y = 0, with p = s it begins at y = 1/2. The same with x = 4.


def turn_on(p):
    more = {"compose": [{"rotate": {"tan_half": "t-1"}}, shift(p, "0"), QUARTER]}
    return moves(2, (0, 1, {"rotate": {"tan_half": "t"}}), (1, "5/4", more))


AT_BREAKS = [
    (UNIT, TWICE, "0", "edge 2-6", [("edge 2-6",) * 2 + ("face 3",) * 2, ("edge 2-6",) * 2 + ("face 4",) * 2]),
    (contact.BLOCK, turn_on("(t-1)^2"), "1", "edge 0-3", [("edge 0-3",) * 2]),
    (contact.BLOCK, turn_on("(t-1)^2"), "1", "edge 1-2", [("edge 1-2",) * 2]),
    (contact.BLOCK, turn_on("t-1"), "1", "edge 0-3", []),
    (contact.BLOCK, turn_on("t-1"), "1", "edge 1-2", []),
]


def run(graze, checks, tag, solid, motion):
    files = [graze.write(tag + end, text) for end, text in
             ((".off" if solid.startswith("OFF") else ".wkt", solid), (".json", motion), ("-patches.csv", ""), ("-joints.csv", ""))]
    done = graze.call("envelope", *files[:2], "--patches", files[2], "--joints", files[3])
    checks.equal(done.returncode, 0, tag, done.stderr)
    return table(files[2]), table(files[3])


def cells_of(patches, row):
    return tuple(sorted(patches[int(k)]["cell"] for k in row["patches"].split(" ")))


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    for number, (solid, motion, want, meet, status) in enumerate(CASES):
        patches, joints = run(graze, checks, f"case{number}", solid, motion)
        told = [tuple(r[k] for k in ("kind", "cell", "from", "to")) + tuple(sorted((r["a"], r["b"]))) + (r["theta_a"], r["theta_b"]) for r in patches]
        checks.equal(Counter(told), Counter(want), "case", number, "patches")
        checks.equal([int(r["patch"]) for r in patches], list(range(len(patches))), "case", number, "numbers")
        met = [(r["cell"], r["from"], r["to"], r["form"], cells_of(patches, r)) for r in joints]
        checks.equal(Counter(met), Counter(meet), "case", number, "joints")
        checks.holds(status is None or {r["status"] for r in patches} == {status}, "case", number, "status")
    for number, (solid, motion, time, cell, want) in enumerate(AT_BREAKS):
        patches, joints = run(graze, checks, f"break{number}", solid, motion)
        met = [cells_of(patches, r) for r in joints if r["from"] == r["to"] == time and r["cell"] == cell]
        checks.equal(sorted(met), sorted(want), "break", number)
        slices = {(r["from"], r["to"]) for r in patches if r["cell"] == cell}
        checks.holds({a == time for a, _ in slices} == {True, False}, "break", number, slices)
    checks.finish()


if __name__ == "__main__":
    main()
