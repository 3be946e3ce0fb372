"""Evaluates motion files of the forms that `graze motion` writes, in fractions.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re

from exact import Fraction as F


def value(text, t, s):
    """An expression of numbers, + - * /, parentheses, t and s."""
    if re.fullmatch(r"[-+*/() ts0-9]*", text) is None:
        raise ValueError(text)
    return F(eval(re.sub(r"(\*\*)?(\d+)", lambda m: m[0] if m[1] else f"F({m[2]})", text), {"F": F, "t": t, "s": s}))


def multiply(a, b):
    """Product of two square matrices."""
    return [[sum(a[i][k] * b[k][j] for k in range(len(b))) for j in range(len(b[0]))]
            for i in range(len(a))]


def apply(matrix, point):
    """The image of a point under d rows of d + 1."""
    return [sum(a * x for a, x in zip(row, point)) + row[-1] for row in matrix]


def after(second, first):
    """The affine map `second` after `first`."""
    d = len(first)
    columns = [[row[j] for row in first] for j in range(d + 1)]
    linear = [[sum(row[k] * column[k] for k in range(d)) for column in columns] for row in second]
    return [[x + (row[-1] if j == d else 0) for j, x in enumerate(line)]
            for line, row in zip(linear, second)]


def rotation_of(q):
    """The rotation of a quaternion w, x, y, z of any length: v -> q v q^-1 by products."""
    def times(a, b):
        w, x, y, z = a
        i, j, k, l = b
        return [w * i - x * j - y * k - z * l, w * j + x * i + y * l - z * k,
                w * k - x * l + y * i + z * j, w * l + x * k - y * j + z * i]
    size = sum(x * x for x in q)
    back = [q[0], -q[1], -q[2], -q[3]]
    images = [times(times(q, [0] + [int(i == j) for i in range(3)]), back)[1:] for j in range(3)]
    return [[images[j][i] / size for j in range(3)] for i in range(3)]


def about(linear, center):
    return [row + [c - sum(a * x for a, x in zip(row, center))] for row, c in zip(linear, center)]


def root(square):
    """The root of a rational square."""
    found = F(math.isqrt(square.numerator), math.isqrt(square.denominator))
    if found * found != square:
        raise ValueError(f"{square} is no square")
    return found


def turned(half, axis, center, d):
    """The rotation whose half angle is that of the complex number half = (re, im)."""
    re_, im = half
    if d == 2:
        size = re_ * re_ + im * im
        c, s = (re_ * re_ - im * im) / size, 2 * re_ * im / size
        return about([[c, -s], [s, c]], center)
    length = root(sum(x * x for x in axis))
    return about(rotation_of([re_ * length] + [im * x for x in axis]), center)


def power(re_, im, n):
    out = (F(1), F(0))
    for _ in range(abs(n)):
        out = (out[0] * re_ - out[1] * im, out[0] * im + out[1] * re_)
    return out if n >= 0 else (out[0], -out[1])


def fraction_of(text, t, s):
    """An expression as (denominator, numerator), so that a tangent may be infinite."""
    parts = re.fullmatch(r"(\(.*\*s\))/(\(.*\*s\))", text)
    if parts:
        return value(parts[2], t, s), value(parts[1], t, s)
    return F(1), value(text, t, s)


class Motion:
    def __init__(self, text):
        self.dimension = text["dimension"]
        self.pieces = text["pieces"]

    def at(self, t):
        piece = next(p for p in self.pieces if F(p["t"][0]) <= t <= F(p["t"][1]))
        low, high = (F(x) for x in piece["t"])
        return self.transform(piece["transform"], t, (t - low) / (high - low))

    def transform(self, what, t, s):
        d = self.dimension
        (kind,) = [k for k in what if k != "center"]
        given = what[kind]
        if kind == "compose":
            out = self.transform(given[0], t, s)
            for one in given[1:]:
                out = after(self.transform(one, t, s), out)
            return out
        if kind == "translate":
            return [[F(i == j) for j in range(d)] + [value(x, t, s)] for i, x in enumerate(given)]
        if kind == "matrix":
            return [[value(x, t, s) for x in row] for row in given]
        if kind == "quaternion":
            center = [value(x, t, s) for x in what.get("center", ["0"] * 3)]
            return about(rotation_of([value(x, t, s) for x in given]), center)
        center = [F(x) for x in given.get("center", ["0"] * d)]
        axis = [F(x) for x in given["axis"]] if d == 3 else None
        if kind == "turn":
            v = abs(given["quarters"]) * s
            re_, im = power(F(1), F(1), v.numerator // v.denominator)
            rest = v - v.numerator // v.denominator
            half = (re_ - im * rest, im + re_ * rest)
            return turned((half[0], half[1] if given["quarters"] > 0 else -half[1]), axis, center, d)
        if kind != "rotate":
            raise ValueError(kind)
        along, across = fraction_of(given["tan_half"], t, s)
        return turned(power(along, across, given.get("times", 1)), axis, center, d)
