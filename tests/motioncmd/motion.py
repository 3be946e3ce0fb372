#!/usr/bin/env python3
# suite
"""Files of `graze motion` against the motion that was asked for.

The files are evaluated by code of this folder, in fractions; the motion asked for is computed from its
definition in decimals of 100 digits. Errors are looked for at many times, among them where the bound
puts the largest ones, and must stay below the bound the program printed, which must be below the
tolerance. SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from evaluate import Motion, apply, multiply, rotation_of  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from harness import Checks, options  # noqa: E402
from truth import dec, joint_map, norm  # noqa: E402

CUBE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "refuse", "common", "cube.off")
SQUARE = os.path.join(os.path.dirname(CUBE), "square.wkt")
CUBE = os.path.join(harness.ROOT, "tests", "refuse", "common", "cube.off")
checks = Checks()
check = checks.holds


def run(graze, *arguments):
    done = harness.run([graze, *arguments], 300)
    return done.returncode, done.stdout, done.stderr


def make(graze, folder, *arguments):
    """(Motion, the report) of a command that must succeed, and whose file `check` must accept."""
    path = os.path.join(folder, "made.json")
    status, _, report = run(graze, "motion", *arguments, "--output", path)
    check(status == 0, arguments, report)
    if status:
        return None, report
    with open(path, encoding="utf-8") as file:
        motion = Motion(json.load(file))
    status, _, says = run(graze, "check", CUBE if motion.dimension == 3 else SQUARE, path)
    check(status == 0, arguments, says)
    return motion, report


def bound_of(report):
    """The number that ends the line `error: ... at most E`."""
    line = [line for line in report.splitlines() if line.startswith("error:")][0]
    return dec(line.split()[-1])


def rigid(matrix):
    """Are the columns of the linear part orthonormal, exactly, and right-handed?"""
    d = len(matrix)
    columns = [[row[j] for row in matrix] for j in range(d)]
    return all(sum(a * b for a, b in zip(columns[i], columns[j])) == (i == j)
               for i in range(d) for j in range(i + 1))


def vector(text):
    return [F(x) for x in text.split(",")]


def points_within(rng, radius, d):
    """Points of the ball, some on its sphere up to 1 part in 10^6, and the centre."""
    out = [[F(0)] * d]
    for axis in range(d):
        out.append([radius * (k == axis) for k in range(d)])
    while len(out) < 8:
        p = [F(rng.randint(-1000, 1000)) for _ in range(d)]
        length = F(str(norm([dec(x) for x in p]))) * (1 + F(1, 10**6))
        if length:
            out.append([x * radius / length for x in p])
    return out


def largest_error(motion, joints, times, points):
    """The largest displacement between file and truth, at the times and points."""
    worst = dec(0)
    for t in times:
        made = motion.at(t)
        check(rigid(made), "not rigid at", t)
        asked = joint_map(joints, dec(t), motion.dimension)
        for p in points:
            there = apply(made, p)
            truth = asked([dec(x) for x in p])
            worst = max(worst, norm([dec(a) - b for a, b in zip(there, truth)]))
    return worst


# Angles whose cosines are known from tables, and others; with and without rational axis length.
ROTATIONS = [("37.5", "0,0,1", None), ("90", "0,0,1", "1,2,3"), ("-217.5", "3,4,0", "1,0,0"),
             ("720", "1,2,2", None), ("-30", "1,1,1", None), ("250", "1,1,0", "0,1/3,0"),
             ("540", "1,1,1", None), ("0", "0,1,0", None), ("0.001", "0,0,1", None),
             ("359.999", "0,0,2", "5,0,0"), ("60", "1,1,1", None), ("360/7", None, "1,1"),
             ("-1000", None, None)]


def test_rotations(graze, folder, args):
    rng = args.random
    for degrees, axis, center in args.once(ROTATIONS, "rotations"):
        for tolerance, radius in (("1e-9", "1"), ("1e-3", "10"), ("1e-30", "1/2")):
            words = ["rotate", "--degrees", degrees, "--tolerance", tolerance, "--radius", radius]
            words += ["--axis", axis] if axis else ["--dimension", "2"]
            words += ["--center", center] if center else []
            motion, report = make(graze, folder, *words)
            if motion is None:
                continue
            d = 3 if axis else 2
            joint = ("turn", F(degrees), F(0), vector(axis) if axis else None,
                     vector(center) if center else [F(0)] * d)
            points = points_within(rng, F(radius), d)
            error = largest_error(motion, [joint], [F(1)], points)
            # The bound of a quarter turn is 0, and `error` is rounded.
            check(error <= bound_of(report) + dec("1e-50") and bound_of(report) <= dec(tolerance), words, error, report)
            check(motion.at(F(0)) == [[F(i == j) for j in range(d + 1)] for i in range(d)], words)
            if F(degrees) % 90 == 0 and axis != "1,1,1":
                check(error < dec("1e-50") and bound_of(report) == 0, words, "a quarter turn is exact", error, report)
            for t in (F(1, 7), F(1, 2), F(6, 7)):
                on_the_way(motion.at(t), joint, words)


def on_the_way(matrix, joint, words):
    """Every position is exactly a turn about the axis: it is rigid and leaves axis and center alone."""
    check(rigid(matrix), words)
    center, axis = joint[4], joint[3]
    check(apply(matrix, center) == center, words, "the center moves")
    if axis:
        tip = [a + b for a, b in zip(center, axis)]
        check(apply(matrix, tip) == tip, words, "the axis moves")


CHAINS = [["turn:90:0,0,1"], ["turn:-300:1,2,2:1,0,0"], ["screw:720:2:1,1,0:1,0,0"],
          ["screw:90:-3:0,0,5"], ["turn:90:0,0,1", "turn:-45:0,0,1:2,0,0", "slide:0,0,1"],
          ["slide:1,2,3", "turn:400:1,1,1:0,1,0", "screw:-100:1/2:3,4,0", "turn:20:1,0,0"]]
PLANE = [["turn:360:0,1", "slide:1,2"], ["turn:-500:3,4", "turn:77:0,0"]]


def joint_of(word, d):
    kind, *rest = word.split(":")
    if kind == "slide":
        return ("slide", vector(rest[0]))
    pitch = F(rest.pop(1)) if kind == "screw" else F(0)
    axis = vector(rest.pop(1)) if d == 3 else None
    return ("turn", F(rest[0]), pitch, axis, vector(rest[1]) if len(rest) > 1 else [F(0)] * d)


def times_of(rng, pieces, count):
    """Ends and middles of pieces, and the places where the sway is largest: x = 1/sqrt(3) from the
    middle outwards."""
    out = {F(0), F(1)}
    for _ in range(count):
        k = rng.randrange(pieces)
        for s in (F(0), F(1, 2) - F(2887, 10000), F(1, 2), F(1, 2) + F(2887, 10000),
                  F(rng.randint(0, 1000), 1000)):
            out.add((k + s) / pieces)
    return sorted(out)


def test_chains(graze, folder, args):
    rng = args.random
    for words, d in args.once([(c, 3) for c in CHAINS] + [(c, 2) for c in PLANE], "chains"):
        for tolerance, radius in (("1e-6", "1"), ("1e-2", "3"), ("1e-5", "1/100")):
            given = ["joints", *words, "--tolerance", tolerance, "--radius", radius]
            motion, report = make(graze, folder, *given, "--dimension", str(d))
            if motion is None:
                continue
            pieces = int(report.split("pieces: ")[1].split()[0])
            check(pieces == len(motion.pieces), given, "pieces", pieces)
            joints = [joint_of(w, d) for w in words]
            times = times_of(rng, pieces, 6 * max(1, int(args.scale)))
            error = largest_error(motion, joints, times, points_within(rng, F(radius), d))
            check(error <= bound_of(report) <= dec(tolerance), given, error, report)
            reach_only = len(words) == 1 and ":1,0,0" not in words[0] and d == 3
            quarters = max(-(-abs(j[1]) // 90) for j in joints if j[0] == "turn")
            # One joint about an axis through the origin: half the pieces would sway eight times as
            # much, which was too much, up to an eighth for rounding; the points reach all of the
            # radius up to the angle between them and the axis.
            if reach_only and pieces > quarters:
                check(error > dec(tolerance) / 40, given, "too many pieces", error)


def test_line(graze, folder, rng):
    """At the time t the map is the translation by t times the way, exactly; two numbers are the plane's."""
    for d in (2, 3):
        for k in range(6):
            way = [F(rng.randint(-999, 999), rng.randint(1, 99)) if k or i else F(0) for i in range(d)]
            words = ["line", "--by", ",".join(map(str, way))]
            motion, report = make(graze, folder, *words)
            check(motion is not None and bound_of(report) == 0, words, report)
            for t in (F(0), F(1, 3), F(1)):
                want = [[F(i == j) for j in range(d)] + [t * way[i]] for i in range(d)]
                check(motion.at(t) == want, words, t, motion.at(t))


def test_screw(graze, folder, rng):
    """A screw is the motion of one such joint; the end of a whole number of turns is exact."""
    words = ["screw", "--degrees", "720", "--axis", "0,3,4", "--pitch", "5", "--center", "1,0,0"]
    motion, report = make(graze, folder, *words)
    same, _ = make(graze, folder, "joints", "screw:720:5:0,3,4:1,0,0")
    check(motion.pieces == same.pieces, "screw and joints differ")
    # Two turns of pitch 5 along (0, 3, 4)/5: the way is (0, 6, 8).
    check(motion.at(F(1)) == [[1, 0, 0, 0], [0, 1, 0, 6], [0, 0, 1, 8]], "end of the screw")
    check(bound_of(report) <= dec("1e-6"), report)
    # Axes whose length is no rational number, long and short: after a turn by 90 degrees the way is a quarter pitch.
    for axis, length in (((3000000, 1, 0), 9000000000001), ((F(1, 1000000), F(2, 1000000), 0), F(5, 10**12))):
        motion, report = make(graze, folder, "screw", "--degrees", "90", "--axis", ",".join(map(str, axis)), "--pitch", "8")
        if motion is None:
            continue
        way = [row[3] for row in motion.at(F(1))]
        share = sum(a * w for a, w in zip(axis, way))   # |axis| times the way along it, which is 2
        error = abs(dec(share) / dec(length).sqrt() - 2)
        check(error <= bound_of(report) <= dec("1e-6"), "advance along", axis, error, report)


def write(folder, text):
    path = os.path.join(folder, "poses.csv")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def keyframes(graze, folder, text, *options):
    path = os.path.join(folder, "poses.json")
    status, _, report = run(graze, "motion", "poses", write(folder, text), "--output", path, *options)
    check(status == 0, text, report)
    with open(path, encoding="utf-8") as file:
        return json.load(file), report


def test_quaternions(graze, folder):
    text = ("# a list\nt,qw,qx,qy,qz,x,y,z\r\n0,1,0,0,0,0.1,0,0\n\n"
            "0.5,0.7,0,0,0.7,1e-3,2,3\n1,-0.5,0,0,-0.8660254037844386,1,1,1\n")
    want = [("0", ["0.1", "0", "0"], ["1", "0", "0", "0"]),
            ("0.5", ["1e-3", "2", "3"], ["0.7", "0", "0", "0.7"]),
            ("1", ["1", "1", "1"], ["-0.5", "0", "0", "-0.8660254037844386"])]
    for options, value in (([], lambda x: F(to_double(x))), (["--numbers", "written"], F)):
        made, report = keyframes(graze, folder, text, *options, "--long")
        got = [(F(k["t"]), [F(x) for x in k["position"]], [F(x) for x in k["quaternion"]])
               for k in made["keyframes"]]
        check(got == [(value(t), list(map(value, p)), list(map(value, q))) for t, p, q in want],
              "poses as written", got)
        check("of those before, at lines 6; 1 in all" in report, "the long way is told", report)
    made, _ = keyframes(graze, folder, "qw,qx,qy,qz\n1,0,0,0\n0,0,0,1\n0,1,0,0\n")
    check([k["t"] for k in made["keyframes"]] == ["0", "1", "2"], "times count from 0")


def random_rotation(rng):
    """(rational rotation, its unit quaternion squared away)"""
    q = [F(rng.randint(-30, 30)) for _ in range(4)]
    return rotation_of(q) if any(q) else random_rotation(rng)


def test_matrices(graze, folder, args):
    rng = args.random
    names = ",".join(f"m{i}{j}" for i in range(4) for j in range(4))
    for round_ in args.rounds(6, "matrices"):
        noise = (0, 1e-15, 1e-9)[round_ % 3]
        frames = []
        for _ in range(12):
            matrix = [[to_double(x) + noise * rng.uniform(-1, 1) for x in row]
                      for row in random_rotation(rng)]
            frames.append([matrix[i] + [rng.uniform(-5, 5)] for i in range(3)])
        rows = "\n".join(",".join(repr(x) for row in m for x in row) + ",0,0,0,1" for m in frames)
        made, report = keyframes(graze, folder, names + "\n" + rows + "\n")
        worst, before = F(0), [1, 0, 0, 0]
        for frame, key in zip(frames, made["keyframes"]):
            q = [F(x) for x in key["quaternion"]]
            check([F(x) for x in key["position"]] == [F(row[3]) for row in frame], "position")
            worst = max([worst] + [abs(a - F(b)) for r, row in zip(rotation_of(q), frame)
                                   for a, b in zip(r, row)])
            check(sum(a * b for a, b in zip(q, before)) >= 0, "sign", q, before)
            before = q
        told = F(report.split("change by at most ")[1].split()[0])
        check(worst <= told <= worst * F(102, 100) + F(1, 10**30), "deviation", to_double(worst), report)
        # The nearest rotation is no further than the true one, up to a factor for the two norms.
        check(worst <= F(3) * F(noise) + F(1, 10**14), "not near", to_double(worst), noise)
        matrices_as_they_are(graze, folder, names, rows, frames)


def matrices_as_they_are(graze, folder, names, rows, frames):
    """Affine: the frames exactly, and entry by entry between. A matrix on the way may be singular,
    which the program refuses; so neighbours are only a few degrees apart here: the first repeated."""
    slow = "\n".join(row for row in rows.split("\n")[:1] for _ in range(3))
    made, _ = keyframes(graze, folder, names + "\n" + slow + "\n", "--affine")
    motion = Motion(made)
    check(motion.at(F(1)) == [[F(x) for x in row] for row in frames[0]], "affine frame")
    stretched = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1\n3,0,0,2,0,1,0,0,0,0.5,1,0,0,0,0,1\n"
    made, _ = keyframes(graze, folder, names + "\n" + stretched, "--affine")
    check(Motion(made).at(F(1, 4)) == [[F(3, 2), 0, 0, F(1, 2)], [0, 1, 0, 0], [0, F(1, 8), 1, 0]],
          "affine between")


def test_limits(graze, folder):
    """A chain too long to be read is refused within two seconds of the processor; none is that its reader takes."""
    done = harness.run(harness.bounded([graze, "motion", "joints", *["turn:36000:1,2,3"] * 6, "--tolerance", "1e-3"], cpu=2))
    check(done.returncode == 6 and "work=" in done.stderr, "work", done.returncode, done.stderr[-300:])
    path = os.path.join(folder, "chain.json")
    for words in (["turn:720:1,2,3", "turn:-90:0,0,1:1/3,0,2", "slide:1,0,1/7"], ["screw:360:1:1,1,1"], ["turn:360:0,0,1"],
                  ["turn:180:0,0,1", "turn:-180:0,0,1"], ["turn:90:1,1,0:1/3,5,7"]):
        made = ["motion", "joints", *words, "--tolerance", "1e-3", "--output", path]
        harness.run([graze, *made])
        low, high = 1, 10**8  # between them is the least limit with which the file is read
        while low < high:
            middle = (low + high) // 2
            taken = harness.run([graze, "check", CUBE, path, "--limit", f"work={middle}"]).returncode != 6
            low, high = (low, middle) if taken else (middle + 1, high)
        for work, status in ((low, 0), (low - 1, 6)):
            done = harness.run([graze, *made, "--limit", f"work={work}"])
            check(done.returncode == status, words, f"work={work}", done.returncode, done.stderr[-300:])


def main():
    args = options(__doc__, seed=1)
    graze, rng = args.graze, args.random
    check(multiply([[F(0), F(1)], [F(1), F(0)]], [[F(2), F(0)], [F(0), F(3)]]) ==
          [[F(0), F(3)], [F(2), F(0)]], "the product of matrices of this test")
    with tempfile.TemporaryDirectory() as folder:
        test_rotations(graze, folder, args)
        test_chains(graze, folder, args)
        test_matrices(graze, folder, args)
        if args.derived:
            test_line(graze, folder, rng)
            test_screw(graze, folder, rng)
            test_limits(graze, folder)
            test_quaternions(graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
