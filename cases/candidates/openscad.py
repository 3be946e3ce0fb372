#!/usr/bin/env python3
"""The union of a solid at all poses, by OpenSCAD, as a mesh.

    python3 cases/candidates/openscad.py POSES SOLID OUT

POSES is a table with columns m00 to m33, SOLID an OFF of numbers, OUT what `openscad -o` writes. OpenSCAD gets a
polyhedron and a multmatrix for each pose, and joins them by CGAL's Nef polyhedra.
SPDX-License-Identifier: CC0-1.0
"""
import csv
import os
import subprocess
import sys
import tempfile
from fractions import Fraction as F


def polyhedron(path):
    """The solid as OpenSCAD spells it, whose facets turn the other way."""
    with open(path, encoding="ascii") as file:
        words = [word for line in file for word in line.split("#")[0].split()]
    vertices, facets = int(words[1]), int(words[2])
    numbers = [float(F(word)) for word in words[4:4 + 3 * vertices]]
    points = [numbers[k:k + 3] for k in range(0, len(numbers), 3)]
    faces, at = [], 4 + 3 * vertices
    for _ in range(facets):
        count = int(words[at])
        faces.append([int(word) for word in words[at + count:at:-1]])
        at += 1 + count
    return f"polyhedron({points}, {faces})"


def script(poses, solid):
    with open(poses, encoding="ascii", newline="") as file:
        rows = list(csv.DictReader(file))
    parts = [[[float(row[f"m{i}{j}"]) for j in range(4)] for i in range(4)] for row in rows]
    return f"module solid() {polyhedron(solid)};\nunion() {{\n" + "".join(f"multmatrix({part}) solid();\n" for part in parts) + "}\n"


def main():
    if len(sys.argv) != 4:
        sys.exit("usage: openscad.py POSES SOLID OUT")
    poses, solid, out = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "union.scad")
        with open(path, "w", encoding="ascii") as file:
            file.write(script(poses, solid))
        status = subprocess.run(["openscad", "--quiet", "-o", out, path], check=False).returncode
    sys.exit(status if status >= 0 else 128 - status)


if __name__ == "__main__":
    main()
