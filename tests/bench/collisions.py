"""First contacts of pairs of solids beside FCL's discrete test at 1,000 times, on the same meshes and motions; and first times at a
clearance of 1/128 beside FCL's distances at 1,000 times.

What each family's verdict must be follows from how it is made.
Both sides have loaded the meshes and built their trees before; FCL's time is that of all 1,000 tests.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import random
import statistics
from fractions import Fraction as F

from measure import Server
from scenes import TORUS_SIZES, torus, write_off

SIZES = (1000, 100000)
TIMES = 1000
PAIRS = 100
MEDIAN, WORST = 5, 15
NEAR_MEDIAN, NEAR_WORST = 3, 10
MEMORY = 300
NEAR = F(1, 10 ** 6)


def block(side):
    """[-1, 1]² × [-1/2, 1/2], each face cut into side² squares of two triangles."""
    index, facets = {}, []

    def at(*p):
        return index.setdefault(p, len(index))
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for end in (0, side):
            for i in range(side):
                for j in range(side):
                    square = []
                    for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        p = [0, 0, 0]
                        p[axis], p[u], p[v] = end, a, b
                        square.append(at(*p))
                    p, q, r, s = square if end else square[::-1]
                    facets += [(p, q, r), (p, r, s)]
    size = (2, 2, 1)
    return [tuple(size[k] * p[k] / side - size[k] / 2 for k in range(3)) for p in index], facets


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


# Unit vectors: the planes across them are those the motions stay in, and which the solids lie on either side of.
AXES = [(F(a, n), F(b, n), F(c, n)) for a, b, c, n in ((1, 2, 2, 3), (2, 3, 6, 7), (-1, 4, 8, 9), (4, -4, 7, 9), (6, 2, -9, 11), (3, 4, 12, 13))]


class Way:
    """Past the fixed solid across an axis, which no turn on the way leaves either; every other one turns."""

    def __init__(self, rng, axis):
        self.axis, self.turns = axis, rng.random() < 0.5
        along, up = cross(axis, rng.choice([(1, 0, 0), (0, 1, 0)])), F(rng.randint(-32, 32), 64)
        across = cross(axis, along)
        self.speed = [8 * (x + up * y) for x, y in zip(along, across)]
        self.tan_half = F(rng.randint(16, 64), 64)

    def text(self, middle, centre):
        """`centre` of the moving solid, about which it turns, is carried to `middle` at 1/2."""
        go = {"translate": [f"{m - c}+({v})*(t-1/2)" for m, c, v in zip(middle, centre, self.speed)]}
        turn = {"rotate": {"axis": list(map(str, self.axis)), "center": list(map(str, centre)), "tan_half": f"{self.tan_half}*t"}}
        return json.dumps({"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"compose": [turn, go]} if self.turns else go}]})


def ends(vertices):
    """The lowest and the highest vertex along each axis."""
    exact = [tuple(map(F, p)) for p in vertices]
    return {axis: [f(exact, key=lambda p, n=axis: dot(n, p)) for f in (min, max)] for axis in AXES}


def over(extremes, rng, axis, gap):
    """The lowest vertex passes the highest one of the same solid at a gap: a plane across the axis lies between."""
    low, high = extremes[axis]
    return Way(rng, axis).text([x + gap * n for x, n in zip(high, axis)], low)


def pass_by(extremes, rng):
    return over(extremes, rng, rng.choice(AXES), F(rng.randint(1, 16), 64))


def near_miss(extremes, rng):
    return over(extremes, rng, rng.choice(AXES), NEAR)


def collision(_, rng):
    """The circles inside the tubes would meet if the centres were one; these are less apart than a tube is thick."""
    return Way(rng, rng.choice(AXES)).text([F(rng.randint(-8, 8), 64) for _ in range(3)], (0, 0, 0))


def slide(_, rng):
    """One block upon the other, facet on facet."""
    return Way(rng, (F(0), F(0), F(1))).text((F(rng.randint(-16, 16), 64), F(rng.randint(-16, 16), 64), 1), (0, 0, 0))


# name -> mesh, whether they meet and come within 1/128, (its ends, random numbers) -> motion
FAMILIES = {"pass by": ("torus", (False, False), pass_by), "collision": ("torus", (True, True), collision),
            "near miss of 1e-6": ("torus", (False, True), near_miss), "slide": ("block", (True, True), slide)}


class Family:
    def __init__(self, bench, name, faces, extremes):
        self.name, self.faces = name, faces
        _, self.meets, self.make = FAMILIES[name]
        self.extremes, self.bench = extremes, bench
        self.graze, self.fcl, self.first, self.near, self.distances = [], [], [], [], []
        self.wrong, self.wrong_fcl = 0, 0

    def ask(self, graze, fcl, count):
        rng, path = random.Random(7), self.bench.path("pair.json")
        for _ in range(count):
            with open(path, "w", encoding="ascii") as file:
                file.write(self.make(self.extremes, rng))
            mine = graze.ask("first", path)
            self.graze.append(mine["seconds"])
            self.wrong += bool(mine["hit"]) != self.meets[0]
            near = graze.ask("near", path)
            self.near.append(near["seconds"])
            self.wrong += bool(near["hit"]) != self.meets[1]
            if fcl:
                self.distances.append(fcl.ask("distance", TIMES, path)["seconds"])
                every = fcl.ask("every", TIMES, path)
                self.fcl.append(every["seconds"])
                self.first.append(fcl.ask("discrete", TIMES, path)["seconds"])
                self.wrong_fcl += bool(every["hit"]) != self.meets[0]

    def rows(self):
        table, what = self.bench.table, f"{self.name}, {self.faces:,} faces"
        graze = statistics.median(self.graze)
        if not self.fcl:
            table.row(f"first contact, {what}, seconds a query", graze, unit=" s", graze=graze)
        else:
            ratios = [a / b for a, b in zip(self.graze, self.fcl)]
            peer = statistics.median(self.fcl)
            table.row(f"first contact, {what} ({len(ratios)} pairs), median", statistics.median(ratios), most=MEDIAN, graze=graze, peer=peer)
            table.row(f"first contact, {what}, worst", max(ratios), most=WORST, graze=max(self.graze), peer=max(self.fcl))
            ratios = [a / b for a, b in zip(self.near, self.distances)]
            table.row(f"first time within 1/128, {what}, median", statistics.median(ratios), most=NEAR_MEDIAN,
                      graze=statistics.median(self.near), peer=statistics.median(self.distances))
            table.row(f"first time within 1/128, {what}, worst", max(ratios), most=NEAR_WORST, graze=max(self.near), peer=max(self.distances))
            early = statistics.median(a / b for a, b in zip(self.graze, self.first))
            table.note(f"against FCL's tests up to its first hit: {early:.3g} times; FCL's verdicts wrong: {self.wrong_fcl} of {len(ratios)}")
        table.row(f"wrong verdicts, with a clearance and without, {what}", self.wrong, most=0, unit="")


def measure(bench):
    peer = os.path.join(bench.programs, "fcl")
    bench.table.head(f"First contacts of pairs, against FCL's discrete test, and with a clearance its distance, at {TIMES:,} times")
    if not os.path.exists(peer):
        bench.table.note("FCL is left out: libfcl-dev is not installed")
    count = 10 if bench.options.quick else PAIRS
    for size in (n for n in SIZES if n <= bench.options.largest):
        meshes = {"torus": torus(*TORUS_SIZES[size]), "block": block(round((size / 12) ** 0.5))}
        for kind, mesh in meshes.items():
            solid = bench.path("pair.off")
            write_off(solid, mesh)
            graze = Server(os.path.join(bench.programs, "pairs"), solid, solid)
            fcl = Server(peer, "mesh", solid, solid) if os.path.exists(peer) else None
            extremes = ends(mesh[0])
            for name in (n for n, family in FAMILIES.items() if family[0] == kind):
                family = Family(bench, name, len(mesh[1]), extremes)
                family.ask(graze, fcl, count)
                family.rows()
            used = graze.ask("memory")["bytes"] / (2 * len(mesh[1]))
            bench.table.row(f"memory a face beside the two solids, {kind}, {len(mesh[1]):,} faces", used, most=MEMORY if size == SIZES[-1] else None, unit=" B")
            for server in (graze, fcl):
                if server:
                    server.close()
