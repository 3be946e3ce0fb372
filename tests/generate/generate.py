# suite
"""`graze generate`: every promise a row makes, checked on the row and on its classification.

SPDX-License-Identifier: GPL-3.0-or-later

A row names a stratum, the order of the contact, a cell, a time and perhaps a displacement. The
motion is read by jets.py and the solid by places.py, which share nothing with the program: the body
point y = M(t)^-1 P must lie in the relative interior of the cell, the order must be that of the
pullback of a plane of the cell, and a displaced point must come back to the cell exactly. Then
`graze classify` must meet the cell at the time.
"""
import json
import math
import os
import re
import sys
import tempfile
from collections import Counter

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", folder) for folder in ("cases", "lib")]

import casefile  # noqa: E402
import jets  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from harness import ONLY, Checks, options, run  # noqa: E402
from places import Solid, dot  # noqa: E402
from times import given_time, value  # noqa: E402

ROWS = 60
SHARE_ROWS = 600
CASES = ["bracket", "family-once-apex", "figure2-orders-2d", "figure2-orders-3d",
         "figure2-rotation-3d", "figure2-slides-2d", "figure2-straight-2d", "figure2-turn-3d",
         "figure4", "unsweep-figure14b", "unsweep-figure7"]
UNMADE = {"edge": lambda scene: scene.solid.dimension == 2,
          "break": lambda scene: len(scene.breaks) == 2}
STRATA = ["random", "near", "face", "face-odd", "edge", "vertex", "crossing", "start", "end",
          "break", "slide", "miss"]


class Scene:
    def __init__(self, name, solid, motion, flags=()):
        self.name, self.files, self.flags = name, [solid, motion], list(flags)
        self.solid, self.motion = Solid(solid), jets.load(motion)
        self.breaks = jets.breaks(self.motion)
        self.maps = {}

    def trajectory(self, point, t):
        """The jets of c at t, and the rows that carry body normals to world normals."""
        if t not in self.maps:
            m = jets.matrix_at(self.motion, t)
            self.maps[t] = m if "unsweep" in self.flags else jets.inverse(m)
        m, d = self.maps[t], len(point)
        c = [sum((row[j] * point[j] for j in range(d)), row[d]) for row in m[:d]]
        return c, [[row[j].terms[0] for j in range(d)] for row in m[:d]]


def of_case(name):
    case = casefile.Case(name)
    operation = case.option("--operation", "sweep")
    return Scene(name, case.path(case.solid), case.path("motion.json"), ["--operation", operation])


class Table:
    """Output of the program: rows by column, the weights of strata, None where it has none."""

    def __init__(self, text):
        lines = text.splitlines()
        head = [line.split() for line in lines if line.startswith("#")]
        body = [line for line in lines if not line.startswith("#")]
        names = body[0].split(",")
        self.rows = [dict(zip(names, line.split(","))) for line in body[1:]]
        self.whole = all(len(line.split(",")) == len(names) for line in body[1:])
        self.strata = {h[2]: int(h[3]) if len(h) == 4 else None for h in head if h[1] == "stratum"}
        box = next(h[2] for h in head if h[1] == "box")
        box = [F(x) for x in box.split(",")]
        self.low, self.high = box[:len(box) // 2], box[len(box) // 2:]
        self.axes = [a for a in "xyz" if a in names]

    def point(self, row):
        return [F(row[a]) for a in self.axes]


class Suite:
    def __init__(self, graze, checks):
        self.graze, self.checks = graze, checks
        self.folder = tempfile.TemporaryDirectory()
        self.met = Counter()

    def path(self, name, text=None):
        path = os.path.join(self.folder.name, name)
        if text is not None:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        return path

    def generate(self, scene, count, seed, *more):
        done = run([self.graze, "generate", *scene.files, *scene.flags, "-n", count, "--seed", seed, *more])
        self.checks.equal(done.returncode, 0, scene.name, seed, *more, done.stderr.strip())
        return done.stdout if done.returncode == 0 else None

    def classify(self, scene, text):
        points = self.path("points.csv", text)
        done = run([self.graze, "classify", *scene.files, points, *scene.flags, "--format", "jsonl"])
        self.checks.equal(done.returncode, 0, scene.name, "classify", done.stderr.strip())
        return [json.loads(line) for line in done.stdout.splitlines()]


def cell_of(feature):
    (kind, name), = feature.items()
    return f"{kind} {'-'.join(map(str, name)) if isinstance(name, list) else name}"


def same_cell(a, b):
    """An edge may be named from either end."""
    return a == b or (a.startswith("edge") and b.startswith("edge")
                      and set(a[5:].split("-")) == set(b[5:].split("-")))


def compared(time, t):
    """-1, 0, 1: is the TIME before, at or after the rational t?"""
    p, low, high = given_time(time)
    if p is None or not low < t < high:
        return (low >= t) - (high <= t) if p is not None else (low > t) - (low < t)
    return 1 if (value(p, t) > 0) == (value(p, low) > 0) else -1


def holds_time(contact, t):
    return compared(contact["from"], t) <= 0 <= compared(contact["to"], t)


# --------------------------------------------------------------- the row alone

def check_row(suite, scene, table, row, representable):
    checks, where = suite.checks, (scene.name, json.dumps(row))
    point, stratum = table.point(row), row["stratum"]
    suite.met[stratum] += 1
    if representable:
        checks.holds(all(F(to_double(x)) == x for x in point), "a double must hold it", *where)
    if stratum == "random":
        checks.equal([row[k] for k in ("order", "cell", "time", "k", "side")], [""] * 5, *where)
        parts = [(x - a) / (b - a) for x, a, b in zip(point, table.low, table.high)]
        checks.holds(all(0 <= p <= 1 and (p * 2 ** 20).denominator == 1 for p in parts),
                    "a multiple of 2^-20 of the box", *where)
        return
    t, cell = F(row["time"]), row["cell"]
    if stratum.startswith("rounded-"):
        check_rounded(suite, scene, row, t, point, where)
        return
    ends = scene.breaks[0], scene.breaks[-1]
    checks.holds(ends[0] <= t <= ends[1], "a time of the motion", *where)
    check_kind(checks, scene, stratum, cell, t, row, where)
    displaced = stratum in ("near", "miss")
    checks.equal((row["k"] != "", row["side"] in ("in", "out")), (displaced, displaced), *where)
    facets = scene.solid.facets_at(cell)
    orders = set()
    if displaced:
        k = int(row["k"])
        checks.holds(k in (range(4, 12) if stratum == "near" else range(8, 97, 8)), "k", *where)
        places = [(f, undisplaced(scene, point, t, f, k, row["side"], representable))
                  for f in facets]
        places = [(f, p) for f, p in places if p is not None]
    else:
        places = [(f, point) for f in facets]
    for facet, place in places:
        c, _ = scene.trajectory(place, t)
        if scene.solid.holds(cell, [x.terms[0] for x in c]):
            pullback = sum((n * x for n, x in zip(facet.normal, c)), jets.jet(-facet.offset))
            orders.add(pullback.order())
    checks.holds(bool(orders), "M(t)^-1 P lies in the cell, displaced back where it was displaced",
                *where)
    order = None if row["order"] == "slide" else int(row["order"])
    checks.holds(order in orders or (order is not None and order >= jets.TERMS and None in orders),
                f"order of {orders}", *where)


def check_rounded(suite, scene, row, t, point, where):
    """Doubles next to a contact of a stratum: M(t)^-1 P is by rounding alone off the planes of the cell's facets."""
    checks, exact = suite.checks, row["stratum"].removeprefix("rounded-")
    checks.holds(all(F(to_double(x)) == x for x in point) and exact in STRATA[2:11], "doubles beside a contact", *where)
    checks.holds(row["k"] == "" and row["side"] in ("in", "on", "out"), "side", *where)
    check_kind(checks, scene, exact, row["cell"], t, row, where)
    c, _ = scene.trajectory(point, t)
    for facet in scene.solid.facets_at(row["cell"]):
        off = abs(sum(n * x.terms[0] for n, x in zip(facet.normal, c)) - facet.offset)
        size = sum(map(abs, facet.normal)) * (1 + max(map(abs, point)) + max(abs(x.terms[0]) for x in c))
        checks.holds(off <= size / 2 ** 46, "within rounding of the cell", to_double(off), *where)


def check_kind(checks, scene, stratum, cell, t, row, where):
    """Cell, time and order that the stratum promises."""
    flat = "face" if scene.solid.dimension == 3 else "edge"
    wanted = {"vertex": "vertex", "edge": "edge", "face": flat, "face-odd": flat, "near": flat,
              "crossing": flat, "slide": flat}.get(stratum)
    if wanted:
        checks.holds(cell.startswith(wanted), f"a cell of kind {wanted}", *where)
    inner = scene.breaks[1:-1]
    fits = {"start": t == scene.breaks[0], "end": t == scene.breaks[-1], "break": t in inner}
    checks.holds(fits.get(stratum, True), "the stratum's time", *where)
    order = row["order"]
    if stratum in ("slide", "crossing"):
        checks.equal(order, {"slide": "slide", "crossing": "1"}[stratum], *where)
    if stratum in ("face", "near"):
        checks.holds(order != "slide" and int(order) >= 2 and int(order) % 2 == 0, "even", *where)
    if stratum == "face-odd":
        checks.holds(order != "slide" and int(order) >= 3 and int(order) % 2 == 1, "odd", *where)


def undisplaced(scene, point, t, facet, k, side, representable):
    """P moved back by 2^-k along the moved facet's normal, its largest coordinate being 1; among
    doubles along the axis of that coordinate alone."""
    _, rows = scene.trajectory(point, t)
    n = [dot([r[j] for r in rows], facet.normal) for j in range(len(point))]
    size = max(map(abs, n))
    if representable:
        widest = [abs(x) for x in n].index(size)
        n = [x if j == widest else F(0) for j, x in enumerate(n)]
    step = F(1 if side == "out" else -1, 2 ** k) / size
    return [x - step * y for x, y in zip(point, n)]


# ---------------------------------------------------------------- the row's classification

def check_answer(suite, scene, row, record):
    """The contact at the row's time, its cell and its kind."""
    checks, where = suite.checks, (scene.name, json.dumps(row))
    if row["stratum"].startswith("rounded-"):
        checks.equal(record["pmc"], row["side"], *where, "the answer")
        return
    if row["order"] == "" or row["k"]:
        return
    t = F(row["time"])
    at = [c for c in record["contacts"] if holds_time(c, t)]
    if not checks.equal(len(at), 1, *where, "contacts at the time", record["word"]):
        return
    contact = at[0]
    cells = [cell_of(f) for f in contact["features"]]
    checks.holds(any(same_cell(c, row["cell"]) for c in cells), f"the cell among {cells}", *where)
    long = contact["from"] != contact["to"]
    if row["stratum"] == "slide":
        checks.holds(long, "an interval contact", *where)
    if row["order"] == "slide" or long or len(cells) > 1 or t in scene.breaks:
        return
    if cells[0].split()[0] == ("face" if scene.solid.dimension == 3 else "edge"):
        tangent = int(row["order"]) % 2 == 0
        checks.equal(contact["kind"], "tangency" if tangent else "intersection", *where)
        checks.equal(contact["left"] == contact["right"], tangent, *where)


def degenerate(scene, row, record):
    """A tangency, a contact on an edge (in space) or vertex or at an end, or of order 2 or more."""
    ends = [str(scene.breaks[0]), str(scene.breaks[-1])]
    small = {"vertex"} | ({"edge"} if scene.solid.dimension == 3 else set())
    return row["k"] == "" and row["order"] not in ("", "1") or any(
        c["kind"] == "tangency" or c["from"] in ends or c["to"] in ends
        or any(set(f) & small for f in c["features"]) for c in record["contacts"])


# ----------------------------------------------------------------------- tables

def check_table(suite, scene, count, seed, *more):
    """The rows and their answers, each row checked; None after a failure."""
    text = suite.generate(scene, count, seed, *more)
    if text is None:
        return None
    table = Table(text)
    suite.checks.equal((len(table.rows), table.whole), (count, True), scene.name, "rows")
    suite.checks.equal(len({tuple(row[a] for a in table.axes) for row in table.rows}), count, scene.name, "distinct points", *more)
    made = {s for s, w in table.strata.items() if w}
    suite.checks.holds({re.sub("^rounded-.*", "rounded", r["stratum"]) for r in table.rows} <= made,
                      "only strata the head gives weight to", scene.name, *more)
    for row in table.rows:
        check_row(suite, scene, table, row, "--representable" in more)
    records = suite.classify(scene, text)
    suite.checks.equal(len(records), count, scene.name, "records")
    for row, record in zip(table.rows, records):
        suite.checks.equal(record["point"], [row[a] for a in table.axes], scene.name, "point")
        check_answer(suite, scene, row, record)
    return table, records


def check_defaults(suite, scene, count, seed):
    answer = check_table(suite, scene, count, seed)
    if answer is None:
        return
    suite.checks.equal(list(answer[0].strata), STRATA, scene.name, "strata of the head")
    for stratum, cannot in UNMADE.items():
        suite.checks.equal(answer[0].strata[stratum] is None, cannot(scene), scene.name, stratum)


def check_share(suite, scene, seed):
    """At least 70 % of the rows are degenerate in their result with the default weights; 60 % where no
    facet has tangencies: a corner gives few points that differ."""
    text = suite.generate(scene, SHARE_ROWS, seed)
    least = 7 if Table(text).strata["face"] else 6
    records = suite.classify(scene, text)
    share = sum(degenerate(scene, *pair) for pair in zip(Table(text).rows, records))
    suite.checks.holds(10 * share >= least * SHARE_ROWS,
                      f"only {share} of {SHARE_ROWS} rows are degenerate", scene.name)


def check_bytes(suite, scene, seed):
    """Same seed, same bytes; the first rows do not depend on how many follow; also into a file."""
    text = suite.generate(scene, 60, seed)
    suite.checks.equal(suite.generate(scene, 60, seed), text, scene.name, "again")
    longer = suite.generate(scene, 90, seed)
    suite.checks.equal(longer[:len(text)], text, scene.name, "first rows of more")
    other = suite.generate(scene, 60, seed + 1)
    same = set(Table(text).rows[k]["x"] + "," + Table(text).rows[k]["y"] for k in range(60))
    fresh = [r for r in Table(other).rows if r["x"] + "," + r["y"] not in same]
    suite.checks.holds(len(fresh) >= 30, "another seed gives other points", scene.name)
    path = suite.path("out.csv")
    suite.checks.equal(suite.generate(scene, 60, seed, "--output", path), "", scene.name, "--output")
    with open(path, encoding="utf-8") as file:
        suite.checks.equal(file.read(), text, scene.name, "--output FILE")


def check_spent(suite):
    """Corners of a square at the generator's times are few points: alone they make a shorter table, beside others the
    rest is theirs."""
    solid = suite.path("square.wkt", SQUARE)
    motion = suite.path("steps.json", '{"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": ["t", 0]}}]}')
    for strata, count, note in (("vertex", 5000, " points were made; no others were found"), ("vertex=1,random=1", 5000, "were found of the strata vertex")):
        done = run([suite.graze, "generate", solid, motion, "-n", count, "--seed", 1, "--strata", strata])
        rows = Table(done.stdout).rows
        points = {(row["x"], row["y"]) for row in rows}
        vertices = sum(row["stratum"] == "vertex" for row in rows)
        suite.checks.equal(len(points), len(rows), strata, "distinct points")
        # At most four corners at 512 times.
        suite.checks.holds(500 < vertices <= 4 * 512, strata, vertices)
        suite.checks.equal(len(rows), vertices if strata == "vertex" else count, strata, "rows")
        suite.checks.holds(note in done.stderr and "fewer points than their weights ask for were found of the strata vertex" in done.stderr, strata, done.stderr)
        suite.checks.equal(done.returncode, 0, strata)


def check_weights(suite, scene, seed):
    """Counts within five standard deviations; a stratum without weight is neither named nor made.
    """
    count, weights = 1500, {"random": 1, "vertex": 3, "crossing": 6, "break": 2}
    text = suite.generate(scene, count, seed, "--strata",
                          ",".join(f"{s}={w}" for s, w in weights.items()))
    table = Table(text)
    suite.checks.equal(set(table.strata), set(weights), scene.name, "strata")
    given = {s: w for s, w in weights.items() if table.strata[s]}
    suite.checks.equal({s: w for s, w in table.strata.items() if w}, given, scene.name, "weights")
    rows = Counter(r["stratum"] for r in table.rows)
    for stratum, weight in given.items():
        share = weight / sum(given.values())
        off = abs(rows[stratum] - count * share)
        suite.checks.holds(off <= 5 * math.sqrt(count * share * (1 - share)),
                          f"{rows[stratum]} of {count} rows with the share {share}", scene.name,
                          stratum)


def check_both_sides(suite):
    """Beside contacts of a box that turns and shifts by numbers that are no doubles lie points on both sides, of every kind."""
    solid = suite.path("square.wkt", SQUARE)
    motion = suite.path("thirds.json", '{"dimension": 2, "pieces": [{"t": [0, "1/3"], "transform": {"translate": ["t + 1/3", "t^2"]}},'
                        '{"t": ["1/3", 1], "transform": {"translate": ["t + 1/3", "t/3"]}}]}')
    scene = Scene("thirds", solid, motion)
    answer = check_table(suite, scene, 600, 5, "--representable", "binary64")
    sides = {}
    for row in answer[0].rows if answer else ():
        sides.setdefault(row["stratum"], Counter())[row["side"]] += 1
    rounded = {name: found for name, found in sides.items() if name.startswith("rounded-")}
    suite.checks.holds(answer and answer[0].strata["rounded"] > 30, "the weight of what is lost", sides)
    # An inner crossing has no outside within an ulp, a break no point of its own; the others have.
    for name in ("vertex", "start", "end"):
        found = rounded.get("rounded-" + name, {})
        suite.checks.holds(found and found["in"] > 0 and found["out"] > 0, name, rounded)
    named = check_table(suite, of_case("bracket"), 200, 3, "--strata", "rounded")
    suite.checks.holds(named and sum(r["side"] == "out" for r in named[0].rows) > 3 and sum(r["side"] == "in" for r in named[0].rows) > 3,
                       "dyadic contacts have neighbours too")


# ---------------------------------------------------------------- boxes in closed form

SQUARE = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n"
BOXES = [
    # a piece's transform, and the extent of the moved unit square: bounds, squared where marked
    ('{"translate": ["4*t", "t - 1/3"]}', [(0, 5), (F(-1, 3), F(5, 3))]),
    ('{"translate": ["0", "4*t - 4*t^2"]}', [(0, 1), (0, 2)]),
    ('{"translate": ["1/(1 + t)", "t^3"]}', [(F(1, 2), 2), (0, 2)]),
    ('{"rotate": {"tan_half": "t", "center": ["1", "1"]}}', [(0, 2), ("1 - sqrt 2", 1)]),
    ('{"scale": ["1 + t", "1 - 2*t/3"]}', [(0, 2), (0, 1)]),
]


def check_boxes(suite):
    """The box holds the sweep and exceeds it by little: 2^-10 of its longest side here."""
    solid = suite.path("square.wkt", SQUARE)
    for number, (transform, extents) in enumerate(BOXES):
        motion = suite.path(f"box{number}.json", '{"dimension": 2, "pieces": [{"t": ["0", "1"], '
                            f'"transform": {transform}}}]}}')
        table = Table(suite.generate(Scene("box", solid, motion), 1, 1))
        slack = max(b - a for a, b in zip(table.low, table.high)) / 2 ** 10
        for low, high, (a, b) in zip(table.low, table.high, extents):
            where = ("box", transform, low, high)
            suite.checks.holds(not low.denominator & (low.denominator - 1)
                              and not high.denominator & (high.denominator - 1), "dyadic", *where)
            if a == "1 - sqrt 2":
                suite.checks.holds((1 - low) ** 2 >= 2 > (1 - low - slack) ** 2, a, *where)
            else:
                suite.checks.holds(a - slack <= low <= a, f"low end {a}", *where)
            suite.checks.holds(b <= high <= b + slack, f"high end {b}", *where)


def main():
    args = options(__doc__, ONLY)
    checks = Checks()
    suite = Suite(args.graze, checks)
    if args.derived:
        check_boxes(suite)
        check_both_sides(suite)
        check_spent(suite)
    rows = ROWS * max(1, int(args.scale))
    for name in args.once(name for name in CASES if args.only in name):
        scene = of_case(name)
        check_defaults(suite, scene, rows, args.seed)
        check_table(suite, scene, rows // 2, args.seed, "--representable", "binary64")
        check_share(suite, scene, args.seed)
        check_bytes(suite, scene, args.seed)
        check_weights(suite, scene, args.seed)
    print("rows by stratum:", dict(suite.met))
    for stratum in STRATA:
        checks.holds(args.only or not args.derived or suite.met[stratum], "is made by no scene", stratum)
    checks.finish()


if __name__ == "__main__":
    main()
