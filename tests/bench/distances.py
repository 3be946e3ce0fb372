"""Enclosed distances to the sweep beside CGAL's closest points of 1,000 sampled positions, and cost against tolerance.

A sampled distance bounds nothing: it is only near the distance at the times asked.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import statistics

import scenes
from measure import fitting, in_turns

REPEATS = 5
SIZES = (1000, 100000)
SAMPLES = 1000
TOLERANCE = 1e-6
TOLERANCES = [10.0 ** -k for k in range(2, 13, 2)]
WIDTH = 1.25  # of the box of points, in that of the sweep


def enclosed(bench, inside, tolerance):
    path = bench.path("distance.points")
    return lambda start, n: inside.ask("distances", path, start, n, tolerance)["seconds"]


def against_closest(bench, size, inside, peers):
    sampled = lambda start, n: peers.ask("closest", bench.path("distance.points"), start, n,
                                         bench.path("distance.samples"))["seconds"]
    peer, graze, ratio, n = in_turns(sampled, enclosed(bench, inside, TOLERANCE), bench.total, bench.target, REPEATS)
    told = inside.ask("distances", bench.path("distance.points"), 0, n, TOLERANCE)
    bench.table.row(f"distances to {TOLERANCE:g} against CGAL's closest at {SAMPLES:,} times, {size:,} faces ({n:,} points)",
                    ratio, least=5, graze=graze, peer=peer)
    bench.table.note(f"{told['out'] / n:.0%} of them out, {told['wide']:.0f} enclosed less closely than asked for")


def against_tolerance(bench, size, inside):
    first = None
    for tolerance in TOLERANCES:
        ask = enclosed(bench, inside, tolerance)
        n = fitting(ask, bench.total // REPEATS, bench.target)
        spent = statistics.median(ask(r * n, n) / n for r in range(REPEATS))
        first = first or spent
        bench.table.row(f"distances to {tolerance:g}, {size:,} faces, as multiple of the first ({n:,} points)", spent / first, graze=spent)


def measure(bench):
    bench.table.head("Distances to the sweep: a rotation with translation, points in a box about it")
    points = scenes.points_around(scenes.ROTATION, scenes.TORUS_BOX, WIDTH, bench.total, 1)
    scenes.save_points(bench.folder, "distance", scenes.ROTATION, points)
    scenes.save_samples(bench.path("distance.samples"), scenes.ROTATION, SAMPLES)
    for size in (n for n in SIZES if n <= bench.options.largest):
        solid = f"distance{size}.off"
        scenes.write_off(bench.path(solid), scenes.torus(*scenes.TORUS_SIZES[size]))
        inside, peers = bench.inside(solid), bench.peers(solid)
        inside.ask("motion", bench.path("rotation.json"))
        against_closest(bench, size, inside, peers)
        against_tolerance(bench, size, inside)
        inside.close()
        peers.close()
