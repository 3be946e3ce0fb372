# suite
"""Laws every answer obeys: the same question put in another way must get the matching answer.

SPDX-License-Identifier: GPL-3.0-or-later

Time reversed, world moved ([IS] eqs 32, 33) or in other coordinates, motion cut, boundary cut otherwise, its corners
repeated, parameter changed, mesh against Nef polyhedron, union against its parts, sweep against
unsweep of the complement ([IS] eqs 19, 36), sequence against its parts, plane scene against its
prism. No law trusts the program: all compare one run of it with another one along a different path.
"""
import os
import sys
from functools import cmp_to_key

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import refine  # noqa: E402
from agreement import Tally  # noqa: E402
from algebra import compare as compare_roots  # noqa: E402
from algebra import scale, sub, substitute  # noqa: E402
from exact import Fraction as F  # noqa: E402
from oracle import Oracle  # noqa: E402
from program import Checks, Graze, exchanged, merged, options  # noqa: E402
from motion import Motion, Piece, build, compose, constant, conjugated, cut, legs  # noqa: E402
from motion import far, mobius, product, reversed_in_time, rotation, scaling, squared  # noqa: E402
from motion import translate  # noqa: E402
from points import mixed  # noqa: E402
from scenes import scenes  # noqa: E402
from shells import shells_text  # noqa: E402
from solids import extruded, meshes, polygons  # noqa: E402
from times import irrational, negated, time_root  # noqa: E402

POINTS = 18
BACKWARDS = {1: 1, 2: 4, 3: 7, 4: 2, 5: 5, 6: 8, 7: 3, 8: 6, 9: 9}


class Scene:
    def __init__(self, name, solid, motion, points):
        self.name, self.solid, self.motion, self.points = name, solid, motion, points
        self.space = motion.dimension == 3


class Law:
    """The tools of all laws: the program, the checks, the base answers of one scene."""

    def __init__(self, graze, checks, scene, base, rng, oracle=None):
        self.graze, self.checks, self.scene, self.base = graze, checks, scene, base
        self.rng, self.oracle = rng, oracle

    def ask(self, law, solid, motion, points, *flags):
        return self.graze.classify(f"{self.scene.name} {law}", solid, motion, points, *flags)

    def same(self, law, answers, times=True, cells=None):
        """All fields equal to the base; times as text; cells through the map `cells`."""
        for a, b, p in zip(answers or [], self.base, self.scene.points):
            where = (self.scene.name, law, ",".join(str(x) for x in p))
            self.checks.equal(a.counts(), b.counts(), *where)
            self.checks.equal(a.kinds(), b.kinds(), *where, "kinds")
            if times:
                self.checks.equal(a.times(), b.times(), *where, "times")
            if cells:
                self.checks.equal([cells(c) for c in a.cells()], b.cells(), *where, "cells")


def unchanged(cells):
    return cells


def law_reversed(law):
    s = law.scene
    answers = law.ask("reversed", s.solid, reversed_in_time(s.motion), s.points)
    for a, b, p in zip(answers or [], law.base, s.points):
        where = (s.name, "reversed", ",".join(str(x) for x in p))
        r, q = a.record, b.record
        law.checks.equal([r[k] for k in ("i", "t", "class", "pmc")],
                         [q[k] for k in ("i", "t", "class", "pmc")], *where)
        law.checks.equal((a.word, r["case"]), (b.word[::-1], BACKWARDS[q["case"]]), *where)
        mirrored = [{"kind": c["kind"], "left": c["right"], "right": c["left"],
                     "from": negated(c["to"]), "to": negated(c["from"]),
                     "features": c["features"]} for c in reversed(b.contacts)]
        law.checks.equal(a.contacts, mirrored, *where, "contacts")


SHEARS = {
    2: ([[1, F(1, 2), 3], [F(-1, 3), 1, -2]],
        [[F(-3, 5), F(4, 5), 1], [F(4, 5), F(3, 5), F(1, 7)]]),
    3: ([[1, F(1, 2), 0, 3], [F(-1, 3), 1, 0, -2], [0, F(1, 5), 2, 1]],
        [[0, 1, 0, 1], [1, 0, F(1, 4), 0], [0, 0, 1, F(-2, 3)]]),
}


def magnified(d, exponent):
    """A scaling out of the range of doubles, and a translation as large."""
    f = F(2) ** exponent
    return [[f if i == j else F(0) for j in range(d)] + [(3 - i) * f] for i in range(d)]


def affine_inverse(m):
    n = len(m)
    rows = [[F(x) for x in row[:n]] + [F(int(i == j)) for j in range(n)]
            for i, row in enumerate(m)]
    for k in range(n):
        pivot = next(i for i in range(k, n) if rows[i][k])
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(n):
            if i != k:
                rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k])]
    a = [row[n:] for row in rows]
    return [row + [-sum(x * F(m[j][n]) for j, x in enumerate(row))] for row in a]


def affine_map(m):
    n = len(m)
    return lambda p: tuple(sum(F(m[i][j]) * p[j] for j in range(n)) + m[i][n] for i in range(n))


def law_world(law):
    """Sheared, mirrored (facets then run the other way round), and far out of a double's range."""
    s, d = law.scene, law.scene.motion.dimension
    maps = list(zip(("moved", "mirrored"), SHEARS[d]))
    maps += [("vast", magnified(d, 1100)), ("minute", magnified(d, -1100))]
    for name, m in maps:
        f = affine_map(m)
        solid = s.solid.mapped(f, name == "mirrored") if s.space else s.solid.mapped(f)
        motion = conjugated(s.motion, m, affine_inverse(m))
        law.same(name, law.ask(name, solid, motion, [f(p) for p in s.points]), cells=unchanged)


LONG = F(10) ** 10


def law_frame(law):
    """The world alone in other coordinates, with long entries: on the way back their first two products cancel at
    some point, so that a short number is left."""
    s, d = law.scene, law.scene.motion.dimension
    for p in law.rng.sample(s.points, 3):
        back = [[LONG, -LONG, p[0]], [0, 1 / LONG, p[1] - LONG]]
        if d == 3:
            back = [[LONG, -LONG, 0, p[0]], [0, 1 / LONG, 0, p[1] - LONG], [0, LONG, -LONG, p[2]]]
        m = affine_inverse(back)
        f = affine_map(m)
        motion = Motion([Piece(x.lo, x.hi, *product(constant(m, d), (x.a, x.b, x.w))) for x in s.motion.pieces])
        law.same("frame", law.ask("frame", s.solid, motion, [f(q) for q in s.points]), cells=unchanged)


def law_cut(law):
    """Cut at rational contact times, and elsewhere."""
    s = law.scene
    times = [F(c["from"]) for a in law.base for c in a.contacts if not irrational(c["from"])]
    law.rng.shuffle(times)
    width = s.motion.end - s.motion.start
    times = times[:4] + [s.motion.start + width * F(law.rng.randint(1, 96), 97) for _ in range(2)]
    law.same("cut", law.ask("cut", s.solid, cut(s.motion, times), s.points), cells=unchanged)


def law_boundary(law):
    s = law.scene
    changes = [("edges cut", refine.edges_cut)]
    if s.space:
        changes += [("triangulated", refine.triangulated), ("facets halved", refine.facets_halved)]
    for name, change in changes:
        solid, carry = change(s.solid)
        law.same(name, law.ask(name, solid, s.motion, s.points), cells=carry)


def law_repeated(law, *flags):
    """Corners given more than once in a row: every cell goes by all its new names, and no other."""
    s = law.scene
    solid, carry, cells = refine.repeated(s.solid, law.rng)
    answers = law.ask("repeated", solid, s.motion, s.points, *flags)
    law.same("repeated", answers)
    for a, b, p in zip(answers or [], law.base, s.points):
        want = [{c for c in cells if carry.image.get(c, c) in met} for met in b.cells()]
        law.checks.equal(a.cells(), want, s.name, "repeated", ",".join(str(x) for x in p), "cells")


def law_parameter(law):
    s = law.scene
    for name, change in (("mobius", mobius), ("squared", squared), ("far", far)):
        motion, changes = change(s.motion)
        answers = law.ask(name, s.solid, motion, s.points)
        law.same(name, answers, times=False, cells=unchanged)
        for a, b, p in zip(answers or [], law.base, s.points):
            for c, d in zip(a.contacts, b.contacts):
                for end in ("from", "to"):
                    law.checks.holds(carried(c[end], d[end], s.motion, changes), s.name, name,
                                    ",".join(str(x) for x in p), c[end], d[end])


def carried(new, old, motion, changes):
    """Is phi(new) = old for the piece's monotone phi?"""
    u, t = time_root(new), time_root(old)
    u.narrow(min(c[1] - c[0] for c in changes) / 2 ** 40)
    a, b = u.bounds()
    k = next(k for k, c in enumerate(changes) if c[0] <= a and b <= c[1])
    lo, hi, num, den = changes[k]
    if t.value is not None:
        q = sub(scale(num, t.value.denominator), scale(den, t.value.numerator))
        return u.sign_of(q) == 0
    q = substitute(t.poly, num, den, len(t.poly) - 1)
    if u.sign_of(q) != 0:
        return False
    inside = [sub(scale(num, x.denominator), scale(den, x.numerator)) for x in (t.lo, t.hi)]
    positive = u.sign_of(den)
    return u.sign_of(inside[0]) * positive > 0 > u.sign_of(inside[1]) * positive


def law_nef(law):
    s = law.scene
    if not s.space or "shared" in s.name:
        return
    answer = law.oracle.ask(shells_text(s.solid), one_form=False)
    if not answer or not law.checks.equal(answer.status, 0, s.name, "to_nef"):
        return
    path = law.graze.write("nef.nef3", answer.text)
    law.same("nef", law.ask("nef", path, s.motion, s.points))


def law_union(law):
    s = law.scene
    pool = meshes() if s.space else polygons()
    other = refine.beside(s.solid, pool["octahedron" if s.space else "star"], F(1, 4))
    both, shifted = refine.union(s.solid, other)
    alone = law.ask("other alone", other, s.motion, s.points)
    answers = law.ask("union", both, s.motion, s.points)
    if alone is None or answers is None:
        return
    for a, b, c, p in zip(answers, law.base, alone, s.points):
        where = (s.name, "union", ",".join(str(x) for x in p))
        parts = [dict(x, cells=cells) for x, cells in zip(b.contacts, b.cells())]
        parts += [dict(x, cells=shifted(cells)) for x, cells in zip(c.contacts, c.cells())]
        parts = in_order(parts)
        got = [dict(x, cells=cells) for x, cells in zip(a.contacts, a.cells())]
        for x in parts + got:
            x.pop("features")
        law.checks.equal(got, parts, *where)
        states = {b.word[0], c.word[0]} - {"O"}
        word = next(iter(states), "O")
        for x in parts:
            word += "B" + (x["right"] or "")
        law.checks.equal(a.word, merged(word), *where, "word")


def in_order(contacts):
    return sorted(contacts, key=cmp_to_key(
        lambda x, y: compare_roots(time_root(x["from"]), time_root(y["from"]))))


def law_dual(law):
    """P is in the sweep of S iff it is not in the unsweep of the complement: states exchanged."""
    s, size = law.scene, 10 ** 6
    solid, carry = refine.complement(s.solid, size)
    d = s.motion.dimension
    still = {"dimension": d, "pieces": [
        {"t": [str(s.motion.start), str(s.motion.end)], "transform": {"translate": ["0"] * d}}]}
    motion = Motion(s.motion.pieces, {"dimension": d, "relative": {
        "moving": still, "frame": s.motion.document}})
    answers = law.ask("dual", solid, motion, s.points, "--operation", "unsweep")
    for a, b, p in zip(answers or [], law.base, s.points):
        where = (s.name, "dual", ",".join(str(x) for x in p))
        pmc = {"in": "out", "out": "in", "on": "on"}[b.record["pmc"]]
        law.checks.equal((a.word, a.record["pmc"]), (exchanged(b.word), pmc), *where)
        law.checks.equal(a.times(), b.times(), *where, "times")
        law.checks.equal([carry(c) for c in a.cells()], b.cells(), *where, "cells")


def followers(space):
    """Motions that start at the identity."""
    if space:
        return [legs([(0, 0, 0), (-6, 1, 0), (4, 0, 1)]),
                build([(0, 2, compose(rotation([0, F(1, 2)], axis=[2, 1, 2], length=3),
                                      translate([[0, 0, -1], [0, 2], [0]])))])]
    return [legs([(0, 0), (-8, 1), (5, 0)], [1, 2, 5]),
            build([(0, 1, compose(scaling([[1, F(1, 2)], [1, 0, 1]]),
                                  translate([[0, -7], [0, 0, 2]])))])]


def affine_at(motion, t):
    """The map at time t as rows of d+1 numbers, from the images of origin and unit points."""
    d = motion.dimension
    origin = motion.map([F(0)] * d, t)
    columns = [[a - b for a, b in zip(motion.map([F(int(i == j)) for j in range(d)], t), origin)]
               for i in range(d)]
    return [list(row) for row in zip(*columns, origin)]


def law_sequence(law):
    """On [0, 1] the first motion, on [1, 2] the second after the first one's last position."""
    s = law.scene
    second = law.rng.choice(followers(s.space))
    d, last = s.motion.dimension, affine_at(s.motion, s.motion.end)
    after = Motion([Piece(p.lo, p.hi, *product((p.a, p.b, p.w), constant(last, d)))
                    for p in second.pieces])
    whole = Motion(s.motion.pieces, {"dimension": d, "sequence": [
        s.motion.document, second.document]})
    answers = law.ask("sequence", s.solid, whole, s.points)
    tails = law.ask("second part", s.solid, after, s.points)
    if answers is None or tails is None:
        return
    for a, b, c, p in zip(answers, law.base, tails, s.points):
        where = (s.name, "sequence", ",".join(str(x) for x in p))
        law.checks.equal(a.word, merged(b.word + c.word), *where)
        expected = [(0, s.motion, x) for x in b.contacts] + [(1, second, x) for x in c.contacts]
        joins = b.word[-1] == "B" == c.word[0]
        if not law.checks.equal(len(a.contacts), len(expected) - joins, *where, "contacts"):
            continue
        spans = [[shifted_time(m, k, x["from"]), shifted_time(m, k, x["to"])]
                 for k, m, x in expected]
        if joins:
            j = len(b.contacts)
            spans[j - 1:j + 1] = [[spans[j - 1][0], spans[j][1]]]
        for x, (start, stop) in zip(a.contacts, spans):
            law.checks.holds(agrees(x["from"], *start) and agrees(x["to"], *stop), *where, x)


def shifted_time(motion, k, time):
    """A time of part k, with the part's interval."""
    return motion.start, motion.end, k, time


def agrees(new, start, end, k, old):
    """new = k + (old - start) / (end - start)?"""
    width = end - start
    num, den = [start - width * k, width], 1
    for c in num:
        den *= c.denominator
    change = (F(k), F(k + 1), [int(c * den) for c in num], [den])
    return carried(new, old, None, [change])


def law_prism(law):
    s = law.scene
    if s.space:
        return
    for levels, z in (([-1, 1], F(1, 3)), ([-1, F(1, 2), 2], F(1, 2))):
        mesh, carry = extruded(s.solid, levels)
        motion = Motion([Piece(p.lo, p.hi, [p.a[0] + [[]], p.a[1] + [[]], [[], [], p.w]],
                               list(p.b) + [[]], p.w) for p in s.motion.pieces])
        name = f"prism {len(levels)}"
        answers = law.ask(name, mesh, motion, [tuple(p) + (z,) for p in s.points])
        law.same(name, answers)
        for a, b, p in zip(answers or [], law.base, s.points):
            want = [{carry(cell, z) for cell in cells} for cells in b.cells()]
            law.checks.equal(a.cells(), want, s.name, name, ",".join(str(x) for x in p), "cells")


LAWS = [law_reversed, law_world, law_frame, law_cut, law_boundary, law_repeated, law_parameter, law_nef, law_union,
        law_dual, law_sequence, law_prism]


def repeated_in_fans(graze, checks, args):
    """The law of repeated corners where facets are not planar and have to be fanned."""
    motion = legs([(-9, 0, 0), (0, F(1, 3), 0), (2, 9, 1)])
    for _, lift in args.cycle((1, -1), 3, "fans"):
        solid = meshes()["cube"]
        solid.vertices[7] = (3, 3, 3 + F(lift, 2))
        points = [p for _, p in mixed(solid, motion, args.random, POINTS)]
        base = graze.classify(f"fans {lift}", solid, motion, points, "--triangulate")
        if base:
            scene = Scene(f"fans {lift}", solid, motion, points)
            law_repeated(Law(graze, checks, scene, base, args.random), "--triangulate")


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Tally()
    graze, oracle = Graze(args, checks), Oracle(args, checks, "to_nef")
    for name, solid, motion in scenes(args):
        points = [p for _, p in mixed(solid, motion, args.random, POINTS)]
        base = graze.classify(name, solid, motion, points)
        if base is None:
            continue
        for a in base:
            tally.add(a)
        law = Law(graze, checks, Scene(name, solid, motion, points), base, args.random, oracle)
        for one in LAWS:
            one(law)
    repeated_in_fans(graze, checks, args)
    tally.report(checks)
    print(f"{graze.runs} runs")
    oracle.finish()
    checks.finish()


if __name__ == "__main__":
    main()
