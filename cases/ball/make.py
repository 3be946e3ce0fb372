"""A polyhedral ball of radius 5, as OFF on standard output: 62 corners, all exactly on the sphere.

SPDX-License-Identifier: GPL-3.0-or-later

Two poles and five parallels of twelve corners; (3, 4, 5) triangles give both the parallels' heights
and the corners on them, so every coordinate is rational and every facet exactly plane.
"""
from fractions import Fraction as F

CIRCLE = [(5, 0), (4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3), (-5, 0), (-4, -3), (-3, -4), (0, -5),
          (3, -4), (4, -3)]
PARALLELS = [(3, -4), (4, -3), (5, 0), (4, 3), (3, 4)]  # radius, height


def ball():
    vertices = [(0, 0, -5)]
    vertices += [(F(r * x, 5), F(r * y, 5), z) for r, z in PARALLELS for x, y in CIRCLE]
    vertices.append((0, 0, 5))
    facets = []
    for k in range(12):
        n = (k + 1) % 12
        facets.append((0, 1 + n, 1 + k))
        facets += [(a + k, a + n, a + n + 12, a + k + 12) for a in (1, 13, 25, 37)]
        facets.append((49 + k, 49 + n, 61))
    return vertices, facets


def main():
    vertices, facets = ball()
    print(f"OFF\n{len(vertices)} {len(facets)} 0")
    for v in vertices:
        print(*v)
    for f in facets:
        print(len(f), *f)


if __name__ == "__main__":
    main()
