# suite
"""Laws of clearance: the same pair with another R, exchanged, reversed, cut, at other speeds, with radii split otherwise.

SPDX-License-Identifier: GPL-3.0-or-later

If R1 < R2, then where the distance is at most R1 it is below R2: letters I and B of R1 are I of R2 at the same times; without a clearance too. Distances
are the same if time runs back, if the motion is cut, and at other speeds. Motions that are rigid have inverses that keep distances, and
a motion of both keeps them. A ball is a point with a radius: R may go from one to the other, as times are the same.
No law trusts the program: all compare one run of it with another one along a different path.
"""
from collections import Counter

from laws import Law, followed, inverse, law_cut, law_exchanged, law_parameter, law_reversed
from pairs import Checks, Collide, larger, options, together, trace_of
from exact import Fraction as F
from placed import placed
from round import ball

from algebra import add, mul  # noqa: E402
from motion import build, rotation  # noqa: E402

PAIRS = {2: 12, 3: 6}
MOST = 16      # vertices of a solid in space
RADII = [F(1, 2 ** 60), F(1, 8), F(1, 3), F(1), F(2), F(7, 2), F(20)]
FRAME = {2: {}, 3: {"axis": [2, 1, 2], "length": 3}}


class Near(Law):
    """All questions of a law have the clearance."""

    def __init__(self, collide, rng, name, pair, radius):
        self.radius = radius
        super().__init__(collide, None, rng, name, *pair)

    def ask(self, law, moving, motion, fixed, *flags, **more):
        return super().ask(law, moving, motion, fixed, "--clearance", str(self.radius), *flags, **more)


def is_rigid(motion):
    """Are the rows of each piece's matrix, over its weight, of length 1 and at right angles?"""
    for p in motion.pieces:
        for i, row in enumerate(p.a):
            for j, other in enumerate(p.a):
                product, square = [], mul(p.w, p.w) if i == j else []
                for x, y in zip(row, other):
                    product = add(product, mul(x, y))
                if any(add(product, [-c for c in square])):
                    return False
    return True


def law_nearer(law):
    """A greater clearance, a smaller one, and none: at most R1 is below R2."""
    start, end = law.motion.start, law.motion.end
    traces = []
    for radius in sorted({F(0), *law.rng.sample(RADII, 2), law.radius}):
        answer = law.collide.ask(f"{law.name} at {radius}", law.moving.whole, law.motion, law.fixed.whole, "--clearance", str(radius))
        if answer is None:
            return
        traces.append(trace_of(answer, start, end))
    for one, other in zip(traces, traces[1:]):
        both = together(one, other, lambda a, b: a + b)
        law.checks.holds(not {"IB", "IO", "BB", "BO"} & set(both.at + both.between), law.name, "nearer", one.word(), other.word())


def law_moved_frame(law):
    more = build([(law.motion.start, law.motion.end, rotation([F(1, 3), F(1, 5)], **FRAME[law.motion.dimension]))])
    law.same("frame", law.ask("frame", law.moving.whole, followed(law.motion, more), law.fixed.whole, motion_of_fixed=more))


def law_split(law):
    """A ball of radius r at R is one of radius r + R / 2 at R / 2."""
    center = tuple(F(law.rng.randint(-8, 8), 4) for _ in range(law.motion.dimension))
    radius = F(law.rng.randint(1, 8), 8)
    one = law.ask("whole", ball(radius, *center), law.motion, law.fixed.whole)
    other = law.collide.ask(f"{law.name} split", ball(radius + law.radius / 2, *center), law.motion, law.fixed.whole, "--clearance",
                            str(law.radius / 2))
    if one is not None and other is not None:
        law.checks.equal((other.word, other.times(), other.cells()), (one.word, one.times(), one.cells()), law.name, "split")


def law_parts_of_it(law):
    """The distance of a union is the least of its parts'."""
    if len(law.moving.parts) * len(law.fixed.parts) < 2:
        return
    whole = None
    for a in law.moving.parts:
        for b in law.fixed.parts:
            answer = law.ask("part", a, law.motion, b)
            if answer is None:
                return
            trace = trace_of(answer, law.motion.start, law.motion.end)
            whole = trace if whole is None else together(whole, trace, larger)
    law.checks.equal(trace_of(law.base, law.motion.start, law.motion.end).word(), whole.word(), law.name, "parts")


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    collide, rigid, words = Collide(args, checks), 0, Counter()
    for d, count in PAIRS.items():
        for k in args.rounds(count, str(d)):
            name, *pair = placed(args.random, d)
            while d == 3 and max(len(s.whole.vertices) for s in (pair[0], pair[2])) > MOST:
                name, *pair = placed(args.random, d)
            law = Near(collide, args.random, f"{d} {k} {name}", pair, args.random.choice(RADII))
            if law.base is None:
                continue
            words[law.base.word] += 1
            for one in (law_nearer, law_reversed, law_cut, law_parameter, law_parts_of_it):
                one(law)
            if is_rigid(law.motion):
                rigid += 1
                for one in (law_exchanged, law_moved_frame, law_split):
                    one(law)
    print(f"{rigid} rigid motions; words: " + ", ".join(f"{word} {n}" for word, n in words.most_common()))
    checks.finish()


if __name__ == "__main__":
    main()
