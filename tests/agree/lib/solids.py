"""Solids for the agreement tests: polygons with holes, meshes, and changes that keep the set.

SPDX-License-Identifier: GPL-3.0-or-later

A Polygon is a list of parts, a part a list of rings, the outer one first; a Mesh has vertices and
facets (cycles, outward oriented). Both write themselves as files. `cells` name a boundary cell as
('edge', u, v) with u < v, ('vertex', v) or ('face', f), by the file's numbering from 0.
"""
from exact import Fraction as F


def ring(*points):
    return [tuple(F(x) for x in p) for p in points]


def box_ring(x0, y0, x1, y1):
    return ring((x0, y0), (x1, y0), (x1, y1), (x0, y1))


def edge(u, v):
    return ("edge", min(u, v), max(u, v))


class Polygon:
    dimension = 2
    suffix = ".wkt"

    def __init__(self, parts):
        self.parts = parts
        self.vertices, self.edges = [], []
        for part in parts:
            for r in part:
                base = len(self.vertices)
                self.vertices += r
                self.edges += [(base + k, base + (k + 1) % len(r)) for k in range(len(r))]

    def text(self):
        def one(r):
            return "(" + ", ".join(f"{x} {y}" for x, y in r + r[:1]) + ")"
        bodies = ["(" + ", ".join(one(r) for r in part) + ")" for part in self.parts]
        if len(bodies) == 1:
            return "POLYGON " + bodies[0] + "\n"
        return "MULTIPOLYGON (" + ", ".join(bodies) + ")\n"

    def mapped(self, f):
        """The image under a point map; rings may then run the other way, which is legal."""
        return Polygon([[[f(p) for p in r] for r in part] for part in self.parts])

    def cell_points(self, rng):
        """(kind, point) of a vertex, a point inside an edge, on its quarter and near its end."""
        out = [("vertex", p) for p in self.vertices]
        for u, v in self.edges:
            s = F(rng.randint(1, 15), 16)
            out.append(("edge", tuple(a + s * (b - a) for a, b in
                                      zip(self.vertices[u], self.vertices[v]))))
        return out

    def lines(self):
        """(outward up to sign normal, two points of the line) of every facet."""
        for u, v in self.edges:
            p, q = self.vertices[u], self.vertices[v]
            yield (q[1] - p[1], p[0] - q[0]), [p, q]


class Mesh:
    dimension = 3
    suffix = ".off"

    def __init__(self, vertices, facets):
        self.vertices = [tuple(F(x) for x in p) for p in vertices]
        self.facets = [list(f) for f in facets]

    def text(self):
        lines = ["OFF", f"{len(self.vertices)} {len(self.facets)} 0"]
        lines += [" ".join(str(x) for x in p) for p in self.vertices]
        lines += [" ".join(str(k) for k in [len(f)] + f) for f in self.facets]
        return "\n".join(lines) + "\n"

    def mapped(self, f, flip=False):
        return Mesh([f(p) for p in self.vertices],
                    [g[::-1] if flip else g for g in self.facets])

    @property
    def edges(self):
        return sorted({(min(a, b), max(a, b)) for f in self.facets
                       for a, b in zip(f, f[1:] + f[:1])})

    def corner(self, facet, s, r):
        """A point of the facet's plane near the triangle of three corners not in line."""
        p, q, w = self.basis(facet)
        return tuple(a + s * (b - a) + r * (c - a) for a, b, c in zip(p, q, w))

    def basis(self, facet):
        pts = [self.vertices[k] for k in facet]
        for k in range(len(pts)):
            p, q, w = pts[k - 1], pts[k], pts[(k + 1) % len(pts)]
            if any(cross(minus(q, p), minus(w, q))):
                return q, w, p
        raise ValueError("degenerate facet")

    def cell_points(self, rng):
        out = [("vertex", p) for p in self.vertices]
        for u, v in self.edges:
            s = F(rng.randint(1, 15), 16)
            out.append(("edge", tuple(a + s * (b - a) for a, b in
                                      zip(self.vertices[u], self.vertices[v]))))
        for f in self.facets:
            s, r = F(rng.randint(1, 7), 16), F(rng.randint(1, 7), 16)
            out.append(("face", self.corner(f, s, r)))
        return out

    def lines(self):
        for f in self.facets:
            p, q, w = self.basis(f)
            yield cross(minus(q, p), minus(w, p)), [p, q, w]


def minus(p, q):
    if len(p) == 3:  # a generator takes three times as long
        return p[0] - q[0], p[1] - q[1], p[2] - q[2]
    return tuple(a - b for a, b in zip(p, q))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def joined(*meshes):
    vertices, facets = [], []
    for m in meshes:
        base = len(vertices)
        vertices += m.vertices
        facets += [[base + k for k in f] for f in m.facets]
    return Mesh(vertices, facets)


def inside_out(mesh):
    return Mesh(mesh.vertices, [f[::-1] for f in mesh.facets])


def block(x0, y0, z0, x1, y1, z1):
    v = [(x, y, z) for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
    return Mesh(v, [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2],
                    [1, 3, 7, 5]])


def prism(r, z0, z1):
    """A prism with one, perhaps non-convex, facet as floor and one as roof."""
    n = len(r)
    return Mesh([(x, y, z) for z in (z0, z1) for x, y in r],
                [list(range(n))[::-1], list(range(n, 2 * n))]
                + [[k, (k + 1) % n, (k + 1) % n + n, k + n] for k in range(n)])


def welded(mesh):
    """Repeated positions made one vertex."""
    index, vertices = {}, []
    for p in mesh.vertices:
        if p not in index:
            index[p] = len(vertices)
            vertices.append(p)
    return Mesh(vertices, [[index[mesh.vertices[k]] for k in f] for f in mesh.facets])


# ------------------------------------------------------------------------------------- extrusion

def area2(r):
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(r, r[1:] + r[:1]))


def oriented(polygon):
    """Outer rings counter-clockwise, holes clockwise: the solid lies on the left."""
    parts = []
    for part in polygon.parts:
        parts.append([r if (area2(r) > 0) == (k == 0) else r[::-1] for k, r in enumerate(part)])
    return Polygon(parts)


def extruded(polygon, levels):
    """The prism over a polygon, cut at every level; caps by vertical slabs, so that any number of
    holes and touching rings is one rule. Returns the mesh and a function that carries a cell of
    the polygon to the cells at height z: the wall or the level edge over an edge, the upright or
    the level vertex over a vertex (z strictly inside the prism)."""
    flat = oriented(polygon)
    levels = [F(z) for z in levels]
    xs = sorted({p[0] for p in flat.vertices})
    spots = slab_points(flat, xs)
    vertices, index, facets, walls = [], {}, [], {}

    def at(p, z):
        if (p, z) not in index:
            index[(p, z)] = len(vertices)
            vertices.append((p[0], p[1], z))
        return index[(p, z)]

    for u, v in flat.edges:
        p, q = flat.vertices[u], flat.vertices[v]
        for k, (a, b) in enumerate(zip(levels, levels[1:])):
            low = along(p, q, spots) if k == 0 else [p, q]
            high = along(p, q, spots) if k == len(levels) - 2 else [p, q]
            walls[(p, q, k)] = len(facets)
            facets.append([at(x, a) for x in low] + [at(x, b) for x in high[::-1]])
    for x0, x1 in zip(xs, xs[1:]):
        for bottom, top in slab_cells(flat, x0, x1):
            cycle = trapezoid(bottom, top, x0, x1, spots)
            facets.append([at(x, levels[-1]) for x in cycle])
            facets.append([at(x, levels[0]) for x in cycle[::-1]])
    mesh = Mesh(vertices, facets)

    def carry(cell, z):
        z = F(z)
        if cell[0] == "vertex":
            p = polygon.vertices[cell[1]]
            if z in levels:
                return ("vertex", index[(p, z)])
            k = sum(z > a for a in levels) - 1
            return edge(index[(p, levels[k])], index[(p, levels[k + 1])])
        p, q = polygon.vertices[cell[1]], polygon.vertices[cell[2]]
        if z in levels:
            return edge(index[(p, z)], index[(q, z)])
        k = sum(z > a for a in levels) - 1
        return ("face", walls[(p, q, k)] if (p, q, k) in walls else walls[(q, p, k)])

    return mesh, carry


def height(p, q, x):
    return p[1] + (q[1] - p[1]) * (x - p[0]) / (q[0] - p[0])


def slab_points(polygon, xs):
    """All points of edges over the slab lines, line by line."""
    spots = {x: set() for x in xs}
    for u, v in polygon.edges:
        p, q = polygon.vertices[u], polygon.vertices[v]
        spots[p[0]].add(p)
        if p[0] != q[0]:
            for x in xs:
                if min(p[0], q[0]) < x < max(p[0], q[0]):
                    spots[x].add((x, height(p, q, x)))
    return spots


def along(p, q, spots):
    """p, the slab points strictly between, q, in order."""
    if p[0] == q[0]:
        inner = [s for s in spots[p[0]] if min(p[1], q[1]) < s[1] < max(p[1], q[1])]
        inner.sort(key=lambda s: s[1], reverse=p[1] > q[1])
    else:
        inner = [(x, height(p, q, x)) for x in spots if min(p[0], q[0]) < x < max(p[0], q[0])]
        inner.sort(reverse=p[0] > q[0])
    return [p] + inner + [q]


def slab_cells(polygon, x0, x1):
    """Pairs (bottom edge, top edge) of the parts of the polygon between two slab lines."""
    mid, crossing = (x0 + x1) / 2, []
    for u, v in polygon.edges:
        p, q = polygon.vertices[u], polygon.vertices[v]
        if min(p[0], q[0]) <= x0 and max(p[0], q[0]) >= x1:
            crossing.append((height(p, q, mid), p, q))
    crossing.sort()
    return [(a[1:], b[1:]) for a, b in zip(crossing[0::2], crossing[1::2])]


def trapezoid(bottom, top, x0, x1, spots):
    """Counter-clockwise cycle with all slab points on its upright sides."""
    def side(x):
        a, b = (x, height(*bottom, x)), (x, height(*top, x))
        return [a] if a == b else along(a, b, spots)
    return side(x1) + side(x0)[::-1]


# ---------------------------------------------------------------------------------------- scenes

def star(center, radii):
    cx, cy = center
    turns = [(1, 0), (F(4, 5), F(3, 5)), (F(3, 5), F(4, 5)), (0, 1), (F(-3, 5), F(4, 5)),
             (F(-4, 5), F(3, 5)), (-1, 0), (F(-4, 5), F(-3, 5)), (F(-3, 5), F(-4, 5)), (0, -1),
             (F(3, 5), F(-4, 5)), (F(4, 5), F(-3, 5))]
    return ring(*[(cx + F(radii[k % len(radii)]) * c, cy + F(radii[k % len(radii)]) * s)
                  for k, (c, s) in enumerate(turns)])


def polygons():
    """name -> (Polygon, its disjoint components or None)."""
    return {
        "ring": Polygon([[box_ring(0, 0, 6, 6), box_ring(2, 2, 4, 4)]]),
        "ell": Polygon([[ring((0, 0), (2, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4))]]),
        "pinch": Polygon([[box_ring(-2, -2, 0, 0)], [box_ring(0, 0, 2, 2)]]),
        "star": Polygon([[star((0, 0), (4, F(3, 2)))]]),
        # the hole touches the outer ring in the middle of an edge; a part stands on a roof
        "touch": Polygon([[box_ring(0, 0, 6, 3), ring((3, 0), (4, 1), (3, 2), (2, 1))],
                          [ring((3, 3), (4, 5), (2, 5))]]),
        "islands": Polygon([[box_ring(-3, -3, 3, 3), box_ring(-2, -2, 2, 2)],
                            [star((0, 0), (1, F(1, 2)))], [ring((5, 0), (7, 1), (5, 2))]]),
    }


def meshes():
    cube = block(0, 0, 0, 3, 3, 3)
    hollow = joined(block(0, 0, 0, 4, 4, 4), inside_out(block(1, 1, 1, 2, 3, 3)))
    ell = extruded(polygons()["ell"], [0, 2])[0]
    torus = extruded(polygons()["ring"], [0, 2])[0]
    edge_touch = joined(block(0, 0, 0, 2, 2, 2), block(2, 2, 0, 4, 4, 2))
    corner_touch = joined(block(0, 0, 0, 2, 2, 2), block(2, 2, 2, 4, 4, 4))
    tip = Mesh([(1, 1, 3), (0, 1, 5), (2, 0, 5), (2, 2, 5)],
               [[0, 1, 3], [0, 3, 2], [0, 2, 1], [1, 2, 3]])
    octa = Mesh([(2, 0, 0), (-2, 0, 0), (0, 2, 0), (0, -2, 0), (0, 0, 2), (0, 0, -2)],
                [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5],
                 [0, 3, 5]])
    return {
        "cube": cube,
        "hollow": hollow,
        "ell3": ell,
        "arrow": prism(ring((0, 0), (4, -2), (2, 0), (4, 2)), 0, 2),
        "torus": torus,
        "edge_touch": edge_touch,
        "edge_shared": welded(edge_touch),
        "corner_touch": corner_touch,
        "corner_shared": welded(corner_touch),
        "tip_on_face": joined(cube, tip),
        "octahedron": octa,
        "star3": extruded(polygons()["star"], [0, 1, 3])[0],
    }
