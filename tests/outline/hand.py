# suite
"""`graze outline` on scenes whose outline is derived by hand: area, components, holes, length, seams.

SPDX-License-Identifier: GPL-3.0-or-later

The scenes and their derivations stand in byhand.py.
"""
from outlines import Checks, F, Program, enclosure, middle, options, to_double, within
from byhand import SCENES

WIDTH = "1e-12"


def linear(motion):
    """Are all pieces translations that are linear in time? Their area is a ratio."""
    return all(len(p.w) == 1 and all(len(e) <= 1 for row in p.a for e in row) and all(len(b) <= 2 for b in p.b) for p in motion.pieces)


def numbers(checks, outline, scene):
    want = [scene.components, scene.interior, scene.holes, scene.components - scene.holes]
    checks.equal(outline.numbers(), want, scene.name, "components, of the interior, holes, Euler")
    outer = [r for r in outline.rings if not r["hole"]]
    checks.equal(len(outer), scene.interior, scene.name, "rings that are no holes")


def measures(checks, outline, scene):
    area, name = outline.area(), scene.name
    if linear(scene.motion):
        checks.holds("exact" in outline.record["area"], name, "a ratio is an area to be given as such", outline.record["area"])
    checks.holds(within(scene.area, area, WIDTH), name, "area", outline.record["area"], "expected", scene.area)
    total = sum(middle(enclosure(r["area"])) for r in outline.rings)
    checks.holds(abs(total - middle(area)) <= 1e-9 * max(1, abs(total)), name, "areas of rings", total, middle(area))
    if scene.length is not None:
        checks.holds(within(scene.length, outline.length(), WIDTH), name, "length", outline.record["length"], "expected", scene.length)
    curves = sum(c.length() for c in outline.curves)
    checks.holds(abs(curves - middle(outline.length())) <= 1e-5 * max(1, curves), name, "lengths of arcs", curves, outline.record["length"])


def lower(checks, outline, scene):
    if scene.lower is None:
        return
    length, found = float(scene.lower), outline.lower_length()
    checks.holds(abs(found - length) <= 1e-8 * max(1, length), scene.name, "length of the lower part", found, "expected", length)
    checks.equal(len(outline.lower["points"]), scene.points, scene.name, "isolated lower points")
    checks.equal(outline.lower["undecided"], 0, scene.name, "undecided")


def walks(checks, outline, scene):
    """Each ring is closed, its arcs are its own, and its area has its sign."""
    seen = [k for r in outline.rings for k in r["arcs"]]
    checks.equal(sorted(seen), list(range(len(outline.arcs))), scene.name, "each arc is in one ring")
    for r in outline.rings:
        arcs = [outline.arcs[k] for k in r["arcs"]]
        checks.holds(all(a["to"] == b["from"] for a, b in zip(arcs, arcs[1:] + arcs[:1])), scene.name, "a ring is closed", r["arcs"])
        places = [a["from"] for a in arcs]
        checks.equal(len(set(places)), len(places), scene.name, "a ring is simple")
        area = enclosure(r["area"])
        checks.holds(area[1] < 0 if r["hole"] else area[0] > 0, scene.name, "sign of a ring's area", r["hole"], r["area"])


def nesting(checks, outline, scene):
    """A hole is within the least outer ring around the set beside it."""
    for r in outline.rings:
        if not r["hole"]:
            checks.equal(r["within"], None, scene.name, "an outer ring is within nothing")
            continue
        x, y = (to_double(F(c)) for c in outline.arcs[r["arcs"][0]]["sample"]["in"])
        around = [k for k, other in enumerate(outline.rings) if not other["hole"] and encloses(outline, other, x, y)]
        least = min(around, key=lambda k: middle(enclosure(outline.rings[k]["area"])), default=None)
        checks.equal(r["within"], least, scene.name, "the ring around a hole")


def encloses(outline, ring, x, y):
    return sum(step for k in ring["arcs"] for at, step in outline.curves[k].crossings(y) if at > x) != 0


def main():
    args = options(__doc__.splitlines()[0], ("--only", {"default": "", "help": "scenes whose name contains this text"}))
    checks = Checks()
    program = Program(args, checks)
    for scene in SCENES:
        if args.only in scene.name:
            outline = program.outline(scene.name, scene.solid, scene.motion, unsweep=scene.unsweep)
            if outline:
                for check in (numbers, measures, lower, walks, nesting):
                    check(checks, outline, scene)
    checks.holds(len(SCENES) >= 40, "scenes", len(SCENES))
    checks.finish()


if __name__ == "__main__":
    main()
