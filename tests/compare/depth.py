#!/usr/bin/env python3
# suite
"""How deep wrong rows are, in the reports of graze validate and graze compare.

The sweep of a cube along a line is a box, whose signed distances are written down here in floats: outside that to the box, inside
the deepest place in a position. Quantiles are counted again from them.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
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
    """The report of a run that keeps its files, or with None of one that does not."""
    keep = ["--keep", folder] if folder else []
    done = harness.run([graze, "validate", CUBE, move, "--quiet", *keep, "--candidate", candidate(answer), *more])
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
    """Quantiles by golden answer over each `every`-th wrong row, in their order."""
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
    check(told["size"] == "3.46411e+00", "the diagonal of [0, 2]^3, 2 sqrt 3 = 3.464101..., rounded up", told)
    depths = [abs(distance((r["x"], r["y"], r["z"]))) for r in measured]
    for part, count in told["deeper-than"].items():   # but for rows within the enclosures' width of the part
        least, most = (sum(s > float(part) * math.sqrt(12) + by for s in depths) for by in (1e-12, -1e-12))
        check(least <= count <= most and (least > 0 or answer == "in"), part, count, least, most)


def check_order(told, rows, answer, show):
    """The deepest wrong rows, at most two of a stratum; rows of equal depth may change places."""
    wrong = sorted((r for r in rows if r["pmc"] != answer), key=lambda r: -abs(distance((r["x"], r["y"], r["z"]))))
    right, count = [], collections.Counter()
    for r in wrong:
        count[r["stratum"]] += 1
        if count[r["stratum"]] <= 2:
            right.append(abs(distance((r["x"], r["y"], r["z"]))))
    shown = [abs(distance(one["point"].split())) for one in told["disagreements"]]
    check(len(shown) == min(show, len(right)) and all(abs(a - b) < WIDTH for a, b in zip(shown, right)), answer, show, shown, right)
    strata = {(r["x"], r["y"], r["z"]): r["stratum"] for r in rows}
    named = collections.Counter(strata[tuple(str(F(c)) if c not in strata else c for c in one["point"].split())] for one in told["disagreements"])
    check(max(named.values()) <= 2, named)


def reports(graze, folder, move):
    for answer, count in (("in", 500), ("out", 900), ("out", 4000)):
        more = "-n", str(count), "--show", "40", "--format", "json"
        told, rows = json.loads(validate(graze, move, answer, folder, *more))["comparison"], golden_rows(folder)
        check_depths(told["depth-of-wrong-rows"], rows, answer, 1)   # the table that is kept has all
        check_order(told, rows, answer, 40)
        told = json.loads(validate(graze, move, answer, None, *more))["comparison"]
        wrong = sum(r["pmc"] != answer for r in rows)
        every = 1 << max(0, math.ceil(math.log2(wrong / 1000)))
        check_depths(told["depth-of-wrong-rows"], rows, answer, every)
        if every == 1:
            check_order(told, rows, answer, 40)
        for one in told["disagreements"]:
            low, high = (float(x) for x in re.search(r" sdf_low=(\S+) sdf_high=(\S+)$", one["golden"]).groups())
            right = distance(one["point"].split())
            check(low - 1e-12 <= right <= high + 1e-12 and high - low < WIDTH, one, right)
    told = json.loads(validate(graze, move, "in", folder, "-n", "500", "--show", "3", "--format", "json"))["comparison"]
    check_order(told, golden_rows(folder), "in", 3)
    text = validate(graze, move, "in", folder, "-n", "300")
    check("\nThe first 10 of " in text and " disagreements, the deepest wrong rows first, at most two of a stratum:\n" in text, text)
    rows = [r for r in golden_rows(folder) if r["pmc"] != "in"]
    check(f"of {len(rows)} of {len(rows)} of them, by the golden answer:\n\n| golden pmc | rows | 50 % | 90 % | 99 % | largest |" in text, text)
    check(f"\n| on | {sum(r['pmc'] == 'on' for r in rows)} | 0 | 0 | 0 | 0 |\n" in text, text)


def tables(graze, folder, move):
    """A golden table with enclosures has the same depths, and one without has none."""
    validate(graze, move, "out", folder, "-n", "200")
    paths = [os.path.join(folder, name) for name in ("points.csv", "candidate.csv", "deep.csv", "plain.csv", "golden.csv")]
    harness.run([graze, "classify", CUBE, move, paths[0], "--sdf", "1e-12r", "--quiet", "-o", paths[2]])
    harness.run([graze, "classify", CUBE, move, paths[0], "--quiet", "-o", paths[3]])
    rows = golden_rows(folder)
    for path in (paths[2], paths[4]):
        told = json.loads(harness.run([graze, "compare", path, paths[1], "--format", "json"]).stdout)
        check_depths(told["depth-of-wrong-rows"], rows, "out", 1)
        check_order(told, rows, "out", 10)
        check("sdf_low=" in told["disagreements"][0]["golden"], told["disagreements"][0])
    plain = json.loads(harness.run([graze, "compare", paths[3], paths[1], "--format", "json"]).stdout)
    check("depth-of-wrong-rows" not in plain and "sdf_low" not in plain["disagreements"][0]["golden"], plain)
    first = [r for r in rows if r["pmc"] != "out"][:10]
    check([one["point"].split() for one in plain["disagreements"]] == [[r[c] for c in "xyz"] for r in first], plain["disagreements"])
    text = harness.run([graze, "compare", paths[3], paths[1]]).stdout
    check(" disagreements, in the order of the tables, as the golden one has no sdf_low, sdf_high:\n" in text, text)
    with open(paths[2], encoding="utf-8") as file:
        lines = file.read().splitlines(keepends=True)
    check([line for line in lines if line.startswith("# diagonal ")] == ["# diagonal 3.464101615137754\n"], "2 sqrt 3 = 3.46410161513775458..., rounded down", lines[:14])
    with open(paths[3], "w", encoding="utf-8") as file:   # as it was before that line
        file.write("".join(line for line in lines if not line.startswith("# diagonal ")))
    text = harness.run([graze, "compare", paths[3], paths[1]]).stdout
    check("Not counted by parts of the size" in text and "the deepest wrong rows first" in text, text)
    # A row that is missing and one too many stand behind the wrong ones; without columns of strata all of a stratum are shown.
    with open(paths[1], encoding="utf-8") as file:
        mine = file.read().splitlines()
    fewer = os.path.join(folder, "fewer.csv")
    with open(fewer, "w", encoding="utf-8") as file:
        file.write("\n".join([mine[0], *mine[2:], "extra,out"]) + "\n")
    told = json.loads(harness.run([graze, "compare", paths[2], fewer, "--format", "json", "--show", "1000"]).stdout)
    kinds = [(one["golden"] is not None, one["candidate"] is not None) for one in told["disagreements"]]
    check(kinds[-2:] == [(True, False), (False, True)] and set(kinds[:-2]) == {(True, True)}, kinds)
    with open(paths[2], "w", encoding="utf-8") as file:
        file.write("".join(lines).replace(",stratum,", ",layer,"))
    told = json.loads(harness.run([graze, "compare", paths[2], paths[1], "--format", "json", "--show", "1000"]).stdout)
    shown = [abs(distance(one["point"].split())) for one in told["disagreements"]]
    check(len(shown) == told["wrong"] and all(a > b - WIDTH for a, b in zip(shown, shown[1:])), "all of them", len(shown), told["wrong"])


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
