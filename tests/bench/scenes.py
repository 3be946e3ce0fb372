"""Input of the measurements: meshes, motions and query points, in the peers' forms too.

Invariant: everything follows from sizes and seeds. A motion is written for Graze as exact text and computed
here in doubles for the peers, which see segments, chords and sampled matrices of its inverse.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import array
import json
import math
import random
from fractions import Fraction


def torus(rings, segments):
    """A torus of 2 * rings * segments triangles about the z axis, vertices in binary64."""
    vertices = []
    for i in range(rings):
        for j in range(segments):
            a, b = 2 * math.pi * i / rings, 2 * math.pi * j / segments
            r = 1 + 0.4 * math.cos(b)
            vertices.append((r * math.cos(a), r * math.sin(a), 0.4 * math.sin(b)))
    at = lambda i, j: i % rings * segments + j % segments
    facets = []
    for i in range(rings):
        for j in range(segments):
            facets.append((at(i, j), at(i + 1, j), at(i + 1, j + 1)))
            facets.append((at(i, j), at(i + 1, j + 1), at(i, j + 1)))
    return vertices, facets


TORUS_BOX = (-1.4, -1.4, -0.4), (1.4, 1.4, 0.4)
TORUS_SIZES = {1000: (22, 23), 10000: (70, 72), 100000: (224, 224), 1000000: (707, 707)}


def prism(outline, bottom, top):
    """The solid over a counter-clockwise outline of integer points; facets are polygons."""
    n = len(outline)
    vertices = [(x, y, z) for z in (bottom, top) for x, y in outline]
    facets = [tuple(range(n - 1, -1, -1)), tuple(range(n, 2 * n))]
    facets += [(k, (k + 1) % n, n + (k + 1) % n, n + k) for k in range(n)]
    return vertices, facets


# With AXIS_PARALLEL both sweep from 20 to 180 along each axis.
BLOCK = prism([(20, 20), (120, 20), (120, 180), (20, 180)], 20, 180)
L_SHAPE = prism([(20, 20), (120, 20), (120, 100), (60, 100), (60, 180), (20, 180)], 20, 180)


def write_off(path, mesh, digits=0):
    """Write OFF: every coordinate in full, or as a decimal with `digits` further digits of its own."""
    vertices, facets = mesh
    rng = random.Random(2)
    tail = lambda: str(rng.randrange(10 ** (digits - 1), 10 ** digits)) if digits else ""
    number = (lambda x: f"{x:.17f}{tail()}") if digits else repr
    with open(path, "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(vertices)} {len(facets)} 0\n")
        file.writelines(" ".join(map(number, v)) + "\n" for v in vertices)
        file.writelines(f"{len(f)} {' '.join(map(str, f))}\n" for f in facets)


# ------------------------------------------------------------------------------------------- motions
def turned(axis, cosine, sine):
    """The matrix of a rotation about a unit axis."""
    x, y, z = axis
    c, s, k = cosine, sine, 1 - cosine
    return ((c + x * x * k, x * y * k - z * s, x * z * k + y * s),
            (y * x * k + z * s, c + y * y * k, y * z * k - x * s),
            (z * x * k - y * s, z * y * k + x * s, c + z * z * k))


class Motion:
    """M(t) = translation ∘ rotation about an axis through a centre, t from 0 to 1."""

    def __init__(self, transform, shift, angle=None, axis=(0, 0, 1), centre=(0, 0, 0)):
        self.json = json.dumps({"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": transform}]})
        self.shift, self.angle, self.axis, self.centre = shift, angle, axis, centre

    def matrix(self, t):
        return turned(self.axis, *self.angle(t)) if self.angle else ((1, 0, 0), (0, 1, 0), (0, 0, 1))

    def forward(self, t, y):
        r, c, v = self.matrix(t), self.centre, self.shift(t)
        d = [y[k] - c[k] for k in range(3)]
        return tuple(sum(r[i][k] * d[k] for k in range(3)) + c[i] + v[i] for i in range(3))

    def inverse(self, t):
        """M(t)^-1 as 12 numbers, row by row."""
        r, c, v = self.matrix(t), self.centre, self.shift(t)
        rows = []
        for i in range(3):
            column = [r[k][i] for k in range(3)]
            rows += column + [c[i] - sum(column[k] * (c[k] + v[k]) for k in range(3))]
        return rows


def tan_half(t):
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


def full_turn(t):
    """Four quarters; in each the tangent of the half angle runs from 0 to 1."""
    quarter = min(int(4 * t), 3)
    c, s = tan_half(4 * t - quarter)
    return [(c, s), (-s, c), (-c, -s), (s, -c)][quarter]


TRANSLATION = Motion({"translate": ["1.4*t", "0.7*t", "0.3*t"]}, lambda t: (1.4 * t, 0.7 * t, 0.3 * t))
# Rotation of degree 2 and a translation of degree 2: pullbacks of degree 4.
ROTATION = Motion(
    {"compose": [{"rotate": {"axis": ["2/7", "3/7", "6/7"], "center": ["1/2", "0", "0"], "tan_half": "t"}},
                 {"translate": ["0.7*t", "t^2/2", "t/4"]}]},
    lambda t: (0.7 * t, t * t / 2, t / 4), tan_half, (2 / 7, 3 / 7, 6 / 7), (0.5, 0, 0))
SCREW = Motion(
    {"compose": [{"turn": {"quarters": 4, "axis": ["1", "0", "0"], "center": ["0", "0.2", "0"]}},
                 {"translate": ["0.4*t", "0", "0"]}]},
    lambda t: (0.4 * t, 0, 0), full_turn, (1, 0, 0), (0, 0.2, 0))
AXIS_PARALLEL = Motion({"translate": ["60*t", "0", "0"]}, lambda t: (60 * t, 0, 0))
# The grid's points are the integers from 0 to 199: the planes of both solids are planes of the grid.
GRID_SIZE = 200


# -------------------------------------------------------------------------------------------- points
def save(path, numbers):
    with open(path, "wb") as file:
        array.array("d", numbers).tofile(file)


def points_crossing(motion, box, count, seed):
    """Points P = M(t) y, y uniform in the solid's box: every trajectory runs through the box."""
    rng = random.Random(seed)
    low, high = box
    return [motion.forward(rng.random(), [rng.uniform(low[k], high[k]) for k in range(3)])
            for _ in range(count)]


def points_around(motion, box, width, count, seed):
    """Points uniform in a box `width` times as wide as that of `points_crossing`."""
    sample = points_crossing(motion, box, 2000, seed + 1)
    rng = random.Random(seed)
    ends = [(min(p[k] for p in sample), max(p[k] for p in sample)) for k in range(3)]
    more = (width - 1) / 2
    return [tuple(rng.uniform(a - more * (b - a), b + more * (b - a)) for a, b in ends)
            for _ in range(count)]


def points_grid(size, count, seed):
    """Points drawn from the grid."""
    rng = random.Random(seed)
    return [tuple(float(rng.randrange(size)) for _ in range(3)) for _ in range(count)]


def apply(matrix, p):
    return tuple(matrix[4 * i] * p[0] + matrix[4 * i + 1] * p[1] + matrix[4 * i + 2] * p[2]
                 + matrix[4 * i + 3] for i in range(3))


def save_points(folder, name, motion, points):
    """Write points and, for the peers, the segments from c(0) to c(1)."""
    start, end = motion.inverse(0), motion.inverse(1)
    save(f"{folder}/{name}.points", (x for p in points for x in p))
    save(f"{folder}/{name}.segments", (x for p in points for x in apply(start, p) + apply(end, p)))


def save_samples(path, motion, count):
    """Matrices of M(t)^-1 at equal steps of the parameter."""
    save(path, (x for k in range(count) for x in motion.inverse(k / (count - 1))))


def write_csv(path, points):
    with open(path, "w", encoding="ascii") as file:
        file.writelines(",".join(map(repr, p)) + "\n" for p in points)


def read_csv(path):
    """The points of a table of `graze generate`, whose coordinates are doubles."""
    with open(path, encoding="ascii") as file:
        rows = [line.split(",") for line in file if line[0] not in "#x"]
    return [tuple(float(Fraction(x)) for x in row[:3]) for row in rows]
