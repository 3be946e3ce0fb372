"""Other boundaries of the same set: facets cut, edges cut, complements, unions.

SPDX-License-Identifier: GPL-3.0-or-later

Each function gives the new solid and a map from its cells to the old solid's cells that hold them.
The new cells met at a contact, carried by the map, are exactly the old cells met there.
"""
from exact import Fraction as F

from solids import Mesh, Polygon, box_ring, block, cross, edge, inside_out, joined, minus


class CellMap:
    """Explicit images of new cells; a cell without one keeps its name."""

    def __init__(self):
        self.image = {}

    def __call__(self, cells):
        return {self.image.get(c, c) for c in cells}


def middle(p, q):
    return tuple((a + b) / 2 for a, b in zip(p, q))


def centre(points):
    return tuple(sum(c) / len(points) for c in zip(*points))


def is_corner(p, q, r):
    return any(cross(minus(q, p), minus(r, q)))


def turns(pts):
    """Signs of the corners against the facet's normal: 1 convex, 0 straight, -1 reflex."""
    normal = (F(0),) * 3
    for p, q in zip(pts, pts[1:] + pts[:1]):
        normal = tuple(a + b for a, b in zip(normal, cross(p, q)))
    out = []
    for k in range(len(pts)):
        c = cross(minus(pts[k], pts[k - 1]), minus(pts[(k + 1) % len(pts)], pts[k]))
        s = sum(a * b for a, b in zip(c, normal))
        out.append((s > 0) - (s < 0))
    return out


def ears(mesh, facet):
    """Triangles of a simple facet without straight corners."""
    rest, out = list(facet), []
    while len(rest) > 3:
        pts = [mesh.vertices[k] for k in rest]
        signs = turns(pts)
        for k in range(len(rest)):
            p, q, r = pts[k - 1], pts[k], pts[(k + 1) % len(rest)]
            others = [x for x in pts if x not in (p, q, r)]
            if signs[k] > 0 and not any(within(x, p, q, r) for x in others):
                out.append([rest[k - 1], rest[k], rest[(k + 1) % len(rest)]])
                del rest[k]
                break
        else:
            raise ValueError("no ear")
    return out + [rest]


def within(x, p, q, r):
    """Is x, in the plane of the triangle, inside it or on its border?"""
    n = cross(minus(q, p), minus(r, p))
    return all(sum(a * b for a, b in zip(cross(minus(v, u), minus(x, u)), n)) >= 0
               for u, v in ((p, q), (q, r), (r, p)))


def triangulated(mesh):
    """Every facet cut into triangles: about its centre where it is convex with straight corners,
    fanned where convex, by ears where not."""
    vertices, facets, carry = list(mesh.vertices), [], CellMap()
    for number, facet in enumerate(mesh.facets):
        signs = turns([mesh.vertices[k] for k in facet])
        if -1 in signs:
            parts = ears(mesh, facet)
        elif 0 in signs:
            c = len(vertices)
            vertices.append(centre([mesh.vertices[k] for k in facet]))
            carry.image[("vertex", c)] = ("face", number)
            parts = [[a, b, c] for a, b in zip(facet, facet[1:] + facet[:1])]
        else:
            parts = [[facet[0], a, b] for a, b in zip(facet[1:], facet[2:])]
        old = {edge(a, b) for a, b in zip(facet, facet[1:] + facet[:1])}
        for part in parts:
            carry.image[("face", len(facets))] = ("face", number)
            facets.append(part)
            for a, b in zip(part, part[1:] + part[:1]):
                if edge(a, b) not in old:
                    carry.image[edge(a, b)] = ("face", number)
    return Mesh(vertices, facets), carry


def edges_cut(solid):
    """A vertex in the middle of every edge; edges of equal positions are cut alike."""
    if isinstance(solid, Polygon):
        return polygon_edges_cut(solid)
    vertices, carry, mid = list(solid.vertices), CellMap(), {}
    for u, v in solid.edges:
        m = mid[edge(u, v)] = len(vertices)
        vertices.append(middle(solid.vertices[u], solid.vertices[v]))
        for cell in (("vertex", m), edge(u, m), edge(m, v)):
            carry.image[cell] = edge(u, v)
    facets = [[k for a, b in zip(f, f[1:] + f[:1]) for k in (a, mid[edge(a, b)])]
              for f in solid.facets]
    return Mesh(vertices, facets), carry


def polygon_edges_cut(solid):
    parts = [[[p for a, b in zip(r, r[1:] + r[:1]) for p in (a, middle(a, b))] for r in part]
             for part in solid.parts]
    carry = CellMap()
    for k, (u, v) in enumerate(solid.edges):
        old_edge = edge(u, v)
        new_u, new_v, m = 2 * u, 2 * v, 2 * k + 1
        carry.image[("vertex", new_u)] = ("vertex", u)
        for cell in (("vertex", m), edge(new_u, m), edge(m, new_v)):
            carry.image[cell] = old_edge
    return Polygon(parts), carry


def repeated(solid, rng):
    """Corners given more than once in a row, by their own number and by new ones, also across the
    end of a ring or facet. Returns a third thing: all cells of the new boundary."""
    return (polygon_repeated if isinstance(solid, Polygon) else mesh_repeated)(solid, rng)


def run_of(rng):
    return rng.choice([1, 1, 2, 3, 4])


def polygon_repeated(solid, rng):
    parts, carry, cells, old, new = [], CellMap(), set(), 0, 0
    for part in solid.parts:
        parts.append([])
        for r in part:
            runs = [run_of(rng) for _ in r]
            owners = [k for k, n in enumerate(runs) for _ in range(n)]
            turn = rng.randrange(runs[0])       # so the first run may lie around the end
            owners = owners[turn:] + owners[:turn]
            parts[-1].append([r[k] for k in owners])
            for k, owner in enumerate(owners):
                cells.add(("vertex", new + k))
                carry.image[("vertex", new + k)] = ("vertex", old + owner)
                after = (k + 1) % len(owners)
                if owners[after] != owner:
                    cells.add(edge(new + k, new + after))
                    carry.image[edge(new + k, new + after)] = edge(old + owner, old + owners[after])
            old, new = old + len(r), new + len(owners)
    return Polygon(parts), carry, cells


def mesh_repeated(solid, rng):
    vertices, facets, carry = list(solid.vertices), [], CellMap()
    cells = {("face", f) for f in range(len(solid.facets))}
    for f in solid.facets:
        corners, runs = [], [run_of(rng) for _ in f]
        for v, n in zip(f, runs):
            for _ in range(n):
                corners.append((v, v))
                if rng.randrange(2):
                    corners[-1] = (len(vertices), v)
                    vertices.append(solid.vertices[v])
        turn = rng.randrange(runs[0])           # a fan goes on to begin where it did
        corners = corners[turn:] + corners[:turn]
        facets.append([u for u, _ in corners])
        for (u, a), (v, b) in zip(corners, corners[1:] + corners[:1]):
            cells.add(("vertex", u))
            carry.image[("vertex", u)] = ("vertex", a)
            if a != b:
                cells.add(edge(u, v))
                carry.image[edge(u, v)] = edge(a, b)
    return Mesh(vertices, facets), carry, cells


def facets_halved(mesh):
    """Every facet of four corners cut from the middle of one side to that of the other."""
    cut, carry = edges_cut(mesh)
    facets = []
    for number, (f, g) in enumerate(zip(mesh.facets, cut.facets)):
        convex = -1 not in turns([mesh.vertices[k] for k in f])
        parts = [g]
        if len(f) == 4 and convex and 0 not in turns([mesh.vertices[k] for k in f]):
            parts = [g[1:6], [g[5], g[6], g[7], g[0], g[1]]]
            carry.image[edge(g[1], g[5])] = ("face", number)
        for part in parts:
            carry.image[("face", len(facets))] = ("face", number)
            facets.append(part)
    return Mesh(cut.vertices, facets), carry


def inside_ring(p, r):
    inside = False
    for a, b in zip(r, r[1:] + r[:1]):
        if (a[1] > p[1]) != (b[1] > p[1]):
            turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
            inside ^= (turn > 0) == (b[1] > a[1])
    return inside


def complement(solid, size):
    """The closure of a big box minus the solid; the box's cells come under names of their own."""
    if isinstance(solid, Mesh):
        box = block(-size, -size, -size, size, size, size)
        return joined(inside_out(solid), box), CellMap()
    holes = [r for part in solid.parts for r in part[1:]]
    frames = [[box_ring(-size, -size, size, size)]] + [[h] for h in holes]
    for part in solid.parts:
        outer = part[0]
        home = next((f for f in frames[1:]
                     if outer is not f[0] and all(inside_ring(p, f[0]) for p in outer)), frames[0])
        home.append(outer)
    out, carry = Polygon(frames), CellMap()
    start, old = {}, 0
    for part in solid.parts:
        for r in part:
            start[id(r)] = old
            old += len(r)
    new = 0
    for part in frames:
        for r in part:
            n = len(r)
            if id(r) in start:
                for k in range(n):
                    a, b = start[id(r)] + k, start[id(r)] + (k + 1) % n
                    carry.image[("vertex", new + k)] = ("vertex", a)
                    carry.image[edge(new + k, new + (k + 1) % n)] = edge(a, b)
            new += n
    return out, carry


def bounds(solid):
    return [(min(c), max(c)) for c in zip(*solid.vertices)]


def beside(solid, other, gap):
    """`other` moved so that its box stands `gap` to the right of the solid's box."""
    shift = bounds(solid)[0][1] + gap - bounds(other)[0][0]
    return other.mapped(lambda p: (p[0] + shift,) + tuple(p[1:]))


def union(first, second):
    """Two disjoint solids as one; the cells of the second come after those of the first."""
    if isinstance(first, Polygon):
        both, faces = Polygon(first.parts + second.parts), 0
    else:
        both, faces = joined(first, second), len(first.facets)
    base = len(first.vertices)

    def shifted(cells):
        return {(c[0], c[1] + faces) if c[0] == "face" else (c[0],) + tuple(k + base for k in c[1:])
                for c in cells}
    return both, shifted
