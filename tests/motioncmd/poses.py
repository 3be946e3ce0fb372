#!/usr/bin/env python3
# suite
"""Logs of poses as programs write them, and motions made dyadic.

The same poses under every name, separator and order give the same motion; what is chosen of them is what a slice of
the list has; signs of quaternions are those of a loop over the list. A dyadic motion is evaluated in fractions beside
the one it was made from. SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from evaluate import rotation_of  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from harness import Checks, options  # noqa: E402

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
    # Without its column the times count, and of two columns for x one is left.
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


def test_signs(graze, folder, rng):
    for _ in range(10):
        poses = [[F(rng.randint(-9, 9)) for _ in range(3)] + [F(1)] for _ in range(30)]
        poses = [[x * rng.choice((1, -1)) for x in q] for q in poses]
        flips, want = [], [poses[0]]
        for line, q in enumerate(poses[1:], 3):
            short = sum(a * b for a, b in zip(want[-1], q)) >= 0
            want.append(q if short else [-x for x in q])
            if not short:
                flips.append(line)
        text = table(NAMES[4:], [[str(x) for x in q] for q in poses])
        got, report = made(graze, folder, text, "--shortest")
        check(got and [frame[2] for frame in frames(got)] == want, "signs of the shortest way", poses)
        told = re.search(r"^shortest: signs of quaternions changed at lines ([\d, .]*); (\d+) in all", report, re.M)
        check(told and [int(x) for x in re.findall(r"\d+", told[1])] == flips[:10] and int(told[2]) == len(flips),
              report, flips)
        long = [line for line, (a, b) in enumerate(zip(poses, poses[1:]), 3) if sum(x * y for x, y in zip(a, b)) < 0]
        got, report = made(graze, folder, text)
        check(got and [frame[2] for frame in frames(got)] == poses, "signs are kept")
        told = re.search(r"^long way: .* lines ([\d, .]*); (\d+) in all; they are kept .*--shortest", report, re.M)
        check(told and [int(x) for x in re.findall(r"\d+", told[1])] == long[:10] and int(told[2]) == len(long), report, long)


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
    # As an option, after a chain of joints: the slide is dyadic, the turn is not.
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
        test_choice(args.graze, folder, args.random)
        test_polynomials(args.graze, folder)
        test_turns(args.graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
