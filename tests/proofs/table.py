#!/usr/bin/env python3
"""The C functions from word to i, t, k, case, class, membership and definition against those proved in Coq,
on all admissible words of up to 13 letters.

Coq computes its rows (proofs/coq/table.v, where the list of words is proved complete), the C functions
theirs (tests/proofs/table.c). make proofs has compiled both.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import os
import re

from coq import Checks, compile_file, harness

LONGEST = 13
COLUMNS = ("word", "i", "t", "k", "case", "class", "pmc", "definition", "class combined", "pmc combined",
           "definition combined", "unsweep")
PRINT = """Require Import String Graze.table.
Open Scope string_scope.
Set Printing Depth 100000.
Eval vm_compute in (rows {}).
"""


def rows_of_coq(build):
    folder = os.path.join(build, "proofs")
    with open(os.path.join(folder, "rows.v"), "w", encoding="utf-8") as file:
        file.write(PRINT.format(LONGEST))
    done = compile_file(folder, "rows.v")
    if done.returncode:
        raise SystemExit(f"rows.v: {done.stderr}")
    return [line.split(",") for line in re.findall(r'"([^"]*)"', done.stdout)]


def rows_of_c(build, words):
    done = harness.run([os.path.join(build, "tests", "proofs", "table")], input="".join(word + "\n" for word in words))
    if done.returncode:
        raise SystemExit(f"the C program ended with status {done.returncode}")
    return [line.split(",") for line in done.stdout.splitlines()]


def differences(coq, c):
    """Differences, as text, between Coq's rows and the C functions' two for each of them."""
    out = []
    if len(c) != 2 * len(coq):
        out.append(f"expected {2 * len(coq)} rows of C, found {len(c)}")
    for k, row in enumerate(c):
        for column, want, found in zip(COLUMNS, coq[k // 2], row):
            if want != found:
                out.append(f"{coq[k // 2][0]}: {column} is {want} in Coq, {found} in C")
    return out


def admissible(letters):
    """The number of admissible words of `letters` letters: every other letter is B, the rest I or O."""
    others = {(letters + 1) // 2, letters // 2} if letters % 2 else {letters // 2}
    return sum(2 ** n for n in others) * (2 if letters % 2 == 0 else 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", default="build")
    args = parser.parse_args()
    checks = Checks()
    coq = rows_of_coq(args.build)
    checks.holds(len(coq) == sum(admissible(n) for n in range(1, LONGEST + 1)),
                 f"{len(coq)} words of up to {LONGEST} letters")
    checks.holds(all(len(row) == len(COLUMNS) for row in coq), "every row has all columns")
    c = rows_of_c(args.build, [row[0] for row in coq])
    for row in c:
        checks.holds(len(row) == len(COLUMNS), f"columns of {row}")
    found = differences(coq, c)
    for line in found[:20]:
        print("FAILED", line)
    checks.holds(not found, f"{len(found)} differences")
    # A row of C that says something else in any one column is noticed.
    for column, name in enumerate(COLUMNS):
        other = [list(row) for row in c]
        other[len(c) // 2][column] += "x"
        checks.holds(len(differences(coq, other)) == len(found) + 1, f"a change of {name} goes unnoticed")
    print(f"{len(coq)} words, {len(c)} rows of C")
    checks.finish()


if __name__ == "__main__":
    main()
