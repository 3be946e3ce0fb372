#!/usr/bin/env python3
# suite
"""Enclosures of the distance against the closed forms that the READMEs of golden cases derive (C66 to C72).

SPDX-License-Identifier: GPL-3.0-or-later

The section `## Distances` of a case has a row `| id | s | derivation |` for each of its points. s is evaluated by
exact.py, without Graze. At each tolerance the row's sdf_low and sdf_high must hold s, be no farther apart than was
asked for, and have its sign.
"""
import csv
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
for folder in (("..", "lib"), ("..", "cases")):
    sys.path.insert(0, os.path.join(HERE, *folder))

import casefile  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from formbounds import form_bounds  # noqa: E402
from harness import ONLY, Checks, options, run  # noqa: E402

TOLERANCES = ("1e-1", "1e-3", "1e-6r", "1e-9", "1e-12")
LEAST = 12  # cases


def forms_of(case):
    """id -> the closed form, or None without the section."""
    with open(case.path("README.md"), encoding="utf-8") as file:
        _, found, rest = file.read().partition("## Distances\n")
    if not found:
        return None
    lines = [[cell.strip() for cell in line.strip("| \n").split("|")]
             for line in rest.partition("\n\n")[0].splitlines()]
    if lines[0] != ["id", "s", "derivation"] or any(len(line) != 3 for line in lines):
        raise casefile.CaseError(f"{case.name}: columns of the distances; expected id, s, derivation")
    return {line[0]: line[1] for line in lines[2:]}


def check_row(checks, where, form, row, tolerance):
    below, above = form_bounds(form)
    low, high = F(row["sdf_low"]), F(row["sdf_high"])
    checks.holds(low <= above and below <= high, *where, f"s = {form}", f"[{row['sdf_low']}, {row['sdf_high']}]")
    checks.holds(high - low <= tolerance, *where, "width", to_double(high - low))
    sign = "on" if below == above == 0 else "in" if above < 0 else "out" if below > 0 else "?"
    checks.equal(row["pmc"], sign, *where, "sign of the closed form")


def check_case(checks, graze, case, forms):
    checks.equal(list(forms), [id for id, _ in case.points], case.name, "ids of the distances")
    files = [case.path(f) for f in (case.solid, "motion.json", "points.csv")]
    for tolerance in TOLERANCES:
        done = run([graze, "classify", *files, *case.options, "--quiet", "--sdf", tolerance])
        if not checks.equal((done.returncode, done.stderr), (0, ""), case.name, tolerance):
            continue
        lines = done.stdout.splitlines()
        width = [F(line.split()[2]) for line in lines if line.startswith("# sdf ")]
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        checks.equal((len(width), len(rows)), (1, len(forms)), case.name, "rows")
        for (id, form), row in zip(forms.items(), rows):
            check_row(checks, (case.name, id, tolerance), form, row, width[0])


def main():
    args, checks, count = options(__doc__, ONLY), Checks(), 0
    for name in casefile.names():
        if args.only not in name:
            continue
        case = casefile.Case(name)
        forms = forms_of(case)
        if forms is not None:
            check_case(checks, args.graze, case, forms)
            count += 1
    print(f"{count} cases with closed forms")
    if not args.only:
        checks.holds(count >= LEAST, f"{count} cases with closed forms, expected at least {LEAST}")
    checks.finish()


if __name__ == "__main__":
    main()
