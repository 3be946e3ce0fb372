"""Solids of the benchmark: closed meshes of triangles, oriented outward, whose coordinates are dyadic rationals.

Everything is exact arithmetic, rounded once to a grid where a circle or a sphere asks for it, so that every machine
makes the same bytes. A mesh is (vertices, faces): triples of Fraction or int, and triples of vertex numbers.
SPDX-License-Identifier: CC0-1.0
"""
from fractions import Fraction as F
from math import isqrt

PI = F(3141592653589793238462643383279502884197, 10 ** 39)
GRID = 2 ** 16  # circles and spheres are rounded to multiples of 1 / GRID


# ------------------------------------------------------------------------------------------------ numbers
def rounded(x, grid=GRID):
    return F(round(x * grid), grid)


def direction(k, n, grid=GRID):
    """(cos, sin) of k n-ths of a turn, rounded; quarter turns map directions to directions exactly."""
    quarter, rest = divmod(4 * (k % n), n)
    angle = PI * F(rest, 2 * n)
    sums, term = [F(0), F(0)], F(1)
    for j in range(30):
        sums[j % 2] += term if j % 4 < 2 else -term
        term = rounded(term * angle / (j + 1), 10 ** 40)
    x, y = (rounded(s, grid) for s in sums)
    for _ in range(quarter):
        x, y = -y, x
    return x, y


def circle(n, grid=GRID):
    return [direction(k, n, grid) for k in range(n)]


class Noise:
    """Integers that look random: the mixing function of splitmix64 over a counter."""

    def __init__(self, seed):
        self.state = seed

    def below(self, n):
        self.state = (self.state + 0x9E3779B97F4A7C15) % 2 ** 64
        x = self.state
        for shift, factor in ((30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB)):
            x = (x ^ x >> shift) * factor % 2 ** 64
        return (x ^ x >> 31) % n


# ------------------------------------------------------------------------------------------------ meshes
def mapped(mesh, f):
    """Its image; f keeps the orientation."""
    return [tuple(f(*v)) for v in mesh[0]], mesh[1]


def moved(mesh, x, y, z):
    return mapped(mesh, lambda a, b, c: (a + x, b + y, c + z))


def sized(mesh, factor):
    return mapped(mesh, lambda *v: [factor * c for c in v])


def together(*meshes):
    """Several parts that do not meet, or only touch; a cavity is a part turned inside out."""
    vertices, faces = [], []
    for more, of in meshes:
        faces += [tuple(k + len(vertices) for k in f) for f in of]
        vertices += more
    return vertices, faces


def inside_out(mesh):
    return mesh[0], [f[::-1] for f in mesh[1]]


def off(mesh):
    """The text of an OFF file; each coordinate the finite decimal that it is, and a binary64."""
    vertices, faces = mesh
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(map(decimal, v)) for v in vertices]
    lines += ["3 " + " ".join(map(str, f)) for f in faces]
    return "\n".join(lines) + "\n"


def decimal(x):
    """A dyadic rational as the decimal that it is exactly."""
    x = F(x)
    if F(float(x)) != x:
        raise ValueError(f"{x} is no binary64")
    places = x.denominator.bit_length() - 1
    if places == 0:
        return str(x.numerator)
    digits = str(abs(x.numerator) * 5 ** places).rjust(places + 1, "0")
    return ("-" if x < 0 else "") + digits[:-places] + "." + digits[-places:].rstrip("0")


# ------------------------------------------------------------------------------------------------ blocks
def blocks(cells, xs, ys, zs):
    """The union of cells (i, j, k) of the lattice with these coordinates."""
    cells, axes, index, faces = set(cells), (xs, ys, zs), {}, []

    def corner(*place):
        return index.setdefault(place, len(index))

    for cell in sorted(cells):
        for axis in range(3):
            for up in (0, 1):
                beside = list(cell)
                beside[axis] += 2 * up - 1
                if tuple(beside) in cells:
                    continue
                ring = []
                for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    at = list(cell)
                    at[axis] += up
                    at[(axis + 1) % 3] += a
                    at[(axis + 2) % 3] += b
                    ring.append(corner(*at))
                faces += quad(*(ring if up else ring[::-1]))
    return [tuple(F(axes[k][at[k]]) for k in range(3)) for at in index], faces


def quad(a, b, c, d):
    return [(a, b, c), (a, c, d)]


def box(low, high):
    return blocks([(0, 0, 0)], *zip(low, high))


def pattern(rows, height=1):
    """Cells of rows of text, # for a cell: rows[j][i] is the cell (i, j), in layers 0 to height - 1."""
    return [(i, j, k) for k in range(height) for j, row in enumerate(rows) for i, mark in enumerate(row) if mark == "#"]


# ------------------------------------------------------------------------------------------------ prisms
def turn_of(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def ears(points, ring):
    """Triangles of a polygon that may pass a bridge to a hole both ways; counter-clockwise."""
    ring, found = list(ring), []
    while len(ring) > 2:
        for k in range(len(ring)):
            a, b, c = ring[k - 1], ring[k], ring[(k + 1) % len(ring)]
            p, q, r = points[a], points[b], points[c]
            if turn_of(p, q, r) <= 0:
                continue
            others = (points[v] for v in ring if points[v] not in (p, q, r))
            if not any(turn_of(p, q, x) >= 0 and turn_of(q, r, x) >= 0 and turn_of(r, p, x) >= 0 for x in others):
                found.append((a, b, c))
                del ring[k]
                break
        else:
            raise ValueError("no ear is left")
    return found


def crosses(p, q, a, b):
    """Do the segments meet, but for common ends?"""
    if {p, q} & {a, b}:
        return False
    return turn_of(p, q, a) * turn_of(p, q, b) <= 0 and turn_of(a, b, p) * turn_of(a, b, q) <= 0


def bridged(points, outer, holes):
    """One ring through the outline and its holes, each joined by the first bridge that meets no side."""
    ring = list(outer)
    sides = [(r[k - 1], r[k]) for r in (outer, *holes) for k in range(len(r))]
    for hole in holes:
        bridges = sorted((sum((x - y) ** 2 for x, y in zip(points[a], points[b])), i, j) for i, a in enumerate(ring) for j, b in enumerate(hole))
        for _, i, j in bridges:
            if not any(crosses(points[ring[i]], points[hole[j]], points[a], points[b]) for a, b in sides):
                break
        sides.append((ring[i], hole[j]))
        ring = ring[:i + 1] + hole[j:] + hole[:j + 1] + ring[i:]
    return ring


def prism(outline, z0, z1, holes=()):
    """Over a counter-clockwise outline with holes, which are given counter-clockwise too."""
    rings, points = [], []
    for ring in (outline, *(hole[::-1] for hole in holes)):
        rings.append(list(range(len(points), len(points) + len(ring))))
        points += [(F(x), F(y)) for x, y in ring]
    n = len(points)
    cap = ears(points, bridged(points, rings[0], rings[1:]))
    faces = [f[::-1] for f in cap] + [tuple(k + n for k in f) for f in cap]
    for ring in rings:
        for k, b in enumerate(ring):
            a = ring[k - 1]
            faces += quad(a, b, b + n, a + n)
    return [(x, y, F(z)) for z in (z0, z1) for x, y in points], faces


def disk(radius, n, x=0, y=0):
    """A regular outline."""
    return [(x + radius * c, y + radius * s) for c, s in circle(n)]


# ------------------------------------------------------------------------------------------------ round bodies
def grown(layers, n, closed):
    """Strips between layers of n points each, the outside on the right; open ones are closed by fans from a middle point."""
    vertices = [p for layer in layers for p in layer]
    faces = []
    for j in range(len(layers) if closed else len(layers) - 1):
        low, high = j * n, (j + 1) % len(layers) * n
        for k in range(n):
            m = (k + 1) % n
            faces += quad(low + k, low + m, high + m, high + k)
    if not closed:
        for layer, start, up in ((layers[0], 0, False), (layers[-1], (len(layers) - 1) * n, True)):
            middle = len(vertices)
            vertices.append((F(0), F(0), layer[0][2]))
            for k in range(n):
                side = (start + k, start + (k + 1) % n)
                faces.append((*side, middle) if up else (side[1], side[0], middle))
    return vertices, faces


def lathe(profile, n, closed=False):
    """Corners (radius, height) turned about the z axis in n steps, from the bottom to the top outside; `closed`: back inside."""
    around = circle(n)
    return grown([[(r * x, r * y, F(z)) for x, y in around] for r, z in profile], n, closed)


def star(radii, heights, shift=0, bore=None, steps=None):
    """Layers with the outline of these radii in evenly spread directions, each layer turned by `shift` steps more.

    `steps` is the number of steps in a turn, a multiple of len(radii). `radii` may be a function of the layer. With
    `bore`, a radius or radii, the inside is open.
    """
    of = radii if callable(radii) else lambda j: radii
    n = len(of(0))
    steps = steps or n
    around = circle(steps)

    def layer(lengths, j):
        return [tuple(r * x for x in around[(k * steps // n + j * shift) % steps]) + (F(heights[j]),) for k, r in enumerate(lengths)]

    outside = [layer(of(j), j) for j in range(len(heights))]
    if bore is None:
        return grown(outside, n, False)
    inner = bore if isinstance(bore, list) else [bore] * n
    return grown(outside + [layer(inner, j) for j in reversed(range(len(heights)))], n, True)


def teeth(count, root, tip, each=8):
    """Radii of a gear's outline: of each tooth the foot, a flank, the tip, a flank."""
    middle = F(root + tip) / 2
    shape = {8: [root, root, root, middle, tip, tip, tip, middle], 6: [root, root, middle, tip, tip, middle]}[each]
    return shape * count


def tiled_sphere(n):
    """Points of the octahedron's surface cut n times, whole numbers with |x| + |y| + |z| = n, and its 8 n^2 triangles."""
    index, faces = {}, []
    for sx in (1, -1):
        for sy in (1, -1):
            for sz in (1, -1):
                def at(i, j, s=(sx, sy, sz)):
                    return index.setdefault((s[0] * i, s[1] * j, s[2] * (n - i - j)), len(index))
                for i in range(n):
                    for j in range(n - i):
                        found = [(at(i, j), at(i + 1, j), at(i, j + 1))]
                        if i + j < n - 1:
                            found.append((at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)))
                        faces += found if sx * sy * sz > 0 else [f[::-1] for f in found]
    return list(index), faces


def ball(n, radius=1, noise=None, rough=0, grid=2 ** 12):
    """A round body of 8 n^2 triangles; with noise, corners lie up to `rough` of the radius deeper."""
    points, faces = tiled_sphere(n)
    vertices = []
    for p in points:
        # Of the length a multiple of 2^-24, rounded down: the direction is right to eight digits before it is rounded.
        length = F(isqrt(sum(c * c for c in p) << 48), 2 ** 24)
        far = radius * (1 - F(noise.below(1024), 1024) * rough if noise else 1)
        vertices.append(tuple(rounded(far * c / length, grid) for c in p))
    return vertices, faces


def torus(n, m, major, minor, waves=0, grid=2 ** 12):
    """2 n m triangles; with waves, the inner radius changes by an eighth that often on the way round."""
    long, short = circle(n), circle(m)
    layers = []
    for j in range(m):
        layer = []
        for k in range(n):
            thick = minor * (1 + long[waves * k % n][0] / 8) if waves else minor
            out = major + thick * short[j][0]
            layer.append((*(rounded(out * x, grid) for x in long[k]), rounded(thick * short[j][1], grid)))
        layers.append(layer)
    return grown(layers, n, True)


def terrain(n, step, noise, most, grid=2 ** 10):
    """A square block of which the top, n by n squares of side `step`, is rough; 2 n^2 + 12 n triangles."""
    height = smooth_heights(n + 1, noise, most)
    vertices = [(i * step, j * step, 1 + rounded(height[j][i], grid)) for j in range(n + 1) for i in range(n + 1)]
    faces = []
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i
            faces += quad(a, a + 1, a + n + 2, a + n + 1)
    ring = [i for i in range(n)] + [j * (n + 1) + n for j in range(n)]
    ring += [n * (n + 1) + n - i for i in range(n)] + [(n - j) * (n + 1) for j in range(n)]
    below, middle = len(vertices), len(vertices) + len(ring)
    vertices += [(*vertices[k][:2], F(0)) for k in ring] + [(n * step / 2, n * step / 2, F(0))]
    for k, top in enumerate(ring):
        m = (k + 1) % len(ring)
        faces += quad(below + k, below + m, ring[m], top) + [(below + m, below + k, middle)]
    return vertices, faces


def smooth_heights(n, noise, most):
    """Random heights from 0 to `most`, four times averaged with their neighbours."""
    h = [[F(noise.below(256) * most, 256) for _ in range(n)] for _ in range(n)]
    for _ in range(4):
        h = [[rounded(sum(h[(j + d) % n][(i + e) % n] for d in (-1, 0, 1) for e in (-1, 0, 1)) / 9, 2 ** 20) for i in range(n)] for j in range(n)]
    return h
