"""A motion's matrix at one time as power series, by a reader of its own.

SPDX-License-Identifier: GPL-3.0-or-later

A Jet is c0 + c1 e + ... up to the power TERMS - 1 of e, where t = t* + e; all exact. The order of
a contact with a plane is the number of leading zeros of the plane's pullback; TERMS zeros count as a
slide. The germ at a break point is that of the piece that begins there.
"""
import json
import math
import re

from exact import Fraction as F

TERMS = 8


class Jet:
    def __init__(self, terms):
        self.terms = (list(terms) + [F(0)] * TERMS)[:TERMS]

    def __add__(self, other):
        return Jet([a + b for a, b in zip(self.terms, jet(other).terms)])

    def __neg__(self):
        return Jet([-a for a in self.terms])

    def __sub__(self, other):
        return self + -jet(other)

    def __mul__(self, other):
        out = [F(0)] * TERMS
        right = jet(other).terms
        for i, a in enumerate(self.terms):
            for j in range(TERMS - i) if a else ():
                out[i + j] += a * right[j]
        return Jet(out)

    def __truediv__(self, other):
        """Term by term; a common power of e is taken out first, t/t being 1."""
        top, bottom = list(self.terms), list(jet(other).terms)
        while bottom[0] == 0:
            if top[0] != 0:
                raise ZeroDivisionError("a pole")
            top, bottom = top[1:] + [F(0)], bottom[1:] + [F(0)]
        out = []
        for k in range(TERMS):
            out.append((top[k] - sum(out[i] * bottom[k - i] for i in range(k))) / bottom[0])
        return Jet(out)

    def __pow__(self, n):
        n = n.terms[0] if isinstance(n, Jet) else n
        out = Jet([F(1)])
        for _ in range(abs(int(n))):
            out = out * self
        return out if n >= 0 else Jet([F(1)]) / out

    __radd__, __rmul__ = __add__, __mul__

    def __rsub__(self, other):
        return jet(other) - self

    def order(self):
        """Leading zeros; None stands for a slide."""
        return next((k for k, c in enumerate(self.terms) if c), None)


def jet(x):
    return x if isinstance(x, Jet) else Jet([F(x)])


def root(x):
    """The square root whose value at e = 0 is rational and positive."""
    value = x.terms[0]
    out = [F(math.isqrt(value.numerator), math.isqrt(value.denominator))]
    if out[0] ** 2 != value:
        raise ValueError("an axis of irrational length")
    for k in range(1, TERMS):
        known = sum(out[i] * out[k - i] for i in range(1, k))
        out.append((x.terms[k] - known) / (2 * out[0]))
    return Jet(out)


def expression(text, t, s):
    """Python's operators bind as the format's do, -t^2 included."""
    text = re.sub(r"(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", lambda m: f"N('{m[0]}')", str(text))
    if not re.fullmatch(r"(?:N\('[\d.eE+-]+'\)|[ts()*/^+\s-])+", text):
        raise ValueError(f"{text} is no expression")
    return jet(eval(text.replace("^", "**"),
                    {"__builtins__": {}, "N": lambda x: jet(F(x)), "t": t, "s": s}))


def product(a, b):
    return [[sum((x * b[k][j] for k, x in enumerate(row)), jet(0)) for j in range(len(b[0]))]
            for row in a]


def unit(n):
    return [[jet(int(i == j)) for j in range(n)] for i in range(n)]


def inverse(m):
    """Gauss; some entry of each column has an invertible value, det M being non-zero."""
    n = len(m)
    rows = [row + extra for row, extra in zip(m, unit(n))]
    for k in range(n):
        pivot = next(i for i in range(k, n) if rows[i][k].terms[0])
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(n):
            if i != k and any(rows[i][k].terms):
                rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k])]
    return [row[n:] for row in rows]


def affine(a, b):
    d = len(b)
    return [row + [x] for row, x in zip(a, b)] + [[jet(0)] * d + [jet(1)]]


def about(a, center):
    moved = product(a, [[c] for c in center])
    return affine(a, [c - m[0] for c, m in zip(center, moved)])


def turned(q, d):
    """The rotation of a quaternion that need not be a unit; in the plane its z axis alone is used."""
    w, x, y, z = q
    n = w * w + x * x + y * y + z * z
    rows = [[w*w + x*x - y*y - z*z, 2 * (x*y - w*z), 2 * (x*z + w*y)],
            [2 * (x*y + w*z), w*w - x*x + y*y - z*z, 2 * (y*z - w*x)],
            [2 * (x*z - w*y), 2 * (y*z + w*x), w*w - x*x - y*y + z*z]]
    return [[x / n for x in row[:d]] for row in rows[:d]]


class Piece:
    """The piece [lo, hi] of a motion in dimension d, looked at from the time `at`."""

    def __init__(self, lo, hi, d, at):
        self.lo, self.hi, self.d, self.at = lo, hi, d, at
        self.t = Jet([at, F(1)])
        self.s = (self.t - lo) / (hi - lo)

    def vector(self, entries):
        return [expression(e, self.t, self.s) for e in entries]

    def half(self, h, axis):
        length = jet(1) if self.d == 2 else root(sum((x * x for x in axis), jet(0)))
        return turned([length] + [h * x for x in axis], self.d)

    def power(self, rotation, n):
        out = unit(self.d)
        for _ in range(abs(n)):
            out = product(out, rotation)
        return out if n >= 0 else inverse(out)

    def quarters(self, n, axis, left):
        """The part of the turn that begins at this time, or ends there if `left`."""
        if n == 0:
            return unit(self.d)
        run = (self.at - self.lo) / (self.hi - self.lo) * abs(n)
        k = math.ceil(run) - 1 if left else math.floor(run)
        sign = 1 if n > 0 else -1
        rest = (self.s * abs(n) - k) * sign
        return product(self.power(self.half(jet(sign), axis), k), self.half(rest, axis))

    def matrix(self, transform, left):
        (name, value), = ((k, v) for k, v in transform.items() if k != "center")
        inner = value if isinstance(value, dict) else transform
        center = self.vector(inner.get("center", transform.get("center", ["0"] * self.d)))
        axis = self.vector(inner.get("axis", [0, 0, 1]))
        if name == "compose":
            out = unit(self.d + 1)
            for part in value:
                out = product(self.matrix(part, left), out)
            return out
        if name == "matrix":
            rows = [self.vector(row) for row in value]
            return (rows if len(rows) > self.d else rows + [unit(self.d + 1)[-1]])
        if name == "translate":
            return affine(unit(self.d), self.vector(value))
        if name == "scale":
            factors = self.vector(value if isinstance(value, list) else [value] * self.d)
            return about([[f * x for x in row] for f, row in zip(factors, unit(self.d))], center)
        if name == "quaternion":
            return about(turned(self.vector(value), self.d), center)
        if name == "rotate":
            h = expression(value["tan_half"], self.t, self.s)
            return about(self.power(self.half(h, axis), int(F(str(value.get("times", 1))))), center)
        if name == "turn":
            return about(self.quarters(int(F(str(value["quarters"]))), axis, left), center)
        raise ValueError(f"there is no transform {name}")


def turns_in(transform):
    (name, value), = ((k, v) for k, v in transform.items() if k != "center")
    if name == "compose":
        return set().union(*map(turns_in, value))
    return {abs(int(F(str(value["quarters"]))))} if name == "turn" else set()


def breaks(motion):
    """All times at which a piece begins or ends, in order."""
    if "pieces" in motion:
        out = set()
        for p in motion["pieces"]:
            lo, hi = (F(str(x)) for x in p["t"])
            out |= {lo, hi} | {lo + (hi - lo) * F(k, n) for n in turns_in(p["transform"])
                               for k in range(n)}
        return sorted(out)
    if "keyframes" in motion:
        return [F(str(f["t"])) for f in motion["keyframes"]]
    if "relative" in motion:
        return sorted(set(breaks(motion["relative"]["moving"]))
                      | set(breaks(motion["relative"]["frame"])))
    out = set()
    for j, part in enumerate(motion["sequence"]):
        inner = breaks(part)
        out |= {(b - inner[0]) / (inner[-1] - inner[0]) + j for b in inner}
    return sorted(out)


def between_frames(motion, at, left):
    d, frames = int(motion["dimension"]), motion["keyframes"]
    times = [F(str(f["t"])) for f in frames]
    k = piece_of(times, at, left)
    piece = Piece(times[k], times[k + 1], d, at)

    def run(name, rest):
        a, b = (piece.vector(f.get(name, rest)) for f in frames[k:k + 2])
        return [x + (y - x) * piece.s for x, y in zip(a, b)]
    if d == 3:
        q = run("quaternion", [1, 0, 0, 0])
    else:
        w, z = run("complex", [1, 0])
        q = [w, jet(0), jet(0), z]
    return affine(turned(q, d), run("position", [0] * d))


def piece_of(times, at, left):
    """The piece that begins at `at`, or ends there if `left`."""
    last = len(times) - 2
    if left:
        return next(k for k in range(last, -1, -1) if times[k] < at)
    return next(k for k in range(last + 1) if times[k] <= at < times[k + 1])


def matrix_at(motion, at, left=False):
    """M at the time `at`; the germ is the left one on request and at the end of all."""
    times = breaks(motion)
    left = left or at == times[-1]
    if "pieces" in motion:
        bounds = [F(str(p["t"][0])) for p in motion["pieces"]] + [times[-1]]
        k = piece_of(bounds, at, left)
        piece = Piece(bounds[k], bounds[k + 1], int(motion["dimension"]), at)
        return piece.matrix(motion["pieces"][k]["transform"], left)
    if "keyframes" in motion:
        return between_frames(motion, at, left)
    if "relative" in motion:
        pair = motion["relative"]
        return product(inverse(matrix_at(pair["frame"], at, left)),
                       matrix_at(pair["moving"], at, left))
    j = math.ceil(at) - 1 if left else math.floor(at)
    out = unit(int(motion["sequence"][0]["dimension"]) + 1)
    for part in motion["sequence"][:j]:
        out = product(values(matrix_at(part, breaks(part)[-1])), out)
    inner = breaks(motion["sequence"][j])
    width = inner[-1] - inner[0]
    here = matrix_at(motion["sequence"][j], inner[0] + (at - j) * width, left)
    return product([[stretched(x, width) for x in row] for row in here], out)


def values(m):
    return [[jet(x.terms[0]) for x in row] for row in m]


def stretched(x, width):
    """The jet in e of a function of width * e."""
    return Jet([c * width ** k for k, c in enumerate(x.terms)])


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file, parse_int=str, parse_float=str)
