"""One answer against the second tracer, and what the points of a script met.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from collections import Counter

from times import check_canonical, irrational, time_is


class Tally:
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
        checks.holds(share >= 0.3, "share of irrational times", share)


def compare(checks, tally, answer, word, contacts, *where):
    checks.equal(answer.word, word, *where, "word")
    if not checks.equal(len(answer.contacts), len(contacts), *where, "contacts"):
        return
    for got, want, cells in zip(answer.contacts, contacts, answer.cells()):
        checks.equal((got["kind"], got["left"], got["right"]), (want.kind, want.left, want.right),
                     *where, "kind")
        for name, root in (("from", want.start), ("to", want.end)):
            checks.holds(time_is(got[name], root), *where, name, got[name], float(root))
        checks.equal(cells, want.cells, *where, "cells")
        tally.unproven += not check_canonical(checks, got["from"], *where)
