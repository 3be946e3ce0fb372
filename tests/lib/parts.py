"""Meshes as CAD exports them: few large faces, cut into long and thin triangles.

Each is (vertices, facets), closed and oriented outward, and follows from its sizes.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import math



def extruded(points, triangles, bottom, top):
    """The solid over a triangulated region of the plane, counter-clockwise triangles; walls of two triangles."""
    n = len(points)
    vertices = [(x, y, z) for z in (bottom, top) for x, y in points]
    facets = [(a, c, b) for a, b, c in triangles] + [(n + a, n + b, n + c) for a, b, c in triangles]
    directed = {(t[k], t[(k + 1) % 3]) for t in triangles for k in range(3)}
    for a, b in sorted(directed):
        if (b, a) not in directed:
            facets += [(a, b, n + b), (a, n + b, n + a)]
    return vertices, facets


def disk(sides):
    """A disk whose caps are fans around their centres: 4 * sides triangles."""
    rim = [(math.cos(2 * math.pi * k / sides), math.sin(2 * math.pi * k / sides)) for k in range(sides)]
    return extruded(rim + [(0.0, 0.0)], [(sides, k, (k + 1) % sides) for k in range(sides)], -0.15, 0.15)


def plate(slits):
    """A plate with parallel slits; the margins beyond their ends are fans from a corner."""
    step = 2 / (2 * slits + 1)
    xs = [-1 + k * step for k in range(2 * slits + 2)]
    levels = -1.0, -0.8, 0.8, 1.0
    count = len(xs)
    points = [(x, y) for y in levels[1:3] for x in xs]
    points += [(-1.0, levels[0]), (1.0, levels[0]), (1.0, levels[3]), (-1.0, levels[3])]
    low_left, low_right, high_right, high_left = range(2 * count, 2 * count + 4)
    triangles = [(low_left, low_right, count - 1), (high_left, 2 * count - 1, high_right)]
    for k in range(count - 1):
        triangles += [(low_left, k + 1, k), (high_left, count + k, count + k + 1)]
    for k in range(0, count, 2):
        triangles += [(k, k + 1, count + k + 1), (k, count + k + 1, count + k)]
    return extruded(points, triangles, -0.1, 0.1)


def ribs(number):
    """A profile of ribs on a base, pulled over a length of 4: the walls are long triangles."""
    step = 2 / (2 * number - 1)
    xs = [-1 + k * step for k in range(2 * number)]
    count = len(xs)
    points = [(x, 0.0) for x in xs] + [(x, 0.4) for x in xs] + [(-1.0, -0.3), (1.0, -0.3)]
    triangles = [(2 * count, 2 * count + 1, count - 1)]
    triangles += [(2 * count, k + 1, k) for k in range(count - 1)]
    for k in range(0, count, 2):
        triangles += [(k, k + 1, count + k + 1), (k, count + k + 1, count + k)]
    return extruded(points, triangles, -2.0, 2.0)


def lathe(around, profile=((0.3, -2.0), (0.3, 1.2), (0.55, 1.25), (0.55, 1.8), (0.2, 2.0))):
    """A part turned from a profile of (radius, height), closed by fans: slivers along the axis."""
    vertices = [(r * math.cos(2 * math.pi * k / around), r * math.sin(2 * math.pi * k / around), h)
                for r, h in profile for k in range(around)]
    vertices += [(0.0, 0.0, profile[0][1]), (0.0, 0.0, profile[-1][1])]
    below, above, top = len(vertices) - 2, len(vertices) - 1, (len(profile) - 1) * around
    facets = []
    for k in range(around):
        after = (k + 1) % around
        facets += [(below, after, k), (above, top + k, top + after)]
        for level in range(0, top, around):
            facets += [(level + k, level + after, level + around + after),
                       (level + k, level + around + after, level + around + k)]
    return vertices, facets
