"""Poses of a motion for codes that read nothing else: matrices of binary64, and how far they are from the motion, proved.

SPDX-License-Identifier: CC0-1.0
"""
import itertools
import math
from fractions import Fraction as F

from motions import value

HEAD = "t," + ",".join(f"m{i}{j}" for i in range(4) for j in range(4))


def times(pieces, count):
    """So many times, evenly spread, the first and the last included."""
    start, end = pieces[0][0], pieces[-1][1]
    return [start + (end - start) * F(k, count - 1) for k in range(count)]


def matrices(pieces, at):
    """(t, the three rows of M(t), exactly) of increasing times."""
    k = 0
    for t in at:
        while t > pieces[k][1]:
            k += 1
        _, _, rows, weight = pieces[k]
        w = value(weight, t)
        yield t, [[value(a, t) / w for a in row] for row in rows]


def decimal(x):
    """A rational number whose denominator divides a power of ten as the decimal that it is."""
    places = next(n for n in range(400) if (x * 10 ** n).denominator == 1)
    digits = str(abs(x.numerator) * 10 ** places // x.denominator).rjust(places + 1, "0")
    return ("-" if x < 0 else "") + (digits[:-places] + "." + digits[-places:] if places else digits)


def root_above(x):
    """A double that is at least the square root of a rational number."""
    if x == 0:
        return 0.0
    shift = max(0, 140 + x.denominator.bit_length() - x.numerator.bit_length()) // 2 * 2
    root = F(math.isqrt((x.numerator << shift) // x.denominator) + 1, 1 << shift // 2)
    found = float(root)
    return found if F(found) >= root else math.nextafter(found, math.inf)


def box_corners(vertices):
    return list(itertools.product(*((min(c), max(c)) for c in zip(*vertices))))


def table(pieces, vertices, count):
    """The text of the table, and a bound of how far a point of the solid is from where the motion has it, in any of the poses.

    The error is affine in the point, so its norm is greatest in a corner of the solid's box.
    """
    corners, lines, most = box_corners(vertices), [HEAD], F(0)
    for t, exact in matrices(pieces, times(pieces, count)):
        near = [[float(a) for a in row] for row in exact]
        lines.append(",".join([decimal(t), *(repr(a) for row in near for a in row), "0.0", "0.0", "0.0", "1.0"]))
        error = [[F(b) - a for a, b in zip(row, other)] for row, other in zip(exact, near)]
        if any(e for row in error for e in row):
            most = max([most, *(sum(sum((e * c for e, c in zip(row, corner)), row[3]) ** 2 for row in error) for corner in corners)])
    return "\n".join(lines) + "\n", root_above(most)
