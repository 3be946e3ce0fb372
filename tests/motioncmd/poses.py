#!/usr/bin/env python3
# suite
"""Logs of poses as programs write them, and motions made dyadic.

The same poses under every name, separator and order give the same motion; what is chosen of them is what a slice of
the list has; signs of quaternions are those of a loop over the list; SLERP about one axis is a turn. A dyadic motion is evaluated in fractions beside
the one it was made from. SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import os
import re
import sys
import tempfile
from decimal import Decimal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from evaluate import rotation_of  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from harness import Checks, options  # noqa: E402
from truth import cos_sin, dec, norm  # noqa: E402

WRITTEN = ("--numbers", "written")
checks = Checks()
check = checks.holds
CUBE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "refuse", "common", "cube.off")


def made(graze, folder, text, *arguments, kind="poses"):
    """(motion file, report) of a text that must be taken."""
    path, to = os.path.join(folder, "given"), os.path.join(folder, "made.json")
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.write(text)
    done = harness.run([graze, "motion", kind, path, "--output", to, *arguments], 300)
    if not check(done.returncode == 0, text[:200], arguments, done.stderr):
        return None, done.stderr
    with open(to, encoding="utf-8") as file:
        return json.load(file), done.stderr


# Half a turn about x, then a quarter turn about z: t, position, quaternion w x y z.
POSES = [["0", "1", "2", "3", "1", "0", "0", "0"], ["1/2", "1.5", "2", "3", "0", "1", "0", "0"],
         ["0.75", "-2", "2e1", "3", "1", "0", "0", "1"]]
NAMES = "t x y z qw qx qy qz".split()


def table(names, rows, separator=",", end="\n"):
    return "".join(separator.join(row) + end for row in [names, *rows])


def frames(motion):
    return [(F(k["t"]), [F(x) for x in k["position"]], [F(x) for x in k["quaternion"]]) for k in motion["keyframes"]]


def value(text):
    """A number as --numbers written takes it."""
    return F(text)


WANT = [(value(p[0]), [value(x) for x in p[1:4]], [value(x) for x in p[4:]]) for p in POSES]


def test_names(graze, folder):
    """Names, orders and separators."""
    written = ["--numbers", "written"]
    for time in ("t", "time", "timestamp"):
        for position in ("xyz", ("tx", "ty", "tz"), ("px", "py", "pz")):
            names = [time, *position, *NAMES[4:]]
            got, _ = made(graze, folder, table(names, POSES), *written)
            check(got and frames(got) == WANT, names)
    for separator in (";", " ", "\t", "  \t ", " , "):
        got, _ = made(graze, folder, table(NAMES, POSES, separator, "\r\n"), *written)
        check(got and frames(got) == WANT, repr(separator))
    quoted = table([f'"{name}"' for name in NAMES], POSES)
    got, _ = made(graze, folder, quoted, *written)
    check(got and frames(got) == WANT, "names in quotes")
    # TUM has the scalar last and no names; its head, if any, is a comment.
    tum = "# timestamp tx ty tz qx qy qz qw\n" + "".join(
        " ".join(p[:4] + p[5:] + p[4:5]) + "\n" for p in POSES)
    got, _ = made(graze, folder, tum, *written)
    check(got and frames(got) == WANT, "TUM", got)


def test_ignored(graze, folder):
    rows = [[*p, "7", "word"] for p in POSES]
    got, _ = made(graze, folder, table([*NAMES, "gripper", "comment"], rows), "--numbers", "written", "--ignore",
                  "gripper", "--ignore", "comment", "--ignore", "nowhere")
    check(got and frames(got) == WANT, "ignored columns")
    # With the column of times ignored, times are 0, 1, 2, ...; with one of two columns for x ignored, the other counts.
    rows = [["100", *p] for p in POSES]
    got, _ = made(graze, folder, table(["tx", *NAMES], rows), "--numbers", "written", "--ignore", "tx", "--ignore", "t")
    check(got and frames(got) == [(F(k), *w[1:]) for k, w in enumerate(WANT)], "times count from 0")


def test_matrices(graze, folder):
    """Rows of 16 and of 12 numbers: what the same numbers under names give; positions in columns 4, 8, 12."""
    turned = [[1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7], [0, -1, 0, 8, 1, 0, 0, 9, 0, 0, 1, 10]]
    named = [f"m{i}{j}" for i in range(3) for j in range(4)]
    want, _ = made(graze, folder, table(named, [[str(x) for x in m] for m in turned]))
    for end in ([], [0, 0, 0, 1]):
        for separator in (",", " "):
            text = "".join(separator.join("%.18e" % x for x in m + end) + "\n" for m in turned)
            got, _ = made(graze, folder, text)
            check(got and frames(got) == frames(want), "rows of numbers", end, separator)
            check([frame["row"] for frame in want["keyframes"]] == [2, 3], "lines behind one of names", want)
            check([frame["row"] for frame in got["keyframes"]] == [1, 2], "lines without names", got)
    check([k["position"] for k in want["keyframes"]] == [["5", "6", "7"], ["8", "9", "10"]], want)
    quarter = rotation_of([F(x) for x in want["keyframes"][1]["quaternion"]])
    check(all(abs(a - b) < F(1, 10**15) for row, m in zip(quarter, ([0, -1, 0], [1, 0, 0], [0, 0, 1]))
              for a, b in zip(row, m)), "a quarter turn from x to y", quarter)


def told_rows(report, begin):
    """(rows, how many in all) of a list such as `lines 4-6, 9; 4 in all`, of at most ten ranges."""
    told = re.search(rf"^{begin} lines ([-\d, ]*)(, \.\.\.)?; (\d+) in all", report, re.M)
    if not told:
        return None
    ends = [[int(x) for x in one.split("-")] for one in told[1].split(", ")]
    return [row for one in ends for row in range(one[0], one[-1] + 1)], bool(told[2]), int(told[3])


def ranges_of(rows):
    return [row for row in rows if row - 1 not in rows]


def check_rows(report, begin, rows):
    """All rows are named, but of more than ten ranges the first ten."""
    told, starts = told_rows(report, begin), ranges_of(rows)
    named = [row for row in rows if len(starts) <= 10 or row < starts[10]]
    check(told == (named, len(starts) > 10, len(rows)) if rows else told is None, report, rows)


def test_signs(graze, folder, rng):
    seen = set()
    for k in range(12):
        poses = [[F(rng.randint(-9, 9)) for _ in range(3)] + [F(1)] for _ in range(30 if k % 2 else 60)]
        poses = [[x * rng.choice((1, -1)) for x in q] for q in poses]
        flips, want = [], [poses[0]]
        for line, q in enumerate(poses[1:], 3):
            short = sum(a * b for a, b in zip(want[-1], q)) >= 0
            want.append(q if short else [-x for x in q])
            if not short:
                flips.append(line)
        text = table(NAMES[4:], [[str(x) for x in q] for q in poses])
        for flags in ((), ("--shortest",)):
            got, report = made(graze, folder, text, *flags)
            check(got and [frame[2] for frame in frames(got)] == want, "signs of the shortest way", flags, poses)
            check_rows(report, "shortest: signs of quaternions changed at", flips)
            check("long way" not in report, report)
        seen.add(len(ranges_of(flips)) > 10)
        long = [line for line, (a, b) in enumerate(zip(poses, poses[1:]), 3) if sum(x * y for x, y in zip(a, b)) < 0]
        got, report = made(graze, folder, text, "--long")
        check(got and [frame[2] for frame in frames(got)] == poses, "signs are kept")
        check_rows(report, "long way: .* at", long)
        check("they are kept" in report and "shortest" not in report, report)
    check(seen == {False, True}, "few ranges and many", seen)


def test_given(graze, folder):
    """Numbers that are rounded are not said to be as given."""
    text = table(NAMES, POSES)
    _, report = made(graze, folder, text, "--numbers", "written")
    check(report.startswith("poses: 3, each one exactly as given at its time\n"), report)
    for flags in ((), ("--numbers", "binary64")):
        _, report = made(graze, folder, text, *flags)
        check("exactly as given" not in report and report.startswith("poses: 3, each one at its time, all numbers rounded to binary64 "), report)


def test_rows(graze, folder):
    """A column has the rows, exactly, in any order; the report names them."""
    rows = [[*p, str(row), str(10 ** 15 - k)] for k, (p, row) in enumerate(zip(POSES, (40, 45, 50)))]
    for name, want in (("N", [40, 45, 50]), ("block", [10 ** 15 - k for k in range(3)])):
        got, report = made(graze, folder, table([*NAMES, "N", "block"], rows), "--columns", f"row={name}", "--ignore", "block")
        check(got and [frame["row"] for frame in got["keyframes"]] == want, name, got)
        check(f"row is '{name}'" in report, report)
    got, report = made(graze, folder, table([*NAMES, "row"], [row[:9] for row in rows]))
    check(got and [frame["row"] for frame in got["keyframes"]] == [40, 45, 50], got)
    check("changed" not in report and re.search(r"most of all up to row (45|50);", report), report)
    rows[1][4] = "-1"  # (1, 0, 0, 0), (-1, 1, 0, 0), (1, 0, 0, 1): the second one changes, and then its scalar product with the third is 1
    _, report = made(graze, folder, table([*NAMES, "row"], [row[:9] for row in rows]))
    check("signs of quaternions changed at rows 45; 1 in all" in report, report)


AXIS = [F(2, 7), F(3, 7), F(6, 7)]


def turned(degrees):
    """The quaternion of a turn about AXIS in decimals of 100 digits."""
    cosine, sine = cos_sin(Decimal(degrees) / 2)
    return [cosine] + [sine * dec(x) for x in AXIS]


def off(got, t, degrees):
    """The angle, a double, between the motion's rotation at a time and a turn about AXIS. Quaternions of length 1 that are c apart
    are of rotations 4 asin(c/2) apart."""
    low, high = next((a, b) for a, b in zip(got, got[1:]) if a[0] <= t <= b[0])
    s = (t - low[0]) / (high[0] - low[0])
    q = [dec(a + (b - a) * s) for a, b in zip(low[2], high[2])]
    length = norm(q)
    return 4 * math.asin(norm([a / length - b for a, b in zip(q, turned(degrees))]) / 2)


SLERP = r"^slerp: .* at most (\S+) radians.*; pieces: (\d+)$"


def test_slerp(graze, folder, rng):
    """SLERP between two turns about one axis is the turn whose angle is linear in time.

    The linear quaternion is off it by 2 max |atan(x tan h) - x h|, h a quarter of the angle between: 0.92 degrees of 90, 6.8 of 170;
    lengths of the quaternions add to it. A way in as few pieces as halving gives is within the tolerance, and with half as many it
    would not be: for h below 1/4 that maximum is at least 0.256 h^3 (x = 1/sqrt 3 and the series of atan and tan)."""
    for degrees, first, known in ((90, 0, 0.92), (170, 10, 6.8), (180, 7, None), (20, 100, None), (Decimal("0.5"), 3, None)):
        for scales in ((1, 1), (1, 3), (F(1, 1000), 1)):
            rows = [["0", *[f"{x * dec(scales[0]):.80f}" for x in turned(first)]], ["1", *[f"{x * dec(scales[1]):.80f}" for x in turned(first + degrees)]]]
            got, report = made(graze, folder, table(["t", *NAMES[4:]], rows), *WRITTEN)
            bound = float(re.search(SLERP, report, re.M)[1])
            way = frames(got)
            true = max(off(way, F(k, 32), first + degrees * Decimal(k) / 32) for k in range(33))
            if degrees == 180 and scales != (1, 1):
                continue  # both ways are as short: the last digit tells which is taken
            check(true <= bound, degrees, scales, true, bound)
            check(scales != (1, 1) or bound <= 1.02 * true, degrees, true, bound)
            check(known is None or scales != (1, 1) or abs(bound * 180 / math.pi - known) < 0.06, degrees, bound)
            for tolerance in ("1e-2", "1e-6", "1e-9"):
                got, report = made(graze, folder, table(["t", *NAMES[4:]], rows), *WRITTEN, "--slerp", "--tolerance", tolerance)
                bound, pieces = re.search(SLERP, report, re.M).groups()
                way = frames(got)
                check(len(way) == int(pieces) + 1 and [p[0] for p in way] == [F(k, int(pieces)) for k in range(len(way))], pieces)
                for k in rng.sample(range(1025), 12):
                    true = off(way, F(k, 1024), first + degrees * Decimal(k) / 1024)
                    check(true <= float(bound) <= float(tolerance), degrees, scales, tolerance, k, true, bound)
                h = math.radians(degrees) / 4 / (int(pieces) / 2)
                check(int(pieces) == 1 or h > 0.25 or 0.256 * h ** 3 > 0.9 * float(tolerance), "too many pieces", degrees, tolerance, pieces)
                check([rotation_of(p[2]) for p in (way[0], way[-1])] == [rotation_of([F(x) for x in row[1:]]) for row in rows], "the poses")
    # Between 0.3 and 0.5 positions stay linear, pieces keep the row of the pose, and a list that does not turn is as it was.
    got, _ = made(graze, folder, "t,x,y,z,qw,qx,qy,qz\n0.25,0,4,0,1,0,0,0\n0.75,8,4,2,1,0,0,1\n", "--slerp", "--tolerance", "1e-4")
    check(all(k["row"] == (3 if F(k["t"]) > F(1, 4) else 2) and [F(x) for x in k["position"]] ==
              [16 * (F(k["t"]) - F(1, 4)), 4, 4 * (F(k["t"]) - F(1, 4))] for k in got["keyframes"]), "positions", got)
    still = "t,x,y,z\n0,0,4,0\n1,8,4,2\n"
    check(made(graze, folder, still, "--slerp")[0] == made(graze, folder, still)[0], "positions alone")


def test_choice(graze, folder, rng):
    """Scale, window and step."""
    rows = [[str(F(k, 3)), str(k), "1/7", "0", "1", "0", "0", "0"] for k in range(40)]
    text = table(NAMES, rows)
    for _ in range(40):
        low, high = sorted(rng.sample(range(-3, 43), 2))
        every = rng.choice((1, 2, 3, 7, 100))
        inside = [k for k in range(40) if low <= k <= high]
        want = inside[::every] + (inside[-1:] if (len(inside) - 1) % every else [])
        if len(want) < 2:
            continue
        got, report = made(graze, folder, text, "--from", f"{low}/3", "--to", f"{high}/3", "--every", str(every),
                           "--scale", "1/1000", "--numbers", "written")
        check(got and frames(got) == [(F(k, 3), [F(k, 1000), F(1, 7000), 0], [1, 0, 0, 0]) for k in want], low, high, every)
        check(f"poses: {len(want)}" + (" of 40," if len(want) < 40 else ",") in report, report)
    # The limit counts poses that are taken.
    done = harness.run([graze, "motion", "poses", os.path.join(folder, "given"), "--limit", "pieces=10"], 300)
    check(done.returncode == 6, done.stderr)
    got, _ = made(graze, folder, text, "--limit", "pieces=10", "--every", "5")
    check(got and len(got["keyframes"]) == 9, "40 poses by 5, and the last")


def entry(text, t):
    return eval(re.sub(r"(\^?)(\d+(?:\.\d+)?)", lambda m: f"**{m[2]}" if m[1] else f"F('{m[2]}')", text), {"F": F, "t": t})


def evaluate(motion, t):
    """The matrix of a file of plain pieces."""
    piece = next(p for p in motion["pieces"] if F(p["t"][0]) <= t <= F(p["t"][1]))
    return [[entry(text, t) for text in row] for row in piece["transform"]["matrix"]]


def is_dyadic(x):
    return x.denominator & (x.denominator - 1) == 0


POLYNOMIAL = {"dimension": 3, "pieces": [
    {"t": ["0", "1/3"], "transform": {"matrix": [["1", "t/7", "0", "0.443221*t"], ["0", "1", "0", "t^3/3 - 1/7"],
                                                 ["0", "0", "1+t", "2/3"]]}},
    {"t": ["1/3", "2"], "transform": {"matrix": [["1", "1/21", "0", "0.443221/3 + (t-1/3)^2"],
                                                 ["0", "1", "0", "1/81 - 1/7"], ["0", "0", "4/3", "2/3"]]}}]}


def test_polynomials(graze, folder):
    for tolerance in ("1e-6", "1/100", "1e-30"):
        got, report = made(graze, folder, json.dumps(POLYNOMIAL), "--tolerance", tolerance, kind="dyadic")
        if got is None:
            continue
        worst = F(0)
        for (low, high) in ((F(0), F(1, 3)), (F(1, 3), F(2))):
            for k in range(0, 1025, 64):
                t = low + (high - low) * k / 1024
                a, b = evaluate(got, t), evaluate(POLYNOMIAL, t)
                worst = max([worst] + [abs(x - y) for p, q in zip(a, b) for x, y in zip(p, q)])
                check(all(is_dyadic(x) for row in a for x in row), "dyadic at", t, a)
        told = F(re.search(r"^change: .* at most (\S+)", report, re.M)[1])
        check(0 < worst <= told <= F(tolerance), to_double(worst), report)
        check("shape: " in report and "lost" not in report, report)


def test_turns(graze, folder):
    """A translation by a decimal, a quarter turn, a translation: the turn stays, the rest is dyadic and meets it."""
    turn = {"t": ["1", "2"], "transform": {"compose": [{"translate": ["1/3", "0", "0"]}, {"turn": {
        "quarters": 1, "axis": ["0", "0", "1"]}}]}}
    given = {"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["t/3", "0", "0"]}}, turn,
                                        {"t": ["2", "3"], "transform": {"compose": [
                                            {"translate": ["1/3", "0", "0"]},
                                            {"turn": {"quarters": 0, "axis": ["0", "0", "1"]}},
                                            {"rotate": {"tan_half": "1", "axis": ["0", "0", "1"]}},
                                            {"translate": ["0", "0", "0.1*(t-2)"]}]}}]}
    got, report = made(graze, folder, json.dumps(given), kind="dyadic")
    check(got and "lost: 1 pieces, the first from t = 1 to 2" in report, report)
    check(evaluate(got, F(1))[0][3] == F(1, 3), "the turn begins where it did")
    check(evaluate(got, F(0)) == [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]], "the start")
    check(is_dyadic(evaluate(got, F(3))[2][3]) and abs(evaluate(got, F(3))[2][3] - F(1, 10)) < F(1, 10**6), "the end")
    # The option --dyadic after a chain of joints makes the slide dyadic.
    to = os.path.join(folder, "made.json")
    done = harness.run([graze, "motion", "joints", "slide:1/3,0,0", "--dyadic", "--output", to], 300)
    with open(to, encoding="utf-8") as file:
        slid = json.load(file)
    check(done.returncode == 0 and is_dyadic(evaluate(slid, F(1))[0][3]), done.stderr)
    check(harness.run([graze, "check", CUBE, to], 300).returncode == 0, "it is legal")


def main():
    args = options(__doc__, seed=1)
    with tempfile.TemporaryDirectory() as folder:
        test_names(args.graze, folder)
        test_ignored(args.graze, folder)
        test_matrices(args.graze, folder)
        test_signs(args.graze, folder, args.random)
        test_given(args.graze, folder)
        test_rows(args.graze, folder)
        test_slerp(args.graze, folder, args.random)
        test_choice(args.graze, folder, args.random)
        test_polynomials(args.graze, folder)
        test_turns(args.graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
