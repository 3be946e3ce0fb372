#!/usr/bin/env python3
# suite
"""Motions of G-code programs.

Random programs in every spelling are run by a reader of this file, in fractions: positions and lines at the ends of
all moves must be the same. On every piece of an exact arc, points lie on the circle in fractions, and turn the right
way through the angle that the ends have; near arcs and helices are within the bound that is told, by definition.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from evaluate import value  # noqa: E402
from exact import Fraction as F  # noqa: E402
from harness import Checks, options  # noqa: E402
from poses import made as made_of  # noqa: E402

checks = Checks()
check = checks.holds
# Points at the distance 65 from the origin: their coordinates are whole, so arcs between them are exact.
RING = sorted({(s * a, t * b) for x, y in ((0, 65), (16, 63), (25, 60), (33, 56), (39, 52)) for a, b in ((x, y), (y, x))
               for s in (1, -1) for t in (1, -1)})
SHARES = (F(0), F(1, 3), F(1, 2), F(6, 7), F(1))


class Piece:
    def __init__(self, given):
        self.t, self.row = [F(x) for x in given["t"]], given["row"]
        self.parts = [text.replace("^", "**") for text in given["transform"]["translate"]]

    def at(self, s):
        return [value(part, 0, s) for part in self.parts]


def made(graze, folder, program, *arguments):
    """(pieces, report) of a program that must be taken."""
    motion, report = made_of(graze, folder, program, *arguments, kind="gcode")
    check(motion is not None, "taken", program, report)
    return motion and [Piece(piece) for piece in motion["pieces"]], report


def told(report, line):
    """The bound of a line's error; 0 for a line that is not named."""
    at = re.search(rf"^line {line}: the arc is off its (?:circle|helix) by at most (\S+)$", report, re.M)
    return F(at[1]) if at else F(0)


def plane_of(point, plane):
    """Coordinates in a plane, counter-clockwise seen from the end of the third axis, and along that."""
    first = {17: 0, 18: 2, 19: 1}[plane]
    return [point[(first + k) % 3] for k in range(3)]


def angle_between(start, end, clockwise):
    """The angle of an arc, above 0 up to a full turn; ends as seen from the centre."""
    turn = math.atan2(float(end[1]), float(end[0])) - math.atan2(float(start[1]), float(start[0]))
    turn = (-turn if clockwise else turn) % math.tau
    return turn if turn > 1e-9 else math.tau


def check_arc(pieces, plane, centre, square, clockwise, bound, where):
    """Points of an arc about a centre, whose squared radius is `square`: on the circle, or within the bound of it."""
    points = [plane_of(piece.at(s), plane) for piece in pieces for s in SHARES]
    seen = [[x - c for x, c in zip(point, centre)] for point in points]
    radius, whole, rise = math.sqrt(square), 0.0, points[-1][2] - points[0][2]
    angles = [0.0]
    for before, after in zip(seen, seen[1:]):
        cross = before[0] * after[1] - before[1] * after[0]
        check(cross <= 0 if clockwise else cross >= 0, "the way round", where, float(cross))
        whole += math.atan2(abs(cross), float(before[0] * after[0] + before[1] * after[1]))
        angles.append(whole)
    check(abs(whole - angle_between(seen[0], seen[-1], clockwise)) < 1e-6, "the angle", where, whole)
    for angle, (x, y), point in zip(angles, (one[:2] for one in seen), points):
        if not bound:
            check(x * x + y * y == square, "on the circle", where, x, y)
        off = abs(math.hypot(x, y) - radius) + abs(float(point[2] - points[0][2]) - float(rise) * angle / whole)
        check(off <= float(bound) + 1e-12, "within the bound", where, off, float(bound))
    for before, after in zip(pieces, pieces[1:]):
        check(before.at(F(1)) == after.at(F(0)) and before.t[1] == after.t[0], "pieces meet", where)


def spelled(rng, letter, number):
    """A word as programs write it."""
    text = f"{float(number):.4f}".rstrip("0").rstrip(".") if number != int(number) else str(int(number))
    if text.startswith("0.") and rng.random() < 0.3:
        text = text[1:]
    if letter in "GMN" and len(text) == 1 and rng.random() < 0.4:
        text = "0" + text
    elif letter not in "GMN" and number >= 0 and rng.random() < 0.1:
        text = "+" + text
    letter = rng.choice((letter, letter.lower()))
    return letter + rng.choice(("", "", " ", "\t")) + text


class Program:
    """A random program, and what it means."""

    def __init__(self, rng):
        self.rng, self.lines, self.moves = rng, [], []
        self.at, self.known = [F(0)] * 3, False
        self.plane, self.unit, self.relative, self.mode = 17, F(1), False, None
        self.put([("G", 90), ("G", 0), ("X", F(1)), ("Y", F(2)), ("Z", F(3))])
        self.at, self.mode = [F(1), F(2), F(3)], 0

    def put(self, words):
        rng = self.rng
        words = list(words)
        rng.shuffle(words)
        if rng.random() < 0.3:
            words.insert(0, ("N", len(self.lines) * 10))
        if rng.random() < 0.3:
            words.append(rng.choice((("F", 300), ("S", 12000), ("T", 3), ("M", 8))))
        text = rng.choice(("", " ")).join(spelled(rng, *word) for word in words)
        if rng.random() < 0.2:
            text = rng.choice((text + " ; G1 X9", text + "(G91)", "(z1) " + text))
        self.lines.append(text)

    def words_to(self, axes, to):
        """Words of coordinates, in the modes that are in force, and where they lead exactly."""
        words = []
        for k in axes:
            asked = to[k] - self.at[k] if self.relative else to[k]
            number = F(round(float(asked / self.unit) * 1000), 1000)
            self.at[k] = number * self.unit + (self.at[k] if self.relative else 0)
            words.append(("XYZ"[k], number))
        return words

    def add_modes(self):
        rng, words = self.rng, []
        if rng.random() < 0.2:
            self.unit = rng.choice((F(1), F(127, 5)))
            words.append(("G", 21 if self.unit == 1 else 20))
        if rng.random() < 0.3:
            self.relative = not self.relative
            words.append(("G", 91 if self.relative else 90))
        if rng.random() < 0.3:
            self.plane = rng.choice((17, 18, 19))
            words.append(("G", self.plane))
        return words

    def add_line(self):
        rng, start = self.rng, list(self.at)
        words, mode = self.add_modes(), rng.choice((0, 1))
        if mode != self.mode or rng.random() < 0.3:
            words.append(("G", mode))
        self.mode = mode
        axes = rng.sample(range(3), rng.randint(1, 3))
        words += self.words_to(axes, [F(rng.randint(-50, 50), 10) for _ in range(3)])
        self.put(words)
        if self.at != start:
            self.moves.append((len(self.lines), start, list(self.at), None))

    def add_arc(self):
        """An exact arc between points of the ring; in increments, so that no coordinate is rounded."""
        rng, start = self.rng, list(self.at)
        words, mode = self.add_modes(), rng.choice((2, 3))
        if not self.relative:
            words = [word for word in words if word != ("G", 90)] + [("G", 91)]
            self.relative = True
        if mode != self.mode or rng.random() < 0.3:
            words.append(("G", mode))
        self.mode, first = mode, {17: 0, 18: 2, 19: 1}[self.plane]
        axes = [first, (first + 1) % 3, (first + 2) % 3]
        a, b = rng.choice(RING), rng.choice(RING)
        scale = F(1, rng.choice((10, 100, 1000)))
        for k in range(2):
            if b[k] != a[k] or rng.random() < 0.3:
                words.append(("XYZ"[axes[k]], (b[k] - a[k]) * scale))
            if a[k] or rng.random() < 0.5:
                words.append(("IJK"[axes[k]], -a[k] * scale))
            self.at[axes[k]] += (b[k] - a[k]) * scale * self.unit
        if rng.random() < 0.2:
            rise = F(rng.randint(-20, 20), 10)
            words.append(("XYZ"[axes[2]], rise))
            self.at[axes[2]] += rise * self.unit
        centre = [start[axes[k]] - a[k] * scale * self.unit for k in range(2)]
        self.put(words)
        self.moves.append((len(self.lines), start, list(self.at),
                           (self.plane, centre, (65 * scale * self.unit) ** 2, mode == 2)))


def test_random(graze, folder, rng):
    program = Program(rng)
    for _ in range(25):
        program.add_arc() if rng.random() < 0.4 else program.add_line()
    text = "\n".join(program.lines) + "\n"
    pieces, report = made(graze, folder, text)
    if pieces is None:
        return
    check(f"moves: {len(program.moves)}, " in report, report, text)
    for k, (line, start, end, arc) in enumerate(program.moves):
        own = [piece for piece in pieces if k <= piece.t[0] < k + 1]
        check(own and own[0].t[0] == k and own[-1].t[1] == k + 1, "one unit of t", line, text)
        check({piece.row for piece in own} == {line}, "the line", line, [piece.row for piece in own], text)
        check(own[0].at(F(0)) == start and own[-1].at(F(1)) == end, "ends", line, text)
        if arc is None:
            check(len(own) == 1 and own[0].at(F(1, 3)) == [a + (b - a) / 3 for a, b in zip(start, end)], "straight", line)
            continue
        plane, centre, square, clockwise = arc
        rises = plane_of(start, plane)[2] != plane_of(end, plane)[2]
        bound = told(report, line)
        check(bool(bound) == rises, "exact without a rise", line, report)
        check_arc(own, plane, centre, square, clockwise, bound, (line, program.lines[line - 1]))
        if rises:  # in the plane a helix is exact too
            for piece in own:
                x, y, _ = plane_of(piece.at(F(2, 5)), plane)
                check((x - centre[0]) ** 2 + (y - centre[1]) ** 2 == square, "a helix on its cylinder", line)


def test_arcs(graze, folder):
    """Arcs by hand, in a piece for each quarter begun."""
    pieces, report = made(graze, folder, "g0x0y0z0\ng3x0y2i0j1\ng2x0y0j-1\ng2i3\n")
    check([piece.t for piece in pieces][:3] == [[0, F(1, 2)], [F(1, 2), 1], [1, F(3, 2)]] and len(pieces) == 8, pieces)
    check([piece.at(F(1)) for piece in pieces if piece.t[1] == int(piece.t[1])] == [[0, 2, 0], [0, 0, 0], [0, 0, 0]], "ends")
    for own, centre, square, clockwise in ((pieces[:2], (0, 1), 1, False), (pieces[2:4], (0, 1), 1, True), (pieces[4:], (3, 0), 9, True)):
        check_arc(own, 17, centre, F(square), clockwise, F(0), centre)
    check("arcs: 3, 3 of them exact\n" in report, report)
    # By R: 3, 4, 5. The centre of the shorter arc from (0, 0) to (6, 8) is the middle for R5; with R13 it is 12 beside it.
    for sign, radius, centre in ((3, 5, (3, 4)), (3, 13, (F(-33, 5), F(56, 5))), (3, -13, (F(63, 5), F(-16, 5))),
                                 (2, 13, (F(63, 5), F(-16, 5))), (2, -13, (F(-33, 5), F(56, 5)))):
        pieces, report = made(graze, folder, f"G0 X0 Y0 Z1\nG{sign} X6 Y8 R{radius}\n")
        check("arcs: 1, 1 of them exact\n" in report, report)
        check_arc(pieces, 17, centre, F(radius) ** 2, sign == 2, F(0), (sign, radius))
    # A centre in inches: 127/5 mm each.
    pieces, _ = made(graze, folder, "G20 G0 X0 Y0 Z0\nG3 X2 I1\n")
    check_arc(pieces, 17, (F(127, 5), 0), F(127, 5) ** 2, False, F(0), "inches")
    check(pieces[-1].at(F(1)) == [F(254, 5), 0, 0], "inches")


def test_near(graze, folder, rng, k):
    """Arcs whose ends have two radii, arcs by R with an irrational centre, helices: within what is told."""
    a, b = ([round(rng.uniform(-9, 9), 3) for _ in range(2)] for _ in range(2))
    mode, rise = rng.choice((2, 3)), rng.choice((0, 0, round(rng.uniform(-4, 4), 2)))
    tolerance = rng.choice(("1e-2", "1e-5"))
    if k % 2:
        radius = rng.choice((1, -1)) * round(math.dist(a, b) / 2 * rng.uniform(1.001, 3) + 0.001, 3)
        side = (1 if radius > 0 else -1) * (1 if mode == 3 else -1)
        high = math.sqrt((radius / math.dist(a, b)) ** 2 - 0.25) * side
        centre = [F((a[0] + b[0]) / 2 - (b[1] - a[1]) * high), F((a[1] + b[1]) / 2 + (b[0] - a[0]) * high)]
        words, square = f"R{radius}", F(radius) ** 2
    else:
        middle, high = [(x + y) / 2 for x, y in zip(a, b)], rng.uniform(-2, 2)
        offset = [round(middle[0] - (b[1] - a[1]) * high - a[0], 3), round(middle[1] + (b[0] - a[0]) * high - a[1], 3)]
        words = f"I{offset[0]} J{offset[1]}"
        exact = [F(str(x)) for x in offset]
        centre, square = [F(str(x)) + y for x, y in zip(a, exact)], sum(x * x for x in exact)
        tolerance = "1e-2"
    text = f"G0 X{a[0]} Y{a[1]} Z1\nG{mode} X{b[0]} Y{b[1]} Z{1 + rise:.2f} {words}\n"
    pieces, report = made(graze, folder, text, "--tolerance", tolerance)
    bound = told(report, 2)
    check(pieces and bound <= F(tolerance), report)
    check(pieces[0].at(F(0)) == [F(str(x)) for x in a] + [1], "the start", text)
    check(pieces[-1].at(F(1)) == [F(str(x)) for x in b] + [F(f"{1 + rise:.2f}")], "the end", text)
    check_arc(pieces, 17, centre, square, mode == 2, bound, text)


def test_bounds(graze, folder):
    # R is less than half the way: a half circle of radius 5, off one of 4.9995 by 0.0005.
    _, report = made(graze, folder, "G0 X0 Y0 Z0\nG2 X10 R4.9995\n")
    check(F("0.0005") <= told(report, 2) <= F("0.000501"), report)
    # Ends 3 and 3.004 from the centre: the bound is at least the difference, and not much more.
    _, report = made(graze, folder, "G0 X0 Y0 Z0\nG2 X3 Y3.004 I3\n")
    check(F("0.004") <= told(report, 2) <= F("0.0041"), report)


def test_start(graze, folder):
    """The first known position; a start that is given; the lines that end a program."""
    pieces, report = made(graze, folder, "G0 Z5\nG0 X1 Y2\nG1 Z0\nM2\nG1 Z9\n")
    check(len(pieces) == 1 and pieces[0].row == 3 and pieces[0].at(F(0)) == [1, 2, 5] and pieces[0].t == [0, 1], pieces)
    check("start: the position at the end of line 2\n" in report, report)
    pieces, report = made(graze, folder, "%\nG0 Z5\nX1 Y2 ; modal\nG1 X1 F9\n%\nnot read\n", "--start", "0,1/3,2")
    check([piece.row for piece in pieces] == [2, 3] and pieces[0].at(F(0)) == [0, F(1, 3), 2] and
          "start" not in report, report)
    # G80 ends the mode of motion; blanks and zeros mean nothing; a line that waits, and one that rounds corners.
    pieces, report = made(graze, folder, "\ufeffg00x0y0z0\r\nG4 P1.5\r\nG64 P0.01\r\nN7 G1G40G49 x +0. 12 34y 7\r\nM6 T2\r\nG80\r\n")
    check(pieces[0].at(F(1)) == [F("0.1234"), 7, 0] and pieces[0].row == 4, pieces)
    check("line 5: M6 may change the tool; the motion goes on\n" in report, report)
    check("line 3: G64 lets a machine round corners; the motion has them\n" in report, report)


def test_classified(graze, folder):
    """A point is cut by the line that leads there: a ball of radius 1 whose tip goes round (0, 0)."""
    pieces, _ = made(graze, folder, "G0 X0 Y-5 Z0\nG1 X0 Y-4\nG3 X0 Y4 J4\nG1 X9\n")
    check(len(pieces) == 4, pieces)
    files = {"mill.csg.json": '{"dimension": 3, "solid": {"ball": {"center": [0, 0, 1], "radius": 1}}}',
             "points.csv": "x,y,z\n4,0,1\n0,-4.5,1\n8,4,1\n0,0,1\n5,0,1\n-1,-4,1\n"}
    for name, text in files.items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)
    done = harness.run([graze, "classify", os.path.join(folder, "mill.csg.json"), os.path.join(folder, "made.json"),
                        os.path.join(folder, "points.csv"), "--moments", "--format", "jsonl"], 60)
    rows = [json.loads(line) for line in done.stdout.splitlines() if line.startswith('{"point"')]
    check([(row["pmc"], row["first_row"]) for row in rows] ==
          [("in", 3), ("in", 2), ("in", 4), ("out", None), ("on", 3), ("on", 2)], done.stderr,
          [(row.get("pmc"), row.get("first_row")) for row in rows])


def main():
    args = options(__doc__, seed=27)
    with tempfile.TemporaryDirectory() as folder:
        if args.derived:
            test_arcs(args.graze, folder)
            test_bounds(args.graze, folder)
            test_start(args.graze, folder)
            test_classified(args.graze, folder)
        for k in args.rounds(24):
            test_random(args.graze, folder, args.random)
            test_near(args.graze, folder, args.random, k)
    checks.finish()


if __name__ == "__main__":
    main()
