#!/usr/bin/env python3
# suite
"""Points of numpy's .npy files: the rows are those of the same values as text.

The files are written here, byte by byte, as numpy.save writes them. SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import pathlib
import struct
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import Fraction  # noqa: E402
from harness import Checks, options, run  # noqa: E402

COMMON = pathlib.Path(__file__).resolve().parents[1] / "refuse" / "common"
SPACE = COMMON / "cube.off", COMMON / "move3.json"
PLANE = COMMON / "square.wkt", COMMON / "move2.json"
checks = Checks()
check = checks.holds


def classify(graze, scene, path, *words):
    return run([graze, "classify", *map(str, scene), str(path), *words], 120)


def npy(rows, columns, type_="<f8", fortran=False, version=1):
    """The bytes of an array of rows."""
    order = [row[k] for k in range(columns) for row in rows] if fortran else [x for row in rows for x in row]
    letter = {"f4": "f", "f8": "d", "i1": "b", "i2": "h", "i4": "i", "i8": "q"}.get(type_[1:]) or \
        {"u1": "B", "u2": "H", "u4": "I", "u8": "Q"}[type_[1:]]
    numbers = struct.pack(("<" if type_[0] == "|" else type_[0]) + f"{len(order)}{letter}", *order)
    return head(f"{{'descr': '{type_}', 'fortran_order': {fortran}, 'shape': ({len(rows)}, {columns}), }}\n", version, numbers)


def same(graze, folder, scene, rows, type_="<f8", fortran=False, words=()):
    """An array as .npy and as text give the same bytes but for checksums of their lines; by default rows have the
    values as decimals."""
    path, text = folder / "points.npy", folder / "points.csv"
    path.write_bytes(npy(rows, 3 if scene is SPACE else 2, type_, fortran))
    text.write_text("".join(",".join(str(Fraction(x)) for x in row) + "\n" for row in rows))
    form = () if {"--format", "--round", "--coordinates"} & set(words) else ("--coordinates", "exact")
    got, want = classify(graze, scene, path, *words, *form), classify(graze, scene, text, *words, *form)
    check(got.returncode == want.returncode == 0, type_, fortran, words, got.stderr, want.stderr)
    check(unsummed(got.stdout) == unsummed(want.stdout) and "complete " in got.stdout + "complete " * ("--format" in words),
          type_, fortran, words, got.stdout[-300:])
    if form:
        table, d = classify(graze, scene, path, *words).stdout.splitlines(), 3 if scene is SPACE else 2
        exact = [line.split(",")[:d] for line in got.stdout.splitlines() if line[0] in "-0123456789"]
        given = [line.split(",")[:d] for line in table if line[0] in "-0123456789"]
        check("# coordinates as-given" in table and not any("/" in x for row in given for x in row), type_, table[:15])
        check([[Fraction(x) for x in row] for row in given] == [[Fraction(x) for x in row] for row in exact], type_, given[:3])


def unsummed(table):
    return [line for line in table.splitlines() if "-checksum " not in line]


def values(random, type_):
    """300 numbers that the type holds."""
    bits = 8 * int(type_[2])
    if type_[1] == "f":
        some = [0.0, -0.0, 0.1, 2.0**-120, -1e30, *(random.uniform(-3, 9) for _ in range(9))]
        return [struct.unpack("f", struct.pack("f", x))[0] if bits == 32 else x for x in random.choices(some, k=300)]
    low, high = (-2**(bits - 1), 2**(bits - 1) - 1) if type_[1] == "i" else (0, 2**bits - 1)
    return random.choices([low, high, 0, max(low, -1), *(random.randint(max(low, -9), 9) for _ in range(9))], k=300)


def types(graze, folder, random):
    for kind in "f4 f8 i1 i2 i4 i8 u1 u2 u4 u8".split():
        for order in "<>" if kind[1] != "1" else "|<>":
            flat = values(random, order + kind)
            same(graze, folder, SPACE, [flat[k:k + 3] for k in range(0, 300, 3)], order + kind)
            same(graze, folder, PLANE, [flat[k:k + 2] for k in range(0, 300, 2)], order + kind, fortran=True)
    for version in (1, 2, 3):
        (folder / "points.npy").write_bytes(npy([[1.0, 3.0]], 2, version=version))
        check("\n1,3,out," in classify(graze, PLANE, folder / "points.npy").stdout, version)


def long(graze, folder, random):
    """More rows than are at hand at once, in both orders, in shards, by name or by its first bytes."""
    rows = [[random.randint(-8, 40) / 4 for _ in range(2)] for _ in range(9500)]
    alone = ["--columns", "pmc"]
    same(graze, folder, PLANE, rows, words=alone)
    same(graze, folder, PLANE, rows, fortran=True, words=alone)
    same(graze, folder, PLANE, rows, fortran=True, words=["--shard", "2/3"])
    same(graze, folder, PLANE, [])
    same(graze, folder, PLANE, rows[:30], words=["--coordinates", "decimal"])
    other = folder / "points.of"
    other.write_bytes(npy(rows[:30], 2))
    check("# complete 30" in classify(graze, PLANE, other).stdout, "another name")
    done = run([graze, "draw", *map(str, PLANE), str(other), "--grid", "9", "-o", str(folder / "a.svg")], 120)
    check(done.returncode == 0 and (folder / "a.svg").exists(), "graze draw", done.stderr)


def head(text, version=1, numbers=bytes(32)):
    size = struct.pack("<H" if version == 1 else "<I", len(text))
    return b"\x93NUMPY" + bytes((version, 0)) + size + text.encode() + numbers


GOOD = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }"
REFUSED = (
    (b"1,3\n", "points.npy: is no .npy file, as its name says; expected the bytes"),
    (b"", "points.npy: is no .npy file"),
    (head(GOOD, 4), "points.npy: expected version 1, 2 or 3 of the .npy form"),
    (b"\x93NUMPY\x01", "expected version 1, 2 or 3"),
    (b"\x93NUMPY\x01\x00\xff\x00{'descr'", "points.npy: the head of the .npy file is not understood"),
    (b"\x93NUMPY\x02\x00\xff\xff\xff\xff{'descr'", "the head of the .npy file is not understood"),
    (head(GOOD.replace("{", "[")), "expected a dictionary with descr, fortran_order and shape"),
    (head(GOOD.replace("'shape': (2, 2), ", "")), "is not understood"),
    (head(GOOD.replace("'shape'", "'descr': '<f8', 'shape'")), "is not understood"),
    (head(GOOD.replace("False", "Maybe")), "is not understood"),
    (head(GOOD.replace("'shape'", "shape")), "is not understood"),
    (head(GOOD.replace("(2, 2)", "2, 2")), "is not understood"),
    (head(GOOD.replace("(2, 2), }", "(2, 2")), "is not understood"),
    (head(GOOD.replace("'descr': '<f8'", "'descr': <f8")), "is not understood"),
    (head(GOOD.replace(", 'fortran", "; 'fortran")), "is not understood"),
    (head(GOOD + "x"), "is not understood"),
    (head(GOOD.replace("'<f8'", "[('x', '<f8'), ('y', '<f8')]")), "points.npy: an array of records; expected one of numbers"),
    (head(GOOD.replace("<f8", "<c16")), "points.npy: numbers of type '<c16'; expected floats of 4 or 8 bytes"),
    (head(GOOD.replace("<f8", "<f2")), "numbers of type '<f2'"),
    (head(GOOD.replace("<f8", "|b1")), "numbers of type '|b1'"),
    (head(GOOD.replace("<f8", "=f8")), "numbers of type '=f8'"),
    (head(GOOD.replace("<f8", "")), "numbers of type ''"),
    (head(GOOD.replace("(2, 2)", "(4,)")), "points.npy: an array of shape (4,); expected (n, 2)"),
    (head(GOOD.replace("(2, 2)", "(2, 2, 1)")), "an array of shape (2, 2, 1); expected (n, 2)"),
    (head(GOOD.replace("(2, 2)", "(1, 4)")), "an array of shape (1, 4); expected (n, 2)"),
    (head(GOOD.replace("(2, 2)", "(-1, 2)")), "an array of shape (-1, 2); expected (n, 2)"),
    (head(GOOD, numbers=bytes(31)), "points.npy: 31 bytes behind its head; expected 2 rows of 16 bytes"),
    (head(GOOD, numbers=bytes(48)), "points.npy: 48 bytes behind its head; expected 2 rows of 16 bytes"),
    (head(GOOD.replace("(2,", f"({2**64 - 1},"), numbers=bytes(2**4)), "expected 18446744073709551615 rows"),
    (head(GOOD, numbers=struct.pack("<4d", 1, 2, 3, float("nan"))), "points.npy: row 2: y: expected a finite number"),
    (head(GOOD, numbers=struct.pack("<4d", float("-inf"), 2, 3, 4)), "points.npy: row 1: x: expected a finite number"),
)


def refused(graze, folder):
    path = folder / "points.npy"
    for data, says in REFUSED:
        path.write_bytes(data)
        done = classify(graze, PLANE, path)
        check(done.returncode == 3 and says in done.stderr and len(done.stderr.splitlines()) == 1, data[:120], done.stderr)
        check("# complete" not in done.stdout, data[:120])
    path.write_bytes(head(GOOD))
    check(classify(graze, PLANE, path).returncode == 0, "the good one")
    with open(path, "rb") as file:
        done = run([graze, "classify", *map(str, PLANE), "-"], 60, stdin=file)
    check(done.returncode == 3 and "is a .npy file, which is no text and is read by its name" in done.stderr, done.stderr)
    done = classify(graze, PLANE, path, "--output", str(path))
    check(done.returncode == 2 and "which is read; expected another file" in done.stderr, done.stderr)


def main():
    given = options(__doc__)
    with tempfile.TemporaryDirectory(prefix="graze-npy-") as name:
        folder = pathlib.Path(name)
        types(given.graze, folder, given.random)
        long(given.graze, folder, given.random)
        refused(given.graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
