"""The gear's outline, as WKT on standard output: 20 involute teeth of module 1, eight corners each.

SPDX-License-Identifier: GPL-3.0-or-later

A flank has corners on the root, base, pitch and tip circle. HALF is half the tooth's angle there:
pi/40 + inv(20 deg) - inv(acos(base/r)), inv(a) = tan a - a, to six digits; the foot is radial.
Corners are rounded to 1/1000. Five teeth are computed, the others are their images under quarter
turns, so that the outline is exactly its own image.
"""
from fractions import Fraction as F

PI = F(314159265358979, 10**14)
FLANK = [(F(35, 4), F(93444, 10**6)), (F(9396926, 10**6), F(93444, 10**6)),
         (F(10), F(78540, 10**6)), (F(11), F(31585, 10**6))]


def cosine_sine(angle):
    """Twenty-four terms of the exponential series: more than enough below pi."""
    sums, term = [F(0), F(0)], F(1)
    for n in range(24):
        sums[n % 2] += term if n % 4 < 2 else -term
        term = term * angle / (n + 1)
    return sums


def corner(radius, angle):
    return tuple(F(round(1000 * radius * x), 1000) for x in cosine_sine(angle))


def outline():
    part = []
    for tooth in range(5):
        middle = tooth * PI / 10
        part += [corner(r, middle - h) for r, h in FLANK]
        part += [corner(r, middle + h) for r, h in reversed(FLANK)]
    whole = []
    for _ in range(4):
        whole += part
        part = [(-y, x) for x, y in part]
    return whole


def main():
    corners = outline()
    print("POLYGON ((" + ", ".join(f"{x} {y}" for x, y in corners + corners[:1]) + "))")


if __name__ == "__main__":
    main()
