# suite
"""`graze outline` against two methods that have no candidate curves: exact unions along legs, slices otherwise; and a formula.

SPDX-License-Identifier: GPL-3.0-or-later

Along legs area and numbers are those of the union of the solid at the path's corners and of parallelograms (unions.py), equal as
ratios. A convex polygon along a leg has its area and width times length more. Curved motions are compared with slices (slices.py),
whose areas are good to a millionth, lengths to a thousandth.
"""
from itertools import chain

from byhand import F, plane
from drawn import SOLIDS, convex, path, scene
from motion import build, legs, translate
from outlines import Checks, Program, middle, options
from refine import complement
from slices import Slices
from solids import ring
from unions import along, unswept

LEGS, LEAVES, CONVEX, CURVED = 60, 30, 40, 24  # rounds at scale 1
NEAR, ROUGH = 1e-6, 1e-3
FINE = 100                                     # lines of a stretch, where those of slices.py are too few


def exact(checks, program, args):
    for k in args.rounds(LEGS, "legs"):
        rng = args.random
        solid = rng.choice(list(SOLIDS))
        way = path(rng, rng.randint(1, 3), rng.random() < 0.8)
        compare(checks, program, f"legs {k} {solid}", SOLIDS[solid], way, along(SOLIDS[solid], way), False)
    for k in args.rounds(LEAVES, "leaves"):
        rng = args.random
        solid = rng.choice(list(SOLIDS))
        way = [(x / 4, y / 4) for x, y in path(rng, rng.randint(1, 3))]
        compare(checks, program, f"leaves {k} {solid}", SOLIDS[solid], way, unswept(SOLIDS[solid], way, complement, 50), True)


def compare(checks, program, name, solid, way, union, unsweep):
    outline = program.outline(name, solid, legs(way), unsweep=unsweep)
    if outline:
        checks.equal(outline.area(), (union.area, union.area), name, [tuple(map(str, p)) for p in way], "area")
        checks.holds("exact" in outline.record["area"], name, "a ratio", outline.record["area"])
        checks.equal(outline.numbers()[:3], numbers(union), name, [tuple(map(str, p)) for p in way], "components, of the interior, holes")


def numbers(found):
    return [found.components, found.interior_components, found.holes]


def translates(checks, program, args):
    """Convex polygons: width times length is the sum over sides of the cross product with the leg, where it is positive."""
    for k in args.rounds(CONVEX, "convex"):
        solid = convex(args.random, 9)
        (_, leg) = path(args.random, 1, False)
        sides = [(solid.vertices[u], solid.vertices[v]) for u, v in solid.edges]
        area = sum(p[0] * q[1] - p[1] * q[0] for p, q in sides) / 2
        area += sum(max(0, leg[0] * (q[1] - p[1]) - leg[1] * (q[0] - p[0])) for p, q in sides)
        outline = program.outline(f"convex {k}", solid, legs([(0, 0), leg]))
        if outline:
            checks.equal(outline.area(), (area, area), f"convex {k}", solid.text(), leg, "area")
            checks.equal(outline.numbers(), [1, 1, 0, 1], f"convex {k}", solid.text(), leg)


def loops():
    """(name, solid, motion, unsweep): paths of tips that cross themselves, in a corner of the boundary for the one that points up."""
    way = ([-2, 0, 1], [0, -2, 0, 1])  # (s² - 2, s³ - 2 s), at ±√2 in (0, 0)
    for name, (x, y) in (("up", (F(1, 8), -1)), ("down", (F(1, 8), 1)), ("wide", (1, F(-1, 2)))):
        tip = plane(ring((0, 0), (x, y), (-x, y)))
        yield f"loop {name}", tip, build([(-2, 2, translate([list(p) for p in way]))]), False
        yield f"loop {name} and back", tip, build([(-2, 2, translate([list(p) for p in way])),
                                                   (2, 6, translate([[14, -8, 1], [56, -46, 12, -1]]))]), False


def curved(checks, program, args):
    drawn = (scene(args.random, k) for k in args.rounds(CURVED, "curved"))
    for name, solid, motion, unsweep in chain(loops() if args.derived else (), drawn):
        outline = program.outline(name, solid, motion, unsweep=unsweep)
        if outline:
            found = Slices(solid, motion, unsweep)
            if differences(outline, found):
                found = Slices(solid, motion, unsweep, FINE)  # parts that no line has met
            checks.equal(differences(outline, found), [], name, motion.text(), "outline and slices")


def differences(outline, found):
    """(what, of the outline, by slices) where they differ."""
    measures = [("area", middle(outline.area()), found.area, NEAR)]
    for what, got, want in zip(("length", "length of the lower part"), (middle(outline.length()), outline.lower_length()), found.lengths()):
        measures.append((what, got, want, ROUGH))
    out = [(what, got, want) for what, got, want, most in measures if abs(got - want) > most * max(1, want)]
    if outline.numbers()[:3] != numbers(found):
        out.append(("components, of the interior, holes", outline.numbers()[:3], numbers(found)))
    return out


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    program = Program(args, checks)
    for part in (exact, translates, curved):
        part(checks, program, args)
    checks.finish()


if __name__ == "__main__":
    main()
