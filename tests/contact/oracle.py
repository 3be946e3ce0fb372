"""Contact points by another road than the program's: differentiation of the pullback, explicit cones, a second tracer.

SPDX-License-Identifier: GPL-3.0-or-later

The program takes g, its derivative and theta from the motion's derivatives at y; here they are derivatives of
phi = n c - d along the trajectory of P = M(t) y. Roles are asked of the directions themselves: for samples of every
cell of an arrangement of planes, is a point at that direction covered next to t.
"""
import itertools
import os
import sys
from math import gcd

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from algebra import Root, compare, trim  # noqa: E402
from exact import Fraction as F  # noqa: E402
from motion import fadd, fmul  # noqa: E402
from solids import Polygon, cross, edge, minus, oriented  # noqa: E402
from tracer import NOW, Edge, Facet, dot, facets_of, fixed, parity, trace  # noqa: E402


def primitive(v):
    den = 1
    for x in v:
        den *= F(x).denominator
    v = [int(F(x) * den) for x in v]
    g = 0
    for x in v:
        g = gcd(g, x)
    return tuple(x // g for x in v)


class Side:
    """A facet of the solid: its outward primitive normal, its plane n x = d, the cell, a view for containment."""

    def __init__(self, name, normal, point, seen):
        self.name, self.normal = name, primitive(normal)
        self.offset = dot(self.normal, point)
        self.seen = seen


def newell(points):
    total = (F(0),) * 3
    for p, q in zip(points, points[1:] + points[:1]):
        total = tuple(a + b for a, b in zip(total, cross(p, q)))
    return total


def sides_of(solid):
    """All facets, with outward normals."""
    if isinstance(solid, Polygon):
        flat = oriented(solid)
        left = {(solid.vertices[u], solid.vertices[v]): (u, v) for u, v in solid.edges}
        out = []
        for u, v in flat.edges:
            p, q = flat.vertices[u], flat.vertices[v]
            a, b = left.get((p, q)) or left[(q, p)]
            out.append(Side(edge(a, b), (q[1] - p[1], p[0] - q[0]), p, Edge(solid, a, b)))
        return out
    return [Side(("face", k), newell([solid.vertices[i] for i in f]), solid.vertices[f[0]], Facet(solid, k))
            for k, f in enumerate(solid.facets)]


def cells_at(side, point):
    if dot(side.normal, point) != side.offset:
        return set()
    return fixed([side.seen], point).cells(NOW)


def at_point(sides, point):
    return [s for s in sides if cells_at(s, point)]


def lowest(sides, point):
    """The lowest cell, of these the one of the least numbers."""
    rank = {"vertex": 0, "edge": 1, "face": 2}
    return min((c for s in sides for c in cells_at(s, point)), key=lambda c: (rank[c[0]], c[1:]))


# ------------------------------------------------------------------------------------------- series

def taylor(p, t, n):
    """Coefficients of p(t + s) up to s^n."""
    out, work = [], [F(c) for c in p] or [F(0)]
    for _ in range(n + 1):
        rest, acc = [], F(0)
        for c in reversed(work):
            acc = acc * t + c
            rest.append(acc)
        out.append(rest[-1])
        work = rest[:-1][::-1] or [F(0)]
    return out


def divided(x, w):
    """The power series x / w."""
    out = []
    for k in range(len(x)):
        out.append((x[k] - sum(out[j] * w[k - j] for j in range(k))) / w[0])
    return out


def path(piece, point, t, n):
    """Coefficients of c(t + s): n + 1 of each coordinate."""
    xs, w = piece.trajectory(point)
    w = taylor(w, t, n)
    return [divided(taylor(x, t, n), w) for x in xs]


def pullback(piece, side, point, t, n):
    c = path(piece, point, t, n)
    phi = [dot(side.normal, [x[k] for x in c]) for k in range(n + 1)]
    phi[0] -= side.offset
    return phi


def order_and_sign(piece, side, point, t, which):
    """Order of the zero at t, None where phi vanishes; sign of phi on that side."""
    xs, w = piece.trajectory(point)
    n = max([len(x) for x in xs] + [len(w)]) + 1
    phi = pullback(piece, side, point, t, n)
    for k, c in enumerate(phi):
        if c:
            return k, (1 if c > 0 else -1) * (-1 if which < 0 and k % 2 else 1)
    return None, 0


def pieces_beside(motion, t):
    """(side, piece): before t and after it."""
    before = [(-1, p) for p in motion.pieces if p.lo < t <= p.hi]
    return before + [(1, p) for p in motion.pieces if p.lo <= t < p.hi]


# ------------------------------------------------------------------------------------------- cones

class Cone:
    """The solid next to a boundary point: states of directions, by location beside the point."""

    def __init__(self, solid, sides, point):
        self.solid, self.point = solid, point
        self.facets = facets_of(solid)
        self.sides, self.here = sides, at_point(sides, point)
        self.normals = sorted({s.normal for s in self.here})
        self.known = {}

    def state(self, u):
        key = tuple((x > 0) - (x < 0) for x in (dot(n, u) for n in self.normals))
        if key not in self.known:
            self.known[key] = self.locate(u)
        return self.known[key]

    def locate(self, u):
        step = F(1)
        for s in self.sides:
            height, slope = dot(s.normal, self.point) - s.offset, dot(s.normal, u)
            if height and slope and -height / slope > 0:
                step = min(step, -height / slope / 2)
        x = tuple(p + step * a for p, a in zip(self.point, u))
        return "B" if at_point(self.sides, x) else parity(self.solid, self.facets, x)

    def swept(self, u, e):
        """Does u + s e lie in the cone for some s >= 0?"""
        cuts = {F(0)}
        for n in self.normals:
            if dot(n, e):
                cuts.add(-F(dot(n, u)) / dot(n, e))
        cuts = sorted(s for s in cuts if s >= 0)
        asked = cuts + [(a + b) / 2 for a, b in zip(cuts, cuts[1:])] + [cuts[-1] + 1]
        return any(self.state(tuple(a + s * b for a, b in zip(u, e))) != "O" for s in asked)

    def kind(self):
        """convex, reflex or other, by which states the cells of the normals' arrangement have."""
        states = {}
        for u in samples([list(n) for n in self.normals], []):
            states[tuple(dot(n, u) > 0 for n in self.normals)] = self.state(u)
        inner = [k for k, v in states.items() if v == "I"]
        outer = [k for k, v in states.items() if v == "O"]
        if inner == [tuple(False for _ in self.normals)]:
            return "convex"
        return "reflex" if outer == [tuple(True for _ in self.normals)] else "other"

    def rays(self):
        if self.solid.dimension == 2:
            return []
        return [cross(a, b) for a, b in itertools.combinations(self.normals, 2) if any(cross(a, b))]


def samples(normals, more):
    """Directions: some in every open cell of the planes with these normals."""
    d = len(normals[0])
    if d == 2:
        rays = [(-n[1], n[0]) for n in normals + more] + [(1, 0), (0, 1)]
        rays = sorted({primitive(r) for r in rays} | {primitive((-r[0], -r[1])) for r in rays}, key=angle)
        return [tuple(x + y for x, y in zip(a, b)) if cross2(a, b) else (-a[1], a[0])
                for a, b in zip(rays, rays[1:] + rays[:1])]
    planes = {primitive(n) for n in normals + more if any(n)} | {(1, 0, 0), (0, 1, 0), (0, 0, 1)}
    rays = {primitive(cross(a, b)) for a, b in itertools.combinations(sorted(planes), 2) if any(cross(a, b))}
    rays = sorted(rays | {tuple(-x for x in r) for r in rays})
    out = []
    for a, b in itertools.combinations(rays, 2):
        out.append(tuple(7 * x + 5 * y for x, y in zip(a, b)))
    for k, (a, b, c) in enumerate(itertools.combinations(rays, 3)):
        if k > 4000:
            break
        out.append(tuple(x + y + z for x, y, z in zip(a, b, c)))
    return [u for u in out if any(u) and all(dot(n, u) for n in planes)]


def angle(v):
    import math
    return math.atan2(v[1], v[0])


def cross2(a, b):
    return a[0] * b[1] - a[1] * b[0]


def leading(cone, piece, point, t, which):
    """The first coefficient of c(t + s) that leaves the cell, on one side; None if none does."""
    xs, w = piece.trajectory(point)
    n = max([len(x) for x in xs] + [len(w)]) + 1
    c = path(piece, point, t, n)
    # times w, which is positive: a polynomial again, so n terms are all
    for k in range(1, n + 1):
        v = tuple(x[k] for x in c)
        if any(dot(m, v) for m in cone.normals):
            return tuple(-x for x in v) if which < 0 and k % 2 else v
    return None


def first(piece, point, t, which):
    return tuple(which * x[1] for x in path(piece, point, t, 1))


def role(solid, sides, motion, t, y):
    """contact, egress, ingress or hidden."""
    point = motion.map(y, t)
    cone = Cone(solid, sides, y)
    here = pieces_beside(motion, t)
    values = {(w, s.normal): -pullback(p, s, point, t, 1)[1] for w, p in here for s in cone.here}
    kind = cone.kind()
    ways = [leading(cone, p, point, t, w) if kind == "other" else first(p, point, t, w) for w, p in here]
    ways = [e for e in ways if e is not None]
    if solid.dimension == 2:
        more = [[-e[1], e[0]] for e in ways if any(e)]
    else:
        more = [list(cross(e, r)) for e in ways for r in cone.rays()]
        if len(cone.normals) == 2:
            more += [list(cross(e, cross(*cone.normals))) for e in ways]
    for u in samples([list(n) for n in cone.normals], more):
        if cone.state(u) == "O" and not any(cone.swept(u, e) for e in ways):
            return "contact"
    if all(v > 0 for v in values.values()):
        return "egress"
    return "ingress" if all(v < 0 for v in values.values()) else "hidden"


# ------------------------------------------------------------------------------------------- times

def states_beside(contacts, t):
    for k, c in enumerate(contacts):
        first, last = compare(c.start, Root(value=t)), compare(c.end, Root(value=t))
        if first <= 0 <= last:
            return k, c.left if first == 0 else "B", c.right if last == 0 else "B", first == last
    return None


def intervals(word, contacts, motion, inside):
    """Closed intervals of times in S, or with `inside` the closures of those in iS, as pairs of Roots."""
    out, met = [], 0
    for letter in word:
        if letter == "B":
            span = contacts[met].start, contacts[met].end
            met += 1
        else:
            span = (contacts[met - 1].end if met else Root(value=motion.start),
                    contacts[met].start if met < len(contacts) else Root(value=motion.end))
        if letter == "I" or (letter == "B" and not inside):
            out.append(span)
    return out


def reflected(x, t):
    """2 t - x."""
    if x.value is not None:
        return Root(value=2 * t - x.value)
    p = [F(0)]
    for c in reversed(x.poly):
        p = fadd(fmul(p, [2 * t, F(-1)]), [F(c)])
    den = 1
    for c in p:
        den *= c.denominator
    return Root(poly=trim([int(c * den) for c in p]), lo=2 * t - x.hi, hi=2 * t - x.lo)


def nearest(spans, t):
    """The time in the intervals nearest to t, t excepted unless it is no isolated one; None: there is none."""
    now, before, after = Root(value=t), [], []
    for a, b in spans:
        from_t, to_t = compare(a, now), compare(b, now)
        if from_t <= 0 <= to_t and not from_t == to_t == 0:
            return now
        if to_t < 0:
            before.append(b)
        if from_t > 0:
            after.append(a)
    if not before or not after:
        return before[-1] if before else after[0] if after else None
    return before[-1] if compare(reflected(before[-1], t), after[0]) <= 0 else after[0]


def trimming(word, contacts, k, instant, beside):
    if "I" in word:
        return "trimmed_near" if "I" in beside else "trimmed_far"
    return "slides" if not instant else "simple" if len(contacts) == 1 else "meets"
