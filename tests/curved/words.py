#!/usr/bin/env python3
# suite
"""Words and times of curved scenes derived by hand: balls, capsules, cones, tori and polynomials, alone and combined, at
tangencies, seams, rims, apexes and along slides (C94 to C101, C121, C122, C129, C126, C127).

SPDX-License-Identifier: GPL-3.0-or-later

In most scenes c(t), the inverted trajectory of the origin, is the path that is given. A time is a ratio, or the
coefficients of its minimal polynomial from the constant on. The reason of a word stands beside it.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

from scenes import (Checks, Curved, Graze, Motion, along, ball, box, capsule, common, cone, cylinder, halfspace,  # noqa: E402
                    minus, options, polynomial, times_of, torus, union)
from exact import Fraction as F  # noqa: E402

ORIGIN = {2: (0, 0), 3: (0, 0, 0)}
# Solids that several scenes share.
CAPSULE = capsule((0, 0, 0), (4, 0, 0), 1)
TWO = ball((-1, 0, 0), 1), ball((1, 0, 0), 1)                      # they touch at the origin
RING = torus((0, 0, 0), (0, 0, 1), 2, 1)                           # its outer equator: r = 3, z = 0
WIDER = torus((0, 0, 0), (0, 0, 1), 4, 1)                          # from outside, along that equator
ROD = cylinder((0, 0, 0), (0, 0, 1), 3, -2, 2)
CONE = cone((0, 0, 0), (0, 0, 1), 1)
NAPPES = polynomial({"2,0,0": 1, "0,2,0": 1, "0,0,2": -1})
PLATE = minus(box((-3, -3, 0), (3, 3, 1)), cylinder((0, 0, 0), (0, 0, 1), 1))
RAISED = torus((0, 0, 1), (0, 0, 1), 2, 1)                         # it rests on z = 0 along r = 2
FLOOR = box((-4, -4, -1), (4, 4, 0))
THREE = tuple(ball(c, 1) for c in ((1, 0), (F(-3, 5), F(4, 5)), (F(-3, 5), F(-4, 5))))
DISK = ball((0, 1), 1)
OVAL = polynomial({"2,0": 1, "0,2": 2, "0,1": -2})                 # x^2 + 2 y^2 = 2 y, in the disk x^2 + y^2 <= 2 y
BALL = ball((0, 0, 1), 1)
EGG = polynomial({"2,0,0": 1, "0,2,0": 1, "0,0,2": 2, "0,0,1": -2})
CUSP = polynomial({"0,2": 1, "3,0": -1})                           # |y| <= x^(3/2)
TACNODE = polynomial({"4,0": 1, "2,1": -2, "0,2": 1, "0,3": -1})   # |x^2 - y| <= y^(3/2)
RIGHT, LEFT, UPPER = halfspace((-1, 0)), halfspace((1, 0)), halfspace((0, -1))
FAN = [halfspace((k, 1)) for k in range(-20, 21)]                  # y <= -20 |x|
SMALL = F(1, 1 << 12)
ABOVE = halfspace((0, 0, -1))                                      # z >= 0
UP, WIDE = cone((0, 0, 0), (0, 0, 1), 1, 1), cone((0, 0, 0), (0, 0, 1), 2, 1)
HOURGLASS = UP, cone((0, 0, 0), (0, 0, -1), 2, 1)                  # of two slopes
NARROW = polynomial({"2,0,0": 1, "0,2,0": 2, "0,0,2": -1})         # in NAPPES, and touches it where y = 0
QUARTIC = polynomial({"4,0,0": 1, "0,4,0": 1, "0,0,4": -1})        # holds NAPPES: x^4 + y^4 <= (x^2 + y^2)^2
FIRST = polynomial({"0,0,1": 1, "1,0,1": 1, "0,2,0": 1})           # z (1 + x) + y^2
SECOND = polynomial({"0,0,1": 1, "1,0,1": 2, "0,2,0": F(3, 2)})    # z (1 + 2 x) + 3/2 y^2


CUBIC = "(t^3-t-1/7)"                                              # from -1 to 0: twice 0, at most 0.25, at least -1/7
TWICE = [[-1, -7, 0, 7]] * 2
BEND = torus((5, 0, 0), (0, 0, 1), 3, 1)                           # it has a circle in y = 0 in common with RING, as have
PIPE, PEARL = cylinder((2, 0, 0), (0, 1, 0), 1), ball((2, 0, 0), 1)
# Three discs through (2, 0), turned about the axis: their gradients there are (-3, -4), (-4, -3), (-5, 0), each over 5.
TURNED = tuple(torus((0, 0, z), (0, 0, 1), r, 1) for z, r in ((F(4, 5), F(13, 5)), (F(3, 5), F(14, 5)), (0, 3)))


def around(radius, height):
    """A quarter of a circle about the z axis."""
    return along(0, 1, f"{radius}*(1-t^2)/(1+t^2)", f"{2 * radius}*t/(1+t^2)", str(height))


def beside(*point, middle=(0, 0, 0)):
    """Out of a point and into it along the ray from the middle, at both roots of CUBIC."""
    return along(-1, 0, *(f"{m}+({p - m})*(1+{CUBIC})" for p, m in zip(point, middle)))


def corner(third):
    """y >= 0, z >= 0 and a third inequality."""
    return common(halfspace((0, -1, 0)), ABOVE, polynomial(third))


def three_cones(share):
    """|v|^2 <= share x^2, share y^2 or share z^2: with a share of 3 they cover all, as the greatest coordinate does."""
    return union(*(polynomial({f"{2 * (i == 0)},{2 * (i == 1)},{2 * (i == 2)}": 1 - (share if i == axis else 0) for i in range(3)})
                   for axis in range(3)))


def outline(*points):
    return {"polygon": {"points": [[str(r), str(z)] for r, z in points], "revolve": 1}}


# name, solid, motion, word, times or None
SCENES = [
    # A ball swept along a parabola: with u = t^2, F = u^2 + (1 - 2 y) u + y^2 - 1.
    *[(f"parabola {y}", ball((0, 0), 1), along(-3, 3, "-t", f"{y}-t^2"), word, times) for y, word, times in (
        ("3/2", "O", []), ("5/4", "OBOBO", [[-3, 0, 4]] * 2), ("9/8", "OBIBOBIBO", [[17, 0, -80, 0, 64]] * 4),
        ("1", "OBIBIBO", [-1, 0, 1]), ("0", "OBIBO", [[-1, 0, 1, 0, 1]] * 2), ("-1", "OBO", [0]))],
    # An ellipsoid that is 2 along y, carried around a circle of radius 3: (C - 1)(9 C - 7), (C - 1)(9 C - 23), C the cosine.
    *[(f"round {x}", {"ellipsoid": {"semiaxes": ["1", "2", "1"]}},
       along(-1, 1, f"{x}-3*(1-t^2)/(1+t^2)", "-6*t/(1+t^2)", "0"), word, times) for x, word, times in (
        (2, "OBIBIBO", [[-1, 0, 8], 0, [-1, 0, 8]]), (4, "OBO", [0]))],
    # One surface twice, with both signs, squared: the set is the closure of its interior.
    ("twice", union(ball((0, 0), 1), ball((0, 0), 1)), along(-2, 2, "t", "0"), "OBIBO", [-1, 1]),
    ("less itself", minus(ball((0, 0), 1), ball((0, 0), 1)), along(-2, 2, "t", "0"), "O", []),
    ("either side", union(polynomial({"1,0": 1, "0,2": 1}), polynomial({"1,0": -1, "0,2": -1})),
     along(-1, 1, "t", "t"), "I", []),
    ("both sides", common(polynomial({"1,0": 2, "0,2": 2}), polynomial({"1,0": -1, "0,2": -1})),
     along(-1, 1, "t", "t"), "O", []),
    ("square", polynomial({"4,0": 1, "2,0": -2, "0,0": 1}), along(-2, 2, "t", "0"), "O", []),
    ("minus a square", polynomial({"4,0": -1, "2,0": 2, "0,0": -1}), along(-2, 2, "t", "0"), "I", []),
    ("a factor squared", polynomial({"3,0": 1, "2,1": 1}), along(-2, 1, "t", "1"), "IBO", [-1]),   # x^2 (x + y) <= 0
    ("two factors", polynomial({"1,1": 1}), along(-2, 2, "t", "1-t"), "IBOBI", [0, 1]),            # x y <= 0
    # A capsule: seams at x = 0 and 4, where ball and cylinder touch.
    ("capsule along", CAPSULE, along(-1, 5, "t", "0", "1"), "OBO", [(0, 4)]),
    ("capsule across", CAPSULE, along(-2, 2, "0", "0", "t"), "OBIBO", [-1, 1]),
    ("capsule beside its seam", CAPSULE, along(-1, 1, "0", "t", "1"), "OBO", [0]),
    ("capsule into its seam", CAPSULE, along(-1, 1, "t", "0", "1-t^2/4"), "OBI", [0]),  # in the ball t^2 / 2 is too much
    ("capsule through", CAPSULE, along(-1, 5, "t", "0", "0"), "BIB", [-1, 5]),
    ("stadium", capsule((0, 0), (3, 4), 1), along(-1, 6, "3*t/5-4/5", "4*t/5+3/5"), "OBO", [(0, 5)]),
    # A rod and a ring that touches it from within along r = 3, z = 0.
    ("rod less ring, upright", minus(ROD, RING), along(-1, 1, "3", "0", "t"), "B", [(-1, 1)]),
    ("rod less ring, outwards", minus(ROD, RING), along(F(5, 2), F(7, 2), "t", "0", "0"), "OBO", [3]),
    ("ring less rod", minus(RING, ROD), along(F(5, 2), F(7, 2), "t", "0", "0"), "O", []),
    ("ring less rod, upright", minus(RING, ROD), along(-1, 1, "3", "0", "t"), "O", []),
    ("ring on half a rod, outwards", union(RING, cylinder((0, 0, 0), (0, 0, 1), 3, -2, 0)),
     along(F(5, 2), F(7, 2), "t", "0", "0"), "IBO", [3]),
    ("ring on half a rod, upright", union(RING, cylinder((0, 0, 0), (0, 0, 1), 3, -2, 0)),
     along(-1, 1, "3", "0", "t"), "BO", [(-1, 0)]),
    ("ring on half a rod, around", union(RING, cylinder((0, 0, 0), (0, 0, 1), 3, -2, 0)),
     along(0, 1, "3*(1-t^2)/(1+t^2)", "6*t/(1+t^2)", "0"), "B", [(0, 1)]),
    # Surfaces that touch along a whole circle. Two rings, and a path that leaves one and enters the other: with s = 1/2 - t^2 in
    # [-1/16, 1/18], r^2 = 9 - 6/5 s + 2 s^2, it is in RING for 0 < s < 0.08 and in the other for -0.11 < s < 0.
    ("rings, around", union(RING, WIDER), around(3, 0), "B", [(0, 1)]),
    ("rings, across", union(RING, WIDER), along(F(2, 3), F(3, 4), "9/5+1/2-t^2", "12/5-1/2+t^2", "1-2*t^2"), "IBI", [[-1, 0, 2]]),
    ("both rings, across", common(RING, WIDER), along(F(2, 3), F(3, 4), "9/5+1/2-t^2", "12/5-1/2+t^2", "1-2*t^2"), "O", []),
    ("ring below a height, around", union(RING, halfspace((0, 0, -1), -1)), around(2, 1), "B", [(0, 1)]),
    # The ball of radius 3 has the ring in it; on a ray from the middle it and the ring end at once.
    ("ball less ring, around", minus(ball((0, 0, 0), 3), RING), around(3, 0), "B", [(0, 1)]),
    ("ball less ring, beside", minus(ball((0, 0, 0), 3), RING), beside(F(9, 5), F(12, 5), 0), "OBOBO", TWICE),
    ("ring less ball, beside", minus(RING, ball((0, 0, 0), 3)), beside(F(9, 5), F(12, 5), 0), "O", []),
    # In y = 0 all have one section. With c = (x - 2)^2 + z^2 - 1, y small, the surfaces are PIPE: c = 0; PEARL: c = -y^2;
    # RING: c = -y^2 (x - 2) / x + ...; BEND: c = y^2 (x - 2) / (5 - x) + ...; the lesser c is the inner one.
    ("ring less pearl", minus(RING, PEARL), beside(F(13, 5), 0, F(4, 5), middle=(2, 0, 0)), "OBOBO", TWICE),
    ("pearl less ring", minus(PEARL, RING), beside(F(13, 5), 0, F(4, 5), middle=(2, 0, 0)), "O", []),
    ("ring less pipe", minus(RING, PIPE), beside(F(13, 5), 0, F(4, 5), middle=(2, 0, 0)), "O", []),
    ("pipe less ring", minus(PIPE, RING), beside(F(13, 5), 0, F(4, 5), middle=(2, 0, 0)), "OBOBO", TWICE),
    ("ring less pipe, on the inner side", minus(RING, PIPE), beside(F(7, 5), 0, F(4, 5), middle=(2, 0, 0)), "OBOBO", TWICE),
    ("ring less bend", minus(RING, BEND), beside(F(13, 5), 0, F(4, 5), middle=(2, 0, 0)), "O", []),
    ("bend less ring", minus(BEND, RING), beside(F(13, 5), 0, F(4, 5), middle=(2, 0, 0)), "OBOBO", TWICE),
    # 3 a - 4 b + 7 c = 0 of the gradients, and the discs have the point in common: none is in the first and third alone.
    ("two less the third, around", minus(common(TURNED[0], TURNED[2]), TURNED[1]), around(2, 0), "O", []),
    ("two less the third, beside", minus(common(TURNED[0], TURNED[2]), TURNED[1]), beside(F(6, 5), F(8, 5), 0), "O", []),
    ("two less another, beside", minus(common(*TURNED[:2]), TURNED[2]), beside(F(6, 5), F(8, 5), 0), "OBOBO", TWICE),
    # A cone, its apex, its generators.
    ("cone beside its apex", CONE, along(-1, 1, "t", "0", "0"), "OBO", [0]),
    ("cone into its apex", CONE, along(-1, 1, "0", "0", "t"), "OBI", [0]),
    ("cone along a generator", CONE, along(-1, 1, "t", "0", "t"), "OB", [(0, 1)]),
    ("capped cone through", cone((0, 0, 0), (0, 0, 2), F(1, 2), 1), along(-1, 3, "0", "0", "t"), "OBIBO", [0, 2]),
    ("box less cone", minus(box((-1, -1, -1), (1, 1, 1)), CONE), along(F(-1, 2), F(1, 2), "t", "0", "0"), "IBI", [0]),
    ("box less cone, down", minus(box((-1, -1, -1), (1, 1, 1)), CONE), along(F(-1, 2), F(1, 2), "0", "0", "t"), "IBO", [0]),
    ("two nappes", NAPPES, along(-1, 1, "t", "0", "0"), "OBO", [0]),
    ("two nappes through", NAPPES, along(-1, 1, "0", "0", "t"), "IBI", [0]),
    ("outside of nappes", minus(box((-2, -2, -2), (2, 2, 2)), NAPPES), along(-1, 1, "t", "0", "0"), "IBI", [0]),
    ("steep plane", common(CONE, halfspace((-1, 0, 2))), along(-1, 1, "0", "0", "t"), "O", []),     # x >= 2 z
    ("steep plane aside", common(CONE, halfspace((-1, 0, 2))), along(-1, 1, "t", "0", "0"), "O", []),
    ("tangent plane", common(CONE, halfspace((-1, 0, 1))), along(-1, 1, "t", "0", "t"), "O", []),   # x >= z
    ("tangent plane at the apex", common(CONE, halfspace((-1, 0, 1))), along(-1, 1, "0", "t", "0"), "O", []),
    ("cutting plane", common(CONE, halfspace((-2, 0, 1))), along(-1, 1, "0", "0", "t"), "OBO", [0]),  # x >= z / 2
    ("cone in a wedge", common(CONE, halfspace((1, 3, 0)), halfspace((-1, 3, 0))), along(-1, 1, "0", "0", "t"),
     "OB", [(0, 1)]),                                               # 3 y <= -|x|: the axis is the wedge's edge
    ("cone less its quadrant", minus(CONE, common(halfspace((-1, 0, 0)), halfspace((0, -1, 0)))),
     along(-1, 1, "t", "t", "2*t"), "OBO", [0]),
    # x^2 + y^2 <= z^2 within |x| >= 2 z >= 0: nothing but the apex, from four cells of the two planes.
    ("cone in two steep planes", common(NAPPES, halfspace((-1, 0, 2)), ABOVE), along(-1, 1, "0", "t", "0"), "O", []),
    ("cone over a cell", minus(common(halfspace((1, 0, -1)), halfspace((-1, 0, -1)), halfspace((0, 1, -1)),
                                      halfspace((0, -1, -1))), NAPPES), along(-1, 1, "t", "0", "0"), "OBO", [0]),
    # 97/100 |a|^2 |x|^2 <= (a x)^2, a = (1, 2, 3): a cone about a that no coordinate plane meets, as 97/100 > 13/14.
    ("cone within an octant", common(ABOVE, halfspace((-1, 0, 0)), halfspace((0, -1, 0)), polynomial(
        {"2,0,0": F(629, 50), "0,2,0": F(479, 50), "0,0,2": F(229, 50), "1,1,0": -4, "1,0,1": -6, "0,1,1": -12})),
     along(-1, 1, "t", "-t", "0"), "OBO", [0]),
    # x + z^2 >= z in the cone: between x = z - z^2 and x = z, y = 0, though not in the tangent plane's half space.
    ("cone and a bent plane", common(NAPPES, ABOVE, polynomial({"1,0,0": -1, "0,0,1": 1, "0,0,2": -1})),
     along(F(-1, 2), F(1, 2), "0", "t", "t^2"), "OBO", [0]),
    # Several cones with one apex (C129): at the origin some directions are in, others out, or all are one.
    ("hourglass through", union(*HOURGLASS), along(-2, 2, "0", "0", "t"), "OBIBIBO", [-1, 0, 1]),
    ("hourglass beside", union(*HOURGLASS), along(-1, 1, "t", "0", "0"), "OBO", [0]),
    ("hourglass, both", common(*HOURGLASS), along(-1, 1, "0", "0", "t"), "O", []),
    ("cone less a steeper one", minus(WIDE, UP), along(-1, 1, "0", "0", "t"), "OBO", [0]),
    ("cone less a steeper one, beside", minus(WIDE, UP), along(-1, 1, "t", "0", "0"), "OBO", [0]),
    ("cone less a steeper one, at rest", minus(WIDE, UP), along(0, 1, "0", "0", "0"), "B", [(0, 1)]),
    ("cone less a steeper one, irrational", minus(WIDE, UP, ball((0, 0, -1), 1)), along(0, 2, "t^2-2", "0", "0"), "OBO", [[-2, 0, 1]]),
    ("steep cone less a wide one", minus(UP, WIDE), along(-1, 1, "0", "0", "t"), "O", []),
    ("box less two cones, across", minus(box((-1, -1, -1), (1, 1, 1)), *HOURGLASS), along(-2, 2, "t", "0", "0"), "OBIBIBO", [-1, 0, 1]),
    ("box less two cones, down", minus(box((-1, -1, -1), (1, 1, 1)), UP, CONE), along(F(-1, 2), F(1, 2), "0", "0", "t"), "IBO", [0]),
    ("box less a cone within another", minus(box((-1, -1, -1), (1, 1, 1)), minus(WIDE, UP)),
     along(F(-1, 2), F(1, 2), "0", "0", "t"), "IBI", [0]),
    # r from z / 2 to 2 z: its tip is on the axis, which is outside.
    ("tip on the axis, upright", outline((0, 0), (1, 2), (2, 1)), along(-1, 1, "0", "0", "t"), "OBO", [0]),
    ("tip on the axis, across", outline((0, 0), (1, 2), (2, 1)), along(-1, 1, "t", "0", "0"), "OBO", [0]),
    # z from -r / 2 to r, and 2 r + z <= 3.
    ("tip on the axis, through", outline((0, 0), (1, 1), (2, -1)), along(-2, 2, "t", "0", "0"), "OBIBIBO", [F(-3, 2), 0, F(3, 2)]),
    ("tangent cones", minus(NAPPES, NARROW), along(-1, 1, "0", "0", "t"), "OBO", [0]),
    ("tangent cones, the inner less the outer", minus(NARROW, NAPPES), along(-1, 1, "0", "0", "t"), "O", []),
    ("cone in a quartic", minus(NAPPES, QUARTIC), along(-1, 1, "t", "0", "0"), "O", []),
    ("quartic about a cone", minus(QUARTIC, NAPPES), along(-1, 1, "t", "0", "0"), "OBO", [0]),
    ("three cones cover all", three_cones(3), along(-1, 1, "t", "0", "0"), "I", []),
    ("less three cones", minus(box((-1, -1, -1), (1, 1, 1)), three_cones(3)), along(F(-1, 2), F(1, 2), "t", "t", "t"), "O", []),
    # Directions near (1, 1, 1) alone are left.
    ("three cones, nearly all", three_cones(F(299, 100)), along(-1, 1, "t", "0", "0"), "IBI", [0]),
    # Pairs of planes along the z axis: 2 y^2 <= x^2 <= 3 y^2, or the opposite.
    ("between two pairs", common(polynomial({"2,0,0": 1, "0,2,0": -3}), polynomial({"2,0,0": -1, "0,2,0": 2})),
     along(-1, 1, "0", "0", "t"), "B", [(-1, 1)]),
    ("beyond two pairs", common(polynomial({"2,0,0": 1, "0,2,0": -2}), polynomial({"2,0,0": -1, "0,2,0": 3})),
     along(-1, 1, "0", "0", "t"), "O", []),
    ("between two pairs, in the plane", common(polynomial({"2,0": 1, "0,2": -3}), polynomial({"2,0": -1, "0,2": 2})),
     along(-1, 1, "t", "0"), "OBO", [0]),
    ("beyond two pairs, in the plane", common(polynomial({"2,0": 1, "0,2": -2}), polynomial({"2,0": -1, "0,2": 3})),
     along(-1, 1, "t", "0"), "O", []),
    # x (1 + z) + y z <= 0 has the axis, and a tangent plane that turns about it.
    ("a pair and a bent plane", common(polynomial({"2,0,0": 1, "0,2,0": -2}), polynomial({"1,0,0": 1, "1,0,1": 1, "0,1,1": 1})),
     along(-1, 1, "0", "0", "t"), "B", [(-1, 1)]),
    # (x^2 - 2)^2 = x y^2 crosses itself where x^2 = 2.
    ("irrational node", polynomial({"4,0": 1, "2,0": -4, "0,0": 4, "1,2": -1}), along(1, 2, "t", "0"), "OBO", [[-2, 0, 1]]),
    ("irrational node, half", common(polynomial({"4,0": 1, "2,0": -4, "0,0": 4, "1,2": -1}), halfspace((0, 1))),
     along(1, 2, "t", "0"), "OBO", [[-2, 0, 1]]),
    # Forms that are definite: points alone.
    ("a point", polynomial({"2,0,0": 2, "0,2,0": 1, "0,0,2": 1, "1,1,0": 1, "3,0,0": 1}), along(F(-1, 2), F(1, 2), "t", "0", "0"), "O", []),
    ("all but a point", polynomial({"2,0": -1, "0,2": -1, "1,1": 1, "3,0": 1}), along(F(-1, 2), F(1, 2), "t", "0"), "I", []),
    # A line of points where x^2 + y^2 = 0: no boundary.
    ("a line that is none", polynomial({"2,0,0": 1, "0,2,0": 1}), along(-1, 1, "t", "0", "t"), "O", []),
    ("a line of all", polynomial({"2,0,0": -1, "0,2,0": -1}), along(-1, 1, "t", "0", "t"), "I", []),
    ("a slide along it", polynomial({"2,0,0": 1, "0,2,0": 1}), along(-1, 1, "0", "0", "t"), "O", []),
    # A node of a cubic, and its cusp: y^2 = x^2 + x^3, y^2 = x^3.
    ("node", polynomial({"0,2": 1, "2,0": -1, "3,0": -1}), along(F(-1, 2), F(1, 2), "0", "t"), "OBO", [0]),
    ("node, along", polynomial({"0,2": 1, "2,0": -1, "3,0": -1}), along(F(-1, 2), F(1, 2), "t", "0"), "IBI", [0]),
    ("cusp, into it and back", polynomial({"0,2": 1, "3,0": -1}), along(-1, 1, "t^2", "0"), "IBI", [0]),
    ("around a cusp, to it and back", polynomial({"0,2": -1, "3,0": 1}), along(-1, 1, "t^2", "0"), "OBO", [0]),
    ("beside a cusp", CUSP, along(-1, 1, "0", "t"), "OBO", [0]),
    ("below a cusp", polynomial({"2,0": 1, "0,3": -1}), along(-1, 1, "t", "0"), "OBO", [0]),
    ("beside a cusp of the complement", polynomial({"0,2": -1, "3,0": 1}), along(-1, 1, "0", "t"), "IBI", [0]),
    # Singular points in company (C126): the cusp lies to the right of the line, its mirror image to the left.
    # The same at other heights: windows beside it end above, in and below y = 0, in it for -3/16 <= y < -1/8.
    *[(f"cusp at {y}", polynomial({"0,2": 1, "0,1": -2 * y, "0,0": y * y, "3,0": -1}), along(-1, 1, "0", "t"), "OBO", [y])
      for y in (F(k, 64) for k in (-40, -25, -13, -12, -11, -10, -9, -8, -5, -1, 1, 5, 9, 12, 40))],
    *[(f"node at {y}", polynomial({"0,2": 1, "0,1": -2 * y, "0,0": y * y, "3,0": -1, "2,0": -1}), along(-F(1, 2), F(1, 2), "t", str(y)), "IBI", [0])
      for y in (F(k, 64) for k in (-13, -12, -10, -9, 7))],        # (y - y0)^2 <= x^2 (1 + x), along the axis
    ("cusp and a line", common(CUSP, RIGHT), along(-1, 1, "0", "t"), "OBO", [0]),
    ("cusp and a line, mirrored", common(polynomial({"0,2": 1, "3,0": 1}), LEFT), along(-1, 1, "0", "t"), "OBO", [0]),
    ("cusp on the other side", common(CUSP, UPPER, LEFT), along(-1, 1, "0", "t"), "O", []),
    ("cusp or all the rest", union(CUSP, LEFT, polynomial({"0,2": -1, "3,0": 1})), along(-1, 1, "0", "t"), "I", []),
    ("two cusps", common(CUSP, polynomial({"2,0": 1, "0,3": -1})), along(-1, 1, "t", "-t"), "O", []),
    ("cusp at rest", common(CUSP, UPPER), along(0, 1, "0", "0"), "B", [(0, 1)]),
    ("cusp at rest, on the other side", common(CUSP, UPPER, LEFT), along(0, 1, "0", "0"), "O", []),
    # A disk of radius r is x^2 <= 2 r y - y^2: below y - y^(3/2) near 0 if 2 r < 1, between y -+ y^(3/2) if 2 r = 1.
    ("tacnode and a disk within", common(TACNODE, ball((0, F(2, 5)), F(2, 5))), along(F(-1, 16), F(1, 16), "t", "0"), "O", []),
    ("tacnode and a disk along", common(TACNODE, ball((0, F(1, 2)), F(1, 2))), along(F(-1, 2), F(1, 2), "0", "t"), "OBO", [0]),
    ("tacnode and a disk below", common(TACNODE, ball((0, -1), 1)), along(F(-1, 2), F(1, 2), "t", "0"), "O", []),
    # More surfaces than have a table of truth.
    ("fan", common(*FAN), along(-1, 1, "t", "0"), "OBO", [0]),
    ("fan from above", common(*FAN, UPPER), along(-1, 1, "t", "0"), "O", []),
    ("fan at rest", common(*FAN), along(0, 1, "0", "0"), "B", [(0, 1)]),
    # Zeros nearby: on x = 0 the node's curve y^2 - 100 y^3 = x^2 at y = 1/100, though between the lines y = 2 |x| it has
    # y^2 (1 - 100 y) <= y^2 / 4, so y >= 3/400; a cusp so steep that it is 2^-30 wide; one that is a loop, closed at x = 2^-24;
    # a line y = x / 2^12, which cuts the cusp at x = 2^-24 and is outside it before.
    ("node and another zero above", common(polynomial({"0,2": 1, "0,3": -100, "2,0": -1}), halfspace((2, -1)), halfspace((-2, -1))),
     along(F(-1, 2), F(1, 2), "t", "-t"), "O", []),
    ("steep cusp", common(polynomial({"2,0": 1 << 60, "0,3": -1}), RIGHT), along(F(-1, 2), F(1, 2), "t", "-t^2"), "OBO", [0]),
    ("small loop", common(polynomial({"0,2": 1, "3,0": -SMALL * SMALL, "4,0": 1}), RIGHT), along(-1, 1, "0", "t"), "OBO", [0]),
    ("line that cuts a cusp nearby", common(CUSP, halfspace((SMALL, -1))), along(-1, 1, "0", "t"), "O", []),
    # Two balls that touch.
    ("two balls through", union(*TWO), along(-3, 3, "t", "0", "0"), "OBIBIBO", [-2, 0, 2]),
    ("two balls between", union(*TWO), along(-1, 1, "0", "t", "0"), "OBO", [0]),
    ("two balls both", common(*TWO), along(-3, 3, "t", "0", "0"), "O", []),
    ("less two balls, between", minus(ball((0, 0, 0), 3), *TWO), along(-1, 1, "0", "t", "0"), "IBI", [0]),
    ("less two balls, through", minus(ball((0, 0, 0), 3), *TWO), along(F(-3, 2), F(3, 2), "t", "0", "0"), "OBO", [0]),
    ("crescent", minus(ball((0, 0, 0), 2), ball((1, 0, 0), 1)), along(-3, 3, "t", "0", "0"), "OBIBOBO", [-2, 0, 2]),
    ("no crescent", minus(ball((1, 0, 0), 1), ball((0, 0, 0), 2)), along(-3, 3, "t", "0", "0"), "O", []),
    # Contact of order four: on the disk's circle y^2 of the oval is x^4 / 4 and more.
    ("disk less oval", minus(DISK, OVAL), along(-1, F(1, 4), "0", "t"), "OBO", [0]),
    ("oval less disk", minus(OVAL, DISK), along(-1, F(1, 4), "0", "t"), "O", []),
    ("ball less egg", minus(BALL, EGG), along(-1, F(1, 4), "0", "0", "t"), "OBO", [0]),
    # Circles that cross where they touch: y = x^2 and y = x^2 + x^3.
    ("crossing of order three", minus(polynomial({"2,0": 1, "0,1": -1}), polynomial({"2,0": 1, "3,0": 1, "0,1": -1})),
     along(-1, 1, "0", "t"), "OBO", [0]),
    # A torus on a floor.
    ("torus on a floor, down", union(RAISED, FLOOR), along(F(-1, 2), F(1, 2), "2", "0", "t"), "IBI", [0]),
    ("torus on a floor, along", union(RAISED, FLOOR), along(-3, 3, "t", "0", "0"), "B", [(-3, 3)]),
    ("torus under the floor", common(RAISED, FLOOR), along(F(-1, 2), F(1, 2), "2", "0", "t"), "O", []),
    ("torus under the floor, around", common(RAISED, FLOOR),
     along(0, 1, "2*(1-t^2)/(1+t^2)", "4*t/(1+t^2)", "0"), "O", []),
    ("floor less torus", minus(FLOOR, RAISED), along(F(-1, 2), F(1, 2), "2", "0", "t"), "IBO", [0]),
    # A plate with a round hole.
    ("plate", PLATE, along(-4, 4, "t", "0", "1/2"), "OBIBOBIBO", [-3, -1, 1, 3]),
    ("plate beside the hole", PLATE, along(-2, 2, "t", "1", "1/2"), "IBI", [0]),
    ("plate, its rim", PLATE, along(-2, 2, "t", "1", "1"), "B", [(-2, 2)]),
    ("plate, the hole's wall", PLATE, along(-1, 2, "1", "0", "t"), "OBO", [(0, 1)]),
    # Three circles through a point; their inner sides have nothing in common and cover all.
    ("three disks", common(*THREE), along(-1, 1, "t", "t/3"), "O", []),
    ("three disks together", union(*THREE), along(F(-1, 3), F(1, 3), "t", "t/3"), "I", []),
    ("less three disks", minus(ball((0, 0), 3), *THREE), along(F(-1, 3), F(1, 3), "t", "t/3"), "O", []),
    # Four balls through a point.
    ("four balls", common(*(ball(c, 1) for c in ((1, 0, 0), (0, 1, 0), (0, 0, 1), (F(-2, 3), F(-2, 3), F(-1, 3))))),
     along(F(-1, 3), F(1, 3), "t", "t", "t"), "O", []),
    # Rank 1: on z = 0 the other is x^2 - y^3, x^2 + y^4, x^2 - y^4.
    ("ridge of order three", minus(polynomial({"0,0,1": 1, "2,0,0": 1, "0,3,0": -1}), halfspace((0, 0, 1))),
     along(-1, 1, "t", "0", "t^2"), "OBO", [0]),
    ("ridge up", minus(polynomial({"0,0,1": 1, "2,0,0": 1, "0,4,0": 1}), halfspace((0, 0, 1))),
     along(-1, 1, "t", "0", "t^2"), "O", []),
    ("ridge down", minus(polynomial({"0,0,1": 1, "2,0,0": 1, "0,4,0": -1}), halfspace((0, 0, 1))),
     along(-1, 1, "t", "0", "t^2"), "OBO", [0]),
    ("bent ridge", minus(polynomial({"0,0,1": 1, "2,0,0": 1, "1,2,0": -2, "0,4,0": 1}), halfspace((0, 0, 1))),
     along(-1, 1, "t", "0", "t^2"), "O", []),                       # (x - y^2)^2
    # Three surfaces along a line: y >= 0, z >= 0, y + z + (x^2, -x^2, x^3) <= 0.
    ("edge closed", corner({"0,1,0": 1, "0,0,1": 1, "2,0,0": 1}), along(-1, 1, "t", "0", "0"), "O", []),
    ("edge open", corner({"0,1,0": 1, "0,0,1": 1, "2,0,0": -1}), along(-1, 1, "t", "0", "0"), "B", [(-1, 1)]),
    ("edge open, across", corner({"0,1,0": 1, "0,0,1": 1, "2,0,0": -1}), along(-1, 1, "0", "t", "0"), "OBO", [0]),
    ("edge open, at its end", common(corner({"0,1,0": 1, "0,0,1": 1, "2,0,0": -1}), halfspace((-1, 0, 0))),
     along(-1, 1, "0", "t", "0"), "OBO", [0]),
    ("edge half open", corner({"0,1,0": 1, "0,0,1": 1, "3,0,0": 1}), along(-1, 1, "t", "0", "0"), "BO", [(-1, 0)]),
    ("edge half open, across", corner({"0,1,0": 1, "0,0,1": 1, "3,0,0": 1}), along(-1, 1, "0", "t", "t"), "OBO", [0]),
    # At 0 fifteen lines meet, more than the rules take; but a boundary on either side is enough.
    ("slide past many", union(halfspace((0, 1)), common(*(halfspace((k, k * k + 1)) for k in range(-7, 8) if k))),
     along(-1, 1, "t", "0"), "B", [(-1, 1)]),
    # Slides whose answer changes at a time at which no surface does: on SECOND = 0, FIRST = y^2 (x - 1) / (2 (1 + 2 x)).
    ("slide from 1", minus(SECOND, FIRST), along(0, 3, "t", "0", "0"), "OB", [(1, 3)]),
    ("slide until 1", minus(FIRST, SECOND), along(0, F(3, 2), "t", "0", "0"), "BO", [(0, 1)]),
    # A rim at an irrational time: (t, 1 / (2 t)) touches the circle where y = x.
    ("rim", common(ball((0, 0), 1), halfspace((-1, 1))), along(F(1, 2), 1, "t", "1/(2*t)"), "OBO", [[-1, 0, 2]]),
    # Breaks of the motion on the boundary.
    ("turned back", ball((0, 0, 0), 1), Motion(3, [(0, 1, {"translate": ["2-t", "0", "0"]}),
                                                   (1, 2, {"translate": ["t", "0", "0"]})]), "OBO", [1]),
    ("held on", ball((0, 0, 0), 1), Motion(3, [(0, 1, {"translate": ["2-t", "0", "0"]}), (1, 2, {"translate": ["1", "0", "0"]}),
                                               (2, 3, {"translate": ["3-t", "0", "0"]})]), "OBI", [(1, 2)]),
    ("at rest on it", ball((0, 0, 0), 1), along(0, 1, "1", "0", "0"), "B", [(0, 1)]),
    ("at rest inside", ball((0, 0, 0), 1), along(0, 1, "1/2", "0", "0"), "I", []),
]
# A ball that grows while it moves: F = |P - b|^2 - (1 + t)^2.
GROWING = Motion(2, [(0, 1, {"compose": [{"scale": "1+t"}, {"translate": ["8*t", "0"]}]})])
POINTS = [(4, F(3, 2), "OBIBO"), (0, 1, "BIBO"), (8, 2, "OB")]


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    for name, node, motion, word, times in SCENES:
        d = motion.dimension
        answers = graze.classify(name, Curved(d, node), motion, [ORIGIN[d]])
        if not answers:
            continue
        checks.equal(answers[0].word, word, name)
        checks.equal(times_of(answers[0].contacts), times, name)
    answers = graze.classify("growing", Curved(2, ball((0, 0), 1)), GROWING, [p[:2] for p in POINTS]) or []
    for (x, y, word), answer in zip(POINTS, answers):
        checks.equal(answer.word, word, "growing", x, y)
    checks.finish()


if __name__ == "__main__":
    main()
