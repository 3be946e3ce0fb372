"""Graze against the golden tables of cases/: rows, words, times and cells, and what they cover.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

Each case is run as a table, which must be expected.csv byte for byte, and as JSON Lines, whose
words, times and cells must be those the README derives. Times are compared exactly (times.py). All
84 (definition, case, dimension) combinations must occur, of polyhedra and of curved solids.
"""
import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import casefile  # noqa: E402
from harness import ONLY, Checks, options, run  # noqa: E402
from times import given_time, same_time  # noqa: E402
from words import combinations  # noqa: E402


def classify(graze, case, *more):
    files = [case.path(f) for f in (case.solid, "motion.json", "points.csv")]
    return run([graze, "classify", *files, *case.options, *more], text=False)


def cells_of(features):
    """The cells of a contact as the README writes them."""
    out = []
    for feature in features:
        (kind, number), = feature.items()
        out.append(f"{kind} " + ("-".join(map(str, number)) if kind == "edge" else str(number)))
    return " ".join(out)


def check_files(checks, case):
    checks.equal(case.unused, [], case.name, "files that belong to no case")
    ids = [id for id, _ in case.points]
    checks.equal(len(set(ids)), len(ids), case.name, "each id once")
    checks.equal(sorted(case.table), sorted(ids), case.name, "points of the README's table")
    checks.equal([row.get("id") for row in case.expected], ids, case.name, "points of expected.csv")


def check_made(checks, case):
    """The solid is what make.py, where there is one, writes."""
    program = case.path("make.py")
    if os.path.exists(program):
        done = run([sys.executable, "-B", program], text=False)
        with open(case.path(case.solid), "rb") as file:
            checks.holds(done.stdout == file.read(), case.name, "make.py writes another solid", done.stderr)


def check_table(checks, graze, case):
    done = classify(graze, case)
    checks.equal(done.returncode, 0, case.name, done.stderr.decode("utf-8", "replace"))
    lines = done.stdout.splitlines(keepends=True)
    got = [line for line in lines if not line.startswith(b"#")]
    with open(case.path("expected.csv"), "rb") as file:
        want = file.readlines()
    checks.equal(len(got), len(want), case.name, "lines of the table")
    for g, w in zip(got, want):
        checks.equal(g, w, case.name, "row")


def check_record(checks, case, id, record):
    word, spans, cells = case.table.get(id, ("", [], None))
    checks.equal(record["word"], word, case.name, id, "word")
    contacts = record["contacts"]
    if not checks.equal(len(contacts), len(spans), case.name, id, "number of contacts"):
        return
    for contact, (low, high) in zip(contacts, spans):
        for got, want in ((contact["from"], low), (contact["to"], high)):
            checks.holds(same_time(given_time(got), want), f"{got} is not {want}", case.name, id)
    if cells:
        got = [cells_of(contact["features"]) for contact in contacts]
        checks.equal(got, cells, case.name, id, "cells")


def check_records(checks, graze, case):
    done = classify(graze, case, "--format", "jsonl")
    checks.equal(done.returncode, 0, case.name, "jsonl")
    lines = done.stdout.decode().splitlines()
    checks.equal(len(lines), len(case.points), case.name, "lines of JSON")
    for (id, _), line in zip(case.points, lines):
        check_record(checks, case, id, json.loads(line))


def covered(case):
    """The combinations of a case's rows; a README that has another operation covers none."""
    if case.option("--operation", "sweep") == "unsweep":
        return set()
    out = set()
    for row in case.expected:
        name = f"ext {row['class']}" if row["definition"] == "ext" else row["definition"]
        out.add((name, int(row["case"]), case.dimension))
    return out


def main():
    args, checks, points = options(__doc__, ONLY), Checks(), 0
    seen = {False: set(), True: set()}
    for name in casefile.all_names():
        if args.only not in name:
            continue
        try:
            case = casefile.Case(name)
        except (casefile.CaseError, ValueError, OSError) as wrong:
            checks.holds(False, str(wrong), name)
            continue
        check_files(checks, case)
        check_made(checks, case)
        check_table(checks, args.graze, case)
        check_records(checks, args.graze, case)
        seen[casefile.is_curved(name)] |= covered(case)
        points += len(case.points)
    want = combinations()
    for curved, found in seen.items():
        kind = "curved solids" if curved else "polyhedra"
        print(f"{kind}: {len(found & want)} of {len(want)} combinations of definition, case and dimension")
        if not args.only:
            checks.equal(sorted(want - found), [], kind, "combinations that no case shows")
            checks.equal(sorted(found - want), [], kind, "combinations that cannot be")
    print(f"{points} points")
    checks.finish()


if __name__ == "__main__":
    sys.exit(main())
