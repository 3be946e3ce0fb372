#!/usr/bin/env python3
# suite
"""Several passes through one point, all tangent to one line: positions that hang on second order.

SPDX-License-Identifier: GPL-3.0-or-later

Parts of a solid pass the origin one after the other while it moves by b = -v - (s, a s^2), s from -1 to 1: part v's tip
(or flat side) is at the origin at s = 0. A tip draws y = -a x^2; a part above it covers what is above that curve near
the origin, a part below it what is below. A flat side needs a < 0 above (a > 0 below), and covers its half-plane:
coefficient 0. With h the largest coefficient of the parts below and g the least of those above, the origin is interior
if and only if both sorts are there and h >= g. Coefficients are also taken 2^-100 apart.
The same as sheared prisms in space may be undecided there, but not wrong.
"""
import os
import sys
from collections import Counter
from fractions import Fraction as F

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))

from algebra import trim  # noqa: E402
from motion import build, translate  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from solids import Mesh, Polygon, joined, prism, ring  # noqa: E402

SCENES = 120
TINY = F(1, 2 ** 100)
# The parts, above the origin; those below are turned over. True: flat.
PARTS = [(ring((0, 0), (1, 2), (-1, 2)), False), (ring((0, 0), (1, 2), (-1, 3)), False),
         (ring((-3, 0), (3, 0), (3, 2), (-3, 2)), True)]
SCALES = (8, 40, 120, 400)


def turned(r):
    return [(x, -y) for x, y in reversed(r)]


def passes(rng):
    """[(ring at the origin, above, a, coefficient)], at most five."""
    out = []
    base = rng.choice([F(0), F(1, 2), F(-1, 2), F(1)])
    for _ in range(rng.randint(1, 4)):
        r, flat = rng.choice(PARTS)
        above = rng.random() < 0.5
        a = base + rng.choice([0, 0, TINY, -TINY, F(1, 4), F(-1, 4)])
        if flat:
            a = -abs(a) - F(1, 4) if above else abs(a) + F(1, 4)
        out.append((r if above else turned(r), above, a, F(0) if flat else -a))
    return out


def path(chosen, rng):
    """c = -b as [(lo, hi, x, y)] with polynomials in t: the passes, and legs around the parts between them."""
    at, t, pieces = None, 0, []

    def leg(to):
        nonlocal at, t
        pieces.append((t, t + 1, [at[0] - (to[0] - at[0]) * t, to[0] - at[0]],
                       [at[1] - (to[1] - at[1]) * t, to[1] - at[1]]))
        at, t = to, t + 1

    for k, (_, _, a, _) in enumerate(chosen):
        y = F(40 * k)
        if at is not None:
            for to in ((F(20), at[1]), (F(20), y - 20), (F(-20), y - 20), (F(-20), y + a), (F(-1), y + a)):
                leg(to)
        # s = t - m on [m - 1, m + 1]
        m = t + 1
        pieces.append((t, t + 2, [F(-m), F(1)], [y + a * m * m, -2 * a * m, a]))
        at, t = (F(1), y + a), t + 2
    return pieces


def solid_of(chosen):
    return [[(x, y + 40 * k) for x, y in r] for k, (r, _, _, _) in enumerate(chosen)]


def plane_scene(chosen, rng):
    motion = build([(lo, hi, translate([trim([-c for c in x]), trim([-c for c in y])]))
                    for lo, hi, x, y in path(chosen, rng)])
    return Polygon([[r] for r in solid_of(chosen)]), motion


def space_scene(chosen, rng):
    """Prisms over [-1, 1], carried by the shear (x, y, z) -> (x + z, y - x + z, z)."""
    mesh = joined(*(prism(r, -1, 1) for r in solid_of(chosen)))
    sheared = Mesh([(x + z, y - x + z, z) for x, y, z in mesh.vertices], mesh.facets)

    def minus(p, q):
        n = max(len(p), len(q))
        p, q = p + [0] * (n - len(p)), q + [0] * (n - len(q))
        return [a - b for a, b in zip(p, q)]
    motion = build([(lo, hi, translate([trim([-c for c in x]), trim([-c for c in minus(y, x)]), []]))
                    for lo, hi, x, y in path(chosen, rng)])
    return sheared, motion


def truth(chosen):
    above = [q for _, up, _, q in chosen if up]
    below = [q for _, up, _, q in chosen if not up]
    return "interior" if above and below and max(below) >= min(above) else "boundary"


def probes(chosen, k):
    """Points at 2^-k: along the curves between any two coefficients, beside all of them, and along the axes."""
    e = F(1, 2 ** k)
    z = sorted({q for _, _, _, q in chosen} | {F(0)})
    z = z + [(a + b) / 2 for a, b in zip(z, z[1:])] + [z[0] - 1, z[-1] + 1]
    return [(s * e, q * e * e) for s in (1, -1) for q in z] + [(F(0), e), (F(0), -e), (e, e / 3), (-e, e / 3), (e, -e / 3),
                                                               (-e, -e / 3)]


def check_plane(checks, graze, seen, name, chosen, rng):
    solid, motion = plane_scene(chosen, rng)
    answers = graze.classify(name, solid, motion, [(F(0), F(0))], "--topo")
    if not answers:
        return
    record, want = answers[0].record, truth(chosen)
    where = (name, [(up, str(a), str(q)) for _, up, a, q in chosen], record["word"])
    checks.equal(record["pmc"], "on", *where)
    checks.equal(record["topo"], want, *where, record.get("topo_level"))
    seen["plane", want, record.get("topo_level", "undecided")] += 1
    points = [(k, p) for k in SCALES for p in probes(chosen, k)]
    found = graze.classify(name, solid, motion, [p for _, p in points]) or []
    out = {k for (k, _), answer in zip(points, found) if answer.record["pmc"] == "out"}
    checks.equal(out, set(SCALES) if want == "boundary" else set(), *where, "the scales of the probes that are out")


def check_space(checks, graze, seen, name, chosen, rng):
    solid, motion = space_scene(chosen, rng)
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
    for k in range(SCENES * args.scale):
        chosen = passes(args.random)
        check_plane(checks, graze, seen, f"germ {k}", chosen, args.random)
        if k % 4 == 0:
            check_space(checks, graze, seen, f"germ {k}", chosen, args.random)
    for key, n in sorted(seen.items()):
        print(*key, n)
    checks.holds(sum(n for key, n in seen.items() if key[1] == "interior") > SCENES / 10, "few are interior")
    checks.finish()


if __name__ == "__main__":
    main()
