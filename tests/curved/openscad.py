#!/usr/bin/env python3
"""OpenSCAD's own examples, as Debian installs them (`apt-get install openscad`): its program writes `.csg` of each; at least 15
are taken, 8 of them curved, and why the others are not is printed as a table. By hand.

Second method: OpenSCAD's mesh of each solid. A point that is further from the mesh than it can be from the true surface is in both
or in none; the mesh decides by the parity of a ray, in doubles. With $fa = 12 and $fs = 2 a circle of radius r has pi r sides, at
least 5 and at most 30, so its chords are at most 0.31 or r / 180 away, on a sphere in two directions. Nothing is copied.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
import glob
import os
import re
import shutil
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import Checks, bounded, options, run  # noqa: E402

EXAMPLES = "/usr/share/openscad/examples"
TAKEN, CURVED = 15, 8
POINTS, MESH_SECONDS, MOST_TRIANGLES = 60, 100, 20000
SCREENLESS = dict(os.environ, QT_QPA_PLATFORM="offscreen")
REST = '{"dimension": %d, "pieces": [{"t": ["0", "1"], "transform": {"translate": [%s]}}]}'


def sub(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def segment_distance2(p, a, b):
    u, w = sub(b, a), sub(p, a)
    t = max(0.0, min(1.0, dot(u, w) / (dot(u, u) or 1.0)))
    d = sub(w, (t * u[0], t * u[1], t * u[2]))
    return dot(d, d)


def distance2(p, triangle):
    """The square of the distance of a point from a triangle."""
    a, b, c = triangle
    n = cross(sub(b, a), sub(c, a))
    if dot(n, n) > 0 and all(dot(cross(sub(y, x), sub(p, x)), n) >= 0 for x, y in ((a, b), (b, c), (c, a))):
        return dot(sub(p, a), n) ** 2 / dot(n, n)
    return min(segment_distance2(p, *edge) for edge in ((a, b), (b, c), (c, a)))


def above(p, triangle):
    """Does the ray upwards from a point pass through a triangle?"""
    a, b, c = triangle
    signs = [(y[0] - x[0]) * (p[1] - x[1]) - (y[1] - x[1]) * (p[0] - x[0]) > 0 for x, y in ((a, b), (b, c), (c, a))]
    if len(set(signs)) > 1:
        return False
    n = cross(sub(b, a), sub(c, a))
    return n[2] != 0 and a[2] + (n[0] * (a[0] - p[0]) + n[1] * (a[1] - p[1])) / n[2] > p[2]


def triangles_of(stl):
    with open(stl, encoding="ascii") as file:
        corners = [tuple(map(float, v)) for v in re.findall(r"vertex (\S+) (\S+) (\S+)", file.read())]
    return list(zip(corners[::3], corners[1::3], corners[2::3]))


class Bench:
    def __init__(self, args, folder):
        self.args, self.folder, self.checks = args, folder, Checks()
        self.compared = 0

    def file(self, name, text=None):
        path = os.path.join(self.folder, name)
        if text is not None:
            with open(path, "w", encoding="ascii") as file:
                file.write(text)
        return path

    def openscad(self, output, source, *options):
        """Run in the folder of the test: the program goes to that of the example by itself."""
        return run(bounded(["openscad", *options, "-o", self.file(output), source]), MESH_SECONDS, env=SCREENLESS)

    def compare(self, name, source, solid):
        """The points that both tell; none if OpenSCAD makes no mesh in time."""
        if self.openscad("m.stl", source).returncode != 0:
            return "no mesh in time"
        triangles = triangles_of(self.file("m.stl"))
        if not 0 < len(triangles) <= MOST_TRIANGLES:
            return f"a mesh of {len(triangles)} triangles"
        ends = [(min(c[i] for t in triangles for c in t), max(c[i] for t in triangles for c in t)) for i in range(3)]
        slack = 0.65 + max(max(map(abs, pair)) for pair in ends) / 60
        points = [[round(self.args.random.uniform(a, b), 5) for a, b in ends] for _ in range(int(POINTS * self.args.scale))]
        table = self.file("p.csv", "".join("%r,%r,%r\n" % tuple(p) for p in points))
        done = run([self.args.graze, "classify", solid, self.file("rest.json", REST % (3, '"0", "0", "0"')), table, "--columns", "pmc"])
        answers = [line.split(",")[3] for line in done.stdout.splitlines() if line[:1] not in "#x"]
        if not self.checks.equal((done.returncode, len(answers)), (0, len(points)), name, done.stderr):
            return "no answers"
        used = 0
        for p, answer in zip(points, answers):
            if min(distance2(p, t) for t in triangles) > slack ** 2:
                inside = sum(above(p, t) for t in triangles) % 2 == 1
                self.checks.equal(answer, "in" if inside else "out", name, p)
                used += 1
        self.compared += used
        return f"{used} points as in its mesh"

    def take(self, source):
        """A row of the table: status, surfaces that are not planes, and a word."""
        name = os.path.basename(source)
        if not self.checks.equal(self.openscad("e.csg", source).returncode, 0, name, "openscad"):
            return None, False, "OpenSCAD fails"
        csg, solid = self.file("e.csg"), self.file("e.csg.json")
        plain = run([self.args.graze, "convert", csg, "-o", solid])
        done = run([self.args.graze, "convert", csg, "-o", solid, "--smooth", "--near-rotation", "1e-5"])
        if done.returncode != 0:
            found = re.fullmatch(r"graze: \S+e\.csg:(?:(\d+): )?(.*)\n", done.stderr)
            self.checks.holds(done.returncode == 3 and found, name, "one line with its place", done.stderr)
            return None, False, found[2].split(";")[0] if found else done.stderr
        with open(csg, encoding="utf-8") as file:
            text = file.read()
        curved = re.search(r"^\s*#?(sphere|cylinder|circle|rotate_extrude)\(", text, re.M) is not None
        with open(solid, encoding="ascii") as file:
            d = int(re.match(r'\{"dimension":(\d)', file.read())[1])
        checked = run([self.args.graze, "check", solid, self.file("rest.json", REST % (d, ", ".join(['"0"'] * d)))])
        self.checks.equal(checked.returncode, 0, name, checked.stderr)
        word = "in the plane" if d == 2 else self.compare(name, source, solid)
        return "taken" if plain.returncode == 0 else "--smooth", curved, word


def main():
    args = options(__doc__.splitlines()[0])
    if not shutil.which("openscad") or not os.path.isdir(EXAMPLES):
        checks = Checks()
        checks.skip("openscad", "not installed; apt-get install openscad")
        checks.finish()
    rows, reasons = [], collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(args, folder)
        for source in sorted(glob.glob(os.path.join(EXAMPLES, "*", "*.scad"))):
            status, curved, word = bench.take(source)
            rows.append((status, curved))
            if status is None:
                reasons[word.split(":")[0] if "not taken" in word else word] += 1
            print(f"{os.path.basename(source):28} {status or '-':9} {'curved' if curved else '-':7} {word}", flush=True)
    taken = [row for row in rows if row[0]]
    plain = [row for row in taken if row[0] == "taken"]
    print(f"{len(rows)} examples: {len(plain)} taken as they are ({sum(c for _, c in plain)} curved), {len(taken) - len(plain)} with "
          f"--smooth ({sum(c for _, c in taken) - sum(c for _, c in plain)} curved); {bench.compared} points compared")
    for reason, count in reasons.most_common():
        print(f"  not taken for {reason}: {count}")
    bench.checks.holds(len(taken) >= TAKEN and sum(c for _, c in taken) >= CURVED, "too few are taken")
    bench.checks.holds(bench.compared > 100, "too few points are compared", bench.compared)
    bench.checks.finish()


if __name__ == "__main__":
    main()
