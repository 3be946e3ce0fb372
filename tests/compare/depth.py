#!/usr/bin/env python3
# suite
"""How deep wrong rows are, in the reports of graze validate and graze compare.

The sweep of a cube along a line is a box, whose signed distances are written down here in floats: outside that to the box, inside
the deepest place in a position. Quantiles are counted again from them.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import os
import re
import shlex
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from harness import Checks, options  # noqa: E402

CUBE = os.path.join(harness.ROOT, "tests", "refuse", "common", "cube.off")
WIDTH = 1e-9  # more than 1e-10 of the diagonal
checks = Checks()
check = checks.holds


def motion(folder, way):
    path = os.path.join(folder, "move.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": [way, "0", "0"]}}]}, file)
    return path


def distance(point):
    """s of the cube [0, 2]^3 that moves by 8 along x."""
    x, y, z = (to_double(F(c)) for c in point)
    out = [max(-c, c - high, 0) for c, high in ((x, 10), (y, 2), (z, 2))]
    inside = min(min(x, 10 - x, 1), y, 2 - y, z, 2 - z)
    return math.hypot(*out) if any(out) else -inside


def candidate(answer):
    line = f'{{ echo id,pmc; grep -v "^[x#]" "$1" | cut -d, -f4 | sed "s/$/,{answer}/"; }} >"$2"'
    return shlex.join(["sh", "-c", line, "sh"]) + " {points} {out}"


def validate(graze, move, answer, folder, *more):
    done = harness.run([graze, "validate", CUBE, move, "--quiet", "--keep", folder, "--candidate", candidate(answer), *more])
    check(done.returncode == 1, answer, done.stderr)
    return done.stdout


def golden_rows(folder):
    with open(os.path.join(folder, "golden.csv"), encoding="utf-8") as file:
        lines = [line.rstrip("\n").split(",") for line in file if not line.startswith("#")]
    return [dict(zip(lines[0], line)) for line in lines[1:]]


def near_above(told, right):
    """Two digits, rounded up from a bound that is at most WIDTH above."""
    return right * (1 - 1e-12) <= float(told) <= 1.1 * (right + WIDTH)


def check_depths(told, rows, answer, every):
    """Quantiles by golden answer of every so many wrong rows, in their order."""
    wrong = [r for r in rows if r["pmc"] != answer]
    measured = wrong[::every]
    check(told["wrong"] == len(wrong) and told["measured"] == len(measured), answer, told, len(wrong), len(measured))
    for pmc in ("in", "on", "out"):
        sizes = sorted(abs(distance((r["x"], r["y"], r["z"]))) for r in measured if r["pmc"] == pmc)
        check(told[pmc]["rows"] == len(sizes), pmc, told, len(sizes))
        for name, value in told[pmc]["quantiles"].items() if sizes else ():
            right = sizes[math.ceil(len(sizes) * int(name) / 100) - 1]
            check(near_above(value, right), answer, pmc, name, value, right)
        check(not sizes or near_above(told[pmc]["largest"], sizes[-1]), answer, pmc, told[pmc], sizes[-1:])


def reports(graze, folder, move):
    for answer, count in (("in", 500), ("out", 900), ("out", 4000)):
        out = validate(graze, move, answer, folder, "-n", str(count), "--show", "40", "--format", "json")
        told, rows = json.loads(out)["comparison"], golden_rows(folder)
        wrong = sum(r["pmc"] != answer for r in rows)
        check_depths(told["depth-of-wrong-rows"], rows, answer, 1 << max(0, math.ceil(math.log2(wrong / 1000))))
        for one in told["disagreements"]:
            low, high = (float(x) for x in re.search(r" sdf_low=(\S+) sdf_high=(\S+)$", one["golden"]).groups())
            right = distance(one["point"].split())
            check(low - 1e-12 <= right <= high + 1e-12 and high - low < WIDTH, one, right)
    text = validate(graze, move, "in", folder, "-n", "300")
    rows = [r for r in golden_rows(folder) if r["pmc"] != "in"]
    check(f"of {len(rows)} of {len(rows)} of them, by the golden answer:\n\n| golden pmc | rows | 50 % | 90 % | 99 % | largest |" in text, text)
    check(f"\n| on | {sum(r['pmc'] == 'on' for r in rows)} | 0 | 0 | 0 | 0 |\n" in text, text)


def tables(graze, folder, move):
    """A golden table with enclosures has the same depths, and one without has none."""
    validate(graze, move, "out", folder, "-n", "200")
    paths = [os.path.join(folder, name) for name in ("points.csv", "candidate.csv", "deep.csv")]
    harness.run([graze, "classify", CUBE, move, paths[0], "--sdf", "1e-10r", "--quiet", "-o", paths[2]])
    told = json.loads(harness.run([graze, "compare", paths[2], paths[1], "--format", "json"]).stdout)
    check_depths(told["depth-of-wrong-rows"], golden_rows(folder), "out", 1)
    check("sdf_low=" in told["disagreements"][0]["golden"], told["disagreements"][0])
    plain = json.loads(harness.run([graze, "compare", os.path.join(folder, "golden.csv"), paths[1], "--format", "json"]).stdout)
    check("depth-of-wrong-rows" not in plain and "sdf_low" not in plain["disagreements"][0]["golden"], plain)


def limits(graze, folder):
    """A motion of too high a degree: the report is whole, and says why it has no depths."""
    out = validate(graze, motion(folder, "8*t^33"), "in", folder, "-n", "60")
    check("\nDepth of the wrong rows: not measured, " in out and "| golden pmc | rows |" not in out, out)
    check("disagreements:" in out, out)


def main():
    graze = options(__doc__).graze
    with tempfile.TemporaryDirectory(prefix="graze depth ") as folder:
        move = motion(folder, "8*t")
        reports(graze, folder, move)
        tables(graze, folder, move)
        limits(graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
