#!/usr/bin/env python3
# suite
"""`regular` of unsweeps: parts that dangle, derived by hand, and of solids of grid cells moved along the axes, decided exactly.

SPDX-License-Identifier: GPL-3.0-or-later

U = {P : M(t) P in S for all t}. Hand scenes say what U is. Solids of cells of the grid (1/2)Z^d, moved along the axes
between points of it: a leg carries an open cell of the grid along a row of cells, and each of its points stays in S exactly
if all cells of the row are in S. So U holds all of an open cell or nothing of it; int U is in the closure of those that it
holds, and a point is in cl int U exactly if it is in the closure of one (proofs/dangling.md C113). A point of U itself runs through cells of
all dimensions, each in S if a cell around it is, in iS if all are. Over a scene of the plane, sheared, a prism leaves the plane's
unsweep times its heights: at the rims above and below a point is regular if it is in the plane (proofs/topology.md C128).
"""
import itertools
import json
import os
import sys
from collections import Counter

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "agree", "lib"))
sys.path.insert(0, os.path.join(HERE, "..", "lib"))
sys.path.insert(0, os.path.join(HERE, "..", "unsweep"))

from cells import around, random_cells, solid_of, state  # noqa: E402
from exact import Fraction as F  # noqa: E402
from motion import build, legs, rotation, translate  # noqa: E402
from prisms import Text, carried, mapped, prisms  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from solids import Mesh, Polygon, block, box_ring, prism, ring  # noqa: E402
from witnesses import check_witness  # noqa: E402

UNSWEEP = ("--operation", "unsweep")
REGULAR = (*UNSWEEP, "--regular")
SCENES, SPACE_SCENES, EACH, WITNESSES = 50, 30, 12, 1
SCALES = (8, 40, 200)  # of probes, beyond those of the point's own denominators
COMPASS = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (1, 1, 1), (1, -1, 2), (-2, 1, 3), (3, 1, -1), (-1, 5, 0)]
HALF = F(1, 2)


def quarter_turn(hi, times=1):
    """About the origin, counter-clockwise, by 2 times atan(t)."""
    return build([(0, hi, rotation([0, 1], times=times))])


def plane_scenes():
    """(name, solid, motion, {point: regular}), of points that are `on`."""
    square = Polygon([[box_ring(0, 0, 2, 2)]])
    # Figure 7 of [IS]: x, x + 2 in [0, 2] leaves x = 0, y in [0, 2]: a segment, which dangles with its ends.
    segment = {(0, 1): "no", (0, 0): "no", (0, 2): "no", (0, F(1, 2 ** 60)): "no"}
    yield "figure 7", square, legs([(0, 0), (2, 0)]), segment
    yield "figure 7 there and back", square, legs([(0, 0), (2, 0), (0, 0)]), segment
    # Moved by 2 - e: [0, e] x [0, 2], all of whose border is regular.
    for e in (F(1), F(1, 2 ** 60)):
        yield f"a thickness of {e}", square, legs([(0, 0), (2 - e, 0)]), {
            (0, 1): "yes", (e, 1): "yes", (0, 0): "yes", (e, 2): "yes", (e / 2, 0): "yes"}
    # Motions by (2, 2) leave the point (0, 0), whatever the way; closed motions around [0, 2]^2, [0, 2] x [0, 1] and [0, 1]^2 leave
    # the point, the segment x = 0, y in [0, 1], and the square [0, 1]^2.
    yield "a point", square, legs([(0, 0), (2, 2)]), {(0, 0): "no"}
    yield "a bent way", square, build([(0, 2, translate([[0, 1], [0, 0, HALF]]))]), {(0, 0): "no"}
    around_box = lambda x, y: legs([(0, 0), (x, 0), (x, y), (0, y), (0, 0)])  # noqa: E731
    yield "around a square", square, around_box(2, 2), {(0, 0): "no"}
    yield "around a rectangle", square, around_box(2, 1), {(0, 0): "no", (0, HALF): "no", (0, 1): "no"}
    yield "around a small square", square, around_box(1, 1), {(0, 0): "yes", (1, 1): "yes", (0, 1): "yes", (HALF, 1): "yes"}
    # [0, 2]^2 with [2, 4] x [0, 1], moved by (2, 0): [0, 2] x [0, 1], and above it x = 0, 1 <= y <= 2, which dangles
    # but for the corner where it joins.
    ell = Polygon([[ring((0, 0), (4, 0), (4, 1), (2, 1), (2, 2), (0, 2))]])
    joint = {(0, F(3, 2)): "no", (0, 2): "no", (0, 1): "yes", (0, 1 + F(1, 2 ** 60)): "no", (1, 1): "yes", (2, 1): "yes",
             (0, HALF): "yes", (0, 0): "yes"}
    yield "a segment on a rectangle", ell, legs([(0, 0), (2, 0)]), joint
    # Two squares that touch in (2, 2), moved along the diagonal by (1, 1): x and x + (1, 1) and all between are in one of
    # them or pass (2, 2). Off the diagonal P + (s, s) passes no pinch: U = [0, 1]^2, [2, 3]^2 and the diagonal between.
    pinch = Polygon([[box_ring(0, 0, 2, 2)], [box_ring(2, 2, 4, 4)]])
    yield "through a pinch", pinch, legs([(0, 0), (1, 1)]), {
        (F(3, 2), F(3, 2)): "no", (1, 1): "yes", (2, 2): "yes", (1, HALF): "yes", (3, F(5, 2)): "yes"}
    # A square turns about its corner. By a quarter turn only directions (1, 0) stay in it: the side y = 0, x <= 2, which
    # dangles; by more only the corner; by 2 atan(1/2), with direction (3, 4), the directions from (1, 0) to (4, 3), on which
    # 3 x = 4 y.
    yield "a quarter turn", square, quarter_turn(1), {(0, 0): "no", (1, 0): "no", (2, 0): "no"}
    yield "half a turn", square, quarter_turn(1, 2), {(0, 0): "no"}
    yield "a smaller turn", square, quarter_turn(HALF), {(0, 0): "yes", (1, 0): "yes", (2, 0): "yes", (F(4, 5), F(3, 5)): "yes"}
    # [-1, 1]^2 turns about its centre by a quarter: the unit disk and its corner squares' rest: r cos, r sin stay below 1
    # in size for all angles from that of P to a quarter more. (1, 0) and (0, 1) are on the disk; (-3/5, 4/5) too.
    centred = Polygon([[box_ring(-1, -1, 1, 1)]])
    yield "a disk", centred, quarter_turn(1), {(1, 0): "yes", (0, 1): "yes", (F(-3, 5), F(4, 5)): "yes"}
    # The square |x|, |y| <= 2 less |x| + |y| < 2: the corner triangles, which touch in (2, 0), (0, 2) and so on. Turned once
    # around, a point is in the square as long as r <= 2, and beyond the diamond as long as r >= 2: the circle r = 2.
    corners = Polygon([[ring((2 * x, 0), (2 * x, 2 * y), (0, 2 * y))] for x in (1, -1) for y in (1, -1)])
    once = Text({"dimension": 2, "pieces": [{"t": [0, 4], "transform": {"turn": {"quarters": 4}}}]})
    yield "a circle", corners, once, {(F(6, 5), F(8, 5)): "no", (F(-8, 5), F(6, 5)): "no", (2, 0): "no", (0, -2): "no"}
    # The band between y = 0 and y = 1, -4 <= x <= 4, moved by (t, t^2), |t| <= 1: the segment y = 0, |x| <= 3; a band up to
    # y = 1 + e is left with [0, e].
    for e, want in ((F(0), "no"), (F(1, 2 ** 60), "yes")):
        band = Polygon([[box_ring(-4, 0, 4, 1 + e)]])
        yield f"a parabola and {e}", band, build([(-1, 1, translate([[0, 1], [0, 0, 1]]))]), {
            (0, 0): want, (1, e): want, (3, 0): want, (-3, e / 2): want}


def space_scenes():
    cube = block(0, 0, 0, 2, 2, 2)
    yield "a facet", cube, legs([(0, 0, 0), (2, 0, 0)]), {(0, 1, 1): "no", (0, 0, 1): "no", (0, 2, 2): "no"}
    yield "an edge", cube, legs([(0, 0, 0), (2, 2, 0)]), {(0, 0, 1): "no", (0, 0, 0): "no", (0, 0, 2): "no"}
    yield "a vertex", cube, legs([(0, 0, 0), (2, 2, 2), (0, 1, 2)]), {(0, 0, 0): "no"}
    yield "a slab", cube, legs([(0, 0, 0), (1, 0, 0), (1, 1, 0)]), {
        (0, HALF, 1): "yes", (1, HALF, 1): "yes", (0, 0, 0): "yes", (1, 1, 2): "yes", (1, 1, 1): "yes"}
    # The plane scenes of an ell, over [0, 3], moved by (2, 0, 0) and by (2, 0, 3): that leaves height 0 alone.
    ell = prism(ring((0, 0), (4, 0), (4, 1), (2, 1), (2, 2), (0, 2)), 0, 3)
    yield "a wall on a box", ell, legs([(0, 0, 0), (2, 0, 0)]), {
        (0, F(3, 2), 1): "no", (0, 2, 3): "no", (0, 1, 1): "yes", (0, 1, 0): "yes", (1, 1, 1): "yes", (0, 0, 0): "yes"}
    yield "its floor", ell, legs([(0, 0, 0), (2, 0, 3)]), {(0, F(3, 2), 0): "no", (1, HALF, 0): "no", (1, 1, 0): "no"}
    # A cube turns about the edge x = y = 0 by a quarter: the square y = 0; by 2 atan(1/2) a wedge. Sheared by the same
    # map, both are.
    for name, hi, want in (("a turn about an edge", 1, "no"), ("less of it", HALF, "yes")):
        motion = build([(0, hi, rotation([0, 1], axis=[0, 0, 1], length=1))])
        yield name, cube, motion, {(0, 0, 1): want, (1, 0, 1): want, (1, 0, 0): want, (2, 0, 2): want}


def stacked(*layers):
    """Walls over rings between two heights, and facets at one, as (ring, low, high) and (ring, height, up or down)."""
    index, facets = {}, []
    for points, low, high in layers:
        lower, *upper = [[index.setdefault((*p, F(h)), len(index)) for p in points] for h in (low, high) if h not in ("up", "down")]
        for other in upper:
            facets += [[a, b, d, c] for a, b, c, d in zip(lower, lower[1:] + lower[:1], other, other[1:] + other[:1])]
        if not upper:
            facets.append(lower if high == "up" else lower[::-1])
    return Mesh(list(index), facets)


def shells():
    """The circle scene over heights, turned once around: at the height 0 one part ends and another one begins."""
    once = Text({"dimension": 3, "pieces": [{"t": [0, 4], "transform": {"turn": {"quarters": 4, "axis": [0, 0, 1]}}}]})
    arc = [(2, 0), (F(8, 5), F(6, 5)), (F(6, 5), F(8, 5)), (0, 2)]   # on the circle r = 2
    turned = [lambda p: p, lambda p: (-p[1], p[0]), lambda p: (-p[0], -p[1]), lambda p: (p[1], -p[0])]
    # Below, all of the square within the chords of the circle is left out; U is the cylinder |z| <= 1, r = 2.
    both = []
    for turn in turned:
        corner, inner = [turn(p) for p in ((2, 0), (2, 2), (0, 2))], [turn(p) for p in arc]
        outer = inner[:1] + corner[1:2] + inner[:0:-1]
        both += [(corner, 1, "up"), (corner, 0, 1), (inner, 0, "down"), (outer, -1, 0), (outer, -1, "down")]
    yield "two shells", stacked(*both), once, {
        **{(F(6, 5), F(8, 5), h): "no" for h in (-1, 0, 1)}, (2, 0, 0): "no"}
    # Below, nothing is left out; U is the disk r <= 2, -1 <= z <= 0, and the cylinder above it.
    square, middle = [turn((2, 2)) for turn in turned], [turn((2, 0)) for turn in turned]
    around = [p for pair in zip(middle, square) for p in pair]
    walls = [([turn(p) for p in ((2, 0), (2, 2), (0, 2))], 0, 1) for turn in turned]
    yield "a shell on a disk", stacked((around, -1, "down"), (around, -1, 0), (middle, 0, "up"), *walls,
                                       *((points, 1, "up") for points, _, _ in walls)), once, {
        (F(6, 5), F(8, 5), 0): "yes", (F(6, 5), F(8, 5), 1): "no", (2, 0, 1): "no", (F(6, 5), F(8, 5), F(1, 2)): "no"}


def rims(name, solid, motion, wants):
    """A scene of the plane over the heights 0 to 3, asked at both ends."""
    mesh = prisms([r for part in solid.parts for r in part], 0, 3)
    yield name + " rims", mesh, carried(json.loads(motion.text())), {
        mapped((*p, h)): want for p, want in wants.items() for h in (F(0), F(3))}


def check_rims(checks, graze, name, solid, motion, wants):
    for (point, want), answer in zip(wants.items(), graze.classify(name, solid, motion, list(wants), *REGULAR) or []):
        record = answer.record
        checks.equal((record["pmc"], record["regular"]), ("on", want), name, *point, record.get("regular_reason"))


def irrational(d):
    """(name, solid, motion, wants, level), with a contact at t = 1/sqrt(2). Along x a slab 0 <= x <= 1/4 + e goes by
    (t^2 - 1/2)^2, which is 1/4 at t = 0 and 1, and 0 between: x = 0 is left, or 0 <= x <= e. The other motion turns by
    2 atan(t) and moves (1, 0) to (-(2 t^2 - 1)^2, 0), in a block of x <= 0. At its one contact the cosine is 1/3: near (1, 0)
    the unsweep is dx <= 2 sqrt(2) dy to first order."""
    more = [F(0)] * (d - 2)

    def body(x0, x1):
        return Polygon([[box_ring(x0, -5, x1, 5)]]) if d == 2 else block(x0, -5, -5, x1, 5, 5)

    def moved(rows):
        return Text({"dimension": d, "pieces": [{"t": [0, 1], "transform": rows}]})

    for e, want, level in ((F(0), "no", "closed_cones"), (F(1, 8), "yes", "first_order")):
        way = moved({"translate": ["(t^2-1/2)^2", *["0"] * (d - 1)]})
        yield f"an irrational time and {e}", body(F(0), F(1, 4) + e), way, {(F(0), F(1), *more): want}, level
    turn = {"rotate": {"tan_half": "t", **({} if d == 2 else {"axis": [0, 0, 1]})}}
    shift = ["-(2*t^2-1)^2-(1-t^2)/(1+t^2)", "-2*t/(1+t^2)", "0"][:d]
    yield "an irrational turn", body(F(-20), F(0)), moved({"compose": [turn, {"translate": shift}]}), {
        (F(1), F(0), *more): "yes"}, "first_order"


def probes(point):
    d, own = len(point), max(x.denominator.bit_length() for x in point)
    ways = {u[:d] for v in COMPASS for u in (v, tuple(-x for x in v)) if any(u[:d])}
    return [tuple(x + F(y, 2 ** (k + own)) for x, y in zip(point, u)) for k in SCALES for u in sorted(ways)]


def check_point(checks, graze, files, where, point, record):
    """Evidence for what was said: a witness that is `in` all along, or nothing `in` nearby."""
    if record["regular"] == "yes":
        check_witness(checks, graze, where[0], files, point, record, "regular")
    else:
        found = graze.classify(where[0] + " near", *files, probes(point), *UNSWEEP) or []
        checks.holds(found and not any(a.record["pmc"] == "in" for a in found), *where, "near a `no`")


def check_hand(checks, graze, name, solid, motion, wants, level=None):
    points = [tuple(map(F, p)) for p in wants]
    answers = graze.classify(name, solid, motion, points, *REGULAR, table=True)
    for point, answer, want in zip(points, answers or [], wants.values()):
        where = (name, ",".join(map(str, point)), answer.word)
        checks.equal((answer.record["pmc"], answer.record["regular"]), ("on", want), *where, answer.record.get("regular_reason"))
        checks.equal(answer.row["regular"], want, *where, "table")
        checks.equal(answer.record.get("regular_level"), level or answer.record.get("regular_level"), *where)
        check_point(checks, graze, (solid, motion), where, point, answer.record)


def walk(rng, d):
    """Points of the grid, neighbours differing along one axis; closed now and then."""
    path = [(0,) * d]
    for _ in range(rng.randint(1, 4)):
        axis, step = rng.randrange(d), rng.choice([-2, -1, 1, 2])
        path.append(tuple(x + step * (k == axis) for k, x in enumerate(path[-1])))
    if rng.random() < 0.3:
        path += path[-2::-1]
    return path


def row(cell, a, b):
    """The cells through which one is carried from a to b, along one axis."""
    axis = next(k for k in range(len(a)) if a[k] != b[k])
    for x in range(min(a[axis], b[axis]), max(a[axis], b[axis]) + 1):
        yield tuple(c + (x if k == axis else y) for k, (c, y) in enumerate(zip(cell, a)))


def holds(cells, path, cell):
    return all(c in cells for a, b in zip(path, path[1:]) for c in row(cell, a, b))


def states(cells, path, point):
    """States of a point's trajectory, at its places on the grid and between."""
    for a, b in zip(path, path[1:]):
        ends = [[x + y for x, y in zip(point, p)] for p in (a, b)]
        axis = next(k for k in range(len(a)) if a[k] != b[k])
        low, high = sorted(p[axis] for p in ends)
        stops = sorted({low, high, *range(-(-low // 1), high // 1 + 1)})
        for x in (*stops, *((p + q) / 2 for p, q in zip(stops, stops[1:]))):
            yield state(cells, tuple(x if k == axis else y for k, y in enumerate(ends[0])))


def truth(cells, path, point):
    """pmc and regular."""
    seen = set(states(cells, path, point))
    pmc = "out" if "O" in seen else "on" if "B" in seen else "in"
    return pmc, "yes" if any(holds(cells, path, cell) for cell in around(point)) else "no"


def grid_points(rng, cells, path):
    """Half-grid points of the solid: of those that are `on`, as many that dangle as not, and a few others."""
    corners = sorted({tuple(x + F(k, 2) for x, k in zip(c, step)) for c in cells
                      for step in itertools.product(range(3), repeat=len(c))})
    rng.shuffle(corners)
    kept, left = [], Counter()
    for point in corners:
        said = truth(cells, path, point)
        if left[said] < (EACH if said[0] == "on" else 2):
            left[said] += 1
            kept.append((point, said))
    return kept


def check_grid(checks, graze, rng, seen, number, d):
    """One scene; returns how many of its points dangle."""
    cells, path = random_cells(rng, d), walk(rng, d)
    points = grid_points(rng, cells, path)
    if not any(said == ("on", "no") for _, said in points):
        return 0
    files = solid_of(cells), legs(path)
    answers = graze.classify(f"grid {d} {number}", *files, [p for p, _ in points], *REGULAR)
    shown = Counter()
    for (point, want), answer in zip(points, answers or []):
        record = answer.record
        where = (f"grid {d} {number}", path, sorted(cells), ",".join(map(str, point)), answer.word)
        checks.equal((record["pmc"], record["regular"]), want, *where, record.get("regular_level"))
        checks.equal(record.get("regular_level") == "word", want[0] != "on", *where)
        seen[d, *want, record.get("regular_level")] += 1
        shown[want] += 1
        if want[0] == "on" and shown[want] <= WITNESSES:
            check_point(checks, graze, files, where, point, record)
    return 1


def rows_of(text):
    return [line for line in text.splitlines() if not line.startswith("#")]


def check_table(checks, graze):
    """The column in tables, in parts, continued, exported, read again, and beside others; where it is refused."""
    files = [graze.write(name, text) for name, text in
             (("ell.wkt", "POLYGON((0 0,4 0,4 1,2 1,2 2,0 2,0 0))"), ("move.json", legs([(0, 0), (2, 0)]).text()))]
    points = graze.write("points.csv", "x,y,n\n1,1/2,a\n0,2,b\n0,1,c\n3,1/2,d\n0,3/2,e\n")
    wants = ["yes", "no", "yes", "no", "no"]
    whole = graze.call("classify", *files, points, *REGULAR, "--quiet")
    plain = graze.call("classify", *files, points, *UNSWEEP, "--quiet")
    checks.equal((whole.returncode, whole.stderr), (0, ""))
    checks.equal([line.rsplit(",", 1) for line in rows_of(whole.stdout)],
                 [[a, b] for a, b in zip(rows_of(plain.stdout), ["regular", *wants])])
    checks.holds("\n# regular yes\n" in whole.stdout and "regular" not in plain.stdout, whole.stdout)
    checks.equal(whole.stdout.splitlines()[-2:], ["# undecided 0", "# complete 5"])
    both = graze.call("classify", *files, points, *REGULAR, "--topo", "--sdf", "1/100", "--quiet").stdout
    checks.equal([line.rsplit(",", 2)[1:] for line in rows_of(both)],
                 [["topo", "regular"]] + [[w, v] for w, v in zip(("interior", "boundary", "boundary", "exterior", "boundary"), wants)])
    parts = [graze.write(f"part-{k}.csv", graze.call("classify", *files, points, *REGULAR, "--quiet", "--shard", f"{k + 1}/2").stdout)
             for k in range(2)]
    checks.equal(graze.call("merge", "--quiet", *parts).stdout, whole.stdout, "merged")
    lines = whole.stdout.splitlines(keepends=True)
    begun = graze.write("begun.csv", "".join(lines[:-4]))
    graze.call("classify", *files, points, *REGULAR, "--quiet", "--resume", begun)
    with open(begun, encoding="utf-8") as f:
        checks.equal(f.read(), whole.stdout, "continued")
    for table in (whole.stdout, both):
        again = graze.call("classify", *files, graze.write("again.csv", table), *UNSWEEP, "--quiet").stdout
        checks.equal(rows_of(again), rows_of(plain.stdout), "a table read again")
    for form in ("vtk", "npy"):
        made = graze.call("classify", *files, points, *REGULAR, "--quiet", "--format", form, "--output", graze.write("out." + form, ""))
        with open(os.path.join(graze.keep or graze.folder.name, "out." + form), "rb") as f:
            checks.holds(made.returncode == 0 and b"regular" in f.read(), form, made.stderr)
    for command, more in (("classify", [points]), ("explain", ["0", "2"])):
        said = graze.call(command, *files, *more, "--regular")
        checks.equal((said.returncode, said.stderr), (2, "graze: --regular is asked of an unsweep; expected --operation unsweep "
                                                         "beside it\n"), command)


def check_explain(checks, graze):
    files = [graze.write(name, text) for name, text in
             (("square.wkt", "POLYGON((0 0,2 0,2 2,0 2,0 0))"), ("figure.json", legs([(0, 0), (2, 0)]).text()))]
    said = graze.call("explain", *files, "0", "1", *REGULAR).stdout
    for words in ("Regular, in the closure of the unsweep's interior: it is `no`, by level `closed_cones`.\nThat is, closed cones",
                  "  at t = 0 and after, edge: dx <= 0\n  at t = 1 and before, edge: dx >= 0\n",
                  "that each covers, by what is outside the solid, to first order:\n"):
        checks.holds(words in said, words, said)
    half = graze.write("half.json", legs([(0, 0), (1, 0)]).text())
    said = graze.call("explain", files[0], half, "0", "1", *REGULAR).stdout
    checks.holds("it is `yes`, by level `first_order`." in said and "A point that is in: (" in said, said)
    checks.holds("Regular" not in graze.call("explain", *files, "0", "1", *UNSWEEP).stdout, "not asked")


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    seen = Counter()
    for scene in args.once((*plane_scenes(), *space_scenes(), *irrational(2), *irrational(3)), "hand"):
        check_hand(checks, graze, *scene)
    for scene in args.once((*shells(), *(rim for scene in plane_scenes() for rim in rims(*scene))), "rims"):
        check_rims(checks, graze, *scene)
    for d, scenes in ((2, SCENES), (3, SPACE_SCENES)):
        met = sum(check_grid(checks, graze, args.random, seen, k, d) for k in args.rounds(scenes, f"grid {d}"))
        checks.holds(met >= scenes / 3 * args.share, d, "scenes with parts that dangle:", met)
    for key, n in sorted(seen.items(), key=str):
        print(*key, n)
    if args.derived:
        check_table(checks, graze)
        check_explain(checks, graze)
    checks.finish()


if __name__ == "__main__":
    main()
