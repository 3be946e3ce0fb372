#!/usr/bin/env python3
# suite
"""Contacts that cover one side of an edge or a flat top alone: turns of even order, and ways that end or break off; derived.

SPDX-License-Identifier: GPL-3.0-or-later

Parts of orders.py pass the origin. Four of them decide:

  A, B: a roof with its ridge along y that comes to x = 0 from x < 0, at s < 0 by (-|s|^m, 0, k |s|^(m + 1)), and another one
     from x > 0; m is even and they go back on the way of the same powers of s, or s ends at 0, whence they drop straight
     down. A ridge draws z = k |x|^(1 + 1/m) where y = 0 on its side, and back -k |x|^(1 + 1/m); what it covers is below.
     Without a tilt it covers nothing above z = 0 where x = 0.
  or A, B: a flat top that moves by (0, 0, -a |s|^n), s from -1 to 0, with tilts w and -w, and drops: it covers what is
     below w s y - a |s|^n for all s, so below 0 and more where w y < 0, and for the other one where w y > 0.
  C, D: a roof below, its ridge along x (for the flat tops along y), draws z = l y^2 (l x^2); one above, of the same kind,
     draws z = u y^2 (u x^2), covering what is above.

With roofs the origin is interior if l > u and k > 0 on both sides, or k is not 0 where the way goes on: C and D close where
y is not 0, A or B with D where y = 0. It is on the boundary if u > max(l, 0) and there is no tilt: at x = 0 all between max(l, 0) y^2 and u y^2 is open. The flat tops are the same with x and y exchanged.
"""
import os
import re
import sys
from collections import Counter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import orders  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from orders import flat, mapped, roof  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from witnesses import check_witness  # noqa: E402

TINY = F(1, 2 ** 60)
SCALES = (30, 60, 110)


def on_side(m, k, w, side, ends, along="y"):
    """The roof of A (side -1) or B (1), with its ridge along y: its x is side |s|^m, its z k |s|^(m + 1) on s < 0, and for m even
    -k s^(m + 1) on all; or along x."""
    part = roof(along, m, k, w)
    way = (side * (1 if m % 2 == 0 else -1), m)
    part.path = [*([way, (0, 0)] if along == "y" else [(0, 0), way]), (k if m % 2 else -k, m + 1)]
    part.ends = ends
    return part


def top(n, w):
    """A flat top that ends; its height is more than 0 where w y < 0."""
    part = flat(n, F(3, 4), w)
    part.path, part.ends = [(0, 0), (0, 0), (F(-3, 4) if n % 2 == 0 else F(3, 4), n)], True
    return part


def crossing(along, l, u):
    """C and D: their ridges along x or y."""
    return [roof(along, 1, l, F(0)), roof(along, 1, u, F(0), False)]


def truth(l, u, sides_close, level):
    return "interior" if l > u and sides_close else "boundary" if u > max(l, 0) and level else None


def scenes(rng, name, sides, along, closing, level, m):
    """(name, parts, position or None, order of the sides)."""
    for l, u in ((F(1, 64) + TINY, F(1, 64)), (F(1, 64) - TINY, F(1, 64)), (-F(1, 64), F(1, 64)),
                 (F(rng.randint(-3, 3), 64), F(rng.randint(-3, 3), 64))):
        yield name, [*sides, *crossing(along, l, u)], truth(l, u, closing, level), m


def setups(longer):
    """Name -> what gives its scenes, of a generator of random numbers."""
    found = {}

    def add(name, *how):
        found[name] = lambda rng: scenes(rng, name, *how)

    for m, ends in ((2, False), (1, True), (3, True), *([(4, False), (2, True)] if longer else [])):
        for k, k2, w in ((F(1, 16), F(1, 8), F(0)), (F(1, 16), -F(1, 8), F(0)), (F(1, 16), F(1, 16), F(1, 16)),
                         *([(F(1, 16), F(0), F(0))] if longer else [])):
            sides = [on_side(m, k, w, -1, ends), on_side(m, k2, w, 1, ends)]
            closing = k and k2 if not ends else k > 0 and k2 > 0
            add(f"edges {m} {ends} {k} {k2} {w}", sides, "x", closing, w == 0, m)
    # a way that ends on one side alone, and one of even order on the other
    for m, side in ((1, -1), (1, 1), (3, 1)):
        sides = [on_side(m, F(1, 16), F(0), side, True), on_side(2, F(1, 8), F(0), -side, False)]
        add(f"edges {m} and 2, {side}", sides, "x", True, True, m)
    # a roof above with its ridge along y, u x^2: one side alone leaves what is between 0 and u x^2 on the other
    for m, ends in ((1, True), (2, False)):
        both = [on_side(m, F(1, 8), F(0), side, ends) for side in (-1, 1)]
        others = [roof("x", 1, F(1, 64), F(0)), roof("y", 1, F(1, 64), F(0), False)]
        fixed = [("both sides", [*both, *others], "interior", m), *(("one side", [side, *others], "boundary", m) for side in both)]
        found[f"edges {m} on a side"] = lambda rng, m=m, fixed=fixed: [(f"edges {m} on {where}", *scene) for where, *scene in fixed]
    for n, w in ((2, F(1, 4)), (3, -F(1, 8)), *([(4, F(1, 4)), (5, F(1, 8))] if longer else [])):
        add(f"tops {n} {w}", [top(n, w), top(n, -w)], "y", True, True, n - 1)
        sides = [top(n, w), on_side(2, F(1, 8), F(0), 1 if w > 0 else -1, False, "x")]
        add(f"tops {n} {w} and an edge", sides, "y", True, True, n - 1)
    return found


def chosen(args):
    base, more = setups(False), setups(True)
    for name in args.once(base, "sides", [name for name in more if name not in base]):
        yield from more[name](args.random)


def check_words(checks, graze, name, files):
    """An undecided point on the boundary: both sides of the plane, and a point that is out, as a hint."""
    said = graze.call("explain", *files, "0", "0", "0", "--topo").stdout
    checks.holds("some in the plane dx + dy + -1 dz = 0:\na gap along it would be thinner than every cone." in said, name, said)
    checks.equal(said.count("; it closes dx + dy + -1 dz > 0\n") > 0, "; it closes dx + dy + -1 dz < 0\n" in said, name, said)
    near = re.search(r"The nearest point found that is out is \((.*)\), about 2\^-(\d+) times\nthe solid's width away. "
                     r"That is a hint, no verdict.", said)
    if checks.holds(near, name, "a point that is out", said):
        found = graze.classify(name + " hint", *files, [near[1].split(", ")])
        checks.equal(found and found[0].record["pmc"], "out", name, near[1])
        away = max(abs(F(x)) for x in near[1].split(", ")) * 2 ** int(near[2])
        wide = max(map(F, re.search("^box of S.*size (.*)$", graze.call("check", *files).stdout, re.M)[1].split(" x ")))
        checks.holds(wide / 4 <= away <= 4 * wide, name, "as far as is said", to_double(away / wide))


def probes(e):
    for x, y in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1), (2, 1), (-1, 2), (8, 1), (-1, 8)):
        for z in (F(0), F(1, 64), -F(1, 64), F(1, 128), -F(1, 128), F(1, 40), F(3, 128)):
            yield mapped((x * e, y * e, z * e * e))


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    seen = Counter()
    origin = mapped((F(0), F(0), F(0)))
    for number, (name, parts, want, m) in enumerate(chosen(args)):
        solid, motion = orders.scene(parts)
        answers = graze.classify(f"sides {number}", solid, motion, [origin], "--topo")
        if not answers:
            continue
        record = answers[0].record
        where = (name, [(str(p.path), str(p.tilt)) for p in parts], record["word"], record.get("topo_level"))
        checks.equal(record["pmc"], "on", *where)
        seen[name.split()[0], m, want, record["topo"], record.get("topo_level")] += 1
        if want == "interior":
            checks.equal(record["topo"], want, *where, record.get("topo_reason"))
        elif want:
            checks.holds(record["topo"] in (want, "undecided"), *where, record["topo"])
        if want == "boundary" and record["topo"] == "undecided":
            check_words(checks, graze, f"words {number}", [graze.write(f"w{number}{x.suffix}", x.text()) for x in (solid, motion)])
        if record["topo"] == "boundary":
            check_witness(checks, graze, f"sides {number}", (solid, motion), origin, record)
        if record["topo"] == "interior":
            places = [p for s in SCALES for p in probes(F(1, 2 ** s))]
            found = graze.classify(f"probes {number}", solid, motion, places) or []
            checks.equal({a.record["pmc"] for a in found} - {"in", "on"}, set(), *where, "probes that are out")
    for key, count in sorted(seen.items(), key=str):
        print(*key, count)
    by_sides = sum(n for key, n in seen.items() if key[3:] == ("interior", "leading_terms"))
    checks.holds(by_sides >= 10 * args.share, f"{by_sides} are interior by the sides")
    by_paths = sum(n for key, n in seen.items() if key[0] == "edges" and key[2:4] == ("boundary", "boundary"))
    checks.holds(by_paths >= 10 * args.share, f"{by_paths} are on the boundary")
    checks.finish()


if __name__ == "__main__":
    main()
