"""Random pairs of solids that touch at some time by construction, and the convex parts the solids are made of.

SPDX-License-Identifier: GPL-3.0-or-later

Either a point of a cell of the moving solid, at a random time, is a point of a cell of the fixed one. Or the solids
graze: the fixed one has a facet along the velocity of a vertex of the moving one, or an edge in the plane of that of a
point of an edge and of that edge, and lies beyond the plane that supports the moving one there.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from algebra import derivative, value  # noqa: E402
from exact import Fraction as F  # noqa: E402
from motion import build, legs, rotation, translate  # noqa: E402
from points import degenerate  # noqa: E402
from scenes import plane_motions, space_motions  # noqa: E402
from solids import Mesh, Polygon, block, box_ring, cross, extruded, joined, prism, ring  # noqa: E402

TURNED = {2: [[F(3, 5), F(-4, 5)], [F(4, 5), F(3, 5)]],
          3: [[F(1, 3), F(2, 3), F(2, 3)], [F(2, 3), F(1, 3), F(-2, 3)], [F(-2, 3), F(2, 3), F(-1, 3)]]}


class Solid:
    """A solid, and convex solids whose union it is."""

    def __init__(self, whole, parts):
        self.whole, self.parts = whole, parts

    def mapped(self, f):
        return Solid(self.whole.mapped(f), [p.mapped(f) for p in self.parts])


def plane_part(r):
    return Polygon([[r]])


def boxes(*boxes_):
    return [plane_part(box_ring(*b)) for b in boxes_]


def plane_solids():
    tri, box, bar = ring((0, 0), (3, 1), (1, 2)), box_ring(0, 0, 2, 2), box_ring(-4, 0, 4, 1)
    ell = Polygon([[ring((0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4))]])
    slot = Polygon([[ring((0, 0), (6, 0), (6, 3), (4, 3), (4, 1), (2, 1), (2, 3), (0, 3))]])
    frame = Polygon([[box_ring(0, 0, 6, 6), box_ring(2, 2, 4, 4)]])
    pinch = Polygon([[box_ring(-2, -2, 0, 0)], [tri]])
    out = {name: Solid(plane_part(r), [plane_part(r)]) for name, r in (("triangle", tri), ("box", box), ("bar", bar))}
    out["ell"] = Solid(ell, boxes((0, 0, 4, 2), (0, 2, 2, 4)))
    out["slot"] = Solid(slot, boxes((0, 0, 6, 1), (0, 1, 2, 3), (4, 1, 6, 3)))
    out["frame"] = Solid(frame, boxes((0, 0, 6, 2), (0, 4, 6, 6), (0, 2, 2, 4), (4, 2, 6, 4)))
    out["pinch"] = Solid(pinch, [plane_part(box_ring(-2, -2, 0, 0)), plane_part(tri)])
    return out


def space_solids():
    octa = Mesh([(2, 0, 0), (-2, 0, 0), (0, 2, 0), (0, -2, 0), (0, 0, 2), (0, 0, -2)],
                [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
    tetra = Mesh([(0, 0, 0), (3, 0, 0), (0, 2, 1), (1, 1, 3)], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    cube, slab = block(0, 0, 0, 2, 2, 2), block(-3, 0, 0, 3, 1, 2)
    ell = extruded(plane_solids()["ell"].whole, [0, 2])[0]
    out = {name: Solid(m, [m]) for name, m in (("octahedron", octa), ("tetrahedron", tetra), ("cube", cube), ("slab", slab))}
    out["ell"] = Solid(ell, [block(0, 0, 0, 4, 2, 2), block(0, 2, 0, 2, 4, 2)])
    beside = tetra.mapped(lambda p: (p[0] + 2, p[1] + 2, p[2] + 2))
    out["corner"] = Solid(joined(cube, beside), [cube, beside])
    return out


def grazing_motions(d):
    """Motions that touch more often than they cross: there and back, parabolas, turns."""
    rest = [[F(0)]] * (d - 2)
    return {"back": legs([[0] * d, [3] + [1] * (d - 1), [0] * d]),
            "parabola": build([(-1, 2, translate([[0, 2], [0, 0, 1]] + rest))]),
            "pivot": build([(-1, 1, rotation([0, 1], **({} if d == 2 else {"axis": [2, 1, 2], "length": 3})))])}


LONG = ("sextic", "rational", "double_rotation")     # of degrees at which the second method is slow


def motions(d):
    out = dict(plane_motions() if d == 2 else space_motions(), **grazing_motions(d))
    return {name: m for name, m in out.items() if name not in LONG}


def turned(solid, d):
    return solid.mapped(lambda p: tuple(sum(a * x for a, x in zip(row, p)) for row in TURNED[d]))


def velocity(motion, point, t):
    piece = motion.piece_at(t)
    w, rate = value(piece.w, t), value(derivative(piece.w), t)
    out = []
    for row, b in zip(piece.a, piece.b):
        num, slope = [sum(value(f(p), t) * x for p, x in zip(row, point)) + value(f(b), t)
                      for f in (lambda p: p, derivative)]
        out.append((slope * w - num * rate) / w ** 2)
    return tuple(out)


def frame_at(place, along, beside, corners):
    """The map that carries the x, y axes to the two vectors and the last axis to the normal on whose side all corners
    are, with the origin at a place; whether it mirrors. None if the corners are on both sides."""
    normal = cross(along, beside) if beside else (-along[1], along[0])
    sides = [sum(n * (x - y) for n, x, y in zip(normal, q, place)) for q in corners]
    if min(sides) < 0 < max(sides) or not any(normal):
        return None
    turn = min(sides) < 0
    columns = [along] + ([beside] if beside else []) + [tuple(-n for n in normal) if turn else normal]
    return (lambda p: tuple(x + sum(c[k] * y for c, y in zip(columns, p)) for k, x in enumerate(place))), turn


def grazed(rng, moving, motion, d):
    """A fixed solid that the convex solid grazes at a random time, or None."""
    t = motion.start + (motion.end - motion.start) * F(rng.randint(1, 23), 24)
    at = [motion.map(p, t) for p in moving.vertices]
    if d == 3 and rng.random() < 0.5:
        i, j = rng.choice(moving.edges)
        point = tuple(a + (b - a) * F(rng.randint(1, 3), 4) for a, b in zip(moving.vertices[i], moving.vertices[j]))
        edge, speed = tuple(b - a for a, b in zip(at[i], at[j])), velocity(motion, point, t)
        solid = prism(ring((0, 0), (-1, -2), (1, -2)), -1, 1).mapped(lambda p: (p[2], p[0], p[1]))
        along = tuple(a * rng.randint(-1, 1) + b for a, b in zip(edge, speed))
        frame = frame_at(motion.map(point, t), along, edge, at)
    else:
        v = rng.choice(moving.vertices)
        beside = tuple(F(rng.randint(-4, 4)) for _ in range(3)) if d == 3 else None
        solid = block(-1, -1, -1, 1, 1, 0) if d == 3 else plane_part(box_ring(-1, -1, 1, 0))
        frame = frame_at(motion.map(v, t), velocity(motion, v, t), beside, at)
    if frame is None:
        return None
    return solid.mapped(*frame) if d == 3 else solid.mapped(frame[0])


def fan(rng, d):
    """Triangles or tetrahedra about the origin; no two of them share a facet."""
    if d == 2:
        ways = ring((1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1))
        chosen = rng.choice([(0,), (0, 2), (0, 3), (0, 4), (0, 2, 4), (0, 2, 5), (0, 2, 4, 6)])
        by = rng.randrange(8)
        rings = [ring((0, 0), ways[(k + by) % 8], ways[(k + by + 1) % 8]) for k in chosen]
        return Solid(Polygon([[r] for r in rings]), [plane_part(r) for r in rings])
    octants = [(x, y, z) for x in (2, -2) for y in (2, -2) for z in (2, -2)]
    sign = rng.choice((-1, 1))
    parts = [octant(o) for o in rng.sample([o for o in octants if sign * o[0] * o[1] * o[2] > 0], rng.randint(1, 3))]
    return Solid(joined(*parts), parts)


def octant(o):
    facets = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
    if o[0] * o[1] * o[2] < 0:
        facets = [f[::-1] for f in facets]
    return Mesh([(0, 0, 0), (o[0], 0, 0), (0, o[1], 0), (0, 0, o[2])], facets)


def fans(rng, d):
    """Two of them about the origin at the time 0, between which one turns, or passes."""
    axis = {} if d == 2 else rng.choice([{"axis": [0, 0, 1], "length": 1}, {"axis": [2, 1, 2], "length": 3}])
    way = [[0, F(rng.randint(-2, 2)), F(rng.randint(-1, 1), 2)] for _ in range(d)]
    motion = build([(F(-1, 2), F(1, 2), rng.choice((rotation([0, rng.choice((-1, 1))], **axis), translate(way))))])
    return "fans", fan(rng, d), motion, fan(rng, d)


def placed(rng, d, more=()):
    """(name, Solid, motion, Solid) of one random pair; `more` are solids by name to choose from too."""
    if rng.random() < 0.2:
        return fans(rng, d)
    solids, ways = dict(plane_solids() if d == 2 else space_solids(), **dict(more)), motions(d)
    a, b, way = rng.choice(sorted(solids)), rng.choice(sorted(solids)), rng.choice(sorted(ways))
    moving, fixed, motion = solids[a], solids[b], ways[way]
    if len(moving.parts) == 1 and rng.random() < 0.8:
        other = next(filter(None, (grazed(rng, moving.whole, motion, d) for _ in range(20))), None)
        if other:
            return f"{a} {way} grazed", moving, motion, Solid(other, [other])
    if rng.random() < 0.5:
        fixed = turned(fixed, d)
    kind, point = rng.choice(degenerate(moving.whole, motion, rng, 3))
    spot = rng.choice(fixed.whole.cell_points(rng))[1]
    by = tuple(p - q for p, q in zip(point, spot))
    return f"{a} {way} {b} {kind}", moving, motion, fixed.mapped(lambda p: tuple(x + y for x, y in zip(p, by)))
