"""The facets of a case's solid for trace.gp, read by a reader of its own (OFF, OBJ, WKT).

SPDX-License-Identifier: GPL-3.0-or-later

A facet is (normal, offset, kept coordinates, corners, corners' numbers): normal . x = offset is its
plane, the two kept coordinates do not see it edge-on. A facet in the plane is an edge and keeps
none. Cases are legal solids, so nothing is checked here but the reading.
"""
import re

from exact import Fraction as F


def number(token):
    """The exact value of a number token: 3, -1.5e2, 22/7."""
    return F(token)


def plane(vertices, numbers):
    """Newell's normal, and the plane through the first corner."""
    corners = [vertices[k] for k in numbers]
    n = [F(0)] * 3
    for (a, b) in zip(corners, corners[1:] + corners[:1]):
        for k in range(3):
            i, j = (k + 1) % 3, (k + 2) % 3
            n[k] += (a[i] - b[i]) * (a[j] + b[j])
    drop = next(k for k in range(3) if n[k])
    offset = sum(x * y for x, y in zip(n, corners[0]))
    return n, offset, [k for k in range(3) if k != drop], corners, numbers


def read_off(text):
    """A line a vertex and a line a facet; what follows coordinates or indices is left alone."""
    lines = [re.sub(r"#.*", "", line).split() for line in text.lstrip("\ufeff").splitlines()]
    lines = [line for line in lines if line]
    if lines[0][0].upper().endswith("OFF"):
        lines[0].pop(0)
    head = []
    while len(head) < 3:
        head += lines.pop(0)
    count, facets = int(head[0]), int(head[1])
    vertices = [[number(t) for t in line[:3]] for line in lines[:count]]
    out = [[int(v) for v in line[1:1 + int(line[0])]] for line in lines[count:count + facets]]
    return vertices, out


def read_obj(text):
    vertices, out = [], []
    for line in text.splitlines():
        word = line.split()
        if word[:1] == ["v"]:
            vertices.append([number(t) for t in word[1:4]])
        elif word[:1] == ["f"]:
            at = [int(w.split("/")[0]) for w in word[1:]]
            out.append([k - 1 if k > 0 else len(vertices) + k for k in at])
    return vertices, out


def read_wkt(text):
    edges, first = [], 0
    for ring in re.findall(r"\(([^()]+)\)", text):
        corners = [[number(t) for t in corner.split()] for corner in ring.split(",")]
        count = len(corners) - 1
        for k, (a, b) in enumerate(zip(corners, corners[1:])):
            n = [b[1] - a[1], a[0] - b[0]]
            ends = [first + k, first + (k + 1) % count]
            edges.append((n, n[0] * a[0] + n[1] * a[1], [], [a, b], ends))
        first += count
    return edges


def facets_of(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    ending = path.rsplit(".", 1)[1]
    if ending == "wkt":
        return read_wkt(text)
    readers = {"off": read_off, "obj": read_obj}
    if ending not in readers:
        raise ValueError(f"{path}: recompute.py reads .off, .obj and .wkt")
    vertices, facets = readers[ending](text)
    return [plane(vertices, numbers) for numbers in facets]


def gp_list(values):
    return "[" + ",".join(str(v) for v in values) + "]"


def gp_facet(index, facet):
    normal, offset, kept, corners, numbers = facet
    corners = "[" + ",".join(gp_list(c) for c in corners) + "]"
    kept = gp_list(k + 1 for k in kept)
    return f"[{gp_list(normal)},{offset},{kept},{corners},{index},{gp_list(numbers)}]"
