#!/usr/bin/env python3
# suite
"""`graze contact` on sites derived by hand: turns, an L-prism, jumps of velocity, slides, a reflection, pinches.

SPDX-License-Identifier: GPL-3.0-or-later

Each case has its derivation above it. Columns that a case does not name are not looked at; facets are (g, g_t, theta).
"""
import csv
import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import has_decimals  # noqa: E402
from program import Checks, Graze, options  # noqa: E402

BLOCK = "POLYGON ((2 -1, 4 -1, 4 1, 2 1, 2 -1))\n"
SQUARE = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\n"
DART = "POLYGON ((0 3, -2 -3, 0 -1, 2 -3, 0 3))\n"
PINCH = "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((0 0, -2 0, -2 -2, 0 -2, 0 0)))\n"
# PINCH with squares in the other quadrants that stop 2^-200 short of the origin.
SHORT = f"1/{2 ** 200}"
CROWDED = PINCH.strip()[:-1] + (f", ((-{SHORT} {SHORT}, -{SHORT} 1, -1 1, -1 {SHORT}, -{SHORT} {SHORT}))"
                                f", (({SHORT} -{SHORT}, {SHORT} -1, 1 -1, 1 -{SHORT}, {SHORT} -{SHORT})))\n")
SMALL = "MULTIPOLYGON (((8 8, 129/16 8, 129/16 129/16, 8 129/16, 8 8)), ((8 8, 127/16 8, 127/16 127/16, 8 127/16, 8 8)))\n"
# SMALL with squares in the other quadrants that begin 1/4 from its pinch: farther than its own squares are wide.
BESIDE = SMALL.strip()[:-1] + (", ((33/4 31/4, 12 31/4, 12 4, 33/4 4, 33/4 31/4))"
                               ", ((31/4 33/4, 4 33/4, 4 12, 31/4 12, 31/4 33/4)))\n")
PAIR = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((2 0, 3 0, 3 1, 2 1, 2 0)))\n"


def off(vertices, faces):
    return (f"OFF\n{len(vertices)} {len(faces)} 0\n" + "".join("%s %s %s\n" % v for v in vertices)
            + "".join(f"{len(f)} " + " ".join(map(str, f)) + "\n" for f in faces))


def prism_of(rings, z0, z1):
    """Prisms over rings that may share vertices."""
    vertices, faces = [], []
    for r in rings:
        n, base = len(r), len(vertices)
        vertices += [(x, y, z) for z in (z0, z1) for x, y in r]
        faces += [[base + k for k in range(n)][::-1], [base + n + k for k in range(n)]]
        faces += [[base + k, base + (k + 1) % n, base + n + (k + 1) % n, base + n + k] for k in range(n)]
    return off(vertices, faces)


PINCHED_EDGE = prism_of([[(0, 0), (2, 0), (2, 2), (0, 2)], [(0, 0), (-2, 0), (-2, -2), (0, -2)]], -3, 3)
# [0,4]^2 x [0,1] and, on it, [2,4] x [0,4] x [1,3]: an L along x and z, from y = 0 to y = 4.
L = [(0, 0), (4, 0), (4, 3), (2, 3), (2, 1), (0, 1)]
L_PRISM = off([(x, y, z) for y in (0, 4) for x, z in L],
              [list(range(6)), list(range(6, 12))[::-1]]
              + [[(k + 1) % 6, k, k + 6, (k + 1) % 6 + 6] for k in range(6)])


def moves(d, *pieces):
    return json.dumps({"dimension": d, "pieces": [{"t": [str(a), str(b)], "transform": t} for a, b, t in pieces]})


def shift(*entries):
    return {"translate": list(entries)}


TURN = {"rotate": {"tan_half": "t"}}
STILL, ALONG = moves(2, (0, 1, TURN)), moves(2, (0, 1, {"compose": [TURN, shift("2*t", "0")]}))
MIRRORED = moves(2, (0, 1, {"compose": [{"scale": ["-1", "1"]}, TURN, shift("2*t", "0")]}))
BACK = moves(2, (0, 1, shift("8*t", "0")), (1, 2, shift("16-8*t", "0")))
ON = moves(2, (0, 1, shift("8*t", "0")), (1, 2, shift("4+4*t", "0")))
RIGHT = moves(2, (0, 1, shift("8*t", "0")))
STAND = moves(2, (0, 1, shift("0", "0")))

CASES = [
    # With s = 2 atan t the pullback of x = 2 at (2, 0) is (2t-1)^2 up to a positive factor, of x = 4 at (4, 0)
    # -(3t-1)^2: w = omega^2 ... theta = 2 omega^2, -4 omega^2 with omega = 2/(1+t^2); g = 0 for all t: g_t = 0.
    (BLOCK, STILL, ("1/2", "2", "0"), dict(role="contact", theta="+", contact_order="2", orientation="degenerate",
     left="O", right="O", trimmed="no", status="simple", near="", near_in="", word="OBO"), [("0", "0", "128/25")] * 2),
    (BLOCK, STILL, ("1/3", "4", "0"), dict(role="contact", theta="-", contact_order="2", orientation="degenerate",
     left="I", right="I", trimmed="yes", status="trimmed_near", near="1/3", near_in="1/3", word="OBIBIBO"),
     [("0", "0", "-324/25")] * 2),
    # Turning while it moves by 2t along x: the pullback of x = 2 at (2, 3/4) is (2t-1)^2 (4-5t), that of x = 4 at
    # (4, 3/4) is (2t-1)^2 (5t-12), each over a positive number; -g_t/theta is -5/3 and -5/19.
    (BLOCK, ALONG, ("1/2", "2", "3/4"), dict(role="contact", theta="+", contact_order="2", orientation="reversing",
     left="O", right="O", trimmed="yes", status="trimmed_far", near="4/5", near_in="4/5", word="OBOBI"),
     [("0", "8/5", "24/25")] * 2),
    (BLOCK, ALONG, ("1/2", "4", "3/4"), dict(role="contact", theta="-", contact_order="2", orientation="reversing",
     left="I", right="I", trimmed="yes", status="trimmed_near", near="1/2", near_in="1/2", word="OBIBI"),
     [("0", "-8/5", "-152/25")] * 2),
    # A mirrored body under x -> -x first has the positions of the body itself: only det A changes its sign.
    ("POLYGON ((-2 -1, -4 -1, -4 1, -2 1, -2 -1))\n", MIRRORED, ("1/2", "-2", "3/4"), dict(role="contact", theta="+",
     orientation="preserving", status="trimmed_far", near="4/5", word="OBOBI"), [("0", "8/5", "24/25")] * 2),
    # To the right by 8 t and back: at the turn x = 2 moves out before and in after it, and only touches; x = 0 is
    # inside on both sides. theta is not asked at a break.
    (SQUARE, BACK, ("1", "2", "1"), dict(role="contact", theta="", contact_order="", orientation="", left="O", right="O",
     trimmed="no", status="simple", word="OBO"), [("8", "0", "0"), ("-8", "0", "0")]),
    # c runs from x = 8 to 0 and back: inside but at t = 1.
    (SQUARE, BACK, ("1", "0", "1"), dict(role="hidden", left="I", right="I", status="trimmed_near", near="1", word="OBIBIBO"),
     [("-8", "0", "0"), ("8", "0", "0")]),
    # Slower after t = 1, but never turning: egress in front, where c runs from x = 10 to 2 and on to -2; ingress behind.
    (SQUARE, ON, ("1", "2", "1"), dict(role="egress", left="O", right="I", status="trimmed_near", word="OBIBO"),
     [("8", "0", "0"), ("4", "0", "0")]),
    (SQUARE, ON, ("1", "0", "1"), dict(role="ingress", left="I", right="O", status="trimmed_near", word="OBIBO"),
     [("-8", "0", "0"), ("-4", "0", "0")]),
    # (5, 2) slides along the top from t = 3/8 to 5/8.
    (SQUARE, RIGHT, ("1/2", "1", "2"), dict(role="contact", theta="0", contact_order="inf", orientation="degenerate",
     left="B", right="B", status="slides", near="1/2", near_in="", word="OBO"), [("0", "0", "0")] * 2),
    (SQUARE, RIGHT, ("3/8", "2", "2"), dict(cell="vertex 2", role="contact", theta="", left="O", right="B", status="slides", near="3/8"),
     [("8", "0", "0")] * 2 + [("0", "0", "0")] * 2),
    # At a break theta is not asked, though the top slides on; where one motion is cut in two it is.
    (SQUARE, ON, ("1", "1", "2"), dict(role="contact", theta="", contact_order="", orientation="", status="slides"),
     [("0", "0", "0")] * 2),
    (SQUARE, moves(2, (0, 1, shift("8*t", "0")), (1, 2, shift("8*t", "0"))), ("1", "1", "2"), dict(role="contact", theta="0",
     contact_order="inf", orientation="degenerate", cell="edge 2-3", status="slides"), [("0", "0", "0")] * 2),
    # End caps: at the start the back is a contact and the front is not, at the end the reverse.
    (SQUARE, RIGHT, ("0", "0", "1"), dict(role="contact", left="", right="O", status="simple", word="BO"), [("-8", "0", "0")]),
    (SQUARE, RIGHT, ("0", "2", "1"), dict(role="egress", left="", right="I", status="trimmed_near", word="BIBO"),
     [("8", "0", "0")]),
    (SQUARE, RIGHT, ("1", "2", "1"), dict(role="contact", left="O", right="", status="simple", word="OB"), [("8", "0", "0")]),
    (SQUARE, RIGHT, ("1", "0", "1"), dict(role="ingress", left="I", right="", status="trimmed_near", word="OBIB"),
     [("-8", "0", "0")]),
    # The dart's notch: normals (1, -1), (-1, -1). Along x one side of it moves out, the other in.
    (DART, RIGHT, ("1/2", "0", "-1"), dict(role="hidden", status="trimmed_near", left="I", right="I"),
     [("8", "0", "0")] * 2 + [("-8", "0", "0")] * 2),
    (DART, moves(2, (0, 1, shift("0", "-8*t"))), ("1/2", "0", "-1"), dict(role="egress", left="O", right="I"),
     [("8", "0", "0")] * 4),
    (DART, STAND, ("1/2", "0", "-1"), dict(role="contact", status="slides", near="1/2", word="B"), [("0", "0", "0")] * 4),
    # The pinch moved along (1, -1), across both squares: two half-planes meet behind it. Normals (-1, 0), (0, -1) of
    # one, (1, 0), (0, 1) of the other square.
    (PINCH, moves(2, (0, 1, shift("t", "-t"))), ("1/2", "0", "0"), dict(role="hidden", left="O", right="O", word="OBO"), None),
    # Along x: the closed quadrants sweep y <= 0 and y >= 0.
    (PINCH, RIGHT, ("1/2", "0", "0"), dict(role="hidden"), None),
    # At the ends a quadrant is left open.
    (PINCH, RIGHT, ("0", "0", "0"), dict(role="contact"), None),
    (PINCH, RIGHT, ("1", "0", "0"), dict(role="contact"), None),
    # Squares there that do not reach the point change nothing, however near they are.
    (CROWDED, RIGHT, ("0", "0", "0"), dict(role="contact"), None),
    (CROWDED, RIGHT, ("1", "0", "0"), dict(role="contact"), None),
    (CROWDED, RIGHT, ("1/2", "0", "0"), dict(role="hidden"), None),
    # A pinch at (8, 8) of squares far smaller than 1: what is next to it is looked for within them.
    (SMALL, moves(2, (-1, 1, shift("t", "-t"))), ("0", "8", "8"), dict(role="hidden", left="O", right="O", word="OBO"), None),
    (SMALL, moves(2, (-1, 1, shift("t", "0"))), ("0", "8", "8"), dict(role="hidden"), None),
    (SMALL, moves(2, (0, 1, shift("t", "0"))), ("0", "8", "8"), dict(role="contact"), None),
    # Squares beside it change nothing: they pass the point at no time, and are not next to it.
    (BESIDE, moves(2, (0, 1, shift("t", "0"))), ("0", "8", "8"), dict(role="contact"), None),
    # A pinched edge along z, c = (t^2, -t^2, t): the velocity is along the edge, (1, -1) leads on both sides and
    # sweeps one of the two open quadrants. With t^3 it leads one way before and the other way after t = 0. g_t = n b'' with
    # b'' = (-2, 2, 0), theta its opposite; normals in the order of the faces: -y, -x, +y, +x.
    (PINCHED_EDGE, moves(3, (-1, 1, shift("-t^2", "t^2", "-t"))), ("0", "0", "0", "0"), dict(role="contact"),
     [("0", "-2", "2")] * 2 + [("0", "2", "-2")] * 4 + [("0", "-2", "2")] * 2),
    (PINCHED_EDGE, moves(3, (-1, 1, shift("-t^3", "t^3", "-t"))), ("0", "0", "0", "0"), dict(role="hidden"),
     [("0", "0", "0")] * 8),
    # An edge of the L beside its notch, y = (2 - 1/2, 0, 1), along (t, t, t): c is y + s (1, 1, 1), s = 3 - t. It is
    # outside for 0 < s < 1/2, in the upper part for 1/2 < s < 2, and outside beyond.
    (L_PRISM, moves(3, (0, 4, shift("t", "t", "t"))), ("3", "3/2", "0", "1"), dict(role="contact", theta="", left="O",
     right="O", status="trimmed_far", near="5/2", near_in="5/2", word="OBIBOBO"), [("-1", "0", "0")] * 2 + [("1", "0", "0")] * 2),
    # c = 2 - (t-1)^2 (t+2) along x touches x = 2 of the second square from the left at t = 1, theta = 6; it is in the
    # first one where (t-1)^2 (t+2) >= 1, that is t^3 - 3t + 1 >= 0 up to t = 0.347..., and from 1.532..., which is nearer. A translation has g_t = n b'' = -theta, here -6.
    (PAIR, moves(2, ("1/4", "7/4", shift("t^3-3*t", "0"))), ("1", "2", "1/2"), dict(role="contact", theta="+",
     contact_order="2", orientation="preserving", left="O", right="O", status="trimmed_far", near="root(1 -3 0 1;1;2)",
     near_in="root(1 -3 0 1;1;2)", word="IBOBOBIBO"), [("0", "-6", "6")] * 2),
    # That run backwards in time, by t -> -t.
    (PAIR, moves(2, ("-7/4", "-1/4", shift("3*t-t^3", "0"))), ("-1", "2", "1/2"), dict(role="contact", theta="+",
     status="trimmed_far", near="root(-1 -3 0 1;-2;-1)", word="OBIBOBOBI"), [("0", "-6", "6")] * 2),
    # The earlier of two passes at equal distance counts: c = 1 + t^2 is at 2 at t = -1 and 1, and at 3 for t^2 = 2.
    (PAIR, moves(2, (-2, 2, shift("-t^2", "0"))), ("0", "1", "1/2"), dict(role="contact", theta="+", left="O", right="O",
     status="trimmed_far", near="-1", near_in="-1", word="OBIBOBOBIBO"), [("0", "-2", "2")] * 2),
]


def check_case(checks, graze, number, case):
    solid, motion, site, columns, facets = case
    suffix = ".off" if solid.startswith("OFF") else ".wkt"
    files = graze.write(f"{number}{suffix}", solid), graze.write(f"{number}.json", motion)
    names = ["time", "bx", "by", "bz"][:len(site)]
    contacts = graze.write(f"{number}.csv", "\n".join([",".join(names), ",".join(site)]) + "\n")
    table = graze.call("contact", *files, contacts, "--quiet")
    where = f"case {number}", site
    if not checks.equal(table.returncode, 0, *where, table.stderr):
        return
    row, = csv.DictReader(x for x in table.stdout.splitlines() if not x.startswith("#"))
    checks.holds(has_decimals(row, "near", "near_in"), *where, row)
    for name, want in columns.items():
        checks.equal(row[name], want, *where, name)
    record = json.loads(graze.call("contact", *files, contacts, "--format", "jsonl").stdout)
    if facets is not None:
        checks.equal([(f["speed"], f["drift"], f["theta"]) for f in record["facets"]], facets, *where, "facets")


def check_carried(checks, graze):
    """Other columns come last as they were, columns of the table are left out; a table is read again as it is."""
    files = graze.write("carried.wkt", SQUARE), graze.write("carried.json", RIGHT)
    text = 'note,time,role,by,bx\n"a, b",1/2,?,2,1\n x ,0,,1,0\n'
    out = graze.call("contact", *files, graze.write("carried.csv", text), "--quiet").stdout
    lines = [x for x in out.splitlines() if not x.startswith("#")]
    checks.holds(lines[0].endswith(",word,note"), lines[0])
    checks.equal([lines[1][-11:], lines[2][-7:]], [',OBO,"a, b"', ",BO, x "], "carried")
    checks.equal(out.splitlines()[-1], "# complete 2")
    checks.equal(graze.call("contact", *files, graze.write("again.csv", out), "--quiet").stdout, out, "read again")


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    for number, case in enumerate(CASES):
        check_case(checks, graze, number, case)
    check_carried(checks, graze)
    checks.finish()


if __name__ == "__main__":
    main()
