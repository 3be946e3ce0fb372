"""A polyhedral ball of radius 5, as OFF on standard output: 62 corners, all exactly on the sphere.

SPDX-License-Identifier: GPL-3.0-or-later

Two poles and five parallels of twelve corners; (3, 4, 5) triangles give both the parallels' heights
and the corners on them, so every coordinate is rational and every facet exactly plane.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))

from mesh import parallels, print_off, sector  # noqa: E402

PARALLELS = [(3, -4), (4, -3), (5, 0), (4, 3), (3, 4)]  # radius, height


def ball():
    vertices = [(0, 0, -5), *parallels(PARALLELS), (0, 0, 5)]
    facets = []
    for k in range(12):
        side, n = sector(k)
        facets += [*side, (49 + k, 49 + n, 61)]
    return vertices, facets


if __name__ == "__main__":
    print_off(*ball())
