"""What the points of a script met: the histogram of (case, class, cells) and irrational times.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from collections import Counter

from times import irrational


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
        checks.true(share >= 0.3, "share of irrational times", share)
