# suite
"""Near misses: degenerate contacts, and the same points displaced by as little as 2^-1100.

SPDX-License-Identifier: GPL-3.0-or-later

Next to a big facet the trajectory is c = y + p(t) e + q(t) n, e along the facet and n outward
transversal, so the sign of q alone says where the point is: words and times follow from q and,
displaced by d along n, from q + d. The solid is the affine image of a square or a cube of half
side 50; the trajectory keeps within 11 along the facet and 32 across, so nothing else is met. At
corners and pinches the words follow from the picture named beside each case.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from algebra import Root, add, between, compare, integral, roots, sign_at  # noqa: E402
from exact import Fraction as F  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from motion import build, compose, legs, rotation, translate  # noqa: E402
from solids import Polygon, block, box_ring, joined  # noqa: E402
from times import time_is  # noqa: E402

SIZES = (60, 200, 1100)

# q(t) on [-2, 2], the word it gives, and the words displaced outward and inward
HEIGHTS = {
    "touch from outside": ([0, 0, 3], "OBO", "O", "OBIBO"),
    "touch from inside": ([0, 0, -3], "IBI", "IBOBI", "I"),
    "crossing of order three": ([0, 0, 0, -2], "OBI", "OBI", "OBI"),
    "touch of order four": ([0, 0, 0, 0, 1], "OBO", "O", "OBIBO"),
    "touch twice at irrational times": ([4, 0, -4, 0, 1], "OBOBO", "O", "OBIBOBIBO"),
    "touch inside at irrational times": ([-4, 0, 4, 0, -1], "IBIBI", "IBOBIBOBI", "I"),
    "plain crossing": ([0, 1], "IBO", "IBO", "IBO"),
    "slide": ([0], "B", "O", "I"),
    "touch at the end": ([2, -1], "OB", "O", "OBI"),
    "crossing of order five": ([0, 0, 0, 0, 0, 1], "IBO", "IBO", "IBO"),
}


def word_of(q):
    """Word and times of a trajectory at height q over the facet."""
    if not q:
        return "B", None
    marks = roots(q, F(-2), F(2))
    stops = [Root(value=F(-2))] + marks + [Root(value=F(2))]
    word = ""
    for k, (a, b) in enumerate(zip(stops, stops[1:])):
        if compare(a, b):
            word += "O" if sign_at(q, between(a, b)) > 0 else "I"
        word += "B" if k < len(marks) else ""
    return word, marks


def frame(rng, d):
    """A random linear map; its diagonal outweighs its rows, so its det is positive."""
    return [[F(rng.randint(-2, 2), rng.randint(1, 3)) + (6 if i == j else 0) for j in range(d)]
            for i in range(d)]


def apply(m, p):
    return tuple(sum(a * x for a, x in zip(row, p)) for row in m)


def facets(graze, checks, rng, d, turning):
    """All heights over a random facet of a random image of the square or cube."""
    m = frame(rng, d)
    box = Polygon([[box_ring(-50, -50, 50, 50)]]) if d == 2 else block(-50, -50, -50, 50, 50, 50)
    solid = box.mapped(lambda p: apply(m, p))
    axis, side = rng.randrange(d), rng.choice((-1, 1))
    out = tuple(F(side * (k == axis)) for k in range(d))
    y = tuple(F(rng.randint(-9, 9), 2) if k != axis else F(50 * side) for k in range(d))
    slope = tuple(F(0) if k == axis else F(rng.randint(-3, 3)) for k in range(d))
    n, y, e = apply(m, out), apply(m, y), apply(m, slope)
    for name, (q, plain, outward, inward) in HEIGHTS.items():
        c = [path(q, y[k], n[k], e[k]) for k in range(d)]
        motion = build([(-2, 2, translate([[-x for x in p] for p in c]))])
        shifts = [(F(0), plain)] + [(s * F(1, 2 ** z), outward if s > 0 else inward)
                                    for z in SIZES for s in (1, -1)]
        points = [tuple(s * x for x in n) for s, _ in shifts]
        answers = graze.classify(f"near {d} {name}", solid, motion, points)
        for (shift, word), answer in zip(shifts, answers or []):
            where = (d, name, m, axis, side, shift)
            moved = integral(add([F(x) for x in q], [shift]))
            derived, marks = word_of(moved)
            checks.equal(derived, word, *where, "the test's own table")
            checks.equal(answer.word, word, *where)
            if marks is not None and checks.equal(len(answer.contacts), len(marks), *where):
                for contact, root in zip(answer.contacts, marks):
                    checks.holds(time_is(contact["from"], root), *where, contact["from"])
    if turning:
        turned(graze, checks, solid, n, y, e, d)


def path(q, y, n, e):
    """y + q n + t e, coordinate by coordinate."""
    out = [F(c) * n for c in q] + [F(0)] * max(0, 2 - len(q))
    out[0] += y
    out[1] += e
    return out


def turned(graze, checks, solid, n, y, e, d):
    """The solid also turns about the query point while it touches: M = R(t) after the translation,
    so the displacement is seen turned by less than 60 degrees and keeps its side of a touch. The
    middle of the facet's normal is n only for right-angled images, hence |t| <= 1/4 here."""
    c = [path([0, 0, 3], y[k], n[k], e[k]) for k in range(d)]
    axis = {"axis": [0, 0, 1], "length": 1} if d == 3 else {}
    still = translate([[-x for x in p] for p in c])
    motion = build([(F(-1, 4), F(1, 4), compose(still, rotation([0, F(1, 8)], **axis)))])
    shifts = [(F(0), "OBO")] + [(s * F(1, 2 ** z), "O" if s > 0 else "OBIBO")
                                for z in SIZES for s in (1, -1)]
    answers = graze.classify(f"near turned {d}", solid, motion,
                             [tuple(s * x for x in n) for s, _ in shifts])
    for (shift, word), answer in zip(shifts, answers or []):
        checks.equal(answer.word, word, "turned", d, shift, [str(x) for x in n])


def corners(graze, checks):
    """Corner cases in the plane and over it as prisms; each displaced along the vector named."""
    square = Polygon([[box_ring(-50, -50, 50, 50)]])
    pinch = Polygon([[box_ring(-50, -50, 0, 0)], [box_ring(0, 0, 50, 50)]])
    cases = [
        # past a corner: outward none, inward a crossing pair
        ("past a corner", square, [(51, 49), (49, 51)], (1, 1), "OBO", "O", "OBIBO"),
        # straight in at a corner: crossed a little beside it, either way
        ("in at a corner", square, [(51, 51), (49, 49)], (1, -1), "OBI", "OBI", "OBI"),
        # from part to part through the pinch: beside it a gap opens
        ("through a pinch", pinch, [(1, 1), (-1, -1)], (1, -1), "IBI", "IBOBI", "IBOBI"),
        # across the pinch from gap to gap: beside it one part is crossed
        ("across a pinch", pinch, [(1, -1), (-1, 1)], (1, 1), "OBO", "OBIBO", "OBIBO"),
        # along an edge and past its end
        ("along an edge", square, [(40, 50), (60, 50)], (0, 1), "BO", "O", "IBO"),
    ]
    for name, polygon, (start, end), way, plain, plus, minus in cases:
        for d in (2, 3):
            lift = [] if d == 2 else [0]
            solid = polygon
            if d == 3:
                parts = [part[0] for part in polygon.parts]
                boxes = [block(*r[0], -50, *r[2], 50) for r in parts]
                solid = joined(*boxes)
            path = [tuple(-x for x in p) + tuple(lift) for p in (start, end)]
            shifts = [(F(0), plain)] + [(s * F(1, 2 ** z), plus if s > 0 else minus)
                                        for z in SIZES for s in (1, -1)]
            points = [tuple(s * x for x in way) + tuple(lift) for s, _ in shifts]
            answers = graze.classify(f"near {name} {d}", solid, legs(path), points)
            for (shift, word), answer in zip(shifts, answers or []):
                checks.equal(answer.word, word, name, d, shift)


def stretched(q, e):
    """q(2^e t)"""
    return [F(c) * 2 ** (e * k) for k, c in enumerate(q)]


def uneven(graze, checks):
    """Two edges met nearly at one time, one of them by a polynomial on which secants are of no use
    for e halvings. With a = 2^k, u = 2^e t and k > e, slow = u^4 - 1 - 1/a changes its sign once in
    [0, 1], at u < 1 + 1/(4 a), quick = u - 1 - u^2/a once, at u = 1 + u^2/a > 1 + 1/a. The trajectory
    (x, -y) is in the quarter plane from the root of x to that of y, if that is the later one; in
    space it crosses a block, or slides on its bottom."""
    for k, e in ((60, 20), (199, 50), (1000, 20), (1000, 100)):
        slow = stretched([-1 - F(1, 2 ** k), 0, 0, 0, 1], e)
        quick = stretched([-1, 1, -F(1, 2 ** k)], e)
        far = 2 ** (4 * e + 1)
        square, box = Polygon([[box_ring(0, 0, far, far)]]), block(0, 0, 0, far, far, 2)
        for x, y, met in ((slow, quick, True), (quick, slow, False)):
            for solid, lift, word in ((square, [], "OBIBO"), (box, [[F(1)]], "OBIBO"), (box, [[F(0)]], "OBO")):
                path = [x, [-c for c in y]] + lift
                axis = {"axis": [0, 0, 1], "length": 1} if lift else {}
                there, back = (translate([[s * c for c in p] for p in path]) for s in (1, -1))
                turn = rotation([0, F(1, 3)], **axis)
                # The point 0 is taken to the path; a turn about it does not move it.
                for motion, flags in ((back, []), (there, ["--operation", "unsweep"]),
                                      (compose(back, turn), []), (compose(turn, there), ["--operation", "unsweep"])):
                    for tier in ([], ["--no-filter"]):
                        run_uneven(graze, checks, solid, build([(0, 1, motion)]), flags + tier,
                                   word if met else "O", (x, y), (k, e, len(lift), met))


def run_uneven(graze, checks, solid, motion, flags, word, edges, where):
    """One run: the word, and that the contacts begin and end where the edges are met."""
    origin = [(F(0),) * motion.dimension]
    answers = graze.classify("uneven", solid, motion, origin, *flags)
    for answer in answers or []:
        checks.equal(answer.word, word, *where, flags)
        ends = [contact[end] for contact in answer.contacts for end in ("from", "to")]
        for time, q in zip((ends[0], ends[-1]) if ends else (), edges):
            (root,) = roots(integral(q), F(0), F(1))
            checks.holds(time_is(time, root), *where, flags, time)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    if args.derived:
        corners(graze, checks)
        uneven(graze, checks)
    for _, d in args.cycle((2, 3), 3):
        facets(graze, checks, args.random, d, True)
    checks.finish()


if __name__ == "__main__":
    main()
