#!/usr/bin/env python3
"""# suite: graze compare --candidate-has sdf: errors of value against enclosures, and motion errors.

Golden tables are made here with random enclosures over 400 decades, candidates with random errors on both sides; every
figure of the JSON report is counted again with fractions and sorted lists. Then a cube that slides, whose distances
are evident, is judged by compare, by validate and from Python.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import os
import random
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "lib"))

import harness  # noqa: E402
from exact import Fraction as F  # noqa: E402
from harness import Checks, options  # noqa: E402

CUBE = os.path.join(HERE, "..", "refuse", "common", "cube.off")  # [0, 2]^3
QUANTILES = {"50": F(1, 2), "90": F(9, 10), "99": F(99, 100), "99.9": F(999, 1000)}
STRATA = ("near", "miss", "10", "9")
checks = Checks()


def decade(x):
    """The k with 10^k <= x < 10^(k + 1), from the written number of a long division."""
    k = 0
    while x >= 10:
        x, k = x / 10, k + 1
    while x < 1:
        x, k = x * 10, k - 1
    return k


def up(x, digits):
    """The least number of `digits` digits that is not below x."""
    unit = F(10) ** (decade(x) - digits + 1) if x else 1
    return math.ceil(x / unit) * unit


def number(text):
    return F(text)


def decimal(x):
    """A token with the value x, written in one of the forms that are allowed."""
    if random.random() < 0.2:
        return str(x)
    places = 0
    while (x * 10 ** places).denominator != 1:
        places += 1
    return f"{x * 10 ** places}e{-places}"


def make_row(chance, k):
    """(golden row, value or None, s may be as low and as high)"""
    pmc = chance.choice(("in", "on", "out"))
    size = F(chance.randint(1, 10 ** 6)) * F(10) ** chance.randint(-130, 110)
    width = size * F(chance.choice((0, 1, 10 ** 5)), 10 ** 6)
    low, high = {"in": (-size - width, -size), "on": (F(0), F(0)), "out": (size, size + width)}[pmc]
    error = F(chance.randint(1, 10 ** 9)) * F(10) ** chance.randint(-115, 92)
    value = chance.choice((low, high, (low + high) / 2, low - error, high + error, -low))
    return {"id": str(k), "pmc": pmc, "low": low, "high": high, "value": value if chance.random() < 0.95 else None,
            "stratum": chance.choice(STRATA), "k": chance.choice(("", "4", "12"))}


def expected_errors(rows, tolerance, eta, outside):
    """The members of a report's errors, of rows that have a value."""
    sizes, over = [], F(0)
    told = {"values": 0, "within": 0, "over": 0, "under": 0, "beyond": 0}
    for row in rows:
        if row["value"] is None or (outside and row["pmc"] != "out"):
            continue
        low, high = row["low"] - eta, row["high"] + eta
        size = max(F(0), row["value"] - high, low - row["value"])
        side = "over" if row["value"] > high else "under" if row["value"] < low else "within"
        told["values"] += 1
        told[side] += 1
        told["beyond"] += tolerance is not None and size > tolerance
        over = max(over, size) if side == "over" else over
        sizes.append(size)
    if tolerance is None:
        del told["beyond"]
    sizes.sort()
    told["quantiles"] = {}
    for name, share in QUANTILES.items():
        size = sizes[max(0, math.ceil(share * len(sizes)) - 1)] if sizes else F(0)
        size = up(size, 2) if size else size
        size = max(size, F(10) ** -99) if size else size
        told["quantiles"][name] = up(sizes[-1], 6) if size >= F(10) ** 100 else size
    told["largest"] = up(sizes[-1], 6) if sizes and sizes[-1] else F(0)
    told["largest-over"] = up(over, 6) if over else F(0)
    return told


def values_of(report):
    """These members of a report as numbers."""
    told = {k: report[k] for k in ("values", "within", "over", "under", "beyond") if k in report}
    told["quantiles"] = {k: F(v) for k, v in report["quantiles"].items()}
    told["largest"], told["largest-over"] = F(report["largest"]), F(report["largest-over"])
    return told


def decade_name(row):
    if row["pmc"] == "on":
        return "0"
    size = -row["low"] if row["pmc"] == "in" else row["high"]
    return ("-" if row["pmc"] == "in" else "") + f"1e{decade(size):+03d}"


def sign(value):
    return "in" if value < 0 else "out" if value > 0 else "on"


def is_certain(row, eta):
    if not eta:
        return True
    return row["low"] > eta if row["pmc"] == "out" else row["high"] < -eta if row["pmc"] == "in" else False


def expect_counts(rows, tolerance, eta, outside):
    n = {"rows": len(rows), "agree": 0, "wrong": 0, "missing": 0, "undecided": 0, "undecided-by-motion-error": 0}
    for row in rows:
        certain = is_certain(row, eta)
        n["undecided-by-motion-error"] += not certain
        if row["value"] is None:
            n["missing"] += 1
            continue
        judged = tolerance is not None and (row["pmc"] == "out" or not outside)
        miss = max(F(0), row["value"] - row["high"] - eta, row["low"] - eta - row["value"])
        if (certain and sign(row["value"]) != row["pmc"]) or (judged and miss > tolerance):
            n["wrong"] += 1
        else:
            n["agree" if certain else "undecided"] += 1
    return n


def check_random(graze, folder, seed):
    chance = random.Random(seed)
    random.seed(seed)
    rows = [make_row(chance, k) for k in range(400)]
    tolerance = chance.choice((None, F(0), F(1, 10 ** 3), F(10) ** 50))
    eta = chance.choice((F(0), F(1, 3), F(10) ** 20))
    outside = chance.random() < 0.4
    golden, candidate = os.path.join(folder, "golden.csv"), os.path.join(folder, "candidate.csv")
    with open(golden, "w", encoding="utf-8") as f:
        f.write("x,y,id,pmc,stratum,k,sdf_low,sdf_high\n")
        for row in rows:
            f.write(f"0,0,{row['id']},{row['pmc']},{row['stratum']},{row['k']},{decimal(row['low'])},{decimal(row['high'])}\n")
        f.write(f"# complete {len(rows)}\n")
    with open(candidate, "w", encoding="utf-8") as f:
        f.write("id,sdf\n")
        f.writelines(f"{row['id']},{decimal(row['value'])}\n" for row in rows if row["value"] is not None)
    ask = ["--candidate-has", "sdf", "--format", "json"]
    ask += ["--sdf-tolerance", str(tolerance)] if tolerance is not None else []
    ask += ["--motion-error", str(eta)] if eta else []
    ask += ["--truth", "outside"] if outside else []
    label = f"seed {seed} {ask}"
    done = harness.run([graze, "compare", golden, candidate, *ask], 300)
    n = expect_counts(rows, tolerance, eta, outside)
    checks.equal(done.returncode, 1 if n["wrong"] or n["missing"] else 0, label, done.stderr)
    report = json.loads(done.stdout)
    checks.equal({k: report.get(k, 0) for k in n}, n, label)
    check_groups(report["errors-of-sdf"], rows, label, tolerance, eta, outside)
    text = harness.run([graze, "compare", golden, candidate, *ask[:2], *ask[4:]], 300).stdout
    e = report["errors-of-sdf"]
    line = f"| all | {e['values']} | {e['within']} | {e['over']} | {e['under']} | {e.get('beyond', '-')} |"
    checks.holds(line in text and f"| {e['largest']} | {e['largest-over']} |" in text, label, line)


def check_groups(report, rows, label, tolerance, eta, outside):
    checks.equal(values_of(report), expected_errors(rows, tolerance, eta, outside), label)
    names = {"stratum": lambda r: r["stratum"], "k": lambda r: r["k"], "sdf": decade_name}
    for by, name in names.items():
        told = {g["value"]: values_of(g) for g in report["by"][by]}
        groups = {}
        for row in rows:
            if name(row) or by != "k":
                groups.setdefault(name(row), []).append(row)
        wanted = {g: expected_errors(some, tolerance, eta, outside) for g, some in groups.items()}
        wanted = {g: e for g, e in wanted.items() if e["values"]}
        checks.equal(told, wanted, label, by)
    order = [float(g["value"]) for g in report["by"]["sdf"]]
    checks.equal(order, sorted(order), label, "decades in order")


# Points about the cube that slides by 8 along x, s by its definition, a value, and its error.
SLIDE = '{"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["8*t", 0, 0]}}]}'
ROWS = [("5,3,1", F(1), "1.1"), ("13,6,1", F(5), "5"), ("5,1,1", F(-1), "-1.5"), ("5,1,2", F(0), "0.0001"),
        ("1/3,1,1", F(-1, 3), "-1/3"), ("5,1,5/2", F(1, 2), ".4")]


def check_scene(graze, folder):
    path = {name: os.path.join(folder, name) for name in ("slide.json", "p.csv", "golden.csv", "mine.csv", "plain.csv")}
    for name, text in (("slide.json", SLIDE), ("p.csv", "".join(r[0] + "\n" for r in ROWS)),
                       ("mine.csv", "x,y,z,sdf\n" + "".join(f"{r[0]},{r[2]}\n" for r in ROWS))):
        with open(path[name], "w", encoding="utf-8") as f:
            f.write(text)
    scene = CUBE, path["slide.json"]
    for name, more in (("golden.csv", ("--sdf", "1e-9")), ("plain.csv", ())):
        done = harness.run([graze, "classify", *scene, path["p.csv"], "-o", path[name], *more], 300)
        checks.equal(done.returncode, 0, done.stderr)
    ask = ["compare", path["golden.csv"], path["mine.csv"], "--candidate-has", "sdf", "--format", "json"]
    report = json.loads(harness.run([graze, *ask], 300).stdout)
    checks.equal([report["wrong"], report["agree"]], [1, 5], "the sign of 0.0001 for `on` is wrong")
    misses = [abs(F(v) - s) for _, s, v in ROWS]
    e = report["errors-of-sdf"]
    checks.equal([e["within"], e["over"], e["under"]], [2, 2, 2], e)
    checks.holds(F(1, 2) - F(1, 10 ** 8) <= F(e["largest"]) <= max(misses), e["largest"])
    checks.holds(F(1, 10) - F(1, 10 ** 8) <= F(e["largest-over"]) <= F(1, 10), e["largest-over"])
    for tolerance, wrong in (("0.45", 2), ("0.05", 4), ("0.6", 1)):  # the wrong sign, and those off by more
        done = harness.run([graze, *ask, "--sdf-tolerance", tolerance], 300)
        checks.equal(json.loads(done.stdout)["wrong"], wrong, tolerance)
    done = harness.run([graze, *ask, "--motion-error", "0.6"], 300)
    report = json.loads(done.stdout)
    checks.equal([done.returncode, report["undecided"], report["undecided-by-motion-error"]], [0, 3, 3], "|s| <= 0.6 three times")
    plain = harness.run([graze, *ask[:1], path["plain.csv"], *ask[2:], "--sdf-tolerance", "1"], 300)
    checks.holds(plain.returncode == 3 and "has no columns sdf_low and sdf_high" in plain.stderr, plain.stderr)
    done = harness.run([graze, *ask[:1], path["plain.csv"], *ask[2:]], 300)
    checks.holds("errors-of-sdf" not in json.loads(done.stdout), "signs alone where there are no enclosures")
    check_validate(graze, scene, path)


def check_validate(graze, scene, path):
    ask = [graze, "validate", *scene, "--points", path["p.csv"], "--candidate", f"sh -c 'cp \"$0\" \"$2\"' {path['mine.csv']} {{points}} {{out}}",
           "--candidate-has", "sdf", "--format", "json", "--quiet"]
    done = harness.run(ask, 300)
    report = json.loads(done.stdout)["comparison"]["errors-of-sdf"]
    checks.equal([report["within"], report["over"], report["under"]], [2, 2, 2], done.stderr)
    done = harness.run([*ask, "--sdf-tolerance", "0.05", "--sdf", "1e-3", "--truth", "outside"], 300)
    report = json.loads(done.stdout)["comparison"]
    checks.equal([report["errors-of-sdf"]["values"], report["wrong"]], [3, 3],
                 "1.1 and .4 miss by 0.1 - 1e-3 or more; the sign of 0.0001 stays wrong")


def main():
    args = options(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        for seed in args.rounds(12):
            check_random(args.graze, folder, seed)
        if args.derived:
            check_scene(args.graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
