"""A smooth closed body, as OFF on standard output: a sphere grid with a radius that varies.

SPDX-License-Identifier: GPL-3.0-or-later

Two poles and eleven parallels of twenty corners in rational directions d; the corner is r(d) d with
r = 3 + x^3 + y z + z^2/2, rounded to 1/64. The surface is a graph over the sphere, so it
does not meet itself.
"""
import os
import sys
from fractions import Fraction as F

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))

from mesh import print_off  # noqa: E402

AROUND, HEIGHTS = 20, 11


def on_circle(share):
    """A rational point of the unit circle near the angle 2 pi share, for 0 <= share < 1."""
    quarter, rest = divmod(4 * share, 1)
    u = rest * (F(83, 100) + rest * F(17, 100))  # half-angle tangent, from 0 to 1
    x, y = (1 - u * u) / (1 + u * u), 2 * u / (1 + u * u)
    for _ in range(int(quarter)):
        x, y = -y, x
    return x, y


def corner(d):
    x, y, z = d
    r = 3 + x**3 + y * z + z * z / 2
    return tuple(F(round(64 * r * c), 64) for c in d)


def body():
    vertices = [corner((F(0), F(0), F(-1)))]
    for j in range(1, HEIGHTS + 1):
        height, radius = on_circle(F(j, 2 * (HEIGHTS + 1)))
        for k in range(AROUND):
            x, y = on_circle(F(k, AROUND))
            vertices.append(corner((radius * x, radius * y, -height)))
    vertices.append(corner((F(0), F(0), F(1))))
    last, facets = len(vertices) - 1, []
    for k in range(AROUND):
        n = (k + 1) % AROUND
        facets.append((0, 1 + n, 1 + k))
        for a in range(1, last - AROUND, AROUND):
            facets += [(a + k, a + n, a + n + AROUND), (a + k, a + n + AROUND, a + k + AROUND)]
        facets.append((last - AROUND + k, last - AROUND + n, last))
    return vertices, facets


if __name__ == "__main__":
    print_off(*body())
