"""Curved solids (.csg.json) and motions of their cases, read for curvedtrace.py by readers of its own.

SPDX-License-Identifier: GPL-3.0-or-later

A solid is a list of polynomials, {powers: coefficient}, and a tree over their numbers: a number (that polynomial is
negative), or (how, parts), how being all, any or not. A motion is a list of Pieces (tests/agree/lib/motion.py).
"""
import json
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from algebra import add, common, mul, scale  # noqa: E402
from exact import Fraction as F  # noqa: E402
from motion import Piece, divided  # noqa: E402


class Ratio:
    """A ratio of two polynomials in t of integers, in lowest terms."""

    def __init__(self, top, bottom=(1,)):
        g = common(top, bottom) if top else list(bottom)
        self.top, self.bottom = (divided(list(p), g) if len(g) > 1 else list(p) for p in (top, bottom))

    def __add__(self, other):
        return Ratio(add(mul(self.top, other.bottom), mul(other.top, self.bottom)), mul(self.bottom, other.bottom))

    def __neg__(self):
        return Ratio(scale(self.top, -1), self.bottom)

    def __sub__(self, other):
        return self + -other

    def __mul__(self, other):
        return Ratio(mul(self.top, other.top), mul(self.bottom, other.bottom))

    def __truediv__(self, other):
        return Ratio(mul(self.top, other.bottom), mul(self.bottom, other.top))

    def __pow__(self, n):
        return self * self ** (n - 1) if n > 1 else self


def constant(x):
    x = F(x)
    return Ratio([x.numerator] if x else [], [x.denominator])


def expression(text):
    """An expression in t; its letters are checked, so that eval sees arithmetic alone."""
    if not re.fullmatch(r"[-+*/^()t0-9. ]*", text):
        raise ValueError(f"{text}: recompute.py reads expressions in t of curved cases")
    code = re.sub(r"(\^?)(\d+(?:\.\d+)?)", lambda m: f"**{m[2]}" if m[1] else f"N('{m[2]}')", text)
    return eval(code, {"N": constant, "t": Ratio([0, 1])})  # pylint: disable=eval-used


def total(ratios):
    out = constant(0)
    for x in ratios:
        out = out + x
    return out


def product(a, b):
    return [[total(x * b[k][j] for k, x in enumerate(row)) for j in range(len(b))] for row in a]


def unit(n):
    return [[constant(i == j) for j in range(n)] for i in range(n)]


def turned(w, x, y, z):
    """The rotation of a quaternion of any length."""
    two, n = constant(2), w * w + x * x + y * y + z * z
    rows = [[w * w + x * x - y * y - z * z, two * (x * y - w * z), two * (x * z + w * y)],
            [two * (x * y + w * z), w * w - x * x + y * y - z * z, two * (y * z - w * x)],
            [two * (x * z - w * y), two * (y * z + w * x), w * w - x * x - y * y + z * z]]
    return [[e / n for e in row] for row in rows]


def transform(what, d):
    """The matrix of size d + 1 of a transform, of those that curved cases have."""
    (name, value), = what.items()
    out = unit(d + 1)
    if name == "compose":
        for part in value:
            out = product(transform(part, d), out)
    elif name == "translate":
        for i in range(d):
            out[i][d] = expression(value[i])
    elif name == "scale":
        for i in range(d):
            out[i][i] = expression(value)
    elif name == "quaternion":
        for i, row in enumerate(turned(*map(expression, value))):
            out[i][:3] = row
    elif name == "rotate" and sorted(value["axis"]) == ["0", "0", "1"] and len(value) == 2:
        half = expression(value["tan_half"])
        for i, row in enumerate(turned(constant(1), *(constant(x) * half for x in value["axis"]))):
            out[i][:3] = row
    else:
        raise ValueError(f"recompute.py does not know this {name} of curved cases")
    return out


def piece(lo, hi, matrix, d):
    w = [1]
    for row in matrix:
        for x in row:
            w = mul(w, divided(x.bottom, common(w, x.bottom)))
    whole = [[mul(x.top, divided(w, x.bottom)) for x in row] for row in matrix[:d]]
    return Piece(F(lo), F(hi), [row[:d] for row in whole], [row[d] for row in whole], w)


def motion_of(path):
    with open(path, encoding="utf-8") as file:
        document = json.load(file, parse_int=str, parse_float=str)
    d = int(document["dimension"])
    return [piece(*p["t"], transform(p["transform"], d), d) for p in document["pieces"]]


class Solid:
    """The polynomials and the tree of a file."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            document = json.load(file, parse_int=str, parse_float=str)
        self.d, self.polynomials = int(document["dimension"]), []
        self.tree = self.node(document["solid"])

    def sign(self, *terms):
        """The number of a sum of (factor, polynomial, polynomial)."""
        out = {}
        for factor, p, q in terms:
            for a, x in p.items():
                for b, y in q.items():
                    key = tuple(i + j for i, j in zip(a, b))
                    out[key] = out.get(key, 0) + factor * x * y
        self.polynomials.append({k: v for k, v in out.items() if v})
        return len(self.polynomials) - 1

    def linear(self, normal, offset):
        out = {tuple(int(i == j) for j in range(self.d)): F(n) for i, n in enumerate(normal)}
        out[(0,) * self.d] = -F(offset)
        return out

    def node(self, node):
        (name, value), = ((k, v) for k, v in node.items() if k != "name")
        if name in ("union", "intersection"):
            return "any" if name == "union" else "all", [self.node(n) for n in value]
        if name == "difference":
            first, *rest = map(self.node, value)
            return "all", [first, *(("not", [n]) for n in rest)]
        return getattr(self, "read_" + name)(value)

    def numbers(self, value, name):
        return [F(x) for x in value.get(name, ["0"] * self.d)]

    def one(self):
        return {(0,) * self.d: F(1)}

    def side(self, normal, offset):
        return self.sign((1, self.linear(normal, offset), self.one()))

    def read_box(self, value):
        parts = []
        for i, (low, high) in enumerate(zip(value["low"], value["high"])):
            e = [int(i == j) for j in range(self.d)]
            parts += [self.side(e, high), self.side([-x for x in e], -F(low))]
        return "all", parts

    def about(self, p):
        """The coordinates less those of a point, with their squares' sum as terms."""
        rows = [self.linear([int(i == j) for j in range(self.d)], x) for i, x in enumerate(p)]
        return [(1, q, q) for q in rows]

    def round(self, p, radius):
        return self.sign(*self.about(p), (-F(radius) ** 2, self.one(), self.one()))

    def read_ball(self, value):
        return self.round(self.numbers(value, "center"), value["radius"])

    def read_ellipsoid(self, value):
        squares = self.about(self.numbers(value, "center"))
        return self.sign(*((1 / F(a) ** 2, p, q) for a, (_, p, q) in zip(value["semiaxes"], squares)), (-1, self.one(), self.one()))

    def shaft(self, value, radius2, slope2):
        """Terms of distance^2 from the axis less radius2 and slope2 height^2; the axis of the height, and its length^2."""
        p, a = self.numbers(value, "point"), self.numbers(value, "axis")
        length2 = sum(x * x for x in a)
        height = self.linear(a, sum(x * y for x, y in zip(a, p)))
        return [*self.about(p), (-(1 + slope2) / length2, height, height), (-radius2, self.one(), self.one())], height, length2

    def cut(self, value, terms, height, length2, low):
        parts = [self.sign(*terms)]
        if low is not None:
            parts.append(self.sign((-1, height, self.one()), (F(low) * length2, self.one(), self.one())))
        if "to" in value:
            parts.append(self.sign((1, height, self.one()), (-F(value["to"]) * length2, self.one(), self.one())))
        return "all", parts

    def read_cylinder(self, value):
        return self.cut(value, *self.shaft(value, F(value["radius"]) ** 2, 0), value.get("from"))

    def read_cone(self, value):
        return self.cut(value, *self.shaft(value, 0, F(value["slope"]) ** 2), value.get("from", "0"))

    def read_capsule(self, value):
        p, a = self.numbers(value, "point"), self.numbers(value, "axis")
        middle = self.cut({"to": 1}, *self.shaft(value, F(value["radius"]) ** 2, 0), 0)
        return "any", [middle, self.round(p, value["radius"]), self.round([x + y for x, y in zip(p, a)], value["radius"])]

    def read_torus(self, value):
        """(|x|^2 + R^2 - r^2)^2 = 4 R^2 (distance from the axis)^2."""
        major2, minor2 = F(value["major"]) ** 2, F(value["minor"]) ** 2
        terms, _, _ = self.shaft(value, 0, 0)
        square = self.polynomials.pop(self.sign(*terms[:self.d], (major2 - minor2, self.one(), self.one())))
        ring = self.polynomials.pop(self.sign(*terms))
        return self.sign((1, square, square), (-4 * major2, ring, self.one()))

    def read_polynomial(self, value):
        f = {tuple(map(int, key.split(","))): F(c) for key, c in value.items()}
        return self.sign((1, f, self.one()))
