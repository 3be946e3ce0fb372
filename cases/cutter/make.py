"""A milling cutter, as OFF on standard output: a profile turned around the z axis in twelve steps.

SPDX-License-Identifier: GPL-3.0-or-later

The tip is the origin. The twelve corners of a parallel come from the (3, 4, 5) triangle, so every
facet is exactly plane.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))

from mesh import parallels, print_off, sector  # noqa: E402

PROFILE = [(2, 1), (3, 3), (3, 8), (2, 9), (2, 14)]  # radius, height; above the tip (0, 0)


def cutter():
    facets = [facet for k in range(12) for facet in sector(k)[0]]
    return [(0, 0, 0), *parallels(PROFILE)], [*facets, tuple(range(49, 61))]


if __name__ == "__main__":
    print_off(*cutter())
