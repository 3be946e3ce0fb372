#!/usr/bin/env python3
# suite
"""`graze envelope --patches` and `--joints`: against the events, against the contact points at single times and by chance, and under changes that keep contacts.

SPDX-License-Identifier: GPL-3.0-or-later

At a time between events the patches are the slices, runs, points and whole facets of the curve of contact, and joints the
points in which these end. A patch begins and ends with the motion, at a break, or at an event that names its cell, and none
such is in between. Patches and joints are told apart by kind, cell, ends and interval, not by their numbers.
"""
import csv
from collections import Counter

from laws import backwards, laws, oracle  # noqa: F401  (it finds tests/contact and tests/agree)
from exact import Fraction as F
from motion import cut, reversed_in_time
from program import Checks, Graze, options
from reading import When, between, table
from scenes import scenes
from solids import Polygon

SCENES, TIMES, POINTS, LIMITS = 7, 3, 12, 6  # scenes in the plane, and in space
FACET_KINDS = ("reach", "cusp", "turn", "singular")


class Tables:
    """The tables of one scene, times in order: `order[text]` is the place of a time among all of them."""

    def __init__(self, checks, graze, tag, solid, motion, *more):
        files = [graze.write(f"{tag}{end}", text) for end, text in ((solid.suffix, solid.text()), (".json", motion.text()))]
        names = [graze.write(f"{tag}-{kind}.csv", "") for kind in ("events", "patches", "joints")]
        done = graze.call("envelope", *files, "--events", names[0], "--patches", names[1], "--joints", names[2], *more)
        checks.equal(done.returncode, 0, tag, done.stderr)
        self.events, self.patches, self.joints = [table(n) for n in names]
        self.files, self.motion = files, motion
        self.start, self.end = str(motion.pieces[0].lo), str(motion.end)
        self.breaks = {str(p.lo) for p in motion.pieces[1:]}
        self.order, self.when = {}, []
        for text in [self.start] + [r["time"] for r in self.events] + [self.end]:
            self.put(text)
        for text in sorted(self.breaks, key=F):
            if text not in self.order:
                self.insert(text)

    def put(self, text):
        if text not in self.order:
            self.order[text] = len(self.when)
            self.when.append(When(text))

    def insert(self, text):
        place = sum(w.compare(F(text)) < 0 for w in self.when)
        self.when.insert(place, When(text))
        self.order = {w.text: k for k, w in enumerate(self.when)}

    def is_within(self, row, time):
        """Is a rational time that is no event's in the row's interval?"""
        return self.when[self.order[row["from"]]].compare(time) < 0 < self.when[self.order[row["to"]]].compare(time)

    def described(self, row):
        ends = tuple(sorted([(row["a"], row["theta_a"]), (row["b"], row["theta_b"])]))
        return row["kind"], row["cell"], row["from"], row["to"], ends

    def joint(self, row):
        return row["cell"], row["from"], row["to"], row["form"], \
            tuple(sorted(self.described(self.patches[int(k)]) for k in row["patches"].split(" ")))


def concerns(event, cell):
    """Does the event name the facet or vertex, or meet on the edge?"""
    if event["kind"] in ("saddle", "meet"):
        return event["cell"] == cell
    return event["facet"] == cell or (event["kind"] == "reach" and event["cell"] == cell)


def check_intervals(checks, t, name, d):
    for row in t.patches:
        low, high = t.order[row["from"]], t.order[row["to"]]
        checks.holds(low < high, name, row)
        inside = {e["time"] for e in t.events if low < t.order[e["time"]] < high and concerns(e, row["cell"])}
        checks.equal(inside, set(), name, row, "events in a patch")
        checks.equal({b for b in t.breaks if row["from"] != b != row["to"] and low < t.order[b] < high} & t.hard, set(), name, row)
        if row["cell"].startswith("edge") and d == 3:
            continue  # a `reach` of a facet beside the edge, at an end of it
        named = {e["time"] for e in t.events if concerns(e, row["cell"])} | {t.start, t.end} | t.breaks
        checks.holds(row["from"] in named and row["to"] in named, name, row, "its ends name the cell")


def joined(row, kinds=("slice", "run")):
    return row["kind"] in kinds


def check_curve(checks, tally, t, name, time, rows, d):
    """The parts of the curve at a time, and the points in which slices and runs end."""
    active = [r for r in t.patches if t.is_within(r, time)]
    vertex = "vertex"
    of_curve = Counter((r["kind"], r["cell"]) for r in rows if not r["cell"].startswith(vertex))
    of_patches = Counter((r["kind"], r["cell"]) for r in active if not r["cell"].startswith(vertex))
    checks.equal(of_patches, of_curve, name, str(time), "parts")
    alone = {r["cell"] for r in rows if r["cell"].startswith(vertex)}
    vertices = [r["cell"] for r in active if r["cell"].startswith(vertex)]
    checks.holds(alone <= set(vertices) and len(set(vertices)) == len(vertices), name, str(time), "vertices")
    tally["parts"] += len(rows)
    if d == 2:
        return
    ends = {}
    for r in rows:
        for k in "ab":
            if joined(r):
                ends.setdefault(tuple(r[k + x] for x in "xyz"), []).append((r["kind"], r["cell"]))
    whole = {k for k, r in enumerate(t.patches) if r["kind"] == "whole"}
    found = Counter()
    for row in t.joints:
        members = [int(k) for k in row["patches"].split(" ")]
        if row["from"] != row["to"] and t.is_within(row, time) and not whole & set(members):
            parts = tuple(sorted((t.patches[k]["kind"], t.patches[k]["cell"]) for k in members if joined(t.patches[k])))
            found[parts] += 1
            checks.equal(row["form"], {1: "open", 2: "closed"}.get(len(parts), "branching"), name, row)
    checks.equal(found, Counter(tuple(sorted(e)) for e in ends.values()), name, str(time), "joints")
    tally["ends"] += len(ends)


def check_points(checks, tally, t, name, sites):
    for site in sites:
        active = [r for r in t.patches if r["cell"] == site["cell"] and t.is_within(r, F(site["time"]))]
        several = len(active) > 1 and all(r["kind"] in ("slice", "run", "point") for r in active)
        checks.holds(len(active) == 1 or several, name, site, active)
        tally["contact points"] += 1


def check_samples(checks, graze, t, name, d):
    """`graze contact` says the same of the samples."""
    axes = "xyz"[:d]
    head = ["time"] + ["b" + x for x in axes]
    rows = graze.write(name + "-samples.csv", "\n".join([",".join(head)] + [",".join(r[k] for k in head) for r in t.patches]) + "\n")
    out = graze.call("contact", *t.files, rows, "--quiet").stdout
    told = list(csv.DictReader(x for x in out.splitlines() if not x.startswith("#")))
    checks.equal(len(told), len(t.patches), name, "samples")
    for row, site in zip(t.patches, told):
        checks.equal(site["role"], "contact", name, row)
        for key in ["cell", "status"] + list(axes):
            checks.equal(site[key], row[key], name, row, key)
        checks.holds(t.is_within(row, F(row["time"])), name, row, "the sample is in the interval")


def check_event_joints(checks, tally, t, name):
    for row in t.joints:
        if row["from"] != row["to"]:
            continue
        members = [t.patches[int(k)] for k in row["patches"].split(" ")]
        at = t.order[row["from"]]
        checks.holds(len(members) > 1, name, row)
        for m in members:
            checks.holds(t.order[m["from"]] <= at <= t.order[m["to"]], name, row, m)
        checks.holds(any(row["from"] in (m["from"], m["to"]) for m in members), name, row)
        tally["joints at events"] += 1


def near_times(t, k):
    """Rational times just before and after time k, none other between."""
    when = t.when[k]
    while when.poly and when.high - when.low > F(1, 2 ** 60):
        when.narrow()
    low, high = when.low - F(1, 2 ** 50), when.high + F(1, 2 ** 50)
    apart = t.when[k - 1].compare(low) < 0 < t.when[k + 1].compare(high)
    return (low, high) if apart else None


def ends_near(t, rows, time):
    """(place, patch) for the ends of slices, runs and points at a time, and the patches that are hard to tell apart."""
    active = {}
    for k, r in enumerate(t.patches):
        if t.is_within(r, time):
            active.setdefault((r["kind"], r["cell"]), []).append(k)
    out, unclear = [], {k for ks in active.values() if len(ks) > 1 for k in ks}
    for r in rows:
        for k in active[r["kind"], r["cell"]] if F(r["time"]) == time and r["kind"] != "whole" and not r["cell"].startswith("vertex") else ():
            out += [([F(r[e + x]) for x in "xyz" if e + x in r], k) for e in "ab"]
    for (kind, cell), ks in active.items():
        if cell.startswith("vertex"):
            out += [([F(t.patches[k]["b" + x]) for x in "xyz" if "b" + x in t.patches[k]], k) for k in ks]
    return out, unclear | {k for (kind, _), ks in active.items() if kind == "whole" for k in ks}


def clusters(ends):
    out = []
    for place, k in ends:
        for first, members in out:
            if all(abs(a - b) < F(1, 2 ** 20) for a, b in zip(first, place)):
                members.add(k)
                break
        else:
            out.append((place, {k}))
    return [members for _, members in out]


def check_limits(checks, tally, graze, rng, t, name):
    """Ends that are near each other just before and after an event."""
    inner = [k for k in range(1, len(t.when) - 1)]
    near = {k: near_times(t, k) for k in rng.sample(inner, min(LIMITS, len(inner)))}
    near = {k: v for k, v in near.items() if v}
    if not near:
        return
    curve = graze.write(name + "-near.csv", "")
    done = graze.call("envelope", *t.files, "--at", ",".join(str(x) for v in near.values() for x in v), "--curve", curve)
    checks.equal(done.returncode, 0, name, done.stderr)
    rows = table(curve)
    for k, times in near.items():
        found = [ends_near(t, rows, time) for time in times]
        unclear = found[0][1] | found[1][1]
        text = t.when[k].text
        changes = {n for n, r in enumerate(t.patches) if text in (r["from"], r["to"])}
        want = Counter(frozenset(c - unclear) for c in clusters(found[0][0] + found[1][0]) if (c - unclear) & changes)
        told = Counter(frozenset({int(n) for n in r["patches"].split(" ")} - unclear) for r in t.joints if r["from"] == r["to"] == text)
        want, told = [Counter({c: n for c, n in x.items() if len(c) > 1 and c & changes}) for x in (want, told)]
        checks.equal(told, want, name, text, "joints at an event")
        tally["limits"] += sum(want.values())


def turned(t, change):
    """Patches and joints with times changed, `from` and `to` exchanged."""
    def patch(p):
        return p[:2] + (change(p[3]), change(p[2]), p[4])
    return Counter(patch(t.described(r)) for r in t.patches), \
        Counter((c, change(b), change(a), f, tuple(sorted(map(patch, m)))) for c, a, b, f, m in map(t.joint, t.joints))


def same(checks, t, other, name, law):
    checks.equal(Counter(map(other.described, other.patches)), Counter(map(t.described, t.patches)), name, law, "patches")
    checks.equal(Counter(map(other.joint, other.joints)), Counter(map(t.joint, t.joints)), name, law, "joints")


def check_laws(checks, graze, rng, name, solid, motion, t):
    m, inverse = laws.MAPS[solid.dimension][0]
    same(checks, t, Tables(checks, graze, name + "-world", solid, laws.times_map(motion, m, None)), name, "world")
    body = solid.mapped(lambda p: laws.apply(m, p)) if isinstance(solid, Polygon) else \
        solid.mapped(lambda p: laws.apply(m, p), False)
    same(checks, t, Tables(checks, graze, name + "-body", body, laws.times_map(motion, None, inverse)), name, "body")
    back = Tables(checks, graze, name + "-back", solid, reversed_in_time(motion))
    patches, joints = turned(t, laws.opposite_time)
    checks.equal(Counter(map(back.described, back.patches)), patches, name, "backwards, patches")
    checks.equal(Counter(map(back.joint, back.joints)), joints, name, "backwards, joints")
    times = {p.lo + (p.hi - p.lo) * F(rng.randint(1, 63), 64) for p in motion.pieces}
    times |= {F(r["time"]) for r in t.events[:40] if not r["time"].startswith("root") and motion.pieces[0].lo < F(r["time"]) < motion.end}
    times -= {p.lo for p in motion.pieces}
    same(checks, t, Tables(checks, graze, name + "-cut", solid, cut(motion, sorted(times))), name, "cut")


def check_scene(checks, tally, graze, rng, number, name, solid, motion):
    tag, d = f"{number}", solid.dimension
    t = Tables(checks, graze, tag, solid, motion)
    t.hard = {r[k] for r in t.patches for k in ("from", "to")}
    gaps = [(a, b) for a, b in zip(t.when, t.when[1:])]
    times = [between(*g) for g in rng.sample(gaps, min(TIMES, len(gaps)))]
    curve, points = graze.write(tag + "-curve.csv", ""), graze.write(tag + "-points.csv", "")
    done = graze.call("envelope", *t.files, "--at", ",".join(map(str, times)), "--curve", curve, "-n", str(POINTS), "--points", points)
    checks.equal(done.returncode, 0, name, done.stderr)
    check_intervals(checks, t, name, d)
    rows = table(curve)
    for time in times:
        check_curve(checks, tally, t, name, time, [r for r in rows if F(r["time"]) == time], d)
    check_points(checks, tally, t, name, table(points))
    check_samples(checks, graze, t, tag, d)
    check_event_joints(checks, tally, t, name)
    check_limits(checks, tally, graze, rng, t, tag)
    check_laws(checks, graze, rng, tag, solid, motion, t)
    tally["patches"] += len(t.patches)
    tally["joints"] += len(t.joints)


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    graze = Graze(args, checks)
    for number, (name, solid, motion) in enumerate(scenes(args, SCENES)):
        check_scene(checks, tally, graze, args.random, number, name, solid, motion)
    for key, count in sorted(tally.items()):
        print(key, count)
    for key in ("parts", "ends", "contact points", "joints at events", "limits"):
        checks.holds(tally[key], "there are some", key)
    checks.finish()


if __name__ == "__main__":
    main()
