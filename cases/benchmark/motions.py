"""Motions of the benchmark: pieces of matrices whose entries are polynomials in t over one denominator, exactly.

A polynomial is a list of Fractions, the constant first. A piece is (t0, t1, rows, weight): three rows of four
polynomials, over the polynomial `weight`. The text is that of `graze convert`, which graze-check reads too.
SPDX-License-Identifier: CC0-1.0
"""
import json
import re
from fractions import Fraction as F
from math import gcd, lcm

ONE, ZERO = [F(1)], [F(0)]


# ------------------------------------------------------------------------------------------------ polynomials
def poly(*coefficients):
    return [F(c) for c in coefficients]


def add(*terms):
    out = [F(0)] * max(map(len, terms))
    for term in terms:
        for k, c in enumerate(term):
            out[k] += c
    return out


def times(a, b):
    out = [F(0)] * (len(a) + len(b) - 1)
    for j, x in enumerate(a):
        for k, y in enumerate(b):
            out[j + k] += x * y
    return out


def scaled(a, factor):
    return [factor * c for c in a]


def minus(a, b):
    return add(a, scaled(b, -1))


def value(a, t):
    out = F(0)
    for c in reversed(a):
        out = out * t + c
    return out


def shifted(a, t0, length=1):
    """The polynomial in t that a is in s = (t - t0) / length."""
    out, s = ZERO, [F(-t0) / length, F(1) / length]
    for c in reversed(a):
        out = add(times(out, s), [c])
    return trimmed(out)


def trimmed(a):
    while len(a) > 1 and a[-1] == 0:
        a = a[:-1]
    return a


def written(a):
    parts = []
    for k, c in enumerate(a):
        if c:
            power = "" if k == 0 else "*t" if k == 1 else f"*t^{k}"
            parts.append((" - " if c < 0 else " + ") + f"{abs(c)}{power}")
    if not parts:
        return "0"
    text = "".join(parts)
    return text[3:] if text.startswith(" + ") else "-" + text[3:]


def read(text):
    """A polynomial as `graze convert` writes it."""
    out = ZERO
    for sign, number, power in re.findall(r"(^-?|[+-]) ?(\d+(?:/\d+)?)((?:\*t(?:\^\d+)?)?)", text):
        k = 0 if not power else int(power[3:]) if "^" in power else 1
        out = add(out, [F(0)] * k + [-F(number) if sign == "-" else F(number)])
    return out


# ------------------------------------------------------------------------------------------------ texts
def entry(a, weight):
    if weight == ONE:
        return written(a)
    return f"({written(a)})/({written(weight)})"


def moves_only(piece):
    _, _, rows, weight = piece
    return not any(c for i in range(3) for j in range(3) for c in minus(rows[i][j], weight if i == j else ZERO))


def is_straight(pieces):
    """Is each piece a translation along a line segment?"""
    return all(moves_only(p) and p[3] == ONE and all(not any(row[3][2:]) for row in p[2]) for p in pieces)


def motion_text(pieces):
    """The motion file."""
    lines = []
    for t0, t1, rows, weight in pieces:
        if moves_only((t0, t1, rows, weight)):
            transform = {"translate": [entry(row[3], weight) for row in rows]}
        else:
            transform = {"matrix": [[entry(a, weight) for a in row] for row in rows]}
        lines.append(json.dumps({"t": [str(t0), str(t1)], "transform": transform}))
    return '{"dimension": 3, "pieces": [\n' + ",\n".join(lines) + "\n]}\n"


def motion_of(text):
    """The pieces of a motion file as motion_text and `graze convert` write it."""
    pieces = []
    for piece in json.loads(text)["pieces"]:
        transform = piece["transform"]
        if "translate" in transform:
            entries = [["1" if i == j else "0" for j in range(3)] + [transform["translate"][i]] for i in range(3)]
        else:
            entries = transform["matrix"][:3]
        weights = {e.split(")/(")[1][:-1] for row in entries for e in row if ")/(" in e}
        if len(weights) > 1:
            raise ValueError("expected one denominator a piece")
        weight = read(weights.pop()) if weights else ONE
        rows = [[read(e[1:].split(")/(")[0]) if ")/(" in e else times(read(e), weight) for e in row] for row in entries]
        pieces.append((*map(F, piece["t"]), rows, weight))
    return pieces


# ------------------------------------------------------------------------------------------------ pieces
def along(x, y, z, t0=0, t1=1, weight=ONE):
    """A translation by three polynomials over a weight."""
    rows = [[weight if i == j else ZERO for j in range(3)] + [a] for i, a in enumerate((x, y, z))]
    return F(t0), F(t1), rows, weight


def straight(*way):
    return [along(*(poly(0, w) for w in way))]


def legs(*points, times_of=None):
    """Straight from point to point, in unit time each or at the given times."""
    at = times_of or range(len(points))
    out = []
    for k in range(len(points) - 1):
        t0, t1 = F(at[k]), F(at[k + 1])
        out.append(along(*(shifted(poly(a, F(b) - a), t0, t1 - t0) for a, b in zip(points[k], points[k + 1])), t0, t1))
    return out


def product(p, q):
    """Of quaternions of polynomials."""
    (a, b, c, d), (e, f, g, h) = p, q
    return (minus(times(a, e), add(times(b, f), times(c, g), times(d, h))),
            add(times(a, f), times(b, e), minus(times(c, h), times(d, g))),
            add(times(a, g), times(c, e), minus(times(d, f), times(b, h))),
            add(times(a, h), times(d, e), minus(times(b, g), times(c, f))))


def turned(q, t0=0, t1=1, center=(0, 0, 0), way=(ZERO, ZERO, ZERO)):
    """The rotation of a quaternion of polynomials about a center, then a translation by polynomials."""
    w, x, y, z = q
    ww, xx, yy, zz = (times(a, a) for a in q)
    weight = add(ww, xx, yy, zz)

    def both(a, b, c, d, sign):
        return scaled(add(times(a, b), scaled(times(c, d), sign)), 2)

    linear = [[minus(add(ww, xx), add(yy, zz)), both(x, y, w, z, -1), both(x, z, w, y, 1)],
              [both(x, y, w, z, 1), minus(add(ww, yy), add(xx, zz)), both(y, z, w, x, -1)],
              [both(x, z, w, y, -1), both(y, z, w, x, 1), minus(add(ww, zz), add(xx, yy))]]
    rows = []
    for i in range(3):
        moved_center = add(*(scaled(linear[i][j], center[j]) for j in range(3)))
        shift = minus(times(weight, add([F(center[i])], way[i])), moved_center)
        rows.append([*linear[i], trimmed(shift)])
    return F(t0), F(t1), [[trimmed(a) for a in row] for row in rows], trimmed(weight)


def about(axis, tan_half):
    """The quaternion of a turn by 2 atan(tan_half) about an axis of whole length."""
    length = next(n for n in range(1, 1000) if n * n == sum(c * c for c in axis))
    return (poly(length), *(scaled(tan_half, F(c)) for c in axis))


def turning(turns, count=1, center=(0, 0, 0), way=(ZERO, ZERO, ZERO)):
    """In each of so many unit times all the turns at once, each (axis, tangent of half its angle), then a translation by polynomials in t."""
    out, before = [], (ONE, ZERO, ZERO, ZERO)
    for k in range(count):
        q = end = before
        for axis, tan_half in turns:
            q = product(about(axis, shifted(poly(0, tan_half), k)), q)
            end = product(about(axis, poly(tan_half)), end)
        out.append(turned(q, k, k + 1, center, way))
        before = lowest(end)
    return out


def lowest(q):
    """A constant quaternion in whole numbers without a common factor: the same turn."""
    numbers = [a[0] for a in map(trimmed, q)]
    common = lcm(*(c.denominator for c in numbers))
    factor = F(common, gcd(*(int(c * common) for c in numbers)))
    return tuple([c * factor] for c in numbers)


def quarters(count, axis=(0, 0, 1), center=(0, 0, 0), way=(0, 0, 0)):
    """Quarter turns, moved on by `way` in each."""
    return turning([(axis, F(1))], count, center, [poly(0, w) for w in way])


def affine(rows, t0=0, t1=1):
    """Three rows of four polynomials."""
    return F(t0), F(t1), rows, ONE


def spline(controls):
    """The translation along a uniform cubic B-spline, from its own start; one piece between four control points."""
    basis = [poly(F(1, 6), F(-1, 2), F(1, 2), F(-1, 6)), poly(F(2, 3), 0, -1, F(1, 2)),
             poly(F(1, 6), F(1, 2), F(1, 2), F(-1, 2)), poly(0, 0, 0, F(1, 6))]
    out = []
    for k in range(len(controls) - 3):
        out.append(along(*(shifted(add(*(scaled(b, F(p[i])) for b, p in zip(basis, controls[k:]))), k) for i in range(3)), k, k + 1))
    return out
