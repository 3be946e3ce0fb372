#!/usr/bin/env python3
# suite
"""`graze contact` under changes that keep the sites: world and body moved by affine maps, some of them mirrors, time
run otherwise or backwards, the motion cut, facets cut.

SPDX-License-Identifier: GPL-3.0-or-later

A change of the body's or the world's orientation turns `orientation` over; running backwards exchanges egress and
ingress, left and right.
"""
import csv
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import oracle  # noqa: E402
from derivation import sites  # noqa: E402
from exact import Fraction as F  # noqa: E402
from motion import Motion, Piece, constant, cut, mobius, product, reversed_in_time  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from refine import triangulated  # noqa: E402
from scenes import scenes  # noqa: E402
from solids import Polygon  # noqa: E402

SITES = {2: 16, 3: 8}
SAME = ("role", "theta", "contact_order", "orientation", "left", "right", "trimmed", "status", "near", "near_in", "word")
# Maps with their inverses, rows of d + 1 numbers; the second of each mirrors.
MAPS = {2: [([[1, 1, 3], [0, 2, -1]], [[1, F(-1, 2), F(-7, 2)], [0, F(1, 2), F(1, 2)]]),
            ([[0, 1, 2], [1, 0, 0]], [[0, 1, 0], [1, 0, -2]])],
        3: [([[1, 1, 0, 3], [0, 2, 0, -1], [0, 0, 1, 0]],
             [[1, F(-1, 2), 0, F(-7, 2)], [0, F(1, 2), 0, F(1, 2)], [0, 0, 1, 0]]),
            ([[0, 1, 0, 2], [1, 0, 0, 0], [0, 0, 1, 5]], [[0, 1, 0, 0], [1, 0, 0, -2], [0, 0, 1, -5]])]}
TURNED = {"preserving": "reversing", "reversing": "preserving"}


def apply(m, p):
    return tuple(sum(F(a) * x for a, x in zip(row, p)) + F(row[-1]) for row in m)


def times_map(motion, left, right):
    """left M right for constant affine maps, either of them None."""
    n, pieces = motion.dimension, []
    for p in motion.pieces:
        entries = (p.a, p.b, p.w)
        entries = product(constant(left, n), entries) if left else entries
        entries = product(entries, constant(right, n)) if right else entries
        pieces.append(Piece(p.lo, p.hi, *entries))
    return Motion(pieces)


class Runs:
    def __init__(self, checks, graze):
        self.checks, self.graze, self.number = checks, graze, 0

    def rows(self, solid, motion, chosen, name):
        """The table's rows, or None after a failed check."""
        self.number += 1
        d = solid.dimension
        lines = [["time", "bx", "by", "bz"][:1 + d]] + [[str(x) for x in (t,) + tuple(y)] for t, y in chosen]
        files = [self.graze.write(f"{self.number}{end}", text) for end, text in
                 ((solid.suffix, solid.text()), (".json", motion.text()),
                  (".csv", "".join(",".join(x) + "\n" for x in lines)))]
        out = self.graze.call("contact", *files, "--quiet")
        if not self.checks.equal(out.returncode, 0, name, out.stderr):
            return None
        return list(csv.DictReader(x for x in out.stdout.splitlines() if not x.startswith("#")))

    def same(self, name, first, second, change=None):
        for a, b in zip(first or [], second or []):
            want = change(dict(a)) if change else a
            self.checks.equal([b[k] for k in SAME], [want[k] for k in SAME], name, a)


def mirrored(row):
    row["orientation"] = TURNED.get(row["orientation"], row["orientation"])
    return row


def opposite_time(text):
    if not text.startswith("root"):
        return str(-F(text)) if text else ""
    coefficients, low, high = text[5:-1].split(";")
    p = [int(c) * (-1) ** k for k, c in enumerate(coefficients.split())]
    p = [-c for c in p] if p[-1] < 0 else p
    return f"root({' '.join(map(str, p))};{-F(high)};{-F(low)})"


def is_tie(first, second, t):
    """Are two times t - s and t + s? Roots are only looked at for t = 0."""
    if first.startswith("root") or second.startswith("root"):
        return t == 0 and opposite_time(first) == second
    return first != "" and second != "" and F(first) + F(second) == 2 * t


def backwards(row):
    row["role"] = {"egress": "ingress", "ingress": "egress"}.get(row["role"], row["role"])
    row["left"], row["right"], row["word"] = row["right"], row["left"], row["word"][::-1]
    row["near"], row["near_in"] = opposite_time(row["near"]), opposite_time(row["near_in"])
    return row


def without_times(row):
    row["near"] = row["near_in"] = ""
    return row


def check_laws(runs, rng, name, solid, motion, chosen, base):
    for k, (m, inverse) in enumerate(MAPS[solid.dimension]):
        turn = mirrored if k else None
        runs.same(f"{name} world {k}", base, runs.rows(solid, times_map(motion, m, None), chosen, name), turn)
        body = solid.mapped(lambda p, m=m: apply(m, p)) if isinstance(solid, Polygon) else \
            solid.mapped(lambda p, m=m: apply(m, p), bool(k))
        moved = [(t, apply(m, y)) for t, y in chosen]
        runs.same(f"{name} body {k}", base, runs.rows(body, times_map(motion, None, inverse), moved, name), turn)
    turned = [(-t, y) for t, y in chosen]
    again = runs.rows(solid, reversed_in_time(motion), turned, name)
    # of two times at equal distance the earlier one is told, which is another one then
    for row, other, (t, _) in zip(base, again or [], turned):
        for column in ("near", "near_in"):
            if is_tie(opposite_time(row[column]), other[column], t):
                other[column] = opposite_time(row[column])
    runs.same(f"{name} backwards", base, again, backwards)
    times = sorted({p.lo + (p.hi - p.lo) * F(rng.randint(1, 63), 64) for p in motion.pieces} | {t for t, _ in chosen[:2]})
    runs.same(f"{name} cut", base, runs.rows(solid, cut(motion, times), chosen, name))
    if solid.dimension == 3:
        try:
            fine = triangulated(solid)[0]
        except (ValueError, IndexError):
            return
        runs.same(f"{name} facets", base, runs.rows(fine, motion, chosen, name))


def check_speed(runs, name, solid, motion, chosen, base):
    """Time run otherwise: phi(v) = (1 + q) v / (1 + q v) on each piece, inverted v = p / (1 + q - q p)."""
    q = F(3, 2)
    other, _ = mobius(motion, q)
    moved = []
    for t, y in chosen:
        k, p = next((k, p) for k, p in enumerate(motion.pieces) if p.lo <= t <= p.hi)
        part = (t - p.lo) / (p.hi - p.lo)
        moved.append((k + part / (1 + q - q * part), y))
    again = runs.rows(solid, other, moved, name)
    runs.same(f"{name} speed", [without_times(dict(r)) for r in base], [without_times(r) for r in again or []])


def main():
    args = options(__doc__.split("\n\n")[0])
    checks = Checks()
    graze = Graze(args, checks)
    runs = Runs(checks, graze)
    for name, solid, motion in scenes(args):
        sides = oracle.sides_of(solid)
        chosen = sites(args.random, solid, motion, sides, SITES[solid.dimension])
        base = runs.rows(solid, motion, chosen, name)
        if base is None:
            continue
        check_laws(runs, args.random, name, solid, motion, chosen, base)
        check_speed(runs, name, solid, motion, chosen, base)
    checks.finish()


if __name__ == "__main__":
    main()
