#!/usr/bin/env python3
# suite
"""`classify --moments`: the first and the last time at which a point is in the closed solid, pieces, rows of a log.

SPDX-License-Identifier: GPL-3.0-or-later

Scenes and expected fields are derived beside them. Boxes that are displaced by quadratics piece by piece are a second
method: a point is inside where each coordinate less the displacement is between two numbers, in exact arithmetic. The
table is the same in parts, by threads, continued, and as points; logs give their lines to the motion.
"""
import csv
import json
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import Fraction, has_decimals, time_bounds  # noqa: E402
from harness import Checks, options, run, without_leaks  # noqa: E402

checks = Checks()
NAMES = ["first", "first_piece", "first_row", "last", "last_piece", "last_row"]
COLUMNS = ["first", "first_near", "first_piece", "first_row", "last", "last_near", "last_piece", "last_row"]

# The square [0, 1]^2 goes right by 2t up to t = 1, and then up by (t - 1)^2 to t = 2.
PLANE = {"dimension": 2, "pieces": [
    {"t": [0, 1], "row": 3, "transform": {"translate": ["2*t", "0"]}},
    {"t": [1, 2], "row": 5, "transform": {"translate": ["2", "(t-1)^2"]}}]}
LEAVES = "root(1 -4 2;1;2)"  # 1/2 = (t - 1)^2, so 2 t^2 - 4 t + 1 = 0, of the roots 0.29 and 1.71
PLANE_ROWS = [
    ("2,1/2", "1/2", "0", "3", LEAVES, "1", "5"),  # 2 - 2t <= 1 from 1/2; then 1/2 - (t - 1)^2 >= 0
    ("3,1/2", "1", "0", "3", LEAVES, "1", "5"),    # 3 - 2t <= 1 at t = 1 first, a touch that lies in both pieces
    ("3,0", "1", "0", "3", "1", "1", "5"),         # the same touch; -(t - 1)^2 < 0 after it
    ("5/2,2", "2", "1", "5", "2", "1", "5"),       # 2 - (t - 1)^2 <= 1 at the end alone
    ("0,1/2", "0", "0", "3", "0", "0", "3"),       # -2t < 0 after the start
    ("1/2,1/2", "0", "0", "3", "1/4", "0", "3"),   # in the interior at the start; 1/2 - 2t >= 0 up to 1/4
    ("5/2,3/2", LEAVES, "1", "5", "2", "1", "5"),  # 3/2 - (t - 1)^2 <= 1 from there on
    ("5/2,0", "3/4", "0", "3", "1", "1", "5"),     # along the lower side until the square goes up
    ("9,9", "", "", "", "", "", ""),               # never
]
# The cube [0, 1]^3 goes along x by t^2 up to t = 2, and then up by t - 2 to t = 3.
SPACE = {"dimension": 3, "pieces": [
    {"t": [0, 2], "row": 7, "transform": {"translate": ["t^2", "0", "0"]}},
    {"t": [2, 3], "transform": {"translate": ["4", "0", "t-2"]}}]}
TWO, THREE, HALF = "root(-2 0 1;1;2)", "root(-3 0 1;1;2)", "root(-1 0 2;0;1)"
SPACE_ROWS = [
    ("3,1/2,1/2", TWO, "0", "7", THREE, "0", "7"),  # 0 <= 3 - t^2 <= 1
    ("5,1/2,1/2", "2", "0", "7", "5/2", "1", ""),   # 5 - t^2 <= 1 at t = 2; 1/2 - (t - 2) >= 0 up to 5/2
    ("0,0,0", "0", "0", "7", "0", "0", "7"),        # a vertex at the start; -t^2 < 0 after it
    ("9/2,1/2,2", "3", "1", "", "3", "1", ""),      # 2 - (t - 2) <= 1 at the end alone
    ("1/2,1/2,1/2", "0", "0", "7", HALF, "0", "7"),  # 1/2 - t^2 >= 0
    ("4,0,1", THREE, "0", "7", "3", "1", ""),       # 4 - t^2 <= 1, along an edge; 1 - (t - 2) >= 0 to the end
    ("0,0,-1", "", "", "", "", "", ""),             # never
]
SQUARE = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n"
FACES = ["0 2 3 1", "4 5 7 6", "0 1 5 4", "2 6 7 3", "0 4 6 2", "1 3 7 5"]


def cube(low=(0, 0, 0), high=(1, 1, 1)):
    corners = [[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)]
    return "OFF\n8 6 0\n" + "".join(" ".join(map(str, c)) + "\n" for c in corners) + "".join(f"4 {f}\n" for f in FACES)


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text if isinstance(text, str) else json.dumps(text))
    return path


def call(graze, *words):
    done = run([graze, *words], 120)
    checks.holds(done.returncode == 0, words, done.stderr)
    return done.stdout


def rows_of(text):
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def check_derived(graze, folder, scene, expected, positions=True):
    names = ",".join("xyz"[:expected[0][0].count(",") + 1])
    points = write(folder, "points.csv", f"{names},id\n" + "".join(f"{row[0]},p{k}\n" for k, row in enumerate(expected)))
    table = call(graze, "classify", *scene, points, "--moments")
    plain = call(graze, "classify", *scene, points)
    lines = [line for line in table.splitlines() if not line.startswith("#")]
    checks.holds("\n# moments yes\n" in table and "moments" not in plain, "the head")
    checks.equal(lines[0].split(",id,")[1], ",".join(COLUMNS))
    checks.equal([line.rsplit(",", 8)[0] for line in lines], [line for line in plain.splitlines() if line[0] != "#"])
    for row, (point, *wanted) in zip(rows_of(table), expected):
        checks.equal([row[name] for name in NAMES], wanted, point)
        checks.holds(has_decimals(row, "first", "last"), row)
    for line, (point, *wanted) in zip(call(graze, "classify", *scene, points, "--moments", "--format", "jsonl").splitlines(), expected):
        found = json.loads(line)
        checks.equal([as_text(found[name]) for name in NAMES], wanted, point, "JSON Lines")
    further = (["--topo"], ["--sdf", "1/1000", "--motion-error", "1/100"]) if positions else ()
    for more in (*further, ["--no-filter"], ["--jobs", "2"]):
        for row, (point, *wanted) in zip(rows_of(call(graze, "classify", *scene, points, "--moments", "--quiet", *more)), expected):
            checks.equal([row[name] for name in NAMES], wanted, point, more)
    return points, table


def as_text(value):
    if isinstance(value, dict):
        return f"root({' '.join(value['poly'])};{value['lo']};{value['hi']})"
    return "" if value is None else str(value)


def check_forms(graze, folder, scene, points, whole):
    """Parts, a continued table, a certificate beside it, the table as points, a grid; refusals."""
    flags = ["--quiet", "--moments"]
    parts = [write(folder, f"part{k}.csv", call(graze, "classify", *scene, points, *flags, "--shard", f"{k}/3")) for k in (1, 2, 3)]
    checks.equal(call(graze, "merge", "--quiet", *parts), whole, "merged")
    begun = write(folder, "begun.csv", "\n".join(whole.splitlines()[:-3]) + "\n3,")
    call(graze, "classify", *scene, points, *flags, "--resume", begun)
    with open(begun, encoding="utf-8") as file:
        checks.equal(file.read(), whole, "continued")
    other = write(folder, "other.csv", "\n".join(whole.splitlines()[:-3]) + "\n")
    checks.equal(run([graze, "classify", *scene, points, "--quiet", "--resume", other]).returncode, 3, "continued without")
    for more in ([], ["--topo"], ["--sdf", "1/1000", "--topo"]):
        golden = write(folder, "golden.csv", call(graze, "classify", *scene, points, *flags, *more))
        again = run([graze, "classify", *scene, golden, "--moments", *more])
        with open(golden, encoding="utf-8") as file:
            checks.equal(again.stdout, file.read(), "the table as points", more)
        checks.holds("carried as" not in again.stderr, again.stderr)
        checks.equal(call(graze, "classify", *scene, golden, "--quiet"), call(graze, "classify", *scene, points), "answers go")
    # A table of an older version has no decimals.
    lines = [line.split(",") for line in whole.splitlines()]
    names = next(line for line in lines if line[0] == "x")
    kept = [k for k, name in enumerate(names) if not name.endswith("_near")]
    old = write(folder, "old.csv", "".join(",".join(line if line[0].startswith("#") else [line[k] for k in kept]) + "\n" for line in lines))
    checks.equal(call(graze, "classify", *scene, old, *flags), whole, "a table without decimals as points")
    for more, says in ((["--format", "npy"], "exact times"), (["--format", "vtk"], "exact times"), (["--columns", "pmc"], "all answers")):
        done = run([graze, "classify", *scene, points, "--moments", *more])
        checks.holds(done.returncode == 2 and "--moments" in done.stderr and says in done.stderr, more, done.stderr)


def check_certificate(graze, folder, scene, points, whole):
    """Rows do not disturb graze-check, which reads them in plain pieces."""
    plain = write(folder, "plain.json", call(graze, "convert", scene[1]))
    proof = os.path.join(folder, "certificate")
    table = write(folder, "certified.csv", call(graze, "classify", scene[0], plain, points, "--moments", "--certify", proof, "--quiet"))
    checks.equal([line for line in open(table, encoding="utf-8") if line[0] != "#"],
                 [line + "\n" for line in whole.splitlines() if line[0] != "#"], "beside a certificate")
    done = run([os.path.join(os.path.dirname(graze), "graze-check"), scene[0], plain, proof, table], env=without_leaks())
    checks.holds(done.returncode == 0 and "first_row" in done.stderr, done.stdout, done.stderr)


# The disk of radius 1 goes right by 2t up to t = 1, and then up by t - 1 to t = 2.
DISK = {"dimension": 2, "solid": {"ball": {"radius": 1}}}
ROUND = {"dimension": 2, "pieces": [{"t": [0, 1], "row": 3, "transform": {"translate": ["2*t", "0"]}},
                                    {"t": [1, 2], "row": 5, "transform": {"translate": ["2", "t-1"]}}]}
ROUND_ROWS = [
    ("3,0", "1", "0", "3", "1", "1", "5"),    # 3 - 2t <= 1 at t = 1, and 1 + (t - 1)^2 > 1 after it
    ("0,0", "0", "0", "3", "1/2", "0", "3"),  # the centre at the start; 2t <= 1 up to 1/2
    ("2,2", "2", "1", "5", "2", "1", "5"),    # 2 - (t - 1) <= 1 at the end alone
    ("2,0", "1/2", "0", "3", "2", "1", "5"),  # 2 - 2t <= 1 from 1/2; then t - 1 <= 1
    ("9,9", "", "", "", "", "", ""),          # never
]
# y^2 <= x^4 - y^4 and 2 x^4 <= y^2 + 3 x^2 y^2 - y^4: both vanish of second order in y and fourth in x.
FLAT = {"dimension": 2, "solid": {"intersection": [{"polynomial": {"0,2": "1", "4,0": "-1", "0,4": "1"}},
                                                   {"polynomial": {"0,2": "-1", "4,0": "2", "2,2": "-3", "0,4": "1"}}]}}


def check_curved(graze, folder):
    """A contact between two pieces of a curved solid; neither time is told where a state is not decided."""
    scene = write(folder, "disk.csg.json", DISK), write(folder, "round.json", ROUND)
    check_derived(graze, folder, scene, ROUND_ROWS, positions=False)
    flat = write(folder, "flat.csg.json", FLAT), write(folder, "through.json", {
        "dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": ["2*t-1", "2*t-1"]}}]})
    points = write(folder, "origin.csv", "0,0\n")
    flat = *flat, points, "--moments", "--limit", "work=10000"  # less than both curves ask for
    row = rows_of(call(graze, "classify", *flat))[0]
    checks.holds("?" in row["word"], "undecided", row)
    checks.equal([row[name] for name in ("pmc", "class", "first", "first_near", "first_piece", "last", "last_near", "last_piece")],
                 ["undecided", "undecided", "undecided", "", "", "undecided", "", ""])
    found = json.loads(call(graze, "classify", *flat, "--format", "jsonl"))
    checks.equal((found["pmc"], found["first"], found["last"], "first_piece" in found), ("undecided", "undecided", "undecided", False))


# ------------------------------------------------------------------------------------ second method


def displacement(rng, d, pieces):
    """Quadratics a + b u + c u^2 of u = t - k for each coordinate and each piece [k, k + 1], continuous."""
    at, made = [Fraction(0)] * d, []
    for _ in range(pieces):
        way = [(a, Fraction(rng.randint(-4, 4), 2), Fraction(rng.randint(-4, 4), 2)) for a in at]
        at = [sum(w) for w in way]
        made.append(way)
    return made


def is_inside(way, size, point, t):
    k = min(int(t), len(way) - 1)
    u = t - k
    return all(0 <= p - (a + b * u + c * u * u) <= s for p, s, (a, b, c) in zip(point, size, way[k]))


def check_moment(way, size, point, row, name, sign):
    """Inside at the time, or next to it on the side of the motion; not next to it on the other one; pieces and rows."""
    low, high = time_bounds(row[name])
    end = Fraction(len(way)) if sign > 0 else Fraction(0)
    step = Fraction(1, 2 ** 60)
    wide = [s + 2 * step for s in size]
    checks.holds(is_inside(way, wide, [p + step for p in point], low), "outside at", row)
    beyond = (high if sign > 0 else low) + sign * step
    checks.holds(low == end or not is_inside(way, size, point, beyond), "inside beyond", row)
    having = [k for k in range(len(way)) if k <= high and low <= k + 1]
    piece = having[-1] if sign > 0 else having[0]
    checks.equal((row[name + "_piece"], row[name + "_row"]), (str(piece), str(10 + piece)), row)


def check_boxes(graze, folder, rng, d):
    size, way = [Fraction(rng.randint(1, 3)) for _ in range(d)], displacement(rng, d, rng.randint(1, 4))
    solid = write(folder, "box.off", cube(high=size)) if d == 3 else \
        write(folder, "box.wkt", f"POLYGON ((0 0, {size[0]} 0, {size[0]} {size[1]}, 0 {size[1]}, 0 0))\n")
    motion = write(folder, "box.json", {"dimension": d, "pieces": [
        {"t": [k, k + 1], "row": 10 + k, "transform": {"translate": [f"{a}+({b})*(t-{k})+({c})*(t-{k})^2" for a, b, c in one]}}
        for k, one in enumerate(way)]})
    points = [[Fraction(rng.randint(-8, 12), 4) for _ in range(d)] for _ in range(60)]
    given = write(folder, "box.csv", "".join(",".join(map(str, p)) + "\n" for p in points))
    samples = [Fraction(k, 64) for k in range(64 * len(way) + 1)]
    seen = set()
    for point, row in zip(points, rows_of(call(graze, "classify", solid, motion, given, "--moments"))):
        inside = [t for t in samples if is_inside(way, size, point, t)]
        checks.equal(not row["first"], not row["last"], row)
        checks.holds(has_decimals(row, "first", "last"), row)
        if not row["first"]:
            checks.holds(not inside and row["pmc"] == "out" and row["first_piece"] == row["last_row"] == "", row, inside[:1])
        else:
            checks.holds(not inside or (time_bounds(row["first"])[0] <= inside[0] and inside[-1] <= time_bounds(row["last"])[1]), row)
            check_moment(way, size, point, row, "first", -1)
            check_moment(way, size, point, row, "last", 1)
        kinds = {"root": "root" in row["first"], "never": row["first"] == "", "start": row["first"] == "0",
                 "end": row["last"] == str(len(way)), "touch": row["first"] == row["last"] != ""}
        seen |= {kind for kind, is_it in kinds.items() if is_it}
    return seen


# ------------------------------------------------------------------------------------------- logs

# Line 1 has a comment, line 2 the names, line 4 is blank: the poses stand on lines 3, 5 and 6.
LOG = "# path\nx,y,z\n0,0,0\n\n2,0,0\n2,0,2\n"


def rows_in(graze, motion):
    return re.findall(r'"row": (\d+)', call(graze, "convert", motion))


def check_logs(graze, folder):
    """The row of a piece is the line that it leads to; programs that rewrite motions keep it."""
    solid = write(folder, "unit.off", cube())
    log = write(folder, "log.csv", LOG)
    made = write(folder, "log.json", call(graze, "motion", "poses", log))
    points = write(folder, "cut.csv", "5/2,1/2,1/2\n5/2,1/2,5/2\n1/2,1/2,1/2\n")
    # x = 5/2 - 2t <= 1 from 3/4 to the end of that piece, then z = 1/2 - 2(t - 1) >= 0 to 5/4; z = 5/2 - 2(t - 1) <= 1
    # from 7/4; the start, and 1/2 - 2t >= 0 to 1/4.
    wanted = [["3/4", "0", "5", "5/4", "1", "6"], ["7/4", "1", "6", "2", "1", "6"], ["0", "0", "5", "1/4", "0", "5"]]
    found = rows_of(call(graze, "classify", solid, made, points, "--moments"))
    checks.equal([[row[name] for name in NAMES] for row in found], wanted)
    checks.equal(rows_in(graze, made), ["5", "6"], "convert")
    matrices = write(folder, "matrices.csv", "".join(f"1 0 0 {x} 0 1 0 0 0 0 1 0\n" for x in (0, 1, 3)))
    affine = write(folder, "affine.json", call(graze, "motion", "poses", matrices, "--affine"))
    checks.equal(rows_in(graze, affine), ["2", "3"], "matrices")
    checks.equal(rows_in(graze, write(folder, "near.json", call(graze, "motion", "dyadic", affine))), ["2", "3"], "dyadic")
    inner = json.loads(open(made, encoding="utf-8").read())
    still = {"dimension": 3, "pieces": [{"t": [0, "1/2"], "row": 8, "transform": {"translate": ["0", "0", "0"]}},
                                        {"t": ["1/2", 2], "transform": {"translate": ["0", "0", "0"]}}]}
    relative = {"dimension": 3, "relative": {"moving": inner, "frame": still}}
    checks.equal(rows_in(graze, write(folder, "r.json", relative)), ["5", "5", "6"], "relative: of the moving one")
    relative["relative"] = {"moving": still, "frame": inner}
    checks.equal(rows_in(graze, write(folder, "r.json", relative)), ["8", "5", "6"], "relative: else of the frame")
    checks.equal(rows_in(graze, write(folder, "s.json", {"dimension": 3, "sequence": [inner, inner]})), ["5", "6", "5", "6"], "sequence")
    turn = {"dimension": 3, "pieces": [{"t": [0, 1], "row": 4, "transform": {"turn": {"quarters": 2, "axis": ["0", "0", "1"]}}}]}
    checks.equal(rows_in(graze, write(folder, "turn.json", turn)), ["4", "4"], "a turn of two quarters")
    bare = write(folder, "bare.json", {"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["t", "0", "0"]}}]})
    first = rows_of(call(graze, "classify", solid, bare, points, "--moments"))[2]
    checks.equal([first.get(name) for name in NAMES], ["0", "0", None, "1/2", "0", None], "a motion without rows")


def main():
    args = options(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        plane = write(folder, "s.wkt", SQUARE), write(folder, "plane.json", PLANE)
        space = write(folder, "s.off", cube()), write(folder, "space.json", SPACE)
        for scene, expected in ((plane, PLANE_ROWS), (space, SPACE_ROWS)) if args.derived else ():
            points, table = check_derived(args.graze, folder, scene, expected)
            check_forms(args.graze, folder, scene, points, table)
            check_certificate(args.graze, folder, scene, points, table)
        if args.derived:
            check_curved(args.graze, folder)
            check_logs(args.graze, folder)
        for d in (2, 3):
            seen = set().union(*(check_boxes(args.graze, folder, args.random, d) for _ in args.rounds(12, str(d))))
            every = {"root", "never", "start", "end", "touch"}
            checks.holds(seen == every if args.ample else seen <= every, d, seen)
    checks.finish()


if __name__ == "__main__":
    main()
