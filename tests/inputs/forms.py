#!/usr/bin/env python3
# suite
"""Forms of a file of points: separators, names in capitals, and what looks like points but is not.

The same points in every form give the rows of the plain form; further columns are read back by Python's csv. Where two
readings are possible, or a number is none, the message says so. SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import os
import pathlib
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import Checks, options, run  # noqa: E402

COMMON = pathlib.Path(__file__).resolve().parents[1] / "refuse" / "common"
SCENE = COMMON / "square.wkt", COMMON / "move2.json"
checks = Checks()
check = checks.holds


def classify(graze, folder, data):
    """(status, rows as lists, what is said) of a file with these bytes."""
    path = folder / "points.csv"
    path.write_bytes(data if isinstance(data, bytes) else data.encode())
    done = run([graze, "classify", *map(str, SCENE), str(path)], 60)
    lines = [line for line in done.stdout.splitlines() if not line.startswith("#")]
    return done.returncode, list(csv.reader(lines)), done.stderr


def taken(graze, folder):
    plain = classify(graze, folder, "x,y,name,note\n1,3,a,b\n5/2,1e0,c,d\n")
    check(plain[0] == 0 and len(plain[1]) == 3, plain)
    for separator in (";", " ", "\t", "   \t", " ; "):
        rows = [separator.join(row) for row in (("x", "y", "name", "note"), ("1", "3", "a", "b"), ("5/2", "1e0", "c", "d"))]
        for end in ("\n", "\r\n"):
            got = classify(graze, folder, end.join(rows) + end)
            cells = [[cell.strip() for cell in row] for row in got[1]]
            check(got[0] == 0 and cells == plain[1], repr(separator), got)
    bare = classify(graze, folder, "1,3\n5/2,1\n")
    for text in ("1 3\n5/2 1\n", "1;3\n5/2;1\n", "  1\t3  \n\n5/2\t\t1\n", "# a comment, with commas\n1 3\n5/2 1\n"):
        got = classify(graze, folder, text)
        check(got[:2] == bare[:2], repr(text), got)
    got = classify(graze, folder, "Y,X,note\n3,1,a\n")
    check(got[0] == 0 and got[1][1][:2] == ["1", "3"] and got[1][0][-1] == "note", "capitals", got)
    got = classify(graze, folder, "x,y,X\n1,3,a\n")
    check(got[0] == 0 and got[1][0][-1] == "X" and got[1][1][-1] == "a", "capitals beside names", got)


def carried(graze, folder):
    """Commas and quotes of further columns come through."""
    for text, want in (('x;y;note\n1;3;a,b\n', "a,b"), ('x;y;note\n1;3;"a;b, ""c"""\n', 'a;b, "c"'),
                       ('x;y;note\n1;3;say "a,b"\n', 'say "a,b"'), ('x y note\n1 3 "a,b\n', '"a,b'),
                       ('x y note\n1 3 "a"\n', '"a"'), ('x y note\n1 3 ,,,\n', ",,,")):
        got = classify(graze, folder, text)
        check(got[0] == 0 and got[1][1][-1] == want and len(got[1][1]) == len(got[1][0]), text, got)
    got = classify(graze, folder, 'x;y;"a,b";"c, ""d"""\n1;3;4;5\n')
    check(got[1][0][-2:] == ["a,b", 'c, "d"'], got)


def refused(graze, folder):
    for data, says in (("x;y\n37,5;1\n", ":2: x: '37,5'"), ("x;y\n37,5;1\n", "expected a decimal point in place of the comma"),
                       ("37,5;1,5\n", "expected decimal points where fields stand between semicolons"),
                       ("x y\n1\n", ":2: 1 columns; expected 2"), ("x;y\n1 3\n", ":2: 1 columns; expected 2"),
                       ("X,q\n1,3\n", "the header names no column y"), ("X,X,Y\n1,3,4\n", "the header names x twice")):
        status, _, said = classify(graze, folder, data)
        check(status == 3 and says in said, data, said)
    for data in ("", "x,y\n", "# nothing\n\n"):
        status, _, said = classify(graze, folder, data)
        check(status == 0 and "note: " in said and "points.csv has no points" in said, data, said)


def main():
    graze = options(__doc__).graze
    with tempfile.TemporaryDirectory(prefix="graze-forms-") as name:
        for part in (taken, carried, refused):
            part(graze, pathlib.Path(name))
    checks.finish()


if __name__ == "__main__":
    main()
