"""Planar scenes with the outline of each derived by hand.

SPDX-License-Identifier: GPL-3.0-or-later

Above each scene stands its derivation. A scene has the area (a Fraction, or a Decimal of 60 digits of its closed form),
components, interior components and holes of the closed sweep or regularised unsweep, and, where they are derived, its
length, the length of its lower part (seams of a sweep, dangling parts of an unsweep) and the number of isolated lower
points. [a, b] x [c, d] is a box, L the length of a leg. Two rules are used again and again:

- rows: if each line along a direction meets S in one interval, a translation along it adds its length times the width of S
  across it; gaps that are shorter than the leg close, wider ones become shorter by it;
- rings: if each circle about the centre meets S in one arc, of w radians, a turn by φ makes it w + φ, at most 2π: it adds
  φ (R² − r²) / 2, R and r the greatest and least distance.
"""
import os
import sys
from collections import namedtuple

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from closed import PI, Decimal, acos, asin, atan, integral, log, number, root, sqrt  # noqa: E402
from exact import Fraction as F  # noqa: E402
from motion import build, compose, legs, matrix, rotation, scaling, translate, turn  # noqa: E402
from solids import Polygon, box_ring, ring  # noqa: E402

Scene = namedtuple("Scene", "name solid motion unsweep area components interior holes length lower points fine")
SCENES = []


def scene(name, solid, motion, area, *, components=1, interior=1, holes=0, length=None, lower=0, points=0, unsweep=False, fine=False):
    """`lower` None: not derived. `fine`: parts are nearer to each other than doubles tell."""
    SCENES.append(Scene(name, solid, motion, unsweep, area, components, interior, holes, length, lower, points, fine))


def unsweep(name, solid, motion, area, **more):
    scene(name, solid, motion, area, unsweep=True, **more)


def box(x0, y0, x1, y1):
    return Polygon([[box_ring(x0, y0, x1, y1)]])


def plane(*rings):
    """A polygon with holes."""
    return Polygon([list(rings)])


def moved(low, high, x, y):
    return build([(low, high, translate([x, y]))])


def quarters(n, *center):
    return build([(0, abs(n), turn(n, center=[F(c) for c in center] or None))])


UNIT = box(0, 0, 1, 1)
ELL = plane(ring((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)))
CUP = plane(ring((0, 0), (6, 0), (6, 4), (4, 4), (4, 2), (2, 2), (2, 4), (0, 4)))
FRAME = plane(box_ring(0, 0, 6, 6), box_ring(2, 2, 4, 4))
# a box with the cavity [1, 5]^2 and a mouth [2, 4] x [5, 6]
JAR = plane(ring((0, 0), (6, 0), (6, 6), (4, 6), (4, 5), (5, 5), (5, 1), (1, 1), (1, 5), (2, 5), (2, 6), (0, 6)))
STAR = plane(ring((2, 0), (F(1, 2), F(1, 2)), (0, 2), (-F(1, 2), F(1, 2)), (-2, 0), (-F(1, 2), -F(1, 2)), (0, -2), (F(1, 2), -F(1, 2))))
SMALL = (("2^-40", F(1, 2 ** 40)), ("10^-9", F(1, 10 ** 9)))

# ------------------------------------------------------------------------------------------- legs

# rows along (3, 1): the width of the square across it times L is 3 + 1; a hexagon of 4 sides 1 and 2 of √10
LEG = legs([(0, 0), (3, 1)])
scene("square along a leg", UNIT, LEG, F(5), length=4 + 2 * sqrt(10))
scene("square along a leg, there and back", UNIT, legs([(0, 0), (3, 1), (0, 0)]), F(5), length=4 + 2 * sqrt(10))
scene("square along a leg, with a rest", UNIT, legs([(0, 0), (F(3, 2), F(1, 2)), (F(3, 2), F(1, 2)), (3, 1)]), F(5),
      length=4 + 2 * sqrt(10))
# x = 3 (2 t − t²) and y = x / 3 turn back at t = 1, where the velocity is 0
scene("square along a leg, retraced in one piece", UNIT, moved(0, 2, [0, 6, -3], [0, 2, -1]), F(5), length=4 + 2 * sqrt(10))
# a corner of 180 degrees turns back in the middle of the side that it slides along, at (5/4, 0): rows are longer by 1/4, the greatest t - t²
scene("a corner that slides along its side and back", plane(ring((0, 0), (1, 0), (2, 0), (2, 1), (0, 1))), moved(0, 1, [0, 1, -1], [0]), F(9, 4),
      length=number(F(13, 2)))
# at rest the sweep is S; the star is 8 triangles (0, 0), (2, 0), (1/2, 1/2) of area 1/2; sides √(9/4 + 1/4)
scene("star at rest", STAR, legs([(0, 0), (0, 0)]), F(4), length=8 * sqrt(F(5, 2)))
# rows along x: at each |y| < 2 one interval; height 4, L = 6. Two tips' sides go, two lines of L = 6 come
scene("star along a leg", STAR, legs([(0, 0), (6, 0)]), F(4 + 24), length=8 * sqrt(F(5, 2)) + 12)
# columns of [0, 2] x [0, 1] and [0, 1] x [0, 2] along (1, 1): [0, 2 + x] on [0, 1], [0, 3] on [1, 2], [x − 2, 2] on [2, 3]:
# 5/2 + 3 + 3/2; sides 2, √2, 1, 1 (at x = 2 from 2 to 3), 1, √2, 2, √2, and from (2, 0) again √2 within it: (2, 0), (3, 1), (3, 2),
# (2, 2), (2, 3), (1, 3), (0, 2), (0, 0): 2, √2, 1, 1, 1, 1, √2, 2
scene("L along its diagonal", ELL, legs([(0, 0), (1, 1)]), F(7), length=8 + 2 * sqrt(2))
# two squares with a common corner, along (1, 1): hexagons 1 + 2 each, [1, 2]^2 in both: one hexagon of L = 2√2
PAIR = Polygon([[box_ring(0, 0, 1, 1)], [box_ring(1, 1, 2, 2)]])
scene("corner pair along its diagonal", PAIR, legs([(0, 0), (1, 1)]), F(5), length=4 + 4 * sqrt(2))
# at rest: the squares meet in a point, so W is one component, its interior two
scene("corner pair at rest", PAIR, legs([(0, 0), (0, 0)]), F(2), interior=2, length=number(8))
# scaled by 1 to 2 about the corner (1, 1): the squares [-1, 1]^2 and [1, 3]^2
scene("corner pair scaled", PAIR, build([(0, 1, scaling([[1, 1], [1, 1]], center=[F(1), F(1)]))]), F(8), interior=2, length=number(16))

# two boxes, 4 apart, and 1 apart, which is the leg: x = 2 is reached at the end and left at once, a seam from side to side
scene("two boxes far apart", Polygon([[box_ring(0, 0, 1, 1)], [box_ring(5, 0, 6, 1)]]), legs([(0, 0), (1, 0)]), F(4), components=2, interior=2,
      length=number(12))
scene("two boxes that meet", Polygon([[box_ring(0, 0, 1, 1)], [box_ring(2, 0, 3, 1)]]), legs([(0, 0), (1, 0)]), F(4), lower=1, length=number(10))
# an island in a hole: [11/4, 13/4]^2 in (2, 4)^2, by 1/4 to the right: 25/4 · 6 - 7/4 · 2 + 3/4 · 1/2
ISLAND = Polygon([[box_ring(0, 0, 6, 6), box_ring(2, 2, 4, 4)], [box_ring(F(11, 4), F(11, 4), F(13, 4), F(13, 4))]])
scene("an island in a hole", ISLAND, legs([(0, 0), (F(1, 4), 0)]), F(75, 2) - F(7, 2) + F(3, 8), components=2, interior=2, holes=1,
      length=number(F(49, 2) + F(15, 2) + F(5, 2)))
# the island is a frame itself, and so is the one in its hole, with 20, 18, 12, 10, 4 and 2 a side
NEST = Polygon([[box_ring(0, 0, 20, 20), box_ring(1, 1, 19, 19)], [box_ring(4, 4, 16, 16), box_ring(5, 5, 15, 15)],
                [box_ring(8, 8, 12, 12), box_ring(9, 9, 11, 11)]])
scene("frames in frames", NEST, legs([(0, 0), (0, 0)]), F(400 - 324 + 144 - 100 + 16 - 4), components=3, interior=3, holes=3,
      length=number(80 + 72 + 48 + 40 + 16 + 8))
# at rest: a hole that touches its outer ring in (3, 0), and a triangle that stands on the top side: 18 - 2 + 2
scene("parts that touch", Polygon([[box_ring(0, 0, 6, 3), ring((3, 0), (4, 1), (3, 2), (2, 1))], [ring((3, 3), (4, 5), (2, 5))]]),
      legs([(0, 0), (0, 0)]), F(18), interior=2, holes=1, length=20 + 4 * sqrt(2) + 2 * sqrt(5))

# ---------------------------------------------------------------------------- closed paths and holes

# along the sides of [0, p]^2: [0, p + 1]^2 without the open square (1, p)^2
for p in (2, 3):
    scene(f"square along a square of {p}", UNIT, legs([(0, 0), (p, 0), (p, p), (0, p), (0, 0)]), F((p + 1) ** 2 - (p - 1) ** 2), holes=1,
          length=number(4 * (p + 1) + 4 * (p - 1)))
# p = 1: (1, 1) is in the open square of b where b is in (0, 1)^2, never; every other point near it is: (1, y) on the way along
# y = 0 for y < 1 and along y = 1 for y > 1, (x, 1) on the ways along x = 0 and x = 1
scene("square along a square of 1", UNIT, legs([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)]), F(4), points=1, length=number(8))
# L along the square of 4: bottom ways fill [0, 6] x [0, 1] and [0, 5] x [0, 2], likewise left; right from x = 4, top from y = 4. The notch
# at (4, 4) leaves (5, 6]^2 free, and the hole is (2, 4)^2
scene("L along a square of 4", ELL, legs([(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)]), F(36 - 1 - 4), holes=1, length=number(24 + 8))
# CUP to the right by h: rows y < 2 are [0, 6 + h], rows above [0, 2 + h] and [4, 6 + h], which join at h = 2 by x = 4 alone: (4, y) is
# inside for 2 < y < 4 at no time, as the left prong reaches it at the end and the right one leaves it at once; (4, 2) ends the seam
scene("U to the right by 1", CUP, legs([(0, 0), (1, 0)]), F(7 * 2 + 2 * 3 + 2 * 3), length=number(7 + 4 + 3 + 2 + 1 + 2 + 3 + 4))
scene("U to the right by 2", CUP, legs([(0, 0), (2, 0)]), F(32), lower=2, length=number(24))
scene("U to the right by 3", CUP, legs([(0, 0), (3, 0)]), F(36), length=number(26))
# by 2 - ε a slit of width ε stays open, of height 2; by 2 + ε nothing
for text, e in SMALL:
    scene(f"U with a slit of {text}", CUP, legs([(0, 0), (2 - e, 0)]), 4 * (8 - e) - 2 * e, length=number(2 * (8 - e) + 8 + 4), fine=True)
    scene(f"U that overlaps by {text}", CUP, legs([(0, 0), (2 + e, 0)]), 4 * (8 + e), length=number(2 * (8 + e) + 8), fine=True)
# JAR to the right by h: the cavity's rows are [1 + h, 5], the mouth's [2 + h, 4]
scene("jar to the right by 1", JAR, legs([(0, 0), (1, 0)]), F(42 - 3 * 4 - 1), length=number(26 + 3 + 4 + 3 + 4 - 1 + 2 - 1))
# by 2: the mouth closes along x = 4, 5 < y < 6, from the hole's upper side to the boundary
scene("jar to the right by 2", JAR, legs([(0, 0), (2, 0)]), F(48 - 2 * 4), holes=1, lower=1, length=number(28 + 12))
scene("jar to the right by 3", JAR, legs([(0, 0), (3, 0)]), F(54 - 4), holes=1, length=number(30 + 10))
# FRAME to the right by h: the hole's rows are [2 + h, 4]
scene("frame to the right by 1", FRAME, legs([(0, 0), (1, 0)]), F(42 - 2), holes=1, length=number(26 + 6))
# by 2: x = 4, 2 <= y <= 4 is on the hole's border at the start or the end or, at (4, 2) and (4, 4), all the time: a seam without a
# vertex of the boundary
scene("frame to the right by 2", FRAME, legs([(0, 0), (2, 0)]), F(48), lower=2, length=number(28))
for text, e in SMALL:
    scene(f"frame with a slit of {text}", FRAME, legs([(0, 0), (2 - e, 0)]), 6 * (8 - e) - 2 * e, holes=1, length=number(2 * (14 - e) + 4 + 2 * e),
          fine=True)
    scene(f"frame that overlaps by {text}", FRAME, legs([(0, 0), (2 + e, 0)]), 6 * (8 + e), length=number(2 * (14 + e)), fine=True)
# along (2, 2) the closed hole [2 + s, 4 + s]^2 keeps (4, 4) alone
scene("frame along its hole's diagonal", FRAME, legs([(0, 0), (2, 2)]), F(36 + 12 + 12), points=1, length=24 + 4 * sqrt(2))

# --------------------------------------------------------------------------------------- parabolas

# The columns of the square along (t, t²), -1 <= t <= 1, are t in [x - 1, x]: from the least t² to the greatest, + 1.
# Least: x² on [-1, 0], 0 on [0, 1] (the flat side at t = 0), (x - 1)² on [1, 2]; greatest: 1 on [-1, 0], max(x², (1 - x)²) on [0, 1], 1 on [1, 2]
ARCH = moved(-1, 1, [0, 1], [0, 0, 1])
ARCH_AREA = 2 * (2 - integral([0, 0, 1], -1, 0)) + 1 + 2 * integral([0, 0, 1], F(1, 2), 1)
scene("square along a parabola", UNIT, ARCH, ARCH_AREA)
scene("square along a parabola and back", UNIT, build([(-1, 1, translate([[0, 1], [0, 0, 1]])), (1, 3, translate([[2, -1], [4, -4, 1]]))]),
      ARCH_AREA)
# a square of side e: [x - e, x] in [-1, 1] in place of [x - 1, x]: e wide, e (2 + e); at both ends 2 (e² - e³ / 3); before 0 e² - 2 e x on
# [e - 1, 0]; the greater of x² and (x - e)² on [0, e], 7 e³ / 12; then 2 e x - e². In all 4 e + e² - e³ / 12. Both long sides are as long as the
# parabola but for less than 8 e, which 60 digits do not hold
TINY = F(1, 2 ** 200)
scene("square of side 2^-200 along a parabola", box(0, 0, TINY, TINY), ARCH, 4 * TINY + TINY ** 2 - TINY ** 3 / 12,
      length=2 * sqrt(5) + log(2 + sqrt(5)), fine=True)
# A triangle with legs of e, its right angle at distance 1 from the centre and a tip at 1 + e: rings are whole between both, so that the turn by π/2 adds
# π/2 ((1 + e)² - 1) / 2 to e² / 2, and arcs of both radii, π/2 (2 + e), to less than 4 e
SLIM = F(1, 2 ** 120)
scene("triangle of side 2^-120, a quarter turn", plane(ring((1, 0), (1 + SLIM, 0), (1, SLIM))), quarters(1),
      number(SLIM ** 2 / 2) + PI / 4 * number(2 * SLIM + SLIM ** 2), length=PI, fine=True)
# A unit square with (0, 0) as its lower left corner, and a triangle below with y <= 2 x <= 0, along (t, t²): while t < 0 the corner's path has
# the square above it and the triangle below, and neither comes over it: a seam, half of the parabola; from t = 0 on, where the corner
# moves along the square's side, the square comes over it. Columns with the triangle, whose top is x² and 3 + 2 x left of -1, its floor
# (x + 1/2)² - 1, -1, x² - 1: with v = x + 1/2 3 + 2 v - v² on [-1, -1/2], 3 - v² on [-1/2, 0], then 3, 2 - x² + the greater of x² and (1 - x)², 2 - (x - 1)²
scene("corner path that is a seam at first", Polygon([[box_ring(0, 0, 1, 1)], [ring((0, 0), (-F(1, 2), -1), (0, -1))]]), ARCH,
      integral([3, 2, -1], -1, -F(1, 2)) + integral([3, 0, -1], -F(1, 2), 0) + F(3, 2) + integral([2, 0, -1], 0, 1)
      + 2 * integral([0, 0, 1], F(1, 2), 1) + integral([2, 0, -1], 0, 1), lower=sqrt(5) / 2 + log(2 + sqrt(5)) / 4)
# (t², t⁴) there and back, twice over one curve: columns [0, 1 + x²] and [(x - 1)², 2]; two arcs of y = x², √5 / 2 + ln(2 + √5) / 4 each
scene("square along a parabola, twice in one piece", UNIT, moved(-1, 1, [0, 0, 1], [0, 0, 0, 0, 1]), F(3),
      length=4 + sqrt(5) + log(2 + sqrt(5)) / 2)
# the star's half height over x is g = 2 - 3 |x| for |x| <= 1/2 and (2 - |x|) / 3 further out: both the greater of two lines there, so
# greatest t² + g(x - t) is at t = x or an end: for 0 <= x <= 1 x² + 2, then 1 + g(x - 1). Least t² - g is that of t² - 2 + 3 |x - t|, x² - 2 on
# [0, 1] and 3 x - 4 beyond, or of t² - 2/3 + |x - t| / 3, x / 3 - 25/36 (t = 1/6); they cross at x = 119/96. From 13/6 the tip (x - 2)² is least
STAR_AREA = 2 * (integral([2, 0, 1], 0, 1) + integral([6, -3], 1, F(3, 2)) + integral([2, -F(1, 3)], F(3, 2), 3)
                 - integral([-2, 0, 1], 0, 1) - integral([-4, 3], 1, F(119, 96)) - integral([-F(25, 36), F(1, 3)], F(119, 96), F(13, 6))
                 - integral([0, 0, 1], F(1, 6), 1))
scene("star along a parabola", STAR, ARCH, STAR_AREA)
# T with its tip in (0, 0) and its top y = 1 over [-1, 1], along (t, t²), then by (4, 1), (4, -1), (0, -1): see below
TIP = plane(ring((0, 0), (1, 1), (-1, 1)))


def pinch(e):
    """The last way is at height -1 - e."""
    first = build([(-1, 1, translate([[0, 1], [0, 0, 1]]))])
    rest = legs([(1, 1), (4, 1), (4, -1 - e), (0, -1 - e)])
    parts = [(-1, 1, translate([[0, 1], [0, 0, 1]]))]
    for k, (p, q) in enumerate(zip([(1, 1), (4, 1), (4, -1 - e)], [(4, 1), (4, -1 - e), (0, -1 - e)]), 1):
        parts.append((k, k + 1, translate([[F(a) - (F(b) - a) * k, F(b) - a] for a, b in zip(p, q)])))
    assert first and rest
    return build(parts)


# Columns, with T's lower side |x - t| + t²: x < 0: of the parabola 2 - least, least x² to 1/2, |x| - 1/4 to 3/2, (|x| - 1)² + 1 to 2,
# in all 29/12; of the last way [|x| - 1, 0] over [-1, 0], 1/2. On [0, 2]: above least(x), where the way at height 1 has [1, 2] from 5/4 on:
# 23/24 + 33/32 + 3/4; below 1 each: 2. On [2, 3]: [1, 2] and [-1, 0]: 2. On [3, 4]: [-1, 2]: 3. On [4, 5]: [x - 5, 2]: 5/2.
# The top of the last way is y = 0 over [-1, 5], which the tip's path y = x² touches in (0, 0): the hole on the right meets the outside there
PINCH = F(29, 12) + F(1, 2) + F(23, 24) + F(33, 32) + F(3, 4) + 2 + 2 + 3 + F(5, 2)
scene("tangent pinch", TIP, pinch(0), PINCH, holes=1)
# lower by e: two more units of column over [3, 5]; the hole opens. Higher: they go, and over |x| < √e both have x² < y < e: 4/3 e √e
for text, e in SMALL:
    scene(f"tangent gap of {text}", TIP, pinch(e), PINCH + 2 * e, fine=True)
    shared = F(4, 3) * F(1, 2 ** 60) if e == F(1, 2 ** 40) else number(F(4, 3)) * number(e) * sqrt(e)
    scene(f"tangent overlap of {text}", TIP, pinch(-e), number(PINCH - 2 * e) - shared if isinstance(shared, Decimal) else PINCH - 2 * e - shared,
          holes=1, fine=True)
# The top of the square at height -1 comes to y = 0, where the side of t = 0 was: from (1, 1) by (4, 1), (4, -1) to (-3, -1) it covers
# [-3, 5] x [-1, 0]. Over (0, 1) both are on y = 0, nothing inside: a seam of length 1 between a hole and the outside, which it parts.
# Columns: ARCH_AREA, the way [1, 5] x [1, 2] without what the arch has of it over [1, 2], [(x - 1)², 2]: 3; [4, 5] x [0, 1]: 1; 8 below
SEAM = build([(-1, 1, translate([[0, 1], [0, 0, 1]])), (1, 2, translate([[-2, 3], [1]])), (2, 3, translate([[4], [5, -2]])),
              (3, 4, translate([[25, -7], [-1]]))])
scene("flat side on a side", UNIT, SEAM, ARCH_AREA + 3 + 1 + 8, holes=1, lower=1)

# Columns of [0, 4] x [0, 1] along (t, f), f = -(t² - 2)², 0 <= t <= 2: t in [x - 4, x], least -4 everywhere, greatest f(x) to √2, 0 to 4 + √2,
# f(x - 4) to 6: 6 · 5 + ∫ f over [0, 2]. The flat top y = 1 is of the irrational time √2 on a rational line
HUMP = [-4, 0, 4, 0, -1]
scene("flats of an irrational time", box(0, 0, 4, 1), moved(0, 2, [0, 1], HUMP), 30 + integral(HUMP, 0, 2))
# on to (3, -1) by a leg, whose end has the top y = 0 over [3, 7], the line of the flat below: over [4 + √3, 6] it is above 1 + f(x - 4), and
# over [6, 7] it has [-4 + 3 (x - 6), 0]
scene("a side at a break on the line of a flat", box(0, 0, 4, 1),
      build([(0, 2, translate([[0, 1], HUMP])), (2, 3, translate([[0, 1], [-10, 3]]))]),
      number(30 + integral(HUMP, 0, 2)) - integral([-3, 0, 4, 0, -1], sqrt(3), number(2)) + number(F(5, 2)))

# FRAME by t - t³ and back within [0, 1], greatest H = 2 / (3 √3) at the irrational time 1 / √3: 6 (6 + H) without a hole of 2 (2 - H)
H, THERE = 2 / (3 * sqrt(3)), [0, 1, 0, -1]
for way, x, y in (("up", [], THERE), ("right", THERE, []), ("down", [], [-c for c in THERE]), ("left", [-c for c in THERE], [])):
    scene(f"frame {way} to an irrational place and back", FRAME, moved(0, 1, x, y), 32 + 8 * H, holes=1, length=number(32))
    scene(f"frame {way} to an irrational place and back, all askew", FRAME.mapped(lambda p: (p[0] - p[1], p[0] + p[1])),
          moved(0, 1, [-c for c in y] or x, x or y), 2 * (32 + 8 * H), holes=1, length=32 * sqrt(2))
    # In NEST each frame is higher by H, and its hole lower
    scene(f"frames in frames {way} to an irrational place and back, all askew", NEST.mapped(lambda p: (p[0] - p[1], p[0] + p[1])),
          moved(0, 1, [-c for c in y] or x, x or y), 2 * (400 - 324 + 144 - 100 + 16 - 4 + (20 + 18 + 12 + 10 + 4 + 2) * H),
          components=3, interior=3, holes=3, length=4 * (20 + 18 + 12 + 10 + 4 + 2) * sqrt(2))

# twice: flats of two times on one upright irrational line are one side
scene("square right to an irrational place and back, twice", UNIT, build([(0, 1, translate([THERE, []])), (1, 2, translate([[0, -2, 3, -1], []]))]), 1 + H,
      length=4 + 2 * H)

# Right triangles with legs of 60, a hole's of 20 and an island's of 6, by (t - t³)(1, 1): the long sides have flats on irrational lines that slope.
# A triangle grows by H √2 times its width, twice its leg over √2; the hole's legs are 20 - 2 H
BACK = [-c for c in THERE]
LEGS = Polygon([[ring((0, 0), (60, 0), (0, 60)), ring((10, 10), (30, 10), (10, 30))], [ring((12, 12), (18, 12), (12, 18))]])
for quarter, x, y in ((0, THERE, THERE), (1, BACK, THERE), (2, BACK, BACK), (3, THERE, BACK)):
    scene(f"triangles along their heights, turned {quarter} times",
          LEGS.mapped(lambda p, n=quarter: ((p[0], p[1]), (-p[1], p[0]), (-p[0], -p[1]), (p[1], -p[0]))[n]), moved(0, 1, x, y),
          1800 + 120 * H - (20 - 2 * H) ** 2 / 2 + 18 + 12 * H, components=2, interior=2, holes=1,
          length=172 - 4 * H + (86 + 2 * H) * sqrt(2))

# (t, y), y = 3 t - 5 t³, -1 <= t <= 1, extreme at ±m = ±1/√5, ±Y = ±2/√5, y(-1) = 2. Columns have t in [x - 1, x]. Greatest: 2 to x = 0, y(x - 1)
# to r, where y(r) = y(r - 1), 15 r² - 15 r + 2 = 0, y(x) to m, Y to 1 + m, y(x - 1); least: the greatest turned about. With d = 1 - 2 r = √105 / 15
# the integral of the greatest is 2 + Y + 7 d / 12
WAVE = [0, 3, 0, -5]
M, Y = 1 / sqrt(5), 2 / sqrt(5)
scene("square along a cubic", UNIT, moved(-1, 1, [0, 1], WAVE), 7 + 2 * Y + 7 * sqrt(105) / 90)


def there_and_back():
    """The area of the square along (t, y), and then back along (3 t - 2, y): columns of the second pass have t in [(x + 1) / 3, (x + 2) / 3].

    On [-5, -4] least y((x + 2) / 3), greatest 2. On [-4, -1], u = (x + 1) / 3 in [-1, 0]: greatest y(u) up to the root v of
    135 u² + 45 u - 22, where y(u) = y(u + 1/3), then y(u + 1/3); least y(u + 1/3) up to -m - 1/3, -Y up to -m, y(u).
    On [-1, 0] greatest 2 of the first pass; least y((x + 1) / 3) of the second up to x2, then y(x), -Y from -m; between both passes
    y(x) - y((x + 2) / 3) - 1 is free up to z. On [0, 1] greatest y(x - 1) up to 1 - 2 m, Y (m, of the second pass) up to 3 m - 1, y((x + 1) / 3)
    up to x3, y(x) up to m, Y; least -Y up to 1 - m, y(x - 1) up to x4, y((x + 2) / 3). On [1, 2] greatest Y up to 1 + m, y(x - 1); least -2.
    y(x) = y((x + 1) / 3) at x2, x3: 65 x² + 25 x - 22 = 0; y(x - 1) = y((x + 2) / 3) at x4: 65 x² - 55 x + 8 = 0.
    """
    third = F(1, 3)

    def area(a, b):
        return integral(WAVE, number(a), number(b))
    x2, x3, x4 = (-25 - sqrt(6345)) / 130, (-25 + sqrt(6345)) / 130, (55 + sqrt(945)) / 130
    v = root([-22, 45, 135], -1, 0)
    z = root([41, -114, -30, 130], -1, F(-9, 10))
    total = 3 - 3 * area(-1, -2 * third)
    total += 3 + 3 * (area(-1, v) + area(v + number(third), third))
    total -= 3 * (area(number(F(-2, 3)), -M) - Y * number(third) + area(-M, 0))
    total += 3 - (3 * area(0, (x2 + 1) / 3) + area(x2, -M) - Y * M)
    total -= area(-1, z) - 3 * area(third, (z + 2) / 3) - (z + 1)
    total += 1 + area(-1, -2 * M) + Y * (5 * M - 2) + 3 * area(M, (x3 + 1) / 3) + area(x3, M) + Y * (1 - M)
    total -= -Y * (1 - M) + area(-M, x4 - 1) + 3 * area((x4 + 2) / 3, 1)
    return total + 3 + Y * M + area(M, 1)


scene("square along a cubic and back thrice as fast in x", UNIT,
      build([(-1, 1, translate([[0, 1], WAVE])), (1, 3, translate([[4, -3], [6 - 40, -3 + 60, -30, 5]]))]), there_and_back())

# ------------------------------------------------------------------------------------------- turns

# rings: r = 0, R = √2. Sides of S^0 and S^1 that stay: 4; the arc of (1, 1) π/2 · √2
scene("square about a corner, quarter", UNIT, quarters(1), 1 + PI / 2, length=4 + PI / sqrt(2))
# a disk; its centre is a corner all the time
scene("square about a corner, full", UNIT, quarters(4), 2 * PI, points=1, length=2 * sqrt(2) * PI)
# corners at 90 degrees from one another
scene("square about its centre, quarter", box(-1, -1, 1, 1), quarters(1), 2 * PI, length=2 * sqrt(2) * PI)
scene("square about its centre, full", box(-1, -1, 1, 1), quarters(4), 2 * PI, length=2 * sqrt(2) * PI)
# [-1, 1] x [0, 1] about the middle of its lower side. Circles r < 1 meet it in w = π; r in [1, √2] in [a, π/2 - a] and [π/2 + a, π - a],
# a = acos(1/r), which join when turned. With ∫ a r dr = π/4 - 1/2 over [1, √2]:
# a quarter: 3π/4 + ∫ (3π/2 - 2 a) r dr = π + 1; half: π + ∫ (2π - 2 a) r dr = 3π/2 + 1; full: all
SIDE = box(-1, 0, 1, 1)
scene("side's middle, quarter", SIDE, quarters(1), PI + 1)
# the ray at the angle 0 is on the lower side at the start and, at the end, again, never inside: a seam from the centre to (1, 0); on the
# ray at the angle π the body comes over it: the line y = 0 has a seam on one half alone
scene("side's middle, half", SIDE, quarters(2), 3 * PI / 2 + 1, lower=1, length=2 + 3 * PI / sqrt(2))
# the same in one piece, by 4 atan(t), where no side at a break cuts the line in its middle
scene("side's middle, half in one piece", SIDE, build([(0, 1, rotation([0, 1], times=2))]), 3 * PI / 2 + 1, lower=1, length=2 + 3 * PI / sqrt(2))
scene("side's middle, full", SIDE, quarters(4), 2 * PI, points=1, length=2 * sqrt(2) * PI)
# rings about a far point: r² = 4, R² = 10 of [2, 3] x [0, 1]; 4 and 37/4 of [2, 3] x [-1/2, 1/2], whose inner circle is the envelope of a side.
# From r = 3 on that has two arcs, 2 acos(3/r) apart, between which the turn fills too: ∫ 2 acos(3/r) r dr = 37/4 atan(1/6) - 3/2
FAR, LEVEL = box(2, 0, 3, 1), box(2, -F(1, 2), 3, F(1, 2))
scene("square about a far point, three quarters", FAR, quarters(3), 1 + 9 * PI / 2)
scene("square about a far point, full", FAR, quarters(4), 6 * PI, holes=1, length=2 * PI * (2 + sqrt(10)))
scene("square about a far point, quarter, with an envelope", LEVEL, quarters(1),
      1 + 21 * PI / 16 + number(F(37, 4)) * atan(F(1, 6)) - number(F(3, 2)))
scene("square about a far point, full, with an envelope", LEVEL, quarters(4), 21 * PI / 4, holes=1, length=2 * PI * (2 + sqrt(37) / 2))
# clockwise, and by one function: 2 atan(t) there and back is the quarter
scene("square about a corner, quarter there and back", UNIT, build([(-1, 1, rotation([1, 0, -1]))]), 1 + PI / 2, length=4 + PI / sqrt(2))
# L about its reflex corner, which is on its border all the time; R² = 2 of (0, 0), (2, 0), (0, 2)
scene("L about its reflex corner, full", ELL, quarters(4, 1, 1), 2 * PI, points=1, length=2 * sqrt(2) * PI)
# the star's tips have r = 2
scene("star about its centre, quarter", STAR, quarters(1), 4 * PI, length=4 * PI)
# A frame [-3, 3]^2 with the hole [-1, 1]^2, in it a square on its tips that touch the hole's sides in their middles: the disk r < 1, and the
# ring 1 < r < 3√2; r = 1 is a closed seam without a vertex
EYE = Polygon([[box_ring(-3, -3, 3, 3), box_ring(-1, -1, 1, 1)], [ring((1, 0), (0, 1), (-1, 0), (0, -1))]])
scene("seam without an end", EYE, quarters(4), 18 * PI, lower=2 * PI, length=6 * sqrt(2) * PI)

# A ladder: (0, 0) and (1, 0) are carried to (0, sin) and (cos, 0) for all angles to 90 degrees; the third corner, at a right angle, runs on
# y = -x (Cardan). Below the astroid x^(2/3) + y^(2/3) = 1 every point is on the ladder at some angle: 3π/32 of area, 3/2 of length. The parts
# with y < 0 lie in S^0, those with x < 0 in S^1, triangles of area 1/4 with two sides √2/2 on the boundary
LADDER = plane(ring((0, 0), (F(1, 2), -F(1, 2)), (1, 0)))
FALL = build([(0, 1, matrix([[[1, 0, -1], [0, 2], []], [[0, -2], [1, 0, -1], [0, 2]]], [1, 0, 1]))])
scene("a ladder", LADDER, FALL, number(F(1, 2)) + 3 * PI / 32, length=number(F(3, 2)) + 2 * sqrt(2))

# --------------------------------------------------------------------------- scaling, shear, hyperbolas

# about the origin by 1 to 2: the hexagon (1, 1), (2, 1), (4, 2), (4, 4), (2, 4), (1, 2)
TWICE = build([(0, 1, scaling([[1, 1], [1, 1]]))])
scene("square scaled", box(1, 1, 2, 2), TWICE, F(7), length=6 + 2 * sqrt(5))
scene("square scaled about its centre", box(-1, -1, 1, 1), TWICE, F(16), length=number(16))
# the hole is least at the start
scene("frame scaled about its centre", FRAME, build([(0, 1, scaling([[1, 1], [1, 1]], center=[F(3), F(3)]))]), F(144 - 4), holes=1,
      length=number(48 + 8))
# x + t y: at height y [0, 1 + y]; of [-1, 1]^2 [-1, 1] and it by y: 2 + |y|
SHEAR = build([(0, 1, matrix([[[1], [0, 1], []], [[], [1], []]], [1]))])
scene("square sheared", UNIT, SHEAR, F(3, 2), length=4 + sqrt(2))
scene("square sheared about its middle", box(-1, -1, 1, 1), SHEAR, F(5), length=2 * 3 + 2 * (1 + sqrt(2)))
# diag(k, 1/k), 1 <= k <= 2, of [1, 2]^2: with the logarithms of x and y a square of side ln 2 along (1, -1); xy, from 1 to 4, is
# kept, and ∫ xy-measure: 1 + ln 2 (4 - 1)
SQUEEZE = build([(1, 2, matrix([[[0, 0, 1], [], []], [[], [1], []]], [0, 1]))])
scene("square squeezed", box(1, 1, 2, 2), SQUEEZE, 1 + 3 * log(2))
# of the triangle x + y <= 1: x/k + k y <= 1 has the envelope 4 x y = 1 from (1/2, 1/2) to (1, 1/4): 3/8 + ln 2 / 4 + 1/8; legs slide in themselves
scene("triangle squeezed", plane(ring((0, 0), (1, 0), (0, 1))), SQUEEZE, number(F(1, 2)) + log(2) / 4)

# ----------------------------------------------------------------------------------------- unsweeps

TWO = box(0, 0, 2, 2)
NOTHING = {"components": 0, "interior": 0}
unsweep("box that is passed, part", TWO, legs([(0, 0), (1, 0)]), F(2), length=number(6))
unsweep("box that is passed, nothing", TWO, legs([(0, 0), (3, 0)]), F(0), **NOTHING)
# x = 0 runs to x = 2
unsweep("box that is passed, a segment", TWO, legs([(0, 0), (2, 0)]), F(0), lower=2, **NOTHING)
# (0, 0) alone runs to (2, 2)
unsweep("box that is passed, a point", TWO, legs([(0, 0), (2, 2)]), F(0), points=1, **NOTHING)
# Each of two boxes, 6 apart, leaves one.
unsweep("boxes that are passed, two points", Polygon([[box_ring(0, 0, 2, 2)], [box_ring(8, 0, 10, 2)]]), legs([(0, 0), (2, 2)]), F(0), points=2, **NOTHING)
# the points that stay in the frame: the hole becomes [2 - 1, 4], the box [0, 5] x [0, 6]
unsweep("frame unswept", FRAME, legs([(0, 0), (1, 0)]), F(30 - 6), holes=1, length=number(22 + 10))

# by 2 and 3 the side bars, as wide as 2, keep a side each, from box to box, and nothing
unsweep("frame unswept to two boxes and their ties", FRAME, legs([(0, 0), (2, 0)]), F(16), components=2, interior=2, lower=4, length=number(24))
unsweep("frame unswept to two boxes", FRAME, legs([(0, 0), (3, 0)]), F(12), components=2, interior=2, length=number(20))

# [IS] Figure 2, in the plane: rings that stay in a rectangle; (b) a triangle about the centre of its inscribed circle
unsweep("[IS] Figure 2(a)", box(-4, -3, 4, 3), quarters(4), 9 * PI, length=6 * PI)
unsweep("[IS] Figure 2(b)", plane(ring((0, 0), (4, 0), (0, 3))), quarters(4, 1, 1), PI, length=2 * PI)
# [IS] Figure 5: a quarter turn of [-1, 9]^2 about the origin: r <= 1 for x < 0, |y| <= 1 and r <= 9 for x > 0
unsweep("[IS] Figure 5", box(-1, -1, 9, 9), quarters(1), PI / 2 + sqrt(80) + 81 * asin(F(1, 9)))
# [IS] Figure 6: L of arms 3 by (3, 0): [0, 5] x [0, 3]; the upright arm is as wide as the way: x = 0, 3 <= y <= 8 dangles
BENCH = plane(ring((0, 0), (8, 0), (8, 3), (3, 3), (3, 8), (0, 8)))
unsweep("[IS] Figure 6(a)", BENCH, legs([(0, 0), (3, 0)]), F(15), lower=5, length=number(16))
unsweep("[IS] Figure 6(b)", BENCH, legs([(0, 0), (-3, 0)]), F(15), lower=5, length=number(16))
# [IS] Figure 7: of the island the disk r <= 1, of the frame the circle r = 5 through the corners (±3, ±4) of its hole, which dangles; three
# quarter turns and 43.6 degrees (2 atan(2/5)) more
unsweep("[IS] Figure 7", Polygon([[box_ring(-5, -5, 5, 5), box_ring(-3, -4, 3, 4)], [box_ring(-1, -1, 1, 1)]]),
        build([(0, 3, turn(3)), (3, 4, compose(rotation([1], times=3), rotation([0, F(2, 5)], var="s")))]), PI, lower=10 * PI, length=2 * PI)
# [IS] Figure 8: a square about its centre
unsweep("[IS] Figure 8(a)", box(-5, -5, 5, 5), quarters(4), 25 * PI, length=10 * PI)
scene("[IS] Figure 8(b)", box(-5, -5, 5, 5), quarters(4), 50 * PI, length=10 * sqrt(2) * PI)
# [IS] Figure 10: two boxes turn by φ, cos φ = 3/5. S1 and S2 alone: no arc that stays passes an extreme angle, so the unsweep is S and S turned
# back: of S1 (2, -2), (21/4, -2), (18/5, 1/5), (2, -1), of S2 (8/3, 2), (5, 2), (5, 10/3), (24/5, 18/5)
FIRST, SECOND = box(2, -2, 6, 3), box(0, 2, 5, 6)
BOTH = plane(ring((2, -2), (6, -2), (6, 3), (5, 3), (5, 6), (0, 6), (0, 2), (2, 2)))
RADIAN = build([(0, 1, rotation([0, F(1, 2)]))])
unsweep("[IS] Figure 10, first", FIRST, RADIAN, F(35, 8))
unsweep("[IS] Figure 10, second", SECOND, RADIAN, F(2))


def arcs(a, low, high, of):
    """The integral of r asin(a/r) or r acos(a/r) from low to high."""
    def upper(r):
        r = number(r)
        return r * r / 2 * of(number(a) / r) + (1 if of is asin else -1) * number(a) / 2 * sqrt(r * r - number(a) ** 2)
    return upper(high) - upper(low)


def disk(low, high):
    return (number(high) ** 2 - number(low) ** 2) / 2


# The union meets the circle r in arcs; of w radians w - φ stay: to 2√2 of S1 alone, |θ| <= acos(2/r), from √5 on; to √34 from
# -asin(2/r) to π/2, as S1 and S2 overlap; then of S2 from acos(5/r) to π/2, from r = 6 on to asin(6/r), up to (5, 10/3)
PHI = acos(F(3, 5))
unsweep("[IS] Figure 10, both", BOTH, RADIAN,
        2 * arcs(2, sqrt(5), sqrt(8), acos) + PI / 2 * disk(sqrt(8), sqrt(34)) + arcs(2, sqrt(8), sqrt(34), asin) + arcs(5, sqrt(34), 6, asin)
        + arcs(6, 6, sqrt(325) / 3, asin) - arcs(5, 6, sqrt(325) / 3, acos) - PHI * disk(sqrt(5), sqrt(325) / 3))
# [IS] Figure 11: a bar [0, 14] x [0, 4] with an arm [5, 10] up to 10. By (-4, 0): [4, 14] x [0, 4] and [9, 10] x [4, 10]. By (0, 4): [5, 10] x [0, 6]
# and, dangling, y = 0 to both sides. First one, then the other: of what (b) keeps, moved by 4, what (a) keeps: [9, 14] x [0, 4],
# [9, 10] x [4, 6], and y = 0 from 4 to 9
ARM = plane(ring((0, 0), (14, 0), (14, 4), (10, 4), (10, 10), (5, 10), (5, 4), (0, 4)))
unsweep("[IS] Figure 11(a)", ARM, legs([(0, 0), (-4, 0)]), F(46), length=number(40))
unsweep("[IS] Figure 11(b)", ARM, legs([(0, 0), (0, 4)]), F(30), lower=9, length=number(22))
unsweep("[IS] Figure 11(d)", ARM, legs([(0, 0), (-4, 0), (-4, 4)]), F(22), lower=5, length=number(22))
# [IS] Figure 14(a), in the plane: [-6, 6] x [-3, 3] by a quarter: the square |x|, |y| <= 3 without the corners outside r = 3 in the first and
# third quadrants. (d): a square and a block along (3, 3): rows along (1, 1) are single, x - y from -2 to 3: 5 + 3 · 5
unsweep("[IS] Figure 14(a)", box(-6, -3, 6, 3), quarters(1), 18 + 9 * PI / 2, length=12 + 3 * PI)
scene("[IS] Figure 14(d)", plane(ring((0, 0), (3, 0), (3, 1), (2, 1), (2, 2), (0, 2))), legs([(0, 0), (3, 3)]), F(20))

# [EI] Figures 3, 5, 7, 8: the U to the right by 20, then a quarter turn about the middle of its foot. Rows of the way: [0, 26] x [0, 4]. Of the turn,
# about (23, 0): above y = 4 the segment of the circle r = 5 of both prongs, 25 a - 12, cos a = 4/5; below y = 0 the quarter disk r < 3 and
# for 3 < r < 5 the angles from π to 3π/2 - acos(3/r): 25/2 a + 6
A = acos(F(4, 5))
scene("[EI] Figures 3, 5, 7, 8", CUP, build([(0, 1, translate([[0, 20], [0]])), (1, 2, compose(rotation([-1, 1], center=[F(3), F(0)]),
                                                                                          translate([[20], [0]])))]), 98 + 75 * A / 2)
# [EI] Figure 4: teeth along 24, more than the shape is wide: each row is from its least x to its greatest, and 24 more. Widths: 14 - |y|/2 on
# [-4, -2], 18 - 3 |y| / 4 on [-2, 0], 22 on [0, 2], with v = y - 2 20 - 3 v / 4 on [2, 4], 16 - v / 2 on [4, 6], 3 - v / 3 on [6, 8]
TEETH = plane(ring((0, 0), (3, 0), (4, -4), (6, -4), (7, 0), (9, 0), (10, -3), (11, 0), (13, 0), (14, -4), (16, -4), (17, 0), (19, 0), (20, -2),
                   (21, 0), (22, 0), (22, 2), (21, 2), (20, 6), (19, 5), (18, 6), (17, 2), (16, 2), (15, 8), (14, 8), (13, 2), (12, 2), (11, 6),
                   (9, 6), (8, 2), (7, 2), (6, 6), (5, 2), (3, 2), (2, 4), (1, 2), (0, 2)))
scene("[EI] Figure 4", TEETH, moved(0, 1, [0, 12, 12], [0]),
      12 * 24 + integral([14, -F(1, 2)], 2, 4) + integral([18, -F(3, 4)], 0, 2) + 44 + integral([20, -F(3, 4)], 0, 2)
      + integral([16, -F(1, 2)], 2, 4) + integral([3, -F(1, 3)], 4, 6))
# [EI] Figures 6 and 16: rows of a U and of a comb whose gaps are shorter than the way, 20
scene("[EI] Figure 6", CUP, moved(0, 1, [0, 10, 10], [0]), F(104), length=number(60))
COMB = plane(ring((0, 0), (14, 0), (14, 8), (12, 8), (12, 3), (10, 3), (10, 8), (8, 8), (8, 2), (6, 2), (6, 5), (4, 5), (4, 2), (2, 2), (2, 8), (0, 8)))
scene("[EI] Figure 16", COMB, moved(0, 1, [0, 10, 10], [0]), F(272), length=number(84))
