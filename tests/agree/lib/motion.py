"""Motions, twice: as the JSON the program reads and as exact polynomial matrices of our own.

SPDX-License-Identifier: GPL-3.0-or-later

A Piece holds M(t) x = (A(t) x + b(t)) / w(t) with integer polynomials in the motion's parameter.
The matrices follow from the textbook formulas (rotation of a quaternion, of a complex half angle),
not from the program. Invariant: pieces follow one another and w > 0 on each closed piece.
"""
import json

from exact import Fraction as F
from math import lcm

from algebra import add, common, content, derivative, integral, mul, quotient, scale, sign_at, sub
from algebra import substitute, trim, value


class Piece:
    def __init__(self, lo, hi, a, b, w):
        """Common factors are taken out, so that degrees stay as low as they can be."""
        entries = [p for row in a for p in row] + list(b) + [w]
        g = []
        for p in entries:
            g = common(g, p) if p else g
        factor = content([c for p in entries for c in p])
        def lower(p):
            p = [c // factor for c in p]
            return divided(p, g) if p and len(g) > 1 else p
        self.lo, self.hi = F(lo), F(hi)
        self.a = [[lower(p) for p in row] for row in a]
        self.b = [lower(p) for p in b]
        self.w = lower(w)
        if sign_at(self.w, (self.lo + self.hi) / 2) < 0:
            self.a = [[scale(p, -1) for p in row] for row in self.a]
            self.b = [scale(p, -1) for p in self.b]
            self.w = scale(self.w, -1)
        self.inverse_map = None

    def map(self, point, t):
        w = value(self.w, t)
        return tuple((sum(value(p, t) * x for p, x in zip(row, point)) + value(b, t)) / w
                     for row, b in zip(self.a, self.b))

    def trajectory(self, point):
        """c = X / W with W > 0 on the piece: adj(A) (w P - b) / det A."""
        if self.inverse_map is None:
            self.inverse_map = adjugate(self.a)
        adj, det = self.inverse_map
        den = 1
        for x in point:
            den = den * x.denominator
        right = [sub(scale(self.w, int(x * den)), scale(b, den))
                 for x, b in zip(point, self.b)]
        xs = []
        for row in adj:
            total = []
            for p, r in zip(row, right):
                total = add(total, mul(p, r))
            xs.append(total)
        w = scale(det, den)
        g = w
        for p in xs:
            g = common(g, p) if p else g
        if len(g) > 1:
            xs, w = [divided(p, g) for p in xs], divided(w, g)
        if sign_at(w, (self.lo + self.hi) / 2) < 0:
            xs, w = [scale(p, -1) for p in xs], scale(w, -1)
        return xs, w


def divided(p, g):
    """p / g with the sign and content of p kept."""
    if not p:
        return []
    q = quotient(p, g)
    ratio = F(p[-1], q[-1] * g[-1])
    if ratio.denominator != 1:
        raise ArithmeticError("divided: content of the divisor does not divide")
    return scale(q, int(ratio))


def adjugate(a):
    if len(a) == 2:
        adj = [[a[1][1], scale(a[0][1], -1)], [scale(a[1][0], -1), a[0][0]]]
    else:
        def cofactor(i, j):
            r = [k for k in range(3) if k != i]
            c = [k for k in range(3) if k != j]
            m = sub(mul(a[r[0]][c[0]], a[r[1]][c[1]]), mul(a[r[0]][c[1]], a[r[1]][c[0]]))
            return scale(m, -1) if (i + j) % 2 else m
        adj = [[cofactor(j, i) for j in range(3)] for i in range(3)]
    det = []
    for k in range(len(a)):
        det = add(det, mul(a[0][k], adj[k][0]))
    return adj, det


class Motion:
    def __init__(self, pieces, document=None):
        self.pieces = pieces
        self.dimension = len(pieces[0].b)
        self.document = document if document is not None else matrix_document(pieces)

    def text(self):
        return json.dumps(self.document)

    @property
    def start(self):
        return self.pieces[0].lo

    @property
    def end(self):
        return self.pieces[-1].hi

    def piece_at(self, t):
        return next(p for p in self.pieces if p.lo <= t <= p.hi)

    def map(self, point, t):
        return self.piece_at(t).map(point, t)

    def back(self, point, t):
        xs, w = self.piece_at(t).trajectory(point)
        return tuple(value(x, t) / value(w, t) for x in xs)

    def velocity_back(self, point, t):
        """c'(t) for P fixed, on the piece that holds t (the left one at a break)."""
        xs, w = self.piece_at(t).trajectory(point)
        ww = value(w, t)
        return tuple((value(derivative(x), t) * ww - value(x, t) * value(derivative(w), t))
                     / ww ** 2 for x in xs)


# ------------------------------------------------------------------------------------ expressions

def term(c, k, var):
    if k == 0:
        return str(c)
    x = var if k == 1 else f"{var}^{k}"
    return x if c == 1 else f"-{x}" if c == -1 else f"{c}*{x}"


def text(p, var="t"):
    """A polynomial with Fraction coefficients as an expression."""
    terms = [term(F(c), k, var) for k, c in enumerate(p) if c]
    return "+".join(terms).replace("+-", "-") if terms else "0"


def ratio_text(p, w, var="t"):
    return text(p, var) if w == [1] else f"({text(p, var)})/({text(w, var)})"


def matrix_document(pieces):
    out = []
    for p in pieces:
        rows = [[ratio_text(e, p.w) for e in row + [b]] for row, b in zip(p.a, p.b)]
        out.append({"t": [str(p.lo), str(p.hi)], "transform": {"matrix": rows}})
    return {"dimension": len(pieces[0].b), "pieces": out}


# ------------------------------------------------------------------------------------- transforms
# A transform is (JSON, function (lo, hi) -> homogeneous (A, b, w) in t). Polynomials are written
# in t, or in s where `var` says so.

def in_t(p, var, lo, hi):
    """A polynomial in s or t as one in t, with Fraction coefficients."""
    if var == "t":
        return [F(c) for c in p]
    out, a = [F(0)], [F(1)]
    s = [F(-lo) / (hi - lo), F(1) / (hi - lo)]
    for c in p:
        out = fadd(out, [F(c) * x for x in a])
        a = fmul(a, s)
    return out


def fadd(p, q):
    n = max(len(p), len(q))
    return [(p[k] if k < len(p) else 0) + (q[k] if k < len(q) else 0) for k in range(n)]


def fmul(p, q):
    out = [F(0)] * (len(p) + len(q) - 1)
    for i, x in enumerate(p):
        for j, y in enumerate(q):
            out[i + j] += x * y
    return out


def homogeneous(a, b, w):
    """Fractions to integers by one common factor."""
    flat = [p for row in a for p in row] + b + [w]
    den = 1
    for p in flat:
        for c in p:
            d = F(c).denominator
            den = den * d // content([den, d])
    def whole(p):
        return trim([int(F(c) * den) for c in p])
    return [[whole(p) for p in row] for row in a], [whole(p) for p in b], whole(w)


def product(m2, m1):
    """m2 after m1."""
    (a2, b2, w2), (a1, b1, w1) = m2, m1
    n = len(b1)
    def dot(row, col):
        total = []
        for p, q in zip(row, col):
            total = add(total, mul(p, q))
        return total
    a = [[dot(a2[i], [a1[k][j] for k in range(n)]) for j in range(n)] for i in range(n)]
    b = [add(dot(a2[i], b1), mul(b2[i], w1)) for i in range(n)]
    return a, b, mul(w1, w2)


def identity(n):
    return [[[1] if i == j else [] for j in range(n)] for i in range(n)]


def about(center, m):
    """m about a constant centre."""
    n = len(center)
    one = [[[F(int(i == j))] for j in range(n)] for i in range(n)]
    def shift(s):
        return homogeneous(one, [[F(s * c)] for c in center], [F(1)])
    return product(product(shift(1), m), shift(-1))


def translate(polys, var="t"):
    def make(lo, hi):
        n = len(polys)
        one = [[[F(int(i == j))] for j in range(n)] for i in range(n)]
        return homogeneous(one, [in_t(p, var, lo, hi) for p in polys], [F(1)])
    return {"translate": [text(p, var) for p in polys]}, make


def scaling(polys, center=None, var="t"):
    n = len(polys)
    def make(lo, hi):
        a = [[in_t(polys[i], var, lo, hi) if i == j else [F(0)] for j in range(n)]
             for i in range(n)]
        m = homogeneous(a, [[F(0)] for _ in range(n)], [F(1)])
        return about(center, m) if center else m
    document = {"scale": [text(p, var) for p in polys]}
    if center:
        document["center"] = [str(c) for c in center]
    return document, make


def matrix(rows, den, var="t"):
    """rows: d rows of d+1 polynomials, over one denominator."""
    n = len(rows)
    def make(lo, hi):
        return homogeneous([[in_t(p, var, lo, hi) for p in row[:n]] for row in rows],
                           [in_t(row[n], var, lo, hi) for row in rows],
                           in_t(den, var, lo, hi))
    return {"matrix": [[ratio_text(p, den, var) for p in row] for row in rows]}, make


def quaternion_matrix(q):
    """The rotation of a quaternion of integer polynomials: q v q^* / |q|^2."""
    w, x, y, z = q
    ww, xx, yy, zz = (mul(p, p) for p in q)
    two = lambda p, r: scale(mul(p, r), 2)
    a = [[sub(add(ww, xx), add(yy, zz)), sub(two(x, y), two(w, z)), add(two(x, z), two(w, y))],
         [add(two(x, y), two(w, z)), sub(add(ww, yy), add(xx, zz)), sub(two(y, z), two(w, x))],
         [sub(two(x, z), two(w, y)), add(two(y, z), two(w, x)), sub(add(ww, zz), add(xx, yy))]]
    return a, [[], [], []], add(add(ww, xx), add(yy, zz))


def complex_matrix(z):
    """The rotation by twice the argument of z."""
    re, im = z
    rr, ii, ri = mul(re, re), mul(im, im), scale(mul(re, im), 2)
    return [[sub(rr, ii), scale(ri, -1)], [ri, sub(rr, ii)]], [[], []], add(rr, ii)


def times_complex(p, q):
    return sub(mul(p[0], q[0]), mul(p[1], q[1])), add(mul(p[0], q[1]), mul(p[1], q[0]))


def half_power(q, n):
    """Re and Im of (q0 + i q1)^n for polynomials; a negative n turns the other way."""
    z = [1], []
    for _ in range(abs(n)):
        z = times_complex(z, q)
    return z[0], z[1] if n >= 0 else scale(z[1], -1)


def rotation(num, den=(1,), times=1, center=None, axis=None, length=None, var="t"):
    """Angle times * 2 atan(num/den); axis: constants of rational length `length`."""
    def make(lo, hi):
        _, (top,), bottom = homogeneous([], [in_t(num, var, lo, hi)], in_t(den, var, lo, hi))
        re, im = half_power((bottom, top), times)
        if axis is None:
            m = complex_matrix((re, im))
        else:
            m = quaternion_matrix([scale(re, length)] + [scale(im, x) for x in axis])
        return about(center, m) if center else m
    document = {"tan_half": ratio_text(list(num), list(den), var)}
    if times != 1:
        document["times"] = times
    if center:
        document["center"] = [str(c) for c in center]
    if axis:
        document["axis"] = [str(c) for c in axis]
    return {"rotate": document}, make


def quaternion(polys, center=None, var="t"):
    def make(lo, hi):
        q = homogeneous([], [in_t(p, var, lo, hi) for p in polys], [F(1)])[1]
        m = quaternion_matrix(q)
        return about(center, m) if center else m
    document = {"quaternion": [text(p, var) for p in polys]}
    if center:
        document["center"] = [str(c) for c in center]
    return document, make


def turn(quarters, center=None, axis=None, length=None):
    """Quarter turns; the piece is cut by `build`, which sees `quarters`."""
    document = {"quarters": quarters}
    if center:
        document["center"] = [str(c) for c in center]
    if axis:
        document["axis"] = [str(c) for c in axis]

    def make(lo, hi, first, last):
        """On [lo, hi], a part of the piece [first, last] cut into |quarters| equal parts."""
        n, direction = abs(quarters), (1 if quarters > 0 else -1)
        part = (last - first) / n
        k = int((lo - first) / part)
        start = first + k * part
        done = half_power(([1], [direction]), k)
        _, (top,), one = homogeneous([], [[-direction * start / part, direction / part]], [F(1)])
        re, im = times_complex(done, (one, top))
        m = complex_matrix((re, im)) if axis is None else quaternion_matrix(
            [scale(re, length)] + [scale(im, x) for x in axis])
        return about(center, m) if center else m
    make.quarters = abs(quarters)
    return {"turn": document}, make


def compose(*transforms):
    return {"compose": [t[0] for t in transforms]}, [t[1] for t in transforms]


def build(parts):
    """A motion from [(lo, hi, transform)], turns cutting their pieces."""
    pieces, document = [], []
    for lo, hi, (doc, makes) in parts:
        lo, hi = F(lo), F(hi)
        makes = makes if isinstance(makes, list) else [makes]
        cut = lcm(*[getattr(m, "quarters", 1) for m in makes])
        for k in range(cut):
            a = lo + (hi - lo) * F(k, cut)
            b = lo + (hi - lo) * F(k + 1, cut)
            total = None
            for m in makes:
                one = m(a, b, lo, hi) if hasattr(m, "quarters") else m(lo, hi)
                total = one if total is None else product(one, total)
            pieces.append(Piece(a, b, *total))
        document.append({"t": [str(lo), str(hi)], "transform": doc})
    return Motion(pieces, {"dimension": len(pieces[0].b), "pieces": document})


def legs(points, times=None):
    """A translation along a polygon, one unit of time a leg."""
    parts = []
    times = times or list(range(len(points)))
    for k, (p, q) in enumerate(zip(points, points[1:])):
        a, b = F(times[k]), F(times[k + 1])
        polys = [[F(x) - (F(y) - x) * a / (b - a), (F(y) - x) / (b - a)] for x, y in zip(p, q)]
        parts.append((a, b, translate([trim(list(c)) for c in polys])))
    return build(parts)


def keyframes(frames):
    """frames: (t, position, rotation); rotation is a quaternion (3D) or complex (2D)."""
    d = len(frames[0][1])
    name = "quaternion" if d == 3 else "complex"
    pieces = []
    for (a, p, q), (b, p2, q2) in zip(frames, frames[1:]):
        a, b = F(a), F(b)
        def line(x, y):
            slope = (F(y) - F(x)) / (b - a)
            return [F(x) - slope * a, slope]
        rot = homogeneous([], [line(x, y) for x, y in zip(q, q2)], [F(1)])[1]
        m = quaternion_matrix(rot) if d == 3 else complex_matrix(rot)
        move = homogeneous([[[F(int(i == j))] for j in range(d)] for i in range(d)],
                           [line(x, y) for x, y in zip(p, p2)], [F(1)])
        pieces.append(Piece(a, b, *product(move, m)))
    document = {"dimension": d, "keyframes": [
        {"t": str(F(t)), "position": [str(F(x)) for x in p], name: [str(F(x)) for x in q]}
        for t, p, q in frames]}
    return Motion(pieces, document)


# --------------------------------------------------------------------------------- other motions

def constant(m, n):
    """An affine map (rows of d+1 Fractions) as homogeneous polynomials."""
    return homogeneous([[[F(x)] for x in row[:n]] for row in m], [[F(row[n])] for row in m],
                       [F(1)])


def reversed_in_time(motion):
    def flip(p):
        return [c if k % 2 == 0 else -c for k, c in enumerate(p)]
    return Motion([Piece(-p.hi, -p.lo, [[flip(e) for e in row] for row in p.a],
                         [flip(e) for e in p.b], flip(p.w)) for p in reversed(motion.pieces)])


def conjugated(motion, t, inverse):
    """T M T^-1 for constant affine maps T and T^-1."""
    n = motion.dimension
    return Motion([Piece(p.lo, p.hi, *product(product(constant(t, n), (p.a, p.b, p.w)),
                                              constant(inverse, n))) for p in motion.pieces])


def cut(motion, times):
    """The motion unchanged, with further break points at these times."""
    pieces = []
    for p in motion.pieces:
        marks = [p.lo] + sorted({t for t in times if p.lo < t < p.hi}) + [p.hi]
        pieces += [Piece(a, b, p.a, p.b, p.w) for a, b in zip(marks, marks[1:])]
    return Motion(pieces)


def reparametrised(motion, changes):
    """Piece k becomes M(phi_k(u)) on [lo, hi]; changes: (lo, hi, numerator, denominator)."""
    pieces = []
    for p, (lo, hi, num, den) in zip(motion.pieces, changes):
        entries = [e for row in p.a for e in row] + p.b + [p.w]
        top = max(len(e) for e in entries) - 1
        def sub_(e):
            return substitute(e, num, den, top)
        pieces.append(Piece(lo, hi, [[sub_(e) for e in row] for row in p.a],
                            [sub_(e) for e in p.b], sub_(p.w)))
    return Motion(pieces)


def squared(motion):
    """Piece k on [k, k+1] with phi = lo + (hi - lo) (u - k)^2: rational times become square
    roots, so that constructed contacts happen at irrational times."""
    changes = []
    for k, p in enumerate(motion.pieces):
        step = p.hi - p.lo
        phi = [p.lo + step * k * k, -2 * step * k, step]
        den = 1
        for c in phi:
            den = den * c.denominator
        changes.append((F(k), F(k + 1), [int(c * den) for c in phi], [den]))
    return reparametrised(motion, changes), changes


def mobius(motion, q=F(3, 2)):
    """Piece k on [k, k+1] with v = u - k, phi = lo + (hi - lo) v (1 + q) / (1 + q v)."""
    changes = []
    for k, p in enumerate(motion.pieces):
        step = p.hi - p.lo
        den = [1 - q * k, q]
        num = [p.lo * den[0] - step * (1 + q) * k, p.lo * q + step * (1 + q)]
        whole = integral(num + den + [F(1)])
        # one common factor keeps the quotient
        factor = F(whole[-1])
        changes.append((F(k), F(k + 1), trim([int(c * factor) for c in num]),
                        trim([int(c * factor) for c in den])))
    return reparametrised(motion, changes), changes


def far(motion):
    """phi = (u - 10^30) 2^100: far from zero, and shorter than doubles there can tell."""
    base, rate = 10 ** 30, 2 ** 100
    changes = [(base + p.lo / rate, base + p.hi / rate, [-base * rate, rate], [1])
               for p in motion.pieces]
    return reparametrised(motion, changes), changes
