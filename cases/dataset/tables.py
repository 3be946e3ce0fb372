"""Tables of the dataset: their columns, their types, and numpy arrays of them without numpy.

Names and their order are those of tables that graze writes with every option. A column's meaning stands here, or is the row of
src/program/cli/formats.md that names it. SPDX-License-Identifier: CC0-1.0
"""
import os
import re
import struct
import subprocess
import tempfile
from fractions import Fraction

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
FORMATS = os.path.join(ROOT, "src", "program", "cli", "formats.md")
# Columns of all tables, and of points as `graze generate` writes them; then those that only the dataset has.
COMMON = {
    "x": "first coordinate of the point", "y": "second coordinate of the point", "z": "third coordinate of the point; empty in the plane",
    "pmc": "membership of the point: inside, on the boundary or outside of the union of the moving solid's interiors (of an unsweep: of the points that stay inside)",
    "class": "class of the point by Definitions 5 to 9 of Erdim and Ilieş (2008)",
    "definition": "the definition that gives the class; `ext` where the ends of the motion meet, which the paper excludes",
    "case": "position case, 1 to 9, of the first and last state of the trajectory",
    "i": "number of intersections: contacts between different states",
    "t": "number of tangencies: contacts between equal states",
    "word": "states of the inverted trajectory in order of time: I inside, B on the boundary, O outside",
    "topo": "position relative to the closed sweep or unsweep",
}
POINTS = {
    "id": "the point's number from 1, in a golden case its name",
    "stratum": "how the point was made: `random`; beside a contact with a `face`, `face-odd`, `edge`, `vertex`, `crossing`, at the `start`, `end` or a `break` of "
               "the motion, a `slide`; `near` a contact; a near `miss`; `rounded-` and one of these, the doubles next to such a contact",
    "order": "order of contact of the trajectory with the cell, a whole number, or `slide` where it stays on it",
    "cell": "the cell of the solid that is met, as `face 2`, `edge 1-2`, `vertex 0`",
    "time": "time of the contact, a ratio, or a root of a polynomial",
    "k": "the point is 2^-k of the size away from the contact, for strata beside one",
    "side": "the side on which the point was made, or of `rounded` points the exact answer",
    "note": "what the row shows, in words",
    "scene": "name of the scene's folder",
    "family": "family of the scene",
    "name": "name of the golden case's folder",
    "options": "options of `graze classify` that the case asks for",
    "s": "signed distance in closed form: ratios, `+ - * / ^`, `sqrt(...)` and `root(POLYNOMIAL, a, b)`",
}
COORDINATES = ("x", "y", "z")
LENGTH, TIME = "unit of the scene's coordinates", "unit of the motion's parameter t"
UNITS = {**dict.fromkeys(("x", "y", "z", "sdf_low", "sdf_high", "boundary_low"), LENGTH),
         **dict.fromkeys(("sdf_t", "time", "first", "first_near", "last", "last_near"), TIME)}
VALUES = {
    "pmc": ["in", "on", "out", "undecided"],
    "class": ["regular", "fold", "fold_boundary", "boundary", "exterior", "undecided"],
    "definition": ["5", "6", "7", "8", "9", "10", "11", "ext"],
    "case": ["1", "2", "3", "4", "5", "6", "7", "8", "9"],
    "topo": ["interior", "boundary", "exterior", "undecided"],
    "regular": ["yes", "no", "undecided"],
    "certain": ["yes", "undecided"],
    "side": ["in", "on", "out"],
    "family": ["parts", "motions", "degenerate", "large", "adversarial"],
}
# Columns of contacts/: meaning, type, unit, values.
SOLID_PATH = "file of the {} solid, in solids.tar.gz"
CONTACTS = {
    "id": ("the pair: its family and number", "string", None, None),
    "family": ("how the pair was made", "string", None,
               ["head-on", "edges", "grazes", "slides", "near-misses", "turns", "screws", "tumbles", "splines", "logs"]),
    "kind": ("the solids of the pair, in words", "string", None, None),
    "moving": (SOLID_PATH.format("moving"), "string", None, None),
    "motion": ("file of the motion, in motions.tar.gz", "string", None, None),
    "fixed": (SOLID_PATH.format("standing"), "string", None, None),
    "facets": ("number of facets of both solids", "integer", None, None),
    "known": ("the word by construction; with + at its end the word begins so; empty: not known beforehand", "string", None, None),
    "known_first": ("time of the first contact by construction, a ratio; empty: not known beforehand", "string", TIME, None),
    "verdict": ("the solids stay apart, touch without a common inner point, or have one at some time", "string", None, ["clear", "touch", "overlap"]),
    "word": ("states of the pair in order of time: O apart, B touching, I with common inner points", "string", None, None),
    "first": ("time of the first contact, exactly: a ratio, or root(c0 c1 ...;a;b): polynomial, the constant first, and an interval with one root of it",
              "string", TIME, None),
    "first_near": ("a double near the time of the first contact", "number", TIME, None),
    "cells": ("all pairs of cells that meet then, of the moving and of the standing solid", "string", None, None),
}
WHOLE = {"case", "i", "t", "k", "first_piece", "last_piece", "first_row", "last_row"}
REAL = {"sdf_low", "sdf_high", "boundary_low", "first_near", "last_near"}
CODES = ("definition", "case", "i", "t")  # numbers in 32 bits of an npy array; 0 for ext and for nothing
BRACKET = [os.path.join(ROOT, "cases", "bracket", name) for name in ("solid.off", "motion.json", "points.csv")]


class Failure(Exception):
    """A table is not what is expected; the message names it."""


def plain(text):
    """A cell of a table of Markdown without its links."""
    return re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text).replace("\\|", "|").strip()


def meanings():
    """column: its meaning, of the tables of formats.md whose head is `| column | values |`."""
    with open(FORMATS, encoding="utf-8") as file:
        tables = re.findall(r"^\| column \| values \|\n\|[-|]+\|\n((?:\|.*\n)+)", file.read(), re.M)
    found = {}
    for line in "".join(tables).splitlines():
        names, _, text = line.strip("|").partition(" | ")
        for name in re.findall(r"`(\w+)`", names):
            found.setdefault(name, plain(text))
    return found


def column_options():
    """Words of two runs, of a sweep and of an unsweep, that between them ask for every column of the page's table of options."""
    with open(FORMATS, encoding="utf-8") as file:
        rows = re.findall(r"^\| `(--[a-z-]+)( [A-Z]+)?` \| `\w+`.*?`# [^|]*\| (.*?) \|", file.read(), re.M)
    words = [("unsweep" in beside, [option, *(["1e-6r" if option == "--sdf" else "1e-9"] if argument else [])]) for option, argument, beside in rows]
    return [word for of_unsweep, more in words if not of_unsweep for word in more], ["--operation", "unsweep", *(word for _, more in words for word in more)]


def written_columns(graze):
    """Names of the columns that graze writes, in order, each with the options of the run that has it."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "rows.json"), "w", encoding="ascii") as file:  # a piece with rows of a log
            file.write('{"dimension": 3, "pieces": [{"t": [0, 1], "row": 1, "transform": {"translate": ["t", 0, 0]}}]}')
        for words in column_options():
            done = subprocess.run([graze, "classify", BRACKET[0], os.path.join(folder, "rows.json"), BRACKET[2], "--quiet", *words],
                                  stdout=subprocess.PIPE, text=True, check=True)
            for name in next(line for line in done.stdout.splitlines() if not line.startswith("#")).split(","):
                found.setdefault(name, " ".join(words))
    return found


def column_type(name, points="number"):
    """Type of a column's fields in a CSV file, as Table Schema names types. `points`: that of coordinates, which may be ratios."""
    if name in COORDINATES:
        return points
    return "integer" if name in WHOLE else "number" if name in REAL else "string"


def describe(graze):
    """The entries of columns.json: name, meaning, type, unit, values of each column of any table, and the folder that has it so, if one has."""
    known, written = {**meanings(), **COMMON, **POINTS}, written_columns(graze)
    lacking = [name for name in written if name not in known]
    if lacking:
        raise Failure(f"{FORMATS}: no row `{lacking[0]}` in a table of columns")
    names = [*written, *(name for name in POINTS if name not in written)]
    keys = ("name", "meaning", "type", "unit", "values", "folder")
    entries = [(name, known[name], column_type(name, "number or ratio"), UNITS.get(name), VALUES.get(name), None) for name in names]
    entries += [(name, *more, "contacts") for name, more in CONTACTS.items()]
    return [dict(zip(keys, entry)) for entry in entries]


def split_table(text, path):
    """(lines of the head, names, rows as lists) of a table of graze."""
    lines = text.splitlines()
    head = [line for line in lines if line.startswith("#")]
    rows = [line.split(",") for line in lines if line and not line.startswith("#")]
    wrong = [row for row in rows if len(row) != len(rows[0]) or any('"' in field for field in row)]
    if wrong:
        raise Failure(f"{path}: a row with other columns, or a quoted field: {','.join(wrong[0])}")
    return head, rows[0], rows[1:]


def nearest(field):
    """The nearest double of a number or ratio; None: no number."""
    try:
        return float(Fraction(field)) if "/" in field else float(field)
    except ValueError:
        return None


def array_column(name, fields):
    """(type of numpy, its fields as bytes) of a column, as `graze classify --format npy` has it."""
    if name in CODES:
        return "<u4", [struct.pack("<I", int(field) if field.isdigit() else 0) for field in fields]
    numbers = [nearest(field) for field in fields]
    if name not in VALUES and name not in ("word", "stratum") and None not in numbers:
        return "<f8", [struct.pack("<d", number) for number in numbers]
    encoded = [field.encode() for field in fields]
    width = max(1, *map(len, encoded))
    return f"S{width}", [field.ljust(width, b"\0") for field in encoded]


def array_bytes(names, rows):
    """A structured numpy array (.npy, 3.0) of a table."""
    columns = [array_column(name, [row[k] for row in rows]) for k, name in enumerate(names)]
    types = ", ".join(f"('{name}', '{kind if kind[0] == '<' else '|' + kind}')" for name, (kind, _) in zip(names, columns))
    head = f"{{'descr': [{types}], 'fortran_order': False, 'shape': ({len(rows)},), }}"
    head += " " * (-(len(head) + 13) % 64) + "\n"
    return b"\x93NUMPY\x03\x00" + struct.pack("<I", len(head)) + head.encode() + b"".join(map(b"".join, zip(*(fields for _, fields in columns))))
