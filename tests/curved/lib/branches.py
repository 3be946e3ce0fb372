"""Germs in the plane that are made of known branches, and what they decide: a second method for proofs/curved.md C126.

SPDX-License-Identifier: GPL-3.0-or-later

Each curve comes with all its branches through the origin as polynomials in a parameter s, exact ones. The sign of another curve
along a branch is that of its first term in s. Each sector between neighbouring branches lies beside one of them, so the patterns
that occur are those beside branches: both signs of the branch's own curve, with the signs of the others along it.
"""
import itertools

from scenes import F


class Poly(dict):
    """Coefficients by exponents, tuples."""

    def __add__(self, other):
        out = type(self)(self)
        for key, value in other.items():
            out[key] = out.get(key, 0) + value
        return type(self)({k: v for k, v in out.items() if v})

    def __mul__(self, other):
        out = type(self)()
        for a, u in self.items():
            for b, v in other.items():
                key = tuple(i + j for i, j in zip(a, b))
                out[key] = out.get(key, 0) + u * v
        return type(self)({k: v for k, v in out.items() if v})

    def times(self, factor):
        return type(self)({k: v * factor for k, v in self.items() if factor})

    def degree(self):
        return max(map(sum, self), default=0)

    def into(self, x, y, one):
        """The value at x, y, polynomials of one kind, whose constant 1 is `one`."""
        out = Poly()
        for (i, j), c in self.items():
            term = one.times(c)
            for factor in [x] * i + [y] * j:
                term = term * factor
            out = out + term
        return out


def line(*coefficients):
    """A polynomial in s from its coefficients."""
    return Poly({(k,): F(c) for k, c in enumerate(coefficients) if c})


def plane(**terms):
    """A polynomial in x, y: x2y1=3 is 3 x^2 y."""
    return Poly({(int(k[1]), int(k[3])): F(c) for k, c in terms.items() if c})


ONE = line(1)
X, Y, UNIT = plane(x1y0=1), plane(x0y1=1), plane(x0y0=1)


def power(a, b, c):
    """y^a = c x^b, a and b coprime: x = c^m s^a, y = c^n s^b with a n = b m + 1."""
    m = next(m for m in range(a) if (b * m + 1) % a == 0)
    return plane(**{f"x0y{a}": 1, f"x{b}y0": -c}), [(Poly({(a,): F(c) ** m}), Poly({(b,): F(c) ** ((b * m + 1) // a)}))]


def node(k):
    """y^2 = x^2 (1 + k x): y = u x, u^2 = 1 + k x, through the origin at u = 1 and u = -1."""
    out = []
    for u in (1, -1):
        x = line(0, 2 * u, 1).times(1 / k)
        out.append((x, line(u, 1) * x))
    return plane(x0y2=1, x2y0=-1, x3y0=-k), out


def tacnode():
    """(x^2 - y)^2 = y^3: x = m (m^2 - 1), y = (m^2 - 1)^2, at m = 1 and m = -1."""
    out = []
    for m in (1, -1):
        w = line(0, 2 * m, 1)
        out.append((line(m, 1) * w, w * w))
    return plane(x4y0=1, x2y1=-2, x0y2=1, x0y3=-1), out


def alone(rng):
    """A curve with an isolated point at the origin."""
    return rng.choice([plane(x2y0=1, x0y2=1, x3y0=1), plane(x4y0=1, x0y2=1), plane(x2y0=-1, x0y2=-2), plane(x2y0=1, x1y1=1, x0y2=1)]), []


def some_curve(rng):
    c = rng.choice([-2, -1, 1, 1, 2])
    kind = rng.randrange(12)
    if kind < 3:
        return power(1, 1, rng.choice([-3, -1, 1, 2, 5]))
    if kind < 5:
        return power(1, 2, c)
    if kind < 8:
        return power(*rng.choice([(2, 3), (2, 3), (3, 4), (3, 2), (4, 3), (3, 1), (2, 1), (1, 3), (1, 4), (4, 1)]), c)
    if kind < 9:
        return plane(x1y0=1), [(line(), line(0, 1))]
    if kind == 9:
        return node(F(rng.choice([-2, -1, 1, 3])))
    return tacnode() if kind == 10 else alone(rng)


def turned(curve, rng):
    """A curve after an invertible linear map of the plane: f(A v), and its branches by A's inverse."""
    f, branches = curve
    if rng.random() < 0.4:
        return curve
    a, b, c, d = (rng.randint(-2, 2) for _ in range(4))
    if a * d == b * c:
        return curve
    det = F(a * d - b * c)
    g = f.into(X.times(a) + Y.times(b), X.times(c) + Y.times(d), UNIT)
    return g, [(x.times(d / det) + y.times(-b / det), x.times(-c / det) + y.times(a / det)) for x, y in branches]


def sign_of_first(p):
    """The sign for small s > 0 of a polynomial in s; 0 for the zero polynomial."""
    return 0 if not p else 1 if p[min(p)] > 0 else -1


def along(curves, x, y):
    return [sign_of_first(f.into(x, y, ONE)) for f, _ in curves]


def halves(x, y):
    """Both half branches of one branch."""
    return [tuple(Poly({k: v * way ** k[0] for k, v in p.items()}) for p in (x, y)) for way in (1, -1)]


def patterns(curves):
    """The patterns near the origin; None where a curve contains a branch of another one."""
    out = set()
    for k, (_, branches) in enumerate(curves):
        for half in itertools.chain.from_iterable(halves(*b) for b in branches):
            signs = along(curves, *half)
            if signs[k] != 0 or signs.count(0) > 1:
                return None
            out |= {tuple(signs[:k] + [s] + signs[k + 1:]) for s in (1, -1)}
    return out or {tuple(along(curves, line(0, 3), line(0, 7)))}


def state(signs_that_occur, truth):
    values = {truth(s) for s in signs_that_occur}
    return "B" if len(values) == 2 else "I" if True in values else "O"


def gap(curves, half, truth):
    """The state along a half path: beside it if it runs in a curve."""
    signs = along(curves, *half)
    return state([tuple(s or w for s in signs) for w in (1, -1)], truth)


PLACES = {   # by name: x, y of the plane in which the curves are drawn, and the time and path that lead to the point
    "rational": (X, Y, F(0), None),
    "root of 2": (plane(x2y0=1, x0y0=-2), Y, F(141421356237, 10 ** 11), None),
    # At t = root 2 + root 3 t^3 is 11 root 2 + 9 root 3.
    "roots of 2 and 3": (plane(x2y0=1, x0y0=-2), plane(x0y2=1, x0y0=-3), F(314626436994, 10 ** 11), ("(t^3-9*t)/2", "(11*t-t^3)/2")),
}


def drawn(rng, name, count):
    """Curves that at a place have degree 4 at most, each with what it is there."""
    x, y, _, _ = PLACES[name]
    out = []
    while len(out) < count:
        curve = turned(some_curve(rng), rng)
        there = curve[0].into(x, y, UNIT)
        if there.degree() <= 4 and all(f != curve[0] for (f, _), _ in out):
            out.append((curve, there))
    return out


def tree(rng, nodes):
    """A Boolean expression over all nodes, each used once: text for a file, and its truth by signs."""
    if len(nodes) == 1:
        (k, node), = nodes
        return node, lambda signs: signs[k] < 0
    cut = rng.randint(1, len(nodes) - 1)
    parts = [tree(rng, nodes[:cut]), tree(rng, nodes[cut:])]
    (left, a), (right, b) = parts
    name, truth = rng.choice([("union", lambda s: a(s) or b(s)), ("intersection", lambda s: a(s) and b(s)),
                              ("intersection", lambda s: a(s) and b(s)), ("difference", lambda s: a(s) and not b(s))])
    return {name: [left, right]}, truth
