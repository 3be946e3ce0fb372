"""Scenes made to break a floating-point filter.

SPDX-License-Identifier: GPL-3.0-or-later

A scene is a solid and a motion of ordinary size, seen in a place: an affine map T takes the solid
to T S, the motion to T M T^-1 and a query point to T P. Incidence does not notice T, so every
coincidence stays one, while coordinates become subnormal, longer than a double, beyond doubles, of
sixty decades in one solid, or far from the origin. Invariant: T is invertible.
"""
import random

from exact import Fraction as F
import jets
import parts
from motion import build, compose, conjugated, keyframes, legs, matrix, quaternion, rotation
from motion import scaling, translate, turn
from scenes import plane_motions, space_motions
from solids import Mesh, Polygon, block, box_ring, extruded, inside_out, joined, meshes, polygons
from solids import ring, star


# --------------------------------------------------------------------------------------- solids

def comb(teeth):
    """Teeth of width 1 with gaps of width 1 over a bar: many edges in one line."""
    points = [(0, -1), (2 * teeth - 1, -1)]
    for k in range(teeth - 1, -1, -1):
        points += [(2 * k + 1, 2), (2 * k, 2)] + ([(2 * k, 0), (2 * k - 1, 0)] if k else [])
    return Polygon([[ring(*[(F(x, 2), y) for x, y in points])]])


def terrain(n, rng):
    """A block under a grid of 2 n^2 triangles; some of them in one plane, some almost."""
    step, vertices = F(6, n), []
    for j in range(n + 1):
        for i in range(n + 1):
            inner = 0 < i < n and 0 < j < n
            z = rng.choice([F(0), F(1, 2), F(1, 2 ** 40), F(rng.randint(-32, 32), 64)])
            vertices.append((i * step, j * step, 2 + (z if inner else 0)))
    at = lambda i, j: j * (n + 1) + i
    facets = []
    for j in range(n):
        for i in range(n):
            facets += [[at(i, j), at(i + 1, j), at(i + 1, j + 1)],
                       [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
    base = len(vertices)
    vertices += [(0, 0, 0), (6, 0, 0), (6, 6, 0), (0, 6, 0)]
    rim = [[at(k, 0) for k in range(n + 1)], [at(n, k) for k in range(n + 1)],
           [at(n - k, n) for k in range(n + 1)], [at(0, n - k) for k in range(n + 1)]]
    facets += [[base + k, base + (k + 1) % 4] + rim[k][::-1] for k in range(4)]
    return Mesh(vertices, facets + [[base + 3, base + 2, base + 1, base]])


def needle(x, y, z, thin):
    """A sliver of a tetrahedron: four long edges, two of length about `thin`."""
    e = F(thin)
    return Mesh([(x, y, z), (x + e, y, z), (x + 4, y + e, z + 3), (x + 4, y, z + 3 + e)],
                [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]])


def part(mesh):
    """A mesh of tests/lib/parts.py; its doubles are meant exactly."""
    vertices, facets = mesh
    return Mesh([tuple(map(F, v)) for v in vertices], [list(f) for f in facets])


def plane_solids():
    tiny, huge = F(1, 10 ** 30), F(10 ** 30)
    return dict(polygons(), **{
        "comb": comb(12),
        "slivers": Polygon([[ring((0, 0), (4, 0), (4, F(1, 10 ** 12)))],
                            [ring((0, 1), (4, 3), (0, 1 + F(1, 10 ** 12)))],
                            [box_ring(1, -2, 1 + F(1, 10 ** 12), -1)]]),
        "decades": Polygon([[box_ring(0, 0, tiny, 1)], [ring((1, tiny), (2, 0), (2, huge))],
                            [ring((3, 0), (huge, -tiny), (huge, huge), (3, 1))]]),
        "spread": Polygon([[ring((0, 0), (F(22, 7), F(1, 3)), (F(10 ** 40 + 1, 3 ** 80), F(9, 2)),
                                 (F(-5, 11), F(2 ** 61, 2 ** 60 - 1)))]]),
    })


def space_solids():
    tiny, huge, rng = F(1, 10 ** 30), F(10 ** 30), random.Random(18)
    holed = Polygon([[box_ring(0, 0, 6, 4), box_ring(1, 1, 2, 3), star((4, 2), (1, F(1, 2)))]])
    return dict(meshes(), **{
        "plate": block(0, 0, 0, 4, 4, F(1, 10 ** 9)),
        "holed": extruded(holed, [0, 1, 2])[0],
        "terrain": terrain(9, rng),
        "needles": joined(needle(0, 0, 0, F(1, 10 ** 12)), needle(0, 1, 0, F(1, 2 ** 40)),
                          block(1, 3, 0, 2, 3 + F(1, 10 ** 12), 2)),
        "decades": joined(block(0, 0, 0, tiny, tiny, 1), block(1, 0, 0, 2, tiny, huge),
                          block(3, -huge, 0, huge, huge, 2)),
        "disk": part(parts.disk(24)),
        "slits": part(parts.plate(6)),
        "ribs": part(parts.ribs(5)),
        "lathe": part(parts.lathe(16)),
        "shells": joined(block(0, 0, 0, 5, 5, 5), inside_out(block(1, 1, 1, 4, 4, 4)),
                         block(F(3, 2), F(3, 2), F(3, 2), 3, 3, 4 - F(1, 2 ** 50))),
    })


# -------------------------------------------------------------------------------------- motions

def chebyshev(n):
    """T_n: n roots in [-1, 1] and all its extremes at the same two heights."""
    a, b = [1], [0, 1]
    for _ in range(n - 1):
        double = [0] + [2 * c for c in b]
        a, b = b, [c - (a[k] if k < len(a) else 0) for k, c in enumerate(double)]
    return b


def times(c, p):
    return [F(c) * x for x in p]


def raised(c, p):
    return [F(p[0]) + c] + list(p[1:])


def journey(count, d):
    """Many short pieces: positions on a curve, turning as they go."""
    frames = []
    for k in range(count + 1):
        t = F(k, count)
        place = (8 * t - 4, 4 * t * (1 - t), t * t)[:d]
        turned = (1, 2 * t - 1, t, 3 * t * t) if d == 3 else (1, 3 * t - 1)
        frames.append((t, place, turned))
    return keyframes(frames)


def plane_adversaries():
    high, other = chebyshev(18), chebyshev(17)
    flat = [[(-8, 0), (8, 0), (8, 4), (-8, 4)], [(0, -8), (0, 8), (2, 8), (2, -8)]]
    return dict(plane_motions(), **{
        "degree 18": build([(-1, 1, translate([times(3, high), times(2, other)]))]),
        "nine turns": build([(-1, 1, compose(rotation([0, 1], times=9, center=[F(1), F(0)]),
                                             translate([[0, 3], [1, 0, -1]])))]),
        "weight": build([(0, 2, rotation([-2, 4], var="s"))]),
        "rest": legs([(-6, 0), (0, 0), (0, 0), (-3, 0), (-6, 0), (-6, 0)]),
        "along": legs(flat[0]),
        "across": legs(flat[1], [0, F(1, 3), F(1, 2), F(22, 7)]),
        "graze": build([(-1, 1, translate([[0, 6], raised(F(1, 2 ** 55), [0, 0, 4, 0, -4])]))]),
        "identity": build([(0, 1, translate([[0], [0]]))]),
        "quarters": build([(0, 1, compose(turn(-5, center=[F(2), F(1)]),
                                          translate([[0, 4], [0]], "s")))]),
        "journey": journey(40, 2),
        "squeeze": build([(0, 1, scaling([[1, F(-3, 4)], [1, 3]], center=[F(1), F(1)]))]),
    })


def space_adversaries():
    z = {"axis": [0, 0, 1], "length": 1}
    helix = compose(rotation([-1, 2], center=[F(1), F(1), F(0)], var="s", **z),
                    translate([[0], [0], [-4, 8]], "s"))
    high = chebyshev(18)
    slide = [(-7, 0, 0), (7, 0, 0), (7, 2, 0), (-7, 2, 0), (-7, 2, 5)]
    frames = [(0, (0, 0, 0), (1, 0, 0, 0)), (F(1, 3), (5, 0, 0), (1, 0, 0, 0)),
              (2, (5, 0, 0), (3, 1, -1, 2)), (3, (0, 4, -1), (0, 1, 0, 1))]
    return dict(space_motions(), **{
        "degree 18": build([(-1, 1, translate([times(3, high), times(2, chebyshev(5)), [0, 3]]))]),
        "nine turns": build([(-1, 1, compose(rotation([0, 1], times=9, **z),
                                             translate([[0, 4], [0], [0, 2]])))]),
        "weight": build([(0, 1, compose(rotation([-2, 4], var="s", **z),
                                        translate([[0], [0], [0, 3]], "s")))]),
        "screw": build([(F(-1, 2), F(5, 2), helix)]),
        "rest": legs([(-6, 1, 1), (1, 1, 1), (1, 1, 1), (-6, 1, 1), (-6, 1, 1)]),
        "slide": legs(slide),
        "oblique": build([(0, 1, translate([[-5, 10], [-1, F(7, 3)], [-2, F(22, 7)]]))]),
        "stops": keyframes(frames),
        "quarters": build([(-1, 1, compose(turn(4, axis=[3, 0, 4], length=5),
                                           translate([[0, 3], [0], [0, 0, 2]], "s")))]),
        "tumble": build([(0, 1, compose(quaternion([[1, -1], [0, 2, -1], [0, 1], [0, 0, 3]]),
                                        translate([[0, 3, 0, 2], [0], [1]])))]),
        "journey": journey(60, 3),
        "skew": build([(0, 1, turn(3, axis=[2, 3, 6], length=7, center=[F(1, 2), F(0), F(0)]))]),
        "two rounds": build([(0, 1, turn(8, axis=[2, 3, 6], length=7, center=[F(1, 2), F(0), F(0)]))]),
        "shear": build([(-1, 1, matrix([[[1], [0, 2], [0], [0, 5]], [[0], [1], [0, 0, 1], [0]],
                                        [[0, 1], [0], [2], [-2]]], [2, 1]))]),
    })


# --------------------------------------------------------------------------------------- places

def diagonal(factors, shift=None):
    d = len(factors)
    return [[F(f) if i == j else F(0) for j in range(d)] + [F(shift[i]) if shift else F(0)]
            for i, f in enumerate(factors)]


def places(d):
    """name -> rows of T, d rows of d + 1 numbers."""
    shear = [[F(1 if i == j else 3 * i - j, 1 if i == j else 7) for j in range(d)]
             + [F(1, 3 + i)] for i in range(d)]
    return {
        "": diagonal([1] * d),
        "subnormal": diagonal([F(1, 2 ** 1060)] * d),
        "vanishing": diagonal([F(1, 10 ** 400)] * d),
        "boundless": diagonal([F(10 ** 400)] * d),
        "near the top": diagonal([F(2 ** 1020)] * d),
        "60 decades": diagonal([F(1, 10 ** 30), F(10 ** 30), F(1)][:d]),
        "sliver": diagonal([F(1), F(1, 10 ** 12), F(1, 3)][:d], [F(1, 3)] * d),
        "far": diagonal([1] * d, [F(2 ** 60) + F(1, 3), F(-10 ** 20), F(10 ** 6)][:d]),
        "thirds": shear,
        "huge ratios": diagonal([F(10 ** 60 + 7, 3 ** 120), F(3 ** 90, 10 ** 40 + 9),
                                 F(2 ** 127 - 1, 10 ** 38)][:d]),
    }


class Scene:
    """A solid and a motion in a place. `solid` and `motion` are those of ordinary size. `heavy`
    where exact polynomials of degree 18 and more take milliseconds a point, or the filter does, `lost` in a place whose doubles say little."""

    def __init__(self, name, solid, motion, rows, flags=()):
        self.name, self.solid, self.motion, self.flags = name, solid, motion, list(flags)
        self.rows, self.d = rows, solid.dimension
        self.unsweep = "unsweep" in self.flags
        self.lost = name.endswith("terrain, screw, far")
        self.heavy = self.lost or any(word in name for word in ("degree 18", "nine turns"))
        self.ordinary = rows == diagonal([1] * self.d)

    def carry(self, point):
        if self.ordinary:
            return tuple(point)
        return tuple(sum((a * x for a, x in zip(row, point)), row[-1]) for row in self.rows)

    def texts(self):
        """The files' texts: of the solid, of the motion."""
        if self.ordinary:
            return self.solid.text(), self.motion.text()
        square = self.rows + [[F(0)] * self.d + [F(1)]]
        inverse = jets.inverse([[jets.jet(x) for x in row] for row in square])
        back = [[x.terms[0] for x in row] for row in inverse[:self.d]]
        return (self.solid.mapped(self.carry).text(),
                conjugated(self.motion, self.rows, back).text())


UNSWEEP = ("--operation", "unsweep")
COMBINED = ("--folds", "combined")
PLANE = [
    ("ring", "legs", ""), ("ell", "degree 18", ""), ("pinch", "nine turns", ""),
    ("star", "weight", ""), ("touch", "along", ""), ("islands", "rotation", "", COMBINED),
    ("comb", "across", ""), ("comb", "quarters", "thirds"), ("slivers", "graze", ""),
    ("slivers", "rotation", "far"), ("decades", "legs", ""), ("decades", "parabola", ""),
    ("spread", "sextic", ""), ("spread", "keyframes", "huge ratios"), ("ring", "rest", ""),
    ("ell", "squeeze", "sliver"), ("star", "degree 18", "60 decades"), ("ell", "legs", "subnormal"),
    ("pinch", "rotation", "boundless"), ("touch", "parabola", "vanishing"),
    ("star", "turns", "far"), ("islands", "graze", "", UNSWEEP), ("ring", "weight", "", UNSWEEP),
    ("comb", "identity", ""), ("pinch", "mirror", "near the top"), ("ell", "rational", ""),
    ("comb", "journey", ""), ("star", "journey", "thirds"), ("ring", "journey", "", UNSWEEP),
]
SPACE = [
    ("cube", "slide", ""), ("cube", "weight", ""), ("hollow", "screw", ""), ("ell3", "sextic", ""),
    ("arrow", "degree 18", ""), ("torus", "turns", ""), ("edge_touch", "legs", ""),
    ("edge_shared", "nine turns", ""), ("corner_touch", "quarters", "", COMBINED),
    ("corner_shared", "rest", ""), ("tip_on_face", "stops", ""), ("octahedron", "tumble", ""),
    ("star3", "oblique", ""), ("plate", "upright", ""), ("holed", "slide", ""),
    ("holed", "rotation", "thirds"), ("terrain", "oblique", ""), ("terrain", "screw", "far"),
    ("terrain", "degree 18", "60 decades"), ("needles", "oblique", ""),
    ("needles", "rotation", "sliver"), ("decades", "legs", ""), ("decades", "screw", ""),
    ("shells", "parabola", ""), ("cube", "legs", "subnormal"), ("torus", "screw", "boundless"),
    ("hollow", "quaternion", "vanishing"), ("ell3", "keyframes", "huge ratios"),
    ("cube", "screw", "near the top"), ("octahedron", "mirror", "60 decades"),
    ("star3", "scaling", "sliver"), ("holed", "parabola", "", UNSWEEP),
    ("cube", "weight", "", UNSWEEP), ("cube", "shear", ""),
    ("disk", "skew", ""), ("disk", "two rounds", "sliver"), ("slits", "skew", ""),
    ("slits", "screw", "thirds"), ("ribs", "two rounds", ""), ("lathe", "skew", ""),
    ("lathe", "quaternion", "far"), ("ribs", "oblique", ""),
    ("disk", "journey", ""), ("lathe", "journey", "thirds"), ("torus", "journey", "far"),
]


def scenes():
    """Every scene of the two tables above."""
    out = []
    for d, table, solids, motions in ((2, PLANE, plane_solids(), plane_adversaries()),
                                      (3, SPACE, space_solids(), space_adversaries())):
        for solid, motion, place, *flags in table:
            flags = flags[0] if flags else ()
            name = ", ".join(filter(None, [f"{d}D {solid}", motion, place, " ".join(flags)]))
            out.append(Scene(name, solids[solid], motions[motion], places(d)[place], flags))
    return out
