"""A mesh of 100,000 triangles judged against a sweep: CPU seconds to the width of 1e-2 of the diagonal, which must be
reached, and with a third of it.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import re
import subprocess

from measure import run_cpu

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
# name, solid and motion, depth of the boundary's cells for about 100,000 triangles
SCENES = [
    ("bracket", "cases/bracket/solid.off", "cases/bracket/motion.json", 6),
    ("plate, 1e-3 thin, that moves by its length and turns", "tests/judge/plate.off", "tests/judge/plate.json", 6),
]
WIDTHS = ("1e-2r", "3e-3r")
SECONDS = 120


# The unit cube moved straight, and its sweep: a hull of 14 corners, or of 8, as triangles.
CUBE = """OFF
8 6 0
0 0 0
1 0 0
0 1 0
1 1 0
0 0 1
1 0 1
0 1 1
1 1 1
4 0 2 3 1
4 4 5 7 6
4 0 1 5 4
4 2 6 7 3
4 0 4 6 2
4 1 3 7 5
"""
PERFECT_SECONDS = 1.5


def perfect(table, graze, folder):
    """Default options; the longer box is 12 triangles."""
    cube, motion, mesh = (os.path.join(folder, name) for name in ("unit.off", "along.json", "long.off"))
    for path, text in ((cube, CUBE), (mesh, re.sub(r"(?m)^1 ([01] [01])$", r"5 \1", CUBE)),
                       (motion, '{"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["4*t", "0", "0"]}}]}')):
        with open(path, "w", encoding="ascii") as file:
            file.write(text)
    words = [graze, "judge", cube, motion, mesh, "--no-points", "--format", "json"]
    report = json.loads(subprocess.run(words, check=True, capture_output=True).stdout)
    table.row("a cube moved by 4 and its exact box", run_cpu(words)[0], most=PERFECT_SECONDS, unit=" s")
    volume = report["volume"]["sweep"]
    if not report["budget"]["reached"] or volume["high"] - volume["low"] > 0.05:
        table.note("the width was NOT reached, or the volume is not within 1 %")
    bracket = [os.path.join(ROOT, "cases", "bracket", name) for name in ("solid.off", "motion.json")]
    own = os.path.join(folder, "own.ply")
    words = [graze, "boundary", *bracket, "--depth", "5", "--surface", own]
    table.row("graze boundary of the bracket, depth 5", run_cpu(words)[0], unit=" s")
    table.row("that surface judged", run_cpu([graze, "judge", *bracket, own, "--no-points"])[0], unit=" s")


def run(table, graze, folder, quick):
    table.head("Meshes judged")
    perfect(table, graze, folder)
    for name, solid, motion, depth in SCENES:
        scene = [os.path.join(ROOT, path) for path in (solid, motion)]
        mesh = os.path.join(folder, "judged.ply")
        subprocess.run([graze, "boundary", *scene, "--depth", str(depth), "--middles", "--surface", mesh], check=True,
                       capture_output=True)
        for width in WIDTHS[:1] if quick else WIDTHS:
            words = [graze, "judge", *scene, mesh, "--within", width, "--no-points", "--format", "json"]
            seconds = run_cpu(words)[0]
            report = json.loads(subprocess.run(words, check=True, capture_output=True).stdout)
            budget, triangles = report["budget"], report["mesh"]["triangles"]
            table.row(f"{name}: {triangles:,} triangles within {width}, {budget['cells']:,} cubes and points", seconds,
                      most=SECONDS if width == WIDTHS[0] else None, unit=" s")
            if not budget["reached"]:
                table.note("the width was NOT reached")
