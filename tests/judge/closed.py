# suite
"""Meshes whose distances from the sweep are known in closed form: every enclosure holds them.

SPDX-License-Identifier: GPL-3.0-or-later

*Boxes.* [0, 2]^3 along x by 8 sweeps W = [0, 10] x [0, 2]^2. E(x), the way from x in W to the outside, is the least of its distances to the
six faces; D(x), from x outside W, is the distance to the box. A turned scene has the same distances.
*Turning box.* [-3, 3] x [-4, 4] x [0, 1] by half a turn about z sweeps the cylinder of radius 5: every point of the
disk is in the rectangle's copy that has its direction as diagonal; so does a longer turn, in one piece whose weight 1 + (4t - 2)^2 = 5 - 16t + 16t^2 has a
negative Bernstein coefficient, 5, -3, 5. A prism over a regular n-gon inscribed (circumscribed) is off by 5 - 5 cos(pi/n)
(5/cos(pi/n) - 5) at most: in the middles of its sides (at its upright edges). Between z = 0 and z = 1 floor and roof are no further than 1/2; from
the cylinder to the sides around it is 5 - 5 cos(pi/n) too.
*Hulls.* A convex solid moved straight by b sweeps the hull of its corners v and v + b. From a mesh that is that hull times q > 1 about an inner
point, D is greatest at a corner, as it is convex.
"""
import itertools
import math
import os

from judged import KEYS, ROUNDING, Checks, Judge, Mesh, block, options, to_triangle, triangles, volume_of, without
from exact import Fraction as F, to_double

from motion import build, translate  # noqa: E402
from harness import ROOT as HOME  # noqa: E402
from solids import cross, joined, minus  # noqa: E402

WITHIN = "1/4"
CUBE = block(0, 0, 0, 2, 2, 2)
ALONG = build([(0, 1, translate([[0, 8], [0], [0]]))])
W = block(0, 0, 0, 10, 2, 2)
ROOT = math.sqrt



def perfect(judge, checks):
    """Meshes that are the boundary: cubes moved straight, three defaults of the width. The unit cube moved by b > 0 sweeps its hull with the copy,
    1 + b1 + b2 + b3 in volume. The same box displaced by 1/2 along z has as much missing as excess, half of its five units."""
    one = triangles(block(0, 0, 0, 1, 1, 1))
    for b in ((4, 0, 0), (3, 1, 2), (F(1, 3), F(7, 5), F(1, 7))):
        name = f"moved by {b}"
        mesh = hull_of_pairs(one, b) if b[1] else triangles(block(0, 0, 0, 5, 1, 1))
        motion = build([(0, 1, translate([[0, x] for x in b]))])
        report = judge.ask(name, one, motion, mesh)
        if report:
            judge.holds(name, report, (0, 0, 0), 1 + sum(b), report["budget"]["within"])
            judge.differs(name, report, 0, 0, 1e-3)
            v = report["volume"]["sweep"]
            checks.holds(v["high"] - v["low"] <= 0.001 * to_double(1 + sum(b)), name, "volume", v)
            checks.holds(report["budget"]["cells"] < 20000, name, "cells", report["budget"])
    report = judge.ask("displaced", one, build([(0, 1, translate([[0, 4], [0], [0]]))]), block(0, 0, F(1, 2), 5, 1, F(3, 2)), "--within", "1/10")
    if report:
        judge.differs("displaced", report, F(5, 2), F(5, 2))
        checks.holds(report["volume"]["missing"]["low"] > 1 and report["volume"]["excess"]["low"] > 1, "displaced", report["volume"])
    # A wall of no thickness inside is no boundary: both its triangles, one on the other, are 1/2 from the outside.
    wall = triangles(block(0, 0, 0, 5, 1, 1))
    n = len(wall.vertices)
    inner = [(F(5, 2), F(1, 4), F(1, 4)), (F(5, 2), F(3, 4), F(1, 4)), (F(5, 2), F(1, 2), F(1, 2))]
    wall = Mesh(wall.vertices + inner, wall.facets + [[n, n + 1, n + 2], [n, n + 2, n + 1]])
    report = judge.ask("with a wall", one, build([(0, 1, translate([[0, 4], [0], [0]]))]), wall, "--within", "1/10")
    if report:
        judge.holds("with a wall", report, (0, F(1, 2), 0), 5, F(1, 10))
        judge.differs("with a wall", report, 0, 0)


def dented():
    """W with a pyramid pressed into x = 10: over the middle square of side 1, 1/4 deep."""
    box = without(W, 5)
    n = len(box.vertices)
    inner = [(10, y, z) for y, z in ((F(1, 2), F(1, 2)), (F(3, 2), F(1, 2)), (F(3, 2), F(3, 2)), (F(1, 2), F(3, 2)))]
    outer = [1, 3, 7, 5]
    ring = [f for k in range(4) for m in [(k + 1) % 4] for f in ([outer[k], outer[m], n + m], [outer[k], n + m, n + k])]
    return Mesh(box.vertices + inner + [(F(39, 4), 1, 1)], box.facets + ring + [[n + k, n + (k + 1) % 4, n + 4] for k in range(4)])


def flipped():
    mesh = triangles(W)
    return Mesh(mesh.vertices, [f[::-1] if k in (3, 8) else f for k, f in enumerate(mesh.facets)])


# name, mesh, greatest D over the mesh, greatest E over it, greatest distance of the boundary of W from it
BOXES = [
    ("itself", W, 0, 0, 0),
    ("short", block(0, 0, 0, 9, 2, 2), 0, 1, 1),          # the middle of x = 9; the corners of x = 10
    ("long", block(0, 0, 0, 11, 2, 2), 1, 0, 1),          # x = 11; the middle of x = 10
    ("large", block(-1, -1, -1, 11, 3, 3), ROOT(3), 0, 1),  # corners; everywhere
    ("small", block(1, F(1, 2), F(1, 2), 9, F(3, 2), F(3, 2)), 0, 1, ROOT(1.5)),  # the middle of x = 1; corners
    ("shifted", block(0, 0, 1, 10, 2, 3), 1, 1, 1),       # z = 3; the middle of z = 1; the face z = 0
    ("open", without(W, 5), 0, 0, 1),                     # x = 10 is missing: its middle
    ("a hole", without(triangles(W), 10), 0, 0, 2 - ROOT(2)),  # the inscribed circle of a half of x = 10
    ("a shell outside", joined(W, block(12, 1, 1, F(49, 4), F(5, 4), F(5, 4))), F(9, 4), 0, 0),
    ("a shell inside", joined(W, block(5, F(7, 8), F(7, 8), F(21, 4), F(9, 8), F(9, 8))), 0, 1, 0),
    ("a dent", dented(), 0, F(1, 4), ROOT(0.05)),         # its tip; from the middle of x = 10 to its sides, 1/8 / sqrt(5/16)
    ("flipped", flipped(), 0, 0, 0),
    ("inward", W.mapped(lambda p: p, True), 0, 0, 0),
    ("one triangle", Mesh([(5, 1, 1), (6, 1, 1), (5, F(3, 2), 1)], [[0, 1, 2]]), 0, 1, None),
]


# 40 + 1/64 with a shell; the pyramid has 1/12
VOLUMES = {"itself": "40", "short": "36", "long": "44", "large": "192", "small": "8", "shifted": "40",
           "a shell outside": "2561/64", "a shell inside": "2561/64", "a dent": "479/12", "inward": "-40"}


# what of W = [0, 10] x [0, 2]^2 is not inside, and what inside is not in W: by rule, so for a shell inside W the mesh has more than once, too
DIFFERENCES = {"itself": (0, 0), "short": (4, 0), "long": (0, 4), "large": (0, 152), "small": (32, 0), "shifted": (20, 20),
               "a shell outside": (0, F(1, 64)), "a shell inside": (0, 0), "a dent": (F(1, 12), 0), "inward": (0, 0)}


def scenes_of_boxes(judge, checks, sanitizers):
    some = ("itself", "shifted", "open", "flipped", "one triangle")
    for name, mesh, outside, inside, sweep in [box for box in BOXES if not sanitizers or box[0] in some]:
        report = judge.ask(name, CUBE, ALONG, mesh, "--within", WITHIN)
        if report:
            judge.holds(name, report, (outside, inside, sweep), 40, F(WITHIN))
            times(checks, name, report)
            known = report["mesh"]["closed"]
            checks.equal(known, name not in ("open", "a hole", "one triangle"), name, "closed")
            rule = "none" if not known else "parity" if name == "flipped" else "winding"
            checks.equal(report["mesh"]["rule"], rule, name, "rule")
            volume = VOLUMES.get(name)
            checks.equal(report["volume"]["mesh"], volume if rule == "winding" else None, name, "volume")
            checks.equal(report["volume"]["missing"] is None, rule == "none", name, "missing")
            if name in DIFFERENCES:
                judge.differs(name, report, *DIFFERENCES[name])
    fine = judge.ask("a dent, finer", CUBE, ALONG, dented(), "--within", "1/12")
    if fine:
        judge.holds("a dent, finer", fine, (0, F(1, 4), ROOT(0.05)), 40, 1 / 12)
        checks.holds(fine["distance"]["mesh_to_sweep_inside"]["low"] > 0.16, "the dent is found", fine["distance"])
    for name, mesh, outside, inside, sweep in BOXES[:1 if sanitizers else 5]:
        move = rigid()
        moved = build([(0, 1, translate([[0, 8 * c] for c in direction()]))])
        report = judge.ask(name + " turned", CUBE.mapped(move), moved, mesh.mapped(move), "--within", WITHIN)
        if report:
            judge.holds(name + " turned", report, (outside, inside, sweep), 40, F(WITHIN))


def times(checks, name, report):
    """At `t` the cube is as near to the place as ever, to a 16th of the width: when its middle 8 t + 1 is nearest to it along x."""
    for key in KEYS:
        found = report["distance"][key]
        checks.equal(found["t"] is None, found["low"] == 0, name, key, found)
        if found["t"] is not None:
            at, best = found["at"], min(1.0, max(0.0, (found["at"][0] - 1) / 8))
            checks.holds(0 <= found["t"] <= 1 and to_cube(at, found["t"]) <= to_cube(at, best) + to_double(F(WITHIN)) / 16 + ROUNDING, name, key, found)


def to_cube(p, t):
    """The signed distance to [8 t, 8 t + 2] x [0, 2]^2."""
    past = [abs(x - m) - 1 for x, m in zip(p, (8 * t + 1, 1, 1))]
    return ROOT(sum(max(x, 0) ** 2 for x in past)) or max(past)


def direction():
    return F(2, 3), F(1, 3), F(2, 3)


def rigid():
    """A turn whose matrix has the columns (2, 1, 2)/3, (-2, 2, 1)/3, (-1, -2, 2)/3, and a shift."""
    rows = ((2, -2, -1), (1, 2, -2), (2, 1, 2))
    return lambda p: tuple(sum(F(a, 3) * x for a, x in zip(row, p)) + F(s) for row, s in zip(rows, ("1/7", -3, 5)))


def ngon(n, radius):
    return [(radius * math.cos(2 * math.pi * k / n), radius * math.sin(2 * math.pi * k / n)) for k in range(n)]


def prism_mesh(n, radius):
    ring = ngon(n, radius)
    return Mesh([(F(x), F(y), z) for z in (0, 1) for x, y in ring],
                [[0, k + 1, k] for k in range(1, n - 1)] + [[n, n + k, n + k + 1] for k in range(1, n - 1)]
                + [f for k in range(n) for m in [(k + 1) % n] for f in ([k, m, m + n], [k, m + n, k + n])])


def turning_box(judge, _):
    """A prism inscribed, and one circumscribed."""
    turned_by_half(judge, "circumscribed 6", 5 / math.cos(math.pi / 6), 6, "1/2")
    turned_by_half(judge, "inscribed 16", 5, 16, "1")


def turning_box_within_less(judge, _):
    """To half the width, which takes five times as long; and the longer turn."""
    turned_by_half(judge, "inscribed 16", 5, 16, "1/2")
    turned_by_half(judge, "a longer turn", 5, 6, "1/2", HALF_TURN.replace('{"turn": {"quarters": 2, ', '{"rotate": {"tan_half": "4*t - 2", '))


HALF_TURN = '{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"turn": {"quarters": 2, "axis": ["0", "0", "1"]}}}]}'


def turned_by_half(judge, name, radius, n, within, motion=HALF_TURN):
    """The prism over an n-gon whose corners are at `radius`, beside the cylinder of radius 5."""
    report = judge.ask(name, block(-3, -4, 0, 3, 4, 1), judge.graze.write("turn.json", motion), prism_mesh(n, radius), "--within", within)
    deepest = radius - radius * math.cos(math.pi / n)
    beyond = radius - 5
    if report:
        truth = (beyond, 0, min(deepest, 0.5)) if beyond else (0, min(deepest, 0.5), deepest)
        judge.holds(name, report, truth, 25 * math.pi, F(within))


def hull(points):
    """The convex hull of points, no four of them in one plane, as triangles; by all triples."""
    faces = []
    for i, j, k in itertools.combinations(range(len(points)), 3):
        n = cross(minus(points[j], points[i]), minus(points[k], points[i]))
        sides = {(lambda s: (s > 0) - (s < 0))(sum(a * b for a, b in zip(n, minus(p, points[i]))))
                 for m, p in enumerate(points) if m not in (i, j, k)}
        if len(sides) == 1:
            faces.append([i, j, k] if sides == {-1} else [i, k, j])
    used = sorted({v for f in faces for v in f})
    place = {v: m for m, v in enumerate(used)}
    return Mesh([points[v] for v in used], [[place[v] for v in f] for f in faces])


def scenes_of_hulls(judge, args):
    rng = args.random
    for k in args.rounds(1 if args.sanitizers else 4, "hulls"):
        points = [tuple(F(rng.randint(-64, 64), 16) for _ in range(3)) for _ in range(8)]
        b = [F(rng.randint(-64, 64), 8) + F(1, 3) for _ in range(3)]
        solid = hull(points)
        swept = hull_of_pairs(solid, b)
        motion = build([(0, 1, translate([[0, x] for x in b]))])
        middle = tuple(sum(p[i] for p in swept.vertices) / len(swept.vertices) for i in range(3))
        report = judge.ask(f"hull {k}", solid, motion, swept, "--within", "1e-1r")
        if report:
            judge.holds(f"hull {k}", report, (0, 0, 0), to_double(volume_of(swept)), report["budget"]["within"])
        q = F(rng.randint(9, 12), 8)
        large = swept.mapped(lambda p, q=q: tuple(m + q * (x - m) for x, m in zip(p, middle)))
        faces = [[[to_double(x) for x in swept.vertices[v]] for v in f] for f in swept.facets]
        far = max(min(to_triangle([to_double(x) for x in p], *f) for f in faces) for p in large.vertices)
        report = judge.ask(f"hull {k} larger", solid, motion, large, "--within", "1e-1r")
        if report:
            judge.holds(f"hull {k} larger", report, (far, 0, None), to_double(volume_of(swept)), report["budget"]["within"])


def hull_of_pairs(solid, b):
    """The hull of v and v + b: faces of the solid on their side, and a parallelogram, as two triangles, at each edge between both sides."""
    ahead = {}
    for f in solid.facets:
        p, q, r = (solid.vertices[v] for v in f)
        ahead[tuple(f)] = sum(x * y for x, y in zip(cross(minus(q, p), minus(r, p)), b)) > 0
    n = len(solid.vertices)
    faces = [[v + n * side for v in f] for f, side in ((f, ahead[tuple(f)]) for f in solid.facets)]
    sides = {(u, v): ahead[tuple(f)] for f in solid.facets for u, v in zip(f, f[1:] + f[:1])}
    for (u, v), front in sides.items():
        if not front and sides[(v, u)]:
            faces += [[v, u, u + n], [v, u + n, v + n]]
    return Mesh(solid.vertices + [tuple(x + s for x, s in zip(p, b)) for p in solid.vertices], faces)


def budgets(judge, checks):
    """A larger budget gives enclosures within those of a smaller one; all hold the truth."""
    name, mesh, *truth = BOXES[1]
    before = None
    for budget in (1, 30, 300, 3000, 30000):
        report = judge.ask(f"budget {budget}", CUBE, ALONG, mesh, "--within", WITHIN, "--budget", str(budget))
        if not report:
            continue
        judge.holds(f"budget {budget}", report, truth, 40)
        checks.holds(budget > 300 or not report["budget"]["reached"], "budget", budget)
        now = [report["distance"][k] for k in ("mesh_to_sweep_outside", "mesh_to_sweep_inside", "sweep_to_mesh")]
        now.append(report["volume"]["sweep"])
        for old, new in zip(before or now, now):
            checks.holds(old["low"] <= new["low"] and new["high"] <= old["high"], "budget", budget, old, new)
        before = now


def jobs(judge, checks):
    """Threads change nothing but the time: to the width, and where the budget ends among the cubes that are cut for the volume."""
    files = [os.path.join(HOME, "cases", "bracket", name) for name in ("solid.off", "motion.json", "solid.off")]
    searched, volumes = [], set()
    for budget in ("15200", "16400", "1000000"):
        reports = [judge.ask(f"jobs {n}", *files, "--within", "5e-2r", "--budget", budget, "--jobs", n) for n in ("1", "3")]
        checks.equal(reports[0], reports[1], "--jobs", budget)
        if reports[0]:
            searched.append(reports[0]["distance"])
            volumes.add(reports[0]["volume"]["sweep"]["low"])
    checks.equal((searched[1:], len(volumes)), (searched[:1] * 2, 3), "the budget ends among cubes of the volume")


def fail_above(judge, checks):
    """Exit status 1 where a distance is certainly more; the report is made all the same."""
    name, mesh = BOXES[2][:2]
    files = [judge.graze.write(n, t.text()) for n, t in (("s.off", CUBE), ("m.json", ALONG), ("long.off", mesh))]
    for limit, status in (("1/2", 1), ("2", 0), ("0", 1)):
        out = judge.graze.call("judge", *files, "--within", WITHIN, "--fail-above", limit, "--no-points")
        checks.equal(out.returncode, status, name, "--fail-above", limit)
        checks.holds(out.stdout.startswith("mesh: 12 triangles"), name, out.stdout[:80])


def vertices(judge, checks):
    """The vertices of the long box: those of x = 11 are 1 away, the others on the boundary."""
    name, mesh = BOXES[2][:2]
    files = [judge.graze.write(n, t.text()) for n, t in (("s.off", CUBE), ("m.json", ALONG), ("long.off", mesh))]
    table = judge.graze.write("v.csv", "")
    out = judge.graze.call("judge", *files, "--within", "1e-6", "--budget", "1", "--no-points", "--vertices", table)
    checks.equal(out.returncode, 0, name, "--vertices", out.stderr)
    with open(table, encoding="utf-8") as file:
        head, *rows = file.read().splitlines()
    checks.equal(head, "x,y,z,pmc,sdf_low,sdf_high", name, "head")
    checks.equal(len(rows), len(mesh.vertices), name, "rows")
    for row, point in zip(rows, mesh.vertices):
        x, y, z, pmc, low, high = row.split(",")
        true, answer = (1, "out") if point[0] == 11 else (0, "on")
        checks.equal(((F(x), F(y), F(z)), pmc), (point, answer), name, row)
        checks.holds(F(low) <= true <= F(high) and F(high) - F(low) <= F("2e-6"), name, row)


def answers(judge, checks):
    """The short box, which ends at x = 9."""
    files = [judge.graze.write(n, t.text()) for n, t in (("s.off", CUBE), ("m.json", ALONG), ("short.off", BOXES[1][1]))]
    points = judge.graze.write("asked.csv", "id,x,y,z\na,5,1,1\nb,9,1/3,1\nc,9.5,1,1\n")
    table = judge.graze.write("said.csv", "")
    out = judge.graze.call("judge", *files, "--within", "1", "--budget", "1", "--points", points, "--answers", table)
    checks.equal(out.returncode, 0, "--answers", out.stderr)
    with open(table, encoding="utf-8") as file:
        head, body = file.read().split("x,y,z,pmc\n")
    checks.equal(body, "5,1,1,in\n9,1/3,1,on\n19/2,1,1,out\n# complete 3\n", "--answers")
    checks.equal(head.splitlines()[1:], ["# answers-of mesh", "# inside winding"], "--answers, head")
    checks.holds("rows stand below" in out.stdout, "rows below")  # (19/2, 1, 1) is in W: a wrong row, which is shown
    right = judge.graze.call("judge", *files[:2], judge.graze.write("right.off", W.text()), "--within", "1", "--budget", "1", "--points", points)
    checks.holds("wrong: 0.00 %" in right.stdout and "rows stand below" not in right.stdout, "no rows below", right.stdout)
    golden = judge.graze.write("golden.csv", judge.graze.call("classify", *files[:2], points).stdout)
    again = judge.graze.call("compare", golden, table, "--on-as", "any")
    checks.holds("wrong: 66.67 % of the rows" in again.stdout,  # (9, 1/3, 1) too: `on` the mesh, in W
                  "compare takes the answers", again.stdout[-300:], again.stderr)
    files[2] = judge.graze.write("flipped.off", flipped().text())
    out = judge.graze.call("judge", *files, "--within", "1", "--budget", "1", "--points", points, "--answers", table)
    with open(table, encoding="utf-8") as file:
        checks.holds("# inside parity\n" in file.read(), "--answers by parity")
    files[2] = judge.graze.write("open.off", without(W, 5).text())
    out = judge.graze.call("judge", *files, "--within", "1", "--budget", "1", "--points", points, "--answers", table)
    checks.equal(out.returncode, 3, "--answers of an open mesh")
    checks.holds("the mesh is not closed and has no answers; expected a closed one" in out.stderr, "--answers of an open mesh", out.stderr)


def windings(judge, checks):
    """Winding numbers inside: -1 in a box that faces inward, 2 in one given twice, 2 in the overlap of two; 1 and 0 in a hollow box, whose
    inner walls face the hollow. With a limit the files of meshes that are no boundary of a solid end with status 1."""
    hollow = joined(W, block(5, F(7, 8), F(7, 8), F(21, 4), F(9, 8), F(9, 8)).mapped(lambda p: p, True))
    files = [judge.graze.write(n, t.text()) for n, t in (("s.off", CUBE), ("m.json", ALONG))]
    quick = ["--within", "1", "--budget", "1", "--no-points"]
    for name, mesh, found, says in (
            ("inward", W.mapped(lambda p: p, True), [-1, 0], "closed and oriented, faces inward\n"),
            ("twice", joined(W, W), [0, 2], "closed and oriented; its winding number is 2 in places\n"),
            ("overlap", joined(W, block(1, 1, 1, 11, 3, 3)), [0, 2], "closed and oriented; its winding number is 2 in places\n"),
            ("inward and twice", joined(W, W).mapped(lambda p: p, True), [-2, 0], ", faces inward; its winding number is -2 in places\n"),
            ("a shell inward", joined(W, block(12, 0, 0, 14, 2, 2).mapped(lambda p: p, True)), [-1, 1], "oriented; its winding number is -1 in places\n"),
            ("hollow", hollow, [0, 1], "closed and oriented\n"), ("itself", W, [0, 1], "closed and oriented\n"),
            ("flipped", flipped(), None, "inside by parity, no volume\n")):
        path = judge.graze.write("wound.off", mesh.text())
        for flags, status in (([], 0), (["--fail-above", "100"], int(found is not None and (found[0] < 0 or found[1] > 1)))):
            out = judge.graze.call("judge", *files, path, *quick, *flags)
            checks.equal(out.returncode, status, name, *flags, out.stderr)
            checks.holds(says in out.stdout, name, says, out.stdout[:200])
        report = judge.ask(name, CUBE, ALONG, mesh, "--within", "1", "--budget", "1")
        checks.equal(report and report["mesh"]["windings"], found, name, "windings")


def seam(judge, checks):
    """[0, 2]^3 up by 8 along y, over by 2 along x and back down sweeps [0, 4] x [0, 10] x [0, 2]; the points of x = 2, y < 8, which both
    legs touch, are in its interior and in no copy's: a copy of either leg covers their neighbourhood together."""
    motion = build([(0, 1, translate([[0], [0, 8], [0]])), (1, 2, translate([[-2, 2], [8], [0]])),
                    (2, 3, translate([[2], [24, -8], [0]]))])
    whole = judge.ask("seam", CUBE, motion, block(0, 0, 0, 4, 10, 2), "--within", "1/2")
    if whole:
        judge.holds("seam", whole, (0, 0, 0), 80, F(1, 2))
    # The middle of its face x = 3 is 1 from x = 4 and z = 0; of W a corner of y = 0 is furthest, at (0, 0, 0): (3, 1, 1/2) away.
    inner = judge.ask("seam, inner", CUBE, motion, block(3, 1, F(1, 2), F(7, 2), 9, F(3, 2)), "--within", "1/2")
    if inner:
        judge.holds("seam, inner", inner, (0, 1, ROOT(10.25)), 80, F(1, 2))
    # The middle of its face x = 2, in the seam, is 1 from the outside; (0, 10, 0) is (2, 3, 1/2) away.
    along = judge.ask("seam, along", CUBE, motion, block(2, 1, F(1, 2), F(5, 2), 7, F(3, 2)), "--within", "1/4")
    if along:
        judge.holds("seam, along", along, (0, 1, ROOT(13.25)), 80, F(1, 4))


def axis(judge, checks):
    """[0, 1] x [0, 1/2] x [0, 1] by a whole turn about z sweeps the cylinder of radius R = sqrt(5/4); its edge on the axis touches that all
    the time, so no copy has the axis inside. A prism of 24 sides on it is R - R cos(pi/24) off at most."""
    radius = ROOT(1.25)
    path = judge.graze.write("turn.json", '{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"turn": {"quarters": 4, "axis": ["0", "0", "1"]}}}]}')
    report = judge.ask("axis", block(0, 0, 0, 1, F(1, 2), 1), path, prism_mesh(24, radius), "--within", "1/4")
    sagitta = radius - radius * math.cos(math.pi / 24)
    if report:
        judge.holds("axis", report, (0, sagitta, sagitta), 1.25 * math.pi, F(1, 4))


def curved_seam(judge, checks):
    """[0, 3] x [0, 4] sweeps the disk of radius 5, [5, 6] x [-1, 1] the ring from 5 to sqrt(37), both of height 2: few copies of both cover no
    piece of the circle between them, which is inside. It stays open, and the bounds hold."""
    path = judge.graze.write("turns.json", '{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"turn": {"quarters": 4, "axis": ["0", "0", "1"]}}}]}')
    both, radius = joined(block(0, 0, 0, 3, 4, 2), block(5, -1, 0, 6, 1, 2)), ROOT(37)
    tall = prism_mesh(24, radius).mapped(lambda p: (p[0], p[1], 2 * p[2]))
    report = judge.ask("curved seam", both, path, tall, "--within", "1/2")
    sagitta = radius - radius * math.cos(math.pi / 24)
    if report:
        judge.holds("curved seam", report, (0, sagitta, sagitta), 74 * math.pi)
        found = report["distance"]["sweep_to_mesh"]
        checks.holds(found["stuck"] and abs(ROOT(sum(x * x for x in found["open"][:2])) - 5) < 1 / 8, "curved seam", found)


def far_off(judge, checks):
    """Corners so far away that doubles cannot tell their distances to the width: that search alone ends, and soon. Of the triangle (1, 1, 1),
    (10^15, 1, 1), (1, 3, 1) the last but one is 10^15 - 10 from x = 10; the middle of z = 1 is 1 from the outside; near (0, 0, 2) W is 1 away
    from the plane z = 1. A vertex of no facet, however far, does not count."""
    lone = Mesh([(1, 1, 1), (F(10) ** 15, 1, 1), (1, 3, 1)], [[0, 1, 2]])
    report = judge.ask("far", CUBE, ALONG, lone, "--within", "1/10", "--budget", "100000")
    if report:
        judge.holds("far", report, (10 ** 15 - 10, 1, None), 40)
        found = report["distance"]["mesh_to_sweep_outside"]
        checks.holds(found["stuck"] and found["high"] - found["low"] < 1e3, "far", found)
        checks.holds(report["budget"]["cells"] < 100000 and report["volume"]["sweep"]["high"] < 50, "far", "the others go on", report["budget"])
    for name, vertices in (("unused", [(F(10) ** 400, 0, 0)]), ("used", [])):
        mesh = Mesh([(0, 0, 0), (0, 0, 2), (0, 2, 2), *vertices], [[0, 1, 2]])
        report = judge.ask(name, CUBE, ALONG, mesh, "--within", "1/4")
        if report:
            judge.holds(name, report, (0, 0, None), 40, F(1, 4))


def in_a_seam(judge, checks):
    """A triangle in the seam y = 2 of [0, 4]^3, in which copies of both halves meet: its corner (2, 2, 3) is 1 from the outside, (3, 2, 2) and (1, 2, 2)
    too, its middle (2, 2, 7/3) 5/3; on the side from (1, 2, 2) to (2, 2, 3) the least of x and 4 - z is greatest in its middle, 3/2; of all the triangle
    at (2, 2, 2), where it is 2. Of the boundary a corner is furthest: (4, 0, 0) is (1, 2, 2) from (3, 2, 2)."""
    halves = joined(block(0, 0, 0, 4, 1, 4), block(0, 2, 0, 4, 3, 4))
    motion = build([(0, 1, translate([[0], [0, 1], [0]]))])
    report = judge.ask("in a seam", halves, motion, Mesh([(1, 2, 2), (3, 2, 2), (2, 2, 3)], [[0, 1, 2]]), "--within", "1/10", "--budget", "40000")
    if report:
        judge.holds("in a seam", report, (0, 2, 3), 64)


def empty(judge, checks):
    """No facet: the volume of the sweep is that of all."""
    report = judge.ask("empty", CUBE, ALONG, Mesh([(0, 0, 0)], []), "--within", "1/2")
    if report:
        v = report["volume"]["sweep"]
        checks.holds(35 < v["low"] <= 40 <= v["high"] < 70, "empty", v)


def laws(judge, checks):
    """Scenes without closed form: bounds for two widths have a number in common, and agree with single vertices."""
    for name in ("bracket",):
        folder = os.path.join(HOME, "cases", name)
        files = [os.path.join(folder, "solid.off"), os.path.join(folder, "motion.json")]
        mesh = os.path.join(HOME, "cases", "bracket", "solid.off")
        table = judge.graze.write("v.csv", "")
        reports = [judge.ask(name, *files, mesh, "--within", w, *more)
                   for w, more in (("1e-1r", ["--vertices", table]), ("5e-2r", []))]
        if None in reports:
            continue
        for key in KEYS:
            a, b = (r["distance"][key] for r in reports)
            checks.holds(max(a["low"], b["low"]) <= min(a["high"], b["high"]), name, key, a, b)
        a, b = (r["volume"]["sweep"] for r in reports)
        checks.holds(max(a["low"], b["low"]) <= min(a["high"], b["high"]), name, "volume", a, b)
        with open(table, encoding="utf-8") as file:
            sdf = [[float(x) for x in row.split(",")[4:]] for row in file.read().splitlines()[1:]]
        high = reports[1]["distance"]["mesh_to_sweep_outside"]["high"]
        checks.holds(max(low for low, _ in sdf) <= high, name, "vertices outside", high)
        high = reports[1]["distance"]["mesh_to_sweep_inside"]["high"]
        checks.holds(max(-s for _, s in sdf) <= high, name, "vertices inside", high)


def texts(judge, checks):
    """The report in words, with what a mesh lacks."""
    files = [judge.graze.write(n, t.text()) for n, t in (("s.off", CUBE), ("m.json", ALONG))]
    far = Mesh([(20, 0, 0), (21, 0, 0), (20, 1, 0), (22, 0, 0), (21, 1, 0), (20, 2, 0), (19, 5, 5), (18, 5, 5), (17, 6, 5), (3, 3, 3)],
               [[0, 1, 2], [1, 3, 4], [2, 4, 5], [6, 7, 8], [0, 1, 3]])
    seen = {}
    for name, mesh, flags in (("empty", Mesh([], []), []), ("flipped", flipped(), ["--format", "markdown"]), ("far", far, []),
                              ("short", BOXES[1][1], ["--budget", "40", "--count", "5"])):
        out = judge.graze.call("judge", *files, judge.graze.write(name + ".off", mesh.text()), "--within", "1", *flags)
        checks.equal(out.returncode, 0, name, out.stderr)
        seen[name] = out.stdout
    for name, texts_of in {"empty": ["mesh: 0 triangles, 0 components, empty", "from the mesh: infinite: the mesh is empty"],
                           "flipped": ["- mesh: 12 triangles, 1 component, closed, not oriented; inside by parity, no volume",
                                       "- edges, by vertices, with the number of triangles each way: ",
                                       "| greatest distance of the | enclosure |", "- width 1 reached; "],
                           "far": ["mesh: 4 triangles, 4 components, 1 more without area, open", ", ...\n"],
                           "short": ["mesh: 12 triangles, 1 component, closed and oriented", "; the budget is spent, open near (",
                                     "volume of the mesh: [36, 36]", "width 1 not reached; ", "| golden pmc"]}.items():
        for text in texts_of:
            checks.holds(text in seen[name], name, text, seen[name])


def vtk(judge, checks):
    """The mesh with the same numbers as data of its points."""
    files = [judge.graze.write(n, t.text()) for n, t in (("s.off", CUBE), ("m.json", ALONG), ("long.off", BOXES[2][1]))]
    path = judge.graze.write("v.vtk", "")
    out = judge.graze.call("judge", *files, "--within", "1e-6", "--budget", "1", "--no-points", "--vertices", path)
    checks.equal(out.returncode, 0, "vtk", out.stderr)
    with open(path, encoding="ascii") as file:
        lines = file.read().splitlines()
    at = lines.index("POINTS 8 double")
    points = [tuple(F(x) for x in line.split()) for line in lines[at + 1:at + 9]]
    checks.equal(points, BOXES[2][1].vertices, "vtk", "points")
    at = lines.index("CELLS 12 48")
    checks.equal(sorted(set(line.split()[0] for line in lines[at + 1:at + 13])), ["3"], "vtk", "cells")
    for name, true in (("sdf_low", 1), ("sdf_high", 1)):
        at = next(k for k, line in enumerate(lines) if line.startswith("SCALARS " + name))
        for line, point in zip(lines[at + 2:at + 10], points):
            checks.holds(abs(float(line) - (true if point[0] == 11 else 0)) <= 1e-6, "vtk", name, line, point)
    at = next(k for k, line in enumerate(lines) if line.startswith("SCALARS pmc"))
    checks.equal([int(line) for line in lines[at + 2:at + 10]], [3 if p[0] == 11 else 2 for p in points], "vtk", "pmc")


def main():
    args = options("closed forms of distances between a mesh and a sweep")
    checks = Checks()
    judge = Judge(args, checks)
    if args.derived:
        scenes_of_boxes(judge, checks, args.sanitizers)
        parts = [budgets, fail_above, vertices, answers, windings, vtk, texts, empty, perfect, curved_seam, far_off]
        if not args.sanitizers:  # the same code as boxes, for longer
            parts += [in_a_seam, turning_box, seam, axis]
        for part in parts:
            part(judge, checks)
    scenes_of_hulls(judge, args)
    if args.to_the_end:
        turning_box_within_less(judge, checks)
    for law in args.once([] if args.sanitizers else [jobs, laws], "laws"):
        law(judge, checks)
    checks.finish()


if __name__ == "__main__":
    main()
