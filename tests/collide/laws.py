# suite
"""Laws of pairs: the same two solids asked about in another way must get the matching answer.

SPDX-License-Identifier: GPL-3.0-or-later

The solids exchanged with the inverse motion, world moved, time reversed, motion cut, at other speeds, solids given by
other facets, with corners repeated, or as Nef polyhedra, unions against their parts, both moved by a motion more, plane
pairs against prisms, points against boxes around them, `--inside` against complements and unsweeps. No law trusts the
program: all compare one run of it with another one along a different path.
"""
from pairs import Checks, Collide, exchanged_cells, larger, options, together, trace_of
from exact import Fraction as F, to_double
from placed import Solid, placed

import refine  # noqa: E402
from algebra import compare, scale  # noqa: E402
from motion import Motion, Piece, adjugate, build, cut, far, matrix, mobius, product, reversed_in_time, rotation  # noqa: E402
from motion import squared  # noqa: E402
from oracle import Oracle  # noqa: E402
from points import mixed  # noqa: E402
from shells import shells_text  # noqa: E402
from solids import Polygon, block, box_ring, extruded, meshes, polygons  # noqa: E402
from times import negated  # noqa: E402

SMALL = 200     # pairs of vertices of a pair that is asked also where most cells are coplanar or no double can help
PAIRS = {2: 10, 3: 8}
SOLIDS = {2: polygons, 3: meshes}       # solids of the tests of points: cavities, islands, parts that touch, reflex corners
POINTS = 3


class Law:
    """The tools of all laws: the pair, the command, the base answer."""

    def __init__(self, collide, oracle, rng, name, moving, motion, fixed):
        self.collide, self.checks, self.oracle, self.rng, self.name = collide, collide.checks, oracle, rng, name
        self.moving, self.motion, self.fixed = moving, motion, fixed
        self.small = len(moving.whole.vertices) * len(fixed.whole.vertices) < SMALL
        self.base = self.ask("base", moving.whole, motion, fixed.whole)

    def ask(self, law, moving, motion, fixed, *flags, **more):
        return self.collide.ask(f"{self.name} {law}", moving, motion, fixed, *flags, **more)

    def same(self, law, answer, cells=lambda pairs: pairs, times=True):
        """Word, kinds, times as text, and cells through a map, are those of the base."""
        if answer is None or not self.checks.equal(answer.word, self.base.word, self.name, law, "word"):
            return
        self.checks.equal(answer.kinds(), self.base.kinds(), self.name, law, "kinds")
        if times:
            self.checks.equal(answer.times(), self.base.times(), self.name, law, "times")
        if cells:
            self.checks.equal([cells(c) for c in answer.cells()], self.base.cells(), self.name, law, "cells")


def followed(motion, other):
    """`other` after `motion`; other has one piece, as long as the whole motion."""
    last = other.pieces[0]
    return Motion([Piece(p.lo, p.hi, *product((last.a, last.b, last.w), (p.a, p.b, p.w))) for p in motion.pieces])


def inverse(motion):
    """x = A^-1 (w y - b) of y = (A x + b) / w."""
    pieces = []
    for p in motion.pieces:
        adj, det = adjugate(p.a)
        back = product((adj, [[] for _ in p.b], det), ([[p.w if i == j else [] for j in range(len(p.b))]
                                                        for i in range(len(p.b))], [scale(b, -1) for b in p.b], [1]))
        pieces.append(Piece(p.lo, p.hi, *back))
    return Motion(pieces)


def law_exchanged(law):
    answer = law.ask("exchanged", law.fixed.whole, inverse(law.motion), law.moving.whole)
    law.same("exchanged", answer, exchanged_cells)


WORLDS = {2: [[[[1], [F(1, 2)], [3]], [[F(-1, 3)], [1], [-2]]],
              [[[F(-3, 5)], [F(4, 5)], [1]], [[F(4, 5)], [F(3, 5)], [F(1, 7)]]]],
          3: [[[[1], [F(1, 2)], [0], [3]], [[F(-1, 3)], [1], [0], [-2]], [[0], [F(1, 5)], [2], [1]]],
              [[[0], [1], [0], [1]], [[1], [0], [F(1, 4)], [0]], [[0], [0], [1], [F(-2, 3)]]]]}


def mapped(solid, by, mirrored):
    """A solid moved by a constant motion; facets of a mirrored mesh run the other way round."""
    def f(p):
        return by.map(p, by.start)
    return solid.mapped(f, mirrored) if solid.dimension == 3 else solid.mapped(f)


def magnified(d, exponent):
    """A scaling out of the range of doubles, and a translation as large."""
    f = F(2) ** exponent
    return [[[f] if i == j else [] for j in range(d)] + [[(3 - i) * f]] for i in range(d)]


def law_world(law):
    """Sheared, mirrored, far out of a double's range, each by a constant motion on the same interval."""
    m, d = law.motion, law.motion.dimension
    worlds = list(zip(("sheared", "mirrored"), WORLDS[d]))
    if law.small:
        worlds += [("vast", magnified(d, 1100)), ("minute", magnified(d, -1100))]
    for name, rows in worlds:
        world = build([(m.start, m.end, matrix(rows, [1]))])
        solids = [mapped(s.whole, world, name == "mirrored") for s in (law.moving, law.fixed)]
        back = inverse(world).pieces[0]
        inner = Motion([Piece(p.lo, p.hi, *product((p.a, p.b, p.w), (back.a, back.b, back.w))) for p in m.pieces])
        law.same(name, law.ask(name, solids[0], followed(inner, world), solids[1]))


def law_reversed(law):
    answer = law.ask("reversed", law.moving.whole, reversed_in_time(law.motion), law.fixed.whole)
    if answer is None or not law.checks.equal(answer.word, law.base.word[::-1], law.name, "reversed"):
        return
    law.checks.equal(answer.times(), [(negated(b), negated(a)) for a, b in law.base.times()[::-1]], law.name, "reversed")
    for got, want, (low, high) in zip(answer.cells(), law.base.cells()[::-1], answer.times()):
        if low == high:
            law.checks.equal(got, want, law.name, "reversed", "cells")


def law_cut(law):
    """Cut at rational contact times, and elsewhere."""
    m = law.motion
    times = [F(t) for pair in law.base.times() for t in pair if isinstance(t, str)]
    times += [m.start + (m.end - m.start) * F(law.rng.randint(1, 96), 97) for _ in range(2)]
    law.same("cut", law.ask("cut", law.moving.whole, cut(m, times), law.fixed.whole))


def law_parameter(law):
    """At other speeds, also so that rational times become irrational, and at times far from zero."""
    for change in (mobius, squared, far):
        name, motion = change.__name__, change(law.motion)[0]
        law.same(name, law.ask(name, law.moving.whole, motion, law.fixed.whole), times=False)


def law_boundary(law):
    changes = [refine.edges_cut] + ([refine.triangulated] if law.motion.dimension == 3 else [])
    for change in changes:
        (one, carry), (other, carry_other) = change(law.moving.whole), change(law.fixed.whole)

        def cells(pairs):
            return {(next(iter(carry({a}))), next(iter(carry_other({b})))) for a, b in pairs}
        name = change.__name__
        law.same(name, law.ask(name, one, law.motion, other), cells)


def law_repeated(law):
    """Corners given more than once in a row: every cell goes by all its new names, and no other."""
    (one, carry, cells), (other, carry_other, cells_other) = [refine.repeated(s.whole, law.rng)
                                                              for s in (law.moving, law.fixed)]
    answer = law.ask("repeated", one, law.motion, other)
    law.same("repeated", answer, None)
    for got, old in zip(answer.cells() if answer else [], law.base.cells()):
        want = {(a, b) for a in cells for b in cells_other
                if (carry.image.get(a, a), carry_other.image.get(b, b)) in old}
        law.checks.equal(got, want, law.name, "repeated", "cells")


def law_nef(law):
    if law.motion.dimension == 2 or "shared" in law.name:      # its shells share no vertex
        return
    answer = law.oracle.ask(shells_text(law.fixed.whole), one_form=False)
    if not answer or not law.checks.equal(answer.status, 0, law.name, "to_nef"):
        return
    path = law.collide.graze.write("nef.nef3", answer.text)
    law.same("nef", law.ask("nef", law.moving.whole, law.motion, path), None)


def law_parts(law):
    """Parts that share a facet too: an open set that is not empty has points off the borders of parts."""
    if len(law.moving.parts) * len(law.fixed.parts) < 2:        # also where parts are not known
        return
    start, end, whole = law.motion.start, law.motion.end, None
    for a in law.moving.parts:
        for b in law.fixed.parts:
            answer = law.ask("parts", a, law.motion, b)
            if answer is None:
                return
            trace = trace_of(answer, start, end)
            whole = trace if whole is None else together(whole, trace, larger)
    got = trace_of(law.base, start, end)
    if law.checks.equal(got.word(), whole.word(), law.name, "parts"):
        for one, other in zip(got.contacts(), whole.contacts()):
            law.checks.holds(not compare(one[0], other[0]) and not compare(one[1], other[1]), law.name, "parts",
                             to_double(one[0]), to_double(other[0]))


def law_frames(law):
    """Both moved by a motion more is the pair as it was; both by the same motion is a pair that stands still."""
    m, d = law.motion, law.motion.dimension
    more = build([(m.start, m.end, rotation([F(1, 3), F(1, 5)], **({} if d == 2 else {"axis": [2, 1, 2], "length": 3})))])
    law.same("frames", law.ask("frames", law.moving.whole, followed(m, more), law.fixed.whole, motion_of_fixed=more))
    still = build([(m.start, m.end, matrix(WORLDS[d][0], [1]))])
    stands = law.ask("still", law.moving.whole, still, law.fixed.whole)
    moves = law.ask("along", law.moving.whole, followed(still, more), law.fixed.whole, motion_of_fixed=more)
    if stands is not None and moves is not None:
        law.checks.equal(len(stands.word), 1, law.name, "still", stands.word)
        law.checks.equal((moves.word, moves.times(), moves.cells()), (stands.word, stands.times(), stands.cells()),
                         law.name, "along")


def law_prism(law):
    """Prisms of one height over a plane pair have its interiors, and its closed sets, over the same points."""
    if law.motion.dimension == 3 or not law.small:
        return
    solids = [extruded(s.whole, [0, 1])[0] for s in (law.moving, law.fixed)]
    motion = Motion([Piece(p.lo, p.hi, [p.a[0] + [[]], p.a[1] + [[]], [[], [], p.w]], list(p.b) + [[]], p.w)
                     for p in law.motion.pieces])
    law.same("prism", law.ask("prism", solids[0], motion, solids[1]), None)


def box_around(point, size):
    low, high = [x - size for x in point], [x + size for x in point]
    return block(*low, *high) if len(point) == 3 else Polygon([[box_ring(*low, *high)]])


def law_points(law):
    """Where a point is in the moved solid, or on its border, the interior of a box around it meets the solid's."""
    m = law.motion
    points = [p for _, p in mixed(law.moving.whole, m, law.rng, POINTS)]
    answers = law.collide.graze.classify(f"{law.name} points", law.moving.whole, m, points)
    for point, answer in zip(points, answers or []):
        check_box(law, "box", answer, {"IB", "IO", "BB", "BO"}, point,
                  lambda box: law.ask("box", law.moving.whole, m, box))


def check_box(law, name, answer, wrong, point, ask):
    """At no time does the letter of a box around the point contradict the letter of the point."""
    m, size = law.motion, F(1, 2 ** law.rng.choice((1, 8, 60)))
    box = ask(box_around(point, size))
    if box is not None:
        both = together(trace_of(answer, m.start, m.end), trace_of(box, m.start, m.end), lambda a, b: a + b)
        law.checks.holds(not wrong & set(both.at + both.between), law.name, name, point, size, answer.word, box.word)


def law_inside(law):
    """A solid is inside the complement of another as long as their interiors do not meet."""
    complement, carry = refine.complement(law.fixed.whole, 10 ** 6)
    answer = law.ask("inside", law.moving.whole, law.motion, complement, "--inside")
    law.same("inside", answer, lambda pairs: {(a, next(iter(carry({b})))) for a, b in pairs})


def law_unswept(law):
    """Where a point that moves is outside of the solid, or on its border, a box around it is not inside."""
    m, solid = law.motion, law.fixed.whole
    points = [p for _, p in mixed(solid, inverse(m), law.rng, POINTS)]
    answers = law.collide.graze.classify(f"{law.name} unswept", solid, m, points, "--operation", "unsweep")
    for point, answer in zip(points, answers or []):
        check_box(law, "unswept", answer, {"OB", "OO", "BB", "BO"}, point,
                  lambda box: law.ask("unswept", box, m, solid, "--inside"))


LAWS = [law_exchanged, law_world, law_reversed, law_cut, law_parameter, law_boundary, law_repeated, law_nef, law_parts,
        law_frames, law_prism, law_points, law_inside, law_unswept]


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    collide, oracle = Collide(args, checks), Oracle(args, checks, "to_nef")
    for d, count in PAIRS.items():
        for k in args.rounds(count, str(d)):
            name, *pair = placed(args.random, d, {name: Solid(whole, []) for name, whole in SOLIDS[d]().items()})
            law = Law(collide, oracle, args.random, f"{d} {k} {name}", *pair)
            if law.base is not None:
                for one in LAWS:
                    one(law)
    print(f"{collide.graze.runs} runs")
    oracle.finish()
    checks.finish()


if __name__ == "__main__":
    main()
