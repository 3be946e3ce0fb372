#!/usr/bin/env python3
# suite
"""Laws of curved scenes: world and body moved by rational maps, time reversed, cut and run otherwise, the expression by De
Morgan's laws, in another order and nested, complements, sweep against unsweep of the complement (C94 to C101, C121, C122).

SPDX-License-Identifier: GPL-3.0-or-later

The scenes are those of words.py, the points the origin, whose trajectory is the path that is given, and rational ones near
it. Rows that are undecided are left out, and counted: they must be few.
"""
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

import words  # noqa: E402
from scenes import Checks, Curved, Graze, Motion, common, halfspace, minus, options, texts, union  # noqa: E402
from exact import Fraction as F  # noqa: E402

SWAP = str.maketrans("IO", "OI")


def instead(motion, change):
    """The motion with `change(lo, hi)`, text in t, for t."""
    def put(value, by):
        if isinstance(value, dict):
            return {key: put(x, by) for key, x in value.items()}
        if isinstance(value, list):
            return [put(x, by) for x in value]
        return re.sub(r"\bt\b", f"({by})", value)
    return [(lo, hi, put(transform, change(lo, hi))) for lo, hi, transform in motion.pieces]


def reversed_in_time(motion):
    lo, hi = F(motion.pieces[0][0]), F(motion.pieces[-1][1])
    pieces = instead(motion, lambda a, b: f"{lo + hi}-t")
    return Motion(motion.dimension, [(lo + hi - F(b), lo + hi - F(a), m) for a, b, m in reversed(pieces)])


def run_otherwise(motion):
    """The first piece's times squared from its beginning on."""
    pieces = instead(motion, lambda a, b: f"{a}+(t-({a}))*(t-({a}))/({F(b) - F(a)})")
    return Motion(motion.dimension, pieces)


def cut(motion, rng):
    out = []
    for a, b, transform in motion.pieces:
        at = F(a) + (F(b) - F(a)) * F(rng.randint(1, 7), 8)
        out += [(a, at, transform), (at, b, transform)]
    return Motion(motion.dimension, out)


def with_maps(motion, before=None, after=None):
    pieces = [(a, b, {"compose": [*([{"matrix": before}] if before else []), m, *([{"matrix": after}] if after else [])]})
              for a, b, m in motion.pieces]
    return Motion(motion.dimension, pieces)


def some_map(rng, d):
    """An invertible rational map and its inverse: shears, a scale and a shift, as rows of d + 1."""
    rows = [[F(int(i == j)) for j in range(d + 1)] for i in range(d + 1)]
    back = [row[:] for row in rows]
    for _ in range(3):
        i, j = rng.sample(range(d), 2)
        k = F(rng.randint(-2, 2), rng.choice([1, 2, 3]))
        rows[i] = [x + k * y for x, y in zip(rows[i], rows[j])]
        for row in back:
            row[j] -= k * row[i]
    i, factor, shift = rng.randrange(d), F(rng.choice([-2, 2, 3]), 3), F(rng.randint(-3, 3), 2)
    rows[i] = [x * factor for x in rows[i]]
    rows[i][d] += shift
    for row in back:
        row[i] /= factor
        row[d] -= row[i] * shift
    return [texts(row) for row in rows[:d]], [texts(row) for row in back[:d]]


def mapped(rows, point):
    return tuple(sum(F(a) * x for a, x in zip(row, point)) + F(row[-1]) for row in rows)


def everything(d):
    normal = [1] + [0] * (d - 1)
    return union(halfspace(normal), halfspace([-x for x in normal]))


def without(node, d):
    return minus(everything(d), node)


def de_morgan(node, d):
    """The set without unions: each becomes the complement of an intersection of complements."""
    (name, value), = ((k, v) for k, v in node.items() if k != "name")
    if name == "union":
        return without(common(*(without(de_morgan(n, d), d) for n in value)), d)
    if name == "intersection":
        return without(union(*(without(de_morgan(n, d), d) for n in value)), d)
    if name == "difference":
        return common(de_morgan(value[0], d), *(without(de_morgan(n, d), d) for n in value[1:]))
    return node


def nested(node, rng):
    """Operands in another order, two and two."""
    (name, value), = ((k, v) for k, v in node.items() if k != "name")
    if name not in ("union", "intersection", "difference"):
        return node
    value = [nested(n, rng) for n in value]
    if name == "difference":
        return {name: [value[0], union(*rng.sample(value[1:], len(value) - 1))]}
    rng.shuffle(value)
    while len(value) > 2:
        value = [{name: value[:2]}, *value[2:]]
    return {name: value}


def points_of(d, rng, count):
    return [(F(0),) * d] + [tuple(F(rng.randint(-8, 8), rng.choice([2, 4, 5])) for _ in range(d)) for _ in range(count)]


def main():
    args = options(__doc__.splitlines()[0])
    checks, rng = Checks(), args.random
    graze = Graze(args, checks)
    seen = undecided = 0

    def compare(name, law, want, got, change=lambda word: word):
        nonlocal seen, undecided
        for one, other in zip(want or [], got or []):
            seen += 1
            undecided += "?" in one.word + other.word
            if "?" not in one.word + other.word:
                checks.equal(other.word, change(one.word), name, law, *one.point if hasattr(one, "point") else ())

    for _, (name, node, motion, _, _) in args.cycle(words.SCENES):
        d = motion.dimension
        points = points_of(d, rng, 4)
        solid = Curved(d, node)
        want = graze.classify(name, solid, motion, points)

        def same(law, other, moving, at=points, change=lambda word: word, *more):
            compare(name, law, want, graze.classify(f"{name}, {law}", other, moving, at, *more), change)
        there, back = some_map(rng, d)
        same("body", Curved(d, {"affine": {"matrix": there, "of": node}}), with_maps(motion, before=back))
        same("world", solid, with_maps(motion, after=there), [mapped(there, p) for p in points])
        same("reversed", solid, reversed_in_time(motion), points, lambda word: word[::-1])
        same("cut", solid, cut(motion, rng))
        same("run otherwise", solid, run_otherwise(motion))
        same("De Morgan", Curved(d, de_morgan(node, d)), motion)
        same("order", Curved(d, nested(node, rng)), motion)
        same("complement", Curved(d, without(node, d)), motion, points, lambda word: word.translate(SWAP))
        opposite = Motion(d, [(a, b, {"translate": [f"-({x})" for x in m["translate"]]}) for a, b, m in motion.pieces])
        same("unsweep", Curved(d, without(node, d)), opposite, points, lambda word: word.translate(SWAP), "--operation", "unsweep")
    print(f"{seen} rows, {undecided} undecided")
    checks.holds(seen >= 3000 * args.share and undecided * 50 < seen, f"{seen} rows, {undecided} undecided")
    checks.finish()


if __name__ == "__main__":
    main()
