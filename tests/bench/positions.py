"""Positions in the closed sweep: what they cost an `on` point beside its class, and which level decides how many.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import json
import os
import subprocess
from collections import Counter, defaultdict

import measure

CASES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "cases")
# Scenes whose own cost is that of a mesh of many thousand facets.
LARGE = ("freeform", "cartridge", "cutter", "gear", "ball")


def scenes():
    """(dimension, name, solid, motion) of the golden cases of sweeps, smaller ones alone."""
    for folder in sorted(glob.glob(os.path.join(CASES, "*", ""))):
        name = os.path.basename(os.path.dirname(folder))
        motion, solids = os.path.join(folder, "motion.json"), sorted(glob.glob(os.path.join(folder, "solid.*")))
        if os.path.exists(motion) and solids and not name.startswith(("unsweep", *LARGE)):
            yield 2 if solids[0].endswith(".wkt") else 3, name, solids[0], motion


def cost(graze, solid, motion, points, *flags):
    """CPU seconds of a run, and its output."""
    return measure.run_cpu([graze, "classify", solid, motion, points, "--jobs", "1", "--quiet", *flags])[0]


def positions_of(graze, solid, motion, points):
    """Level -> points that are `on` and that it decided, or `undecided`."""
    done = subprocess.run([graze, "classify", solid, motion, points, "--topo", "--format", "jsonl", "--quiet"],
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True)
    out = defaultdict(list)
    for line in done.stdout.splitlines():
        record = json.loads(line)
        if record["pmc"] == "on":
            out[record.get("topo_level", "undecided")].append(record["point"])
    return out


def run(table, graze, folder, count):
    """All rows; `count` points a scene, made by `graze generate`. What a level costs is measured on its points alone."""
    table.head("Positions in the closed sweep of generated points that are `on`, scenes of cases; none may be undecided in the plane")
    levels, seconds = {2: Counter(), 3: Counter()}, {2: Counter(), 3: Counter()}
    points = os.path.join(folder, "positions.csv")
    for dimension, _, solid, motion in scenes():
        with open(points, "w", encoding="ascii") as file:
            subprocess.run([graze, "generate", solid, motion, "-n", str(count), "--seed", "3", "--quiet"], stdout=file, check=True)
        for level, of in positions_of(graze, solid, motion, points).items():
            with open(points, "w", encoding="ascii") as file:
                file.writelines(",".join(p) + "\n" for p in of)
            with_topo, without = cost(graze, solid, motion, points, "--topo"), cost(graze, solid, motion, points)
            levels[dimension][level] += len(of)
            seconds[dimension][level] += max(with_topo - without, 0)
    for dimension, of in levels.items():
        on, spent = sum(of.values()), sum(seconds[dimension].values())
        name = "plane" if dimension == 2 else "space"
        table.row(f"cost an `on` point: {name}, {on:,} points", 1e6 * spent / on, unit=" us", graze=spent / on)
        table.row(f"undecided of 1,000: {name}", 1000 * of["undecided"] / on, most=0 if dimension == 2 else None, unit="")
        for level, n in sorted(of.items()):
            table.row(f"decided by {level}, of 1,000: {name}", 1000 * n / on, unit="")
            table.row(f"cost a point decided by {level}: {name}", 1e6 * seconds[dimension][level] / n, unit=" us",
                      graze=seconds[dimension][level] / n)
