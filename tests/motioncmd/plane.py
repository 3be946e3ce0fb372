#!/usr/bin/env python3
# suite
"""Motions in the plane of lists of poses: `graze motion poses --dimension 2`.

The frames are those of the motion in space, the third coordinate dropped, in every form of a list; a prism that moves in
space answers as its polygon in the plane; tilts and z are left out within their bounds.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import json
import math
import os
import re
import sys
import tempfile
from decimal import Decimal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from evaluate import rotation_of  # noqa: E402
from exact import Fraction as F  # noqa: E402
from harness import Checks, options  # noqa: E402
from truth import PI, cos_sin, dec  # noqa: E402

checks = Checks()
check = checks.holds
SPACE = ["t", "x", "y", "z", "qw", "qx", "qy", "qz"]


def table(names, rows):
    return "".join(",".join(str(x) for x in row) + "\n" for row in [names, *rows])


class Lists:
    """Runs `graze motion poses` in a folder."""

    def __init__(self, graze, folder):
        self.graze, self.folder = graze, folder

    def at(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.at(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.at(name)

    def run(self, *arguments):
        return harness.run([self.graze, *arguments], 300)

    def made(self, text, *arguments, to="made.json"):
        """(motion file, report) of a list that must be taken."""
        done = self.run("motion", "poses", self.write("list", text), "--numbers", "written", "--output", self.at(to), *arguments)
        if not check(done.returncode == 0, text[:300], arguments, done.stderr):
            return None, done.stderr
        with open(self.at(to), encoding="utf-8") as file:
            return json.load(file), done.stderr

    def flat(self, text, *arguments, to="made.json"):
        return self.made(text, "--dimension", "2", *arguments, to=to)


def frames(motion):
    """(t, position, half angle) of each frame in the plane."""
    return [(F(k["t"]), [F(x) for x in k["position"]], [F(x) for x in k.get("complex", [1, 0])]) for k in motion["keyframes"]]


def dropped(motion):
    """The frames of a motion in space that keeps the plane, its third coordinate left out."""
    return [(F(k["t"]), [F(x) for x in k["position"]][:2], [F(x) for x in k.get("quaternion", [1, 0, 0, 0])][::3]) for k in motion["keyframes"]]


def test_quarter(lists):
    """A bar [0, 2] x [0, 1] runs by (3, 0), then turns a quarter about its corner: the turn sweeps a sector of radius sqrt 5 and
    a triangle of area 1 on each side of it, 5 pi/4 + 2; the leg the bar and 3 x 1."""
    lists.write("bar.wkt", "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))\n")
    turned = ([("qw", "qz"), (1, 0), (1, 1), ()], [("qz", "qw"), (0, "0.7"), ("0.7", "0.7"), ()],
              [("theta",), (0,), ("1.57079632679489661923",), ()], [("yaw",), (0,), (90,), ("--angles", "rpy")])
    for names, start, end, flags in turned:
        leg, _ = lists.flat(table(["t", "x", "y", *names], [[0, 0, 0, *start], [1, 3, 0, *start]]), *flags, to="leg.json")
        check(leg and leg["dimension"] == 2, names)
        got = lists.run("outline", lists.at("bar.wkt"), lists.at("leg.json"))
        check(re.search(r"^area\W+5$", got.stdout, re.M), got.stdout)
        turn, _ = lists.flat(table(["t", "x", "y", *names], [[0, 3, 0, *start], [1, 3, 0, *end]]), *flags, to="turn.json")
        re_part, im_part = frames(turn)[-1][2]
        check(re_part == im_part > 0, "a quarter turn, exactly", names, turn)
        got = lists.run("outline", lists.at("bar.wkt"), lists.at("turn.json"), "--format", "json")
        area = json.loads(got.stdout)["area"]
        bounds = [Decimal(str(x)) for x in (area["low"], area["high"])]
        check(bounds[0] <= 5 * PI / 4 + 2 <= bounds[1] and bounds[1] - bounds[0] < Decimal("1e-10"), names, area)


def test_dropped(lists, args):
    """Every form of a list, and every way between poses."""
    rng = args.random
    for k in args.rounds(6, "forms"):
        angles = [(rng.randint(-9, 9), rng.choice((1, 2, 3, 5))) for _ in range(8)]
        at = [[F(j, 3), F(rng.randint(-99, 99), 10), F(rng.randint(-99, 99), 7)] for j in range(8)]
        quaternions = table(SPACE, [[*p, 0, w, 0, 0, z] for p, (z, w) in zip(at, angles)])
        short = table([SPACE[j] for j in (0, 1, 2, 4, 7)], [[*p, w, z] for p, (z, w) in zip(at, angles)])
        for flags in ((), ("--long",), ("--slerp", "--tolerance", "1e-3"), ("--scale", "2/7"), ("--every", "3")):
            if flags == ("--long",) and k % 2:
                continue
            want, told = lists.made(quaternions, *flags)
            for text in (quaternions, short):
                got, report = lists.flat(text, *flags)
                check(got and frames(got) == dropped(want) and [f["row"] for f in got["keyframes"]] == [f["row"] for f in want["keyframes"]],
                      flags, text)
                check(report == told, "the report of the motion in space", report, told)
        rows = [[x for line, b in zip(rotation_of([F(w), F(0), F(0), F(z)]), (p[1], p[2], 0)) for x in [*line, b]] for p, (z, w) in zip(at, angles)]
        text = table([f"m{i}{j}" for i in range(3) for j in range(4)], rows)
        check(frames(lists.flat(text)[0]) == dropped(lists.made(text)[0]), "matrices", text)
        # Entries within 1/4 of the identity's: no mean of two is singular.
        rows = [[1 + F(rng.randint(-1, 1), 4), F(rng.randint(-1, 1), 4), 0, *p[1:2], F(rng.randint(-1, 1), 4), 1, 0, p[2], 0, 0, 1, p[1]] for p in at]
        text = table([f"m{i}{j}" for i in range(3) for j in range(4)], rows)
        got, want = lists.flat(text, "--affine")[0], lists.made(text, "--affine")[0]
        for a, b in zip(got["pieces"], want["pieces"]):
            matrix = b["transform"]["matrix"]
            check(a["t"] == b["t"] and a["transform"]["matrix"] == [[row[j] for j in (0, 1, 3)] for row in matrix[:2]], "affine", a, b)
        for machine, name in (("kuka", "A"), ("fanuc", "R"), ("staubli", "RZ"), ("kawasaki", "O"), ("cnc", "C"), ("rpy", "yaw")):
            names = {"kuka": "ABC", "fanuc": "WPR", "staubli": ("RX", "RY", "RZ"), "kawasaki": "OAT", "cnc": "ABC",
                     "rpy": ("roll", "pitch", "yaw")}[machine]
            degrees = [rng.randint(-300, 300) for _ in at]
            want, _ = lists.made(table(["t", "x", "y", "z", *names], [[*p, 0, *(d if n == name else 0 for n in names)] for p, d in zip(at, degrees)]),
                                 "--angles", machine)
            got, _ = lists.flat(table(["t", "x", "y", name], [[*p, d] for p, d in zip(at, degrees)]), "--angles", machine)
            check(frames(got) == dropped(want), machine, degrees)
        axes, _ = lists.flat(table(["x", "y", "z", "i", "j", "k"], [[*p[1:], 0, 0, 0, 3] for p in at]))
        alone, _ = lists.flat(table(["x", "y"], [p[1:] for p in at]))
        check([f[1] for f in frames(axes)] == [f[1] for f in frames(alone)] == [p[1:] for p in at], "axes, and positions alone")
        check(all(z == 0 < w for _, _, (w, z) in frames(axes)), axes)


def test_radians(lists, args):
    """The half angle of theta against the series of cosine and sine, within the bound of the report."""
    rng = args.random
    for k in args.rounds(12, "radians"):
        tolerance = ("1e-3", "1e-6", "1e-25")[k % 3]
        theta = [Decimal(rng.randint(-10 ** 12, 10 ** 12)) / 10 ** rng.randint(9, 12) for _ in range(6)] + [Decimal(0)]
        got, report = lists.flat(table(["x", "y", "heading"], [[0, 0, x] for x in theta]), "--columns", "theta=heading", "--tolerance", tolerance)
        told = float(re.search(r"^angles: in radians, about z, off by at most (\S+) radians", report, re.M)[1])
        check(told <= float(tolerance), report)
        for (_, _, half), x in zip(frames(got), theta):
            w, z = (dec(a) for a in half)
            cosine, sine = cos_sin(x * 180 / PI)
            size = w * w + z * z
            # Points of the circle that are c apart are 2 asin(c/2) apart.
            off = 2 * math.asin(min(1, float((((w * w - z * z) / size - cosine) ** 2 + (2 * w * z / size - sine) ** 2).sqrt()) / 2))
            check(off <= told * (1 + 1e-9) + 1e-90, x, off, told)


def test_tilts(lists, args):
    """The entries of both matrices, in fractions, beside the bound that is told; beyond the tolerance the row is refused."""
    rng = args.random
    for _ in args.rounds(40, "tilts"):
        q = [F(rng.randint(-20, 20)) for _ in range(4)]
        q = [q[0] or F(1), q[1] / 10 ** 6, q[2] / 10 ** rng.choice((4, 6)), q[3]]
        square = 4 * (q[1] ** 2 + q[2] ** 2) / sum(x * x for x in q)  # of the bound 2 hypot(x, y) / |q|
        text = table(SPACE, [[0, 0, 0, 0, 1, 0, 0, 0], [1, 1, 2, 0, *q]])
        change = max(abs(a - b) for p, r in zip(rotation_of(q), rotation_of([q[0], 0, 0, q[3]])) for a, b in zip(p, r))
        above = F(math.isqrt(int(square * 10 ** 60)) + 1, 10 ** 30) * (1 + F(1, 10 ** 15))  # rounded up, with 64 bits
        got, report = lists.flat(text, "--tolerance", str(above))
        told = re.search(r"^plane: tilts are left out; they change entries of matrices by at most (\S+)$", report, re.M)
        check(F(told[1]) >= change if told else change == 0, report, q)
        check(not told or F(told[1]) <= above * F(102, 100), report, above)
        w, z = frames(got)[-1][2]
        check([w, z] in ([q[0], q[3]], [-q[0], -q[3]]), "w and z stay", q, got)
        if square:
            below = F(math.isqrt(int(square * 10 ** 60)), 10 ** 30) * F(999, 1000)
            done = lists.run("motion", "poses", lists.write("list", text), "--numbers", "written", "--dimension", "2", "--tolerance", str(below))
            check(done.returncode == 3 and ":3: the pose turns out of the plane" in done.stderr, done.stderr)


def test_heights(lists):
    """z is told where it is left out."""
    _, report = lists.flat(table(["x", "y", "z"], [[0, 0, 0], [1, 2, F(1, 9)]]))
    check("plane: z is left out\n" in report, report)
    _, report = lists.flat(table(["x", "y", "z"], [[0, 0, 0], [1, 2, 0]]))
    check("plane" not in report, report)


def rows_of(lists, solid, motion, points):
    done = lists.run("classify", lists.at(solid), lists.at(motion), points, "--moments")
    check(done.returncode == 0, done.stderr)
    return [{k: row[k] for k in ("pmc", "word", "first", "last", "first_row", "last_row")} for row in
            csv.DictReader(line for line in done.stdout.splitlines() if not line.startswith("#"))]


def test_prism(lists, args):
    """A prism answers in space as its polygon in the plane, at any height within it: pmc, word and exact times. Its log rises by up to
    1, and the points stay 4 or more away from its two ends."""
    corners = [(0, 0), (3, 0), (3, 2), (1, 1), (0, 2)]
    lists.write("car.wkt", "POLYGON ((" + ", ".join(f"{x} {y}" for x, y in [*corners, corners[0]]) + "))\n")
    n = len(corners)
    faces = [[*range(n - 1, -1, -1)], [*range(n, 2 * n)], *([k, (k + 1) % n, n + (k + 1) % n, n + k] for k in range(n))]
    lists.write("car.off", f"OFF\n{2 * n} {len(faces)} 0\n" + "".join(f"{x} {y} {z}\n" for z in (-10, 10) for x, y in corners)
                + "".join(f"{len(f)} {' '.join(map(str, f))}\n" for f in faces))
    rng = args.random
    for k in args.rounds(8, "prisms"):
        poses = [[j, rng.randint(-6, 6), rng.randint(-6, 6), F(rng.randint(-4, 4), 4), rng.choice((1, 2, 3)), 0, 0, rng.randint(-3, 3)] for j in range(6)]
        log = table(SPACE, poses)
        lists.made(log, to="space.json")
        lists.flat(log, to="plane.json")
        points = [(F(rng.randint(-20, 20), 2), F(rng.randint(-20, 20), 2)) for _ in range(120)]
        for j, p in enumerate(poses):  # corners as they stand at the poses
            rotation = rotation_of([F(x) for x in p[4:]])
            points += [tuple(rotation[i][0] * x + rotation[i][1] * y + p[1 + i] for i in (0, 1)) for x, y in corners]
        got = rows_of(lists, "car.wkt", "plane.json", lists.write("2.csv", table("xy", points)))
        want = rows_of(lists, "car.off", "space.json", lists.write("3.csv", table("xyz", [[*p, k % 8 - 2] for p in points])))
        check(len(got) == len(points) and any(row["pmc"] == "on" for row in got), "some points are on the boundary", len(got))
        for p, a, b in zip(points, got, want):
            check(a == b, p, a, b, log)


def main():
    args = options(__doc__, seed=1)
    with tempfile.TemporaryDirectory() as folder:
        lists = Lists(args.graze, folder)
        if args.derived:
            test_quarter(lists)
            test_heights(lists)
        test_dropped(lists, args)
        test_radians(lists, args)
        test_tilts(lists, args)
        test_prism(lists, args)
    checks.finish()


if __name__ == "__main__":
    main()
