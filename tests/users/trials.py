#!/usr/bin/env python3
# suite
"""Three new users, each with the installed program alone: a golden table to the report of a classifier in floats; an
STL file and a log of poses to a verdict and a surface; numpy in, a table out.

`make install` puts everything under a prefix of its own, whose printed lines of environment are what the users have.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import shlex
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from harness import ROOT, Checks, options  # noqa: E402

checks = Checks()
check = checks.holds
PYTHON = "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else sys.executable
# The box [0, 2]^3 of 12 triangles, outward.
CORNERS = [(x, y, z) for z in (0, 2) for y in (0, 2) for x in (0, 2)]
TRIANGLES = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
             (1, 3, 7), (1, 7, 5)]
# In floats: the box moves by 8 along x, so a point is met if it is in [0, 10] x [0, 2] x [0, 2].
CLASSIFIER = """
import csv, sys
from fractions import Fraction
rows = list(csv.reader(line for line in open(sys.argv[1]) if not line.startswith("#")))
with open(sys.argv[2], "w") as out:
    out.write("x,y,z,pmc\\n")
    for row in rows[1:]:
        x, y, z = (float(Fraction(text)) for text in row[:3])
        inside = 0 < x < 10 and 0 < y < 2 and 0 < z < 2
        out.write(f"{x!r},{y!r},{z!r},{'in' if inside else 'out'}\\n")
"""
NUMPY = """
import graze, numpy
solid = graze.Solid((numpy.array(%r, float), numpy.array(%r)))
poses = numpy.tile(numpy.eye(4), (2, 1, 1)); poses[1, 0, 3] = 8
scene = graze.Scene(solid, graze.Motion.poses(poses))
points = numpy.array([[5, 1, 1], [5, 1, 2], [5, 3, 1]], float)
columns = graze.columns(scene.classify(points), points)
print(columns["pmc"], columns["class"], list(map(float, columns["x"])))
print(repr(scene), len(scene.draw(points[:1], grid=4)._repr_svg_()) > 1000)
""" % (CORNERS, TRIANGLES)


class User:
    """Runs lines of a shell in a folder, with the environment that `make install` asks for."""

    def __init__(self, folder, exports):
        self.folder, self.exports = folder, exports

    def sh(self, line, status=0):
        bare = {"PATH": "/usr/bin:/bin", "HOME": self.folder, "LC_ALL": "C.UTF-8", "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run(["sh", "-c", "\n".join([*self.exports, line])], cwd=self.folder, env=bare, text=True,
                              capture_output=True, timeout=600)
        check(done.returncode == status, line, done.stdout[-1000:], done.stderr[-1000:])
        return done.stdout + done.stderr

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)


def stl():
    """The box as text."""
    corner = lambda k: "   vertex %d %d %d\n" % CORNERS[k]
    return "solid box\n" + "".join(f" facet normal 0 0 0\n  outer loop\n{''.join(map(corner, t))}  endloop\n endfacet\n"
                                   for t in TRIANGLES) + "endsolid box\n"


def researcher(user):
    """Points of a scene, exact answers, a table by floats, and where the two differ: on the boundary alone."""
    user.write("box.stl", stl())
    user.write("move.json", '{"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["8*t", 0, 0]}}]}')
    user.write("mine.py", CLASSIFIER)
    user.sh("graze generate box.stl move.json -n 500 --seed 1 --quiet > points.csv")
    user.sh("graze classify box.stl move.json points.csv --quiet > golden.csv")
    user.sh(f"{PYTHON} mine.py golden.csv mine.csv")
    said = user.sh("graze compare golden.csv mine.csv --on-as out", 1)
    # Floats have rounded some of the points: their rows are matched all the same, and it is told.
    check("rows matched by: order; " in said and "missing: " not in said, said[:800])
    check("rows have coordinates other than the golden ones" in said, said[:800])
    said = user.sh("graze compare golden.csv mine.csv --on-as out --round binary64 --show 1 --solid box.stl --motion move.json", 1)
    wrong = [line for line in said.splitlines() if line.startswith("| 500 | ")][0].split("|")
    # Only points within 2^-53 of the boundary are lost to floats.
    check(0 < int(wrong[3]) < 25 and int(wrong[4]) == int(wrong[6]) == 0, said[:800])
    check("Its word is" in user.sh(next(line.strip(" `") for line in said.splitlines() if "`graze explain" in line)), said)
    said = user.sh("graze classify box.stl move.json golden.csv --quiet")
    check(said == user.sh("cat golden.csv"), "the golden table as points gives itself")


def engineer(user):
    """A mesh and a TUM log: is it legal, what does it sweep, how far does it reach."""
    user.write("poses.txt", "# timestamp tx ty tz qx qy qz qw\n0.0 0 0 0 0 0 0 1\n0.5 4000 0 0 0 0 0 -1\n1.0 8000 0 0 0 0 0 1\n")
    said = user.sh("graze motion poses poses.txt --scale 1/1000 --long -o log.json", 3)
    check("opposite" in said, "signs that jump are told", said)
    said = user.sh("graze motion poses poses.txt --scale 1/1000 -o log.json")
    check("signs of quaternions changed at lines 3; 1 in all" in said, said)
    check("legal" in user.sh("graze check box.stl log.json"), "the pair is legal")
    user.sh("graze boundary box.stl log.json --depth 4 --surface swept.ply")
    check(user.sh("head -c 3 swept.ply") == "ply", "a surface")
    user.write("probe.txt", "x y z\n9.5 1 1\n10 1 1\n10.5 1 1\n")
    rows = user.sh("graze classify box.stl log.json probe.txt --quiet").split("word\n")[1].splitlines()
    check([row.split(",")[3] for row in rows[:3]] == ["in", "on", "out"], rows)


def developer(user):
    """The module of Python, with arrays."""
    if subprocess.run([PYTHON, "-c", "import numpy"], capture_output=True).returncode != 0:
        checks.skip("numpy", f"{PYTHON} has no numpy")
        return
    user.write("sweep.py", NUMPY)
    said = user.sh(f"{PYTHON} sweep.py")
    check(said.startswith("['in', 'on', 'out'] ['regular', 'boundary', 'exterior'] [5.0, 5.0, 5.0]\n"), said)
    check("8 vertices, 12 facets" in said and said.endswith("True\n"), said)


def main():
    args = options(__doc__)
    if args.sanitizers:
        checks.skip("trials", "the library is built with a sanitizer, the interpreter is not")
        checks.finish()
    build = os.path.relpath(os.path.dirname(args.graze), ROOT)
    with tempfile.TemporaryDirectory() as folder:
        prefix = os.path.join(folder, "prefix")
        done = harness.run(["make", "-s", "-C", ROOT, f"B={build}", "install", f"PREFIX={prefix}"], 900)
        check(done.returncode == 0, done.stderr)
        exports = [line.strip() for line in done.stdout.splitlines() if line.strip().startswith("export ")]
        user = User(folder, exports)
        check(user.sh("command -v graze").strip() == shlex.quote(f"{prefix}/bin/graze"), exports)
        for trial in (researcher, engineer, developer):
            trial(user)
    checks.finish()


if __name__ == "__main__":
    main()
