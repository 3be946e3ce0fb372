# suite
"""The scenes of the benchmark: fifty in five families, the same bytes twice, coordinates that are binary64, motions
that are what their words say, poses that are the nearest doubles to the exact ones, and the proved deviation.

Motions are evaluated here by an evaluator of their text that shares nothing with cases/benchmark. Volumes, ends of
motions and diagonals are derived beside their tables. In a box the deviation is that of a vertex: it is held to the
last place.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import bisect
import collections
import csv
import functools
import hashlib
import json
import math
import os
import re
import sys
import tempfile
import unittest.mock

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import ROOT, Checks, options, run  # noqa: E402

BENCHMARK = os.path.join(ROOT, "cases", "benchmark")
sys.path.insert(0, BENCHMARK)

import poses  # noqa: E402
import scenes  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from motions import ZERO, along, poly  # noqa: E402

PROGRAM = os.path.join(BENCHMARK, "scenes.py")
FILES = ("solid.off", "motion.json", "scene.json", "poses-101.csv", "poses-1001.csv")
BOX = "box"
# Scene: six times its volume (0: not derived here), "box" if it is one, and (t, the image of the origin) by hand.
DERIVED = {
    "igl-2562": (6, BOX, [(F(4, 7), (1, 0, 0)), (1, (F(7, 4), 0, 0))]),
    # 25/4 by 4 by 1/8; at the end the translation alone moves the origin, about which it turns.
    "plate-fifty": (6 * F(25, 8), BOX, [(1, (4, 0, 2))]),
    "slab-bend": (12, BOX, [(F(1, 2), (2, 0, (F(1, 4) + F(1, 2 ** 24)) / 2)), (1, (0, 0, F(1, 4) + F(1, 2 ** 24)))]),
    # 16 less four squares, 2 high.
    "block-holes": (12 * (16 - F(1, 2 ** 12) - F(1, 2 ** 16) - F(1, 2 ** 20) - F(1, 2 ** 24)), "", [(1, (0, 0, 5))]),
    "bar-closed-turn": (24, BOX, [(F(1, 2), (0, 0, 0)), (4, (0, 0, 0))]),
    # Half of 6 * 7/4 less half of 3/2 * 7/16, 1 high.
    "sector-almost-closed": (6 * (F(21, 4) - F(21, 64)), "", [(4, (0, 0, 0))]),
    "wedge-rational": (0, "", [(1, (-4, 4, 2)), (2, (-8, 8, 4))]),
    "needle-dart": (0, "", [(F(1, 2) + F(1, 2 ** 11), (1, -4, 3)), (1, (2, 0, 1))]),
    # An octahedron of radius 2: 4/3 of its cube.
    "octahedron-kinks": (64, "", [(1, (4, 0, 0)), (2, (8, 0, 0)), (3, (4, 0, 0))]),
    # A quarter turn about x = 14.
    "wrench-turn": (0, "", [(1, (14, -14, 0))]),
    "star-tumbling": (0, "", []),
    "gripper-log": (0, "", []),
    "torus-huge": (0, "", []),
}
WHOLE = ("igl-2562", "plate-fifty")  # whose 1,001 poses are tested too
AGAIN = ("igl-2562", "star-tumbling", "block-holes", "gripper-log")  # made twice
checks = Checks()


@functools.lru_cache(maxsize=None)
def compiled(text):
    """An entry of a motion file in Python's own grammar, its numbers Fractions but for exponents."""
    numbers = []

    def name(match):
        power, number = match.groups()
        numbers.append(int(number) if power else F(int(number)))
        return f"{'**' if power else ''}n[{len(numbers) - 1}]"

    return compile(re.sub(r"(\^?)(\d+)", name, text), text, "eval"), numbers


def evaluated(text, t):
    code, numbers = compiled(text)
    return F(eval(code, {"n": numbers, "t": t}))  # pylint: disable=eval-used


def exact_rows(motion, t):
    piece = motion["pieces"][bisect.bisect_left(motion["ends"], t)]
    transform = piece["transform"]
    if "translate" in transform:
        return [[F(i == j) for j in range(3)] + [evaluated(transform["translate"][i], t)] for i in range(3)]
    return [[evaluated(e, t) for e in row] for row in transform["matrix"]]


def motion_of(folder):
    motion = json.loads(read(folder, "motion.json"))
    return {**motion, "ends": [F(piece["t"][1]) for piece in motion["pieces"]]}


def nearest(x, exact):
    """Is no other double nearer?"""
    return all(abs(F(x) - exact) <= abs(F(math.nextafter(x, way)) - exact) for way in (-math.inf, math.inf))


def read(folder, name):
    with open(os.path.join(folder, name), encoding="ascii") as file:
        return file.read()


def made(graze, out, names, seed):
    """A hash of the files of the scenes, by a process of its own."""
    done = run([sys.executable, PROGRAM, "--graze", graze, out, *names], seconds=120, env=dict(os.environ, PYTHONHASHSEED=seed))
    checks.equal(done.returncode, 0, "scenes.py", done.stderr)
    whole = hashlib.sha256()
    for name in names:
        for file in FILES:
            whole.update(read(os.path.join(out, name), file).encode())
    return whole.hexdigest()


# ------------------------------------------------------------------------------------------------ one scene
def check_solid(name, text, six_volumes):
    """(vertices, their box's diagonal squared): binary64 numbers, a closed surface, the derived volume."""
    lines = text.split("\n")
    n, m, _ = map(int, lines[1].split())
    tokens = [line.split() for line in lines[2:2 + n]]
    vertices = [tuple(map(F, token)) for token in tokens]
    checks.holds(all(F(to_double(c)) == F(c) for token in tokens for c in token), name, "a coordinate is no binary64")
    faces = [list(map(int, line.split()[1:])) for line in lines[2 + n:2 + n + m]]
    sides = collections.Counter()
    volume = F(0)
    for a, b, c in faces:
        for u, v in ((a, b), (b, c), (c, a)):
            sides[u, v] += 1
            sides[v, u] -= 1
        (x, y, z), (p, q, r), (u, v, w) = vertices[a], vertices[b], vertices[c]
        volume += x * (q * w - r * v) + y * (r * u - p * w) + z * (p * v - q * u)
    checks.holds(not any(sides.values()), name, "an edge is passed more often one way")
    checks.holds(volume == six_volumes if six_volumes else volume > 0, name, f"six volumes are {volume}, expected {six_volumes}")
    return vertices, sum((max(c) - min(c)) ** 2 for c in zip(*vertices))


def check_poses(name, motion, vertices, count, text, bound, is_box):
    rows = list(csv.reader(text.splitlines()))
    start, end = F(motion["pieces"][0]["t"][0]), F(motion["pieces"][-1]["t"][1])
    checks.equal(len(rows), count + 1, name, "poses and a head")
    most, some = F(0), vertices if len(vertices) < 20 else vertices[::len(vertices) // 10]
    for k, row in enumerate(rows[1:]):
        t = start + (end - start) * F(k, count - 1)
        exact = exact_rows(motion, t)
        near = [list(map(to_double, row[1 + 4 * i:5 + 4 * i])) for i in range(4)]
        right = F(row[0]) == t and near[3] == [0, 0, 0, 1] and all(nearest(b, a) for p, q in zip(exact, near) for a, b in zip(p, q))
        if not right:
            checks.fail(name, f"pose {k}", row)
        error = [[F(b) - a for a, b in zip(p, q)] for p, q in zip(exact, near)]
        error = [row for row in error if any(row)]
        most = max(most, *(sum((sum((e * c for e, c in zip(r, v)), r[3])) ** 2 for r in error) for v in some))
    bound = F(bound)
    checks.holds(0 < most <= bound ** 2, name, f"{count} poses: a vertex is off by {to_double(most) ** 0.5}, the bound is {to_double(bound)}")
    if is_box:
        checks.holds((bound * (1 - F(1, 2 ** 50))) ** 2 < most, name, f"{count} poses: the bound {to_double(bound)} is not that of the vertices")
    else:
        # A corner of the box is an affine combination of it: in the box, at most the diagonal further than any vertex, thus a small multiple.
        checks.holds(bound ** 2 <= 100 * most, name, f"{count} poses: the bound {to_double(bound)} is far above {to_double(most) ** 0.5}")


def check_scene(graze, out, name):
    folder = os.path.join(out, name)
    six_volumes, is_box, images = DERIVED[name]
    facts, motion = json.loads(read(folder, "scene.json")), motion_of(folder)
    vertices, square = check_solid(name, read(folder, "solid.off"), six_volumes)
    below = F(facts["diagonal"])
    checks.holds(below ** 2 <= square < (below * (1 + F(1, 2 ** 50))) ** 2, name, "diagonal", facts["diagonal"])
    checks.equal(facts["count"], 1000 if name == "gripper-log" else 10000, name, "count")
    for t, image in images:
        checks.equal([row[3] for row in exact_rows(motion, F(t))], list(image), name, f"the origin at t = {t}")
    for count in (101, 1001) if name in WHOLE else (101,):
        check_poses(name, motion, vertices, count, read(folder, f"poses-{count}.csv"), facts["poses"][str(count)]["deviation"], is_box)
    done = run([graze, "check", *(os.path.join(folder, file) for file in FILES[:2])])
    checks.equal(done.returncode, 0, name, "graze check", done.stdout, done.stderr)


# ------------------------------------------------------------------------------------------------ all
def check_families():
    """Ten scenes each; at least eight are straight, whose motion is made without Graze."""
    counts = collections.Counter(family for family, *_ in scenes.SCENES.values())
    checks.equal(counts, {family: 10 for family in ("parts", "motions", "degenerate", "large", "adversarial")}, "families")
    light = [make for family, _, make, log in scenes.SCENES.values() if family != "large" and not log]
    straight = sum(scenes.is_straight(make(None)[1]) for make in light)
    checks.holds(straight >= 8, f"{straight} straight scenes")
    bent = along(poly(0, 1), poly(0, 0, 1), ZERO)
    checks.holds(not scenes.is_straight([bent]), "a parabola is not straight")


def check_words(out):
    """Adversarial scenes have the poses and motions that their words promise."""
    darts = [row for count in (101, 1001) for row in csv.DictReader(read(os.path.join(out, "needle-dart"), f"poses-{count}.csv").splitlines())]
    checks.holds(all(float(row["m13"]) == 0 for row in darts), "a pose sees the needle dart out")
    # Three quarters and twice the angle of tangent 3/4 - 2^-32: the lower side's end, at x = 6, is past 24/25 * 6 by less than 2^-28.
    last = exact_rows(motion_of(os.path.join(out, "sector-almost-closed")), F(4))
    tip = [sum(a * b for a, b in zip(row, (6, F(7, 4), 0, 1))) for row in last]
    checks.holds(-F(1, 2 ** 28) < tip[1] < 0 < tip[0], "the sector's end", tip)
    # Poses that are doubles are not off: of 1,000 times one unit.
    text, bound = poses.table([along(poly(0, 1000), ZERO, ZERO)], [(F(0), F(0), F(0)), (F(1), F(1), F(1))], 1001)
    checks.equal((bound, text.splitlines()[2].split(",")[4]), (0.0, "1.0"), "exact poses")


def check_usage(graze, out):
    done = run([sys.executable, PROGRAM, "--graze", graze, out, "no-such-scene"])
    checks.holds(done.returncode not in (0, 120) and "no-such-scene" in done.stderr, "an unknown scene", done.stderr)
    done = run([sys.executable, PROGRAM, "--list"])
    listed = [line.split("\t")[:2] for line in done.stdout.splitlines()]
    checks.equal(listed, [[name, family] for name, (family, *_) in scenes.SCENES.items()], "--list")


def check_whole(path):
    """A run that ends before a file has its name leaves the one before."""
    scenes.write(path, "old")
    with unittest.mock.patch("os.replace", side_effect=KeyboardInterrupt):
        try:
            scenes.write(path, "new")
        except KeyboardInterrupt:
            pass
    with open(path, encoding="ascii") as file:
        checks.equal(file.read(), "old", "a file is written whole, or not at all")


def main():
    args = options(__doc__)
    check_families()
    with tempfile.TemporaryDirectory() as folder:
        names = list(DERIVED)
        first, again = (os.path.join(folder, part) for part in ("first", "again"))
        made(args.graze, first, [name for name in names if name not in AGAIN], "1")
        checks.equal(made(args.graze, first, AGAIN, "1"), made(args.graze, again, AGAIN, "2"), "two runs")
        for name in names:
            check_scene(args.graze, first, name)
        check_words(first)
        check_whole(os.path.join(folder, "scene.json"))
        check_usage(args.graze, os.path.join(folder, "none"))
    checks.finish()


if __name__ == "__main__":
    main()
