#!/usr/bin/env python3
# suite
"""Several passes through one point, all tangent to one line: positions that hang on second order.

SPDX-License-Identifier: GPL-3.0-or-later

Parts of a solid pass the origin one after the other while it moves by b = -v - (s, a s^2), s from -1 to 1: part v's tip
(or flat side) is at the origin at s = 0. A tip draws y = -a x^2; a part above it covers what is above that curve near
the origin, a part below it what is below. A flat side needs a < 0 above (a > 0 below), and covers its half-plane:
coefficient 0. With h the largest coefficient of the parts below and g the least of those above, the origin is interior
if and only if both sorts are there and h >= g. Coefficients are also taken 2^-100 apart.
The same as sheared prisms in space are decided by a section across them, but for a few of too high degree.

A part may also turn while it passes, by the angle 2 atan(w s) at c = v + (s, 0): its tip then draws -s (cos, sin), to
second order y = -2 w x^2. A flat side that turns at c = v + (s, a s^2) is the line Y cos - X sin + a s^2 = 0; what it
covers above is bounded by y = -(w^2 / |a|) x^2 to second order. These have terms of fourth order, so their coefficients
are taken apart from all others.
"""
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from algebra import trim  # noqa: E402
from exact import Fraction as F  # noqa: E402
from motion import build, matrix  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from solids import Mesh, Polygon, joined, prism, ring  # noqa: E402

SCENES = 120
# The largest share of prisms that may be undecided.
SPACE_LEFT = 0.1
TINY = F(1, 2 ** 100)
# The parts, above the origin; those below are turned over. True: flat.
PARTS = [(ring((0, 0), (1, 2), (-1, 2)), False), (ring((0, 0), (1, 2), (-1, 3)), False),
         (ring((-3, 0), (3, 0), (3, 2), (-3, 2)), True)]
SCALES = (8, 40, 120, 400)


# Turning parts: (flat, w, a) and the coefficient above; below it is the opposite of w and a, and of the coefficient.
TURNS = [(False, F(1, 16), F(0), F(-1, 8)), (False, F(-3, 16), F(0), F(3, 8)), (False, F(5, 16), F(0), F(-5, 8)),
         (True, F(1, 4), F(-1, 5), F(-5, 16)), (True, F(3, 8), F(-1, 3), F(-27, 64))]


def turned(r):
    return [(x, -y) for x, y in reversed(r)]


def passes(rng):
    """[(ring at the origin, above, w, a, coefficient)], at most four."""
    out = []
    base = rng.choice([F(0), F(1, 2), F(-1, 2), F(1)])
    for _ in range(rng.randint(1, 4)):
        above = rng.random() < 0.5
        if rng.random() < 0.3:
            flat, w, a, q = rng.choice(TURNS)
            r = PARTS[2][0] if flat else PARTS[0][0]
            sign = 1 if above else -1
            out.append((r if above else turned(r), above, w * sign, a * sign, q * sign))
            continue
        r, flat = rng.choice(PARTS)
        a = base + rng.choice([0, 0, TINY, -TINY, F(1, 4), F(-1, 4)])
        if flat:
            a = -abs(a) - F(1, 4) if above else abs(a) + F(1, 4)
        out.append((r if above else turned(r), above, F(0), a, F(0) if flat else -a))
    return out


def path(chosen):
    """[(lo, hi, tangent of the half angle, x, y)]: M p = R (p - c) with c = (x, y), polynomials in t: the passes, and
    between them ways around the parts, on which the solid turns where c stands still."""
    at, t, pieces = (F(20), F(-20)), 0, []

    def add(tangent, x, y, length=1):
        nonlocal t
        pieces.append((t, t + length, tangent, x, y))
        t += length

    def leg(to, tangent):
        nonlocal at
        add([tangent], *([p - (q - p) * t, q - p] for p, q in zip(at, to)))
        at = to

    for k, (_, _, w, a, _) in enumerate(chosen):
        y = F(40 * k)
        leg((F(20), y - 20), F(0))
        leg((F(-20), y - 20), F(0))
        add([w * t, -w], [at[0]], [at[1]])
        leg((F(-20), y + a), -w)
        leg((F(-1), y + a), -w)
        # s = t - m on [m - 1, m + 1]
        m = t + 1
        add([-w * m, w], [F(-m), F(1)], [y + a * m * m, -2 * a * m, a], 2)
        at = (F(1), y + a)
        leg((F(20), y + a), w)
        add([w * (t + 1), -w], [at[0]], [at[1]])
    return pieces


def plus(p, q, sign=1):
    n = max(len(p), len(q))
    return [a + sign * b for a, b in zip(p + [0] * (n - len(p)), q + [0] * (n - len(q)))]


def times(p, q):
    out = [F(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] += a * b
    return out


def turn_and_move(tangent, x, y):
    """The rows of R (p - c), and their denominator."""
    square = times(tangent, tangent)
    den, cos, sin = plus([F(1)], square), plus([F(1)], square, -1), [2 * c for c in tangent]
    minus_sin = [-c for c in sin]
    moves = [plus(times(sin, y), times(cos, x), -1), [-c for c in plus(times(sin, x), times(cos, y))]]
    rows = [[cos, minus_sin, moves[0]], [sin, cos, moves[1]]]
    return [[trim(list(c)) for c in row] for row in rows], trim(list(den))


def solid_of(chosen):
    return [[(x, y + 40 * k) for x, y in part[0]] for k, part in enumerate(chosen)]


def plane_scene(chosen):
    motion = build([(lo, hi, matrix(*turn_and_move(tangent, x, y))) for lo, hi, tangent, x, y in path(chosen)])
    return Polygon([[r] for r in solid_of(chosen)]), motion


def space_scene(chosen):
    """Prisms over [-1, 1], carried by the shear (x, y, z) -> (x + z, y - x + z, z), and the motion by it too."""
    mesh = joined(*(prism(r, -1, 1) for r in solid_of(chosen)))
    sheared = Mesh([(x + z, y - x + z, z) for x, y, z in mesh.vertices], mesh.facets)
    parts = []
    for lo, hi, tangent, x, y in path(chosen):
        (first, second), den = turn_and_move(tangent, x, y)
        # with T the shear: T M T^-1, where T^-1 (x, y, z) = (x - z, y + x - 2 z, z)
        second = [plus(b, a, -1) for a, b in zip(first, second)]
        rows = []
        for a, b, c in (first, second):
            both = plus(a, b)
            up = plus([-p for p in both], b, -1)   # -a - 2 b
            rows.append([both, b, plus(up, den), c])
        rows.append([[], [], den, []])
        parts.append((lo, hi, matrix([[trim(list(p)) for p in row] for row in rows], den)))
    return sheared, build(parts)


def truth(chosen):
    above = [part[4] for part in chosen if part[1]]
    below = [part[4] for part in chosen if not part[1]]
    return "interior" if above and below and max(below) >= min(above) else "boundary"


def probes(chosen, k):
    """Points at 2^-k: along the curves between any two coefficients, beside all of them, and along the axes."""
    e = F(1, 2 ** k)
    z = sorted({part[4] for part in chosen} | {F(0)})
    z = z + [(a + b) / 2 for a, b in zip(z, z[1:])] + [z[0] - 1, z[-1] + 1]
    return [(s * e, q * e * e) for s in (1, -1) for q in z] + [(F(0), e), (F(0), -e), (e, e / 3), (-e, e / 3), (e, -e / 3),
                                                               (-e, -e / 3)]


def check_plane(checks, graze, seen, name, chosen):
    solid, motion = plane_scene(chosen)
    answers = graze.classify(name, solid, motion, [(F(0), F(0))], "--topo")
    if not answers:
        return
    record, want = answers[0].record, truth(chosen)
    where = (name, [(up, str(w), str(a), str(q)) for _, up, w, a, q in chosen], record["word"])
    checks.equal(record["pmc"], "on", *where)
    checks.equal(record["topo"], want, *where, record.get("topo_level"))
    seen["plane", want, record.get("topo_level", "undecided")] += 1
    points = [(k, p) for k in SCALES for p in probes(chosen, k)]
    found = graze.classify(name, solid, motion, [p for _, p in points]) or []
    out = {k for (k, _), answer in zip(points, found) if answer.record["pmc"] == "out"}
    checks.equal(out, set(SCALES) if want == "boundary" else set(), *where, "the scales of the probes that are out")


def check_space(checks, graze, seen, name, chosen):
    solid, motion = space_scene(chosen)
    answers = graze.classify(name + "s", solid, motion, [(F(0), F(0), F(0))], "--topo")
    if not answers:
        return
    record, want = answers[0].record, truth(chosen)
    checks.equal(record["pmc"], "on", name, "space")
    seen["space", want, record.get("topo_level", "undecided")] += 1
    checks.holds(record["topo"] in (want, "undecided"), name, "space", record["topo"], want, record["word"])


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    seen = Counter()
    for k in args.rounds(SCENES):
        chosen = passes(args.random)
        check_plane(checks, graze, seen, f"germ {k}", chosen)
        if k % 4 == 0 or args.scale > 1:
            check_space(checks, graze, seen, f"germ {k}", chosen)
    for key, n in sorted(seen.items()):
        print(*key, n)
    checks.holds(sum(n for key, n in seen.items() if key[1] == "interior") > SCENES / 10 * args.share, "few are interior")
    space = [(key[2], n) for key, n in seen.items() if key[0] == "space"]
    left = sum(n for level, n in space if level == "undecided")
    checks.holds(left <= max(1, SPACE_LEFT * sum(n for _, n in space)), f"{left} undecided in space")
    checks.finish()


if __name__ == "__main__":
    main()
