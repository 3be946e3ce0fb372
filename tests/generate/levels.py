#!/usr/bin/env python3
# suite
"""`graze generate --strata level`: every decade of the signed distance on both sides, checked by closed forms.

SPDX-License-Identifier: GPL-3.0-or-later

The cube [0, 2]^3 that moves by 8 along x sweeps [0, 10] x [0, 2]^2: outside, s is the distance to that box; inside, a
ball in one cube has its centre at most 1 deep, so -s = min(1, x, 10 - x, y, 2 - y, z, 2 - z). Likewise the square
[0, 1]^2 that moves by 3 along y. In scenes that turn, the enclosures of `classify --sdf` are read.
"""
import json
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "lib")]

from exact import Fraction as F, to_double  # noqa: E402
from harness import ROOT, Checks, options, run  # noqa: E402

checks = Checks()
CUBE = os.path.join(ROOT, "tests", "refuse", "common", "cube.off")
SLIDE = {"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["8*t", 0, 0]}}]}
LIFT = {"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": [0, "3*t"]}}]}
BOXES = {"cube": ([(F(0), F(10)), (F(0), F(2)), (F(0), F(2))], F(1)), "square": ([(F(0), F(1)), (F(0), F(4))], F(1, 2))}


def signed_square(box, deepest, p):
    """s |s|, exactly."""
    beyond = [max(low - x, x - high, F(0)) for x, (low, high) in zip(p, box)]
    if any(beyond):
        return sum(b * b for b in beyond)
    depth = min([deepest] + [min(x - low, high - x) for x, (low, high) in zip(p, box)])
    return -depth * depth


def rows_of(text):
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    names = lines[0].split(",")
    return names, [dict(zip(names, line.split(","))) for line in lines[1:]]


def in_decade(square, name):
    """Is s |s| of the decade that a row names, as -1e-05?"""
    low = F(name.lstrip("-"))
    sign = -1 if name.startswith("-") else 1
    return low * low <= sign * square < 100 * low * low


def expected_decades(top, last):
    return {f"{sign}1e{k:+03d}" for k in range(last, top + 1) for sign in ("", "-")}


def generate(graze, scene, *more):
    done = run([graze, "generate", *scene, "-n", 500, "--seed", 5, "--strata", "level", "--quiet", *more], 600)
    checks.equal(done.returncode, 0, *scene, done.stderr)
    return done.stdout


def check_box(graze, name, scene, top, last):
    text = generate(graze, scene)
    names, rows = rows_of(text)
    box, deepest = BOXES[name]
    checks.equal(names[len(box):], ["id", "stratum", "order", "cell", "time", "k", "side", "decade"], name)
    checks.equal({row["decade"] for row in rows}, expected_decades(top, last), name, "decades")
    for row in rows:
        square = signed_square(box, deepest, [F(row[a]) for a in "xyz"[:len(box)]])
        checks.holds(in_decade(square, row["decade"]), name, row, to_double(square))
        checks.equal(row["side"], "out" if square > 0 else "in", name, row)
        checks.holds(row["stratum"] == "level" and row["k"] == "" and row["order"] and row["cell"], name, row)
    checks.equal(generate(graze, scene), text, name, "the same seed")
    _, some = rows_of(generate(graze, scene, "--representable", "binary64"))
    checks.equal({row["decade"] for row in some}, expected_decades(top, last), name, "binary64")
    for row in some:
        place = [F(row[a]) for a in "xyz"[:len(box)]]
        checks.holds(all(F(to_double(x)) == x for x in place), name, row)
        checks.holds(in_decade(signed_square(box, deepest, place), row["decade"]), name, row)


def check_missing(graze, scene):
    """2^33 away doubles are multiples of 2^-19, and so are the differences that a distance of a box is the hypotenuse of: no
    decade below 1e-06 has points. Each decade has rows or stands in the head and in the note."""
    done = run([graze, "generate", *scene, "-n", 500, "--seed", 5, "--strata", "level", "--representable", "binary64"], 600)
    checks.equal(done.returncode, 0, *scene, done.stderr)
    missing = [line.split()[2] for line in done.stdout.splitlines() if line.startswith("# decade ") and line.endswith(" cannot be made")]
    _, rows = rows_of(done.stdout)
    made = {row["decade"] for row in rows}
    checks.holds(expected_decades(-7, -9) <= set(missing), "below the last place", missing)
    checks.equal((made | set(missing), made & set(missing)), (expected_decades(-1, -9), set()), "each decade", made, missing)
    checks.holds(f"of the decade {', '.join(missing)}" in done.stderr, "note", done.stderr)


def check_enclosures(graze, folder, name, operation):
    case = os.path.join(ROOT, "cases", name)
    solid = next(f for f in sorted(os.listdir(case)) if f.startswith("solid."))
    scene = [os.path.join(case, solid), os.path.join(case, "motion.json"), "--operation", operation]
    done = run([graze, "generate", *scene, "-n", 150, "--seed", 8, "--strata", "level=3,face", "--quiet"], 600)
    checks.equal(done.returncode, 0, name, done.stderr)
    path = os.path.join(folder, "points.csv")
    with open(path, "w", encoding="utf-8") as f:
        f.write(done.stdout)
    table = run([graze, "classify", *scene, path, "--sdf", "1e-13r", "--quiet"], 600)
    _, rows = rows_of(table.stdout)
    seen = set()
    for row in rows:
        if row["stratum"] != "level":
            checks.equal(row["decade"], "", name, row)
            continue
        seen.add(row["decade"])
        for bound in ("sdf_low", "sdf_high"):
            value = F(row[bound])
            checks.holds(in_decade(value * abs(value), row["decade"]), name, row)
        checks.equal(row["pmc"], row["side"], name, row)
    known = sorted(F(d) for d in seen)
    checks.holds(len(known) > 10 and known[0] < 0 < known[-1], name, known)
    shallow = min(abs(k) for k in known)
    checks.holds(max(-known[0], known[-1]) / shallow >= 10 ** 7, name, known)


def check_validate(graze, folder, scene):
    """The candidate says 0 everywhere: the report has groups of the stratum and of small decades."""
    path = os.path.join(folder, "mine.py")
    with open(path, "w", encoding="utf-8") as f:
        f.write("import sys\nlines = [l for l in open(sys.argv[1]) if not l.startswith('#')]\n"
                "print('x,y,sdf', file=open(sys.argv[2], 'w'))\n"
                "open(sys.argv[2], 'a').writelines(','.join(l.split(',')[:2]) + ',0\\n' for l in lines[1:])\n")
    done = run([graze, "validate", *scene, "-n", 400, "--candidate", f"{sys.executable} {path} {{points}} {{out}}",
                "--candidate-has", "sdf", "--format", "json", "--quiet"], 600)
    report = json.loads(done.stdout)["comparison"]
    by = {g["value"]: g for g in report["errors-of-sdf"]["by"]["stratum"]}
    checks.holds("level" in by and by["level"]["within"] == 0, "validate", sorted(by))
    small = [g["value"] for g in report["errors-of-sdf"]["by"]["sdf"] if g["value"] in ("1e-08", "-1e-08")]
    checks.equal(len(small), 2, "near misses on both sides", small)


def main():
    args = options(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        path = {name: os.path.join(folder, name) for name in ("slide.json", "lift.json", "square.wkt", "far.json", "away.json")}
        for name, text in (("slide.json", json.dumps(SLIDE)), ("lift.json", json.dumps(LIFT)),
                           ("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n"),
                           ("away.json", json.dumps(LIFT).replace('[0, "3*t"]', '["2^33", "2^33+3*t"]')),
                           ("far.json", json.dumps(LIFT).replace("3*t", "t^40"))):
            with open(path[name], "w", encoding="utf-8") as f:
                f.write(text)
        # Diagonals of 3.46 and 1.41: 1e-9 of them is in the decade of 1e-9.
        check_box(args.graze, "cube", [CUBE, path["slide.json"]], -1, -9)
        check_box(args.graze, "square", [path["square.wkt"], path["lift.json"]], -1, -9)
        check_missing(args.graze, [path["square.wkt"], path["away.json"]])
        check_enclosures(args.graze, folder, "bracket", "sweep")
        check_enclosures(args.graze, folder, "gear", "sweep")
        check_enclosures(args.graze, folder, "unsweep-figure7", "unsweep")
        check_validate(args.graze, folder, [path["square.wkt"], path["lift.json"]])
        done = run([args.graze, "generate", path["square.wkt"], path["far.json"], "-n", 1, "--seed", 1,
                    "--strata", "level"], 60)
        checks.holds(done.returncode == 6 and "degree of at most 32" in done.stderr, done.returncode, done.stderr)
    checks.finish()


if __name__ == "__main__":
    main()
