"""A milling cutter, as OFF on standard output: a profile turned around the z axis in twelve steps.

SPDX-License-Identifier: GPL-3.0-or-later

The tip is the origin. The twelve corners of a parallel come from the (3, 4, 5) triangle, so every
facet is exactly plane.
"""
from fractions import Fraction as F

CIRCLE = [(5, 0), (4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3), (-5, 0), (-4, -3), (-3, -4), (0, -5),
          (3, -4), (4, -3)]
PROFILE = [(2, 1), (3, 3), (3, 8), (2, 9), (2, 14)]  # radius, height; above the tip (0, 0)


def cutter():
    vertices = [(0, 0, 0)]
    vertices += [(F(r * x, 5), F(r * y, 5), z) for r, z in PROFILE for x, y in CIRCLE]
    facets = []
    for k in range(12):
        n = (k + 1) % 12
        facets.append((0, 1 + n, 1 + k))
        facets += [(a + k, a + n, a + n + 12, a + k + 12) for a in (1, 13, 25, 37)]
    facets.append(tuple(range(49, 61)))
    return vertices, facets


def main():
    vertices, facets = cutter()
    print(f"OFF\n{len(vertices)} {len(facets)} 0")
    for v in vertices:
        print(*v)
    for f in facets:
        print(len(f), *f)


if __name__ == "__main__":
    main()
