#!/usr/bin/env python3
# suite
"""`classify --sdf` and `explain --sdf`: the columns in tables, JSON Lines, shards, continued and exported tables;
what is refused; and every row of two scenes in space against the distance computed at sampled times.

SPDX-License-Identifier: GPL-3.0-or-later

The second method takes exact poses at 60 times and the time of each row, and the distance to each triangle in floats:
no sample may be below sdf_low, and the one at sdf_t not above sdf_high.
"""
import ast
import csv
import json
import math
import os
import random
import re
import struct
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "agree", "lib"))
sys.path.insert(0, os.path.join(HERE, "..", "lib"))

from exact import Fraction as F, to_double  # noqa: E402
from program import Checks, Graze, options  # noqa: E402

CUBE = os.path.join(HERE, "..", "refuse", "common", "cube.off")  # [0, 2]^3
CORNERS = [(x, y, z) for z in (0, 2) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
TRIANGLES = [(f[0], f[k], f[k + 1]) for f in FACES for k in (1, 2)]


def motion(transform):
    return json.dumps({"dimension": 3, "pieces": [{"t": [0, 1], "transform": transform}]})


SLIDE = motion({"translate": ["8*t", 0, 0]})
SCREW = motion({"compose": [{"rotate": {"tan_half": "t", "axis": [0, 0, 1]}}, {"translate": [0, 0, "3*t"]}]})
SHEAR = motion({"matrix": [["1+t", "t/2", 0, "4*t"], [0, 1, "t", 0], ["t/3", 0, "1+t^2", 1]]})


def screw(t):
    c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    return ((c, -s, 0, 0), (s, c, 0, 0), (0, 0, 1, 3 * t))


def shear(t):
    return ((1 + t, t / 2, 0, 4 * t), (0, 1, t, 0), (t / 3, 0, 1 + t * t, 1))


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def to_segment(u, v, p):
    d = minus(v, u)
    s = min(1, max(0, dot(minus(p, u), d) / dot(d, d)))
    return math.dist(p, [u[k] + s * d[k] for k in range(3)])


def to_triangle(corners, p):
    a, b, c = corners
    n = cross(minus(b, a), minus(c, a))
    sides = ((a, b), (b, c), (c, a))
    if all(dot(cross(minus(v, u), minus(p, u)), n) >= 0 for u, v in sides):
        return abs(dot(minus(p, a), n)) / math.sqrt(dot(n, n))
    return min(to_segment(u, v, p) for u, v in sides)


def signed(pose, p):
    """The signed distance to the cube in a pose, in floats: all facets' outer sides decide the sign."""
    at = [tuple(to_double(dot(row, x) + row[3]) for row in pose) for x in CORNERS]
    value = min(to_triangle([at[k] for k in t], p) for t in TRIANGLES)
    middle = [sum(x[k] for x in at) / 8 for k in range(3)]
    for a, b, c in TRIANGLES:
        n = cross(minus(at[b], at[a]), minus(at[c], at[a]))
        if dot(n, minus(p, at[a])) * dot(n, minus(middle, at[a])) <= 0:
            return value
    return -value


def rows_of(text):
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def check_samples(checks, graze, name, text, pose, tolerance):
    rng = random.Random(2026)
    points = [[F(rng.randint(-3 << 10, 6 << 10), 1 << 10) for _ in range(3)] for _ in range(120)]
    path = graze.write(f"{name}.csv", "".join(",".join(map(str, p)) + "\n" for p in points))
    out = graze.call("classify", CUBE, graze.write(f"{name}.json", text), path, "--quiet",
                     "--sdf", tolerance)
    checks.equal(out.returncode, 0, out.stderr)
    rows = rows_of(out.stdout)
    checks.equal(len(rows), len(points), name)
    checks.holds(len({r["pmc"] for r in rows}) > 1, f"{name}: answers of more than one kind")
    for p, row in zip(points, rows):
        low, high, at = F(row["sdf_low"]), F(row["sdf_high"]), F(row["sdf_t"])
        q = [to_double(x) for x in p]
        least = min(signed(pose(F(k, 60)), q) for k in range(61))
        checks.holds(0 <= high - low <= F(tolerance), f"{name} {p}: width")
        checks.holds(least >= low - F(1, 10 ** 12), f"{name} {p}: sample {least} below {to_double(low)}")
        checks.holds(signed(pose(at), q) <= high + F(1, 10 ** 12), f"{name} {p}: at {at} above {to_double(high)}")
        checks.equal(row["pmc"], "in" if high <= 0 and low < 0 else "out", f"{name} {p}: sign")


# Points about the cube that slides by 8 along x, and s by its definition.
ROWS = [("5", "3", "1", F(1)), ("13", "6", "1", F(5)), ("5", "1", "1", F(-1)), ("5", "1", "2", F(0)),
        ("1/3", "1", "1", F(-1, 3)), ("5", "1", "5/2", F(1, 2))]


def check_table(checks, graze, points, scene):
    plain = graze.call("classify", *scene, points, "--quiet")
    out = graze.call("classify", *scene, points, "--sdf", "1e-9")
    checks.equal(out.returncode, 0, out.stderr)
    checks.equal(out.stderr, "", "nothing is said where all is enclosed")
    body = [line for line in out.stdout.splitlines() if not line.startswith("#")]
    checks.equal([line.rsplit(",", 3)[0] for line in body],
                 [line for line in plain.stdout.splitlines() if not line.startswith("#")], "rows")
    checks.holds(body[0].endswith(",sdf_low,sdf_high,sdf_t"), body[0])
    checks.holds("\n# sdf 1e-09\n" in out.stdout, "the head has the number that was given")
    for (x, y, z, s), row in zip(ROWS, rows_of(out.stdout)):
        low, high = F(row["sdf_low"]), F(row["sdf_high"])
        checks.holds(low <= s <= high and high - low <= F(1, 10 ** 9), f"{x} {y} {z}", row)
    on = rows_of(out.stdout)[3]
    checks.equal([on["sdf_low"], on["sdf_high"], on["sdf_t"]], ["0", "0", "3/8"], "touched from t = 3/8 on")
    both = graze.call("classify", *scene, points, "--quiet", "--sdf", "1e-9", "--topo")
    checks.holds(both.stdout.splitlines()[-3].count(",") == body[-1].count(",") + 1, "with topo")
    return out.stdout


def check_lines(checks, graze, points, scene):
    out = graze.call("classify", *scene, points, "--quiet", "--sdf", "1e-9", "--format", "jsonl")
    for (x, y, z, s), line in zip(ROWS, out.stdout.splitlines()):
        row = json.loads(line)
        checks.holds(row["sdf_low"] <= s <= row["sdf_high"], f"JSON {x} {y} {z}", line)
        checks.holds(isinstance(row["sdf_t"], str), line)


def check_parts(checks, graze, points, scene, whole):
    ask = ("--quiet", "--sdf", "1e-9")
    parts = []
    for k in range(3):
        out = graze.call("classify", *scene, points, *ask, "--jobs", "2", "--shard", f"{k + 1}/3")
        parts.append(graze.write(f"part-{k}.csv", out.stdout))
    checks.equal(graze.call("merge", "--quiet", *parts).stdout, whole, "merged")
    lines = whole.splitlines(keepends=True)
    begun = graze.write("begun.csv", "".join(lines[:-3]) + lines[-3][:3])
    ended = graze.call("classify", *scene, points, *ask, "--resume", begun)
    with open(begun, encoding="utf-8") as f:
        checks.equal(f.read(), whole, "continued", ended.stderr)
    other = graze.write("other.csv", "".join(lines[:-3]))
    checks.equal(graze.call("classify", *scene, points, "--quiet", "--sdf", "1e-8", "--resume", other).returncode, 3,
                 "another tolerance is another table")
    for flags in (ask, (*ask, "--topo")):
        table = graze.call("classify", *scene, points, *flags).stdout
        again = graze.call("classify", *scene, graze.write("again.csv", table), *flags).stdout
        checks.equal(again, table, "a table as points")
    forged = graze.write("forged.csv", whole.replace(",0,0,3/8", ",0,1,3/8"))
    checks.equal(graze.call("merge", "--quiet", forged).returncode, 3, "no part")
    begun = graze.write("wrong.csv", "".join(lines[:-2]).replace(",0,0,3/8", ",0,1,3/8"))
    out = graze.call("classify", *scene, points, *ask, "--resume", begun)
    checks.holds(out.returncode == 3 and "expected a table of this run" in out.stderr, out.stderr)
    for form in ("npy", "vtk"):
        out = graze.call("classify", *scene, points, *ask, "--format", form, "--output", graze.write("out." + form, ""))
        checks.equal(out.returncode, 0, form, out.stderr)


def below(n, d):
    """The largest double that is at most n/d."""
    near = int(n) / int(d)
    return near if F(near) <= F(n, d) else math.nextafter(near, 0)


def above(n, d):
    """The least double that is at least n/d."""
    near = int(n) / int(d)
    return near if F(near) >= F(n, d) else math.nextafter(near, math.inf)


def check_heads(checks, graze, points, scene):
    """A width stands in the head as the shortest decimal that is read as its double again."""
    widths = ((1, 10 ** 9), (1, 3), (1, 10 ** 18), (25, 1), (1, 1), (123456789, 10 ** 12), (1, 10 ** 300), (7, 10 ** 5))
    for n, d in widths:
        out = graze.call("classify", *scene, points, "--quiet", "--sdf", f"{n}/{d}", "--motion-error", f"{n}/{d}")
        head = dict(line[2:].split(" ", 1) for line in out.stdout.splitlines() if line.startswith("# "))
        width, error = F(head["sdf"]), F(head["motion-error"])
        checks.equal(below(width.numerator, width.denominator), below(n, d), f"{n}/{d} read again", head["sdf"])
        checks.equal(above(error.numerator, error.denominator), above(n, d), f"{n}/{d} read again", head)
        digits = head["sdf"].split("e")[0].replace(".", "").strip("0")
        for fewer in range(1, len(digits)):  # no number of fewer digits is in [double, next double)
            unit = F(10) ** (math.floor(math.log10(to_double(width))) - fewer + 1)
            least = math.ceil(F(below(n, d)) / unit) * unit
            checks.holds(least >= F(math.nextafter(below(n, d), math.inf)), f"{n}/{d}: {head['sdf']} is not shortest")
        if "/" not in f"{F(n, d)}" or n == 1 and d in (10 ** 9, 10 ** 18, 10 ** 300):
            checks.equal([width, error], [F(n, d), F(n, d)], "the number that was given")


def check_certain(checks, graze, points, scene):
    """|s| > ETA, of points that are 1, 5, 1, 0, 1/3 and 1/2 away."""
    for eta, beyond in (("1/4", "111011"), ("0.4", "111001"), ("3/4", "111000"), ("1", "010000"), ("100", "000000")):
        certain = ["undecided" if k == "0" else "yes" for k in beyond]
        ask = ("--quiet", "--sdf", "1e-9", "--motion-error", eta)
        out = graze.call("classify", *scene, points, *ask)
        checks.equal([row["certain"] for row in rows_of(out.stdout)], certain, eta)
        lines = graze.call("classify", *scene, points, *ask, "--format", "jsonl").stdout.splitlines()
        checks.equal([json.loads(line)["certain"] for line in lines], certain, eta)
    ask = ("--quiet", "--sdf", "1e-9", "--motion-error", "0.4")
    for more in ((), ("--topo",)):
        whole = graze.call("classify", *scene, points, *ask, *more).stdout
        again = graze.call("classify", *scene, graze.write("again.csv", whole), *ask, *more).stdout
        checks.equal(again, whole, "a table as points")
        parts = [graze.write(f"part-{k}.csv", graze.call("classify", *scene, points, *ask, *more, "--shard", f"{k}/2").stdout)
                 for k in (1, 2)]
        checks.equal(graze.call("merge", "--quiet", *parts).stdout, whole, "merged")
        lines = whole.splitlines(keepends=True)
        begun = graze.write("begun.csv", "".join(lines[:-3]))
        graze.call("classify", *scene, points, *ask, *more, "--resume", begun)
        with open(begun, encoding="utf-8") as f:
            checks.equal(f.read(), whole, "continued")
        for word in ("yes", "no"):
            wrong = graze.write("wrong.csv", "".join(lines[:-3 if more else -2]).replace("3/8,undecided", "3/8," + word))
            out = graze.call("classify", *scene, points, *ask, *more, "--resume", wrong)
            checks.holds(out.returncode == 3 and "expected a table of this run" in out.stderr, out.stderr)
            checks.holds(f"3/8,{word}" in out.stderr and "3/8,undecided" in out.stderr, word, "both words", out.stderr)
    fine = graze.call("classify", *scene, points, "--sdf", "1e-17r", "--motion-error", "1")
    checks.holds("rows is enclosed less closely" in fine.stderr, fine.stderr)
    out = graze.call("classify", *scene, points, "--motion-error", "1")
    checks.holds(out.returncode == 2 and "expected --sdf beside it" in out.stderr, out.stderr)
    for bad in ("0", "-1", "nan", "1e400", "", "1r"):
        out = graze.call("classify", *scene, points, "--sdf", "1", "--motion-error", bad)
        checks.holds(out.returncode == 2 and "expected a positive number" in out.stderr, bad, out.stderr)


def npy_columns(path):
    """Columns of a structured npy file, of numbers and of texts as words."""
    with open(path, "rb") as f:
        data = f.read()
    size, = struct.unpack("<I", data[8:12])
    head = ast.literal_eval(data[12:12 + size].decode())
    form = "<" + "".join({"f8": "d", "u4": "I"}.get(d[1:], d[2:] + "s") for _, d in head["descr"])
    columns = zip((n for n, _ in head["descr"]), zip(*struct.iter_unpack(form, data[12 + size:])))
    return {n: [v.rstrip(b"\0").decode() if isinstance(v, bytes) else v for v in c] for n, c in columns}


def vtk_columns(path, count):
    """name -> values of the columns of doubles of a legacy VTK file."""
    with open(path, "rb") as f:
        data = f.read()
    heads = re.finditer(rb"^SCALARS (\w+) double 1\nLOOKUP_TABLE default\n", data, re.M)
    return {h.group(1).decode(): list(struct.unpack_from(f">{count}d", data, h.end())) for h in heads}


def check_grid(checks, graze, scene):
    """A grid in every format, by one thread and by several, has the rows of its points."""
    ask = ("--grid", "5,4,3", "--box=-1,-1,-1,12,4,4", "--quiet", "--sdf", "1e-7", "--motion-error", "1/8")
    whole = graze.call("classify", *scene, *ask, "--jobs", "1").stdout
    rows = rows_of(whole)
    checks.equal(len(rows), 60, "points of the grid")
    for row in rows:  # the cube [0, 2]^3 slides by 8 along x: the distance to [0, 10] x [0, 2]^2, or at most 1 deep
        p = [F(row[a]) for a in "xyz"]
        beyond = [max(-x, x - top, F(0)) for x, top in zip(p, (10, 2, 2))]
        low, high = F(row["sdf_low"]), F(row["sdf_high"])
        if any(beyond):
            square = sum(b * b for b in beyond)
            checks.holds(0 <= low and low * low <= square <= high * high and high - low <= F(1, 10 ** 7), row)
            checks.equal(row["certain"], "yes" if square > F(1, 64) else "undecided", row)
        else:
            s = -min([F(1)] + [min(x, top - x) for x, top in zip(p, (10, 2, 2))])
            checks.holds(low <= s <= high and high - low <= F(1, 10 ** 7), row)
    checks.equal(graze.call("classify", *scene, *ask, "--jobs", "3").stdout, whole, "three threads")
    parts = [graze.write(f"grid-{k}.csv", graze.call("classify", *scene, *ask, "--shard", f"{k}/3").stdout) for k in (1, 2, 3)]
    checks.equal(graze.call("merge", "--quiet", *parts).stdout, whole, "shards of a grid")
    lines = graze.call("classify", *scene, *ask, "--format", "jsonl").stdout.splitlines()
    told = [json.loads(line) for line in lines]
    checks.equal([(t["sdf_low"], t["sdf_high"], t["certain"]) for t in told],
                 [(float(r["sdf_low"]), float(r["sdf_high"]), r["certain"]) for r in rows], "JSON Lines of a grid")
    columns = {name: [float(r[name]) for r in rows] for name in ("sdf_low", "sdf_high")}
    path = graze.write("grid.npy", "")
    graze.call("classify", *scene, *ask, "--format", "npy", "--output", path)
    arrays = npy_columns(path)
    for name, values in columns.items():
        checks.equal(arrays[name], values, "npy", name)
    checks.equal(arrays["certain"], [r["certain"] for r in rows], "npy, certain")
    path = graze.write("grid.vtk", "")
    graze.call("classify", *scene, *ask, "--format", "vtk", "--output", path)
    arrays = vtk_columns(path, len(rows))
    for name, values in columns.items():
        checks.equal(arrays[name], values, "vtk", name)


def check_refused(checks, graze, points, scene):
    for bad in ("0", "-1", "x", "", "r", "nan", "1e400", "1e-400", "0r"):
        out = graze.call("classify", *scene, points, "--sdf", bad)
        checks.equal(out.returncode, 2, f"--sdf {bad}", out.stderr)
        checks.holds("expected a positive number" in out.stderr, out.stderr)
    out = graze.call("classify", *scene, points, "--sdf", "1", "--columns", "pmc")
    checks.holds(out.returncode == 2 and "--sdf needs all answers" in out.stderr, out.stderr)
    for quiet in ((), ("--quiet",)):
        fine = graze.call("classify", *scene, points, "--sdf", "1e-17r", *quiet)
        checks.equal((fine.returncode, "rows is enclosed less closely" in fine.stderr), (0, not quiet), fine.stderr)
    out = graze.call("explain", *scene, "5", "3", "1", "--sdf", "1e-6r")
    checks.holds("The signed distance to the sweep lies in [0.99999" in out.stdout, out.stdout)
    out = graze.call("explain", *scene, "5", "1", "2", "--sdf", "1")
    checks.holds("lies in [0, 0]" in out.stdout and "on the boundary of S at t = 3/8" in out.stdout, out.stdout)


def check_relative(checks, graze, points):
    """1/1000 of the diagonal of the cube [0, 2]^3, whose square is 12, wherever the cube begins and however it lies."""
    for shift in ("0", "1000", "-1000"):
        for turn in ([[-1, 0, 0], [0, 1, 0], [0, 0, -1]], [[0, 1, 0], [1, 0, 0], [0, 0, -1]]):
            text = motion({"matrix": [[*row, f"{shift}+8*t"] for row in turn]})
            out = graze.call("classify", CUBE, graze.write("far.json", text), points, "--quiet", "--sdf", "0.001r")
            width = [F(line.split()[2]) for line in out.stdout.splitlines() if line.startswith("# sdf ")]
            checks.equal(len(width), 1, shift, out.stderr)
            checks.holds(all(F(12) * (1 - F(1, 2 ** 40)) <= w * w * 10 ** 6 <= 12 for w in width), "relative", shift, turn, width)


def check_minute(checks, graze):
    """[0, 2u]^2 slides by 8u, u = 2^-400, whose square is below the floor of the bounds: they are true, and the search ends
    where they do, not at its limit, which took a second a row."""
    u = F(1, 2 ** 400)
    square = ", ".join(f"{x * u} {y * u}" for x, y in ((0, 0), (2, 0), (2, 2), (0, 2), (0, 0)))
    files = (graze.write("minute.wkt", f"POLYGON (({square}))\n"),
             graze.write("minute.json", json.dumps({"dimension": 2, "pieces": [{"t": [0, 1], "transform": {
                 "translate": [f"{8 * u}*t", 0]}}]})))
    points = [(F(3 * k % 61, 4) - 3, F(9, 4) + F(k % 5, 2)) for k in range(100)]
    where = graze.write("minute.csv", "".join(f"{x * u},{y * u}\n" for x, y in points))
    done = graze.call("classify", *files, where, "--sdf", "1e-126")
    checks.equal(done.returncode, 0, "minute", done.stderr)
    rows = rows_of(done.stdout)
    checks.equal(len(rows), len(points), "minute", "rows")
    for (x, y), row in zip(points, rows):
        truth = (max(-x, 0, x - 10) ** 2 + (y - 2) ** 2) * u * u
        low, high = F(row["sdf_low"]), F(row["sdf_high"])
        checks.holds(low >= 0 and low * low <= truth <= high * high, "minute", x, y, row)
        checks.holds(high < 2 ** 10 * F(1, 2 ** 390), "minute", "width", row)


def main():
    args = options(__doc__)
    checks = Checks()
    graze = Graze(args, checks)
    scene = CUBE, graze.write("slide.json", SLIDE)
    points = graze.write("points.csv", "".join(",".join(r[:3]) + "\n" for r in ROWS))
    whole = check_table(checks, graze, points, scene)
    check_lines(checks, graze, points, scene)
    check_parts(checks, graze, points, scene, whole)
    check_refused(checks, graze, points, scene)
    check_heads(checks, graze, points, scene)
    check_certain(checks, graze, points, scene)
    check_grid(checks, graze, scene)
    check_relative(checks, graze, points)
    check_minute(checks, graze)
    check_samples(checks, graze, "screw", SCREW, screw, "1e-7")
    check_samples(checks, graze, "shear", SHEAR, shear, "1e-7")
    checks.finish()


if __name__ == "__main__":
    main()
