"""Times of contacts, compared exactly: a rational, or one root of an integer polynomial.

SPDX-License-Identifier: GPL-3.0-or-later

A Time is (polynomial, low, high): its only root in the open interval; or (None, r, r), the rational
r. Polynomials are lists of Fractions, the constant term first. Everything is decided by division
and Sturm chains over Q.
"""
import functools
import re

from exact import Fraction as F


def trim(p):
    while p and p[-1] == 0:
        p = p[:-1]
    return p


def value(p, x):
    out = F(0)
    for c in reversed(p):
        out = out * x + c
    return out


def remainder(p, q):
    p = trim(list(p))
    while len(p) >= len(q):
        factor, shift = p[-1] / q[-1], len(p) - len(q)
        p = trim([c - factor * q[k - shift] if k >= shift else c for k, c in enumerate(p)][:-1])
    return p


def sturm(p):
    chain = [trim(p), trim([k * c for k, c in enumerate(p)][1:])]
    while chain[-1]:
        chain.append([-c for c in remainder(chain[-2], chain[-1])])
    return chain[:-1]


def changes(chain, x):
    signs = [v > 0 for v in (value(p, x) for p in chain) if v != 0]
    return sum(a != b for a, b in zip(signs, signs[1:]))


def roots_between(p, low, high):
    """How many distinct roots lie in the open interval."""
    return counted(tuple(p), low, high)


@functools.lru_cache(1 << 16)  # rows of one scene have the times of others, and each is read in several files
def counted(p, low, high):
    if low >= high:
        return 0
    while value(p, low) == 0 or value(p, high) == 0:
        p = divided(p, low if value(p, low) == 0 else high)
    chain = sturm(p)
    return changes(chain, low) - changes(chain, high)


def divided(p, r):
    """p / (t - r), r being a root."""
    out, carry = [], F(0)
    for c in reversed(p):
        carry = carry * r + c
        out.append(carry)
    return out[-2::-1]


def times_polynomial(p, q):
    out = [F(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] += a * b
    return out


def parse_polynomial(text):
    """A sum of terms such as 3*t^2, -t, 5, (2*t - 1)^2; brackets may be nested."""
    tokens = re.findall(r"\d+|[t()*^+-]", text)
    if "".join(tokens) != text.replace(" ", ""):
        raise ValueError(f"{text} is no polynomial in t")

    def factor():
        token = tokens.pop(0)
        if token == "(":
            base = total()
            tokens.pop(0)
        else:
            base = [F(0), F(1)] if token == "t" else [F(int(token))]
        out = base
        if tokens[:1] == ["^"]:
            tokens.pop(0)
            out = [F(1)]
            for _ in range(int(tokens.pop(0))):
                out = times_polynomial(out, base)
        return out

    def term():
        sign = F(1)
        while tokens[0] in "+-":
            sign = -sign if tokens.pop(0) == "-" else sign
        out = [sign * c for c in factor()]
        while tokens[:1] == ["*"]:
            tokens.pop(0)
            out = times_polynomial(out, factor())
        return out

    def total():
        out = term()
        while tokens and tokens[0] in "+-":
            more = term()
            wide = max(len(out), len(more))
            out, more = (p + [F(0)] * (wide - len(p)) for p in (out, more))
            out = [a + b for a, b in zip(out, more)]
        return out

    out = trim(total())
    if tokens or len(out) < 2:
        raise ValueError(f"{text} is no polynomial in t of degree 1 or more")
    return out


def parse_time(text):
    """A TIME of a README: a ratio or root(POLYNOMIAL, a, b)."""
    if not text.startswith("root("):
        return None, F(text), F(text)
    polynomial, low, high = (part.strip() for part in text[5:].rstrip(")").rsplit(",", 2))
    p, low, high = parse_polynomial(polynomial), F(low), F(high)
    if roots_between(p, low, high) != 1:
        raise ValueError(f"{text}: not exactly one root in the open interval")
    return p, low, high


def given_time(time):
    """A TIME of JSON Lines: text of a ratio, or an object with poly, lo, hi."""
    if isinstance(time, str):
        return None, F(time), F(time)
    p, low, high = [F(c) for c in time["poly"]], F(time["lo"]), F(time["hi"])
    if roots_between(p, low, high) != 1:
        raise ValueError(f"{time}: not exactly one root in the open interval")
    return p, low, high


def same_time(got, want):
    """Is the time `got` (whose polynomial, if any, is irreducible) the time `want`?"""
    p, low, high = want
    if p is None or got[0] is None:
        if p is None:
            return got == want
        return low < got[1] < high and value(p, got[1]) == 0
    common = max(low, got[1]), min(high, got[2])
    return not remainder(p, got[0]) and roots_between(got[0], *common) == 1


def same_root(got, want):
    """Is the one root of a squarefree polynomial in an interval that of another?"""
    p, q = trim(list(got[0])), trim(list(want[0]))
    while q:
        p, q = q, remainder(p, q)
    low, high = max(got[1], want[1]), min(got[2], want[2])
    return len(p) > 1 and roots_between(p, low, high) == 1
