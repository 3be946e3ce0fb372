#!/usr/bin/env python3
"""Judges signed distances of sampled motions: libigl's swept_volume_signed_distance and sampled_sdf, by Graze.

    IGL_INCLUDE=/where/igl/lies python3 cases/candidates/igl.py --graze build/graze [--count N]

Compiles both programs into a temporary folder and prints the tables of the README: scattered points, by stratum, at
10, 100 and 1,000 poses, and a grid at isolevel 0. Without IGL_INCLUDE (the folder that holds igl/; Eigen from Debian's
libeigen3-dev) libigl is left out by name.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import csv
import os
import subprocess
import sys
import tempfile
from collections import defaultdict
from fractions import Fraction as F

HERE = os.path.dirname(os.path.abspath(__file__))
CASES = os.path.dirname(HERE)
SCENES = {"bracket": ("bracket/solid.off", "bracket/motion.json"), "arch": ("candidates/ell.off", "candidates/arch.json"),
          "turn": ("candidates/ell.off", "candidates/turn.json"), "climb": ("distance-climb/solid.off", "distance-climb/motion.json")}
POSES = (10, 100, 1000)
SMALL = F(1, 10 ** 6)  # smaller overestimates may be rounding alone
SIGNS = ("pseudonormal", "winding", "fast")
# libigl's issue 2562: a unit cube in eight positions, each 1/4 from the next, on a grid whose band is thinner than the cube.
OVERLAP = (("OFF\n8 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n"
            "3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n"),
           '{"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["7*t/4", 0, 0]}}]}')
START, EDGE, SIDES = (-0.296875, -0.296875, -0.296875), 0.109375, (24, 16, 16)  # of the grid, in 64ths
GRID_POSES = (8, 100, 1000)
EIGEN = "/usr/include/eigen3"


def compile_programs(folder):
    """The names of the programs there are."""
    objects = []
    for name in ("scene", "motion", "sampled_sdf"):
        objects.append(os.path.join(folder, name + ".o"))
        subprocess.run(["cc", "-std=c11", "-D_POSIX_C_SOURCE=200809L", "-O2", "-c", "-o", objects[-1], os.path.join(HERE, name + ".c")], check=True)
    shared = [*objects[:2], "-lyajl", "-lm"]
    subprocess.run(["cc", "-o", os.path.join(folder, "sampled_sdf"), objects[2], *shared], check=True)
    include = os.environ.get("IGL_INCLUDE")
    if not include:
        print("SKIP libigl: IGL_INCLUDE does not name its headers")
        return ["sampled_sdf"]
    subprocess.run(["c++", "-std=c++17", "-O2", "-DNDEBUG", "-isystem", include, "-isystem", EIGEN, "-o", os.path.join(folder, "igl_swept"),
                    os.path.join(HERE, "igl_swept.cpp"), *shared], check=True)
    return ["sampled_sdf", "igl_swept"]


def rows_of(text):
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def output(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def write(path, text):
    with open(path, "w", encoding="ascii") as file:
        file.write(text)


class Scene:
    """A scene with triangles, its points and their enclosures."""

    def __init__(self, graze, folder, name, solid, motion):
        self.graze, self.folder, self.name, self.motion = graze, folder, name, motion
        self.solid, self.points = (os.path.join(folder, name + end) for end in (".off", ".csv"))
        subprocess.run([graze, "convert", solid, "-o", self.solid], check=True, stderr=subprocess.DEVNULL)

    def generate(self, count):
        made = output(self.graze, "generate", self.solid, self.motion, "-n", str(count), "--seed", "1",
                      "--representable", "binary64", "--quiet")
        self.take(made, [row["stratum"] for row in rows_of(made)])

    def take(self, points, strata):
        """Points, and their enclosures."""
        write(self.points, points)
        self.strata, before = strata, os.times().children_user
        self.golden = rows_of(output(self.graze, "classify", self.solid, self.motion, self.points, "--sdf", "1e-6r", "--quiet", "--jobs", "1"))
        self.seconds = os.times().children_user - before

    def ask(self, program, *more, grid=()):
        """The candidate's values, and its CPU seconds."""
        out = os.path.join(self.folder, "out.csv")
        before = os.times().children_user
        subprocess.run([os.path.join(self.folder, program), *map(str, more), self.solid, self.motion, self.points, out, *map(str, grid)],
                       check=True, stderr=subprocess.DEVNULL)
        with open(out, encoding="ascii") as file:
            return [float(row["sdf"]) for row in rows_of(file.read())], os.times().children_user - before

    def judged(self, values):
        """(wrong in, wrong out, `on` called inside, overestimates, errors) of all rows, by stratum."""
        found = defaultdict(lambda: [0, 0, 0, 0, 0, 0.0])
        for row, value, stratum in zip(self.golden, values, self.strata):
            low, high = F(row["sdf_low"]), F(row["sdf_high"])
            error = float(max(0, low - F(value), F(value) - high)) if abs(value) < 1e300 else float("inf")
            for name in (stratum, "all"):
                one = found[name]
                one[0] += 1
                one[1] += row["pmc"] == "in" and value >= 0
                one[2] += row["pmc"] == "out" and value <= 0
                one[3] += row["pmc"] == "on" and value < 0
                one[4] += value > high + SMALL
                one[5] = max(one[5], error)
        return found


def print_row(*cells):
    print("| " + " | ".join(map(str, cells)) + " |")


def scattered(scenes, programs):
    print_row("scene", "candidate", "poses", "`in` called outside", "`on` called inside", "`out` called inside", "too far by more than 1e-6",
              "largest error", "ms a point", "Graze, ms a point")
    print("|---|---|" + "--:|" * 8)
    by_stratum = {}
    for scene in scenes:
        runs = [("sampled_sdf", ())] if "sampled_sdf" in programs else []
        runs += [("igl_swept", (sign, "inf")) for sign in SIGNS if "igl_swept" in programs]
        n = len(scene.golden)
        counts = {pmc: sum(r["pmc"] == pmc for r in scene.golden) for pmc in ("in", "on", "out")}
        for program, more in runs:
            for poses in POSES:
                values, seconds = scene.ask(program, poses, *more)
                found = scene.judged(values)
                rows, wrong_in, wrong_out, inside, over, error = found["all"]
                print_row(scene.name, " ".join((program, *more[:1])), poses, f"{wrong_in} of {counts['in']}", f"{inside} of {counts['on']}",
                          f"{wrong_out} of {counts['out']}", f"{over} of {n}", f"{error:.2g}", f"{1000 * seconds / n:.2f}",
                          f"{1000 * scene.seconds / n:.2f}")
                sys.stdout.flush()
                by_stratum.setdefault((program, *more[:1], poses), []).append(found)
    return by_stratum


def strata_table(by_stratum):
    keys = [k for k in by_stratum if k[-1] == POSES[-1]]
    names = sorted({name for found in by_stratum.values() for one in found for name in one} - {"all"})
    print_row("wrong signs, all scenes, 1,000 poses", *(" ".join(k[:-1]) for k in keys))
    print("|---|" + "--:|" * len(keys))
    for name in ["all", *names]:
        cells = []
        for key in keys:
            parts = [one[name] for one in by_stratum[key] if name in one]
            cells.append(f"{sum(p[1] + p[2] + p[3] for p in parts)} of {sum(p[0] for p in parts)}")
        print_row(name, *cells)


def banded(options, folder):
    """The scene of issue 2562: isolevel 0, for which libigl answers near it alone, beside an infinite one."""
    paths = [os.path.join(folder, name) for name in ("cube.off", "slide.json")]
    for path, text in zip(paths, OVERLAP):
        write(path, text)
    scene = Scene(options.graze, folder, "overlap", *paths)
    lines = [",".join(str(a + EDGE * n) for a, n in zip(START, (i, j, k)))
             for k in range(SIDES[2]) for j in range(SIDES[1]) for i in range(SIDES[0])]
    scene.take("x,y,z\n" + "\n".join(lines) + "\n", ["grid"] * len(lines))
    counts = {pmc: sum(r["pmc"] == pmc for r in scene.golden) for pmc in ("in", "out")}
    print_row("overlap, grid of " + "×".join(map(str, SIDES)), "isolevel", "poses", "`in` called outside", "deepest of them", "`out` called inside")
    print("|---|" + "--:|" * 5)
    for sign in SIGNS:
        for level in ("0", "inf"):
            for poses in GRID_POSES:
                values, _ = scene.ask("igl_swept", poses, sign, level, grid=(*SIDES, EDGE))
                _, wrong_in, wrong_out, *_ = scene.judged(values)["all"]
                deep = max([-float(r["sdf_high"]) for r, v in zip(scene.golden, values) if r["pmc"] == "in" and v >= 0], default=0)
                print_row(sign, level, poses, f"{wrong_in} of {counts['in']}", f"{deep:.3g}" if wrong_in else "", f"{wrong_out} of {counts['out']}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--count", type=int, default=2000, help="points of each scene")
    options = parser.parse_args()
    options.graze = os.path.abspath(options.graze)
    with tempfile.TemporaryDirectory() as folder:
        programs = compile_programs(folder)
        scenes = [Scene(options.graze, folder, name, *(os.path.join(CASES, path) for path in paths)) for name, paths in SCENES.items()]
        for scene in scenes:
            scene.generate(options.count)
        by_stratum = scattered(scenes, programs)
        print()
        strata_table(by_stratum)
        print()
        if "igl_swept" in programs:
            banded(options, folder)


if __name__ == "__main__":
    main()
