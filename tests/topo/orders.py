#!/usr/bin/env python3
# suite
"""Roofs and flat tops that pass a point of space with higher orders: positions that hang on leading terms, derived.

SPDX-License-Identifier: GPL-3.0-or-later

Parts pass the origin one after the other, the parameter s from -1 to 1. A roof with its ridge along y moves by
(s^m, 0, k s^(m + 1)), m odd, and tilts about x by the angle 2 atan(w s / 2): its ridge draws z = x^(1/m) (k x + w y) to
leading order, 1 + 1/m, and what it covers is below. A flat top moves by (0, 0, -a s^n), n even, and tilts about x: it covers
what is below z = w s y - a s^n for all s, that is below c |y|^(1 + 1/m) with m = n - 1 and c^m = (m / n)^m w^n / (n a).
Parts above are turned over. With the maximum of u (k u + w)^m, k < 0, which is at u = -w / ((m + 1) k):

  two roofs of one m, below (k, w) with its ridge along y, above (l, 0) with its ridge along x: interior if and only if k > 0 > l and
  (-l)^m (m + 1)^(m + 1) k > m^m w^(m + 1); on the boundary if < holds or k < 0 or l > 0;
  a flat top below, of order m + 1, and a roof above (l, w') with its ridge along y: interior if l < 0 and
  c^m (m + 1)^(m + 1) (-l) > m^m w'^(m + 1), on the boundary if < holds or l > 0;
  a flat top below of order n and a roof above (l, 0) of another m, its ridge along y: interior if l < 0, boundary if l > 0.

A linear map is applied to all, so that nothing is along an axis.
"""
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import Fraction as F  # noqa: E402
from prisms import BACK, MAP, Text, mapped  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from solids import Mesh, block, inside_out, joined, prism, ring  # noqa: E402
from witnesses import check_witness  # noqa: E402

TINY = F(1, 2 ** 100)
SCENES = 14
SCALES = (30, 60, 110)
APART = 40  # between two parts, along z


def ridge_along_y():
    """A prism whose cross section in x, z is a triangle with its tip at the origin."""
    tip = prism(ring((0, 0), (-1, -2), (1, -2)), -3, 3)
    return inside_out(Mesh([(x, z, y) for x, y, z in tip.vertices], tip.facets))


class Part:
    """A part at the origin with its way: the powers and factors of its path, and its tilt. One that `ends` goes straight
    down or up from the origin."""

    def __init__(self, mesh, axis, path, tilt, below):
        self.mesh = mesh if below else inside_out(Mesh([(x, y, -z) for x, y, z in mesh.vertices], mesh.facets))
        self.axis, self.below = axis, below
        self.path = path  # [(factor, power)] of s for x, y, z
        self.tilt = tilt if below else -tilt
        self.ends = False


def roof(along, m, k, w, below=True):
    """Its ridge along y or x; what it draws above is that of below with k and w."""
    mesh, sign = ridge_along_y(), 1 if below else -1
    if along == "y":
        return Part(mesh, [1, 0, 0], [(1, m), (0, 0), (k, m + 1)], sign * w, below)
    turned = Mesh([(y, -x, z) for x, y, z in mesh.vertices], mesh.facets)
    return Part(turned, [0, -1, 0], [(0, 0), (1, m), (k, m + 1)], sign * w, below)


def flat(n, a, w):
    return Part(block(-3, -3, -2, 3, 3, 0), [1, 0, 0], [(0, 0), (0, 0), (-a, n)], w, True)


def value(path, s):
    return [F(f) * F(s) ** p for f, p in path]


def written(path, s):
    return [f"({F(f)})*({s})^{p}" if f else "0" for f, p in path]


def scene(parts):
    """The parts along z, and the motion: M p = R (p - home) + T, R the tilt, T the path; between two passes T goes around
    the parts, and the tilt comes and goes where T stands still, far away."""
    mesh = joined(*(Mesh([(x, y, z + APART * j) for x, y, z in part.mesh.vertices], part.mesh.facets)
                    for j, part in enumerate(parts)))
    mesh = Mesh([mapped(v) for v in mesh.vertices], mesh.facets)
    rows = {"matrix": [[*row, 0] for row in BACK]}, {"matrix": [[*row, 0] for row in MAP]}
    pieces, t, at = [], 0, [F(30), F(30), F(0)]

    def piece(part, home, half, path, length):
        nonlocal t
        pieces.append({"t": [t, t + length], "transform": {"compose": [
            rows[0], {"translate": [0, 0, -home]}, {"rotate": {"tan_half": half, "axis": part.axis}},
            {"translate": path}, rows[1]]}})
        t += length

    def leg(part, home, half, to):
        nonlocal at
        piece(part, home, f"({half})", [f"({p})+({q - p})*(t-({t}))" for p, q in zip(at, to)], 1)
        at = list(to)

    for j, part in enumerate(parts):
        home, half = APART * j, F(part.tilt) / 2
        side, stop = (-10 if part.below else 10), (0 if part.ends else 1)
        leg(part, home, F(0), [F(30), F(30), F(side)])
        piece(part, home, f"({-half})*(t-({t}))", [str(x) for x in at], 1)
        first, last = value(part.path, -1), value(part.path, stop)
        leg(part, home, -half, [first[0], first[1], F(side)])
        leg(part, home, -half, first)
        piece(part, home, f"({half})*(t-({t + 1}))", written(part.path, f"t-({t + 1})"), 1 + stop)
        at, here = last, half * stop
        leg(part, home, here, [last[0], last[1], F(side)])
        leg(part, home, here, [F(30), F(30), F(side)])
        piece(part, home, f"({here})*({t + 1}-t)", [str(x) for x in at], 1)
        at[2] += APART  # seen from the next part's home
    return mesh, Text({"dimension": 3, "pieces": pieces})


def sign(x):
    return (x > 0) - (x < 0)


def two_roofs(m, k, w, l):
    order = sign((-l) ** m * (m + 1) ** (m + 1) * k - m ** m * w ** (m + 1)) if k > 0 > l else -1
    if k == 0 or l == 0:
        order = 0
    low = lambda x, y: x * (k * x ** m + w * y ** m)  # noqa: E731: at (x^m, y^m)
    high = lambda x, y: l * y ** (m + 1)  # noqa: E731
    return [roof("y", m, k, w), roof("x", m, l, F(0), False)], order, low, high, m


def flat_and_roof(m, a, w, l, w2):
    """The flat top's height at (x^m, y^m) is c |y|^(m + 1), and c^m = `bulge`; z is tried for a c below it."""
    n = m + 1
    bulge = F(m, n) ** m * w ** n / (n * a)
    order = sign(bulge * n ** n * -l - m ** m * w2 ** n) if l < 0 else -1
    c = F(m, n) * abs(w)
    while c ** m > bulge:
        c = c * 63 / 64
    low = lambda x, y: c * abs(y) ** n  # noqa: E731
    high = lambda x, y: x * (l * x ** m + w2 * y ** m)  # noqa: E731
    return [flat(n, a, w), roof("y", m, l, w2, False)], order if l else 0, low, high, m


def mixed(n, a, w, m, l):
    return [flat(n, a, w), roof("y", m, l, F(0), False)], -sign(l), None, None, m


def chosen(args):
    """(number, scene): a scene with what decides it: 1 interior, -1 boundary, 0 on the edge between."""
    rng, derived = args.random, []
    for m, k, w in ((3, F(1, 16), F(1, 8)), (1, F(1, 16), F(1, 8)), (5, F(1, 16), F(1, 8))):
        # (-l)^m k (m + 1)^(m + 1) = m^m w^(m + 1) where l is rational: m = 1 alone; else on both sides of the root
        root = F(m ** m) * w ** (m + 1) / ((m + 1) ** (m + 1) * k)
        low, high = F(0), F(1)
        for _ in range(120):
            middle = (low + high) / 2
            low, high = (middle, high) if middle ** m <= root else (low, middle)
        for l in (low - TINY, high + TINY):
            derived.append(two_roofs(m, k, w, -l))
    yield from enumerate(derived if args.derived else [])
    number = lambda n: F(rng.randint(-2, n), 64)  # noqa: E731
    for k in args.rounds(SCENES, "one order"):
        m = rng.choice((1, 3, 3, 3, 5))
        yield len(derived) + 3 * k, two_roofs(m, number(6), number(6), -number(6))
        yield len(derived) + 3 * k + 1, flat_and_roof(m, F(rng.randint(16, 40), 32), F(rng.randint(1, 12), 32), -number(6), number(6))
    for k, (n, m) in args.cycle(((4, 1), (6, 1), (6, 3), (4, 1), (6, 3)), 1, "mixed"):
        yield len(derived) + 3 * k + 2, mixed(n, F(1, 2), F(1, 4), m, -number(6) or F(-1, 64))


def probes(low, high, m, e):
    """Places at the distance e^m along several directions: below, between and above what both draw."""
    for x, y in ((1, 0), (0, 1), (1, 1), (1, -1), (2, 1), (1, 2), (2, -1), (-1, 2), (-1, -1), (-2, 1)):
        below, above = low(F(x), F(y)), high(F(x), F(y))
        for z in ((below + above) / 2, below, above, F(0)):
            yield mapped((F(x) ** m * e ** m, F(y) ** m * e ** m, z * e ** (m + 1)))


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    seen = Counter()
    by_path = 0
    wants = {1: "interior", -1: "boundary"}
    for number, (parts, order, low, high, m) in chosen(args):
        solid, motion = scene(parts)
        answers = graze.classify(f"orders {number}", solid, motion, [mapped((F(0), F(0), F(0)))], "--topo")
        if not answers:
            continue
        record, want = answers[0].record, wants.get(order)
        where = (number, [(str(p.path), str(p.tilt)) for p in parts], record["word"], record.get("topo_level"))
        checks.equal(record["pmc"], "on", *where)
        seen[m, want, record["topo"], record.get("topo_level")] += 1
        if want == "interior":
            checks.equal(record["topo"], want, *where, record.get("topo_reason"))
        elif want:
            checks.holds(record["topo"] in (want, "undecided"), *where, record["topo"])
        if record["topo"] == "boundary":
            check_witness(checks, graze, f"orders {number}", (solid, motion), mapped((F(0), F(0), F(0))), record)
            by_path += record["topo_level"] == "leading_terms" and record["topo_order"] > 1
        if want == "interior" and low:
            places = [p for s in SCALES for p in probes(low, high, m, F(1, 2 ** s))]
            found = graze.classify(f"probes {number}", solid, motion, places) or []
            checks.equal({a.record["pmc"] for a in found} - {"in", "on"}, set(), *where, "probes that are out")
    for key, count in sorted(seen.items(), key=str):
        print(*key, count)
    by_terms = sum(n for key, n in seen.items() if key[0] > 1 and key[2:] == ("interior", "leading_terms"))
    checks.holds(by_terms > 5 * args.share, f"{by_terms} are interior by terms of higher orders")
    checks.holds(by_path > 10 * args.share, f"{by_path} are boundary with a path of a higher order")
    checks.finish()


if __name__ == "__main__":
    main()
