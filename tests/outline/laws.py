# suite
"""`graze outline` against `graze classify` and itself: winding numbers, reversal, other parameters, affine images, complements.

SPDX-License-Identifier: GPL-3.0-or-later

The rings have the winding number 1 about the points of the set's interior and 0 elsewhere: a random point, in or out by
`classify`, is counted by the crossings of its row, but where it is within 1e-9 of one. One set has one outline: a motion run
backwards, at another speed, cut, or there and back has the same; an affine image of solid and motion has the image; a sweep
is what the unsweep of its complement by the inverse motion leaves.
"""
import json
from bisect import bisect

from byhand import SCENES, box
from drawn import scene

from motion import Motion, conjugated, cut, mobius, reparametrised, reversed_in_time, squared
from outlines import Checks, F, Program, middle, off, options, places, to_double
from refine import bounds, complement

ROWS, COLUMNS = 12, 25    # points of a scene
ROUNDS, LAWS = 60, 24     # scenes at scale 1
NEAR = 1e-9
MAPS = {"turned": [[0, -1, 3], [1, 0, -2]], "sheared": [[1, F(1, 2), 0], [0, 1, 1]], "mirrored": [[-2, 0, 1], [0, F(3, 2), 0]]}


# ----------------------------------------------------------------------------------- winding numbers

def winding(checks, program, args, name, solid, motion, unsweep):
    """The scene's outline."""
    outline = program.outline(name, solid, motion, unsweep=unsweep)
    if not outline:
        return None
    sources(checks, program, name, solid, motion, unsweep, outline)
    (x0, x1), (y0, y1) = frame(outline, solid)
    rows = [y0 + (y1 - y0) * F(args.random.randint(1, 10 ** 6), 10 ** 6 + 3) for _ in range(ROWS)]
    points = [(x0 + (x1 - x0) * F(args.random.randint(1, 10 ** 6), 10 ** 6 + 3), y) for y in rows for _ in range(COLUMNS)]
    words = program.pmc(name, solid, motion, points, unsweep)
    if not words:
        return outline
    width, crossings = to_double(x1 - x0), {y: outline.row(to_double(y)) for y in rows}
    for (x, y), word in zip(points, words):
        at, row = to_double(x), crossings[y]
        k = bisect(row, (at,))
        if any(abs(row[j][0] - at) < NEAR * width for j in (k - 1, k) if 0 <= j < len(row)) or word == "on":
            continue
        checks.equal(sum(step for _, step in row[k:]), 1 if word == "in" else 0, name, motion.text(), (str(x), str(y)), word, "winding number")
    return outline


def sources(checks, program, name, solid, motion, unsweep, outline):
    """Each source of an arc ends where the arc does; each sample is on the side that it says."""
    size = max([1.0] + [abs(c) for p in outline.places for c in p])
    for arc in outline.arcs:
        ends = [outline.places[arc[end]] for end in ("from", "to")]
        for source in arc["sources"]:
            there = places(source, solid, motion, unsweep)
            gap = min(max(off(p, q) for p, q in zip(there, order)) for order in (ends, ends[::-1]))
            checks.holds(gap < NEAR * size, name, motion.text(), "ends of a source", source, there, ends)
    samples = [tuple(F(x) for x in arc["sample"][side]) for arc in outline.arcs for side in ("in", "out")]
    words = program.pmc(name + " samples", solid, motion, samples, unsweep) if samples else []
    checks.equal(words, ["in", "out"] * len(outline.arcs), name, motion.text(), "samples")


def frame(outline, solid):
    """A box somewhat larger than the set's, or the solid's if it is empty."""
    places = [[F(c) for c in p] for p in outline.places] or solid.vertices
    out = []
    for low, high in [(min(c), max(c)) for c in zip(*places)]:
        margin = (high - low) / 3 + F(1, 7)
        out.append((low - margin, high + margin))
    return out


def windings(checks, program, args):
    if args.derived:
        for one in SCENES:
            args.random.seed(one.name)
            winding(checks, program, args, one.name, one.solid, one.motion, one.unsweep)
    for k in args.rounds(ROUNDS, "windings"):
        name, solid, motion, unsweep = scene(args.random, k)
        winding(checks, program, args, name, solid, motion, unsweep)


# ---------------------------------------------------------------------------------------------- laws

def same(checks, one, other, where, factor=1):
    """Do two outlines of one set, or of an affine image, agree? A factor of None: lengths change too, by no one factor."""
    scale = F(1) if factor is None else factor
    checks.equal(other.numbers(), one.numbers(), *where, "components, of the interior, holes, Euler")
    (low, high), (a, b) = one.area(), other.area()
    if low == high and a == b and "exact" in one.record["area"] and "exact" in other.record["area"]:
        checks.equal(a, low * scale, *where, "area")
    wanted = middle((low, high)) * to_double(scale)
    checks.holds(abs(middle((a, b)) - wanted) <= 4e-12 * max(1, abs(wanted)), *where, "area", middle((a, b)), wanted)
    checks.equal(len(other.lower["points"]), len(one.lower["points"]), *where, "isolated lower points")


def alike(checks, one, other, where):
    """Do two outlines of one set agree, in lengths and lower parts too?"""
    same(checks, one, other, where)
    lengths = middle(one.length()), middle(other.length())
    checks.holds(abs(lengths[0] - lengths[1]) <= 4e-12 * max(1, *lengths), *where, "length", *lengths)
    lower = one.lower_length(), other.lower_length()
    checks.holds(abs(lower[0] - lower[1]) <= 1e-7 * max(1, *lower), *where, "length of the lower part", *lower)


def there_and_back(motion):
    """The motion, then reversed, shifted to begin where the first ends."""
    back = reversed_in_time(motion)
    shift = motion.end - back.start
    den = shift.denominator
    changes = [(p.lo + shift, p.hi + shift, [int(-shift * den), int(den)], [int(den)]) for p in back.pieces]
    return Motion(motion.pieces + reparametrised(back, changes).pieces)


def others(motion):
    """Motions that pass the same positions."""
    yield "backwards", reversed_in_time(motion)
    yield "at another speed", mobius(motion)[0]
    yield "squared", squared(motion)[0]
    yield "cut", cut(motion, [p.lo + (p.hi - p.lo) * F(2, 7) for p in motion.pieces])
    yield "there and back", there_and_back(motion)


def image(rows):
    def point(p):
        return tuple(F(r[0]) * p[0] + F(r[1]) * p[1] + F(r[2]) for r in rows)
    (a, b, e), (c, d, f) = [[F(x) for x in r] for r in rows]
    det = a * d - b * c
    inverse = [[d / det, -b / det, (b * f - d * e) / det], [-c / det, a / det, (c * e - a * f) / det]]
    return point, inverse, abs(det)


def dual(checks, program, name, solid, motion, outline):
    """The box that stays in a large one, without the unsweep of the complement, is the sweep."""
    far = 20 + 8 * max(abs(x) for p in [solid.vertices, [[F(c) for c in p] for p in outline.places]] for q in p for x in q)
    still = {"dimension": 2, "pieces": [{"t": [str(motion.start), str(motion.end)], "transform": {"translate": ["0", "0"]}}]}
    inverse = json.dumps({"dimension": 2, "relative": {"moving": still, "frame": motion.document}})
    free = program.outline(name + " dual", complement(solid, far)[0], inverse, unsweep=True)
    all_of_it = program.outline(name + " box", box(-far, -far, far, far), inverse, unsweep=True)
    if free and all_of_it:
        area = middle(all_of_it.area()) - middle(free.area())
        checks.holds(abs(area - middle(outline.area())) <= 1e-11 * middle(all_of_it.area()), name, "area by the dual", area, middle(outline.area()))
        checks.equal([free.interior_components, free.holes], [outline.holes + 1, outline.interior_components], name,
                     "components of the dual's interior and its holes")
        lower = free.lower_length(), outline.lower_length()
        checks.holds(abs(lower[0] - lower[1]) <= 1e-7 * max(1, *lower), name, "the dual's lower part", *lower)
        checks.equal(len(free.lower["points"]), len(outline.lower["points"]), name, "the dual's lower points")


def laws(checks, program, args):
    for k in args.rounds(LAWS, "laws"):
        name, solid, motion, unsweep = scene(args.random, k)
        outline = program.outline(name, solid, motion, unsweep=unsweep)
        if not outline:
            continue
        for what, other in others(motion):
            found = program.outline(f"{name} {what}", solid, other, unsweep=unsweep)
            if found:
                alike(checks, outline, found, (name, what, motion.text()))
        what = list(MAPS)[k % len(MAPS)]
        point, inverse, det = image(MAPS[what])
        found = program.outline(f"{name} {what}", solid.mapped(point), conjugated(motion, [[F(x) for x in r] for r in MAPS[what]], inverse),
                                unsweep=unsweep)
        if found:
            same(checks, outline, found, (name, what, motion.text()), det)
        if not unsweep:
            dual(checks, program, name, solid, motion, outline)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    program = Program(args, checks)
    windings(checks, program, args)
    laws(checks, program, args)
    checks.finish()


if __name__ == "__main__":
    main()
