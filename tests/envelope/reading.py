"""The outputs of `graze envelope`: the summary, tables, and times as brackets of rationals.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv

from exact import Fraction as F, has_decimals


def sign(x):
    return (x > 0) - (x < 0)


def value(p, x):
    total = F(0)
    for c in reversed(p):
        total = total * x + c
    return total


class When:
    """A time of a table: [low, high] around it, which narrows."""

    def __init__(self, text):
        self.text = text
        if text.startswith("root("):
            p, low, high = text[5:-1].split(";")
            self.poly = [int(c) for c in p.split()]
            self.low, self.high = F(low), F(high)
        else:
            self.poly, self.low, self.high = None, F(text), F(text)

    def narrow(self):
        if self.poly is None or self.low == self.high:
            return
        middle = (self.low + self.high) / 2
        if sign(value(self.poly, middle)) == sign(value(self.poly, self.low)):
            self.low = middle
        else:
            self.high = middle

    def compare(self, x):
        """Sign of the time minus a rational that is not the time, unless it is rational."""
        while self.low < x < self.high:
            self.narrow()
        return 0 if self.low == x == self.high else 1 if self.low >= x else -1


def between(a, b):
    """A rational strictly between two times in order."""
    while a.high >= b.low:
        a.narrow()
        b.narrow()
    return (a.high + b.low) / 2


def table(path):
    """The rows of a whole table whose exact times have their decimals behind them, or None."""
    lines = open(path, encoding="utf-8").read().splitlines()
    rows = list(csv.DictReader(x for x in lines if not x.startswith("#")))
    columns = rows[0] if rows else {}
    times = ["from", "to"] if "from" in columns else ["time"] if "facet" in columns else []
    return rows if lines[-1] == f"# complete {len(rows)}" and all(has_decimals(row, *times) for row in rows) else None


def summary(text):
    """The lines `name: value` of the summary."""
    return dict(line.split(": ", 1) for line in text.splitlines())


def named(cell):
    """('edge', 1, 2) of `edge 1-2`."""
    if not cell:
        return None
    kind, numbers = cell.split(" ")
    return (kind,) + tuple(int(x) for x in numbers.split("-"))
