"""The program against the second tracer of lib/tracer.py, point by point, in the plane.

SPDX-License-Identifier: GPL-3.0-or-later

Words, kinds, states on both sides, exact times and boundary cells must agree; every time must be in
canonical form; at least 30 % of the times must be irrational, or the scenes prove too little.
"""
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

from harness import Checks, Graze, options  # noqa: E402
from points import mixed  # noqa: E402
from scenes import plane_scenes  # noqa: E402
from times import check_canonical, irrational, time_is  # noqa: E402
from tracer import trace  # noqa: E402

POINTS = 36


class Tally:
    """What the points met: how often which case, class and cells, how many irrational times."""

    def __init__(self):
        self.histogram, self.times, self.irrational, self.unproven = Counter(), 0, 0, 0

    def add(self, answer):
        r = answer.record
        kinds = {"+".join(sorted({c[0] for c in cells})) for cells in answer.cells()} or {"none"}
        for kind in kinds:
            self.histogram[(r["case"], r["class"], kind)] += 1
        for c in answer.contacts:
            self.times += 1
            self.irrational += irrational(c["from"])

    def report(self, checks):
        print("case class          cells of a contact         points")
        for (case, name, kind), n in sorted(self.histogram.items()):
            print(f"{case:4} {name:14} {kind:26} {n:6}")
        share = self.irrational / max(self.times, 1)
        print(f"{self.times} contacts, {100 * share:.0f} % at irrational times, "
              f"{self.unproven} minimal polynomials not seen to be irreducible")
        checks.true(share >= 0.3, "share of irrational times", share)


def compare(checks, tally, answer, word, contacts, *where):
    checks.equal(answer.word, word, *where, "word")
    if not checks.equal(len(answer.contacts), len(contacts), *where, "contacts"):
        return
    for got, want, cells in zip(answer.contacts, contacts, answer.cells()):
        checks.equal((got["kind"], got["left"], got["right"]), (want.kind, want.left, want.right),
                     *where, "kind")
        for name, root in (("from", want.start), ("to", want.end)):
            checks.true(time_is(got[name], root), *where, name, got[name], float(root))
        checks.equal(cells, want.cells, *where, "cells")
        tally.unproven += not check_canonical(checks, got["from"], *where)


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Tally()
    graze = Graze(args, checks)
    for name, solid, motion in plane_scenes(args.random, args.scale):
        points = mixed(solid, motion, args.random, POINTS)
        answers = graze.classify(name, solid, motion, [p for _, p in points])
        for (kind, p), answer in zip(points, answers or []):
            where = (name, kind, ",".join(str(x) for x in p))
            word, contacts = trace(solid, motion, p)
            compare(checks, tally, answer, word, contacts, *where)
            tally.add(answer)
    tally.report(checks)
    checks.finish()


if __name__ == "__main__":
    main()
