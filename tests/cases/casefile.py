"""A case as it lies in cases/NAME: its files, the options and the table of its README.

SPDX-License-Identifier: GPL-3.0-or-later

A case is a folder with README.md. It holds solid.*, motion.json, points.csv and expected.csv, and
make.py where its solid was generated. Whatever else lies there belongs to no case and is a failure.
The README's section `## Words and times` is read, its table `| id | word | contacts |` with an
optional fourth column `cells`.
"""
import os
import re

from times import parse_time

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
FOLDER = os.path.join(ROOT, "cases")
KNOWN = {"README.md", "motion.json", "points.csv", "expected.csv", "make.py"}


class CaseError(Exception):
    """A case that is not in the form this file describes."""


def table_of(text):
    """The rows of the fixed table: id -> (word, [(from, to)], cells or None)."""
    _, found, rest = text.partition("## Words and times\n")
    if not found:
        raise CaseError("the README has no section `## Words and times`")
    lines = []
    for line in rest.strip().splitlines():
        if not line.startswith("|"):
            if lines:
                break
            continue
        lines.append([cell.strip() for cell in line.strip().strip("|").split("|")])
    columns = ["id", "word", "contacts", "cells"]
    if len(lines) < 2 or lines[0] not in (columns[:3], columns):
        raise CaseError("the table's columns must be id, word, contacts and perhaps cells")
    rows = {}
    for cells in lines[2:]:
        if len(cells) != len(lines[0]) or cells[0] in rows:
            raise CaseError(f"row {cells}: another number of columns, or the id a second time")
        met = None
        if len(cells) == 4 and cells[3]:
            met = [re.sub(r"[\s,]+", " ", c).strip() for c in cells[3].split(";")]
        rows[cells[0]] = (cells[1].strip("`"), contacts_of(cells[2]), met)
    return rows


def contacts_of(text):
    """[(from, to)] of `1/4; [1/2, 2/3]; root(2*t^2 - 1, 0, 1)`."""
    out = []
    for entry in filter(None, (e.strip() for e in text.split(";"))):
        inside = re.fullmatch(r"\[(.*)\]", entry)
        ends = re.split(r",\s*(?![^(]*\))", inside[1]) if inside else [entry, entry]
        if len(ends) != 2:
            raise CaseError(f"{entry}: an interval is [TIME, TIME]")
        out.append(tuple(parse_time(e.strip()) for e in ends))
    return out


def rows_of(path):
    """(header, rows) of a CSV file without its comment lines."""
    with open(path, encoding="utf-8") as file:
        lines = [l.rstrip("\n").split(",") for l in file if l.strip() and not l.startswith("#")]
    return [c.strip() for c in lines[0]], [[c.strip() for c in l] for l in lines[1:]]


class Case:
    """One folder; `path(name)` is a file of it."""

    def __init__(self, name):
        self.name = name
        self.folder = os.path.join(FOLDER, name)
        files = set(os.listdir(self.folder)) - {"__pycache__"}
        solids = sorted(f for f in files if f.startswith("solid."))
        if len(solids) != 1:
            raise CaseError(f"one solid.* is needed, here are {solids}")
        self.solid = solids[0]
        self.unused = sorted(files - KNOWN - {self.solid})
        with open(self.path("README.md"), encoding="utf-8") as file:
            text = file.read()
        found = re.findall(r"^options: *(.*)$", text.replace("`", ""), re.M)
        self.options = found[0].split() if found else []
        # without those of further columns
        self.answers = [word for word in self.options if word != "--topo"]
        self.table = table_of(text)
        header, rows = rows_of(self.path("points.csv"))
        if "id" not in header:
            raise CaseError("points.csv has no column id")
        axes = [header.index(a) for a in "xyz" if a in header]
        self.points = [(row[header.index("id")], [row[a] for a in axes]) for row in rows]
        self.dimension = len(axes)
        header, rows = rows_of(self.path("expected.csv"))
        self.expected = [dict(zip(header, row)) for row in rows]

    def path(self, name):
        return os.path.join(self.folder, name)

    def option(self, name, default):
        return self.options[self.options.index(name) + 1] if name in self.options else default


def names():
    """The cases of polyhedra and polygons, in order."""
    return [name for name in all_names() if not is_curved(name)]


def is_curved(name):
    return os.path.exists(os.path.join(FOLDER, name, "solid.csg.json"))


def all_names():
    """The cases there are, in order: the folders that hold any file of a case but the README."""
    found = []
    for name in sorted(os.listdir(FOLDER)):
        folder = os.path.join(FOLDER, name)
        files = set(os.listdir(folder)) if os.path.isdir(folder) else set()
        if files & {"motion.json", "points.csv", "expected.csv"}:
            found.append(name)
    return found
