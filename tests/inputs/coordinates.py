#!/usr/bin/env python3
# suite
"""Forms of coordinates: --coordinates and --digits of graze classify and graze generate.

What stands in the rows is computed here with Python's fractions and decimals; the answers are those of the plain table.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import decimal
import os
import pathlib
import sys
import tempfile
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import Checks, options, run  # noqa: E402
from machine import MPI_ENVIRONMENT, ranks  # noqa: E402

COMMON = pathlib.Path(__file__).resolve().parents[1] / "refuse" / "common"
CASES = COMMON.parents[2] / "cases" / "bracket"
SPACE = COMMON / "cube.off", COMMON / "move3.json"
PLANE = COMMON / "square.wkt", COMMON / "move2.json"
TOKENS = ["1", "+3", "0.10", ".5", "5.", "1.5e-3", "22/7", "-4/6", "-0", "1e2", "00.250", "7E1", "100000000000000000000", "1e-12"]
FINITE = [token for token in TOKENS if "/" not in token]
checks = Checks()
check = checks.holds


def call(graze, *words, status=0, stdin=None):
    done = run([graze, *map(str, words)], 120, stdin=stdin)
    check(done.returncode == status, words, done.returncode, done.stderr)
    return done.stdout, done.stderr


def table(text):
    """(head lines, names, rows) of a table."""
    lines = text.splitlines()
    rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    return [line for line in lines if line.startswith("#")], rows[0], rows[1:]


def points(path, tokens, note=True):
    """A file of points of the plane, every token in both columns, between semicolons and in quotes too."""
    rows = [f"{a},{tokens[-1 - k]}" + (f',"n, {k}"' if note else "") for k, a in enumerate(tokens)]
    path.write_text("\n".join(["x,y,note" if note else "x,y", *rows]) + "\n")
    return [(a, tokens[-1 - k]) for k, a in enumerate(tokens)]


def rounded(value, digits):
    """The nearest decimal of `digits` digits, ties to even."""
    context = decimal.Context(prec=digits, rounding=decimal.ROUND_HALF_EVEN)
    return Fraction(context.divide(decimal.Decimal(value.numerator), decimal.Decimal(value.denominator)))


def as_given(graze, folder):
    path = folder / "given.csv"
    want = points(path, TOKENS)
    head, names, plain = table(call(graze, "classify", *PLANE, path, "--coordinates", "exact")[0])
    text = call(graze, "classify", *PLANE, path, "--coordinates", "as-given", "--jobs", "3")[0]
    check(text == call(graze, "classify", *PLANE, path)[0], "the default")
    got = table(text)
    check("# coordinates as-given" in got[0], got[0])
    check([line for line in got[0] if "coordinates" not in line] == head, "the rest of the head", got[0], head)
    check(got[1] == names, names)
    check([tuple(row[:2]) for row in got[2]] == want, "tokens", [row[:2] for row in got[2]])
    check([row[2:] for row in got[2]] == [row[2:] for row in plain], "answers")
    # Columns in another order, in quotes and between semicolons.
    path.write_text('note;"y";x\n' + "".join(f'n;"{b}"; {a} \n' for a, b in want))
    again = table(call(graze, "classify", *PLANE, path, "--coordinates", "as-given")[0])
    check([tuple(row[:2]) for row in again[2]] == want, "quoted", again[2][:3])


def exact_by_default(graze, folder):
    """Tables beside certificates, of rounded points and of grids, and all forms but CSV, as with exact coordinates."""
    path, proof = folder / "exact.csv", folder / "proof"
    points(path, TOKENS)
    for words in ([path, "--certify", proof], [path, "--round", "binary64"], ["--grid", "3,3"], [path, "--format", "jsonl"],
                  [path, "--format", "vtk"], [path, "--format", "npy"]):
        text = call(graze, "classify", *PLANE, *words)[0]
        check(text == call(graze, "classify", *PLANE, *words, "--coordinates", "exact")[0] and "as-given" not in text, words)


def as_decimal(graze, folder):
    path = folder / "decimal.csv"
    want = points(path, FINITE)
    plain = table(call(graze, "classify", *PLANE, path)[0])[2]
    text, said = call(graze, "classify", *PLANE, path, "--coordinates", "decimal")
    head, _, rows = table(text)
    check("# coordinates decimal" in head and "rounded" not in said, head, said)
    for row, (a, b), exact in zip(rows, want, plain):
        check("/" not in row[0] + row[1] and [Fraction(x) for x in row[:2]] == [Fraction(a), Fraction(b)], row, a, b)
        check(row[2:] == exact[2:], row, exact)
    points(path, TOKENS)
    _, said = call(graze, "classify", *PLANE, path, "--coordinates", "decimal", status=3)
    check("decimal.csv:8: x has no finite decimal; expected --digits N, which rounds it, or --coordinates exact" in said, said)
    for digits in (1, 5, 17, 400):
        want = points(path, TOKENS)
        text, said = call(graze, "classify", *PLANE, path, "--coordinates", "decimal", "--digits", digits)
        head, _, rows = table(text)
        check(f"# coordinates decimal {digits}" in head, head)
        check(f"note: coordinates of more than {digits} digits are rounded" in said, said)
        check([[Fraction(x) for x in row[:2]] for row in rows] ==
              [[rounded(Fraction(a.rstrip(".")), digits) for a in pair] for pair in want], digits, rows)
        exact = table(call(graze, "classify", *PLANE, path)[0])[2]
        check([row[2:] for row in rows] == [row[2:] for row in exact], "answers are those of the exact points", digits)
    grid = call(graze, "classify", *PLANE, "--grid", "4,4", "--box", "0,0,3/4,3/8", "--coordinates", "decimal")[0]
    check([row[:2] for row in table(grid)[2][:5]] == [["0", "0"], ["0.25", "0"], ["0.5", "0"], ["0.75", "0"], ["0", "0.125"]], grid)
    alone = call(graze, "classify", *PLANE, "--grid", "4,4", "--box", "0,0,3/4,3/8", "--coordinates", "decimal", "--columns", "pmc")[0]
    check([row[:3] for row in table(alone)[2]] == [row[:3] for row in table(grid)[2]], "pmc alone", alone)
    _, said = call(graze, "classify", *PLANE, "--grid", "4,4", "--box", "0,0,1,1", "--coordinates", "decimal", status=3)
    check("row 2: x has no finite decimal" in said, said)


def parts(graze, folder, form):
    """Shards, a continued table and ranks give the bytes of one run; golden tables in this form are points again."""
    path, whole, cut = folder / "parts.csv", folder / "whole.csv", folder / "cut.csv"
    tokens = FINITE if form == ["--coordinates", "decimal"] else TOKENS
    path.write_text("x,y,z,note\n" + "".join(f"{a},{b},{tokens[(k + 3) % len(tokens)]},{k}\n" for k, (a, b) in
                                             enumerate((a, b) for a in tokens for b in tokens)))
    call(graze, "classify", *SPACE, path, *form, "--output", whole)
    pieces = [folder / f"part{k}.csv" for k in (1, 2)]
    for k, piece in enumerate(pieces, 1):
        call(graze, "classify", *SPACE, path, *form, "--shard", f"{k}/2", "--output", piece)
    merged = call(graze, "merge", *pieces)[0]
    check(merged == whole.read_text(), form, "merged")
    lines = whole.read_text().splitlines(keepends=True)
    cut.write_text("".join(lines[:-40]))
    call(graze, "classify", *SPACE, path, *form, "--resume", cut)
    check(cut.read_text() == whole.read_text(), form, "continued")
    for wrong in ("x", "1/2/3", "+"):
        bad = [line.replace(line.split(",")[0], wrong, 1) if line[0] != "#" and k == 40 else line
               for k, line in enumerate(pieces[0].read_text().splitlines(keepends=True))]
        (folder / "bad.csv").write_text("".join(bad))
        _, said = call(graze, "merge", folder / "bad.csv", pieces[1], status=3)
        check("bad.csv: was changed" in said, wrong, said)
    cut.write_text("".join(lines[:20]) + lines[20].replace(lines[20].split(",")[0], "7", 1) + lines[21])
    _, said = call(graze, "classify", *SPACE, path, *form, "--resume", cut, status=3)
    check("cut.csv:21: `7," in said and "expected a table of this run" in said, said)
    again = call(graze, "classify", *SPACE, whole)[0]
    check(len(again.splitlines()) == len(lines) and "column" not in again, "as points", form)
    started = ranks(checks, graze, 3)
    if started:
        done = run([*started, *SPACE, path, *form], 300, env=MPI_ENVIRONMENT)
        check(done.stdout == whole.read_text(), "by ranks", form, done.stderr)
    done = run([graze, "compare", str(whole), str(whole)], 60)
    check(done.returncode == 0, form, "compare", done.stderr, done.stdout[-300:])


def generated(graze):
    """Points of generate are the plain ones, as decimals."""
    words = ["generate", CASES / "solid.off", CASES / "motion.json", "-n", "200", "--seed", "4"]
    plain = table(call(graze, *words, "--representable", "binary64")[0])[2]
    head, _, rows = table(call(graze, *words, "--representable", "binary64", "--coordinates", "decimal")[0])
    check("# coordinates decimal" in head, head)
    check([row[3:] for row in rows] == [row[3:] for row in plain], "columns behind the point")
    check(all(Fraction(a) == Fraction(b) and "/" not in a for row, want in zip(rows, plain) for a, b in zip(row[:3], want[:3])),
          "values", rows[:3])
    plain = table(call(graze, *words)[0])[2]
    _, said = call(graze, *words, "--coordinates", "decimal", status=3)
    first = next(k for k, row in enumerate(plain, 1) for x in row[:3] if not finite(Fraction(x)))
    check(f"point {first}: " in said and "has no finite decimal; expected --digits N" in said, said, first)
    text, said = call(graze, *words, "--coordinates", "decimal", "--digits", "9")
    head, _, rows = table(text)
    check("# coordinates decimal 9" in head and "need not be at the contact" in said, head, said)
    check(all(Fraction(a) == rounded(Fraction(b), 9) for row, want in zip(rows, plain) for a, b in zip(row[:3], want[:3])),
          "rounded", rows[:3])


def finite(value):
    rest = value.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    return rest == 1


def main():
    graze = options(__doc__).graze
    with tempfile.TemporaryDirectory(prefix="graze-coordinates-") as name:
        folder = pathlib.Path(name)
        as_given(graze, folder)
        exact_by_default(graze, folder)
        as_decimal(graze, folder)
        for form in (["as-given"], ["decimal"], ["decimal", "--digits", "3"]):
            parts(graze, folder, ["--coordinates", *form])
        generated(graze)
    checks.finish()


if __name__ == "__main__":
    main()
