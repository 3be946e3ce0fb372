#!/usr/bin/env python3
# suite
"""Points beside contact points, classified exactly at distances from 2^-8 to 2^-400.

SPDX-License-Identifier: GPL-3.0-or-later

From some distance on egress, ingress and trimmed points have no `out` point beside them; simple contacts in a facet, on a
convex edge or on a convex vertex have some at every distance. Directions are few, so that at distances where the sweep is
not yet like its cone they may miss what is out: simple contacts are probed from 2^-30 on. With --scale 80 some 20,000
sites are probed (`make test-long`).
"""
import os
import sys
from collections import Counter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import oracle  # noqa: E402
from derivation import sites  # noqa: E402
from exact import Fraction as F  # noqa: E402
from laws import Runs  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from scenes import scenes  # noqa: E402

SITES = {2: 16, 3: 8}
# Distances 2^-k; from index FAR on inner points must have no `out` point beside them.
INNER_STEPS, FAR, OUTER_STEPS = (8, 30, 100, 400), 2, (30, 60, 200, 400)
# Directions that are probed, in the plane and in space.
AROUND = {2: [(a, b) for a in range(-2, 3) for b in range(-2, 3) if a or b],
          3: [(a, b, c) for a in (-1, 0, 1) for b in (-1, 0, 1) for c in (-1, 0, 1) if a or b or c]}
PROBES = 10000  # of one run
BITS = "bits=10000000"  # a double root at 2^-400 may ask for more than the usual 100,000


def probed(solid, sides, y, row):
    """Whether a site is probed, as inner or as outer one."""
    if row["role"] in ("egress", "ingress") or row["trimmed"] == "yes":
        return "inner"
    if row["status"] == "simple" and row["role"] == "contact" and oracle.Cone(solid, sides, y).kind() == "convex":
        return "outer"
    return None


def probes(motion, t, y, kind):
    """Distances and points, the directions of the body carried to the world."""
    p, d = motion.map(y, t), motion.dimension
    origin = motion.map((F(0),) * d, t)
    ways = [tuple(a - b for a, b in zip(motion.map(tuple(F(x) for x in v), t), origin)) for v in AROUND[d]]
    steps = INNER_STEPS if kind == "inner" else OUTER_STEPS
    return [[tuple(a + b / 2 ** k for a, b in zip(p, w)) for w in ways] for k in steps]


def check_scene(runs, tally, name, solid, motion, chosen):
    sides = oracle.sides_of(solid)
    base = runs.rows(solid, motion, chosen, name)
    asked = []
    for (t, y), row in zip(chosen, base or []):
        kind = probed(solid, sides, y, row)
        if kind:
            asked.append((row, kind, probes(motion, t, y, kind)))
    while asked:
        few, count = [], 0
        while asked and count < PROBES:
            few.append(asked.pop())
            count += sum(map(len, few[-1][2]))
        answers = runs.graze.classify(f"{name} probe", solid, motion, [p for _, _, rings in few for r in rings for p in r],
                                      "--limit", BITS)
        if answers is None:
            return
        out = iter(a.record["pmc"] == "out" for a in answers)
        for row, kind, rings in few:
            found = [any([next(out) for _ in ring]) for ring in rings]
            if kind == "inner":
                runs.checks.holds(not any(found[FAR:]), name, "an out point beside", row, found)
                tally["farther off"] += any(found)
            else:
                runs.checks.holds(all(found), name, "no out point beside", row, found)
            tally[kind] += 1
            tally[row["status"]] += 1


def main():
    args = options(__doc__.split("\n\n")[0])
    checks, tally = Checks(), Counter()
    runs = Runs(checks, Graze(args, checks))
    for name, solid, motion in scenes(args):
        chosen = sites(args.random, solid, motion, oracle.sides_of(solid), SITES[solid.dimension])
        check_scene(runs, tally, name, solid, motion, chosen)
    print(dict(tally))
    checks.holds(tally["outer"] > 20 * args.share and tally["inner"] > 100 * args.share, "probed", dict(tally))
    checks.finish()


if __name__ == "__main__":
    main()
