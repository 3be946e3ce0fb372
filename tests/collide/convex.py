# suite
"""Unions of convex solids that turn, decided by separating axes.

SPDX-License-Identifier: GPL-3.0-or-later

Two convex solids are apart, or touch alone, if and only if they do so along the normal of a facet of either or along
a product of two edges: those are the normals of their Minkowski difference. A union is in the largest state of its
parts, since open sets that meet do so off the borders of parts. States change at roots of vertex against facet and of
edge against edge, and Sturm's sequences isolate all of them; the state is taken in each gap, and at each root.
At an irrational root the coordinates are those of a place 2^-400 beside it, and a width below 2^-120 is 0: the widths are
polynomials of small coefficients at roots of others, which have no values between. Cells at rational times are those
found by clipping.
"""
from collections import Counter
from math import comb

from meeting import meeting_cells
from exact import Fraction as F, to_double
from pairs import Checks, Collide, Trace, agrees, cell_pairs, first_agrees, larger, options
from placed import placed

from algebra import Root, add, between, mul, primitive, roots, scale, sort_roots, sub  # noqa: E402
from solids import cross, minus  # noqa: E402

PAIRS = {2: 30, 3: 12}
NOTHING = F(1, 2 ** 120)
SURE = 1e-7         # doubles of these scenes are far more exact


# ------------------------------------------------------------------------------------ one instant

def dot(a, b):
    return sum(x * y for x, y in zip(a, b)) if len(a) < 3 else a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def along(n, points):
    """Where the points lie along n."""
    if len(n) < 3:
        return [n[0] * x + n[1] * y for x, y in points]
    return [n[0] * x + n[1] * y + n[2] * z for x, y, z in points]


class Part:
    """A convex part in its own coordinates: vertices, two vertices of each edge, three of each facet (edge in E²)."""

    def __init__(self, solid):
        self.vertices, self.rough = solid.vertices, floats(solid.vertices)
        self.edges = list(solid.edges)
        self.facets = [f[:3] for f in solid.facets] if solid.dimension == 3 else self.edges


def directions(part, at):
    """One vector of each edge, one normal of each facet, for vertices that were moved."""
    if len(at[0]) == 2:
        return [], [(at[b][1] - at[a][1], at[a][0] - at[b][0]) for a, b in part.edges]
    return ([minus(at[b], at[a]) for a, b in part.edges],
            [cross(minus(at[b], at[a]), minus(at[c], at[a])) for a, b, c in part.facets])


def distinct(vectors):
    """The vectors without those parallel to another one, where that is exact and cheap to see."""
    out = {}
    for v in vectors:
        lead = next((x for x in v if x), None)
        if lead:
            out[tuple(x / lead for x in v)] = v
    return list(out.values())


def width(one, at, other, to):
    """The least width that the two have in common along an axis of unit sum norm; negative: they are apart."""
    (edges, normals), (edges_, normals_) = directions(one, at), directions(other, to)
    axes = distinct(normals + normals_ + [cross(e, f) for e in distinct(edges) for f in distinct(edges_)])
    least = None
    for n in axes:
        p, q = along(n, at), along(n, to)
        common = (min(max(p), max(q)) - max(min(p), min(q))) / sum(map(abs, n))
        least = common if least is None else min(least, common)
    return least


def floats(points):
    return [tuple(map(to_double, p)) for p in points]


def rough_place(piece, points, t):
    """The moved points at a time, in doubles."""
    a, b, w = [[horner(p, t) for p in row] for row in piece.a], [horner(p, t) for p in piece.b], horner(piece.w, t)
    return [tuple((dot(row, p) + x) / w for row, x in zip(a, b)) for p in points]


def horner(poly, t):
    out = 0.0
    for c in reversed(poly):
        out = out * t + c
    return out


def letter(one, other, motion, root):
    """In doubles where they are sure, else exactly."""
    t = near(root, 60)
    common = width(one, rough_place(motion.piece_at(t), one.rough, to_double(t)), other, other.rough)
    if abs(common) < SURE:
        root.settle()
        common = width(one, [motion.map(p, near(root, 400)) for p in one.vertices], other, other.vertices)
    return "B" if abs(common) < NOTHING else "I" if common > 0 else "O"


def near(root, bits):
    root.narrow(F(1, 2 ** bits))
    low, high = root.bounds()
    return (low + high) / 2


# ------------------------------------------------------------------------------------- all times

def affine(n, c, xs, w):
    """n x + c w for polynomials xs over w."""
    form = scale(w, c)
    for k, x in zip(n, xs):
        form = add(form, scale(x, k))
    return form


def whole(n, p):
    """The form n (x - p) with integers: (n, c)."""
    flat = integral_all(list(n) + [-dot(n, p)])
    return flat[:-1], flat[-1]


def integral_all(row):
    den = 1
    for x in row:
        den *= F(x).denominator
    return [int(x * den) for x in row]


def moved_vertex(piece, v):
    """Polynomials over piece.w, with v's denominator taken out: (coordinates, weight)."""
    row = integral_all(list(v) + [F(1)])
    return [affine(row[:-1], row[-1], a, b) for a, b in zip(piece.a, piece.b)], scale(piece.w, row[-1])


def vertex_facet(piece, one, other):
    """Vertices of the moving part against facets of the fixed one, and the other way round."""
    for (a, n) in zip(other.facets, directions(other, other.vertices)[1]):
        form = whole(n, other.vertices[a[0]])
        yield from (affine(*form, *moved_vertex(piece, v)) for v in one.vertices)
    for (a, n) in zip(one.facets, directions(one, one.vertices)[1]):
        form = whole(n, one.vertices[a[0]])
        yield from (affine(*form, *piece.trajectory(q)) for q in other.vertices)


def edge_edge(piece, one, other):
    """det(Ma - p, Mb - p, q - p) = (Ma - p) x (Mb - p) . (q - p)."""
    moved = [moved_vertex(piece, v) for v in one.vertices]
    for p, q in ((other.vertices[i], other.vertices[j]) for i, j in other.edges):
        row = integral_all(list(p) + list(q) + [F(1)])
        p_, u, den = row[:3], [b - a for a, b in zip(row[:3], row[3:6])], row[6]
        ends = [([sub(scale(x, den), scale(w, k)) for x, k in zip(xs, p_)], w) for xs, w in moved]
        for i, j in one.edges:
            x, y = ends[i][0], ends[j][0]
            yield add(add(scale(minor(x, y, 1, 2), u[0]), scale(minor(x, y, 2, 0), u[1])), scale(minor(x, y, 0, 1), u[2]))


def minor(x, y, i, j):
    return sub(mul(x[i], y[j]), mul(x[j], y[i]))


def critical(motion, one, other):
    """All times at which the state of two parts can change, ends and breaks too."""
    out = [Root(value=motion.start)]
    for piece in motion.pieces:
        forms = list(vertex_facet(piece, one, other))
        if len(one.vertices[0]) == 3:
            forms += edge_edge(piece, one, other)
        out.append(Root(value=piece.hi))
        for form in {tuple(primitive(f)) for f in forms if len(f) > 1}:
            if varies(form, piece.lo, piece.hi):
                out += roots(list(form), piece.lo, piece.hi)
    return sort_roots(out)


def varies(form, low, high):
    """False if all Bernstein coefficients on [low, high] have one sign, so that there is no root."""
    wide = []                               # the form at low + (high - low) s, by Horner's rule
    for c in reversed(form):
        raised = [F(0)] + [x * (high - low) for x in wide]
        wide = [x * low + y for x, y in zip(wide + [F(0)], raised)]
        wide[0] += c
    n = len(form) - 1
    heights = [sum(F(comb(k, i), comb(n, i)) * wide[i] for i in range(k + 1)) for k in range(n + 1)]
    return not (min(heights) > 0 or max(heights) < 0)


def oracle(moving, motion, fixed):
    """The Trace of two unions of convex parts."""
    pairs = [(Part(a), Part(b)) for a in moving for b in fixed]
    times = sort_roots([t for a, b in pairs for t in critical(motion, a, b)])

    def state(root):
        best = "O"
        for a, b in pairs:
            best = larger(best, letter(a, b, motion, root))
            if best == "I":
                break
        return best
    gaps = [state(Root(value=between(a, b))) for a, b in zip(times, times[1:])]
    return Trace(times, [state(t) for t in times], gaps)


# ----------------------------------------------------------------------------------------- checks

def one_pair(collide, checks, name, moving, motion, fixed, tally):
    trace = oracle(moving.parts, motion, fixed.parts)
    tally[trace.word()] += 1
    full = collide.ask(name, moving.whole, motion, fixed.whole)
    if full is None or not agrees(checks, full, trace, name):
        return
    for c in full.contacts:
        if isinstance(c["from"], str):
            checks.equal(cell_pairs(c), meeting_cells(moving.whole, motion, fixed.whole, F(c["from"])), name, "cells")
    first = collide.ask(name, moving.whole, motion, fixed.whole, "--first")
    if first is not None:
        first_agrees(checks, first, full, name)


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    collide = Collide(args, checks)
    for d, count in PAIRS.items():
        for k in args.rounds(count, str(d)):
            name, *pair = placed(args.random, d)
            while d == 3 and name != "fans" and len(pair[0].parts) * len(pair[2].parts) > 2:        # too slow
                name, *pair = placed(args.random, d)
            one_pair(collide, checks, f"{d} {k} {name}", *pair, tally)
    print(f"{len(tally)} words: " + ", ".join(f"{word} {n}" for word, n in tally.most_common(20)))
    checks.finish()


if __name__ == "__main__":
    main()
