#!/usr/bin/env python3
"""Sweeps along line segments as Minkowski sums, exactly, by CGAL's Nef polyhedra: answers for points.

    python3 cases/candidates/minkowski.py PROGRAM SOLID MOTION POINTS OUT

PROGRAM is tests/agree/minkowski.cpp, which the agreement tests ask too (`make build/tests/minkowski`); this
writes its input and reads its answers. SOLID is OFF, MOTION a motion of the benchmark that is straight, POINTS a table
with id, x, y, z. OUT gets id and pmc. Exit status 2: the motion is not straight.
SPDX-License-Identifier: CC0-1.0
"""
import csv
import os
import subprocess
import sys
from fractions import Fraction as F

CASES = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
TESTS = os.path.join(os.path.dirname(CASES), "tests")
# Both agree/lib and benchmark have solids.py: here it is that of agree/lib.
sys.path[:0] = [*(os.path.join(TESTS, *part) for part in (("agree", "lib"), ("cases",), ("lib",))), os.path.join(CASES, "benchmark")]

from motions import is_straight, motion_of, value  # noqa: E402
from shells import shells_text  # noqa: E402
from solidfile import read_off  # noqa: E402
from solids import Mesh  # noqa: E402


def read(path):
    with open(path, encoding="ascii", newline="") as file:
        return file.read()


def place(piece, t):
    """Where the origin is."""
    return [value(row[3], t) for row in piece[2]]


def legs_of(pieces):
    """The ends of each piece; a rest between two others adds nothing, and CGAL takes no segment without a length."""
    legs = [place(piece, piece[0]) + place(piece, piece[1]) for piece in pieces]
    return [leg for leg in legs if leg[:3] != leg[3:]] or legs[:1]


def main():
    if len(sys.argv) != 6:
        sys.exit("usage: minkowski.py PROGRAM SOLID MOTION POINTS OUT")
    program, solid, motion, points, out = sys.argv[1:]
    pieces = motion_of(read(motion))
    if not is_straight(pieces):
        print("the motion is not straight", file=sys.stderr)
        sys.exit(2)
    legs = legs_of(pieces)
    rows = list(csv.DictReader(line for line in read(points).splitlines() if not line.startswith("#")))
    lines = [shells_text(Mesh(*read_off(read(solid)))), str(len(legs))]
    lines += [" ".join(map(str, leg)) for leg in legs]
    lines += [str(len(rows)), *(" ".join(str(F(row[axis])) for axis in "xyz") for row in rows)]
    done = subprocess.run([program], input="\n".join(lines) + "\n", check=False, stdout=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit(done.returncode if done.returncode > 0 else 128 - done.returncode)
    with open(out, "w", encoding="ascii") as file:
        file.write("id,pmc\n")
        file.writelines(f"{row['id']},{line.split()[0]}\n" for row, line in zip(rows, done.stdout.splitlines()))


if __name__ == "__main__":
    main()
