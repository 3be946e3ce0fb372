#!/usr/bin/env python3
"""Judges first contacts of balls and capsules with boxes by `graze collide`: FCL's and Bullet's by conservative advancement, FCL's at 1,000 times.

    python3 cases/candidates/round_bodies.py --graze build/graze [--count N] [--code CODE] [--only FAMILY]

As fcl.py does for boxes; prints a table of the README. Coordinates, radii and coefficients are doubles exactly.
SPDX-License-Identifier: CC0-1.0
"""
import functools
import json
import os
from fractions import Fraction as F

from fcl import MICRON, Box, main, motion, straight, write


class Round:
    """A ball about one point, or a capsule about the segment between two."""

    def __init__(self, radius, *points):
        self.radius, self.points = F(radius), [[F(x) for x in p] for p in points]

    def base(self):
        """An OFF of the points alone, as the candidates read it."""
        return f"OFF\n{len(self.points)} 0 0\n" + "".join(" ".join(str(float(x)) for x in p) + "\n" for p in self.points)

    def solid(self):
        start, axis = self.points[0], [b - a for a, b in zip(self.points[0], self.points[-1])]
        numbers = {"radius": str(self.radius)}
        if len(self.points) == 1:
            return json.dumps({"dimension": 3, "solid": {"ball": {"center": list(map(str, start)), **numbers}}})
        return json.dumps({"dimension": 3, "solid": {"capsule": {"point": list(map(str, start)), "axis": list(map(str, axis)), **numbers}}})


# ------------------------------------------------------------------------------------------------ families
# Each makes (moving, motion, fixed) with a generator of random numbers. Sixteenths and 64ths keep all exact.

def between(rng, low, high, parts=16):
    return F(rng.randint(low * parts, high * parts), parts)


def post(rng):
    return Box((0, 0, 0), [between(rng, 1, 2) for _ in range(3)])


def beside(rng, gap, capsule):
    """A body that passes a box at a gap in y, between its bottom and its top; a capsule lies along x."""
    fixed, radius = post(rng), F(rng.randint(2, 16), 16)
    moving = Round(radius, *((0, 0, 0), (between(rng, 1, 2), 0, 0))[:1 + capsule])
    start = (-8, fixed.high[1] + radius + gap, fixed.high[2] * F(rng.randint(1, 7), 8))
    return moving, straight(start, (between(rng, 14, 18), 0, 0)), fixed


def by_edge(rng, gap, capsule):
    """The way along the box's long edge in x is 3/5 and 4/5 of the radius away from it; a capsule lies along x."""
    fixed, unit = post(rng), F(rng.randint(1, 8), 16)
    moving = Round(5 * unit, *((0, 0, 0), (between(rng, 1, 2), 0, 0))[:1 + capsule])
    start = (-8, fixed.high[1] + 3 * unit + gap, fixed.high[2] + 4 * unit + gap)
    return moving, straight(start, (between(rng, 14, 18), 0, 0)), fixed


def head_on(rng, capsule):
    """Askew into the box, or past it."""
    fixed, radius = post(rng), F(rng.randint(2, 16), 16)
    moving = Round(radius, *((0, 0, 0), (between(rng, -1, 1), between(rng, -1, 1), 1))[:1 + capsule])
    start, aim = (-8, between(rng, -4, 4), between(rng, -4, 4)), [between(rng, -1, 3) for _ in range(3)]
    return moving, straight(start, [2 * (a - b) for a, b in zip(aim, start)]), fixed


def through(rng, capsule):
    """A small body that crosses a thin wall between two of 1,000 times."""
    moving = Round(F(1, 512), *((0, 0, 0), (0, 0, F(1, 2)))[:1 + capsule])
    wall = Box((0, -1, -1), (F(1, 1024), 1, 1))
    return moving, straight((-8 - F(rng.randint(0, 1023), 1024), 0, 0), (20, 0, 0)), wall


def turning(rng):
    """A capsule that turns about its middle into a post, or stops before it; the angle is 2 atan t."""
    length = between(rng, 2, 4)
    at = (length * F(rng.randint(6, 15), 16), between(rng, 1, 4))
    fixed = Box((*at, -2), (at[0] + F(1, 4), at[1] + F(1, 4), 2))
    return Round(F(rng.randint(1, 8), 32), (-length, 0, 0), (length, 0, 0)), motion({"rotate": {"axis": [0, 0, 1], "tan_half": "t"}}), fixed


FAMILIES = {}
for _name, _capsule in (("ball", 0), ("capsule", 1)):
    FAMILIES.update({
        f"{_name} beside a face, 1e-6 off": functools.partial(beside, gap=MICRON, capsule=_capsule),
        f"{_name} along a face": functools.partial(beside, gap=0, capsule=_capsule),
        f"{_name} along an edge": functools.partial(by_edge, gap=0, capsule=_capsule),
        f"{_name} into an edge by 1e-6": functools.partial(by_edge, gap=-MICRON, capsule=_capsule),
        f"{_name} at a box": functools.partial(head_on, capsule=_capsule),
        f"{_name} through a wall": functools.partial(through, capsule=_capsule)})
FAMILIES["capsule turns into a post"] = turning


def written(folder, moving, path, fixed):
    """A pair as files, for fcl.main."""
    base, solid, way, box = (os.path.join(folder, end) for end in ("base.off", "moving.csg.json", "motion.json", "fixed.off"))
    for where, text in zip((base, solid, way, box), (moving.base(), moving.solid(), path, fixed.text())):
        write(where, text)
    return (solid, way, box), (base, way, box), (repr(float(moving.radius)),)


if __name__ == "__main__":
    main(__doc__, FAMILIES, written)
