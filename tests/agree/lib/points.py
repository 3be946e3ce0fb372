"""Query points: random ones, and ones whose contacts are degenerate by construction.

SPDX-License-Identifier: GPL-3.0-or-later

A constructed point is P = M(t*) y with rational t* and y on the boundary of the solid: a vertex, a
point in an edge or a facet, or a point of a facet's plane where the facet's normal velocity is
zero at t* (g is affine along the facet, so it vanishes on a line of it). Its trajectory
is at y at t*.
"""
from exact import Fraction as F


def random_time(motion, rng):
    """A rational time inside a piece, or now and then a break point or an end."""
    if rng.random() < 0.2:
        return rng.choice([p.lo for p in motion.pieces] + [motion.end])
    p = rng.choice(motion.pieces)
    return p.lo + (p.hi - p.lo) * F(rng.randint(1, 23), 24)


def normal_velocity(motion, normal, y, t):
    """n . A^-1 (A' y + b') = -n . c'(t) for P = M(t) y ."""
    w = motion.velocity_back(motion.map(y, t), t)
    return -sum(n * x for n, x in zip(normal, w))


def still_point(motion, normal, corners, t, rng):
    """A point y of the facet's plane with zero normal velocity at t, or None. Along one side of
    the facet g is affine: two values give its zero; in space two sides give a line."""
    g = [normal_velocity(motion, normal, p, t) for p in corners]
    zeros = []
    for i in range(len(corners)):
        j = (i + 1) % len(corners)
        if g[i] != g[j]:
            s = g[i] / (g[i] - g[j])
            zeros.append(tuple(a + s * (b - a) for a, b in zip(corners[i], corners[j])))
    if not zeros:
        return corners[0] if g[0] == 0 else None
    if len(zeros) == 1 or zeros[0] == zeros[1]:
        return zeros[0]
    s = F(rng.randint(1, 7), 8)
    return tuple(a + s * (b - a) for a, b in zip(zeros[0], zeros[1]))


def degenerate(solid, motion, rng, count):
    """[(kind, point)]: kinds vertex, edge, face, still."""
    out = []
    spots = solid.cell_points(rng)
    lines = list(solid.lines())
    while len(out) < count:
        t = random_time(motion, rng)
        if rng.random() < 0.3:
            normal, corners = rng.choice(lines)
            kind, y = "still", still_point(motion, normal, corners, t, rng)
            if y is None:
                continue
        else:
            kind, y = rng.choice(spots)
        out.append((kind, motion.map(y, t)))
    return out


def scattered(solid, motion, rng, count):
    """[('random', point)]: a solid's point carried along, then displaced a little."""
    spots = [p for _, p in solid.cell_points(rng)]
    out = []
    for _ in range(count):
        p = motion.map(rng.choice(spots), random_time(motion, rng))
        out.append(("random", tuple(F(round(x * 8) + rng.randint(-8, 8), 8) for x in p)))
    return out


def mixed(solid, motion, rng, count):
    n = count // 3
    return scattered(solid, motion, rng, n) + degenerate(solid, motion, rng, count - n)
