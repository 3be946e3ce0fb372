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
import time
from collections import defaultdict
from fractions import Fraction as F

HERE = os.path.dirname(os.path.abspath(__file__))
CASES = os.path.dirname(HERE)
SCENES = {"bracket": ("bracket/solid.off", "bracket/motion.json"), "arch": ("candidates/ell.off", "candidates/arch.json"),
          "turn": ("candidates/ell.off", "candidates/turn.json"), "climb": ("distance-climb/solid.off", "distance-climb/motion.json")}
POSES = (10, 100, 1000)
SIGNS = ("pseudonormal", "winding", "fast")
SIDES = 24  # of the grid
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


class Scene:
    """A scene with triangles, its points and their enclosures."""

    def __init__(self, options, folder, name):
        self.name, self.folder, self.graze = name, folder, options.graze
        solid, self.motion = (os.path.join(CASES, path) for path in SCENES[name])
        self.solid = os.path.join(folder, name + ".off")
        output(self.graze, "convert", solid, "-o", self.solid)
        self.points = os.path.join(folder, name + ".csv")
        made = output(self.graze, "generate", self.solid, self.motion, "-n", str(options.count), "--seed", "1",
                      "--representable", "binary64", "--quiet")
        self.save(made)
        self.strata = [row["stratum"] for row in rows_of(made)]
        self.golden, self.seconds = self.enclosed()

    def save(self, text):
        with open(self.points, "w", encoding="ascii") as file:
            file.write(text)

    def enclosed(self):
        start = time.process_time(), os.times().children_user
        found = rows_of(output(self.graze, "classify", self.solid, self.motion, self.points, "--sdf", "1e-6r", "--quiet", "--jobs", "1"))
        return found, os.times().children_user - start[1]

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
                one[4] += value > high
                one[5] = max(one[5], error)
        return found


def to_grid(scene):
    """Exchange the points for a grid of the sweep's box, x first; the edge is returned."""
    box = [(min(F(r[a]) for r in scene.golden), max(F(r[a]) for r in scene.golden)) for a in "xyz"]
    edge = F(round(64 * max(b - a for a, b in box) / (SIDES - 3)) + 1, 64)
    start = [F(round(64 * ((a + b) / 2 - edge * (SIDES - 1) / 2)), 64) for a, b in box]
    lines = [",".join(str(float(s + edge * k)) for s, k in zip(start, (i, j, k)))
             for k in range(SIDES) for j in range(SIDES) for i in range(SIDES)]
    scene.save("x,y,z\n" + "\n".join(lines) + "\n")
    scene.strata = ["grid"] * len(lines)
    scene.golden, scene.seconds = scene.enclosed()
    return edge


def print_row(*cells):
    print("| " + " | ".join(map(str, cells)) + " |")


def scattered(scenes, programs):
    print_row("scene", "candidate", "poses", "`in` called outside", "`on` called inside", "`out` called inside", "above sdf_high",
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


def banded(scenes, programs):
    if "igl_swept" not in programs:
        return
    print_row(f"scene, grid of {SIDES}³, isolevel 0", "poses", "`in` called outside", "`out` called inside",
              "the same with infinite isolevel", "largest depth called outside, in grid edges")
    print("|---|" + "--:|" * 5)
    for scene in scenes:
        edge = to_grid(scene)
        counts = {pmc: sum(r["pmc"] == pmc for r in scene.golden) for pmc in ("in", "out")}
        for poses in POSES:
            cells = []
            for level in ("0", "inf"):
                values, _ = scene.ask("igl_swept", poses, "pseudonormal", level, grid=(SIDES, SIDES, SIDES, float(edge)))
                one = scene.judged(values)["all"]
                cells.append(one)
                if level == "0":
                    deep = max([-F(r["sdf_high"]) / edge for r, v in zip(scene.golden, values) if r["pmc"] == "in" and v >= 0], default=0)
            print_row(scene.name, poses, f"{cells[0][1]} of {counts['in']}", f"{cells[0][2]} of {counts['out']}",
                      f"{cells[1][1]}, {cells[1][2]}", f"{float(deep):.2f}")
            sys.stdout.flush()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--count", type=int, default=2000, help="points of each scene")
    options = parser.parse_args()
    options.graze = os.path.abspath(options.graze)
    with tempfile.TemporaryDirectory() as folder:
        programs = compile_programs(folder)
        scenes = [Scene(options, folder, name) for name in SCENES]
        by_stratum = scattered(scenes, programs)
        print()
        strata_table(by_stratum)
        print()
        banded(scenes, programs)


if __name__ == "__main__":
    main()
