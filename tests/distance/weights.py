#!/usr/bin/env python3
# suite
"""Distances where the common denominator of a motion's matrix is far smaller at some times than at others (C68).

SPDX-License-Identifier: GPL-3.0-or-later

A turn by tan_half t for t in [a, T], T up to 10^40, has the denominator 1 + t^2. The same path with the parameter q = 1/t
beyond t = 1 has denominators between 1 and 2: enclosures of the two must meet, and each is as narrow as asked for.
"""
import csv
import json
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "lib")]

from exact import Fraction as F, to_double  # noqa: E402
from harness import Checks, options, run  # noqa: E402

checks = Checks()
TOLERANCE = F(1, 10 ** 6)
SQUARE = "POLYGON ((-1 -1, 9 -1, 9 9, -1 9, -1 -1))\n"
BOX = "OFF\n8 6 0\n-1 -1 0\n9 -1 0\n9 9 0\n-1 9 0\n-1 -1 3\n9 -1 3\n9 9 3\n-1 9 3\n" \
      "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"


def turn(d, expression):
    return {"rotate": {"tan_half": expression, **({"axis": [0, 0, 1]} if d == 3 else {})}}


def shear(d):
    return {"matrix": [[1, "1/2", 0], [0, 1, 0]] if d == 2 else [[1, "1/2", 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}


def moved(d, rigid, expression):
    return turn(d, expression) if rigid else {"compose": [turn(d, expression), shear(d)]}


def plain(d, rigid, last):
    return {"dimension": d, "pieces": [{"t": [0, last], "transform": moved(d, rigid, "t")}]}


def even(d, rigid, last):
    """The path of `plain`: t, then 1/q with q from 1 down to 1/last."""
    return {"dimension": d, "pieces": [{"t": [0, 1], "transform": moved(d, rigid, "t")},
                                       {"t": [1, 2], "transform": moved(d, rigid, f"1/(2-t+(t-1)/{last})")}]}


def mirrored(motion):
    """Backwards: the denominator is smallest at the end."""
    text = json.dumps(motion)
    piece = json.loads(text)["pieces"][0]
    last = piece["t"][1]
    return json.loads(text.replace('"tan_half": "t"', f'"tan_half": "{last}-t"'))


def rows(graze, folder, d, motion, *flags):
    paths = [os.path.join(folder, name) for name in ("solid." + ("wkt" if d == 2 else "off"), "motion.json", "points.csv")]
    points = [(0, F(5, 3)), (6, 8), (0, -3), (20, 1), (-2, -2), (F(-1, 7), 12), (F(19, 2), F(-1, 2)), (-11, F(1, 3))]
    texts = (SQUARE if d == 2 else BOX, json.dumps(motion), "".join(",".join(map(str, (*p, *(["4/3"] * (d - 2))))) + "\n" for p in points))
    for path, text in zip(paths, texts):
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    done = run([graze, "classify", *paths, "--sdf", "1e-6", "--quiet", *flags], 300)
    found = list(csv.DictReader(line for line in done.stdout.splitlines() if not line.startswith("#")))
    checks.equal((done.returncode, len(found)), (0, len(points)), d, motion, *flags, done.stderr)
    return [(r["pmc"], F(r["sdf_low"]), F(r["sdf_high"])) for r in found]


def check_path(graze, folder, d, rigid, last, *flags):
    base = rows(graze, folder, d, even(d, rigid, last), *flags)
    for name, motion in (("plain", plain(d, rigid, last)), ("mirrored", mirrored(plain(d, rigid, last)))):
        if name == "mirrored" and last > 10 ** 13:
            continue  # doubles end where the denominator is smallest, unless that is at the beginning
        for one, (pmc, low, high) in zip(base, rows(graze, folder, d, motion, *flags)):
            where = (name, d, rigid, last, *flags, one, pmc, to_double(low), to_double(high))
            checks.holds(pmc == one[0] and low <= one[2] and one[1] <= high, *where)
            checks.holds(high - low <= TOLERANCE, *where)


def main():
    args = options(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        for d in (2, 3):
            for last in (10 ** 3, 10 ** 6, 10 ** 12, 10 ** 40):
                for rigid in (True, False):
                    check_path(args.graze, folder, d, rigid, last)
                check_path(args.graze, folder, d, True, last, "--operation", "unsweep")
    checks.finish()


if __name__ == "__main__":
    main()
