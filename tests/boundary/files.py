"""Reads what `graze boundary` writes. Coordinates become fractions.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from fractions import Fraction as F


def read_points(path):
    """{point: pmc} of a CSV file."""
    with open(path, encoding="utf-8") as file:
        rows = [line.strip().split(",") for line in file if not line.startswith("#")]
    names, rows = rows[0], rows[1:]
    d = len(names) - 1
    out = {tuple(map(F, row[:d])): row[d] for row in rows}
    if names != list("xyz"[:d]) + ["pmc"] or len(out) != len(rows):
        raise ValueError(path)
    return out


def read_ply(path):
    """(vertices, faces): triangles, or the edges of a file of the plane, with two coordinates."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    end = lines.index("end_header")
    counts = {line.split()[1]: int(line.split()[2]) for line in lines[:end]
              if line.startswith("element")}
    body = [line.split() for line in lines[end + 1:]]
    vertices = [tuple(F(x) for x in row) for row in body[:counts["vertex"]]]
    rest = body[counts["vertex"]:]
    if "edge" in counts:
        if any(v[2] for v in vertices) or len(rest) != counts["edge"]:
            raise ValueError(path)
        return [v[:2] for v in vertices], [tuple(map(int, row)) for row in rest]
    if len(rest) != counts["face"] or any(row[0] != "3" for row in rest):
        raise ValueError(path)
    return vertices, [tuple(map(int, row[1:])) for row in rest]


def read_vtk(path):
    """(points, [(corners, level, pmc, contact)]) of a legacy VTK file of cells."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    if lines[0] != "# vtk DataFile Version 3.0" or lines[2:4] != ["ASCII",
                                                                   "DATASET UNSTRUCTURED_GRID"]:
        raise ValueError(path)
    count = int(lines[4].split()[1])
    points = [tuple(F(x) for x in line.split()) for line in lines[5:5 + count]]
    at = 5 + count
    cells = int(lines[at].split()[1])
    corners = [tuple(map(int, line.split()))[1:] for line in lines[at + 1:at + 1 + cells]]
    if sum(len(c) + 1 for c in corners) != int(lines[at].split()[2]):
        raise ValueError(path)
    at += 1 + cells
    kinds = set(lines[at + 1:at + 1 + cells])
    if kinds != {"8"} and kinds != {"11"}:
        raise ValueError(path)
    at += 1 + cells + 1
    columns = {}
    while at < len(lines):
        columns[lines[at].split()[1]] = [int(x) for x in lines[at + 2:at + 2 + cells]]
        at += 2 + cells
    if kinds == {"8"}:
        points = [p[:2] for p in points]
    return points, list(zip(corners, columns["level"], columns["pmc"], columns["contact"]))


def read_polydata(path, d):
    """(points, cells, data of the points) of a legacy VTK file."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    if lines[3] != "DATASET POLYDATA":
        raise ValueError(path)
    count = int(lines[4].split()[1])
    points = [tuple(F(x) for x in line.split())[:d] for line in lines[5:5 + count]]
    at = 5 + count
    _, cells, numbers = lines[at].split()
    rows = [tuple(map(int, line.split())) for line in lines[at + 1:at + 1 + int(cells)]]
    if sum(map(len, rows)) != int(numbers) or any(row[0] + 1 != len(row) for row in rows):
        raise ValueError(path)
    data = [int(x) for x in lines[at + 1 + int(cells) + 3:]]
    return points, [row[1:] for row in rows], data
