#!/usr/bin/env python3
# suite
"""`graze generate` on curved solids: every promise of a row by polynomials and power series in fractions, and `validate`.

SPDX-License-Identifier: GPL-3.0-or-later

Solids and motions are read by curvedfile.py and jets.py, which share nothing with the program. With y = M(t)^-1 P the
surfaces that vanish at y and matter there, their gradients, and the series of each polynomial along the trajectory tell
which stratum a point is of. Where the surfaces of a pair are tangent, their difference along the tangent plane tells an
isolated point from a seam. `graze classify` must have a contact at the time, with the primitive.
"""
import itertools
import json
import os
import stat
import sys
import tempfile
from collections import Counter

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "lib"), *(os.path.join(HERE, "..", folder) for folder in ("cases", "lib", "generate"))]

from exact import Fraction as F, to_double  # noqa: E402
from scenes import Curved, Motion, ball, box, capsule, cone, cylinder, minus, polynomial, torus, union  # noqa: E402  (before agree/lib has another)
import jets  # noqa: E402
from curvedfile import Solid  # noqa: E402
from curvedtrace import gradient, truth, value  # noqa: E402
from generate import Table, holds_time  # noqa: E402
from harness import ONLY, Checks, options, run  # noqa: E402

ROWS, SHARE = 16, 5
STRATA = ["random", "near", "face", "face-odd", "edge", "vertex", "crossing", "start", "end", "break", "slide", "miss"]
O = (0, 0, 0)
Z = (0, 0, 1)
FILLET = union(box((-4, -3, -4), (0, 3, 1)), box((-4, -3, -4), (1, 3, 0)), cylinder(O, (0, 3, 0), 1, -1, 1))
PLATE = minus(box((-3, -3, 0), (3, 3, 1)), cylinder(O, Z, 2, -1, 2))


def ellipse(a, b):
    return {"ellipsoid": {"semiaxes": [str(a), str(b)]}}


def motion(*transforms):
    d = len(transforms[0].get("translate", O))
    return Motion(d, [(k, k + 1, what) for k, what in enumerate(transforms)])


def moved(*path):
    return {"translate": list(path)}


BEND = motion(moved("2*t", "t^2", "0"), moved("2 + 3*(t-1)", "1", "t-1"))
TURN = Motion(3, [(0, 1, {"rotate": {"axis": ["0", "0", "1"], "tan_half": "t", "center": ["3", "0", "0"]}})])
SPIN = Motion(3, [(0, 1, {"rotate": {"axis": ["0", "0", "1"], "tan_half": "t"}})])
SCREW = Motion(3, [(0, 1, {"compose": [{"rotate": {"axis": ["0", "0", "1"], "tan_half": "t"}}, moved("0", "0", "4*t")]})])
ACROSS = motion(moved("4*t", "0", "0"), moved("4", "3*(t-1)", "0"))
ALONG = motion(moved("0", "0", "4*t"), moved("2*(t-1)", "0", "4"))
DIVE = motion(moved("3*t", "0", "-4*t"), moved("3", "t-1", "-4"))
PLANE = motion(moved("3*t", "t^2"), moved("3", "1 + t - 1"))
# scene: its strata but random, start, end, crossing and miss, which all have; why the others cannot be is geometry
SCENES = {
    "ball-bend": (3, ball(O, 1), BEND, "near face break"),
    "ball-turn": (3, ball((1, 0, 0), 1), TURN, "near face"),
    "cylinder-along": (3, cylinder(O, Z, 1, 0, 2), ALONG, "near face edge break slide"),
    "cylinder-screw": (3, cylinder(O, Z, 1, 0, 2), SCREW, "edge slide"),
    "cylinder-turn": (3, cylinder((1, 1, 0), (2, 1, 2), 1, 0, 1), TURN, "near face edge"),
    "cone-bend": (3, cone(O, Z, "1/2", 2), BEND, "near face edge vertex break slide"),
    "torus-across": (3, torus(O, Z, 2, 1), ACROSS, "near face break"),
    "torus-bend": (3, torus(O, (0, 3, 4), 2, "1/2"), BEND, "near face break"),
    "torus-spin": (3, torus(O, (0, 3, 4), 2, "1/2"), SPIN, "near face"),
    "capsule-bend": (3, capsule(O, (0, 0, 2), 1), BEND, "near face edge break"),
    "plate-across": (3, PLATE, ACROSS, "near face edge vertex break slide"),
    "fillet-dive": (3, FILLET, DIVE, "near face edge vertex break slide"),
    "touching-balls": (3, union(ball((-1, 0, 0), 1), ball((1, 0, 0), 1)), ACROSS, "near face vertex break"),
    "disk-plane": (2, ball((0, 0), 1), PLANE, "near face break"),
    "ellipse-plane": (2, union(ellipse(2, 1), box((-1, -3), (1, 0))), PLANE, "near face vertex break slide"),
}
# z <= -(x^2 + y^2)^2 without z <= 0 is empty, but no rule tells it at the origin.
FLAT = union(box((3, 3, 3), (4, 4, 4)),
             minus({"intersection": [polynomial({"0,0,1": 1, "4,0,0": 1, "2,2,0": 2, "0,4,0": 1}), box((-1, -1, -1), (1, 1, 1))]},
                   box((-2, -2, -2), (2, 2, 0))))


class Scene:
    def __init__(self, folder, name, dimension, node, path, made):
        self.name, self.d, self.made = name, dimension, made
        self.files = [os.path.join(folder, f"{name}.csg.json"), os.path.join(folder, f"{name}.json")]
        for file, thing in zip(self.files, (Curved(dimension, node), path)):
            with open(file, "w", encoding="utf-8") as out:
                out.write(thing.text())
        self.solid, self.motion = Solid(self.files[0]), jets.load(self.files[1])
        self.breaks, self.maps = jets.breaks(self.motion), {}

    def trajectory(self, point, t):
        """The series of the inverted trajectory at t, and A^-1."""
        if t not in self.maps:
            self.maps[t] = jets.inverse(jets.matrix_at(self.motion, t))
        rows = self.maps[t][:self.d]
        return ([sum((row[j] * x for j, x in enumerate(point)), row[self.d]) for row in rows],
                [[x.terms[0] for x in row[:self.d]] for row in rows])


def series(f, c):
    return sum((jets.jet(a) * product(x ** e for x, e in zip(c, powers) if e) for powers, a in f.items()), jets.jet(0))


def product(factors):
    out = jets.jet(1)
    for x in factors:
        out = out * x
    return out


def proportional(f, g):
    key = next(iter(f))
    return f.keys() == g.keys() and all(f[k] * g[key] == g[k] * f[key] for k in f)


def mattering(solid, y):
    """The polynomials at y on whose signs the expression depends, of proportional ones the first."""
    zero = [k for k, f in enumerate(solid.polynomials) if value(f, y) == 0]
    free = []
    for k in zero:
        if not any(proportional(solid.polynomials[k], solid.polynomials[j]) for j in free):
            free.append(k)
    owner = {}
    for k in zero:
        j = next(j for j in free if proportional(solid.polynomials[k], solid.polynomials[j]))
        key = next(iter(solid.polynomials[j]))
        owner[k] = (j, solid.polynomials[k][key] * solid.polynomials[j][key] > 0)
    fixed = [value(f, y) < 0 for f in solid.polynomials]

    def said(signs):
        negative = list(fixed)
        for k, (j, same) in owner.items():
            negative[k] = signs[free.index(j)] == same
        return truth(solid.tree, negative)
    table = {signs: said(signs) for signs in itertools.product((False, True), repeat=len(free))}
    return [k for n, k in enumerate(free)
            if any(table[s] != table[s[:n] + (not s[n],) + s[n + 1:]] for s in table)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def rank(rows):
    if not any(map(any, rows)):
        return 0
    first = next(r for r in rows if any(r))
    normals = [cross(first, r) for r in rows]
    if not any(map(any, normals)):
        return 1
    normal = next(n for n in normals if any(n))
    return 3 if any(dot(normal, r) for r in rows) else 2


def second(f, y, u, v):
    """The second derivative of f at y along u and v."""
    parts = [{tuple(e - (i == k) for k, e in enumerate(p)): c * p[i] for p, c in f.items() if p[i]} for i in range(3)]
    return sum(a * dot(gradient(g, y), v) for a, g in zip(u, parts) if g)


def is_isolated(solid, y, pair):
    """Whether two tangent surfaces have the one point in common, or a crossing of curves: by second derivatives of
    their difference along the tangent plane."""
    f, g = (solid.polynomials[k] for k in pair)
    a, b = gradient(f, y), gradient(g, y)
    at = next(i for i in range(3) if a[i])
    ways = [w for w in (cross(a, e) for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1))) if any(w)][:2]
    form = [[second(f, y, u, v) - a[at] / b[at] * second(g, y, u, v) for v in ways] for u in ways]
    return form[0][0] * form[1][1] != form[0][1] ** 2


def dimension_at(solid, y, matter):
    """The dimension of the boundary's cell at y; None for no boundary."""
    gradients = [gradient(solid.polynomials[k], y) for k in matter]
    if not matter:
        return None
    if not all(map(any, gradients)):
        return 0
    if len(matter) == 1:
        return solid.d - 1
    if solid.d == 2 or rank(gradients) == 3:
        return 0
    if rank(gradients) == 2:
        return 1
    return 0 if len(matter) == 2 and is_isolated(solid, y, matter) else 1


class Suite:
    def __init__(self, args, checks, folder):
        self.graze, self.checks, self.folder = args.graze, checks, folder
        self.seams, self.rows = 0, ROWS * max(1, int(args.scale))

    def generate(self, scene, count, seed, *more):
        done = run([self.graze, "generate", *scene.files, "-n", count, "--seed", seed, *more])
        self.checks.equal(done.returncode, 0, scene.name, *more, done.stderr)
        return done

    def classify(self, scene, text):
        path = os.path.join(self.folder, "points.csv")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        done = run([self.graze, "classify", *scene.files, path, "--format", "jsonl"])
        self.checks.equal(done.returncode, 0, scene.name, done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]


# --------------------------------------------------------------- rows

def check_contact(suite, scene, row, point, t, stratum):
    """A point that is not displaced: y is of the stratum's cell, and the order is that of one of its surfaces."""
    checks, where = suite.checks, (scene.name, json.dumps(row))
    c, _ = scene.trajectory(point, t)
    y = [x.terms[0] for x in c]
    matter = mattering(scene.solid, y)
    size = dimension_at(scene.solid, y, matter)
    wanted = {"edge": 1, "vertex": 0, **dict.fromkeys(("face", "face-odd", "crossing", "slide"), scene.d - 1)}.get(stratum, size)
    checks.equal(size, wanted, *where, "dimension of the cell of", y)
    checks.holds(size is not None, "y on the boundary", *where)
    orders = {series(scene.solid.polynomials[k], c).order() for k in matter}
    order = None if row["order"] == "slide" else int(row["order"])
    checks.holds(order in orders, f"order of {orders}", *where)
    fits = {"face": order is not None and order >= 2 and order % 2 == 0, "face-odd": order is not None and order % 2 == 1 and order > 1,
            "crossing": order == 1, "slide": order is None}
    checks.holds(fits.get(stratum, True), "the stratum's order", *where)
    if size == 1 and scene.d == 3:
        pairs = itertools.combinations([gradient(scene.solid.polynomials[k], y) for k in matter], 2)
        suite.seams += any(rank(pair) == 1 for pair in pairs)


def check_displaced(checks, scene, row, point, t):
    """A point displaced by 2^-k along the largest coordinate of a normal: the value of a surface there is about 2^-k times the
    normal's size, and where no other surface is near, its sign is that of the side."""
    c, back = scene.trajectory(point, t)
    y, k, where = [x.terms[0] for x in c], int(row["k"]), (scene.name, json.dumps(row))
    checks.holds(k in (range(4, 12) if row["stratum"] == "near" else range(8, 97, 8)), "k", *where)
    near = []
    for n, f in enumerate(scene.solid.polynomials):
        g = gradient(f, y)
        normal = [dot(g, [row_[j] for row_ in back]) for j in range(scene.d)]
        size, off = max(map(abs, normal)), abs(value(f, y)) * 2 ** k
        if size / 4 < off < 4 * scene.d * size:
            near.append(n)
    checks.holds(near, "a surface about 2^-k away", *where)
    negative = [value(f, y) < 0 for f in scene.solid.polynomials]
    close = [n for n, f in enumerate(scene.solid.polynomials) if abs(value(f, y)) < F(1, 64)]
    if k >= 16 and len(close) == 1 and near == close:
        flipped = [s != (n in near) for n, s in enumerate(negative)]
        if truth(scene.solid.tree, negative) != truth(scene.solid.tree, flipped):
            checks.equal(truth(scene.solid.tree, negative), row["side"] == "in", *where, "side")
    return k


def check_answer(suite, scene, row, record):
    checks, where = suite.checks, (scene.name, json.dumps(row))
    checks.holds(record["pmc"] != "undecided", "decided", *where)
    if row["order"] == "" or row["k"] or row["stratum"].startswith("rounded"):
        return
    t = F(row["time"])
    at = [c for c in record["contacts"] if holds_time(c, t)]
    if not checks.equal(len(at), 1, *where, "contacts at the time", record["word"]):
        return
    cells = [f["primitive"].split()[1] for f in at[0]["features"]]
    checks.holds(row["cell"].split()[1] in cells, f"the primitive among {cells}", *where)
    if row["stratum"] in ("face", "crossing") and at[0]["from"] == at[0]["to"] and t not in scene.breaks:
        checks.equal(at[0]["left"] == at[0]["right"], row["stratum"] == "face", *where, "tangency")
    if row["stratum"] == "slide":
        checks.holds(at[0]["from"] != at[0]["to"], "an interval", *where)


def check_rows(suite, scene, text, *more):
    table = Table(text)
    points = [tuple(table.point(row)) for row in table.rows]
    suite.checks.equal(len(set(points)), len(points), scene.name, "distinct points", *more)
    depths = set()
    for row, point in zip(table.rows, points):
        stratum, ends = row["stratum"], (scene.breaks[0], scene.breaks[-1])
        if stratum == "random" or stratum.startswith("rounded"):
            continue
        t = F(row["time"])
        fits = {"start": t == ends[0], "end": t == ends[1], "break": t in scene.breaks[1:-1]}
        suite.checks.holds(fits.get(stratum, ends[0] <= t <= ends[1]), "time", scene.name, json.dumps(row))
        if stratum in ("near", "miss"):
            depths.add(check_displaced(suite.checks, scene, row, point, t))
        else:
            check_contact(suite, scene, row, point, t, stratum)
    for row, record in zip(table.rows, suite.classify(scene, text)):
        check_answer(suite, scene, row, record)
    return table, depths


def check_scene(suite, scene, args):
    done = suite.generate(scene, suite.rows, args.seed)
    table, depths = check_rows(suite, scene, done.stdout)
    checks = suite.checks
    checks.equal(len(table.rows), suite.rows, scene.name, "rows")
    named = {s for s, w in table.strata.items() if w}
    wanted = {"random", "start", "end", "crossing", "miss", *scene.made.split()}
    checks.equal(list(table.strata), STRATA, scene.name)
    checks.equal(named, wanted, scene.name, "strata that can be made")
    alike = ",".join(sorted(wanted))
    even, more = check_rows(suite, scene, suite.generate(scene, SHARE * len(wanted), args.seed, "--strata", alike).stdout, alike)
    made = Counter(row["stratum"] for row in even.rows)
    checks.equal(set(made), wanted, scene.name, "are made")
    longer = suite.generate(scene, suite.rows + 10, args.seed).stdout
    checks.equal(longer[:len(done.stdout)], done.stdout, scene.name, "first rows of more")
    return depths | more


def check_doubles(suite, scene, seed):
    """Among doubles, and beside them: each coordinate is one."""
    for more in (("--representable", "binary64"), ("--strata", "rounded")):
        table, _ = check_rows(suite, scene, suite.generate(scene, SHARE, seed, *more).stdout, *more)
        suite.checks.holds(all(F(to_double(x)) == x for row in table.rows for x in table.point(row)), scene.name, *more)
    rounded = Table(suite.generate(scene, 40, seed, "--strata", "rounded").stdout).rows
    suite.checks.equal({row["side"] for row in rounded} >= {"in", "out"}, True, scene.name, "sides")


CANDIDATE = """#!/usr/bin/env python3
import subprocess, sys
solid, motion, points, out, wrong = sys.argv[1:]
text = subprocess.run([{graze!r}, "classify", solid, motion, points], capture_output=True, text=True, check=True).stdout
if wrong == "yes":
    text = text.replace(",on,boundary,8,", ",out,exterior,9,")
open(out, "w").write(text)
"""


def check_validate(suite, scene):
    """A candidate that takes the boundary for the outside is found in each row of it; Graze's own answers are right."""
    path = os.path.join(suite.folder, "candidate.py")
    with open(path, "w", encoding="utf-8") as file:
        file.write(CANDIDATE.format(graze=suite.graze))
    os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
    keep = os.path.join(suite.folder, "kept-" + scene.name)
    for wrong in ("no", "yes"):
        done = run([suite.graze, "validate", *scene.files, "-n", 60, "--seed", 4, "--format", "json", "--keep", keep, "--quiet",
                    "--candidate", f"{sys.executable} {path} {{solid}} {{motion}} {{points}} {{out}} {wrong}"])
        suite.checks.equal(done.returncode, int(wrong == "yes"), scene.name, wrong, done.stderr)
        if not suite.checks.holds(done.stdout.startswith("{"), scene.name, done.stderr):
            continue
        report = json.loads(done.stdout)
        with open(os.path.join(keep, "golden.csv"), encoding="utf-8") as file:
            on = sum(",on,boundary,8," in line for line in file)
        suite.checks.holds(on > 5, scene.name, "boundary points", on)
        report = report.get("comparison", report)
        suite.checks.equal((report["rows"], report["wrong"]), (60, on if wrong == "yes" else 0), scene.name, wrong)


def check_undecided(suite):
    """A vertex that no rule decides is left out and counted; alone, it makes no stratum."""
    scene = Scene(suite.folder, "flat", 3, FLAT, ACROSS, "")
    done = suite.generate(scene, 200, 1, "--strata", "vertex")
    suite.checks.holds("points are left out, as their answers are undecided" in done.stderr, done.stderr)
    records = suite.classify(scene, done.stdout)
    suite.checks.equal([r["pmc"] for r in records if r["pmc"] == "undecided"], [], "undecided rows")
    suite.checks.holds(len(records) > 50, "vertices of the box", len(records))


def main():
    args = options(__doc__, ONLY)
    checks = Checks()
    depths, reached = set(), Counter()
    with tempfile.TemporaryDirectory() as folder:
        suite = Suite(args, checks, folder)
        for name in args.once(name for name in SCENES if args.only in name):
            dimension, node, path, made = SCENES[name]
            scene = Scene(folder, name, dimension, node, path, made)
            depths |= check_scene(suite, scene, args)
            reached.update(made.split())
            if name in ("cylinder-along", "plate-across", "ellipse-plane"):
                check_doubles(suite, scene, args.seed)
            if name in ("torus-across", "ellipse-plane"):
                check_validate(suite, scene)
        if args.derived and not args.only:
            check_undecided(suite)
        if args.ample and not args.only:
            checks.holds({4, 96} <= depths and len(depths) > 15, "displacements", depths)
            checks.holds(suite.seams > 0, "seams", suite.seams)
            print("scenes by stratum:", dict(reached))
    checks.finish()


if __name__ == "__main__":
    main()
