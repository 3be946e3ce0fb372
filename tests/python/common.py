"""Shared by the tests of the module: the program beside the library, scenes, ways to compare.

The square is [0, 1]^2, the cube [0, 2]^3; expected values in the tests are derived from these.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import glob
import os
import subprocess
from fractions import Fraction as F

import graze

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
GRAZE = "build/graze"
SCALE = 1
SEED = 1

try:
    import numpy
except ImportError:
    numpy = None

SQUARE = ([(0, 0), (1, 0), (1, 1), (0, 1)], [[0, 1, 2, 3]])
CUBE = ([(x, y, z) for z in (0, 2) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))],
        [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])


def moved(*entries, start="0", end="1"):
    """A motion of one piece that is a translation."""
    return {"dimension": len(entries),
            "pieces": [{"t": [start, end], "transform": {"translate": list(entries)}}]}


def cube_scene(**options):
    """The cube moved by 8 along x, t from 0 to 1."""
    return graze.Scene(CUBE, moved("8*t", "0", "0"), **options)


def root_scene(**options):
    """The square moved by t^2 along x, t from 0 to 2: c(t) = (x - t^2, y)."""
    return graze.Scene(SQUARE, moved("t^2", "0", end="2"), **options)


def case(name):
    """A folder of cases: paths of solid, motion and points, and the options of its README."""
    folder = os.path.join(ROOT, "cases", name)
    solid = glob.glob(os.path.join(folder, "solid.*"))[0]
    options = {}
    with open(os.path.join(folder, "README.md"), encoding="utf-8") as file:
        for line in file:
            if line.startswith("options: "):
                words = line.split()[1:]
                options = {key[2:]: value for key, value in zip(words[::2], words[1::2])}
    return solid, os.path.join(folder, "motion.json"), os.path.join(folder, "points.csv"), options


def case_names():
    """Every case with a table of expected rows."""
    return sorted(os.path.basename(os.path.dirname(path))
                  for path in glob.glob(os.path.join(ROOT, "cases", "*", "expected.csv")))


def read_rows(path):
    """Rows of a table as dicts, `#` lines left out."""
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def coordinates(row):
    """The point of a row, as number tokens."""
    return [row[name] for name in "xyz" if name in row]


def program(*arguments, text=None):
    """Output of the program."""
    done = subprocess.run([GRAZE, *arguments], input=text.encode() if text else None, check=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    return done.stdout.decode()


def tuples(results):
    """Verdicts as tuples of ints, whichever form they have."""
    return [tuple(map(int, verdict)) for verdict in results]


def token(value):
    """A rational as the tables have it."""
    return str(F(value))
