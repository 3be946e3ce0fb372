"""Turns, screws and slides from their definitions, in decimals of 100 digits.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from decimal import Decimal, getcontext
from numbers import Rational

from exact import Fraction as F

getcontext().prec = 105


def dec(x):
    return Decimal(int(x.numerator)) / Decimal(int(x.denominator)) if isinstance(x, Rational) else Decimal(x)


def arctan_inverse(n):
    """atan(1/n) by its series."""
    term, total, k = Decimal(1) / n, Decimal(0), 0
    while abs(term) > Decimal(10) ** -104:
        total += term / (2 * k + 1) * (-1) ** k
        term /= n * n
        k += 1
    return total


PI = 4 * (4 * arctan_inverse(5) - arctan_inverse(239))


def cos_sin(degrees):
    """Cosine and sine of a decimal number of degrees, by the series after reduction to at most 45 of them."""
    quarters = int((degrees / 90).to_integral_value())
    x = (degrees - 90 * quarters) * PI / 180
    cosine, sine, term, k = Decimal(0), Decimal(0), Decimal(1), 0
    while k < 84:
        cosine += term * (1, 0, -1, 0)[k % 4]
        sine += term * (0, 1, 0, -1)[k % 4]
        k += 1
        term *= x / k
    for _ in range(quarters % 4):
        cosine, sine = -sine, cosine
    return cosine, sine


def norm(v):
    return sum(x * x for x in v).sqrt()


def turn(point, degrees, advance, axis, center):
    """Rodrigues' formula about the axis through the center, then the advance along it."""
    c, s = cos_sin(degrees)
    center = [dec(x) for x in center]
    x = [a - b for a, b in zip(point, center)]
    if axis is None:
        return [center[0] + c * x[0] - s * x[1], center[1] + s * x[0] + c * x[1]]
    u = [dec(a) for a in axis]
    length = norm(u)
    u = [a / length for a in u]
    along = sum(a * b for a, b in zip(u, x)) * (1 - c)
    cross = [u[1] * x[2] - u[2] * x[1], u[2] * x[0] - u[0] * x[2], u[0] * x[1] - u[1] * x[0]]
    return [o + c * a + s * b + (along + advance) * w for o, a, b, w in zip(center, x, cross, u)]


def joint_map(joints, t, dimension):
    """The map of a chain at the time t, the first joint applied first."""
    def go(point):
        for kind, *what in joints:
            if kind == "slide":
                point = [p + t * dec(w) for p, w in zip(point, what[0])]
            else:
                degrees, pitch, axis, center = what
                angle = dec(degrees) * t
                point = turn(point, angle, dec(pitch) * angle / 360, axis, center)
        return point[:dimension]
    return go
