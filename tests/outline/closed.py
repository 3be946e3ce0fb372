"""Numbers in closed form to 60 digits: roots, pi, logarithms, arcs, integrals of polynomials.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from decimal import Decimal, getcontext

from exact import Fraction as F

getcontext().prec = 60


def number(x):
    """A Decimal of an integer, a ratio or a Decimal."""
    return x if isinstance(x, Decimal) else Decimal(int(F(x).numerator)) / Decimal(int(F(x).denominator))


def sqrt(x):
    return number(x).sqrt()


def log(x):
    return number(x).ln()


def atan(x):
    """By halving the angle, then the series x − x³/3 + …"""
    x, halvings = number(x), 12
    for _ in range(halvings):
        x = x / (1 + (1 + x * x).sqrt())
    power, total, k = x, Decimal(0), 1
    while abs(power) > Decimal(10) ** -70:
        total += power / k
        power, k = -power * x * x, k + 2
    return total * 2 ** halvings


PI = 4 * atan(1)


def asin(x):
    x = number(x)
    return atan(x / (1 - x * x).sqrt()) if abs(x) < 1 else x * PI / 2


def acos(x):
    return PI / 2 - asin(x)


def value(poly, x):
    """A polynomial, lowest power first, at x."""
    total = number(0)
    for c in reversed(poly):
        total = total * number(x) + number(c)
    return total


def integral(poly, a, b):
    """The integral of a polynomial, lowest power first: a Fraction where the ends are rational, else a Decimal."""
    if isinstance(a, Decimal) or isinstance(b, Decimal):
        upper = [0] + [number(c) / (k + 1) for k, c in enumerate(poly)]
        return value(upper, b) - value(upper, a)
    return sum(F(c) * (F(b) ** (k + 1) - F(a) ** (k + 1)) / (k + 1) for k, c in enumerate(poly))


def root(poly, a, b):
    """The root of a polynomial between a and b, where it has other signs."""
    a, b = number(a), number(b)
    rising = value(poly, a) < 0
    while b - a > Decimal(10) ** -57:
        middle = (a + b) / 2
        a, b = (middle, b) if (value(poly, middle) < 0) == rising else (a, middle)
    return (a + b) / 2
