#!/usr/bin/env python3
# suite
"""[AMS] 2014, Figure 2: a saucer along a helix while it turns about its axis; the map from envelope to body keeps orientation at some points and reverses it at others.

SPDX-License-Identifier: GPL-3.0-or-later

The saucer is turned: rings s (2, 1), s (1, 2), ... of eight corners on a circle, s = 1 below (z = -1), 2 on the rim (z = 1) and 1 again in the dish (z = 0), between two discs. Its slopes are

    outside  x - z <= 3, 2x + 2y - 3z <= 9     in the dish  2z - x <= -2, 3z - x - y <= -3

and their like in the other sectors. With t = tan(a/2) the motion is b = (2 cos a, 2 sin a, t) after a turn by 2 a. In the body's frame, by the angle a, the velocity of y is V = 2 J y + 2 d + p e_z, with
J a quarter turn, d = (sin a, cos a), p = dt/da = (1 + t^2)/2. On a slope with the normal (m, n_z), and d' = (-cos a, sin a) = J d, dd/da = -d':

    g  = -2 m x y + 2 m.d + n_z p                 m x y = m_x y_y - m_y y_x: a slice is a segment on which that is constant
    g_a = -2 m.d' + n_z p_a                       p_a = t (1 + t^2)/2
    theta = -g_a + 2 m.J(2 J y + 2 d) = 6 m.d' - n_z p_a - 4 m.y

and the orientation is sgn(-g_a) sgn(theta). At a = 0 the slopes of the dish over (1, 0) and (-1, 0), m = (-1, 0) and (1, 0), have theta = 6 + 4 |x| and -6 + 4 |x|, both positive for 2 <= |x| <= 4, and
-g_a = 2 and -2: two faces of the envelope, not in the interior next to t; one keeps orientation and the other reverses it.
"""
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contact"))

from hand import moves, off, shift  # noqa: E402
from exact import Fraction as F  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from reading import named, sign, table  # noqa: E402

RING = [(2, 1), (1, 2), (-1, 2), (-2, 1), (-2, -1), (-1, -2), (1, -2), (2, -1)]
CORNERS = [(s * x, s * y, z) for s, z in ((1, -1), (2, 1), (1, 0)) for x, y in RING]
BELOW, DISH = list(range(8))[::-1], list(range(16, 24))
# Slope k of eight lies between corners k and k + 1 of the rings; first the eight outside, then those of the dish.
SLOPES = [[a + k, a + (k + 1) % 8, a + 8 + (k + 1) % 8, a + 8 + k] for a in (0, 8) for k in range(8)]
SAUCER = off(CORNERS, [BELOW, DISH] + SLOPES)
# (1, 1), (0, 1), (-1, 1), ... is the outward direction of each sector.
OUTWARD = [(1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
HELIX = moves(3, ("-1/2", "1/2", {"compose": [{"rotate": {"axis": ["0", "0", "1"], "tan_half": "t", "times": 2}},
                                             shift("2*(1-t^2)/(1+t^2)", "4*t/(1+t^2)", "t")]}))
TIMES = ["0", "1/3", "-1/4", "1/7", "-2/5", "49/100"]


def normal(slope):
    """(m, n_z): x - z and 2x + 2y - 3z outside, 2z - x and 3z - x - y in the dish."""
    (x, y), inside = OUTWARD[slope % 8], slope >= 8
    if inside:
        return (-x, -y), 3 if x and y else 2
    return ((2 * x, 2 * y), -3) if x and y else ((x, y), -1)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


class Moment:
    """The formulas at a time."""

    def __init__(self, text):
        t = F(text)
        cos, sin = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        self.d, self.turned, self.p, self.p_a = (sin, cos), (-cos, sin), (1 + t * t) / 2, t * (1 + t * t) / 2

    def g(self, m, n_z, y):
        return -2 * (m[0] * y[1] - m[1] * y[0]) + 2 * dot(m, self.d) + n_z * self.p

    def minus_g_a(self, m, n_z):
        return 2 * dot(m, self.turned) - n_z * self.p_a

    def theta(self, m, n_z, y):
        return 6 * dot(m, self.turned) - n_z * self.p_a - 4 * dot(m, y)


def slice_of(now, slope):
    """The ends of the slice of a slope, theta there, and the orientation in its middle; None without a slice."""
    m, n_z = normal(slope)
    corners = [CORNERS[v] for v in SLOPES[slope]]
    ends = []
    for u, v in zip(corners, corners[1:] + corners[:1]):
        a, b = now.g(m, n_z, u), now.g(m, n_z, v)
        if a * b < 0:
            ends.append(tuple(p + a / (a - b) * (q - p) for p, q in zip(map(F, u), v)))
        assert a != 0, "the times are such that no slice passes through a corner"
    if not ends:
        return None
    ends.sort()
    middle = tuple((p + q) / 2 for p, q in zip(*ends))
    turn = sign(now.minus_g_a(m, n_z)) * sign(now.theta(m, n_z, middle))
    return tuple(ends), tuple("-0+"[1 + sign(now.theta(m, n_z, y))] for y in ends), ("reversing", "degenerate", "preserving")[1 + turn]


def check_slices(checks, graze, files):
    """All slices at a few times; at a = 0 the two of the dish."""
    curve = graze.write("curve.csv", "")
    done = graze.call("envelope", *files, "--at", ",".join(TIMES), "--curve", curve)
    if not checks.equal(done.returncode, 0, "curve", done.stderr):
        return
    rows, total = table(curve), Counter()
    for time in TIMES:
        want = {f"face {2 + k}": slice_of(Moment(time), k) for k in range(16)}
        want = {cell: found for cell, found in want.items() if found}
        got = {}
        for r in rows:
            if F(r["time"]) == F(time) and r["kind"] == "slice":
                ends = sorted((tuple(F(r[e + c]) for c in "xyz"), r["theta_" + e]) for e in "ab")
                got[r["cell"]] = tuple(e for e, _ in ends), tuple(s for _, s in ends), r["orientation"]
        checks.equal(got, want, time)
        total.update((thetas, turn) for _, thetas, turn in want.values())
        if time == "0":
            # Slopes 15 and 11, over (1, 0) and (-1, 0), at y = -1/2 and 1/2.
            checks.equal((got["face 17"][1:], got["face 13"][1:]), ((("+", "+"), "preserving"), (("+", "+"), "reversing")), "dish")
            checks.equal([{p[1] for p in got[f][0]} for f in ("face 17", "face 13")], [{F(-1, 2)}, {F(1, 2)}], "dish")
    checks.holds(len(total) > 4, "kinds of slices", dict(total))


def touches(patch, cell):
    """Does the closure of a patch's cell contain a cell? Then the adjacency of patches is one of cells."""
    kind, *numbers = named(patch["cell"])
    vertices = ([BELOW, DISH] + SLOPES)[numbers[0]] if kind == "face" else numbers
    return set(named(cell)[1:]) <= set(vertices)


def check_adjacency(checks, graze, files):
    """Faces of the envelope that meet belong to cells of the saucer that meet there; both orientations occur where theta > 0."""
    patches, joints, events = (graze.write(n, "") for n in ("p.csv", "j.csv", "e.csv"))
    done = graze.call("envelope", *files, "--patches", patches, "--joints", joints, "--events", events)
    if not checks.equal(done.returncode, 0, "patches", done.stderr):
        return
    rows = table(patches)
    for joint in table(joints):
        if joint["from"] != joint["to"]:
            members = [rows[int(k)] for k in joint["patches"].split(" ")]
            checks.holds(all(touches(p, joint["cell"]) for p in members), joint, members)
    outer = Counter(r["orientation"] for r in rows if r["kind"] == "slice" and r["theta_a"] == r["theta_b"] == "+")
    checks.holds(outer["preserving"] > 2 and outer["reversing"] > 2, "orientations where theta > 0", dict(outer))
    # On the dish over (1, 0) a slice is at y = sin a - p. It passes the corner (2, -1, 0), where g = -2 - 2 sin a + 2 p falls, as t^4 - 4t - 1 = 0.
    passed = [r for r in table(events) if (r["kind"], r["facet"], r["cell"]) == ("reach", "face 17", "vertex 23")]
    checks.equal([(r["time"], r["before"], r["after"]) for r in passed], [("root(-1 -4 0 0 1;-1;0)", "+", "-")], "corner")


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    files = graze.write("saucer.off", SAUCER), graze.write("helix.json", HELIX)
    check_slices(checks, graze, files)
    check_adjacency(checks, graze, files)
    checks.finish()


if __name__ == "__main__":
    main()
