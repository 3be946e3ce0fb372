#!/usr/bin/env python3
# suite
"""`graze contact --snap`: points moved to the contact sets of faces, edges and vertices; by hand, and by a second method.

SPDX-License-Identifier: GPL-3.0-or-later

The program cuts each simplex by the signs of g and takes the nearest point of what is left. Here the nearest point is
looked for among the feet on all flats that can hold it: the facet's plane, its edges' lines, where g is 0 on a side of t
in any of these, and corners; those in the contact set are compared. g is the derivative of a pullback (oracle.py), and
vertices are asked by directions.
"""
import csv
import itertools
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import oracle  # noqa: E402
from exact import Fraction as F  # noqa: E402
from hand import ALONG, BACK, BLOCK, L_PRISM, ON, RIGHT, SQUARE, moves, off, shift  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from scenes import scenes  # noqa: E402
from solids import Polygon, minus  # noqa: E402
from tracer import dot  # noqa: E402

# Facets at an inner point of a cell.
FACETS = {(2, "edge"): 1, (3, "edge"): 2, (3, "face"): 1}
ANSWERS = ("role", "theta", "contact_order", "orientation", "left", "right", "trimmed", "status", "near", "near_in", "word")
CUBE = off([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))],
           [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
STAND3 = moves(3, (0, 1, shift("0", "0", "0")))
# M = R(t) x + b, R of the quaternion (1, t, t, 0): at t = 0 A' y = 2 (1, 1, 0) x y, so on the edge (1, 1, z) the velocity
# is (2 z, -2 z, 0) + b'; with b' = (-2/3, 4/3, 0) g of x = 1 is 2 z - 2/3, of y = 1 it is 4/3 - 2 z: contact up to 1/3 and
# from 2/3 on.
TWO_RUNS = moves(3, (-1, 1, {"compose": [{"quaternion": ["1", "t", "t", "0"]},
                                         shift("-2/3*t", "4/3*t", "0")]}))
# Solid, motion, time and point, cell, then where it goes and the squared distance, None where there is no contact.
HAND = [
    # theory: on x = 2 of the block g is 0 at y = 1 - t^2
    (BLOCK, ALONG, "1/2", "5 1/3", "edge 0-3", "2 3/4", "1321/144"),
    # t = 0, g >= 0 is not asked: A' y + b' = (2 - 2 y, 2 x), on y = -1 g = -2 x < 0 all along: its nearest point
    (BLOCK, ALONG, "0", "3 1", "edge 0-1", "3 -1", "4"),
    # and on y = 1 g = 2 x > 0
    (BLOCK, ALONG, "0", "3 1", "edge 2-3", None, None),
    # right by 8 t: the top slides, the front does not
    (SQUARE, RIGHT, "1/2", "1 5", "edge 2-3", "1 2", "9"),
    (SQUARE, RIGHT, "1/2", "-3 5", "edge 2-3", "0 2", "18"),
    (SQUARE, RIGHT, "1/2", "1 5", "edge 1-2", None, None),
    (SQUARE, RIGHT, "1/2", "1 1", "vertex 2", "2 2", "2"),
    (SQUARE, RIGHT, "1", "7 1", "edge 1-2", "2 1", "25"),
    # at the turn the front moves out before and in after
    (SQUARE, BACK, "1", "7 1", "edge 1-2", "2 1", "25"),
    (SQUARE, BACK, "1", "7 1", "edge 0-3", None, None),
    (SQUARE, ON, "1", "7 1", "edge 1-2", None, None),
    # both runs of the edge (1, 1, z) are 1/6 away
    (CUBE, TWO_RUNS, "0", "1 1 1/2", "edge 2-6", "1 1 1/3", "1/36"),
    (CUBE, TWO_RUNS, "0", "2 1 1/6", "edge 2-6", "1 1 1/6", "1"),
    (CUBE, TWO_RUNS, "0", "1 1 2", "edge 2-6", "1 1 1", "1"),
    # the face x = 1: g = 2 z - 2/3 along it; nothing is nearer than straight across
    (CUBE, TWO_RUNS, "0", "3 1/2 0", "face 3", "1 1/2 1/3", "37/9"),
    (CUBE, STAND3, "1/2", "1/2 1/3 5", "face 1", "1/2 1/3 1", "16"),
    (CUBE, STAND3, "1/2", "1/2 -1 5", "face 1", "1/2 0 1", "17"),
    (CUBE, STAND3, "1/2", "1/2 1/2 1/2", "edge 0-1", "1/2 0 0", "1/2"),
    # the notch of the L, from (2, 0, 1) to (2, 4, 1): its facets x = 2 and z = 1 are not both still along (t, t, t)
    (L_PRISM, STAND3, "1/2", "0 1 1", "edge 4-10", "2 1 1", "4"),
    (L_PRISM, moves(3, (0, 4, shift("t", "t", "t"))), "3", "0 1 1", "edge 4-10", None, None),
    (L_PRISM, moves(3, (0, 4, shift("0", "t", "0"))), "3", "0 9 1", "edge 4-10", "2 4 1", "29"),
    # along z only the facet z = 1 moves: its notch is a contact at the end if it moves outward, at the start if inward
    (L_PRISM, moves(3, (0, 4, shift("0", "0", "t"))), "4", "0 1 1", "edge 4-10", "2 1 1", "4"),
    (L_PRISM, moves(3, (0, 4, shift("0", "0", "-t"))), "4", "0 1 1", "edge 4-10", None, None),
    (L_PRISM, moves(3, (0, 4, shift("0", "0", "-t"))), "0", "0 1 1", "edge 4-10", "2 1 1", "4"),
    (L_PRISM, moves(3, (0, 4, shift("0", "0", "t"))), "0", "0 1 1", "edge 4-10", None, None),
]


def table(checks, graze, tag, files, sites, world=False):
    d = len(sites[0][1])
    names = ["time"] + (["x", "y", "z"] if world else ["bx", "by", "bz"])[:d] + ["cell"]
    rows = [names] + [[str(t)] + [str(x) for x in y] + [cell] for t, y, cell in sites]
    contacts = graze.write(tag + ".csv", "".join(",".join(r) + "\n" for r in rows))
    out = graze.call("contact", *files, contacts, "--snap", "--quiet")
    if not checks.equal(out.returncode, 0, tag, out.stderr):
        return None
    return list(csv.DictReader(x for x in out.stdout.splitlines() if not x.startswith("#")))


def body(row, d):
    return tuple(F(row[k]) for k in ("bx", "by", "bz")[:d])


def check_missed(checks, row, y, cell, *where):
    checks.equal((body(row, len(y)), row["cell"], row["shift"]), (y, cell, ""), *where, "missed")
    checks.equal([row[k] for k in ANSWERS], [""] * len(ANSWERS), *where, "missed")


def check_hand(checks, graze):
    for number, (solid, motion, t, y, cell, want, square) in enumerate(HAND):
        suffix = ".off" if solid.startswith("OFF") else ".wkt"
        files = graze.write(f"hand{number}{suffix}", solid), graze.write(f"hand{number}.json", motion)
        y = tuple(F(x) for x in y.split())
        rows = table(checks, graze, f"hand{number}", files, [(t, y, cell)])
        where = "hand", number, cell
        if rows is None:
            continue
        if want is None:
            check_missed(checks, rows[0], y, cell, *where)
            continue
        checks.equal((body(rows[0], len(y)), rows[0]["shift"]), (tuple(F(x) for x in want.split()), square), *where)
        checks.holds(rows[0]["role"], *where)


# ---------------------------------------------------------------------------------- a second method

def solve(rows, point):
    """The foot of a point on {x : a x = b for all (a, b)}; None if that is empty."""
    basis = []
    for a, b in rows:
        a, b = list(a), F(b)
        for n, c in basis:
            k = dot(a, n) / dot(n, n)
            a, b = [x - k * z for x, z in zip(a, n)], b - k * c
        if any(a):
            basis.append((a, b))
        elif b:
            return None
    for n, c in basis:  # the normals are orthogonal
        k = (c - dot(n, point)) / dot(n, n)
        point = tuple(p + k * x for p, x in zip(point, n))
    return tuple(point)


def speeds(motion, t, side):
    """(side of t, slope, constant) of g, which is affine in y."""
    d = motion.dimension
    out = []
    for which, piece in oracle.pieces_beside(motion, t):
        def g(y):
            return -oracle.pullback(piece, side, motion.map(y, t), t, 1)[1]
        zero = g((F(0),) * d)
        out.append((which, [g(tuple(F(int(i == j)) for j in range(d))) - zero for i in range(d)], zero))
    return out


def line_through(p, q):
    """Equations of the line."""
    w = minus(q, p)
    if len(p) == 2:
        n = (-w[1], w[0])
        return [(n, dot(n, p))]
    k = next(i for i in range(3) if w[i])
    out = []
    for i in range(3):
        if i != k:
            n = [F(0)] * 3
            n[i], n[k] = w[k], -w[i]
            out.append((n, dot(n, p)))
    return out


def nearest(candidates, y, allowed):
    good = [(sum((a - b) ** 2 for a, b in zip(x, y)), x) for x in set(candidates) if x is not None and allowed(x)]
    return min(good) if good else None


def with_zeros(flats, zeros, y):
    for flat in flats:
        for n in range(min(len(zeros), 2) + 1):
            for some in itertools.combinations(zeros, n):
                yield solve(flat + list(some), y)


def of_facet(motion, side, t, y, borders):
    gs = speeds(motion, t, side)
    zeros = [(slope, -constant) for _, slope, constant in gs]
    plane = [(side.normal, side.offset)]

    def allowed(x):
        return bool(oracle.cells_at(side, x)) and all(-w * (dot(s, x) + c) >= 0 for w, s, c in gs)
    flats = [plane] + [line_through(p, q) for p, q in borders]
    return nearest(itertools.chain(with_zeros(flats, zeros, y), (p for b in borders for p in b)), y, allowed)


def of_edge(motion, pair, reflex, t, y, p, q):
    gs = [speeds(motion, t, s) for s in pair]
    zeros = [(slope, -constant) for one in gs for _, slope, constant in one]

    def allowed(x):
        if not 0 <= dot(minus(x, p), minus(q, p)) <= dot(minus(q, p), minus(q, p)):
            return False
        good = True
        for k, (which, _, _) in enumerate(gs[0]):
            holds = [-which * (dot(one[k][1], x) + one[k][2]) >= 0 for one in gs]
            good &= all(holds) if reflex else any(holds)
        return good
    return nearest(itertools.chain(with_zeros([line_through(p, q)], zeros, y), (p, q)), y, allowed)


def cells_of(solid, sides):
    """(name, what finds the nearest point of it)."""
    if isinstance(solid, Polygon):
        for s in sides:
            u, v = s.name[1:]
            yield f"edge {u}-{v}", lambda m, t, y, s=s, b=[(solid.vertices[u], solid.vertices[v])]: of_facet(m, s, t, y, b)
    else:
        edges = {}
        for k, f in enumerate(solid.facets):
            ring = list(zip(f, f[1:] + f[:1]))
            for u, v in ring:
                edges.setdefault((min(u, v), max(u, v)), []).append(k)
            borders = [(solid.vertices[u], solid.vertices[v]) for u, v in ring]
            yield f"face {k}", lambda m, t, y, s=sides[k], b=borders: of_facet(m, s, t, y, b)
        for (u, v), pair in edges.items():
            p, q = solid.vertices[u], solid.vertices[v]
            middle = tuple((a + b) / 2 for a, b in zip(p, q))
            if len(pair) != 2 or len(oracle.at_point(sides, middle)) != 2:
                continue
            reflex = oracle.Cone(solid, sides, middle).kind() == "reflex"
            pair = [sides[k] for k in pair]
            yield (f"edge {u}-{v}", lambda m, t, y, pair=pair, r=reflex, p=p, q=q: of_edge(m, pair, r, t, y, p, q))
    used = {x for e in solid.edges for x in e} if isinstance(solid, Polygon) else {x for f in solid.facets for x in f}
    for v in sorted(used):
        p = solid.vertices[v]

        def at_vertex(m, t, y, p=p):
            square = sum((a - b) ** 2 for a, b in zip(p, y))
            return (square, p) if oracle.role(solid, sides, m, t, p) == "contact" else None
        yield f"vertex {v}", at_vertex


def check_scene(checks, tally, graze, rng, name, solid, motion, count):
    sides = oracle.sides_of(solid)
    cells = list(cells_of(solid, sides))
    marks = [p.lo for p in motion.pieces] + [motion.end]
    chosen, found = [], []
    for cell, find in rng.sample(cells, min(count, len(cells))):
        piece = rng.choice(motion.pieces)
        t = piece.lo + (piece.hi - piece.lo) * F(rng.randint(1, 15), 16)
        t = rng.choice(marks) if rng.random() < 0.3 else t
        y = rng.choice(solid.cell_points(rng))[1]
        if rng.random() < 0.6:
            y = tuple(a + F(rng.randint(-8, 8), rng.randint(1, 5)) for a in y)
        chosen.append((t, tuple(F(x) for x in y), cell))
        found.append(find(motion, t, chosen[-1][1]))
    tag = name.replace(" ", "_")
    files = graze.write(tag + solid.suffix, solid.text()), graze.write(tag + ".json", motion.text())
    rows = table(checks, graze, tag, files, chosen)
    if rows is None or not checks.equal(len(rows), len(chosen), name):
        return
    for (t, y, cell), want, row in zip(chosen, found, rows):
        where = name, f"t={t}", [str(x) for x in y], cell
        kind = cell.split()[0]
        tally[(solid.dimension, kind, want is not None)] += 1
        if want is None:
            check_missed(checks, row, y, cell, *where)
            continue
        checks.equal((F(row["shift"]), body(row, len(y))), want, *where)
        # where no other facet is at the point, the program's own role is contact
        if row["cell"] == cell and len(oracle.at_point(sides, want[1])) == FACETS.get((solid.dimension, kind)):
            checks.equal(row["role"], "contact", *where)
            tally["roles"] += 1
    world = [(t, motion.map(y, t), cell) for t, y, cell in chosen]
    checks.equal(table(checks, graze, tag + "-world", files, world, True), rows, name, "by x, y, z")


def main():
    args = options(__doc__.split("\n\n")[0])
    checks, tally = Checks(), Counter()
    graze = Graze(args, checks)
    if args.derived:
        check_hand(checks, graze)
    for name, solid, motion in scenes(args):
        check_scene(checks, tally, graze, args.random, name, solid, motion, 12 if motion.dimension == 2 else 9)
    print({str(k): n for k, n in sorted(tally.items(), key=str)})
    kinds = {(2, "edge"), (2, "vertex"), (3, "face"), (3, "edge"), (3, "vertex")}
    checks.holds(all(tally[k + (b,)] >= 2 for k in kinds for b in (True, False)), "moved and missed", dict(tally))
    checks.finish()


if __name__ == "__main__":
    main()
