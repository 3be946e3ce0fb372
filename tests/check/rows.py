"""Rows made by hand that only one test of graze-check refutes, each beside one that is right.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

The squares have their sides on the axes; c is the position of the row's point in the solid, at the time t.
"""
import json
import os
import tempfile

from lib_certificate import Certificate, Programs, REFUTED, Row, VERIFIED, sha256, write
from meshes import CUBE, SQUARE, off
from harness import ONLY, Checks, options

TEETH = "POLYGON ((1 0, 6 0, 6 1, 4 1, 4 1/2, 3 1/2, 3 1, 1 1, 1 0))"
APART = "POLYGON ((3/4 -1/4, 5/4 -1/4, 5/4 1/4, 3/4 1/4, 3/4 -1/4))"
# Turns that take (1, 0) around the origin; the weight 16 t^2 - 16 t + 5 has the coefficients 5, -3, 5.
TURN = ("(-16*t^2 + 16*t - 3)/(16*t^2 - 16*t + 5)", "(8*t - 4)/(16*t^2 - 16*t + 5)", "(4 - 8*t)/(16*t^2 - 16*t + 5)")
AROUND = '{"matrix": [["%s", "%s", "0"], ["%s", "%s", "0"]]}' % (TURN[0], TURN[2], TURN[1], TURN[0])
TWICE = "3*t - 11*t^2 + 16*t^3 - 8*t^4"
SLIDE = ["O 1/2", "OBB 3/2 -1 1", "B 2"], ["B 11/2", "BBO 13/2 -6 1", "O 7"]
GAP = ["B 5/2", "BBO 13/4 -3 1", "O 15/4", "OBB 9/2 -4 1"]
QUARTERS = ["O 1/4", "O 1/2", "O 3/4", "O 1"]


def along(x, y="0"):
    """c = (x0 - x, y0 - y) for the point (x0, y0)."""
    return '{"translate": ["%s", "%s"]}' % (x, y)


# Name, solid, motion on [0, end], end, signs, point, word, intervals, whether it is right.
ROWS = [
    ("a slide, a gap, a slide", TEETH, along("-t"), 7, "0 7", "0 1", "OBOBO", [*SLIDE[0], *GAP, *SLIDE[1]], True),
    ("a slide that goes on over a gap", TEETH, along("-t"), 7, "0 7", "0 1", "OBO", [*SLIDE[0], "BBB 5 -7 2", *SLIDE[1]], False),
    ("a slide that leaves its side", TEETH, along("-t"), 7, "0 7", "0 1", "OBO", [*SLIDE[0][:2], "B 11/2", *SLIDE[1][1:]], False),
    ("a point apart", APART, AROUND, 1, "0 1/4 1/2 3/4 1", "-9 0", "O", QUARTERS, True),
    ("control points apart, over a weight of both signs", APART, AROUND, 1, "0 1/4 1/2 3/4 1", "1 0", "O", ["O 1"], False),
    # c_x = 1 - t + 2 t^2: on the right side at 0 and at 1/2, inside between.
    ("a root in the middle", SQUARE, along("t - 2*t^2"), 1, "0 1", "1 1/2", "BIBO", ["BI 1/4", "IBO 1 -1 2"], True),
    ("a root at the beginning, too", SQUARE, along("t - 2*t^2"), 1, "0 1", "1 1/2", "BO", ["BBO 1 0 -1 2"], False),
    # c_x = 1 + t (2 t - 1)^2: on the right side at 0, touches it at 1/2.
    ("a touch after the beginning", SQUARE, along("4*t^2 - t - 4*t^3"), 1, "0 1", "1 1/2", "BOBO", ["BO 1/4", "OBO 3/4 -1 2", "O 1"], True),
    ("a touch after the beginning, left out", SQUARE, along("4*t^2 - t - 4*t^3"), 1, "0 1", "1 1/2", "BO", ["BO 1"], False),
    # c_x = 2 - 3 t + 2 t^2: on it at 1/2 and at 1, inside between.
    ("a root in the middle", SQUARE, along("3*t - 2*t^2"), 1, "0 1", "2 1/2", "OBIB", ["OBI 3/4 -1 2", "IB 1"], True),
    ("a root at the end, too", SQUARE, along("3*t - 2*t^2"), 1, "0 1", "2 1/2", "OB", ["OBB 1 1 -3 2"], False),
    # c_x = 1 + (4 t - 1)^2 (4 t - 3)^2/32 touches it twice.
    ("two touches", SQUARE, along(TWICE), 1, "0 1", "41/32 1/2", "OBOBO", ["O 1/8", "OBO 3/8 -1 4", "O 5/8", "OBO 7/8 -3 4", "O 1"], True),
    ("two touches as one", SQUARE, along(TWICE), 1, "0 1", "41/32 1/2", "OBO", ["OBO 1 3 -16 16"], False),
    # c_x = 1 + (2 t - 1)^2 touches the right side's line; c_y = 1/2, or 2/3 + t, which is past its end by then.
    ("a touch", SQUARE, along("4*t - 4*t^2"), 1, "0 1", "2 1/2", "OBO", ["O 1/4", "OBO 3/4 -1 2", "O 1"], True),
    ("a touch of its line", SQUARE, along("4*t - 4*t^2", "1/3 - t"), 1, "0 1", "2 1", "OBO", ["O 1/4", "OBO 3/4 -1 2", "O 1"], False),
    # c_y = 1 + (40 t^2 - 40 t + 11)/40 > 1, with a control point below 1.
    ("a near miss", SQUARE, along("0", "t - t^2"), 1, "0 1", "1/2 51/40", "O", ["O 1/2", "O 1"], True),
    ("a near miss as a touch", SQUARE, along("0", "t - t^2"), 1, "0 1", "1/2 51/40", "OBO", ["OBO 1 11 -40 40"], False),
    ("two letters for one", TEETH, along("-t"), 7, "0 7", "0 1", "OBOBO", [*SLIDE[0][:2], "BB 2", *GAP, *SLIDE[1]], False),
    ("three letters for one", SQUARE, along("0"), 1, "0 1", "1/2 1/2", "I", ["III 1 -1 2"], False),
    # c_y = 1 + (2 t - 1)^2; c_x = t + 1/3 is on the upper side at 1/2, c_x = t + 2/3 past its end, from 1/3 on.
    ("a touch beside a corner", SQUARE, along("-t", "4*t - 4*t^2"), 1, "0 1", "1/3 2", "OBO", ["O 1/4", "OBO 5/8 -1 2", "O 1"], True),
    ("a touch past a corner", SQUARE, along("-t", "4*t - 4*t^2"), 1, "0 1", "2/3 2", "OBO", ["O 1/4", "OBO 5/8 -1 2", "O 1"], False),
    ("a coefficient that is no integer", SQUARE, along("4*t - 4*t^2"), 1, "0 1", "2 1/2", "OBO", ["O 1/4", "OBO 3/4 -1 2/3", "O 1"], False),
    ("a coefficient without digits", SQUARE, along("4*t - 4*t^2"), 1, "0 1", "2 1/2", "OBO", ["O 1/4", "OBO 3/4 -1 2 -", "O 1"], False),
    # The times of signs go back, or leave the motion and come back.
    ("a time more", SQUARE, along("t"), 1, "0 1/2 1", "9 9", "O", ["O 1"], True),
    ("a time twice", SQUARE, along("t"), 1, "0 1/2 1/2 1", "9 9", "O", ["O 1"], False),
    ("times of two pieces", SQUARE, along("t"), 2, "0 1 2", "9 9", "O", ["O 1", "O 2"], True),
    ("an interval across two pieces", SQUARE, along("t"), 2, "0 2", "9 9", "O", ["O 1", "O 2"], False),
    ("times that go back", SQUARE, along("t"), 1, "0 3/4 1/2 1", "9 9", "O", ["O 1"], False),
    ("times past the end", SQUARE, along("t"), 1, "0 1 2 1", "9 9", "O", ["O 1"], False),
]
# c = (1/2 + (2 t - 1)^2/2, 1 + (2 t - 1)^2) touches the square at 1/2, and is right of the other part but then, below it then.
BESIDE = ["MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((1/4 1.1, 1/2 1.1, 1/2 2, 1/4 2, 1/4 1.1)))",
          along("2*t - 2*t^2", "4*t - 4*t^2"), 1, "0 1", "1 2", "OBO"]
ROWS.append(("a touch beside another part, in long", *BESIDE, ["O 1/4", "OBO 3/4 -1 2", "O 1"], True))
# Rows with contacts. Vertices have the numbers of the rings: the square's sides are 0-1, 1-2, 2-3 and 0-3.
TOUCH = [SQUARE, along("-t", "4*t - 4*t^2"), 1, "0 1", "1/3 2", "OBO"]
ENTRY = [SQUARE, along("t^2"), "3/2", "0 3/2", "3 1/2", "OBI"]  # c_x = 3 - t^2
LONG = [TEETH, along("-t"), 7, "0 7", "0 1", "OBOBO"]
WHOLE = [TEETH, along("-t"), 2, "0 2", "1 1", "B"]
BACK = [TEETH, along("t^2 - 2*t"), 2, "0 2", "2 1", "B"]  # c_x = 3 - (t - 1)^2
# c = (1/2, y, 2 - t) comes down into the cube of squares, through the middle of its top, whose pieces meet there, or along its front.
DOWN = [off(CUBE), '{"translate": ["0", "0", "t"]}', "3/2", "0 3/2"]
TOP, FRONT = [*DOWN, "1/2 1/2 2", "OBI", "O 3/4", "OBI 3/2 -1 1"], [*DOWN, "1/2 0 2", "OB", "O 3/4", "OBB 5/4 -1 1", "B 3/2"]
RUN = "POLYGON ((0 0, 1 0, 1 0, 1 0, 1 1, 0 1, 0 0))"
CONTACTS = [
    ("a touch", *TOUCH, ["O 1/4", "OBO 5/8 -1 2", "contact 1/2 edge 2-3", "O 1"], True),
    ("a touch, a facet unknown", *TOUCH, ["O 1/4", "OBO 3/4 -1 2", "contact 1/2 edge 2-3", "O 1"], False),
    ("a touch beside another part", *BESIDE, ["O 3/8", "OBO 5/8 -1 2", "contact 1/2 edge 2-3", "O 1"], True),
    ("a touch beside another part, unknown", *BESIDE, ["O 1/4", "OBO 3/4 -1 2", "contact 1/2 edge 2-3", "O 1"], False),
    ("a touch too late", *TOUCH, ["O 1/4", "OBO 5/8 -1 2", "O 1", "contact 1/2 edge 2-3"], False),
    ("a touch too early", *TOUCH, ["O 1/4", "contact 1/2 edge 2-3", "OBO 5/8 -1 2", "O 1"], False),
    ("a touch not said", *TOUCH, ["O 1/4", "OBO 5/8 -1 2", "O 1"], False),
    ("a word more", *TOUCH, ["O 1/4", "OBO 5/8 -1 2", "contact 1/2 edge 2-3 vertex", "O 1"], False),
    ("a longer word", *TOUCH, ["O 1/4", "OBO 5/8 -1 2", "contact 1/2 edge 2-33", "O 1"], False),
    ("a root", *ENTRY, ["O 5/4", "OBI 3/2 -2 0 1", "contact root 5/4 3/2 -2 0 1 edge 1-2"], True),
    ("a root of a multiple", *ENTRY, ["O 5/4", "OBI 3/2 4 0 -2", "contact root 5/4 3/2 2 0 -1 edge 1-2"], True),
    ("a root with another multiple", *ENTRY, ["O 5/4", "OBI 3/2 -2 0 1", "contact root 5/4 3/2 -4 0 2 edge 1-2"], False),
    ("a root in a longer interval", *ENTRY, ["O 5/4", "OBI 3/2 -2 0 1", "contact root 1 3/2 -2 0 1 edge 1-2"], False),
    ("a root with a line's time", *ENTRY, ["O 5/4", "OBI 3/2 -2 0 1", "contact 3/2 edge 1-2"], False),
    ("slides", *LONG, [*SLIDE[0], *GAP[:2], "contact 1 to 3 edge 6-7 vertex 6 vertex 7", *GAP[2:], *SLIDE[1][:2],
                       "contact 4 to 6 edge 2-3 vertex 2 vertex 3", *SLIDE[1][2:]], True),
    ("slides without a vertex", *LONG, [*SLIDE[0], *GAP[:2], "contact 1 to 3 edge 6-7 vertex 6 vertex 7", *GAP[2:], *SLIDE[1][:2],
                                        "contact 4 to 6 edge 2-3 vertex 2", *SLIDE[1][2:]], False),
    ("a slide as a touch", *LONG, [*SLIDE[0], *GAP[:2], "contact 1 edge 6-7 vertex 6 vertex 7", *GAP[2:], *SLIDE[1][:2],
                                   "contact 4 to 6 edge 2-3 vertex 2 vertex 3", *SLIDE[1][2:]], False),
    ("a slide from end to end", *WHOLE, ["B 2", "contact 0 to 2 edge 6-7 vertex 6 vertex 7"], True),
    ("the same in two", *WHOLE, ["B 1", "B 2", "contact 0 to 2 edge 6-7 vertex 6 vertex 7"], True),
    ("without its beginning", *WHOLE, ["B 2", "contact 0 to 2 edge 6-7 vertex 6"], False),
    ("without its end", *WHOLE, ["B 2", "contact 0 to 2 edge 6-7 vertex 7"], False),
    ("a slide and back", *BACK, ["B 1", "B 2", "contact 0 to 2 edge 6-7 vertex 6"], True),
    ("a slide and back, not to the corner", *BACK, ["B 1", "B 2", "contact 0 to 2 edge 6-7"], False),
    ("a diagonal of a facet", *TOP[:6], [*TOP[6:], "contact 1 face 1"], True),
    ("a diagonal as an edge", *TOP[:6], [*TOP[6:], "contact 1 edge 4-6"], False),
    ("an edge, then a facet across its diagonal", *FRONT[:6], [*FRONT[6:], "contact 1 to 3/2 face 2 edge 4-5"], True),
    ("the edge that closes a facet", *DOWN, "0 1/2 2", "OB", ["O 3/4", "OBB 5/4 -1 1", "B 3/2", "contact 1 to 3/2 face 5 edge 4-7"], True),
    ("the diagonal as an edge", *FRONT[:6], [*FRONT[6:], "contact 1 to 3/2 face 2 edge 0-5 edge 4-5"], False),
    ("a run of vertices", RUN, along("-t"), 1, "0 1", "1 0", "BO", ["BO 1", "contact 0 vertex 1 vertex 2 vertex 3"], True),
    ("a run of vertices, but one", RUN, along("-t"), 1, "0 1", "1 0", "BO", ["BO 1", "contact 0 vertex 1 vertex 3"], False),
    ("an end", SQUARE, along("-t"), 1, "0 1", "-1 1/2", "OB", ["OB 1", "contact 1 edge 0-3"], True),
    ("no contact", SQUARE, along("-t"), 1, "0 1", "-9 1/2", "O", ["O 1"], True),
    ("a contact invented", SQUARE, along("-t"), 1, "0 1", "-9 1/2", "O", ["O 1", "contact 1 edge 0-3"], False),
]
IN_PIECES = {"times of two pieces", "an interval across two pieces"}  # [0, 1], [1, 2], ...; others have one


def certificate(solid, motion, signs, point, word, intervals, contacts):
    d = len(point.split())
    row = Row([*point.split(), word], d)
    row.claim(word, False, False)
    row.intervals = [interval.split() for interval in intervals]
    out = Certificate("complete 1\n")
    out.head = [["graze-certificate", "1"], ["solid-sha256", sha256(solid)], ["motion-sha256", sha256(motion)],
                ["scene-sha256", "0" * 64], ["dimension", str(d)], ["operation", "sweep"], ["folds", "separate"],
                *([["contacts", "yes"]] if contacts else []), ["signs", *signs.split()]]
    out.rows = [row]
    return out.text()


def main():
    chosen = options(__doc__, ONLY)
    programs, tally = Programs(chosen.graze), Checks()
    with tempfile.TemporaryDirectory() as folder:
        for k, (what, polygon, transform, end, signs, point, word, intervals, right) in enumerate([*ROWS, *CONTACTS]):
            d = len(point.split())
            solid = write(os.path.join(folder, "solid.wkt" if d == 2 else "solid.off"), polygon)
            starts = range(end) if what in IN_PIECES else [0]
            pieces = [{"t": [str(lo), str(hi)], "transform": json.loads(transform)} for lo, hi in zip(starts, [*starts[1:], end])]
            motion = write(os.path.join(folder, "motion.json"), json.dumps({"dimension": d, "pieces": pieces}))
            path = write(os.path.join(folder, "certificate"), certificate(solid, motion, signs, point, word, intervals, k >= len(ROWS)))
            status, _, error = programs.check(solid, motion, path)
            tally.equal(status, VERIFIED if right else REFUTED, what, error)
    tally.finish()


if __name__ == "__main__":
    main()
