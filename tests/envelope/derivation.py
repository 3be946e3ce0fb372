#!/usr/bin/env python3
# suite
"""`graze envelope --events` against the pullback: signs before and after every event, and none in between.

SPDX-License-Identifier: GPL-3.0-or-later

Between two events, and on a grid, g, theta and g_t are taken anew at rational times: g = -phi' and theta = phi'' are
derivatives of the pullback phi = n c - d along the trajectory of M(t) y; the sign of g_t where a slice ends is the way
in which that end moves along the edge. Each has the sign that the last event before and the next one after say.
"""
import os
import sys
from collections import Counter, defaultdict

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contact"))

import oracle  # noqa: E402
from exact import Fraction as F  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from reading import When, between, named, sign, summary, table  # noqa: E402
from scenes import scenes  # noqa: E402
from solids import Polygon, cross, minus  # noqa: E402

GRID, GAPS = 4, 16
SIGNS = {"+": 1, "-": -1, "0": 0, "": None}


class Series:
    """The events of one quantity, in order."""

    def __init__(self):
        self.events = []

    def sign_at(self, t, others=()):
        """The sign that the events beside t demand: None where nothing is demanded. `others`: times at which the
        quantity may end or begin, beyond which an event demands nothing."""
        low = max((e[0].high for s in others for e in s.events if e[0].compare(t) < 0), default=None)
        high = min((e[0].low for s in others for e in s.events if e[0].compare(t) > 0), default=None)
        before = [e for e in self.events if e[0].compare(t) < 0 and (low is None or e[0].compare(low) >= 0)]
        after = [e for e in self.events if e[0].compare(t) > 0 and (high is None or e[0].compare(high) <= 0)]
        claims = [before[-1][2]] if before else []
        claims += [after[0][1]] if after else []
        return claims


def pieces_of(solid, sides):
    """Edges by position, cut at the vertices in them: (p, q)."""
    if isinstance(solid, Polygon):
        lines = [(solid.vertices[u], solid.vertices[v]) for u, v in solid.edges]
    else:
        lines = [(solid.vertices[a], solid.vertices[b])
                 for f in solid.facets for a, b in zip(f, f[1:] + f[:1])]
    points = {tuple(solid.vertices[i]) for i in range(len(solid.vertices))}
    out = set()
    for p, q in lines:
        along = minus(q, p)
        inner = []
        for x in points:
            to = minus(x, p)
            flat = along[0] * to[1] == along[1] * to[0] if len(p) == 2 else not any(cross(along, to))
            s = sum(a * b for a, b in zip(along, to)) / F(sum(a * a for a in along))
            if flat and 0 <= s <= 1:
                inner.append((s, x))
        inner = [x for _, x in sorted(inner)]
        out |= {tuple(sorted(pair)) for pair in zip(inner, inner[1:])}
    return sorted(out)


class View:
    """Quantities of a scene at rational times."""

    def __init__(self, solid, motion):
        self.motion = motion
        self.sides = oracle.sides_of(solid)
        self.edges = []
        for p, q in pieces_of(solid, self.sides):
            middle = tuple((a + b) / 2 for a, b in zip(p, q))
            self.edges.append((oracle.lowest(self.sides, middle), p, q, oracle.at_point(self.sides, middle)))
        self.vertices = [(oracle.lowest(self.sides, p), p, oracle.at_point(self.sides, p))
                         for p in sorted({x for _, p, q, _ in self.edges for x in (p, q)})]

    def phi(self, side, t, y, n):
        piece = oracle.pieces_beside(self.motion, t)[0][1]
        return oracle.pullback(piece, side, self.motion.map(y, t), t, n)

    def g(self, side, t, y):
        return -self.phi(side, t, y, 1)[1]

    def end(self, side, t, p, q):
        """Where the slice ends on an edge, and how far along it; None."""
        a, b = self.g(side, t, p), self.g(side, t, q)
        if a * b >= 0:
            return None
        s = a / (a - b)
        return s, tuple(x + s * (y - x) for x, y in zip(p, q)), sign(a)


def corners(view, series, facets, p, q):
    """The series of g of the facets at the ends of an edge: where these change a slice may end."""
    keys = [("reach", name, oracle.lowest(view.sides, x)) for name in facets for x in (p, q)]
    return [series[key] for key in keys if key in series]


def check_series(checks, tally, series, key, t, found, others, *where):
    for claim in series[key].sign_at(t, others):
        if claim is not None:
            checks.equal(found, claim, *where, key, "at", str(t))
            tally[key[0], found] += 1


def check_time(checks, tally, view, series, seen, t, *where):
    """All quantities at a time at which no event is. `seen`: signs of quantities without events."""
    def check(key, found):
        if key in series:
            check_series(checks, tally, series, key, t, found, (), *where)
        else:
            piece = oracle.pieces_beside(view.motion, t)[0][1].lo
            checks.equal(seen.setdefault(key, found), found, *where, key, "has no event", str(t), str(piece))
    for name, p, facets in view.vertices:
        for side in facets:
            check(("reach", side.name, name), sign(view.g(side, t, p)))
    for name, p, q, facets in view.edges:
        if sum(n == name for n, *_ in view.edges) > 1:
            continue
        ends = {side.name: view.end(side, t, p, q) for side in facets}
        for side in facets:
            if ends[side.name]:
                key = ("cusp", side.name, name)
                found = sign(view.phi(side, t, ends[side.name][1], 2)[2])
                if key in series:
                    check_series(checks, tally, series, key, t, found, corners(view, series, [side.name], p, q), *where)
                tally["slice ends", found] += 1
        for first in facets:
            for second in facets:
                key = ("meet", second.name, name, first.name)
                if key in series and ends[first.name] and ends[second.name]:
                    check_series(checks, tally, series, key, t, sign(view.g(second, t, ends[first.name][1])),
                                 corners(view, series, [first.name, second.name], p, q), *where)


def check_gap(checks, tally, view, series, low, high, *where):
    """Between two times without event in between: theta keeps its sign, and the ends of slices their way."""
    for name, p, q, facets in view.edges:
        if sum(n == name for n, *_ in view.edges) > 1:
            continue
        for side in facets:
            a, b = view.end(side, low, p, q), view.end(side, high, p, q)
            checks.equal(bool(a), bool(b), *where, name, side.name, "the slice ends all along", str(low), str(high))
            if not a or not b:
                continue
            middle = view.end(side, (low + high) / 2, p, q)
            ways = {sign(middle[0] - a[0]), sign(b[0] - middle[0])}
            checks.equal(len(ways), 1, *where, name, side.name, "turns between", str(low), str(high))
            signs = {sign(view.phi(side, t, e[1], 2)[2]) for t, e in ((low, a), (high, b))}
            checks.equal(len(signs), 1, *where, name, side.name, "theta between", str(low), str(high))
            way = ways.pop() * a[2]
            key = ("turn", side.name, name)
            others = corners(view, series, [side.name], p, q)
            for claim in series[key].sign_at((low + high) / 2, others) if key in series else []:
                if claim is not None:
                    checks.equal(way, claim, *where, key, str(low), str(high))
                    tally["turn", way] += 1


def read_series(rows):
    series = defaultdict(Series)
    times = []
    for row in rows:
        when = When(row["time"])
        if not times or times[-1].text != when.text:
            times.append(when)
        facet = [named(x) for x in row["facet"].split(" and ")]
        key = (row["kind"], facet[0], named(row["cell"])) + tuple(facet[1:])
        series[key].events.append((when, SIGNS[row["before"]], SIGNS[row["after"]]))
    return dict(series), times


def times_between(motion, times):
    """Two times in each gap between events, breaks and ends."""
    marks = [When(str(p.lo)) for p in motion.pieces] + [When(str(motion.end))]
    marks += [t for t in times if t.text not in {m.text for m in marks}]
    rational = [m for m in marks if m.poly is None]
    for m in marks:
        for r in rational:
            if m is not r:
                m.compare(r.low)
    for k, a in enumerate(marks):
        for b in marks[k + 1:]:
            while not (a.high <= b.low or b.high <= a.low):
                a.narrow()
                b.narrow()
    marks.sort(key=lambda m: (m.low, m.high))
    out = []
    for a, b in zip(marks, marks[1:]):
        x = between(a, b)
        out.append((between(a, When(str(x))), between(When(str(x)), b)))
    return out


def run_scene(checks, tally, graze, rng, name, solid, motion):
    tag = name.replace(" ", "_")
    files = graze.write(tag + solid.suffix, solid.text()), graze.write(tag + ".json", motion.text())
    events = graze.write(tag + "-events.csv", "")
    done = graze.call("envelope", *files, "--events", events)
    if not checks.equal(done.returncode, 0, name, done.stderr):
        return
    rows = table(events)
    if not checks.holds(rows is not None, name, "the table is whole"):
        return
    counts = Counter(row["kind"] for row in rows)
    said = summary(done.stdout)["events"].split()
    checks.equal(int(said[0]), len(rows), name, "number of events")
    checks.equal({said[k]: int(said[k + 1]) for k in range(2, len(said), 3) if int(said[k + 1])}, dict(counts), name)
    tally.update({("events", k): n for k, n in counts.items()})
    tally["decomposable", summary(done.stdout)["decomposable"]] += 1
    series, times = read_series(rows)
    view = View(solid, motion)
    seen = {}
    gaps = times_between(motion, times)
    for low, high in rng.sample(gaps, min(GAPS, len(gaps))):
        check_time(checks, tally, view, series, seen, low, name)
        check_gap(checks, tally, view, series, low, high, name)
    for piece in motion.pieces:
        for k in range(1, GRID):
            t = piece.lo + (piece.hi - piece.lo) * F(k, GRID)
            if all(when.compare(t) for when in times):
                check_time(checks, tally, view, series, seen, t, name, "grid")


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    graze = Graze(args, checks)
    for name, solid, motion in scenes(args):
        run_scene(checks, tally, graze, args.random, name, solid, motion)
    for key, number in sorted(tally.items(), key=str):
        print(*key, number)
    for kind in ("reach", "cusp", "turn", "meet"):
        checks.holds(tally["events", kind] or not args.ample, "there are events of each kind", kind)
    checks.finish()


if __name__ == "__main__":
    main()
