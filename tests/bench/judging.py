"""A mesh of 100,000 triangles judged against a sweep: CPU seconds to the width of 1e-2 of the diagonal, which must be
reached, and with a third of it.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
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


def run(table, graze, folder, quick):
    table.head("Meshes judged")
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
