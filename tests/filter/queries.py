"""Query points for a scene, most of them degenerate or a hair's breadth from it.

SPDX-License-Identifier: GPL-3.0-or-later

A constructed point is M(t) y with y on the boundary and t rational (for unsweep M(t)^-1 y), so that
its trajectory is at y at the time t. Points are made in the scene's ordinary size and carried to
its place, which keeps every coincidence. Beside them: the rows of `graze generate`. Each point has
a kind, which goes with it through the program in a column of its own.
"""
from exact import Fraction as F, to_double

from points import degenerate, random_time

HAIRS = (30, 40, 52, 53, 60, 75, 90, 120)
NEAR = {"near", "miss", "hair", "rounded"}


def direction(rng, d):
    """A vector whose largest coordinate has size 1, along an axis every other time."""
    if rng.random() < 0.5:
        axis, side = rng.randrange(d), rng.choice((-1, 1))
        return [F(side * (k == axis)) for k in range(d)]
    out = [F(rng.randint(-8, 8), 8) for _ in range(d)]
    out[rng.randrange(d)] = F(1)
    return out


def shifted(point, rng):
    step = F(1, 2 ** rng.choice(HAIRS))
    return tuple(x + step * w for x, w in zip(point, direction(rng, len(point))))


class Maker:
    """Points of one scene. Everything is drawn from `rng`, so a seed gives the same points."""

    def __init__(self, scene, rng):
        self.scene, self.rng = scene, rng
        # a facet of the plane is an edge
        self.facet = "face" if scene.d == 3 else "edge"
        spots = scene.solid.cell_points(rng)
        self.spots = [y for _, y in spots]
        self.corners = [y for kind, y in spots if kind != self.facet]
        corners = [scene.motion.map(v, t) for v in scene.solid.vertices[:40]
                   for t in (scene.motion.start, scene.motion.end)]
        if scene.unsweep:
            corners = scene.solid.vertices
        # a solid of many decades is looked at where its small parts are
        self.low = [max(min(x), F(-10)) for x in zip(*corners)]
        self.high = [min(max(x), F(10)) for x in zip(*corners)]

    def constructed(self, spots, t):
        at = self.scene.motion.back if self.scene.unsweep else self.scene.motion.map
        return at(self.rng.choice(spots), t)

    def hard(self, count):
        """Through a vertex or an edge, or with a double zero of a facet's pullback; this last is
        made for sweeps alone."""
        motion, out = self.scene.motion, []
        if self.scene.unsweep:
            return [self.constructed(self.corners, random_time(motion, self.rng))
                    for _ in range(count)]
        while len(out) < count:
            some = degenerate(self.scene.solid, motion, self.rng, 2 * count)
            out += [p for kind, p in some if kind != self.facet]
        return out[:count]

    def ends(self, count):
        motion = self.scene.motion
        times = [motion.start, motion.end] + [p.lo for p in motion.pieces]
        return [self.constructed(self.spots, self.rng.choice(times)) for _ in range(count)]

    def long_ratios(self, count):
        """Contacts at times of forty digits."""
        out = []
        for _ in range(count):
            p = self.rng.choice(self.scene.motion.pieces)
            q = self.rng.randrange(10 ** 39, 10 ** 40)
            t = p.lo + (p.hi - p.lo) * F(self.rng.randrange(q), q)
            out.append(self.constructed(self.corners, t))
        return out

    def lattice(self, count):
        """Halves: where a CAD model has its corners, and its planes."""
        def one(a, b):
            return F(self.rng.randint(int(2 * a) - 1, int(2 * b) + 1), 2)
        return [tuple(map(one, self.low, self.high)) for _ in range(count)]

    def grid(self):
        """Flags of a grid on whole numbers or halves, about a hundred points; how many it has."""
        size = 11 if self.scene.d == 2 else 5
        low = [int(x) - self.rng.choice((F(1), F(1, 2))) for x in self.low]
        high = [x + size - 1 for x in low]
        box = ",".join(str(x) for x in low + high)
        return ["--grid", ",".join([str(size)] * self.scene.d), "--box", box], size ** self.scene.d

    def doubles(self, count):
        return [tuple(F(self.rng.uniform(to_double(a) - 1, to_double(b) + 1))
                      for a, b in zip(self.low, self.high)) for _ in range(count)]

    def rounded(self, points):
        """Constructed points as a program with doubles has them; out of range they stay exact."""
        out = []
        for p in points:
            try:
                out.append(tuple(F(to_double(x)) for x in p))
            except OverflowError:
                out.append(p)
        return out

    def points(self, count):
        """[(kind, point in the scene's place)], about `count`."""
        n = max(1, count // 20)
        carry = self.scene.carry
        near = self.hard(4 * n) + self.ends(n) + self.long_ratios(n)
        families = {"hard": self.hard(6 * n), "hair": [shifted(p, self.rng) for p in near],
                    "end": self.ends(2 * n), "ratio": self.long_ratios(n),
                    "lattice": self.lattice(2 * n), "random": self.doubles(n)}
        out = [(kind, carry(p)) for kind, points in families.items() for p in points]
        return out + [("rounded", p) for p in self.rounded(map(carry, self.hard(2 * n)))]


def written(d, points):
    """A CSV file of points with their kinds; a double that ends soon is written as a decimal."""
    rows = [",".join([*(token(x) for x in p), kind]) for kind, p in points]
    return "\n".join([",".join([*"xyz"[:d], "kind"])] + rows) + "\n"


def token(x):
    """A number as it is written; text stays as it is."""
    if isinstance(x, str):
        return x
    plain = repr(to_double(x)) if -1e15 < x < 1e15 else ""
    return plain if plain and F(plain) == x else str(x)


def generated(text, d):
    """[(stratum, coordinates as they stand)] of a table of `graze generate`."""
    lines = [line.split(",") for line in text.splitlines() if not line.startswith("#")]
    column = lines[0].index("stratum")
    return [(row[column], row[:d]) for row in lines[1:]]
