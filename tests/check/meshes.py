"""Meshes as (points, faces), and what is made of them.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from exact import Fraction

SQUARE = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"
CUBE = ([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))],
        [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])
MOVE = {3: '{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["t", "0", "0"]}}]}',
        2: '{"dimension": 2, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["t", "0"]}}]}'}


def scaled(solid, factor, shift=(0, 0, 0)):
    points, faces = solid
    return [tuple(str(factor * Fraction(c) + Fraction(s)) for c, s in zip(p, shift)) for p in points], list(faces)


def turned(solid):
    return solid[0], [face[::-1] for face in solid[1]]


def both(*solids):
    points, faces = [], []
    for p, f in solids:
        faces += [tuple(v + len(points) for v in face) for face in f]
        points += p
    return points, faces


def without(solid, face):
    return solid[0], [f for k, f in enumerate(solid[1]) if k != face]


def off(solid):
    points, faces = solid
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(str, p)) for p in points] + [" ".join(map(str, (len(f), *f))) for f in faces]
    return "\n".join(lines) + "\n"


def prism(outline, low, high):
    n = len(outline)
    return ([(x, y, z) for z in (low, high) for x, y in outline],
            [tuple(range(n))[::-1], tuple(range(n, 2 * n)),
             *((k, (k + 1) % n, n + (k + 1) % n, n + k) for k in range(n))])


def tetrahedron(*points):
    """Outward oriented."""
    a, b, c, d = ([Fraction(x) for x in p] for p in points)
    u, v, w = ([x - y for x, y in zip(p, a)] for p in (b, c, d))
    det = sum(u[i] * (v[(i + 1) % 3] * w[(i + 2) % 3] - v[(i + 2) % 3] * w[(i + 1) % 3]) for i in range(3))
    faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
    return list(points), faces if det > 0 else [f[::-1] for f in faces]
