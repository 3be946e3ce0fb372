#!/usr/bin/env python3
"""Makes pairs of solids, one of them moving, whose first contacts are told exactly: ten families of a thousand.

    python3 cases/contacts/pairs.py OUT [--count N]

Writes OUT/pairs.csv, one row a pair, and the solids and motions that it names. Every coordinate and every coefficient is a
binary64, by rational arithmetic alone, so that every machine writes the same bytes. Where a pair is made so that its
answer is known, the row has it: see README.md.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import csv
import os
import sys
from fractions import Fraction as F

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "benchmark"))

from motions import ZERO, about, along, legs, motion_text, poly, product, shifted, spline, turned  # noqa: E402
from solids import Noise, ball, blocks, box, disk, mapped, moved, off, pattern, prism, star, teeth, torus  # noqa: E402

COLUMNS = ("id", "family", "kind", "moving", "motion", "fixed", "facets", "known", "known_first")
TETRAHEDRON = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])


class Pair:
    """Two meshes, the moving one's pieces of motion; where they are known, the word, with a + if it may go on, and the first time."""

    def __init__(self, kind, moving, pieces, fixed, known="", first=None):
        self.kind, self.moving, self.pieces, self.fixed = kind, moving, pieces, fixed
        self.known, self.first = known, first


# ------------------------------------------------------------------------------------------------ solids about the origin
def between(noise, low, high, parts=16):
    """A multiple of 1 / parts in [low, high]."""
    return F(low * parts + noise.below(int((high - low) * parts) + 1), parts)


def centred_box(noise):
    half = [between(noise, F(1, 4), 1) for _ in range(3)]
    return box([-h for h in half], half)


def polycube(noise):
    rows = [("##", "#."), ("###", "#.#"), (".#.", "###", ".#."), ("###", "#.#", "###")][noise.below(4)]
    n, m = len(rows[0]), len(rows)
    lines = [[F(k - F(size, 2)) / 2 for k in range(size + 1)] for size in (n, m, 1)]
    return blocks(pattern(rows), *lines)


def solid(noise):
    """A name and a mesh of 4 to 1,000 facets, within 2 of the origin."""
    kind = noise.below(10)
    if kind == 0:
        return "tetrahedron", mapped(TETRAHEDRON, lambda *v: [2 * c - F(1, 2) for c in v])
    if kind <= 2:
        return "box", centred_box(noise)
    if kind == 3:
        return "octahedron", ball(1)
    if kind == 4:
        return "prism", prism(disk(between(noise, F(1, 2), 1), 3 + noise.below(30)), F(-1, 2), F(1, 2))
    if kind == 5:
        return "polycube", polycube(noise)
    if kind == 6:
        return "gear", star(teeth(4 + noise.below(9), F(3, 4), 1), [F(-1, 4), F(1, 4)])
    if kind == 7:
        return "torus", torus(6 + noise.below(15), 4 + noise.below(9), 1, F(3, 8))
    if kind == 8:
        return "rock", ball(2 + noise.below(6), 1, noise, F(1, 8))
    return "ball", ball(2 + noise.below(10))


def two(noise):
    (a, moving), (b, fixed) = solid(noise), solid(noise)
    return f"{a} and {b}", moving, fixed


def place(noise, far):
    return tuple(between(noise, -far, far) for _ in range(3))


# ------------------------------------------------------------------------------------------------ families with answers known
def after(first, until):
    """Word and time of a contact at `first` after which the interiors meet, if the motion goes on so far."""
    return ("O", None) if first > until else ("OB", first) if first == until else ("OBI+", first)


def head_on(noise):
    """Two boxes, face on face: the way between them over the speed."""
    a, b = centred_box(noise), centred_box(noise)
    gap = between(noise, 1, 4)
    low, high = min(v[0] for v in b[0]), max(v[0] for v in a[0])
    x = low - high - gap
    aside = [between(noise, F(-1, 8), F(1, 8)) for _ in range(2)]
    speed = [gap, gap / 2, gap * 2, gap + 1][noise.below(4)]
    return Pair("boxes", a, [along(poly(x, speed), poly(aside[0]), poly(aside[1]))], b, *after(gap / speed, 1))


def ridge(noise, up):
    """A prism of three sides whose edge lies along x (a fixed one, its edge up) or along y (a moving one, its edge down)."""
    half, side = between(noise, 1, 2), between(noise, F(1, 4), 1)
    outline = [(-side, -1), (side, -1), (0, 0)] if up else [(side, 1), (-side, 1), (0, 0)]
    mesh = prism(outline, -half, half)  # the outline's plane is xy, the edge along z
    turn = (lambda x, y, z: (z, x, y)) if up else (lambda x, y, z: (x, z, y))
    vertices, faces = mapped(mesh, turn)
    return (vertices, faces) if up else (vertices, [f[::-1] for f in faces])  # the second map is a reflection


def edges(noise):
    """Two edges that cross: straight down, or along a parabola that touches and leaves."""
    moving, fixed = ridge(noise, False), ridge(noise, True)
    aside = [between(noise, F(-1, 2), F(1, 2)) for _ in range(2)]
    if noise.below(2):
        height = between(noise, F(1, 2), 2)
        speed = [height, height * 2, height / 2, height + F(1, 2)][noise.below(4)]
        return Pair("edges cross", moving, [along(poly(aside[0]), poly(aside[1]), poly(height, -speed))], fixed, *after(height / speed, 1))
    at, curve = between(noise, F(1, 4), F(3, 4)), between(noise, 1, 4)
    z = [curve * at * at, -2 * curve * at, curve]
    return Pair("edges graze", moving, [along(poly(aside[0]), poly(aside[1]), z)], fixed, "OBO", at)


def cone(noise, up):
    """A pyramid of four sides with its tip in the origin."""
    height, half = F(1), between(noise, 1, 2)
    z = -height if up else height
    base = [(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)]
    faces = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (0, 2, 1), (0, 3, 2)]
    vertices = [*base, (F(0), F(0), F(0))]
    return (vertices, faces) if up else (vertices, [f[::-1] for f in faces])


def grazing(noise, height):
    """A tip along a parabola whose lowest point is `height` over a face, an edge or a tip; it drifts in x meanwhile.

    The moving cone is above its tip and the fixed solid below z = 0, where the origin is in its face, edge or tip. So they are apart
    while the tip is above, and at the height 0 they touch in the origin alone.
    """
    at, curve, drift = between(noise, F(1, 4), F(3, 4)), between(noise, 1, 4), between(noise, F(1, 4), F(1, 2))
    what = ("face", "edge", "vertex")[noise.below(3)]
    fixed = box((-2, -2, -1), (2, 2, 0)) if what == "face" else ridge(noise, True) if what == "edge" else cone(noise, True)
    path = along([-drift * at, drift], ZERO, [curve * at * at + height, -2 * curve * at, curve])
    return what, cone(noise, False), [path], fixed, at


def grazes(noise):
    what, moving, pieces, fixed, at = grazing(noise, F(0))
    return Pair(f"tip on {what}", moving, pieces, fixed, "OBO", at)


def slides(noise):
    """A box on a box: in contact from where the sides pass each other until they do again, or the motion ends."""
    a, b = centred_box(noise), centred_box(noise)
    reach = max(v[0] for v in a[0]) + max(v[0] for v in b[0])
    z = max(v[2] for v in b[0]) - min(v[2] for v in a[0])
    y = between(noise, F(-1, 8), F(1, 8))
    gap, kind = between(noise, F(1, 2), 2), noise.below(3)
    far = (gap, gap + reach, 2 * gap + 2 * reach)[kind]  # to the first touch of sides, to the middle, beyond
    known = ("OB", "OB", "OBO")[kind]
    return Pair("box on box", a, [along(poly(-reach - gap, far), poly(y), poly(z))], b, known, gap / far)


def near_misses(noise):
    """By less than any tolerance, or into it by as much: a box beside a box, a tip over a face, an edge or a tip."""
    small = F(1, 2 ** (10 + noise.below(51)))
    sign = (1, -1)[noise.below(2)]
    if noise.below(2):
        what, moving, pieces, fixed, _ = grazing(noise, sign * small)
        return Pair(f"tip over {what}", moving, pieces, fixed, "O" if sign > 0 else "OBI+")
    a, b = box((0, 0, 0), [between(noise, F(1, 2), 2) for _ in range(3)]), box((0, 0, 0), [between(noise, F(1, 2), 2) for _ in range(3)])
    speed, up = between(noise, 9, 12), between(noise, F(-1, 4), F(1, 4))
    width = max(v[0] for v in a[0])
    y = max(v[1] for v in b[0]) + sign * small
    known = ("O", None) if sign > 0 else ("OBI+", (6 - width) / speed)
    return Pair("box beside box", a, [along(poly(-6, speed), poly(y), poly(up))], b, *known)


# ------------------------------------------------------------------------------------------------ families that turn or bend
def turns(noise):
    """About the z axis by at most a quarter, into a solid beside it."""
    kind, moving, fixed = two(noise)
    arm = (between(noise, F(3, 2), 3), F(0), F(0))
    moving = moved(moving, *arm)
    at = (between(noise, -1, 2), between(noise, 2, 4), between(noise, -1, 1))
    return Pair(kind, moving, [turned(about((0, 0, 1), poly(0, 1)))], moved(fixed, *at))


def screws(noise):
    """A turn about a slanted axis and a way along it."""
    kind, moving, fixed = two(noise)
    axis = [(0, 0, 1), (1, 2, 2), (2, -2, 1), (2, 3, 6)][noise.below(4)]
    pitch = between(noise, F(1, 8), F(1, 2))
    pieces = [turned(about(axis, poly(0, between(noise, F(1, 2), 1))), way=[poly(0, pitch * c) for c in axis])]
    return Pair(kind, moved(moving, *place(noise, 1)), pieces, moved(fixed, *place(noise, 2)))


def tumbles(noise):
    """Turns about two axes at once while it flies by."""
    kind, moving, fixed = two(noise)
    q = product(about((0, 0, 1), poly(0, between(noise, F(1, 4), 1))), about((1, 0, 0), poly(0, between(noise, F(1, 4), 1))))
    start = place(noise, 4)
    end = [between(noise, F(1, 2), 1) * -c for c in start]
    way = [poly(a, b - a) for a, b in zip(start, end)]
    return Pair(kind, moving, [turned(q, way=way)], fixed)


def beziers(*controls):
    """The cubic over four points, as one piece from 0 to 1."""
    return along(*(poly(a, 3 * (b - a), 3 * (a - 2 * b + c), d - 3 * c + 3 * b - a) for a, b, c, d in zip(*controls)))


def splines(noise):
    """Along a Bezier cubic, or a uniform B-spline of four to eight pieces."""
    kind, moving, fixed = two(noise)
    if noise.below(2):
        return Pair(kind, moving, [beziers(*(place(noise, 4) for _ in range(4)))], fixed)
    # A uniform B-spline divides by 6: its points are multiples of 3 / 4, so that all coefficients are dyadic.
    controls = [tuple(F(3, 4) * c for c in place(noise, 6)) for _ in range(7 + noise.below(5))]
    return Pair(kind, moving, spline(controls), fixed)


def logs(noise):
    """Straight from place to place, as a log of poses has it: twenty to a hundred legs that wander."""
    kind, moving, fixed = two(noise)
    at = [place(noise, 4)]
    for _ in range(20 + noise.below(81)):
        at.append(tuple(c + d - F(c, 16) for c, d in zip(at[-1], place(noise, 1))))
    return Pair(kind, moving, legs(*([rounded(c) for c in p] for p in at)), fixed)


def rounded(x):
    return F(round(x * 256), 256)


FAMILIES = {"head-on": head_on, "edges": edges, "grazes": grazes, "slides": slides, "near-misses": near_misses,
            "turns": turns, "screws": screws, "tumbles": tumbles, "splines": splines, "logs": logs}


def dart():
    """DART's spline: a unit cube along a Bezier cubic by a fixed one, at the root of 8 t^3 - 12 t^2 + 1."""
    cube = box([F(-1, 2)] * 3, [F(1, 2)] * 3)
    path = beziers((-2, 2, 0), (-2, -2, 0), (2, -2, 0), (2, 2, 0))
    return Pair("dart", cube, [path], moved(cube, 0, -1, 0), "OBI+")


# ------------------------------------------------------------------------------------------------ files
class Folder:
    """OUT, where one mesh or motion is one file, however many pairs it stands in."""

    def __init__(self, out):
        self.out, self.known, self.count = out, {}, {"solids": 0, "motions": 0}
        for name in ("solids", "motions"):
            os.makedirs(os.path.join(out, name), exist_ok=True)

    def put(self, kind, ending, text):
        if text not in self.known:
            self.known[text] = f"{kind}/{self.count[kind]:05}{ending}"
            self.count[kind] += 1
            with open(os.path.join(self.out, self.known[text]), "w", encoding="ascii") as file:
                file.write(text)
        return self.known[text]


def made(family, count):
    """The pairs of a family; the first one of the splines is DART's."""
    noise = Noise(1 + 1000 * list(FAMILIES).index(family))
    for k in range(count):
        yield dart() if family == "splines" and k == 0 else FAMILIES[family](noise)


def write(out, count, families=FAMILIES):
    folder = Folder(out)
    with open(os.path.join(out, "pairs.csv"), "w", encoding="ascii", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(COLUMNS)
        for family in families:
            for k, pair in enumerate(made(family, count)):
                rows.writerow([f"{family}-{k:04}", family, pair.kind, folder.put("solids", ".off", off(pair.moving)),
                               folder.put("motions", ".json", motion_text(pair.pieces)), folder.put("solids", ".off", off(pair.fixed)),
                               len(pair.moving[1]) + len(pair.fixed[1]), pair.known, "" if pair.first is None else pair.first])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("out", help="the folder")
    parser.add_argument("--count", type=int, default=1000, help="pairs of each family (1000)")
    options = parser.parse_args()
    write(options.out, options.count)


if __name__ == "__main__":
    main()
