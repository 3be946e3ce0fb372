# suite
"""`collide --clearance R` on unions of convex solids, decided by the distances of their features.

SPDX-License-Identifier: GPL-3.0-or-later

Two closed convex solids have a point in common if no axis of a facet or of a product of edges separates them, which a second
method here decides already; else the least of the distances of their vertices, edges and facets, each taken where the feet of the
common perpendicular lie in the closed features, is theirs. A union's is the least of its parts'. The letter is I below R, B at R, O
above it. It can change only where some pair of features, with its feet or without, is at distance R: all of these times are found, by
Sturm's sequences, of all pairs, and none is told apart from another. The letter is taken in each gap, exactly, and at each time; at an
irrational one at a place 2^-400 beside it, where a square distance nearer to R^2 than 2^-120 is R^2: both are values of polynomials of
small coefficients at roots of others.
"""
from collections import Counter
from math import isqrt

from convex import NOTHING, SURE, Part, dot, floats, near, rough_place, varies, width
from exact import Fraction as F, to_double
from pairs import Checks, Collide, Trace, agrees, first_agrees, options
from placed import placed

from algebra import Root, add, between, mul, primitive, roots, scale, sort_roots, sub  # noqa: E402
from solids import cross, minus  # noqa: E402

PAIRS = {2: 16, 3: 6}
RADII = [F(1, 16), F(1, 8), F(1, 3), F(1, 2), F(1), F(3, 2)]
MOST = 13  # vertices of both parts in space, beyond which the algebra is slow


# ------------------------------------------------------------------------------------ one instant
class Features:
    """A convex part: its Part, and three corners of each triangle that its facets are cut into, which are all edges' too."""

    def __init__(self, solid):
        self.part = Part(solid)
        whole = solid.facets if solid.dimension == 3 else []
        self.triangles = [(f[0], f[k], f[k + 1]) for f in whole for k in range(1, len(f) - 1)]


def crossed(a, b):
    """The cross product, in the plane its one number."""
    return cross(a, b) if len(a) == 3 else (a[0] * b[1] - a[1] * b[0],)


def to_edges(points, at, edges):
    """Square distances of points from edges where the foot is in the edge."""
    for i, j in edges:
        e = minus(at[j], at[i])
        square = dot(e, e)
        for x in points:
            way = minus(x, at[i])
            if 0 <= dot(way, e) <= square:
                normal = crossed(way, e)
                yield dot(normal, normal) / square


def to_triangles(points, at, triangles):
    for a, b, c in triangles:
        p, q, r = at[a], at[b], at[c]
        n = cross(minus(q, p), minus(r, p))
        for x in points:
            if all(dot(cross(n, minus(v, u)), minus(x, u)) >= 0 for u, v in ((p, q), (q, r), (r, p))):
                yield dot(n, minus(x, p)) ** 2 / dot(n, n)


def of_edges(at, edges, to, others):
    for i, j in edges:
        e = minus(at[j], at[i])
        for k, m in others:
            f, way = minus(to[m], to[k]), minus(to[k], at[i])
            kappa = cross(e, f)
            square = dot(kappa, kappa)
            if square and 0 <= dot(cross(way, f), kappa) <= square and 0 <= dot(cross(way, e), kappa) <= square:
                yield dot(way, kappa) ** 2 / square


def square_distance(one, at, other, to, nothing=0):
    """The square distance of two convex parts in place; widths from -nothing on are no gap."""
    if width(one.part, at, other.part, to) >= -nothing:
        return 0
    found = [dot(minus(x, y), minus(x, y)) for x in at for y in to]
    found += to_edges(at, to, other.part.edges)
    found += to_edges(to, at, one.part.edges)
    if len(at[0]) == 3:
        found += to_triangles(at, to, other.triangles)
        found += to_triangles(to, at, one.triangles)
        found += of_edges(at, one.part.edges, to, other.part.edges)
    return min(found)


class Scene:
    """Unions of convex parts, the first one moving, and R."""

    def __init__(self, moving, motion, fixed, radius):
        self.pairs = [(Features(a), Features(b)) for a in moving for b in fixed]
        self.motion, self.radius = motion, radius

    def exactly(self, t):
        return min(square_distance(a, [self.motion.map(p, t) for p in a.part.vertices], b, b.part.vertices) for a, b in self.pairs)

    def roughly(self, t):
        piece, now = self.motion.piece_at(t), to_double(t)
        return min(square_distance(a, rough_place(piece, a.part.rough, now), b, b.part.rough, SURE) for a, b in self.pairs)

    def letter(self, root):
        """In doubles where they are sure, else exactly."""
        t, least = near(root, 60), self.radius ** 2
        rough = self.roughly(t) - to_double(least)
        if abs(rough) > SURE * (1 + to_double(least)):
            return "I" if rough < 0 else "O"
        root.settle()
        apart = self.exactly(near(root, 400)) - least
        return "B" if abs(apart) < NOTHING else "I" if apart < 0 else "O"


# ------------------------------------------------------------------------------------- all times
def sums(*terms):
    out = []
    for term in terms:
        out = add(out, term)
    return out


def inner(a, b):
    return sums(*(mul(x, y) for x, y in zip(a, b)))


def outer(a, b):
    if len(a) == 2:
        return [sub(mul(a[0], b[1]), mul(a[1], b[0]))]
    return [sub(mul(a[i], b[j]), mul(a[j], b[i])) for i, j in ((1, 2), (2, 0), (0, 1))]


def less(a, b):
    return [sub(x, y) for x, y in zip(a, b)]


def forms_of_points(moved, fixed, wide, square):
    """Vertex against vertex: |X - y w|^2 - R^2 w^2."""
    for x in moved:
        for y in fixed:
            way = less(x, y)
            yield sub(inner(way, way), scale(wide, square))


def forms_of_edges(points, ends, edges, wide, square):
    """Vertex against edge: |d x e|^2 - R^2 |e|^2 w^2; both are over w, e too."""
    for i, j in edges:
        e = less(ends[j], ends[i])
        for x in points:
            normal = outer(less(x, ends[i]), e)
            yield sub(inner(normal, normal), scale(mul(inner(e, e), wide), square))


def forms_of_facets(points, corners, facets, wide, square):
    """Vertex against facet: (n d)^2 - R^2 |n|^2 w^2."""
    for a, b, c in facets:
        n = outer(less(corners[b], corners[a]), less(corners[c], corners[a]))
        for x in points:
            height = inner(n, less(x, corners[a]))
            yield sub(mul(height, height), scale(mul(inner(n, n), wide), square))


def forms_of_pairs(ends, edges, others, pairs, wide, square):
    """Edge against edge: (d (e x f))^2 - R^2 |e x f|^2 w^2."""
    for i, j in edges:
        e = less(ends[j], ends[i])
        for k, m in pairs:
            normal = outer(e, less(others[m], others[k]))
            height = inner(normal, less(others[k], ends[i]))
            yield sub(mul(height, height), scale(mul(inner(normal, normal), wide), square))


def forms(piece, one, other, square):
    """Where they vanish some pair of features is at distance R. All places are over the piece's w."""
    moved = [[sums(b, *(scale(p, x) for p, x in zip(row, v))) for row, b in zip(piece.a, piece.b)] for v in one.part.vertices]
    fixed = [[scale(piece.w, x) for x in v] for v in other.part.vertices]
    wide = mul(piece.w, piece.w)
    yield from forms_of_points(moved, fixed, wide, square)
    yield from forms_of_edges(moved, fixed, other.part.edges, wide, square)
    yield from forms_of_edges(fixed, moved, one.part.edges, wide, square)
    if len(moved[0]) == 3:
        yield from forms_of_facets(moved, fixed, other.part.facets, wide, square)
        yield from forms_of_facets(fixed, moved, one.part.facets, wide, square)
        yield from forms_of_pairs(moved, one.part.edges, fixed, other.part.edges, wide, square)


def whole(form):
    """The form times a positive integer, in integers; without its factors that no motion's times are roots of."""
    common = 1
    for c in form:
        common *= F(c).denominator // gcd_of(common, F(c).denominator)
    return tuple(primitive([int(F(c) * common) for c in form]))


def gcd_of(a, b):
    while b:
        a, b = b, a % b
    return a


def critical(scene):
    """All times at which the letter can change, ends and breaks too."""
    out = [Root(value=scene.motion.start)]
    for piece in scene.motion.pieces:
        out.append(Root(value=piece.hi))
        found = {whole(f) for a, b in scene.pairs for f in forms(piece, a, b, scene.radius ** 2) if len(f) > 1}
        for form in found:
            if varies(form, piece.lo, piece.hi):
                out += roots(list(form), piece.lo, piece.hi)
    return sort_roots(out)


def oracle(scene):
    times = critical(scene)
    gaps = [scene.letter(Root(value=between(a, b))) for a, b in zip(times, times[1:])]
    return Trace(times, [scene.letter(t) for t in times], gaps)


# ----------------------------------------------------------------------------------------- checks
def radius_of(rng, scene):
    """Any; or the distance at some time, if that is rational, so that the word has a B there."""
    motion = scene.motion
    for _ in range(4 * (rng.random() < 0.6)):
        square = F(scene.exactly(motion.start + (motion.end - motion.start) * F(rng.randint(0, 12), 12)))
        root = F(isqrt(int(square.numerator)), isqrt(int(square.denominator)))
        if root and root ** 2 == square:
            return root
    return rng.choice(RADII)


def one_pair(collide, checks, name, moving, motion, fixed, rng, tally):
    scene = Scene(moving.parts, motion, fixed.parts, F(1))
    scene.radius = radius_of(rng, scene)
    trace = oracle(scene)
    tally[trace.word()] += 1
    clearance = ("--clearance", str(scene.radius))
    full = collide.ask(name, moving.whole, motion, fixed.whole, *clearance)
    if full is None or not agrees(checks, full, trace, name, *clearance):
        return
    first = collide.ask(name, moving.whole, motion, fixed.whole, "--first", *clearance)
    if first is not None:
        first_agrees(checks, first, full, name, *clearance)


def size(solid):
    return sum(len(part.vertices) for part in solid.parts)


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    collide = Collide(args, checks)
    for d, count in PAIRS.items():
        for k in args.rounds(count, str(d)):
            name, *pair = placed(args.random, d)
            while d == 3 and size(pair[0]) + size(pair[2]) > MOST:
                name, *pair = placed(args.random, d)
            one_pair(collide, checks, f"{d} {k} {name}", *pair, args.random, tally)
    print(f"{len(tally)} words: " + ", ".join(f"{word} {n}" for word, n in tally.most_common(20)))
    checks.finish()


if __name__ == "__main__":
    main()
