#!/usr/bin/env python3
# suite
"""`graze envelope` on scenes derived by hand: events, whether the envelope is decomposable and why, cells of parts that touch.

SPDX-License-Identifier: GPL-3.0-or-later

Each case has its derivation above it.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contact"))

import hand as contact  # noqa: E402  (tests/contact/hand.py: its solids and motions)
from hand import moves, off, prism_of, shift  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from reading import summary, table  # noqa: E402

THETA, REFLEX, BREAK = "theta is negative on a slice", "a slice crosses a reflex edge", \
    "contact on one side of a break, into the solid on the other"
VERTEX, PIECES = "a slice or run reaches a vertex and enters the solid there", "the motion has a break"
ZERO = "theta is not positive on a closed slice"
CUBE = prism_of([[(0, 0), (2, 0), (2, 2), (0, 2)]], 0, 2)
SLAB = prism_of([[(0, 0), (1, 0), (1, 1), (0, 1)]], -1, 0)
FAR_SLAB = prism_of([[(1, 1), (2, 1), (2, 2), (1, 2)]], -1, 0)


def sheared(*last_row):
    """(x, y, z) -> (x, y, a x + b y + z + r)"""
    return {"matrix": [["1", "0", "0", "0"], ["0", "1", "0", "0"], list(last_row)]}


BOTTOM, FRONT = "face 0", "face 2"
BOX = prism_of([[(0, 0), (4, 0), (4, 5), (0, 5)]], 0, 2)
SHRUNK_AND_TURNED = {"compose": [{"scale": "1-t/2", "center": ["1", "0", "0"]},
                                 {"quaternion": ["1", "0", "t", "-t/2"], "center": ["1", "1", "1"]}]}
LEAVES = {("1/2", "singular", FRONT, FRONT, "", ""), ("4/5", "singular", BOTTOM, BOTTOM, "", "")}


MIRRORED_BLOCK = "POLYGON ((-2 -1, -4 -1, -4 1, -2 1, -2 -1))\n"
# g of y = 1 is (2x - 4t)/(1+t^2), of y = -1 its opposite; of x = 2 it is 2 (y + t^2 - 1)/(1+t^2), of x = 4 its opposite. So
# g is 0 at the corners (2, 1), (4, 1) at t = 0 and, of y = 1 and y = -1, at the left corners at t = 1. Where g = 0, y = 1 -
# t^2, theta of x = 2 is 4 (2 - 3t - t^3)/(1+t^2)^2, of x = 4 it is 4 (t^3 + 3t - 4)/(1+t^2)^2, 0 at t = 1.
ALONG = [("0", "reach", "edge 1-2", "vertex 2", "", "-"), ("0", "reach", "edge 0-3", "vertex 3", "", "+"),
         ("root(-2 3 0 1;0;1)", "cusp", "edge 0-3", "edge 0-3", "+", "-"),
         ("1", "reach", "edge 0-1", "vertex 0", "-", ""), ("1", "reach", "edge 2-3", "vertex 3", "+", ""),
         ("1", "cusp", "edge 1-2", "edge 1-2", "-", "")]

CASES = [
    # Turning about the origin: g of x = 2 is 0 at (2, 0) all the time, of x = 4 at (4, 0), of the others never. theta < 0 on x = 4.
    (contact.BLOCK, contact.STILL, "no", THETA, []),
    (contact.BLOCK, contact.ALONG, "no", THETA, ALONG),
    # The mirrored body under x -> -x first: the same speeds.
    (MIRRORED_BLOCK, contact.MIRRORED, "no", THETA, ALONG),
    # All g are constant and not 0; the edge run that ends at the notch meets the upper part.
    (contact.L_PRISM, moves(3, (0, 4, shift("t", "t", "t"))), "no", VERTEX, []),
    # The prism along y: the notch's faces slide, and so does the edge between them; nothing moves across it.
    (contact.L_PRISM, moves(3, (0, 4, shift("0", "t", "0"))), "undecided",
     "a slice or run reaches a reflex edge or a vertex that is not convex", []),
    # Along x the floor of the notch slides towards its wall.
    (contact.L_PRISM, moves(3, (0, 4, shift("t", "0", "0"))), "no", REFLEX, []),
    # b' = (1, t): only the edge from (-2, -3) to the notch (0, -1), normal (1, -1), has g = 1 - t = 0, at t = 1, with theta = 1 >
    # 0 everywhere. There the other edge at the notch has g = -2.
    (contact.DART, moves(2, ("1/2", "3/2", shift("t", "t^2/2"))), "no", VERTEX,
     [("1", "reach", "edge 1-2", "vertex 1", "+", "-"), ("1", "reach", "edge 1-2", "vertex 2", "+", "-")]),
    # Up to it the notch is reached at the end alone, and nothing enters.
    (contact.DART, moves(2, ("1/2", "1", shift("t", "t^2/2"))), "undecided",
     "a slice or run reaches a reflex edge or a vertex that is not convex",
     [("1", "reach", "edge 1-2", "vertex 1", "+", ""), ("1", "reach", "edge 1-2", "vertex 2", "+", "")]),
    # Past it none is 0.
    (contact.DART, moves(2, ("5/4", "3/2", shift("t", "t^2/2"))), "yes", None, []),
    # b' = (1, t), to the other side: theta of the edge is b''(1, -1) = -1 for t^2/2 with the opposite sign.
    (contact.DART, moves(2, ("1/2", "3/2", shift("t", "2*t-t^2/2"))), "no", THETA,
     [("1", "reach", "edge 1-2", "vertex 1", "-", "+"), ("1", "reach", "edge 1-2", "vertex 2", "-", "+")]),
    # A square slides along x all the time; there and back; to the right and on, slower: a jump of velocity but of no sign.
    (contact.SQUARE, contact.RIGHT, "yes", None, []),
    (contact.SQUARE, contact.STAND, "yes", None, []),
    (contact.SQUARE, contact.BACK, "undecided", PIECES,
     [("1", "reach", "edge 0-3", "vertex 0", "-", "+"), ("1", "reach", "edge 1-2", "vertex 1", "+", "-"),
      ("1", "reach", "edge 1-2", "vertex 2", "+", "-"), ("1", "reach", "edge 0-3", "vertex 3", "-", "+")]),
    (contact.SQUARE, contact.ON, "undecided", PIECES, []),
    (contact.SQUARE, moves(2, (0, 1, shift("8*t", "0")), (1, 2, shift("8*t", "0"))), "yes", None, []),
    # The top slides along x until it moves up, into the points that slid on it.
    (contact.SQUARE, moves(2, (0, 1, shift("8*t", "0")), (1, 2, shift("8", "8*t-8"))), "no", BREAK,
     [("1", "reach", edge, vertex, before, after) for vertex, edge, before, after in
      (("vertex 0", "edge 0-1", "0", "-"), ("vertex 0", "edge 0-3", "-", "0"), ("vertex 1", "edge 0-1", "0", "-"),
       ("vertex 1", "edge 1-2", "+", "0"), ("vertex 2", "edge 1-2", "+", "0"), ("vertex 2", "edge 2-3", "0", "+"),
       ("vertex 3", "edge 0-3", "-", "0"), ("vertex 3", "edge 2-3", "0", "+"))]),
    # The edge x = y = 2 is a run at first, g = 1 and -1 beside it; then both are 1, and of z = 0, 2 it is 0 all the time.
    (CUBE, moves(3, (0, 1, shift("t", "-t", "0")), (1, 2, shift("t", "t-2", "0"))), "no", BREAK, set()),
    # The front comes to rest at t = 1 and then moves on: no contact of the front before, egress after.
    (contact.SQUARE, moves(2, (0, 1, shift("2*t-t^2", "0")), (1, 2, shift("t", "0"))), "undecided", PIECES,
     [("1", "reach", edge, vertex, sign, sign) for vertex, edge, sign in
      (("vertex 0", "edge 0-3", "-"), ("vertex 1", "edge 1-2", "+"), ("vertex 2", "edge 1-2", "+"), ("vertex 3", "edge 0-3", "-"))]),
    # phi of the top is P_z - r - t X with r = -t + t^4: g = X - 1 + 4t^3, theta = -12 t^2, third derivative -24 t. At t = 0 the line
    # X = 1 has order 4; the slab to X = 1 has it on its edge only, the one from X = 1 on as well; from 0 to 2 within.
    (prism_of([[(0, 0), (2, 0), (2, 1), (0, 1)]], -1, 0), moves(3, ("-1/4", "1/4", sheared("t", "0", "1", "t^4-t"))), "no", THETA,
     {("0", "singular", "face 0", "face 0", "", ""), ("0", "singular", "face 1", "face 1", "", "")}),
    (SLAB, moves(3, ("-1/4", "1/4", sheared("t", "0", "1", "t^4-t"))), None, None, set()),
    # phi = P_z - r - t X - t^2 Y with r = -t/2 - t^2/2 + t^4: all three vanish at t = 0 in (1/2, 1/2) alone.
    (SLAB, moves(3, (-1, 1, sheared("t", "t^2", "1", "t^4-t^2/2-t/2"))), None, None,
     {("0", "singular", "face 0", "face 0", "", ""), ("0", "singular", "face 1", "face 1", "", "")}),
    (FAR_SLAB, moves(3, (-1, 1, sheared("t", "t^2", "1", "t^4-t^2/2-t/2"))), None, None, set()),
    # The whole top has order 4 at t = 0; theta = -12 t^2 is not negative there. y = 0, 2 slide.
    (CUBE, moves(3, (-1, 1, shift("t", "0", "t^4"))), "undecided", ZERO,
     {("0", "singular", "face 0", "face 0", "", ""), ("0", "singular", "face 1", "face 1", "", "")}),
    # Moved up by t, then turned about the x axis: c of (x, 0, 0) is (x, -t, 0), all of it in the bottom. That line leaves the bottom
    # at its lowest corner, (4, -1/2); at t = 1/3 and 3/7 it passes others.
    (prism_of([[(0, 0), (2, "-1/3"), (4, "-1/2"), (6, "-3/7"), (7, 1), (3, 3)]], 0, 1),
     moves(3, (0, 1, {"compose": [shift("0", "t", "0"), {"rotate": {"tan_half": "t", "axis": ["1", "0", "0"]}}]})), None, None,
     {("1/2", "singular", BOTTOM, BOTTOM, "", "")}),
    # Scaled by k = 1 - t/2 about (1, 0, 0), then turned about (1, 1 + 2l, 1 - l), which stays: c of it is (1, (1 + 2l)/k, (1 - l)/k).
    # For l = -1/2 that is in y = 0, up to z = 2 at 1/2, for l = 1 in z = 0, up to y = 5 at 4/5. A cut there changes nothing.
    (BOX, moves(3, (0, 1, SHRUNK_AND_TURNED)), None, None, LEAVES),
    (BOX, moves(3, (0, "4/5", SHRUNK_AND_TURNED), ("4/5", 1, SHRUNK_AND_TURNED)), None, None, LEAVES),
    # A zero of lower order is no event. theta = -2 < 0 on the top, and 2 > 0 on the bottom.
    (CUBE, moves(3, (-1, 1, shift("t", "0", "t^2"))), "no", THETA, set()),
    # A block that turns by omega and grows by k, k/omega from 1/4 to 1/2: the slice y = 2 k/omega of x = 2 is the only one: of x = 4
    # g = 4k - omega y > 0, and the others have one sign. On it theta > 0, as k and omega change slowly: about 2 omega^2.
    (contact.BLOCK, moves(2, (0, "1/2", {"compose": [{"scale": "1+t/10"}, {"rotate": {"tan_half": "t/8"}}]})), "yes", None, []),
    # A triangle that turns about the origin with its corner (2, 0), which is nearest to it, on the slice of x = 2 all the time:
    # theta = 2 omega^2 > 0 there. Of y = 1 g has the sign of x, of the side to (4, 1) that of -(2x + y).
    ("POLYGON ((2 0, 4 1, 2 1, 2 0))\n", contact.STILL, "yes", None, []),
]


def touching(z0):
    """Two cubes with x = y = 2 in common, the second from z0 to z0 + 2."""
    first = [(x, y, z) for z in (0, 2) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
    second = [(x, y, z) for z in (z0, z0 + 2) for x, y in ((2, 2), (4, 2), (4, 4), (2, 4))]
    faces = [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
    return off(first + second, faces + [[8 + k for k in f] for f in faces])


# A cube, and a tetrahedron whose edge from (3, 1, 1) to (1, 3, 1) crosses the cube's edge x = y = 2 at z = 1.
CROSSED = off([(x, y, z) for z in (0, 2) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
              + [(3, 1, 1), (1, 3, 1), (4, 4, 0), (4, 4, 2)],
              [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7],
               [8, 9, 10], [8, 11, 9], [8, 10, 11], [9, 11, 10]])
CELLS = [
    # One edge apart, overlapping from z = 1 to 2 (cut in 3), and one edge in common.
    (touching(2), "12 facets, 24 edges, 15 vertices"), (touching(1), "12 facets, 25 edges, 16 vertices"),
    (touching(0), "12 facets, 23 edges, 14 vertices"),
    # Both edges are cut at the crossing.
    (CROSSED, "10 facets, 20 edges, 13 vertices"),
    # A square whose corner rests on the middle of another one's side: 8 edges of the input, 8 corners.
    ("MULTIPOLYGON (((0 0, 4 0, 4 2, 0 2, 0 0)), ((2 2, 3 3, 2 4, 1 3, 2 2)))\n", "8 facets, 0 edges, 8 vertices"),
    (contact.PINCHED_EDGE, "12 facets, 23 edges, 14 vertices"),
]


def run_case(graze, tag, solid, motion):
    suffix = ".off" if solid.startswith("OFF") else ".wkt"
    files = graze.write(tag + suffix, solid), graze.write(tag + ".json", motion)
    events = graze.write(tag + "-events.csv", "")
    return graze.call("envelope", *files, "--events", events), events


def check_case(checks, graze, number, case):
    solid, motion, answer, reason, want = case
    done, events = run_case(graze, f"{number}", solid, motion)
    if not checks.equal(done.returncode, 0, number, done.stderr):
        return
    said = summary(done.stdout)
    if answer:
        checks.equal(said["decomposable"], answer, "case", number, said)
    if reason:
        checks.equal(said["why"].split(",")[0] if "," not in reason else said["why"][:len(reason)], reason, "case", number)
    rows = [tuple(row[k] for k in ("time", "kind", "facet", "cell", "before", "after")) for row in table(events)]
    if isinstance(want, set):  # the singular points alone
        checks.equal({row for row in rows if row[1] == "singular"}, want, "case", number)
    else:
        checks.equal(rows, want, "case", number)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    for number, case in enumerate(CASES):
        check_case(checks, graze, number, case)
    for number, (solid, want) in enumerate(CELLS):
        d = 3 if solid.startswith("OFF") else 2
        done, _ = run_case(graze, f"cells{number}", solid, moves(d, (0, 1, shift(*["t"] * d))))
        if checks.equal(done.returncode, 0, "cells", number, done.stderr):
            checks.equal(summary(done.stdout)["cells"], want, "cells", number)
    checks.finish()


if __name__ == "__main__":
    main()
