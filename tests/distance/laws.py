#!/usr/bin/env python3
# suite
"""Laws that enclosures of the distance obey (C66, C67): neighbours on lines, rigid maps, powers of two, motions cut,
turned around and at another speed, solids of two parts, smaller tolerances.

SPDX-License-Identifier: GPL-3.0-or-later

Solids and motions are those of the agreement tests. Two enclosures of one number must meet. Where all coordinates are
multiplied by a power of two, so are the bounds of a least distance over the motion (their decimals are rounded
outward, so the last bit may differ), and the time is the same. A smaller tolerance only continues the search: each
enclosure lies in that of the tolerance before, also in worlds of any size, in slabs thinner than tolerances, and where
doubles or the work for a point end it.
"""
import csv
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
for folder in ("lib", os.path.join("agree", "lib")):
    sys.path.insert(0, os.path.join(HERE, "..", folder))

import refine  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from motion import build, compose, conjugated, cut, mobius, reversed_in_time, rotation, squared, translate  # noqa: E402
from points import mixed  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from scenes import scenes  # noqa: E402
from solids import block, meshes, polygons  # noqa: E402

SCENES = 5     # in the plane, and in space
POINTS = 12
LINES = 2
STEPS = 12     # points of a line
TOLERANCE = F(1, 2 ** 24)
EXPONENTS = (40, -40)
FAR_EXPONENTS = (100, 40, 0, -40, -100)
CHAIN = [F(1, 10 ** k) for k in (1, 2, 3, 5, 7, 9, 12, 15, 30)]
THICKNESSES = (F(1, 10 ** 9), F(1, 2 ** 40))
ROUNDED = F(1, 2 ** 51)
RIGID = {2: [[F(3, 5), F(-4, 5), 1], [F(4, 5), F(3, 5), -2]],
         3: [[F(2, 3), F(-1, 3), F(2, 3), 3], [F(2, 3), F(2, 3), F(-1, 3), -2], [F(-1, 3), F(2, 3), F(2, 3), 1]]}


class Law:
    """One scene: the program, the checks, and the enclosures that others are compared with."""

    def __init__(self, graze, checks, scene, rng, *flags):
        self.graze, self.checks, self.rng, self.flags = graze, checks, rng, flags
        self.name, self.solid, self.motion = scene
        self.points = [p for _, p in mixed(self.solid, self.motion, rng, POINTS)]
        self.base = self.ask("itself", self.solid, self.motion, self.points)

    def ask(self, law, solid, motion, points, tolerance=TOLERANCE):
        """[(pmc, low, high, t)]."""
        paths = (self.graze.write("solid" + solid.suffix, solid.text()), self.graze.write("motion.json", motion.text()),
                 self.graze.write("points.csv", "".join(",".join(map(str, p)) + "\n" for p in points)))
        out = self.graze.call("classify", *paths, "--quiet", "--sdf", str(tolerance), *self.flags)
        rows = list(csv.DictReader(line for line in out.stdout.splitlines() if not line.startswith("#")))
        self.checks.equal((out.returncode, len(rows)), (0, len(points)), self.name, law, out.stderr)
        return [(r["pmc"], F(r["sdf_low"]), F(r["sdf_high"]), r["sdf_t"]) for r in rows]

    def same(self, law, found, base=None):
        for p, (pmc, low, high, _), (want, least, most, _) in zip(self.points, found, base or self.base):
            self.checks.holds(pmc == want and low <= most and least <= high, self.name, law, *self.flags, ",".join(map(str, p)),
                              f"{pmc} [{to_double(low)}, {to_double(high)}], {want} [{to_double(least)}, {to_double(most)}]")


def affine(m):
    return lambda p: tuple(sum(a * x for a, x in zip(row, p)) + row[-1] for row in m)


def law_motion(law):
    width = law.motion.end - law.motion.start
    times = [law.motion.start + width * F(law.rng.randint(1, 96), 97) for _ in range(3)]
    many = [law.motion.start + width * F(k, 41) for k in range(1, 41)]  # their arcs are searched in a tree
    for name, motion in (("reversed", reversed_in_time(law.motion)), ("cut", cut(law.motion, times)), ("in many", cut(law.motion, many)),
                         ("mobius", mobius(law.motion)[0]), ("squared", squared(law.motion)[0])):
        law.same(name, law.ask(name, law.solid, motion, law.points))


def law_rigid(law):
    m = RIGID[law.motion.dimension]
    d = len(m)
    back = [[m[i][j] for i in range(d)] + [-sum(m[i][j] * m[i][d] for i in range(d))] for j in range(d)]
    f = affine(m)
    law.same("rigid", law.ask("rigid", law.solid.mapped(f), conjugated(law.motion, m, back), [f(p) for p in law.points]))


def scaled(law, exponent):
    """A name, and the solid, motion and points of the world that is 2^exponent times as large."""
    d, k = law.motion.dimension, F(2) ** exponent
    m, back = ([[x * (i == j) for j in range(d)] + [F(0)] for i in range(d)] for x in (k, 1 / k))
    f = affine(m)
    return f"times 2^{exponent}", law.solid.mapped(f), conjugated(law.motion, m, back), [f(p) for p in law.points]


def law_scaled(law):
    for exponent in EXPONENTS:
        k = F(2) ** exponent
        name, *world = scaled(law, exponent)
        found = law.ask(name, *world, TOLERANCE * k)
        for p, (pmc, low, high, t), (want, least, most, time) in zip(law.points, found, law.base):
            where = (law.name, name, *law.flags, ",".join(map(str, p)))
            law.checks.holds(low / k <= most and least <= high / k, *where, to_double(low / k), to_double(high / k))
            if pmc == ("in" if law.flags else "out"):  # others begin at contacts' times, enclosed in another way
                off = max(abs(low / k - least), abs(high / k - most))
                law.checks.equal((pmc, t), (want, time), *where)
                law.checks.holds(off <= ROUNDED * max(abs(least), abs(most)), *where, to_double(off))


def law_lines(law):
    ends = [(min(p[i] for p in law.points), max(p[i] for p in law.points)) for i in range(law.motion.dimension)]
    for _ in range(LINES):
        a, b = ([low - 1 + (high - low + 2) * F(law.rng.randint(0, 64), 64) for low, high in ends] for _ in range(2))
        line = [tuple(x + (y - x) * F(k, STEPS) for x, y in zip(a, b)) for k in range(STEPS + 1)]
        step = sum((y - x) ** 2 for x, y in zip(line[0], line[1]))
        found = law.ask("line", law.solid, law.motion, line)
        for p, (_, low, high, _), (_, least, most, _) in zip(line, found, found[1:]):
            apart = max(low - most, least - high, 0)
            law.checks.holds(apart * apart <= step, law.name, "line", *law.flags, ",".join(map(str, p)), to_double(apart), to_double(step) ** .5)


def law_parts(law):
    pool = meshes() if law.motion.dimension == 3 else polygons()
    other = refine.beside(law.solid, pool["octahedron" if law.motion.dimension == 3 else "star"], F(1, 4))
    alone = law.ask("other part", other, law.motion, law.points)
    both = law.ask("two parts", refine.union(law.solid, other)[0], law.motion, law.points)
    least = []
    for (one, a, b, _), (two, c, d, _) in zip(law.base, alone):
        pmc = next(x for x in ("in", "on", "out") if x in (one, two))
        least.append((pmc, min(a, c), min(b, d), None))
    law.same("two parts", both, least)


def law_nested(law, chain=CHAIN):
    exponent = law.rng.choice(FAR_EXPONENTS)
    name, *world = scaled(law, exponent)
    before = None
    for tolerance in chain:
        found = law.ask(name, *world, tolerance * F(2) ** exponent)
        for p, (pmc, low, high, _), (want, least, most, _) in zip(law.points, found, before or found):
            law.checks.holds(pmc == want and least <= low and high <= most, law.name, name, *law.flags, to_double(tolerance),
                             ",".join(map(str, p)), f"{pmc} [{to_double(low)}, {to_double(high)}] in [{to_double(least)}, {to_double(most)}]")
        before = found


def thin_slabs():
    """Slabs that turn in their plane, rise through it, or pitch."""
    level = {"axis": [0, 0, 1], "length": 1}
    ways = {"turns and slides": compose(rotation([0, 1], **level), translate([[0, 3], [0, 0, 1], [0]])),
            "turns and rises": compose(rotation([0, 1], **level), translate([[0, 3], [0, 0, 1], [F(-1, 2), 1]])),
            "pitches": compose(rotation([0, 1], axis=[1, 2, 2], length=3), translate([[0, 1], [0], [0, 1]]))}
    return [(f"slab {to_double(h):g} {name}", block(0, 0, 0, 2, 2, h), build([(0, 1, way)]))
            for h in THICKNESSES for name, way in ways.items()]


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    # Where a map is singular, finer ones end at the limit of cells; the slabs below have them in any case.
    shorter = CHAIN if args.to_the_end else CHAIN[:-3]
    for scene in scenes(args, SCENES):
        for flags in ((), ("--operation", "unsweep")):
            law = Law(graze, checks, scene, args.random, *flags)
            for obey in (law_motion, law_rigid, law_scaled, law_lines, *(() if flags else (law_parts,))):
                obey(law)
            law_nested(law, shorter)
    for _, scene in args.cycle(thin_slabs(), 1, "slabs"):
        for flags in ((), ("--operation", "unsweep")):
            law_nested(Law(graze, checks, scene, args.random, *flags))
    checks.finish()


if __name__ == "__main__":
    main()
