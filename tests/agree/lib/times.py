"""TIMEs of JSON Lines: their value as a Root, and every clause of their canonical form.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from exact import Fraction as F

from algebra import Root, common, content, sign_at, squarefree, sturm_chain, surely_irreducible
from algebra import variations


def irrational(time):
    return not isinstance(time, str)


def polynomial(time):
    return [int(c) for c in time["poly"]]


def time_root(time):
    if isinstance(time, str):
        return Root(value=F(time))
    return Root(poly=polynomial(time), lo=F(time["lo"]), hi=F(time["hi"]))


def time_is(time, root):
    """Is a TIME the number `root` of the second tracer? Its polynomial must divide the root's."""
    if isinstance(time, str):
        x = F(time)
        if root.value is not None:
            return root.value == x
        return root.lo < x < root.hi and sign_at(root.poly, x) == 0
    if root.value is not None:
        return False
    p = polynomial(time)
    lo, hi = max(F(time["lo"]), root.lo), min(F(time["hi"]), root.hi)
    g = common(p, root.poly)
    return lo < hi and len(g) == len(p) and sign_at(g, lo) * sign_at(g, hi) < 0


def negated(time):
    """The TIME of -t, in canonical form."""
    if isinstance(time, str):
        return str(-F(time))
    p = [c if k % 2 == 0 else -c for k, c in enumerate(polynomial(time))]
    p = [-c for c in p] if p[-1] < 0 else p
    text = time["approx"]
    return {"poly": [str(c) for c in p], "lo": str(-F(time["hi"])), "hi": str(-F(time["lo"])),
            "approx": text[1:] if text.startswith("-") else "-" + text}


def check_canonical(checks, time, *where):
    """Form of a TIME. Returns False where irreducibility could not be seen modulo small primes
    (it is then left unchecked, and counted by the caller)."""
    if isinstance(time, str):
        x = F(time)
        return checks.equal(str(x), time, *where, "lowest terms")
    p, lo, hi = polynomial(time), F(time["lo"]), F(time["hi"])
    checks.holds(len(p) > 2 and p[-1] > 0 and content(p) == 1, *where, "primitive", time)
    checks.equal([str(lo), str(hi)], [time["lo"], time["hi"]], *where, "lowest terms")
    width = hi - lo
    dyadic = width.numerator == 1 and width.denominator & (width.denominator - 1) == 0
    checks.holds(dyadic and (lo / width).denominator == 1, *where, "dyadic", time)
    chain = sturm_chain(squarefree(p))
    checks.equal(variations(chain, lo) - variations(chain, hi), 1, *where, "isolates", time)
    if width < 1:
        parent = lo - (lo / width) % 2 * width
        count = variations(chain, parent) - variations(chain, parent + 2 * width)
        checks.holds(count > 1, *where, "widest", time)
    check_approximation(checks, time, p, *where)
    return surely_irreducible(p)


def check_approximation(checks, time, p, *where):
    """17 significant digits, and the root within half a unit of the last one: the polynomial
    changes sign between the two half-way points (or the root is so near another one that the
    isolating interval decides)."""
    text = time["approx"]
    mantissa, _, exponent = text.lower().partition("e")
    digits = mantissa.lstrip("-").replace(".", "").lstrip("0")
    checks.equal(len(digits), 17, *where, "digits", text)
    half = F(1, 2) / 10 ** len(mantissa.partition(".")[2]) * F(10) ** int(exponent or 0)
    low, high = max(F(text) - half, F(time["lo"])), min(F(text) + half, F(time["hi"]))
    checks.holds(low < high and sign_at(p, low) * sign_at(p, high) < 0, *where, "rounding", text)
