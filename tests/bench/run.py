#!/usr/bin/env python3
"""Speed of the exact path on one core, through `graze classify --jobs 1`.

Each figure is the slope between two row counts in one run, so that loading is left out; medians of five. Rates
move with the machine: compare only figures of one run.
"""
import argparse
import math
import os
import random
import statistics
import subprocess
import tempfile
import time


def sphere(rings, segments, bump):
    """A bumpy sphere with 2 * segments * (rings - 1) triangles, coordinates binary64."""
    vertices = [(0.0, 0.0, 1.0)]
    for i in range(1, rings):
        for j in range(segments):
            a, b = math.pi * i / rings, 2 * math.pi * j / segments
            r = 1 + bump * math.sin(5 * a) * math.cos(7 * b)
            vertices.append((r * math.sin(a) * math.cos(b), r * math.sin(a) * math.sin(b),
                             r * math.cos(a)))
    vertices.append((0.0, 0.0, -1.0))
    at = lambda i, j: 1 + (i - 1) * segments + j % segments
    facets = []
    for j in range(segments):
        facets.append((0, at(1, j), at(1, j + 1)))
        facets.append((len(vertices) - 1, at(rings - 1, j + 1), at(rings - 1, j)))
        for i in range(1, rings - 1):
            facets.append((at(i, j), at(i + 1, j), at(i + 1, j + 1)))
            facets.append((at(i, j), at(i + 1, j + 1), at(i, j + 1)))
    return vertices, facets


def cube():
    vertices = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return vertices, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def write_off(path, vertices, facets):
    with open(path, "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(vertices)} {len(facets)} 0\n")
        file.writelines(f"{x!r} {y!r} {z!r}\n" for x, y, z in vertices)
        file.writelines(f"{len(f)} {' '.join(map(str, f))}\n" for f in facets)


MOTIONS = {
    "translation": '{"dimension": 3, "pieces": [{"t": ["0", "1"], '
                   '"transform": {"translate": ["3*t", "t/2", "t/4"]}}]}',
    "quarter turn with translation":
        '{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"compose": ['
        '{"rotate": {"axis": ["0", "0", "1"], "tan_half": "t"}}, '
        '{"translate": ["3*t", "t/2", "t/4"]}]}}]}',
}


def seconds(graze, solid, motion, points, rows, folder):
    path = os.path.join(folder, "points.csv")
    with open(path, "w", encoding="ascii") as file:
        file.writelines(f"{x!r},{y!r},{z!r}\n" for x, y, z in points[:rows])
    start = time.perf_counter()
    subprocess.run([graze, "classify", "--jobs", "1", solid, motion, path], check=True,
                   stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


def rate(graze, solid, motion, rows, folder):
    rng = random.Random(1)
    points = [(rng.uniform(-1.2, 4.2), rng.uniform(-1.2, 1.7), rng.uniform(-1.2, 1.45))
              for _ in range(rows)]
    few = rows // 5
    slopes = []
    for _ in range(5):
        slopes.append((seconds(graze, solid, motion, points, rows, folder) -
                       seconds(graze, solid, motion, points, few, folder)) / (rows - few))
    return 1 / statistics.median(slopes)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--graze", default="build/graze")
    options = parser.parse_args()
    solids = [("cube, 12 facets", cube(), 20000), ("bumpy sphere, 1,012 facets", sphere(23, 23, 0.05), 5000),
              ("bumpy sphere, 7,080 facets", sphere(60, 60, 0.05), 2500),
              ("bumpy sphere, 100,352 facets", sphere(225, 224, 0.05), 1000)]
    print(f"{'solid':32}{'motion':34}{'points a second':>16}")
    with tempfile.TemporaryDirectory() as folder:
        for name, (vertices, facets), rows in solids:
            solid = os.path.join(folder, "solid.off")
            write_off(solid, vertices, facets)
            for motion_name, text in MOTIONS.items():
                motion = os.path.join(folder, "motion.json")
                with open(motion, "w", encoding="ascii") as file:
                    file.write(text)
                print(f"{name:32}{motion_name:34}{rate(options.graze, solid, motion, rows, folder):16.0f}",
                      flush=True)


if __name__ == "__main__":
    main()
