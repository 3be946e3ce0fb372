#!/usr/bin/env python3
"""Contact points in double, trimmed by sampling: a candidate for `graze contact`, with numpy.

    python3 cases/candidates/contact_sampled.py SOLID MOTION GOLDEN N EPS > answers.csv

Reads time and body point of each row of a table of `graze contact` and answers role, trimmed and status beside them, for
`graze compare`. The role is by
the signs of n V, V by a central difference; the solid covers P at one of N + 1 evenly spread times if all points at EPS
from the trajectory there, along the axes, are in the solid by ray parity.
SPDX-License-Identifier: CC0-1.0
"""
import csv
import json
import re
import sys
from fractions import Fraction

import numpy as np

STEP = 1e-6  # of the difference


def read_solid(path):
    """Vertices, and facets as loops of corners: polygons in space, in the plane edges."""
    with open(path, encoding="ascii") as file:
        text = file.read()
    if text.startswith("POLYGON"):
        rings = [[tuple(float(Fraction(x)) for x in p.split()) for p in r.split(",")] for r in re.findall(r"\(([^()]+)\)", text)]
        area = lambda r: sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(r, r[1:]))
        rings = [r if (area(r) > 0) == (k == 0) else r[::-1] for k, r in enumerate(rings)]
        return [np.array([a, b]) for r in rings for a, b in zip(r, r[1:])]
    words = " ".join(line.split("#")[0] for line in text.splitlines()).split()[1:]
    count, faces, at = int(words[0]), int(words[1]), 3
    vertices = np.array(words[at:at + 3 * count], dtype=float).reshape(count, 3)
    at, out = at + 3 * count, []
    for _ in range(faces):
        n = int(words[at])
        out.append(vertices[[int(w) for w in words[at + 1:at + 1 + n]]])
        at += n + 1
    return out


def number(text, t):
    return float(eval(text.replace("^", "**"), {"__builtins__": {}}, {"t": t}))  # the scenes' own expressions


def matrix_of(transform, d, t, part):
    """d rows of d + 1 numbers and the last row, of a transform as the scenes here have them."""
    m = np.eye(d + 1)
    if "compose" in transform:
        for one in transform["compose"]:
            m = matrix_of(one, d, t, part) @ m
    elif "translate" in transform:
        m[:d, d] = [number(x, t) for x in transform["translate"]]
    elif "matrix" in transform:
        m[:d] = [[number(x, t) for x in row] for row in transform["matrix"]]
    else:
        turn = transform["turn"]
        c, s = (1 - part * part) / (1 + part * part), 2 * part / (1 + part * part)
        m[:2, :2] = [[c, -s], [s, c]]
        center = np.array([float(x) for x in turn["center"]])
        m[:d, d] = center - m[:d, :d] @ center
    return m


class Motion:
    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            text = json.load(file)
        self.d = text["dimension"]
        self.pieces = [(*map(float, p["t"]), p["transform"]) for p in text["pieces"]]
        self.start, self.end = self.pieces[0][0], self.pieces[-1][1]

    def at(self, t):
        low, high, transform = next((p for p in self.pieces if t <= p[1]), self.pieces[-1])
        return matrix_of(transform, self.d, t, (t - low) / (high - low))


def normal_of(loop):
    if loop.shape[1] == 2:
        e = loop[1] - loop[0]
        n = np.array([e[1], -e[0]])
    else:
        n = sum(np.cross(a - loop[0], b - loop[0]) for a, b in zip(loop[1:], loop[2:]))
    return n / np.linalg.norm(n)


def parity(loops, points):
    """Is each point inside? A ray along the last axis crosses the fans of the facets an odd number of times."""
    inside = np.zeros(len(points), dtype=bool)
    x = points[:, :-1]
    for loop in loops:
        if x.shape[1] == 1:
            a, b = loop
            hit = (a[0] <= x[:, 0]) != (b[0] <= x[:, 0])
            with np.errstate(all="ignore"):
                inside ^= hit & (a[1] + (x[:, 0] - a[0]) / (b[0] - a[0]) * (b[1] - a[1]) > points[:, 1])
            continue
        n, flat = normal_of(loop), loop[:, :2]
        if n[2] == 0:
            continue
        hit = np.zeros(len(points), dtype=bool)
        for a, b in zip(flat, np.roll(flat, -1, axis=0)):
            with np.errstate(all="ignore"):
                hit ^= ((a[1] <= x[:, 1]) != (b[1] <= x[:, 1])) & (a[0] + (x[:, 1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) > x[:, 0])
        height = loop[0][2] - ((x - flat[0]) @ n[:2]) / n[2]
        inside ^= hit & (height > points[:, 2])
    return inside


def states(loops, points, eps):
    """I, O, or B within eps of the boundary, as far as the axes tell."""
    d = points.shape[1]
    around = np.array([parity(loops, points + s * eps * np.eye(d)[k]) for k in range(d) for s in (-1, 1)])
    return np.where(around.all(axis=0), "I", np.where(around.any(axis=0), "B", "O"))


def role(loops, motion, t, y, eps):
    """By facets whose planes, and whose boxes, contain y within eps; as at a convex place."""
    low, high = max(t - STEP, motion.start), min(t + STEP, motion.end)
    here = np.append(y, 1.0)
    v = ((motion.at(high) - motion.at(low)) @ here / (high - low))[:-1]
    w = np.linalg.solve(motion.at(t)[:-1, :-1], v)
    near = [f for f in loops if abs((y - f[0]) @ normal_of(f)) <= eps
            and np.all(y >= f.min(axis=0) - eps) and np.all(y <= f.max(axis=0) + eps)]
    g = np.array([normal_of(f) @ w for f in near])
    tolerance = 1e3 * STEP
    if len(g) == 0:
        return "hidden"
    out, in_ = (g > tolerance).all(), (g < -tolerance).all()
    if out and t < motion.end:
        return "egress"
    if in_ and t > motion.start:
        return "ingress"
    return "contact"


def status(found, times, t):
    step = times[1] - times[0]
    beside = np.abs(times - t) <= 1.5 * step
    if (found == "I").any():
        return "trimmed_near" if (found[beside] == "I").any() else "trimmed_far"
    apart = np.abs(times - t) > 0.5 * step
    if (found[beside & apart] == "B").any():
        return "slides"
    return "meets" if (found[apart] == "B").any() else "simple"


def main():
    solid, motion, golden, n, eps = sys.argv[1:]
    loops, motion, eps = read_solid(solid), Motion(motion), float(eps)
    times = np.linspace(motion.start, motion.end, int(n) + 1)
    inverse = np.array([np.linalg.inv(motion.at(t)) for t in times])
    out = csv.writer(sys.stdout, lineterminator="\n")
    names = ["time", "bx", "by", "bz"][:motion.d + 1]
    out.writerow(names + ["role", "trimmed", "status"])
    with open(golden, encoding="ascii") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            t = float(Fraction(row["time"]))
            y = np.array([float(Fraction(row[k])) for k in names[1:]])
            there = (inverse @ (motion.at(t) @ np.append(y, 1.0)))[:, :-1]
            told = status(states(loops, there, eps), times, t)
            out.writerow([row[k] for k in names] + [role(loops, motion, t, y, eps), "yes" if told.startswith("trimmed") else "no", told])


if __name__ == "__main__":
    main()
