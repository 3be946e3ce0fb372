#!/usr/bin/env python3
# suite
"""`graze envelope` under changes that keep contacts: world and body moved by affine maps, some of them mirrors, time run
otherwise or backwards, the motion cut, facets cut; and contacts of decomposable envelopes, none next to the interior.

SPDX-License-Identifier: GPL-3.0-or-later

g, meet and saddle turn over with time; a mirrored body turns the determinant of a saddle over.
"""
import importlib.util
import os
import sys
from collections import Counter

CONTACT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contact")
sys.path.insert(0, CONTACT)

import oracle  # noqa: E402,F401  (it finds the library of tests/agree)
from exact import Fraction as F  # noqa: E402
from motion import Motion, Piece, cut, mobius, reversed_in_time  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from reading import summary, table  # noqa: E402
from refine import triangulated  # noqa: E402
from scenes import scenes  # noqa: E402
from solids import Polygon, meshes  # noqa: E402


def beside(name):
    """A suite of tests/contact as a module; some have the names of suites here."""
    spec = importlib.util.spec_from_file_location("contact_" + name, os.path.join(CONTACT, name + ".py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


sites = beside("derivation").sites
laws = beside("laws")
SCENES, SITES = 6, 20  # scenes in the plane, and in space
OPPOSITE = {"+": "-", "-": "+"}
COLUMNS = ("time", "kind", "facet", "cell", "before", "after")


class Runs:
    def __init__(self, checks, graze):
        self.checks, self.graze, self.number = checks, graze, 0

    def find(self, solid, motion, name):
        """(rows, answer, reason), or None after a failed check."""
        self.number += 1
        files = [self.graze.write(f"{self.number}{end}", text) for end, text in
                 ((solid.suffix, solid.text()), (".json", motion.text()), ("-events.csv", ""))]
        done = self.graze.call("envelope", *files[:2], "--events", files[2])
        if not self.checks.equal(done.returncode, 0, name, done.stderr):
            return None
        said = summary(done.stdout)
        rows = [tuple(row[k] for k in COLUMNS) for row in table(files[2])]
        return rows, said["decomposable"], said["why"].split(",")[0]

    def same(self, name, base, other, change=None):
        """Check that both have equal rows, in the same order of times, once each row of the base is changed."""
        if base is None or other is None:
            return
        self.checks.equal(Counter(other[0]), Counter(change(r) if change else r for r in base[0]), name)
        self.checks.equal(other[1:], base[1:], name)


def turned(row, kinds):
    if row[1] not in kinds:
        return row
    return row[:4] + tuple(OPPOSITE.get(x, x) for x in row[4:])


def mirrored(row):
    return turned(row, ("saddle",))


def backwards(row):
    row = turned(row, ("saddle", "reach", "meet"))
    return (laws.opposite_time(row[0]),) + row[1:4] + (row[5], row[4])


def check_laws(runs, rng, name, solid, motion, base):
    for k, (m, inverse) in enumerate(laws.MAPS[solid.dimension]):
        runs.same(f"{name} world {k}", base, runs.find(solid, laws.times_map(motion, m, None), name))
        body = solid.mapped(lambda p, m=m: laws.apply(m, p)) if isinstance(solid, Polygon) else \
            solid.mapped(lambda p, m=m: laws.apply(m, p), bool(k))
        runs.same(f"{name} body {k}", base, runs.find(body, laws.times_map(motion, None, inverse), name),
                  mirrored if k else None)
    runs.same(f"{name} backwards", base, runs.find(solid, reversed_in_time(motion), name), backwards)
    times = {p.lo + (p.hi - p.lo) * F(rng.randint(1, 63), 64) for p in motion.pieces}
    times |= {F(row[0]) for row in base[0][:40] if not row[0].startswith("root") and motion.pieces[0].lo < F(row[0]) < motion.end}
    times -= {p.lo for p in motion.pieces}
    runs.same(f"{name} cut", base, runs.find(solid, cut(motion, sorted(times)), name))
    other, _ = mobius(motion, F(3, 2))
    fast = runs.find(solid, other, name)
    if fast:
        runs.checks.equal([r[1:] for r in in_groups(fast[0])], [r[1:] for r in in_groups(base[0])], name, "speed")
        runs.checks.equal(fast[1:], base[1:], name, "speed")
    if solid.dimension == 3:
        try:
            fine = triangulated(solid)[0]
        except (ValueError, IndexError):
            return
        again = runs.find(fine, motion, name)
        if again:
            runs.checks.equal(again[1:], base[1:], name, "facets")


def in_groups(rows):
    """Rows with the number of their time for the time."""
    number, last, out = -1, None, []
    for row in rows:
        number += row[0] != last
        last = row[0]
        out.append((number,) + row[1:])
    return out


def check_yes(runs, graze, rng, name, solid, motion, tally):
    """No contact at an inner time has the interior next to it."""
    chosen = [(t, y) for t, y in sites(rng, solid, motion, oracle.sides_of(solid), SITES) if motion.pieces[0].lo < t < motion.end]
    rows = laws.Runs(runs.checks, graze).rows(solid, motion, chosen, name) or []
    for row in rows:
        if row["role"] == "contact":
            runs.checks.holds(row["near_in"] != row["time"], name, row)
            tally["contacts of yes"] += 1


def square():
    return Polygon([[[(F(0), F(0)), (F(4), F(1)), (F(3), F(5)), (F(-1), F(2))]]])


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    graze = Graze(args, checks)
    runs = Runs(checks, graze)
    for name, solid, motion in scenes(args, SCENES):
        base = runs.find(solid, motion, name)
        if base:
            tally[base[1]] += 1
            tally["events"] += len(base[0])
            check_laws(runs, args.random, name, solid, motion, base)
    few = ("square", square()), ("cube", meshes()["cube"]), ("octahedron", meshes()["octahedron"])
    for name, solid in few if args.derived else ():
        d = solid.dimension
        unit = [[[int(i == j)] for j in range(d)] for i in range(d)]
        line = Motion([Piece(F(0), F(1), unit, [[0, 7 + 3 * i, 1 + i] for i in range(d)], [1])])
        grow = Motion([Piece(F(0), F(1), [[[2, int(i == j)] if i == j else [] for j in range(d)] for i in range(d)],
                             [[0, 40] for _ in range(d)], [2])])
        for kind, motion in (("line", line), ("grow", grow)):
            base = runs.find(solid, motion, name)
            if base:
                tally[base[1]] += 1
                check_laws(runs, args.random, f"{name} {kind}", solid, motion, base)
                if base[1] == "yes":
                    check_yes(runs, graze, args.random, f"{name} {kind}", solid, motion, tally)
    for key, number in sorted(tally.items(), key=str):
        print(key, number)
    checks.holds(tally["no"] and (tally["yes"] and tally["contacts of yes"] or not args.derived), "both answers occur", tally)
    checks.finish()


if __name__ == "__main__":
    main()
