#!/usr/bin/env python3
# suite
"""Dangling parts of unsweeps by duality: the sweep of a solid and the unsweep of its complement by the inverse motion.

SPDX-License-Identifier: GPL-3.0-or-later

The complement of the unsweep is the open sweep, so its `on` points are `on` the sweep, and a point is in the closure of
the unsweep's interior exactly if it is not in the interior of the closed sweep (proofs/dangling.md C113): `regular` is `no` where the position
is `interior`, `yes` where it is `boundary`. Positions are those that other suites derive, or CGAL's Minkowski sums say; the
solid here is a large box without the solid there, its facets turned over, one motion the inverse of the other. What is
undecided, by which level the rest, are the same, but that in space the box's own curves may be more than planes through a
point are looked at with. Witnesses are `in` all along; about a `no` nothing is.
"""
import itertools
import json
import os
import re
import sys
from collections import Counter

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "agree", "lib"))
sys.path.insert(0, os.path.join(HERE, "..", "lib"))

import germs  # noqa: E402
import orders  # noqa: E402
import roofs  # noqa: E402
import sides  # noqa: E402
import straight  # noqa: E402
import verdicts  # noqa: E402
from exact import Fraction as F  # noqa: E402
from oracle import Oracle  # noqa: E402
from prisms import Text, has_hole, mapped, rings_of, turned_left  # noqa: E402
from program import Checks, Graze, exchanged, options  # noqa: E402
from refine import complement  # noqa: E402
from solids import Mesh, Polygon  # noqa: E402
from witnesses import check_witness  # noqa: E402

SIZE = 10 ** 6
UNSWEEP = ("--operation", "unsweep", "--regular")
REGULAR = {"interior": "no", "boundary": "yes", "undecided": "undecided"}
IN_PLANES, MORE_CURVES = ("section", "curves", "leading_terms"), F(1, 10)  # the most of the points in space
GERMS, WITNESSES, PROBED = 25, 2, (20, 60, 200)
COMPASS = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1), (1, -1, 2), (-2, 1, 3), (3, 1, -1), (-1, 5, 0)]


def inverse(motion):
    """M^ as the motion of a standing frame seen from M."""
    document = json.loads(motion.text())
    d, ends = document["dimension"], [document["pieces"][0]["t"][0], document["pieces"][-1]["t"][1]]
    still = {"dimension": d, "pieces": [{"t": ends, "transform": {"translate": ["0"] * d}}]}
    return Text({"dimension": d, "relative": {"moving": still, "frame": document}})


def read_mesh(path):
    with open(path, encoding="utf-8") as f:
        lines = [x.split() for x in f if x.strip() and not x.startswith(("#", "OFF"))]
    vertices, facets = int(lines[0][0]), int(lines[0][1])
    return Mesh([tuple(F(x) for x in line) for line in lines[1:1 + vertices]],
                [tuple(int(x) for x in line[1:]) for line in lines[1 + vertices:1 + vertices + facets]])


def read_solid(name):
    path = os.path.join(verdicts.EXAMPLES, "solids", name)
    if not name.endswith(".wkt"):
        return read_mesh(path)
    with open(path, encoding="utf-8") as f:
        rings = rings_of(f)
    return Polygon([rings] if has_hole(name) else [[turned_left(r)] for r in rings])


def read_motion(name):
    with open(os.path.join(verdicts.EXAMPLES, "motions", name + ".json"), encoding="utf-8") as f:
        return Text(json.load(f))


def derived():
    """(name, solid, motion, point, derived position or None) of points that are `on` a sweep."""
    for name, solid, motion, point, pmc in verdicts.examples():
        if pmc == "on":
            yield f"example {name}", read_solid(solid), read_motion(motion), [F(x) for x in point], verdicts.POSITIONS[name]
    for name, solid, motion, point, pmc, position in verdicts.neighbours():
        if pmc == "on":
            yield name, solid, motion, point, position


def scenes(args):
    """Rows as in `derived`, and those of other suites' scenes, some of them random."""
    yield from derived() if args.derived else ()
    for k in args.rounds(GERMS, "germs"):
        chosen = germs.passes(args.random)
        yield f"germ {k}", *germs.plane_scene(chosen), (F(0), F(0)), germs.truth(chosen)
        if k % 5 == 0:
            yield f"germ {k} in space", *germs.space_scene(chosen), (F(0),) * 3, germs.truth(chosen)
    origin = mapped((F(0), F(0), F(0)))
    for k, terms in roofs.chosen(args):
        if k % 3 == 0:
            yield f"roofs {k}", roofs.roofs(), roofs.motion(*terms), origin, roofs.truth(*terms)
    for k, (parts, order, *_) in orders.chosen(args):
        if k % 4 == 0:
            yield f"orders {k}", *orders.scene(parts), origin, {1: "interior", -1: "boundary"}.get(order)
    for k, setup in args.cycle(sides.setups(False).values(), 1, "sides"):
        found = list(setup(args.random))
        _, parts, position, _ = found[k % len(found)]
        yield f"sides {k}", *orders.scene(parts), origin, position


def probes(point):
    return [tuple(x + F(s * y, 2 ** k) for x, y in zip(point, u)) for k in PROBED for u in COMPASS for s in (1, -1)]


def check(checks, graze, seen, name, solid, motion, points, positions, looked_at):
    """Points of one scene; `looked_at` of each answer have their witness checked, or are probed."""
    d, left = len(points[0]), Counter()
    there = complement(solid, SIZE)[0], inverse(motion)
    swept = graze.classify(name, solid, motion, points, "--topo")
    kept = graze.classify(name + " dual", *there, points, *UNSWEEP, table=looked_at > 0)
    for a, b, point, position in zip(swept or [], kept or [], points, positions):
        record, there_record = a.record, b.record
        where = (name, ",".join(str(x) for x in point), a.word, record.get("topo_level"), there_record.get("regular_level"))
        checks.equal((there_record["pmc"], b.word), ("on", exchanged(a.word)), *where)
        said = there_record["regular"]
        if d == 3 and said == "undecided" and record.get("topo_level") in IN_PLANES:
            seen["more curves"] += 1
        else:
            checks.equal(said, REGULAR[record["topo"]], *where, there_record.get("regular_reason"))
            checks.equal(there_record.get("regular_level"), record.get("topo_level"), *where)
        checks.holds(position is None or said in (REGULAR[position], "undecided"), *where, said, position)
        checks.equal("regular_witness" in there_record, said == "yes", *where, "witness")
        checks.holds(b.row is None or b.row["regular"] == said, *where, "the table")
        seen[d, said, there_record.get("regular_level")] += 1
        left[said] += 1
        if left[said] > looked_at:
            continue
        if said == "undecided":
            check_hint(checks, graze, where, there, point)
        elif said == "yes":
            check_witness(checks, graze, name, there, point, there_record, "regular")
        else:
            found = graze.classify(name + " near", *there, probes(point), *UNSWEEP[:2]) or []
            checks.equal({answer.record["pmc"] for answer in found} & {"in"}, set(), *where, "near a `no`")


def check_hint(checks, graze, where, files, point):
    """An undecided point in words, with a point that is `in` within the box's size."""
    files = [graze.write("hint" + x.suffix, x.text()) for x in files]
    said = graze.call("explain", *files, *map(str, point), *UNSWEEP).stdout
    checks.holds("Regular, in the closure of the unsweep's interior: it is undecided: to first order" in said, *where, said)
    near = re.search(r"The nearest point found that is in is \((.*)\), about 2", said)
    if checks.holds(near, *where, said):
        found = graze.classify(where[0] + " hint", *files, [near[1].split(", ")], *UNSWEEP[:2])
        checks.equal(found and found[0].record["pmc"], "in", *where, near[1])


def check_straight(checks, graze, oracle, args, seen):
    """Points on a lattice about straight legs: positions by CGAL."""
    for name, solid, path in itertools.chain(straight.plane_scenes(args, F(1, 2)), straight.space_scenes(args, F(1, 2))):
        motion = straight.legs(path)
        points = [p for _, p in straight.lattice(args.random, solid, path, straight.POINTS)]
        answers = graze.classify(name, solid, motion, points) or []
        points = [p for p, answer in zip(points, answers) if answer.record["pmc"] == "on"]
        if points:
            positions = [position for _, position in straight.positions_of(oracle, solid, path, points)]
            checks.equal(len(positions), len(points), name, "positions")
            check(checks, graze, seen, "straight " + name, solid, motion, points, positions, WITNESSES)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze, oracle = Graze(args, checks), Oracle(args, checks, "minkowski")
    seen = Counter()
    for name, solid, motion, point, position in scenes(args):
        check(checks, graze, seen, name, solid, motion, [point], [position], 1)
    check_straight(checks, graze, oracle, args, seen)
    for key, n in sorted(seen.items(), key=str):
        print(key, n)
    checks.holds(seen["more curves"] <= MORE_CURVES * sum(n for key, n in seen.items() if key[0] == 3), "undecided by the box's curves", seen["more curves"])
    for d, levels in ((2, ("first_order", "closed_cones", "edges", "curves")),
                      (3, ("first_order", "closed_cones", "leading_terms", "section"))):
        for level in levels if args.derived else set(levels) - {"edges", "section"}:
            checks.holds(seen[d, "no", level] + seen[d, "yes", level], d, level, "is asked")
    oracle.finish()
    checks.finish()


if __name__ == "__main__":
    main()
