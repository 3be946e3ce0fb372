"""Integer polynomials and their real roots, exactly: the arithmetic of the second tracer.

SPDX-License-Identifier: GPL-3.0-or-later

A polynomial is a list of ints, lowest power first, without trailing zeros; [] is zero. Roots are
isolated by Sturm sequences, a method the program under test does not use. Invariant of Root: it
is rational (`value` set), or `poly` is squarefree, has exactly one root in the open interval
(lo, hi), and none at lo or hi.
"""
from exact import Fraction, to_double
from functools import cmp_to_key
from math import gcd


def trim(p):
    while p and p[-1] == 0:
        p.pop()
    return p


def add(p, q):
    if len(p) < len(q):
        p, q = q, p
    r = list(p)
    for k, c in enumerate(q):
        r[k] += c
    return trim(r)


def scale(p, c):
    return [c * a for a in p] if c else []


def sub(p, q):
    return add(p, scale(q, -1))


def mul(p, q):
    if not p or not q:
        return []
    r = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        if a:
            for j, b in enumerate(q):
                r[i + j] += a * b
    return trim(r)


def power(p, n):
    r = [1]
    for _ in range(n):
        r = mul(r, p)
    return r


def derivative(p):
    return trim([k * c for k, c in enumerate(p)][1:])


def content(p):
    g = 0
    for c in p:
        g = gcd(g, c)
        if g == 1:
            break
    return g


def reduced(p):
    """p divided by its positive content: the sign of every value is kept."""
    g = content(p)
    return [c // g for c in p] if g > 1 else p


def primitive(p):
    """Positive leading coefficient, content 1."""
    p = reduced(p)
    return [-c for c in p] if p and p[-1] < 0 else p


def remainder(p, q):
    """A positive multiple of the remainder of p by q."""
    r, lead, sign = list(p), abs(q[-1]), 1 if q[-1] > 0 else -1
    while len(r) >= len(q):
        top, shift = r[-1] * sign, len(r) - len(q)
        r = [c * lead for c in r]
        for k, c in enumerate(q):
            r[k + shift] -= top * c
        trim(r)
    return reduced(r)


def common(p, q):
    """Greatest common divisor, primitive."""
    p, q = primitive(p), primitive(q)
    while q:
        p, q = q, primitive(remainder(p, q))
    return p


def quotient(p, q):
    """p / q where q divides p over the rationals; primitive."""
    p = [Fraction(c) for c in p]
    out = [Fraction(0)] * (len(p) - len(q) + 1)
    for shift in range(len(out) - 1, -1, -1):
        out[shift] = p[shift + len(q) - 1] / q[-1]
        for k, c in enumerate(q):
            p[k + shift] -= out[shift] * c
    if any(p):
        raise ArithmeticError("quotient: not a divisor")
    return primitive(integral(out))


def integral(p):
    """Fractions to ints by a positive factor."""
    den = 1
    for c in p:
        c = Fraction(c)
        den = den * c.denominator // gcd(den, c.denominator)
    return trim([int(c * den) for c in p])


def sign(x):
    return (x > 0) - (x < 0)


def value(p, x):
    """p(x) for a Fraction."""
    return Fraction(scaled_value(p, x), x.denominator ** max(len(p) - 1, 0))


def scaled_value(p, x):
    """p(x) times the positive denominator of x to the degree of p."""
    a, b, r, f = x.numerator, x.denominator, 0, 1
    for c in reversed(p):
        r = r * a + c * f
        f *= b
    return r


def sign_at(p, x):
    return sign(scaled_value(p, x))


def squarefree(p):
    d = derivative(p)
    if not d:
        return primitive(p)
    g = common(p, d)
    return primitive(p) if len(g) == 1 else quotient(p, g)


def substitute(p, num, den, degree):
    """The numerator of p(num/den) over den^degree, degree >= deg p."""
    out, a = [], [1]
    dens = [[1]]
    for _ in range(degree):
        dens.append(mul(dens[-1], den))
    for k, c in enumerate(p):
        out = add(out, scale(mul(a, dens[degree - k]), c))
        a = mul(a, num)
    return out


def sturm_chain(p):
    chain = [p, derivative(p)]
    while len(chain[-1]) > 1:
        r = remainder(chain[-2], chain[-1])
        chain.append([-c for c in r])
    return [q for q in chain if q]


def variations(chain, x):
    signs = [s for s in (sign_at(q, x) for q in chain) if s]
    return sum(a != b for a, b in zip(signs, signs[1:]))


class Root:
    __slots__ = ("poly", "lo", "hi", "value", "rising")

    def __init__(self, value=None, poly=None, lo=None, hi=None):
        self.value, self.poly, self.lo, self.hi = value, poly, lo, hi
        if value is None:
            self.rising = sign_at(poly, hi)

    def refine(self):
        mid = (self.lo + self.hi) / 2
        s = sign_at(self.poly, mid)
        if s == 0:
            self.value = mid
        elif s == self.rising:
            self.hi = mid
        else:
            self.lo = mid

    def bounds(self):
        return (self.value, self.value) if self.value is not None else (self.lo, self.hi)

    def narrow(self, width):
        while self.value is None and self.hi - self.lo > width:
            self.refine()

    def settle(self):
        """Find out whether the root is rational: a rational root has the leading coefficient
        as a multiple of its denominator, so that a narrow interval leaves one candidate."""
        lead = abs(self.poly[-1]) if self.value is None else 1
        self.narrow(Fraction(1, 2 * lead))
        if self.value is None:
            near = Fraction(round((self.lo + self.hi) / 2 * lead), lead)
            if self.lo < near < self.hi and sign_at(self.poly, near) == 0:
                self.value = near
        return self.value

    def sign_of(self, q):
        """Sign of the polynomial q at the root."""
        if not q:
            return 0
        if self.value is None:
            g = common(self.poly, q)
            if len(g) > 1 and sign_at(g, self.lo) * sign_at(g, self.hi) < 0:
                return 0
            chain = sturm_chain(squarefree(q))
            while self.value is None and (
                    sign_at(q, self.lo) == 0
                    or variations(chain, self.lo) != variations(chain, self.hi)):
                self.refine()
        return sign_at(q, self.value if self.value is not None else self.hi)

    def __float__(self):
        self.narrow(Fraction(1, 2 ** 60))
        a, b = self.bounds()
        return to_double((a + b) / 2)


def same(x, y):
    """Are two roots one number? Their intervals are known to meet."""
    if x.value is not None and y.value is not None:
        return x.value == y.value
    if x.value is not None:
        x, y = y, x
    if y.value is not None:
        return x.lo < y.value < x.hi and sign_at(x.poly, y.value) == 0
    lo, hi = max(x.lo, y.lo), min(x.hi, y.hi)
    if lo >= hi:
        return False
    g = common(x.poly, y.poly)
    return len(g) > 1 and sign_at(g, lo) * sign_at(g, hi) < 0


def compare(x, y):
    if x is y:
        return 0
    equal = None
    while True:
        (a, b), (c, d) = x.bounds(), y.bounds()
        if b < c or (b == c and (x.value is None or y.value is None)):
            return -1
        if d < a or (d == a and (x.value is None or y.value is None)):
            return 1
        if equal is None:
            equal = same(x, y)
        if equal:
            return 0
        if x.value is None:
            x.refine()
        if y.value is None:
            y.refine()


def roots(p, a, b):
    """All real roots of p (not zero) in [a, b], ascending."""
    if len(p) < 2:
        return []
    q = squarefree(p)
    out = []
    for end in {a, b}:
        if sign_at(q, end) == 0:
            out.append(Root(value=end))
            q = quotient(q, [-end.numerator, end.denominator])
    if len(q) > 1 and a < b:
        chain = sturm_chain(q)
        isolate(out, q, chain, a, b, variations(chain, a), variations(chain, b))
    return sort_roots(out)


def isolate(out, q, chain, a, b, va, vb):
    if va == vb:
        return
    if va - vb == 1:
        if len(q) == 2:
            out.append(Root(value=Fraction(-q[0], q[1])))
        else:
            out.append(Root(poly=q, lo=a, hi=b))
        return
    mid = (a + b) / 2
    cut = Fraction(1, 3)
    while sign_at(q, mid) == 0:      # an end point must not be a root
        mid = a + (b - a) * cut
        cut /= 2
    vm = variations(chain, mid)
    isolate(out, q, chain, a, mid, va, vm)
    isolate(out, q, chain, mid, b, vm, vb)


def sort_roots(items):
    """Ascending, each number once."""
    out = []
    for r in sorted(items, key=cmp_to_key(compare)):
        if not out or compare(out[-1], r):
            out.append(r)
    return out


def between(x, y):
    """A rational strictly between x < y."""
    while True:
        b, c = x.bounds()[1], y.bounds()[0]
        if b < c:
            return (b + c) / 2
        if b == c and x.value is None and y.value is None:
            return b
        if x.value is None:
            x.refine()
        if y.value is None:
            y.refine()


def factor_degrees(p, prime):
    """Degrees of the irreducible factors of p modulo a prime, None if p drops degree or is not
    squarefree there."""
    def mod(a):
        return trim([c % prime for c in a])

    def rem(a, b):
        a, inv = list(a), pow(b[-1], -1, prime)
        while len(a) >= len(b):
            f, shift = a[-1] * inv % prime, len(a) - len(b)
            for k, c in enumerate(b):
                a[k + shift] = (a[k + shift] - f * c) % prime
            trim(a)
        return a

    def div(a, b):
        a, inv, out = list(a), pow(b[-1], -1, prime), [0] * (len(a) - len(b) + 1)
        while len(a) >= len(b):
            f, shift = a[-1] * inv % prime, len(a) - len(b)
            out[shift] = f
            for k, c in enumerate(b):
                a[k + shift] = (a[k + shift] - f * c) % prime
            trim(a)
        return out

    def gcd_mod(a, b):
        while b:
            a, b = b, rem(a, b)
        return a

    f = mod(p)
    if len(f) != len(p) or len(gcd_mod(f, mod(derivative(p)))) > 1:
        return None
    out, h, d = [], [0, 1], 0
    while len(f) > 1:
        d += 1
        if 2 * d > len(f) - 1:
            return out + [len(f) - 1]
        h, base, e = [1], rem(h, f), prime
        while e:
            if e & 1:
                h = rem(mod(mul(h, base)), f)
            base = rem(mod(mul(base, base)), f)
            e >>= 1
        g = gcd_mod(f, mod(sub(h, [0, 1])))
        out += [d] * ((len(g) - 1) // d)
        f = div(f, g)
        h = rem(h, f) if len(f) > 1 else h
    return out


def surely_irreducible(p):
    """True if the factor degrees modulo small primes leave no proper factor; False if that is
    not seen (which proves nothing)."""
    n, possible = len(p) - 1, None
    for prime in (5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61):
        degrees = factor_degrees(p, prime)
        if degrees is None:
            continue
        sums = {0}
        for d in degrees:
            sums |= {s + d for s in sums}
        possible = sums if possible is None else possible & sums
        if possible == {0, n}:
            return True
    return False
