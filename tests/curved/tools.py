#!/usr/bin/env python3
# suite
"""Tools that `graze solid --exact` writes: their boxes, the commands that need one, and points at rest by closed forms (C102).

SPDX-License-Identifier: GPL-3.0-or-later

A tool is what its profile r(z), 0 <= z <= L, sweeps about its axis. Points have a rational distance r from the axis, as
(3/5 r, 4/5 r) has, so that r <= R + sqrt(1 - (1 - z)^2) and its like are decided in fractions. The slope of a tapered
side is taken from the file, of whose taper test solid/tools is.
"""
import csv
import json
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

from scenes import Checks, F, options  # noqa: E402

WAYS = (1, 0), (F(-3, 5), F(4, 5)), (F(5, 13), F(-12, 13))
LENGTH = 20


def sign(x):
    return (x > 0) - (x < 0)


def under_root(a, square):
    """The sign of a - sqrt(square)."""
    return sign(a) if square == 0 else 1 if a > 0 and a * a > square else 0 if a >= 0 and a * a == square else -1


def flat(radius):
    return lambda r, z: sign(r - radius)


def bull(radius, corner):
    """Below the corner's height a fillet, whose centre is at (radius - corner, corner)."""
    return lambda r, z: sign(r - radius) if z >= corner else under_root(r - radius + corner, corner ** 2 - (corner - z) ** 2)


def tapered(at, slope):
    return lambda r, z: sign(r - slope * (z - at))


# Words behind `graze solid`, the radius of the box, and a function of the file's cone that gives the sign of (r, z) for 0 < z < L.
TOOLS = [
    (("cylinder", "--diameter", "6"), lambda cone: 3, lambda cone: flat(3)),
    (("cutter", "--diameter", "6"), lambda cone: 3, lambda cone: flat(3)),
    (("cutter", "--diameter", "6", "--corner", "1"), lambda cone: 3, lambda cone: bull(3, 1)),
    (("cutter", "--diameter", "6", "--corner", "3"), lambda cone: 3, lambda cone: bull(3, 3)),
    (("cutter", "--diameter", "6", "--taper", "5"), lambda cone: cone[1] * (LENGTH - cone[0]), lambda cone: tapered(*cone)),
    (("cutter", "--diameter", "6", "--taper", "-5"), lambda cone: 3, lambda cone: tapered(*cone)),
]
PLACES = (0, 0, 0), (1, -2, 3)


def cone_of(document):
    """Where the radius of the file's cone is 0, and by how much the radius grows with z; None without a cone."""
    found = re.search(r'"cone": (\{.*?\})', document)
    if not found:
        return None
    cone = json.loads(found[1])
    return F(str(cone["point"][2])), F(str(cone["slope"])) * int(cone["axis"][2])


def place_of(profile, r, z):
    """in, on or out: all of the sides r and z."""
    ends = max(sign(-z), sign(z - LENGTH))
    worst = 1 if ends > 0 else max(ends, profile(r, z))
    return {1: "out", 0: "on", -1: "in"}[worst]


class Runs:
    def __init__(self, checks, graze, folder):
        self.checks, self.graze, self.folder = checks, graze, folder

    def path(self, name, text=None):
        path = os.path.join(self.folder, name)
        if text is not None:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        return path

    def run(self, *words, status=0):
        done = subprocess.run([self.graze, *map(str, words)], capture_output=True, text=True, timeout=120)
        self.checks.equal(done.returncode, status, *words, done.stderr)
        return done.stdout


def rows_of(text):
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def check_box(runs, solid, motion, name, radius, at):
    """The box of the tool and, with a motion by (8, 0, 0), the grid's: larger by less than 2^-10 of the longest side."""
    said = re.search(r"^box of S[^:]*: (.*); size", runs.run("check", solid, motion), re.M)
    runs.checks.holds(said, name, "has a box")
    ends = [[F(x) for x in side.split(" .. ")] for side in said[1].split(", ")] if said else []
    exact = [(at[0] - radius, at[0] + radius), (at[1] - radius, at[1] + radius), (at[2], at[2] + LENGTH)]
    for (low, high), (a, b) in zip(ends, exact):
        runs.checks.holds(a - F(1, 1000) <= low <= a and b <= high <= b + F(1, 1000), name, low, high, a, b)
    grid = re.search(r"^# box (.*)$", runs.run("classify", solid, motion, "--grid", "3,3,3", "--columns", "pmc"), re.M)
    corners = [F(x) for x in grid[1].split(",")]
    for k, (a, b) in enumerate(exact):
        b += 8 * (k == 0)
        runs.checks.holds(a - F(1, 32) <= corners[k] <= a and b <= corners[k + 3] <= b + F(1, 32), name, "grid", grid[1])


def check_points(runs, solid, name, profile, at):
    """Points at rest, singly; and on the grid of the tool's box, singly and together."""
    heights = (F(-1, 2 ** 40), 0, F(1, 2 ** 40), F(1, 5), F(1, 2), 1, F(6, 5), 3, 10, LENGTH, LENGTH + F(1, 2 ** 40))
    radii = (0, 1, 2, F(13, 5), F(14, 5), 3, 3 + F(1, 2 ** 40), 3 - F(1, 2 ** 40), 4)
    points = [(r, z, x * r + at[0], y * r + at[1], z + at[2]) for z in heights for r in radii for x, y in WAYS]
    text = "".join(",".join(map(str, p[2:])) + "\n" for p in points)
    rows = rows_of(runs.run("classify", solid, runs.path("points.csv", "x,y,z\n" + text), "--at-rest"))
    for p, row in zip(points, rows):
        runs.checks.equal(row["pmc"], place_of(profile, *p[:2]), name, *p)
    runs.checks.equal(({row["pmc"] for row in rows}, len(rows)), ({"in", "on", "out"}, len(points)), name)
    grid = runs.run("classify", solid, "--at-rest", "--grid", "2,2,9")
    runs.checks.equal({row["pmc"] for row in rows_of(grid)}, {"out"}, name, "corners of the box")


def check_commands(runs, solid, motion, name):
    """generate, validate and draw take the tool."""
    made = runs.run("generate", solid, motion, "-n", 40, "--seed", 2)
    runs.checks.holds(len(rows_of(made)) == 40 and {"face", "near"} <= {row["stratum"] for row in rows_of(made)}, name, made[:500])
    answer = f"{runs.graze} classify {{solid}} {{motion}} {{points}} --output {{out}} --quiet"
    said = json.loads(runs.run("validate", solid, motion, "-n", 30, "--format", "json", "--quiet", "--candidate", answer))
    runs.checks.equal((said["comparison"]["rows"], said["comparison"]["wrong"]), (30, 0), name, "validate")
    runs.run("draw", solid, motion, "-o", runs.path("tool.svg"), "--plane", "z=5")
    runs.checks.holds(os.path.getsize(runs.path("tool.svg")) > 1000, name, "draw")


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(checks, args.graze, folder)
        motion = runs.path("move.json")
        runs.run("motion", "line", "--by", "8,0,0", "-o", motion)
        for k, (words, radius, form) in enumerate(TOOLS):
            solid, at = runs.path("tool.csg.json"), PLACES[k % 2]
            runs.run("solid", *words, "--length", LENGTH, "--exact", "--at", ",".join(map(str, at)), "-o", solid)
            with open(solid, encoding="utf-8") as file:
                cone = cone_of(file.read())
            check_box(runs, solid, motion, words, radius(cone), at)
            check_points(runs, solid, words, form(cone), at)
            check_commands(runs, solid, motion, words)
    checks.finish()


if __name__ == "__main__":
    main()
