# suite
"""Ilies & Shapiro's equations as properties of answers, over random scenes.

SPDX-License-Identifier: GPL-3.0-or-later

Solids are unions of grid cells (cells.py), so unions, intersections, complements and membership of
a point in S are exact and need no program. Each equation is tested with the hypotheses it needs:
20, 27 and 34 need the identity in M; 28 needs parts that do not touch; 25 holds for the plain
intersection, for the regularised one only towards `in`; 30 and 31 are false as printed and are
tested as unsweep(S, M1) ∩ M1(a1)^-1 unsweep(S, M2) ∩ ..., their counterexample is kept. A set's
points are those that are not `out`, the points of its interior those that are `in`.
"""
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import refine  # noqa: E402
from cells import block, random_cells, sharing, shifted, solid_of, state, touch  # noqa: E402
from exact import Fraction as F  # noqa: E402
from program import Checks, Graze, exchanged, merged, options  # noqa: E402
from motion import Motion, build, compose, conjugated, legs, rotation, scaling  # noqa: E402
from motion import translate  # noqa: E402

SCENES = 14
POINTS = 16
UNSWEEP = ("--operation", "unsweep")


def small(rng, least=-6, most=6):
    return F(rng.randint(least, most), 4)


def random_motion(rng, d):
    """A small motion on [0, 1] that starts at the identity."""
    center = [F(rng.randint(1, 3)) for _ in range(d)]
    axis = {} if d == 2 else {"axis": rng.choice([[0, 0, 1], [1, 2, 2], [2, -1, 2]])}
    if axis:
        axis["length"] = 1 if axis["axis"] == [0, 0, 1] else 3
    turning = rotation([0, rng.choice([F(1, 4), F(1, 2), -1, 1])], center=center, **axis)
    moving = translate([[0, small(rng), small(rng)] for _ in range(d)])
    kind = rng.randrange(5)
    if kind == 0:
        stops = [[small(rng) for _ in range(d)] for _ in range(2)]
        return legs([[F(0)] * d, *stops], [F(0), F(1, 3), F(1)])
    if kind == 4:
        moving = scaling([[1, F(rng.randint(-2, 4), 4)] for _ in range(d)], center=center)
    return build([(0, 1, {1: moving, 2: turning, 3: compose(turning, moving), 4: moving}[kind])])


def still(d):
    return {"dimension": d, "pieces": [
        {"t": ["0", "1"], "transform": {"translate": ["0"] * d}}]}


def inverse(motion):
    """M^ as the motion of a standing frame seen from M."""
    d = motion.dimension
    return Motion(motion.pieces, {"dimension": d, "relative": {
        "moving": still(d), "frame": motion.document}})


def in_sequence(motions):
    return Motion(motions[0].pieces, {"dimension": motions[0].dimension,
                                      "sequence": [m.document for m in motions]})


def lattice(rng, cells):
    """A half-integer point of a cell's boundary or middle."""
    return tuple(x + F(rng.randint(0, 2), 2) for x in rng.choice(sorted(cells)))


def query_points(rng, cells, motion):
    """Some at random; some whose trajectory meets a half-integer point at a rational time."""
    d, out = motion.dimension, []
    for _ in range(POINTS // 2):
        out.append(tuple(F(rng.randint(-4, 26 if d == 2 else 18), 4) for _ in range(d)))
        out.append(motion.back(lattice(rng, cells), F(rng.randint(0, 4), 4)))
    return out


class Scene:
    def __init__(self, graze, checks, rng, d, number):
        self.graze, self.checks, self.rng, self.d = graze, checks, rng, d
        self.name = f"scene {number}"
        self.cells, self.motion = random_cells(rng, d), random_motion(rng, d)
        self.points = query_points(rng, self.cells, self.motion)
        self.base = self.words("base", self.cells, self.motion, self.points)
        self.answers = [member(w) for w in self.base]

    def words(self, what, cells, motion, points, *flags):
        """The words for the points, `cells` being a set of cells or a solid."""
        solid = solid_of(cells) if isinstance(cells, set) else cells
        answers = self.graze.classify(f"{self.name} {what}", solid, motion, points,
                                      *(flags or UNSWEEP))
        if answers is None:
            raise SystemError(f"{self.name} {what}: no answers")
        for a, p in zip(answers, points):
            pmc = swept(a.word) if flags else member(a.word)
            self.checks.equal(a.record["pmc"], pmc, self.name, what, text(p), "pmc of", a.word)
        return [a.word for a in answers]

    def unswept(self, what, cells, motion, points):
        return [member(w) for w in self.words(what, cells, motion, points)]

    def swept(self, what, cells, motion, points):
        return [swept(w) for w in self.words(what, cells, motion, points, "--operation", "sweep")]

    def each(self, what, claims, points=None):
        """`claims`: one (holds, operands) per point."""
        for p, (holds, operands) in zip(points or self.points, claims):
            self.checks.holds(holds, self.name, what, text(p), operands)


def text(point):
    return ",".join(str(x) for x in point)


def member(word):
    """[IS] eq. 35."""
    return "in" if word == "I" else "out" if "O" in word else "on"


def swept(word):
    """The open sweep, from the word of the inverted trajectory."""
    return "in" if "I" in word else "on" if "B" in word else "out"


def place(cells, point):
    return {"I": "in", "B": "on", "O": "out"}[state(cells, point)]


def least(answers):
    """Membership in an intersection: in both interiors, or in both sets."""
    return max(answers, key=["in", "on", "out"].index)


def most(answers):
    return min(answers, key=["in", "on", "out"].index)


def within(small_one, large_one):
    """Subset: of the sets, and then of their interiors."""
    return least([small_one, large_one]) == small_one


def eq19(s):
    """[sweep(S, M)]^c = unsweep(S^c, M^), also with sweep and unsweep exchanged."""
    rest = refine.complement(solid_of(s.cells), 10 ** 4)[0]
    swept_words = s.words("19 sweep", s.cells, s.motion, s.points, "--operation", "sweep")
    dual = s.words("19", rest, inverse(s.motion), s.points)
    other = s.words("19 back", rest, inverse(s.motion), s.points, "--operation", "sweep")
    s.each("19", [(a == exchanged(b), (a, b)) for a, b in zip(swept_words, dual)])
    s.each("19 back", [(a == exchanged(b), (a, b)) for a, b in zip(s.base, other)])


def eq20(s):
    """unsweep(S, M) ⊂ S ⊂ sweep(S, M)."""
    outer = s.swept("20", s.cells, s.motion, s.points)
    places = [place(s.cells, p) for p in s.points]
    s.each("20", [(within(a, b) and within(b, c), (a, b, c))
                  for a, b, c in zip(s.answers, places, outer)])


def eq24_points(s):
    """sweep[unsweep(S, M), M] ⊂ S ⊂ unsweep[sweep(S, M), M], point by point: M(t) P for P in
    unsweep(S, M) is in S, and for P in S it is in sweep(S, M)."""
    times = [F(s.rng.randint(0, 12), 12) for _ in s.points]
    moved = [s.motion.map(p, t) for p, t in zip(s.points, times)]
    s.each("24, left", [(within(a, place(s.cells, q)), (a, q))
                        for a, q in zip(s.answers, moved)])
    outer = s.swept("24", s.cells, s.motion, moved)
    s.each("24, right", [(within(place(s.cells, p), b), (text(q), b))
                         for p, q, b in zip(s.points, moved, outer)])


def eq24_solids(s):
    """Equation 24 with the unswept and the swept solid, which an axis-parallel translation by whole
    cells keeps made of cells. The regularised unsweep may lose points; its sweep is in S even so.
    """
    k, axis = s.rng.randint(1, 3), s.rng.randrange(s.d)
    motion = build([(0, 1, translate([[0, k] if a == axis else [0] for a in range(s.d)]))])
    steps = [shifted(s.cells, [j * (a == axis) for a in range(s.d)]) for j in range(k + 1)]
    back = [shifted(s.cells, [-j * (a == axis) for a in range(s.d)]) for j in range(k + 1)]
    points = query_points(s.rng, s.cells, motion)
    inner, outer = set.intersection(*back), set.union(*steps)
    s.each("24, swept cells", [(a == place(outer, p) or (a, place(outer, p)) == ("on", "in"), a)
                               for a, p in zip(s.swept("24 W", s.cells, motion, points), points)],
           points)
    if inner:
        answers = s.swept("24 inner", inner, motion, points)
        s.each("24, inner solid", [(within(a, place(s.cells, p)), a)
                                   for a, p in zip(answers, points)], points)
    answers = s.unswept("24 outer", outer, motion, points)
    s.each("24, outer solid", [(within(place(s.cells, p), a), a)
                               for a, p in zip(answers, points)], points)


def eq25(s):
    """unsweep(S1 ∩ S2, M) = unsweep(S1, M) ∩ unsweep(S2, M)."""
    pair = sharing(s.rng, s.cells, 24 if s.d == 2 else 6)
    answers = [s.unswept(f"25 S{k}", c, s.motion, s.points) for k, c in enumerate(pair)]
    s.each("25", [(least([a, b]) == c, (a, b, c)) for a, b, c in zip(*answers, s.answers)])


def eq25_regularised(s):
    """The regularised intersection has the same interior, and its unsweep may be smaller."""
    other = random_cells(s.rng, s.d)
    if not s.cells & other:
        return
    apart = [least(pair) for pair in zip(s.answers, s.unswept("25 R", other, s.motion, s.points))]
    joint = s.unswept("25 regularised", s.cells & other, s.motion, s.points)
    s.each("25 regularised", [(within(a, b) and (a == "in") == (b == "in"), (a, b))
                              for a, b in zip(joint, apart)])


def eq25_blocks(s):
    """Equation 25 for two blocks that overlap."""
    first = block((0,) * s.d, (4,) * s.d)
    second = block((1,) * s.d, (6,) * (s.d - 1) + (3,))
    answers = [s.unswept(f"25 block {k}", c, s.motion, s.points)
               for k, c in enumerate((first, second, first & second))]
    s.each("25 blocks", [(least([a, b]) == c, (a, b, c)) for a, b, c in zip(*answers)])


def eq27(s):
    """S ⊃ unsweep(S, M) ⊃ ∪ unsweep(S_i, M)."""
    parts = [{c for c in s.cells if s.rng.random() < 0.7} for _ in range(2)]
    if not all(parts):
        return
    whole = parts[0] | parts[1]
    joint = s.unswept("27", whole, s.motion, s.points)
    apart = zip(*(s.unswept(f"27 S{k}", p, s.motion, s.points) for k, p in enumerate(parts)))
    s.each("27", [(within(most(a), b) and within(b, place(whole, p)), (a, b))
                  for a, b, p in zip(apart, joint, s.points)])


def eq28(s):
    """unsweep(S, M) = ∪ unsweep(S_i, M) for parts that do not touch."""
    other = shifted(random_cells(s.rng, s.d), (7,) + (0,) * (s.d - 1))
    s.checks.holds(not touch(s.cells, other), s.name, "28", "parts must not touch")
    points = s.points + query_points(s.rng, other, s.motion)
    joint = s.words("28", s.cells | other, s.motion, points)
    first = s.words("28 S1", s.cells, s.motion, points)
    second = s.words("28 S2", other, s.motion, points)
    s.each("28", [(member(a) == most([member(b), member(c)]), (a, b, c))
                  for a, b, c in zip(joint, first, second)], points)


def eq30(s):
    """unsweep(S, M2[M1]) = unsweep(S, M1) ∩ M1(a1)^-1 unsweep(S, M2), and 31 with a third."""
    motions = [s.motion] + [random_motion(s.rng, s.d) for _ in range(2)]
    moved, words = [s.points], [s.base]
    for k, (before, motion) in enumerate(zip(motions, motions[1:])):
        moved.append([before.map(p, before.end) for p in moved[-1]])
        words.append(s.words(f"30 M{k + 2}", s.cells, motion, moved[-1]))
    for n in (2, 3):
        whole = s.words(f"30 {n}", s.cells, in_sequence(motions[:n]), s.points)
        parts = list(zip(*words[:n]))
        s.each(f"30 of {n}", [(member(a) == least([member(b) for b in bs]), (a, bs))
                              for a, bs in zip(whole, parts)])
        s.each(f"30 of {n}, words", [(a == merged("".join(bs)), (a, bs))
                                     for a, bs in zip(whole, parts)])


MAPS = {
    2: [([[1, F(1, 2), 3], [F(-1, 3), 1, -2]], False), ([[0, 2, 1], [1, F(1, 4), 0]], True)],
    3: [([[1, F(1, 2), 0, 3], [F(-1, 3), 1, 0, -2], [0, F(1, 5), 2, 1]], False),
        ([[0, 1, 0, 1], [1, 0, F(1, 4), 0], [0, 0, 1, F(-2, 3)]], True)],
}


def inverse_map(rows):
    """T^-1 of an affine map, by Cramer's rule."""
    n = len(rows)

    def det(m):
        return m[0][0] if len(m) == 1 else sum(
            (-1) ** k * m[0][k] * det([r[:k] + r[k + 1:] for r in m[1:]]) for k in range(len(m)))
    a = [[F(x) for x in row[:n]] for row in rows]
    out = [[(-1) ** (i + j) * det([r[:i] + r[i + 1:] for k, r in enumerate(a) if k != j]) / det(a)
            for j in range(n)] for i in range(n)]
    return [row + [-sum(x * F(r[n]) for x, r in zip(row, rows))] for row in out]


def apply(rows, p):
    return tuple(sum(F(r[j]) * x for j, x in enumerate(p)) + r[-1] for r in rows)


def eq32(s):
    """T unsweep(S, M) = unsweep(T S, T M T^-1); 33: unsweep(T S, M) = T unsweep(S, T^-1 M T)."""
    for rows, mirrored in MAPS[s.d]:
        back, solid = inverse_map(rows), solid_of(s.cells)
        moved = [apply(rows, p) for p in s.points]
        s.checks.equal([apply(back, p) for p in moved], [tuple(p) for p in s.points], "T^-1 T")
        image = (solid.mapped(lambda p: apply(rows, p), mirrored) if s.d == 3
                 else solid.mapped(lambda p: apply(rows, p)))
        got = s.words("32", image, conjugated(s.motion, rows, back), moved)
        s.each("32", [(a == b, (a, b)) for a, b in zip(got, s.base)])
        left = s.words("33 left", image, s.motion, moved)
        right = s.words("33 right", s.cells, conjugated(s.motion, back, rows), s.points)
        s.each("33", [(a == b, (a, b)) for a, b in zip(left, right)])


def eq34(s):
    """S ⊃ ∪ unsweep(S, M_i) ⊃ ∩ unsweep(S, M_i)."""
    motions = [random_motion(s.rng, s.d) for _ in range(2)]
    answers = [s.answers] + [s.unswept(f"34 M{k}", s.cells, m, s.points)
                             for k, m in enumerate(motions)]
    s.each("34", [(within(most(a), place(s.cells, p)) and within(least(a), most(a)), a)
                  for a, p in zip(zip(*answers), s.points)])


def printed_30(graze, checks, d):
    """Equation 30 as printed against the truth, S = [0, 10], M1 = +3, M2 = -3: unsweep(S, M1) is
    [0, 7], moved [3, 10]; what M2 leaves of this is [6, 10], moved back [3, 7]. But every point of
    [0, 7] stays in S by the sequence. The other coordinates stand still in (0, 1)."""
    def run(low, high, steps, xs):
        motions = [build([(0, 1, translate([[0, k]] + [[0]] * (d - 1)))]) for k in steps]
        motion = in_sequence(motions) if len(motions) > 1 else motions[0]
        cells = block((low,) + (0,) * (d - 1), (high,) + (1,) * (d - 1))
        answers = graze.classify(f"printed {d} {low} {steps}", solid_of(cells), motion,
                                 [(x,) + (F(1, 2),) * (d - 1) for x in xs], *UNSWEEP)
        return [a.record["pmc"] for a in answers or []]

    def interval(low, high, xs):
        return ["on" if x in (low, high) else "in" if low < x < high else "out" for x in xs]
    xs = [F(k, 4) for k in range(-4, 48)]
    checks.equal(run(0, 10, [3], xs), interval(0, 7, xs), "30 printed", d, "M1")
    truth = run(0, 10, [3, -3], xs)
    checks.equal(truth, interval(0, 7, xs), "30 printed", d, "sequence")
    printed = run(3, 10, [-3], [x + 3 for x in xs])
    checks.equal(printed, interval(3, 7, xs), "30 printed", d, "right side")
    checks.holds(truth != printed, "30 printed", d, "the two sides must differ")


EQUATIONS = [eq19, eq20, eq24_points, eq24_solids, eq25, eq25_regularised, eq25_blocks, eq27, eq28,
             eq30, eq32, eq34]


def main():
    args = options(__doc__.splitlines()[0])
    checks, seen = Checks(), Counter()
    graze = Graze(args, checks)
    for d in (2, 3) if args.derived else ():
        printed_30(graze, checks, d)
    for number, d in args.cycle((2, 3), SCENES // 2):
        try:
            s = Scene(graze, checks, args.random, d, number)
            for equation in EQUATIONS:
                equation(s)
        except SystemError as wrong:
            print(wrong)
            continue
        seen.update(s.answers)
    print(f"{graze.runs} runs; base answers {dict(seen)}")
    for pmc in ("in", "on", "out"):
        checks.holds(20 * seen[pmc] >= sum(seen.values()), "each answer in 5 % of the points", pmc)
    checks.finish()


if __name__ == "__main__":
    main()
