#!/usr/bin/env python3
# suite
"""A ball along a polyline: the sweep is a union of balls and capsules, decided by distances from segments in fractions (C94).

SPDX-License-Identifier: GPL-3.0-or-later

A point is `in`, `on` or `out` as its least squared distance from the segments is below, at or above the radius squared. Three of five
points lie exactly at that distance from one segment or corner, and of these two thirds are inside no other part. A scale of 35 makes 100,000 points.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

from scenes import Checks, Curved, Graze, Motion, ball, options  # noqa: E402
from exact import Fraction as F  # noqa: E402

SCENES, POINTS = 20, 150
# Rational orthonormal frames, by rows.
FRAMES = {2: [((1, 0), (0, 1)), ((F(3, 5), F(4, 5)), (F(-4, 5), F(3, 5))), ((F(5, 13), F(-12, 13)), (F(12, 13), F(5, 13)))],
          3: [((1, 0, 0), (0, 1, 0), (0, 0, 1)), ((F(1, 3), F(2, 3), F(2, 3)), (F(2, 3), F(1, 3), F(-2, 3)), (F(2, 3), F(-2, 3), F(1, 3))),
              ((F(2, 7), F(3, 7), F(6, 7)), (F(3, 7), F(-6, 7), F(2, 7)), (F(6, 7), F(2, 7), F(-3, 7)))]}
UNITS = [(F(1), F(0)), (F(0), F(1)), (F(3, 5), F(4, 5)), (F(-4, 5), F(3, 5)), (F(-1), F(0)), (F(8, 17), F(-15, 17))]


def plus(p, q, k=1):
    return tuple(a + k * b for a, b in zip(p, q))


def dot(p, q):
    return sum(a * b for a, b in zip(p, q))


def distance2(p, a, b):
    """The squared distance of p from the segment a b."""
    along, off = plus(b, a, -1), plus(p, a, -1)
    k = max(F(0), min(F(1), dot(off, along) / dot(along, along)))
    rest = plus(off, along, -k)
    return dot(rest, rest)


def some_path(rng, d):
    path = [tuple(F(rng.randint(-6, 6)) for _ in range(d))]
    frames = []
    for _ in range(rng.randint(2, 5)):
        frame = rng.choice(FRAMES[d])
        frame = rng.sample(frame, d)
        frames.append(frame)
        path.append(plus(path[-1], frame[0], rng.choice([-1, 1]) * F(rng.randint(2, 12), 2)))
    return path, frames


def some_point(rng, d, path, frames, radius):
    """Exactly at the radius from a segment, just beside that, or anywhere near."""
    kind = rng.choice(["on", "on", "on", "beside", "free"])
    k = rng.randrange(len(frames))
    foot = plus(path[k], plus(path[k + 1], path[k], -1), rng.choice([F(0), F(1), F(rng.randint(0, 8), 8)]))
    if kind == "free":
        return plus(foot, tuple(F(rng.randint(-20, 20), 8) for _ in range(d)))
    across = frames[k][1] if d == 2 else tuple(a * x + b * y for (a, b) in [rng.choice(UNITS)] for x, y in zip(*frames[k][1:]))
    off = radius * rng.choice([-1, 1])
    return plus(foot, across, off if kind == "on" else off * (1 + F(rng.choice([-1, 1]), 2 ** rng.randint(3, 60))))


def main():
    args = options(__doc__.splitlines()[0])
    checks, rng = Checks(), args.random
    graze = Graze(args, checks)
    seen = {"in": 0, "on": 0, "out": 0}
    for number in args.rounds(SCENES):
        d = rng.choice([2, 3])
        radius = F(rng.randint(1, 8), rng.choice([2, 3]))
        path, frames = some_path(rng, d)
        pieces = [(k, k + 1, {"translate": [f"{x}+({y - x})*(t-{k})" for x, y in zip(a, b)]})
                  for k, (a, b) in enumerate(zip(path, path[1:]))]
        points = [some_point(rng, d, path, frames, radius) for _ in range(POINTS)]
        answers = graze.classify(f"path {number}", Curved(d, ball((0,) * d, radius)), Motion(d, pieces), points) or []
        for p, answer in zip(points, answers):
            nearest = min(distance2(p, a, b) for a, b in zip(path, path[1:]))
            want = "in" if nearest < radius ** 2 else "on" if nearest == radius ** 2 else "out"
            seen[want] += 1
            checks.equal(answer.record["pmc"], want, number, path, radius, p)
    print(", ".join(f"{count} {pmc}" for pmc, count in seen.items()))
    checks.holds(3 * seen["on"] > sum(seen.values()), "a third of the points are `on`", seen)
    checks.finish()


if __name__ == "__main__":
    main()
