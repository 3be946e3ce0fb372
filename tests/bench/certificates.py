"""Certificates: bytes a row, making and checking them beside answers of the exact path alone.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import random
import statistics
import subprocess

import measure
import scenes

SIZES = {12: None, 500: (16, 16), 7000: (59, 60), 100000: (224, 224)}
MOTION = '{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["4*t^4 - t", "2*t^3", "t^2"]}}]}\n'
MOST_BYTES, MOST_MAKING, MOST_CHECKING = 2000, 5, 10
TEETH = 1000
REPEATS = 5


def rows_of(path):
    """The bytes of each row's lines in a certificate."""
    sizes = []
    with open(path, encoding="ascii") as file:
        for line in file:
            if line.startswith("row "):
                sizes.append(0)
            if sizes and not line.startswith("complete "):
                sizes[-1] += len(line)
    return sizes


def write_points(graze, folder, solid, motion, kind, count):
    path = os.path.join(folder, f"{kind}{count}.csv")
    with open(path, "w", encoding="ascii") as file:
        if kind == "degenerate":
            subprocess.run([graze, "generate", solid, motion, "-n", str(count), "--seed", "5", "--quiet"], stdout=file, check=True)
        else:
            rng = random.Random(7)
            file.writelines(f"{rng.uniform(-1.5, 4.5)!r},{rng.uniform(-1.5, 3.5)!r},{rng.uniform(-0.5, 1.5)!r}\n" for _ in range(count))
    return path


def a_row(count, command):
    """CPU seconds a row: the time of `count` rows without that of one, each the best of some runs, since a small solid's
    rows take less than the start of a program varies by; None where they still do. `command` has a place for the
    number."""
    one, all_ = (min(measure.run_cpu(command(n))[0] for _ in range(REPEATS)) for n in (1, count))
    return (all_ - one) / (count - 1) if all_ > one else None


def as_multiple(spent, of):
    return spent / of if spent and of else None


def measured(table, graze, folder, faces, solid, motion, kind, count):
    points = {n: write_points(graze, folder, solid, motion, kind, n) for n in (1, count)}
    certificate = lambda n: os.path.join(folder, f"certificate{n}")
    exact = a_row(count, lambda n: [graze, "classify", solid, motion, points[n], "--no-filter", "--jobs", "1", "--quiet"])
    making = a_row(count, lambda n: [graze, "certify", solid, motion, points[n], "--jobs", "1", "-o", certificate(n)])
    check = os.path.join(os.path.dirname(graze), "graze-check")
    checking = a_row(count, lambda n: [check, solid, motion, certificate(n), "--assume-legal"])
    name = f"{faces:,} faces, {kind}"
    table.row(f"bytes a row, median: {name}", statistics.median(rows_of(certificate(count))), most=MOST_BYTES, unit=" B")
    subprocess.run([graze, "certify", solid, motion, points[count], "--times", "--quiet", "-o", certificate(0)], check=True)
    table.row(f"  with times and cells of the contacts: {name}", statistics.median(rows_of(certificate(0))), unit=" B")
    table.row(f"making a row / classify --no-filter: {name}", as_multiple(making, exact), most=MOST_MAKING, graze=making, peer=exact)
    table.row(f"checking a row / classify --no-filter: {name}", as_multiple(checking, exact), most=MOST_CHECKING, graze=checking, peer=exact)


def beside(table, graze, folder):
    """One trajectory that runs beside many facets: along the tips of a saw, 1/1000 away, up a slope of 1/10."""
    tips = [(x, x / 10 + (x % 2)) for x in range(2 * TEETH, -1, -1)]
    files = {"saw.wkt": "POLYGON ((" + ", ".join(f"{x} {y}" for x, y in [(0, -1), (2 * TEETH, -1), *tips, (0, -1)]) + "))\n",
             "along.json": '{"dimension": 2, "pieces": [{"t": ["0", "1"], "transform": {"translate": '
                           f'["-{2 * TEETH}*t", "-{TEETH / 5}*t"]}}}}]}}\n',
             "tip.csv": "0,1.001\n"}
    for name, text in files.items():
        with open(os.path.join(folder, name), "w", encoding="ascii") as file:
            file.write(text)
    solid, motion, points, certificate = (os.path.join(folder, name) for name in [*files, "saw.certificate"])
    making = measure.run_cpu([graze, "certify", solid, motion, points, "--jobs", "1", "-o", certificate])[0]
    check = os.path.join(os.path.dirname(graze), "graze-check")
    checking = measure.run_cpu([check, solid, motion, certificate])[0]
    with open(certificate, encoding="ascii") as file:
        intervals = sum(line.startswith("O ") for line in file)
    table.row(f"bytes of one row beside {TEETH:,} teeth, its making with the solid's loading", rows_of(certificate)[0], unit=" B", graze=making)
    table.row("  its intervals, its checking with the solid's", intervals, unit="", graze=checking)


def run(table, graze, folder, count):
    """All rows; `count` points each."""
    table.head("Certificates, one piece of degree 4; the peer is graze classify --no-filter")
    motion = os.path.join(folder, "certified.json")
    with open(motion, "w", encoding="ascii") as file:
        file.write(MOTION)
    for faces, size in SIZES.items():
        solid = os.path.join(folder, f"certified{faces}.off")
        mesh = scenes.torus(*size) if size else scenes.prism([(0, 0), (1, 0), (1, 1), (0, 1)], 0, 1)
        scenes.write_off(solid, mesh)
        for kind in ("random", "degenerate"):
            measured(table, graze, folder, faces, solid, motion, kind, count)
    beside(table, graze, folder)
