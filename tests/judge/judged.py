"""Runs of `graze judge`, meshes made by hand, and what every report must obey.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import Fraction as F, to_double  # noqa: E402
from program import Checks, Graze, options  # noqa: E402,F401  (suites take them from here)
from solids import Mesh, block, cross, minus  # noqa: E402,F401

KEYS = ("mesh_to_sweep_outside", "mesh_to_sweep_inside", "sweep_to_mesh")
ROUNDING = 1e-9  # of true distances, which are doubles here


class Judge:
    """Runs of the command; solids, motions and meshes are objects with text(), or paths."""

    def __init__(self, args, checks):
        self.graze, self.checks = Graze(args, checks), checks

    def ask(self, name, solid, motion, mesh, *flags):
        """The report, or None after a failed check."""
        tag = name.replace(" ", "_").replace("/", "_")
        files = [thing if isinstance(thing, str) else self.graze.write(tag + what + end, thing.text())
                 for thing, what, end in ((solid, "_solid", ".off"), (motion, "", ".json"), (mesh, "_mesh", ".off"))]
        out = self.graze.call("judge", *files, "--format", "json", "--no-points", *flags)
        if out.returncode:
            self.checks.fail(name, *flags, f"exit {out.returncode}: {out.stderr.strip()[:300]}")
            return None
        return json.loads(out.stdout)

    def differs(self, name, report, missing, excess, most=None):
        """The volumes of the difference are enclosed, with a width of at most `most`."""
        for key, true in (("missing", missing), ("excess", excess)):
            found = report["volume"][key]
            self.checks.holds(found["low"] <= to_double(true) + ROUNDING and to_double(true) - ROUNDING <= found["high"], name, key, true, found)
            self.checks.holds(most is None or found["high"] - found["low"] <= most, name, key, "width", found)

    def holds(self, name, report, truth, volume=None, within=None):
        """Each true distance (None: not known) is in its enclosure, which has the width asked for."""
        for key, true in zip(KEYS, truth):
            found = report["distance"][key]
            low, high = found["low"], found["high"]
            if true is not None:
                true = to_double(true)
                self.checks.holds(low <= true + ROUNDING and true - ROUNDING <= high, name, key, true, found)
            if within is not None:
                self.checks.holds(found["reached"] and high - low <= within, name, key, within, found)
        if volume is not None:
            v, volume = report["volume"]["sweep"], to_double(volume)
            self.checks.holds(v["low"] <= volume + ROUNDING and volume - ROUNDING <= v["high"], name, volume, v)


def triangles(mesh):
    """The facets of a convex mesh as triangles."""
    return Mesh(mesh.vertices, [[f[0], f[k], f[k + 1]] for f in mesh.facets for k in range(1, len(f) - 1)])


def without(mesh, *facets):
    return Mesh(mesh.vertices, [f for k, f in enumerate(mesh.facets) if k not in facets])


def volume_of(mesh):
    total = F(0)
    for a, b, c in mesh.facets:
        p, q, r = (mesh.vertices[k] for k in (a, b, c))
        total += sum(x * y for x, y in zip(p, cross(q, r)))
    return total / 6


def to_triangle(p, a, b, c):
    """The distance from a point to a triangle, in doubles: the least over its plane and sides."""
    def dot(u, v):
        return sum(x * y for x, y in zip(u, v))

    def to_segment(u, v):
        e, w = minus(v, u), minus(p, u)
        s = min(1.0, max(0.0, dot(e, w) / dot(e, e)))
        return math.sqrt(sum((x - s * y) ** 2 for x, y in zip(w, e)))

    best = min(to_segment(a, b), to_segment(b, c), to_segment(c, a))
    n = cross(minus(b, a), minus(c, a))
    if all(dot(cross(minus(v, u), minus(p, u)), n) >= 0 for u, v in ((a, b), (b, c), (c, a))):
        best = min(best, abs(dot(n, minus(p, a))) / math.sqrt(dot(n, n)))
    return best
