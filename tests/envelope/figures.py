#!/usr/bin/env python3
# suite
"""The sweeps of Adsul, Machchhar and Sohoni's figures with polyhedra for their bodies: a helix, a parabola, an arc, and a map that turns over.

SPDX-License-Identifier: GPL-3.0-or-later

An octahedron |x|/p + |y|/q + |z|/r <= 1 has the corners 0 and 1 (-p, p on x), 2 and 3 on y, 4 and 5 on z. Along a translation g = n b' is one number for each facet and theta = -n b'',
so a facet is in contact all at once or not at all. A facet's signs are (sx, sy, sz). Edges x-y lie in two facets with sz = +-1, x-z with sy, y-z with sx.
"""
import itertools
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contact"))

from hand import ALONG, moves, off, prism_of, shift  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from reading import summary, table  # noqa: E402

THETA = "theta is negative on a slice"
CORNER = {("x", -1): 0, ("x", 1): 1, ("y", -1): 2, ("y", 1): 3, ("z", -1): 4, ("z", 1): 5}
SIGNS = list(itertools.product((-1, 1), repeat=3))


def octahedron(*size):
    vertices = [tuple(s * size[i] if i == k else 0 for i in range(3)) for k in range(3) for s in (-1, 1)]
    faces = [[CORNER["x", a], CORNER["y", b], CORNER["z", c]] for a, b, c in SIGNS]
    return off(vertices, [f if a * b * c > 0 else f[::-1] for f, (a, b, c) in zip(faces, SIGNS)])


def edges(one, other):
    return ["edge %d-%d" % tuple(sorted((CORNER[one, a], CORNER[other, b]))) for a in (-1, 1) for b in (-1, 1)]


def corners(axis):
    return [f"vertex {CORNER[axis, s]}" for s in (-1, 1)]


def outlines(middle, outer, times):
    """The contact set is the outline of four edges `middle`-z from times[1] to times[2], `outer`-z before and after: patches and joints. Each of its corners joins two
    edges; at the two times both outlines end at the corners z, and at its own corners each ends with a corner's patch."""
    spans = list(zip(times, times[1:]))
    patches, joints = Counter(), Counter()
    for axis, span in ((outer, spans[0]), (middle, spans[1]), (outer, spans[2])):
        runs, points = edges(axis, "z"), corners(axis) + corners("z")
        patches.update([("run", cell) + span for cell in runs] + [("point", cell) + span for cell in points])
        joints.update([(cell,) + span + ("closed", 3) for cell in points])
    for time in times[1:3]:
        joints.update([(cell, time, time, "", 6) for cell in corners("z")])
        joints.update([(cell, time, time, "", 3) for cell in corners(middle) + corners(outer)])
    return patches, joints


def crossings(time_of):
    """`reach` of each facet at its three corners, at time_of(signs) = (time, sign after)."""
    out = Counter()
    for k, signs in enumerate(SIGNS):
        time, after = time_of(*signs)
        for axis, s in zip("xyz", signs):
            out["reach", f"face {k}", f"vertex {CORNER[axis, s]}", time, "+-"[after > 0], "-+"[after > 0]] += 1
    return out


# [AMS] Figure 8, a helix b = (2 cos, 2 sin, 8t), t = tan of half the angle: b' = (-8t, 4 (1 - t^2))/(1 + t^2)^2 and 8, |b'_x| + |b'_y| < 8 where |t| <= 1, as 8|t| + 4 (1 - t^2) <= 8. So g has the sign
# of sz: the outline is that of the edges x-y all the time. Displacements have |dx| + |dy| < |dz|: a contact |x| + |y| = 1, z = 0 is never inside again.
HELIX = moves(3, (-1, 1, shift("2*(1-t^2)/(1+t^2)", "4*t/(1+t^2)", "8*t")))
STEADY = Counter([("run", e, "-1", "1") for e in edges("x", "y")] + [("point", v, "-1", "1") for v in corners("x") + corners("y")]), \
    Counter((v, "-1", "1", "closed", 3) for v in corners("x") + corners("y"))
# Figure 12, a parabola b = (t, t^2, 0): g = sx + 2 t sy, 0 at t = -sx/(2 sy), then with the sign of sy; theta = -2 sy < 0 on the side of sy = 1. Edges x-z are in contact where
# |2t| > 1, y-z where |2t| < 1, x-y never.
PARABOLA = moves(3, (-1, 1, shift("t", "t^2", "0")))
# Figure 13, an ellipsoid x^2 + y^2/4 + z^2 <= 1 along the arc 3 (cos, sin), t = tan of half the angle: n = (2 sx, sy, 2 sz), g is -4 t sx + sy (1 - t^2) up to a positive factor, 0 at
# t^2 + 4 s t - 1 = 0 with s = sx sy, that is at s (sqrt 5 - 2), with the derivative of the sign of -sx (there -4 sx - 2 t sy). b'' is towards the centre but for a part along b', so
# theta has the sign of 2 sx cos + sy sin, sx: < 0 inside the arc. Edges x-z are in contact in between, y-z before and after.
ARC = moves(3, ("-1/2", "1/2", shift("3*(1-t^2)/(1+t^2)", "6*t/(1+t^2)", "0")))
EARLY, LATE = "root(-1 -4 1;-1;0)", "root(-1 4 1;0;1)"

CASES = [
    (octahedron(1, 1, 1), HELIX, "yes", None, *STEADY, Counter()),
    (octahedron(1, 1, 1), PARABOLA, "no", THETA, *outlines("y", "x", ("-1", "-1/2", "1/2", "1")),
     crossings(lambda sx, sy, sz: ("1/2" if sx != sy else "-1/2", sy))),
    (octahedron(1, 2, 1), ARC, "no", THETA, *outlines("x", "y", ("-1/2", EARLY, LATE, "1/2")),
     crossings(lambda sx, sy, sz: (LATE if sx == sy else EARLY, -sx))),
]


def check_case(checks, graze, number, case):
    solid, motion, answer, reason, patches, joints, events = case
    names = [graze.write(f"{number}{end}", text) for end, text in
             ((".off", solid), (".json", motion), ("-e.csv", ""), ("-p.csv", ""), ("-j.csv", ""))]
    done = graze.call("envelope", *names[:2], "--events", names[2], "--patches", names[3], "--joints", names[4])
    if not checks.equal(done.returncode, 0, number, done.stderr):
        return
    said = summary(done.stdout)
    checks.equal(said["decomposable"], answer, "case", number, said)
    checks.holds(reason is None or said["why"].startswith(reason), "case", number, said)
    rows = table(names[3])
    checks.equal(Counter((r["kind"], r["cell"], r["from"], r["to"]) for r in rows), patches, "case", number, "patches")
    checks.equal(Counter((r["cell"], r["from"], r["to"], r["form"], len(r["patches"].split(" "))) for r in table(names[4])), joints, "case", number,
                 "joints")
    checks.equal(Counter((r["kind"], r["facet"], r["cell"], r["time"], r["before"], r["after"]) for r in table(names[2])), events, "case", number,
                 "events")
    if answer == "yes":
        checks.equal({r["status"] for r in rows}, {"simple"}, "case", number, "statuses")


def check_turned(checks, graze):
    """[AMS] 2014, Figure 2: the map from the contact set is reversing at some points and preserving at others. The block of tests/contact/hand.py, turning while it moves, as a prism: on x = 2
    and on x = 4 -g_t/theta is -5/3 and -5/19 at t = 1/2; on x = 2 theta changes its sign at the cusp and g_t = -theta det does not, as the slice y = 1 - t^2 moves one way."""
    plane = [(2, -1), (4, -1), (4, 1), (2, 1)]
    motion = ALONG.replace('"dimension": 2', '"dimension": 3').replace('{"tan_half": "t"}', '{"tan_half": "t", "axis": ["0", "0", "1"]}') \
        .replace('["2*t", "0"]', '["2*t", "0", "0"]')
    names = [graze.write(f"turned{end}", text) for end, text in ((".off", prism_of([plane], 0, 1)), (".json", motion), ("-p.csv", ""))]
    done = graze.call("envelope", *names[:2], "--patches", names[2])
    checks.equal(done.returncode, 0, done.stderr)
    slices = [(r["cell"], r["from"], r["to"], r["theta_a"], r["theta_b"], r["orientation"]) for r in table(names[2]) if r["kind"] == "slice"]
    cusp = "root(-2 3 0 1;0;1)"
    checks.equal(Counter(slices), Counter([("face 5", "0", cusp, "+", "+", "reversing"), ("face 5", cusp, "1", "-", "-", "preserving"),
                                           ("face 3", "0", "1", "-", "-", "reversing")]), "turned")


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    for number, case in enumerate(CASES):
        check_case(checks, graze, number, case)
    check_turned(checks, graze)
    checks.finish()


if __name__ == "__main__":
    main()
