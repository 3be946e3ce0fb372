"""Reads what `graze boundary` writes. Coordinates become fractions.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from exact import Fraction as F


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


# VTK's number of a cell: its dimension, and its corners in the order of the bits of x, y, z.
CELLS = {9: (2, (0, 1, 3, 2)), 12: (3, (0, 1, 3, 2, 4, 5, 7, 6))}
FACES = {1: 1, 3: 2, 5: 3}


def read_grid(path):
    """(points, cells, types, data) of a legacy VTK file: data is {name: column}."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    if lines[0] != "# vtk DataFile Version 3.0" or lines[2:4] != ["ASCII",
                                                                   "DATASET UNSTRUCTURED_GRID"]:
        raise ValueError(path)
    count = int(lines[4].split()[1])
    points = [tuple(F(x) for x in line.split()) for line in lines[5:5 + count]]
    word, cells, numbers = lines[5 + count].split()
    at, cells = 6 + count, int(cells)
    rows = [tuple(map(int, line.split())) for line in lines[at:at + cells]]
    if word != "CELLS" or sum(map(len, rows)) != int(numbers) or any(row[0] + 1 != len(row) for row in rows):
        raise ValueError(path)
    at += cells
    if lines[at] != f"CELL_TYPES {cells}":
        raise ValueError(path)
    types = list(map(int, lines[at + 1:at + 1 + cells]))
    at += 1 + cells
    columns, rows_of_data = {}, 0
    while at < len(lines):
        if lines[at].split()[0] in ("CELL_DATA", "POINT_DATA"):
            rows_of_data = int(lines[at].split()[1])
            at += 1
        columns[lines[at].split()[1]] = [int(x) for x in lines[at + 2:at + 2 + rows_of_data]]
        at += 2 + rows_of_data
    return points, [row[1:] for row in rows], types, columns


def read_vtk(path):
    """(points, [(corners, level, pmc, contact)]) of a file of cells."""
    points, cells, types, columns = read_grid(path)
    kind, = set(types)
    d, order = CELLS[kind]
    corners = [tuple(cell[k] for k in order) for cell in cells]
    if any(len(cell) != 2 ** d for cell in cells):
        raise ValueError(path)
    if d == 2:
        points = [p[:2] for p in points]
    return points, list(zip(corners, columns["level"], columns["pmc"], columns["contact"]))


def read_faces(path, d):
    """(points, cells, data of the points) of a file of a surface or of points."""
    points, cells, types, columns = read_grid(path)
    if any(FACES[kind] != len(cell) for kind, cell in zip(types, cells)):
        raise ValueError(path)
    return [p[:d] for p in points], cells, columns.get("pmc", [])
