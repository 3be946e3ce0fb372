"""Rows of commands for which people wait: a start, points whose coordinates are doubles, and a page of points, in CPU seconds of
whole programs, against `graze classify` of the same points.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import statistics
import subprocess

import scenes
from measure import run_cpu

COUNT = 2000
REPEATS = 3
CASES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "cases")
# Scenes, and the largest ratio. The curved solid, whose draws are each traced to be confirmed, has none.
GENERATED = {"torus 1000 translation": 3, "torus 10000 rotation": 4, "torus 10000 screw": 3, "bracket": 3, "gear": 3,
             "freeform": 3, "cutter": 3.5, "curved-torus-plate": None}
STARTS = 100        # runs of a program that ends at once
LIBRARIES = ("-lyajl", "-lmd", "-lflint", "-lmpfr", "-lgmp", "-lstdc++", "-lm")
PAGES = ("torus 1000 translation", "torus 10000 rotation", "bracket", "freeform")


def scene_of(name, folder):
    """The paths of solid and motion; those of a torus are written."""
    if name.startswith("torus"):
        _, faces, motion = name.split()
        paths = [os.path.join(folder, f"waiting{faces}.off"), os.path.join(folder, f"waiting-{motion}.json")]
        scenes.write_off(paths[0], scenes.torus(*scenes.TORUS_SIZES[int(faces)]))
        with open(paths[1], "w", encoding="ascii") as file:
            file.write({"translation": scenes.TRANSLATION, "rotation": scenes.ROTATION, "screw": scenes.SCREW}[motion].json)
        return paths
    case = os.path.join(CASES, name)
    return [os.path.join(case, next(f for f in sorted(os.listdir(case)) if f.startswith("solid."))), os.path.join(case, "motion.json")]


def against_classify(table, graze, work, command, paths, points, most):
    """Medians of the CPU seconds of a command and of `classify`, which take turns, and of their ratio."""
    classify = [graze, "classify", *paths, points, "--jobs", "1", "--quiet"]
    pairs = [(run_cpu(command)[0], run_cpu(classify)[0]) for _ in range(REPEATS)]
    table.row(work, statistics.median(a / b for a, b in pairs), most=most,
              graze=statistics.median(a for a, _ in pairs) / COUNT, peer=statistics.median(b for _, b in pairs) / COUNT)


def against_nothing(table, graze, folder):
    """`graze check` of a cube against a program that does nothing, with the libraries of graze."""
    cube, motion, nothing = (os.path.join(folder, name) for name in ("start.off", "start.json", "nothing"))
    subprocess.run(["cc", "-x", "c", "-", "-o", nothing, "-Wl,--no-as-needed", *LIBRARIES], input=b"int main(void) { return 0; }", check=True)
    subprocess.run([graze, "solid", "box", "--size", "2,2,2", "-o", cube], check=True, stderr=subprocess.DEVNULL)
    with open(motion, "w", encoding="ascii") as file:
        file.write(scenes.TRANSLATION.json)
    pairs = [(run_cpu([graze, "check", cube, motion])[0], run_cpu([nothing])[0]) for _ in range(STARTS)]
    check, idle = (statistics.median(times) for times in zip(*pairs))
    table.row("check of a cube / an empty program of the same libraries", check / idle, most=1.35, graze=check, peer=idle)


def run(table, graze, folder):
    table.head(f"{COUNT:,} points: generate --representable binary64, and a page, against classify of the same points")
    against_nothing(table, graze, folder)
    points = os.path.join(folder, "waiting.csv")
    made = lambda paths, *flags: [graze, "generate", *paths, "-n", str(COUNT), "--seed", "1", "--quiet", *flags, "--output", points]
    for name, most in GENERATED.items():
        paths = scene_of(name, folder)
        command = made(paths, "--representable", "binary64")
        run_cpu(command)
        against_classify(table, graze, f"generate / classify: {name}", command, paths, points, most)
    for name in PAGES:
        paths = scene_of(name, folder)
        run_cpu(made(paths))
        page = [graze, "draw", *paths, points, "-o", os.path.join(folder, "waiting.html")]
        against_classify(table, graze, f"page / classify: {name}", page, paths, points, None)
