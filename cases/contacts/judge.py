#!/usr/bin/env python3
"""Judges FCL and Bullet by the pairs of golden.py, family by family.

    python3 cases/contacts/judge.py OUT [--count N]

OUT is the folder that golden.py made. Compiles cases/candidates/fcl.cpp and bullet.cpp (Debian's libfcl-dev, libbullet-dev and
libyajl-dev; what is not installed is left out, and it says so), asks them about the first N pairs of each family, Bullet about those
of convex solids, and prints the table of README.md.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import csv
import json
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "candidates"))

import fcl  # noqa: E402
from golden import near  # noqa: E402

METHODS = (("fcl", "mesh", "advance", 1), ("fcl", "mesh", "advance", 64), ("fcl", "mesh", "discrete", 1000), ("bullet", "hull", "advance", 64))
CONVEX = {"boxes", "box", "tetrahedron", "octahedron", "prism", "ball", "dart", "box on box", "box beside box", "edges cross", "edges graze"}


class Golden(fcl.Truth):
    """The pair word over the motion's time from 0 to 1, from a golden answer."""

    def __init__(self, record, start, end):  # pylint: disable=super-init-not-called
        def share(time):
            return (near(time) - start) / (end - start)

        self.verdict, self.word = record["verdict"], record["word"]
        self.contacts = [(share(c["from"]), share(c["to"])) for c in record["contacts"]]
        self.first = self.contacts[0][0] if self.contacts else None


def is_convex(kind):
    return kind in CONVEX or kind.startswith("tip ") or all(part in CONVEX for part in kind.split(" and "))


def span(path):
    with open(path, encoding="ascii") as file:
        pieces = json.load(file)["pieces"]
    return tuple(float(fcl.F(t)) for t in (pieces[0]["t"][0], pieces[-1]["t"][1]))


def judge_pair(out, pair, record, programs, tally, methods):
    paths = [os.path.join(out, pair[name]) for name in ("moving", "motion", "fixed")]
    start, end = span(paths[1])
    truth = Golden(record, start, end)
    if truth.word[0] != "O":  # codes say that it begins in contact, or that the first time is 0: no family is about that
        return
    asked = [m for m in methods if m[0] != "bullet" or is_convex(pair["kind"])]
    for method, (hit, t) in fcl.answers(programs, asked, paths).items():
        tally.add(pair["family"], method, *fcl.judge(truth, hit, (t - start) / (end - start)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("out", help="the folder that golden.py made")
    parser.add_argument("--count", type=int, default=100, help="pairs of each family (100)")
    options = parser.parse_args()
    with open(os.path.join(options.out, "golden.jsonl"), encoding="utf-8") as file:
        golden = {record["id"]: record for record in map(json.loads, file)}
    with open(os.path.join(options.out, "pairs.csv"), encoding="ascii", newline="") as file:
        pairs = list(csv.DictReader(file))
    with tempfile.TemporaryDirectory() as folder:
        programs = fcl.compile_codes(folder)
        methods = [m for m in METHODS if m[0] in programs]
        tally = fcl.Tally()
        fcl.print_row("family", *(f"{code} {method} {n}, {shape}" for code, shape, method, n in methods))
        print("|---" * (1 + len(methods)) + "|")
        for family in dict.fromkeys(pair["family"] for pair in pairs):
            for pair in [pair for pair in pairs if pair["family"] == family][:options.count]:
                judge_pair(options.out, pair, golden[pair["id"]], programs, tally, methods)
            fcl.print_row(family, *(cell(tally, family, m) for m in methods))


def cell(tally, family, method):
    asked = sum(tally.counts.get((family, method), {}).values())
    return f"{tally.cell(family, method)} of {asked}" if asked else "none is convex"


if __name__ == "__main__":
    main()
