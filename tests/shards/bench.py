"""Shared by the suites of this folder: the program with a folder for files, scenes, tables and their alterations.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import pathlib
import re
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402

COMMON = pathlib.Path(__file__).resolve().parents[1] / "refuse" / "common"
SECONDS = 300


class Bench:
    """The program, a folder for files, a random generator, and the counts."""

    def __init__(self, args, folder):
        self.graze, self.folder, self.scale = args.graze, pathlib.Path(folder), max(1, int(args.scale))
        self.random, self.checks, self.sanitizers = args.random, harness.Checks(), args.sanitizers

    def check(self, holds, what, *seen):
        self.checks.holds(holds, what, *(repr(s)[:600] for s in seen))

    def run(self, *words, stdin=None, **limits):
        """(exit status, standard output, standard error) of graze."""
        command = [self.graze, *words]
        done = harness.run(harness.bounded(command, **limits) if limits else command, SECONDS, text=False, input=stdin)
        return done.returncode, done.stdout, done.stderr

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content)
        return path

    def good(self, *words, **more):
        """Standard output of a run that must succeed."""
        status, out, err = self.run(*words, **more)
        silent = err == b"" or re.fullmatch(rb"graze: note: \S+ has no points\n", err)
        self.check(status == 0 and silent, f"{words} succeeds", status, err)
        return out


def run_checks(description, checks):
    """A suite: each check on one bench."""
    args = harness.options(description, seed=1)
    with tempfile.TemporaryDirectory(prefix="graze-shards-") as folder:
        bench = Bench(args, folder)
        for check in checks:
            start = time.monotonic()
            check(bench)
            print(f"{check.__name__}: {time.monotonic() - start:.1f} s")
    bench.checks.finish()


def random_points(chance, count, dimension):
    """CSV with columns between and behind the coordinates, comments and blank lines."""
    lines = ["# made by a test", "name,x,y,z,note" if dimension == 3 else "name,x,y,note"]
    for k in range(count):
        numbers = [f"{chance.randint(-6, 24)}/{chance.choice((1, 2, 3))}" for _ in range(dimension)]
        lines.append(f"p{k}," + ",".join(numbers) + f',"a, {chance.randint(0, 9)}"')
        if chance.random() < 0.05:
            lines.append(chance.choice(("", "# between", "   ")))
    return ("\n".join(lines) + chance.choice(("", "\n"))).encode()


def split(table):
    """(head, rows, end) of a table, as lists of lines."""
    lines = table.splitlines(keepends=True)
    first = next(k for k, line in enumerate(lines) if not line.startswith(b"#")) + 1
    last = len(lines)
    while lines[last - 1].startswith(b"#"):
        last -= 1
    return lines[:first], lines[first:last], lines[last:]


def checksum(data):
    """Checksum of 64 bits (src/program/cli/formats.md, Tables): 8 bytes at a time, the first one lowest; the rest, filled
    with zeros; the length."""
    value, whole = 0, len(data) // 8 * 8
    words = [int.from_bytes(data[k:k + 8], "little") for k in range(0, whole, 8)]
    for word in (*words, int.from_bytes(data[whole:], "little"), len(data)):
        value = (value ^ word) * 0x9e3779b97f4a7c15 % 2**64
        value ^= value >> 32
    return value


def sealed(lines, complete, mark=b"# "):
    """A part of these lines, its last two made anew."""
    body = b"".join(lines)
    return body + mark + b"bytes-checksum %016x\n" % checksum(body) + mark + b"complete %d\n" % complete


def scenes(bench):
    """(name, the words of classify without POINTS, the words for the points, standard input)."""
    cube = ["classify", COMMON / "cube.off", COMMON / "move3.json"]
    square = ["classify", COMMON / "square.wkt", COMMON / "move2.json"]
    count = 700 * bench.scale
    points = random_points(bench.random, count, 3)
    flat = random_points(bench.random, 25, 2)
    yield "points", cube, [bench.file("points.csv", points)], None
    yield "pipe", cube, ["-"], points
    yield "few points", square, [bench.file("flat.csv", flat)], None
    yield "no points", square, [bench.file("none.csv", b"x,y,w\n")], None
    yield "grid", cube, ["--grid", "7,5,9"], None
    yield "plane grid", square, ["--grid", "2,3", "--folds", "combined"], None
    yield "unsweep", square, ["--grid", "9,9", "--operation", "unsweep", "--round", "binary32"], None


def altered(bench, rows, at):
    """(what was done, rows) where row `at`, not the last, is no longer what the run wrote; every change is one that the
    row's point or its word shows."""
    fields = rows[at].split(b",")
    word = next(k for k, f in enumerate(fields) if k > 1 and f.strip(b"\n") and not f.strip(b"IBO\n"))
    names = {b"in": b"out", b"out": b"on", b"on": b"in"}

    def put(k, value):
        return b",".join(fields[:k] + [value + b"\n" * (k == len(fields) - 1)] + fields[k + 1:])

    pmc = next(k for k, f in enumerate(fields) if f in names)
    yield "NUL bytes", bytes(len(rows[at]) - 1) + b"\n"
    yield "one NUL byte", bytes(1) + rows[at][1:]
    yield "another x", put(0, fields[0] + b"1")
    yield "an x not in lowest terms", put(0, b"2/2" if fields[0] == b"1" else fields[0] + b"/1")
    yield "another last coordinate", put(pmc - 1, b"977")
    yield "another pmc", put(pmc, names[fields[pmc]])
    for k in range(pmc + 1, word):
        yield f"another answer {k - pmc}", put(k, b"3" if fields[k] != b"3" else b"4")
    other = b"OBO" if fields[word].strip() != b"OBO" else b"OBOBO"
    if word == pmc + 1:  # of an unsweep, where pmc alone follows from the word
        other = b"O" if fields[pmc] == b"in" else b"I"
    for value in (b"", b"OO", b"BB", b"IO", b"OBX", other):
        yield f"the word {value}", put(word, value)
    yield "a column more", rows[at][:-1] + b",1\n"
    yield "a column less", rows[at].rpartition(b",")[0] + b"\n"
    yield "a blank line", b"\n"
    yield "a comment", b"# " + rows[at]
    yield "a row more", rows[at] + rows[at]
    yield "a comment more", rows[at] + b"# between\n"
    yield "a row less", b""
    yield "its neighbour", rows[at - 1 if at else at + 1]
