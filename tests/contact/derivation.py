#!/usr/bin/env python3
# suite
"""`graze contact` against the pullback: values, orders, states, roles, nearest times of random sites.

SPDX-License-Identifier: GPL-3.0-or-later

Sites lie in faces, edges and vertices of the scenes of the agreement tests, at the ends and breaks of the motion and
between them; many are solved for g = 0. oracle.py says how each value is found a second time. The orientation is that of explicit tangent
vectors: the contact set's facet of y and t, mapped by M.
"""
import csv
import json
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import oracle  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from program import Checks, Graze, cell_set, options  # noqa: E402
from scenes import scenes  # noqa: E402
from solids import Polygon, cross, minus  # noqa: E402
from times import check_canonical, time_is  # noqa: E402
from tracer import dot, trace  # noqa: E402

PLANE_SITES, SPACE_SITES = 24, 10


def on_segment(p, q, s):
    return tuple(a + s * (b - a) for a, b in zip(p, q))


def g_of(motion, side, t, y):
    piece = oracle.pieces_beside(motion, t)[0][1]
    return -oracle.pullback(piece, side, motion.map(y, t), t, 1)[1]


def zero_on(motion, side, t, p, q):
    """Where g vanishes between p and q, strictly; None if nowhere or everywhere."""
    a, b = g_of(motion, side, t, p), g_of(motion, side, t, q)
    return on_segment(p, q, a / (a - b)) if a * b < 0 else None


def slice_point(rng, solid, motion, sides, t):
    """A point of a facet's plane with g = 0; perhaps off the facet."""
    k = rng.randrange(len(sides))
    if isinstance(solid, Polygon):
        _, u, v = sides[k].name
        return zero_on(motion, sides[k], t, solid.vertices[u], solid.vertices[v])
    corners = [solid.vertices[i] for i in solid.facets[k]]
    ends = [zero_on(motion, sides[k], t, p, q) for p, q in zip(corners, corners[1:] + corners[:1])]
    ends = [e for e in ends if e is not None]
    if len(ends) < 2:
        return None
    return on_segment(ends[0], ends[1], rng.choice([F(0), F(1, 2), F(1, 3), F(1)]))


def sites(rng, solid, motion, sides, count):
    marks = [p.lo for p in motion.pieces] + [motion.end]
    out, tries = [], 0
    while len(out) < count and tries < 20 * count:
        tries += 1
        piece = rng.choice(motion.pieces)
        t = piece.lo + (piece.hi - piece.lo) * F(rng.randint(1, 31), 32)
        if rng.random() < 0.3:
            t = rng.choice(marks)
        if rng.random() < 0.5:
            y = slice_point(rng, solid, motion, sides, t)
        else:
            y = rng.choice(solid.cell_points(rng))[1]
        if y is not None and oracle.at_point(sides, y):
            out.append((t, y))
    return out


def orientation(motion, side, t, y):
    """Orientation of (y, t) -> M(t) y on the facet's contact set, in coordinates of the facet and by its outward normals."""
    piece = oracle.pieces_beside(motion, t)[0][1]
    point = motion.map(y, t)
    c = oracle.path(piece, point, t, 2)
    w = tuple(x[1] for x in c)

    def g(at, when):
        x = oracle.path(piece, motion.map(at, when), when, 1)
        return -dot(side.normal, [a[1] for a in x])

    d = len(y)
    if d == 2:
        frame = [(-side.normal[1], side.normal[0])]
    else:
        a = next(a for a in ((1, 0, 0), (0, 1, 0)) if any(cross(side.normal, a)))
        frame = [cross(side.normal, a)]
        frame.append(cross(side.normal, frame[0]))
    slopes = [g(tuple(p + q for p, q in zip(y, f)), t) - g(y, t) for f in frame]
    # g_t by the identity phi'' = -(g_t + slope of g along w), all three of the pullback
    theta = 2 * oracle.pullback(piece, side, point, t, 2)[2]
    rise = g(tuple(p + q for p, q in zip(y, w)), t) - g(y, t)
    g_t = -theta - rise
    if not theta or not g_t:
        return g_t, theta, "degenerate"
    # Tangent vectors of the contact set: (f, -slope f / g_t); mapped and pulled back by A: f - w dt.
    images = []
    for f, slope in zip(frame, slopes):
        dt = -slope / g_t
        images.append(tuple(a - b * dt for a, b in zip(f, w)))
    # The image of the facet's plane at P has the same tangents: normal components vanish where g = 0.
    flat = [[dot(i, f) for f in frame] for i in images]
    base = [[dot(i, f) for f in frame] for i in frame]

    def det(m):
        return m[0][0] if len(m) == 1 else m[0][0] * m[1][1] - m[0][1] * m[1][0]
    sign = det(flat) * det(base)
    unit = [tuple(F(int(i == j)) for j in range(d)) for i in range(d)]
    origin = motion.map((F(0),) * d, t)
    columns = [minus(motion.map(u, t), origin) for u in unit]
    turn = det(columns) if d == 2 else dot(columns[0], cross(columns[1], columns[2]))
    sign *= turn
    return g_t, theta, "preserving" if sign > 0 else "reversing" if sign < 0 else "degenerate"


def check_facets(checks, record, solid, motion, sides, t, y, *where):
    """Values of each facet and side; returns {side of t: signs}."""
    point = motion.map(y, t)
    here = oracle.at_point(sides, y)
    want = {}
    for which, piece in oracle.pieces_beside(motion, t):
        for s in here:
            phi = oracle.pullback(piece, s, point, t, 2)
            order, sign = oracle.order_and_sign(piece, s, point, t, which)
            want[(s.name, which)] = (-phi[1], 2 * phi[2], order, sign)
    got = {}
    for f in record["facets"]:
        name, = cell_set([f["facet"]])
        which = {"+": 1, "-": -1}[f["side"]]
        order = None if f["order"] == "inf" else f["order"]
        got[(name, which)] = (F(f["speed"]), F(f["theta"]), order, {"+": 1, "0": 0, "-": -1}[f["sign"]])
    checks.equal(got, want, *where, "facets")


def check_site(checks, tally, record, row, solid, motion, sides, t, y, *where):
    point = motion.map(y, t)
    word, contacts = trace(solid, motion, point)
    found = oracle.states_beside(contacts, t)
    k, left, right, instant = found
    checks.equal([F(x) for x in record["body"]], list(y), *where, "body")
    checks.equal([F(x) for x in record["point"]], list(point), *where, "point")
    checks.equal(cell_set([record["cell"]]), {oracle.lowest(sides, y)}, *where, "cell")
    check_facets(checks, record, solid, motion, sides, t, y, *where)
    checks.equal((record["word"], record["left"], record["right"]), (word, left, right), *where, "word")
    checks.equal(record["trimmed"], "yes" if "I" in word else "no", *where, "trimmed")
    checks.equal(record["status"], oracle.trimming(word, contacts, k, instant, (left, right)), *where)
    for name, inside in (("near", False), ("near_in", True)):
        want = oracle.nearest(oracle.intervals(word, contacts, motion, inside), t)
        if want is None or record[name] is None:
            checks.equal(record[name], None if want is None else to_double(want), *where, name)
            continue
        checks.holds(time_is(record[name], want), *where, name, record[name], to_double(want))
        check_canonical(checks, record[name], *where, name)
        checks.equal(row[name], text_of(record[name]), *where, name)
    want = oracle.role(solid, sides, motion, t, y)
    checks.equal(record["role"], want, *where, "role")
    tally[(record["role"], record["status"], next(iter(record["cell"])))] += 1
    check_slice(checks, tally, record, solid, motion, sides, t, y, *where)
    checks.equal([row[n] for n in ("role", "status", "word", "trimmed")],
                 [record[n] for n in ("role", "status", "word", "trimmed")], *where, "row")
    checks.equal([row["left"], row["right"]], [record["left"] or "", record["right"] or ""], *where, "row")


def text_of(time):
    if isinstance(time, str):
        return time
    return f"root({' '.join(time['poly'])};{time['lo']};{time['hi']})"


def check_slice(checks, tally, record, solid, motion, sides, t, y, *where):
    here = oracle.at_point(sides, y)
    beside = oracle.pieces_beside(motion, t)
    want = (None, None, None)
    is_break = len({id(p) for _, p in beside}) > 1
    if len({s.normal for s in here}) == 1 and not is_break and g_of(motion, here[0], t, y) == 0:
        g_t, theta, turn = orientation(motion, here[0], t, y)
        order, _ = oracle.order_and_sign(beside[0][1], here[0], motion.map(y, t), t, 1)
        want = ("+" if theta > 0 else "-" if theta < 0 else "0", "inf" if order is None else order, turn)
        tally[("slice",) + want] += 1
        checks.equal({F(f["drift"]) for f in record["facets"]}, {g_t}, *where, "g_t")
    checks.equal((record["theta"], record["contact_order"], record["orientation"]), want, *where, "slice")


def run_scene(checks, tally, graze, rng, name, solid, motion, count):
    sides = oracle.sides_of(solid)
    chosen = sites(rng, solid, motion, sides, count)
    tag = name.replace(" ", "_")
    files = graze.write(tag + solid.suffix, solid.text()), graze.write(tag + ".json", motion.text())
    names = ["time", "bx", "by", "bz"][:1 + solid.dimension]
    rows = [names] + [[str(x) for x in (t,) + tuple(y)] for t, y in chosen]
    contacts = graze.write(tag + ".csv", "".join(",".join(r) + "\n" for r in rows))
    lines = graze.call("contact", *files, contacts, "--format", "jsonl", "--quiet")
    table = graze.call("contact", *files, contacts, "--quiet")
    if not checks.equal((lines.returncode, table.returncode), (0, 0), name, lines.stderr, table.stderr):
        return
    records = [json.loads(line) for line in lines.stdout.splitlines()]
    answers = list(csv.DictReader(x for x in table.stdout.splitlines() if not x.startswith("#")))
    checks.equal((len(records), len(answers)), (len(chosen),) * 2, name, "rows")
    for (t, y), record, row in zip(chosen, records, answers):
        check_site(checks, tally, record, row, solid, motion, sides, t, y, name, f"t={t}", [str(x) for x in y])
    # the same rows by where the points are in the world
    world = [["time", "x", "y", "z"][:1 + solid.dimension]] + [[str(x) for x in (t,) + motion.map(y, t)] for t, y in chosen]
    again = graze.write(tag + "-world.csv", "".join(",".join(r) + "\n" for r in world))
    checks.equal(graze.call("contact", *files, again, "--quiet").stdout, table.stdout, name, "by x, y, z")


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    graze = Graze(args, checks)
    for name, solid, motion in scenes(args):
        count = PLANE_SITES if motion.dimension == 2 else SPACE_SITES
        run_scene(checks, tally, graze, args.random, name, solid, motion, count)
    for key, number in sorted(tally.items(), key=str):
        print(*key, number)
    roles = {key[0] for key in tally}
    checks.holds({"contact", "egress", "ingress", "hidden", "slice"} <= roles, "every role occurs", roles)
    checks.finish()


if __name__ == "__main__":
    main()
