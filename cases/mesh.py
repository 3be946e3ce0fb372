"""What the programs that make large solids share: bodies turned about the z axis in twelve steps, and OFF.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from fractions import Fraction as F

# Twelve points of the circle of radius 5, from the (3, 4, 5) triangle: parallels through them have plane facets
# between them.
CIRCLE = [(5, 0), (4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3), (-5, 0), (-4, -3), (-3, -4), (0, -5),
          (3, -4), (4, -3)]


def parallels(profile):
    """Twelve corners at each (radius, height)."""
    return [(F(r * x, 5), F(r * y, 5), z) for r, z in profile for x, y in CIRCLE]


def sector(k):
    """The facets of sector k from vertex 0, below, over five parallels; and the number of the next sector."""
    n = (k + 1) % 12
    return [(0, 1 + n, 1 + k)] + [(a + k, a + n, a + n + 12, a + k + 12) for a in (1, 13, 25, 37)], n


def print_off(vertices, facets):
    print(f"OFF\n{len(vertices)} {len(facets)} 0")
    for v in vertices:
        print(*v)
    for f in facets:
        print(len(f), *f)
