"""Curved solids and motions for tests: nodes of `.csg.json`, and translations that carry the origin along a path.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "lib"))

from exact import Fraction as F  # noqa: E402
from program import Checks, Graze, options  # noqa: E402,F401  (suites take them from here)


class Curved:
    """A node in a dimension, as a file."""
    suffix = ".csg.json"

    def __init__(self, dimension, node):
        self.dimension, self.node = dimension, node

    def text(self):
        return json.dumps({"dimension": self.dimension, "solid": self.node})


class Motion:
    """Pieces of a motion: (from, to, transform)."""

    def __init__(self, dimension, pieces):
        self.dimension, self.pieces = dimension, pieces

    def text(self):
        return json.dumps({"dimension": self.dimension, "pieces": [
            {"t": [str(a), str(b)], "transform": transform} for a, b, transform in self.pieces]})


def along(low, high, *path):
    """The motion by which the inverted trajectory of the origin is the path: expressions in t."""
    return Motion(len(path), [(low, high, {"translate": [f"-({x})" for x in path]})])


def times_of(contacts):
    """Times of contacts: a ratio, or the coefficients of a root's polynomial; of a stay two of them."""
    out = []
    for c in contacts:
        ends = [F(x) if isinstance(x, str) else [int(a) for a in x["poly"]] for x in (c["from"], c["to"])]
        out.append(ends[0] if c["from"] == c["to"] else tuple(ends))
    return out


def texts(values):
    return [str(v) for v in values]


def ball(center, radius):
    return {"ball": {"center": texts(center), "radius": str(radius)}}


def box(low, high):
    return {"box": {"low": texts(low), "high": texts(high)}}


def halfspace(normal, offset=0):
    return {"halfspace": {"normal": texts(normal), "offset": str(offset)}}


def cylinder(point, axis, radius, low=None, high=None):
    value = {"point": texts(point), "axis": texts(axis), "radius": str(radius)}
    if low is not None:
        value.update({"from": str(low), "to": str(high)})
    return {"cylinder": value}


def cone(point, axis, slope, high=None):
    value = {"point": texts(point), "axis": texts(axis), "slope": str(slope)}
    if high is not None:
        value["to"] = str(high)
    return {"cone": value}


def torus(point, axis, major, minor):
    return {"torus": {"point": texts(point), "axis": texts(axis), "major": str(major), "minor": str(minor)}}


def capsule(point, axis, radius):
    return {"capsule": {"point": texts(point), "axis": texts(axis), "radius": str(radius)}}


def polynomial(terms):
    """Terms {powers: coefficient}, powers such as "2,0,1"."""
    return {"polynomial": {key: str(value) for key, value in terms.items()}}


def union(*nodes):
    return {"union": list(nodes)}


def common(*nodes):
    return {"intersection": list(nodes)}


def minus(*nodes):
    return {"difference": list(nodes)}
