#!/usr/bin/env python3
# suite
"""Logs of poses as ROS, robots and CAM write them.

A log of known poses under the names of other programs gives the motion of the plain list. Rotations of a tool's axis
and of three angles are compared with their definitions in decimals of 100 digits: products of rotations about the
axes in the order of formats.md; the least rotation has its axis across (0, 0, 1) and takes it to the tool's.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import sys
import tempfile
from decimal import Decimal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from evaluate import rotation_of  # noqa: E402
from exact import Fraction as F  # noqa: E402
from harness import Checks, options  # noqa: E402
from poses import POSES, WANT, frames, made, table  # noqa: E402
from truth import cos_sin, dec  # noqa: E402

checks = Checks()
check = checks.holds
WRITTEN = ("--numbers", "written")


def test_names(graze, folder):
    """The list of poses.py under names in parts, large and small."""
    for time, before, turned, between in (("Time", "pos", "q", "_"), ("secs", "pose.position", "pose.orientation", "."),
                                          ("header.stamp.sec", "field.pose.pose.position", "field.pose.pose.orientation", "."),
                                          ("timestamp", "/tf/translation", "/tf/rotation", "/"),
                                          ("TIME", "Position", "Quaternion", "_"), ("t", "tcp_pos", "tcp_quat", "_")):
        names = [time, *(before + between + x for x in "xyz"), *(turned + between + x for x in "wxyz")]
        got, report = made(graze, folder, table(names, POSES), *WRITTEN)
        check(got and frames(got) == WANT, names, got)
        check(f"x is '{names[1]}'" in report and f"qz is '{names[-1]}'" in report, report)


def test_clocks(graze, folder):
    """Nanoseconds are exact, whatever rounds the other numbers; counters and frames are passed over, stamps beside a time."""
    start, names = 1700000000123456789, "x,y,z,qx,qy,qz,qw"
    head = "%time,field.header.seq,field.header.stamp,field.header.frame_id," + ",".join(
        ["field.pose.position." + x for x in "xyz"] + ["field.pose.orientation." + x for x in "xyzw"])
    rows = [[str(start + 10 ** 7 * k), str(k), str(start - 5), "map", "1", "2", str(k), "0", "0", "0", "1"] for k in range(4)]
    got, report = made(graze, folder, table(head.split(","), rows))
    check(got and [frame[0] for frame in frames(got)] == [F(start + 10 ** 7 * k, 10 ** 9) for k in range(4)], got)
    check("passed over: field.header.seq, field.header.frame_id, field.header.stamp\n" in report, report)
    # The time that the caller names is the whole time: the other clock adds nothing to it.
    twice = [[row[0], row[1], str(start + 7 * 10 ** 6 * k), *row[3:]] for k, row in enumerate(rows)]
    for name, unit in (("nanoseconds", 10 ** 9), ("t", 1)):
        got, _ = made(graze, folder, table(head.split(","), twice), *WRITTEN, "--columns", f"{name}=field.header.stamp")
        check(got and [frame[0] for frame in frames(got)] == [F(start + 7 * 10 ** 6 * k, unit) for k in range(4)], name, got)
    rows = [[str(17 + k // 2), str(k % 2 * 500000001), "1", "2", str(k), "0", "0", "0", "1"] for k in range(4)]
    got, _ = made(graze, folder, table(["stamp.sec", "stamp.nanosec", *names.split(",")], rows), *WRITTEN)
    check(got and [frame[0] for frame in frames(got)] == [17 + k // 2 + F(k % 2 * 500000001, 10 ** 9) for k in range(4)], got)
    # A name that is given wins over those that would be taken, and says in which unit a stamp is.
    rows = [[*p, "9", "9", "9", str(3 * k), "7"] for k, p in enumerate(POSES)]
    head = ["t", "u", "v", "w3", "qw", "qx", "qy", "qz", "x", "y", "z", "stamp", "imu_bias_1"]
    got, report = made(graze, folder, table(head, rows), *WRITTEN, "--columns", "x=u,y=v,tz=w3,t=stamp", "--ignore", "imu*")
    check(got and frames(got) == [(F(3 * k), *w[1:]) for k, w in enumerate(WANT)], got)
    check("passed over: t, x, y, z\n" in report, report)


def told(report, line):
    """The bound behind a line of the report."""
    at = re.search(rf"^{line}: .* at most (\S+) radians$", report, re.M)
    return Decimal(at[1]) if check(at, line, report) else Decimal(0)


def apply_turn(axis, degrees, matrix):
    """The rotation about a coordinate axis after a matrix."""
    c, s = cos_sin(degrees)
    b, d, out = (axis + 1) % 3, (axis + 2) % 3, [row[:] for row in matrix]
    out[b] = [c * x - s * y for x, y in zip(matrix[b], matrix[d])]
    out[d] = [s * x + c * y for x, y in zip(matrix[b], matrix[d])]
    return out


# Machine: columns of the angle that is applied first, second, third, and their axes (formats.md).
ORDERS = {"kuka": ("CBA", "xyz"), "fanuc": ("WPR", "xyz"), "staubli": (("RZ", "RY", "RX"), "zyx"),
          "kawasaki": ("TAO", "zyz"), "cnc": ("ABC", "xyz"), "rpy": (("roll", "pitch", "yaw"), "xyz")}


def test_angles(graze, folder, rng):
    for machine, (names, axes) in ORDERS.items():
        rows = [[str(rng.randint(-720000, 720000) / 1000) for _ in range(3)] for _ in range(12)]
        rows += [["0", "0", "0"], ["90", "-90", "180"], ["0", "0", "360"]]
        for tolerance in ("1e-6", "1e-25"):
            got, report = made(graze, folder, table([*"xyz", *names], [["1", "2", "3", *row] for row in rows]), *WRITTEN,
                               "--angles", machine, "--tolerance", tolerance)
            bound, worst, before = told(report, "angles"), Decimal(0), None
            for (_, _, quaternion), row in zip(frames(got), rows):
                want = [[Decimal(i == j) for j in range(3)] for i in range(3)]
                for axis, angle in zip(axes, row):
                    want = apply_turn("xyz".index(axis), Decimal(angle), want)
                worst = max([worst] + [abs(dec(a) - b) for p, q in zip(rotation_of(quaternion), want) for a, b in zip(p, q)])
                check(before is None or sum(a * b for a, b in zip(before, quaternion)) >= 0, "the nearer sign", machine)
                before = quaternion
            check(worst <= bound <= Decimal(tolerance), machine, worst, bound)
    # A machine tool's angle without a column is 0.
    one, _ = made(graze, folder, "x,y,z,A,C\n0,0,0,10,20\n1,0,0,30,40\n", "--angles", "cnc")
    all_, _ = made(graze, folder, "x,y,z,A,B,C\n0,0,0,10,0,20\n1,0,0,30,0,40\n", "--angles", "cnc")
    check(one == all_, "a missing angle")


def test_axes(graze, folder, rng):
    rows = [[str(rng.randint(-9, 9)) for _ in range(2)] + [str(rng.choice((-50, -9, -1, 0, 1, 7)))] for _ in range(40)]
    rows += [["0", "0", "1"], ["0", "0", "0.25"], ["3", "4", "0"], ["1e-9", "0", "-1"], ["0.6", "0", "0.8"]]
    rows = [row for row in rows if any(float(x) for x in row[:2]) or float(row[2]) > 0]
    got, report = made(graze, folder, table([*"XYZIJK"], [["1", "2", "3", *row] for row in rows]), *WRITTEN)
    bound, worst, before = told(report, "axes"), Decimal(0), None
    for (_, _, quaternion), row in zip(frames(got), rows):
        i, j, k = (Decimal(x) for x in row)
        length, turned = (i * i + j * j + k * k).sqrt(), rotation_of(quaternion)
        worst = max([worst] + [abs(dec(turned[m][2]) - x / length) for m, x in enumerate((i, j, k))])
        check(quaternion[3] == 0, "the axis lies across (0, 0, 1)", row, quaternion)
        check(before is None or sum(a * b for a, b in zip(before, quaternion)) >= 0, "the nearer sign", row)
        before = quaternion
    check(worst <= bound <= Decimal("1e-15"), worst, bound)
    got, report = made(graze, folder, "X,Y,Z,I,J,K\n0,0,0,0,0,5\n1,0,0,0.6,0,0.8\n", *WRITTEN, "--tolerance", "0")
    numbered, said = made(graze, folder, "N,X,Y,Z,I,J,K,F\n10,0,0,0,0,0,5,200\n20,1,0,0,0.6,0,0.8,200\n", *WRITTEN)
    check(got and numbered == got and "passed over: N, F\n" in said, numbered, said)
    check(got and frames(got)[1][2] in ([F(9, 5), 0, F(3, 5), 0],) and told(report, "axes") == 0, "exact where the length is", got)


def test_positions(graze, folder):
    got, report = made(graze, folder, "X,Y,Z\n0,0,0\n1,2,3\n")
    check(got and got["keyframes"] == [{"t": "0", "row": 2, "position": ["0", "0", "0"]},
                                     {"t": "1", "row": 3, "position": ["1", "2", "3"]}], got)
    check("the list has no rotations" in report, report)


def main():
    args = options(__doc__, seed=1)
    with tempfile.TemporaryDirectory() as folder:
        test_names(args.graze, folder)
        test_clocks(args.graze, folder)
        test_angles(args.graze, folder, args.random)
        test_axes(args.graze, folder, args.random)
        test_positions(args.graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
