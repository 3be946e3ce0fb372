"""The rational numbers of the suites' own algebra, under the name and with the meaning of Python's Fraction.

They are gmpy2's mpq where gmpy2 is installed, several times as fast; GRAZE_FRACTIONS=python takes Python's own everywhere. With mpq
some expressions would silently become inexact floats of gmpy2 (an mpq with a float or to a rational power, an mpz over an int):
each of them fails here, as no float fits into the context that is set. A thread has a context of its own: call refuse_floats there.
`to_double` stands for `float`, which rounds an mpq towards 0.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numbers
import os
import re
from decimal import Decimal
from fractions import Fraction as PythonFraction

try:
    if os.environ.get("GRAZE_FRACTIONS") == "python":
        raise ImportError
    import gmpy2
except ImportError:
    gmpy2 = None

# Numerals that mpq reads as Python does; of others it takes some that are none ("1 2" is 12), and refuses some that are ("+1").
PLAIN = re.compile(r"-?[0-9]+(?:/[0-9]+|(?:\.[0-9]+)?(?:[eE][-+]?[0-9]+)?)")


def of_gmpy2(*parts):
    """The mpq of what Python's Fraction takes: a number, a numeral, a numerator with its denominator."""
    if len(parts) == 1 and isinstance(parts[0], (str, Decimal)) and not (isinstance(parts[0], str) and PLAIN.fullmatch(parts[0])):
        return gmpy2.mpq(PythonFraction(parts[0]))
    return gmpy2.mpq(*parts)


Fraction = of_gmpy2 if gmpy2 else PythonFraction


def refuse_floats():
    """In this thread a float of gmpy2 is an error."""
    if gmpy2:
        least = gmpy2.get_emin_min()
        gmpy2.set_context(gmpy2.context(precision=2, emin=least, emax=least + 1, trap_inexact=True, trap_overflow=True, trap_underflow=True,
                                        trap_invalid=True, trap_erange=True, trap_divzero=True))


def is_float(x):
    """A float of gmpy2: the one that a context lets pass is 0."""
    return gmpy2 is not None and isinstance(x, gmpy2.mpfr)


def to_double(x):
    """The double nearest to a number, or to a numeral or a ratio as text, as Python's `float` gives it for its own numbers."""
    if isinstance(x, str):
        x = PythonFraction(x) if "/" in x else float(x)
    return int(x.numerator) / int(x.denominator) if isinstance(x, numbers.Rational) else float(x)


def time_bounds(text, bits=100):
    """(low, high) of an exact time of a table, a ratio or root(c0 c1 ...;low;high), equal or at most 2^-bits apart."""
    root = re.fullmatch(r"root\((.*);(.*);(.*)\)", text)
    if not root:
        return Fraction(text), Fraction(text)
    poly = [Fraction(c) for c in root[1].split()]
    low, high = Fraction(root[2]), Fraction(root[3])

    def value(t):
        return sum(c * t ** k for k, c in enumerate(poly))
    while high - low > Fraction(1, 2 ** bits):
        middle = (low + high) / 2
        low, high = (low, middle) if value(low) * value(middle) <= 0 else (middle, high)
    return low, high


def rounds_to(text, decimal):
    """Is a decimal of at most 17 significant digits an exact time of a table, rounded to the nearest? Both may be empty."""
    if text in ("", "undecided"):
        return decimal == ""
    digits = Decimal(decimal).as_tuple().digits
    unit = Fraction(10) ** (Decimal(decimal).adjusted() - 16)
    low, high = time_bounds(text, 200)
    return len(digits) <= 17 and abs(Fraction(decimal) - low) <= unit / 2 + (high - low)


def has_decimals(row, *names):
    """Does a row have, for each column of an exact time, one of its decimal behind it?"""
    places = list(row)
    return all(any(places[places.index(name) + 1] == name + end and rounds_to(row[name], row[name + end]) for end in ("_near", "_decimal"))
               for name in names)


def simple(x, most):
    """The fraction nearest to x whose denominator is at most `most`."""
    return Fraction(PythonFraction(int(x.numerator), int(x.denominator)).limit_denominator(most))


refuse_floats()
