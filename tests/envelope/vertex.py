#!/usr/bin/env python3
# suite
"""`graze envelope` where slices pass through vertices: the reason `vertex`, and theta told at vertices alone, derived by hand.

SPDX-License-Identifier: GPL-3.0-or-later

All motions are M(t)(x, y, z) = (x + p, y + q, z + h + m l(x, y)) with l affine and p, q, h, m functions of t. With the linear part L of l, A^-1 (A'y + b')
is (p', q', G), G = h' + m' l - m L(p', q'). So g of a facet with normal n is n (p', q', G), of one that looks up or down G or -G. Where m'' = 0 and p, q are
linear, theta of one that looks up is on its slice -(G_t + m' L(w)) = m' L(p', q') - G_t.

A tower over [-1,2]^2, z from 1 to 3, stands on a block with top [0,4]^2 at z = 1, and hangs over; v = (2, 2, 1) is where the top F is notched by the tower,
vertex 8. C at v is z < 1 and the quadrant x, y < 2. F has its edges at v in common with the tower's walls x = 2, y = 2, with normals (1, 0, 0), (0, 1, 0). With p = q = t
these have g = 1, what looks the other way -1, and the bottom of the block, (x + y)/2 - 4 with n = (1, 1, -2), has 2 - 2G > 0 where G < 1.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contact"))

from hand import moves, off, prism_of  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from reading import summary  # noqa: E402

ENTERS = "a slice or run reaches a vertex and enters the solid there, "
THETA = "theta is negative on a slice, "
TOP = [9, 4, 5, 6, 7, 8]


def tower(tops):
    vertices = [(0, 0, -4), (4, 0, -2), (4, 4, 0), (0, 4, -2)]
    vertices += [(4, 0, 1), (4, 4, 1), (0, 4, 1), (0, 2, 1), (2, 2, 1), (2, 0, 1), (0, 0, 1)]
    vertices += [(x, y, z) for z in (1, 3) for x, y in ((-1, -1), (2, -1), (2, 2), (-1, 2)) if (x, y, z) != (2, 2, 1)]
    # 11 (-1,-1,1), 12 (2,-1,1), 13 (-1,2,1); above 14 (-1,-1), 15 (2,-1), 16 (2,2), 17 (-1,2)
    return off(vertices, [[3, 2, 1, 0], [0, 1, 4, 9, 10], [3, 0, 10, 7, 6], [1, 2, 5, 4], [2, 3, 6, 5], [11, 13, 7, 10, 9, 12],
                          [12, 9, 8, 16, 15], [8, 7, 13, 17, 16], [11, 12, 15, 14], [13, 11, 14, 17], [14, 15, 16, 17]] + tops)


def sheared(p, q, last_row):
    return {"matrix": [["1", "0", "0", p], ["0", "1", "0", q], list(last_row)]}


def cube(top):
    corners = [(x, y, z) for z in (0, 2) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
    return off(corners, [[3, 2, 1, 0], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]] + top)


# m = t/10, l = x + y - 4, h = t^2/10: G = l/10, theta = 1/5. The slice of F goes from (0, 4) to (4, 0), through v, all the time; that of the tower's top is its
# corner. G < 0 on the tower's bottom, so what hangs over looks out with g > 0, and no run ends where it leaves the block. w = -(1, 1, 0) at v leads into the tower.
CORNERWISE = moves(3, (0, 1, sheared("t", "t", ["t/10", "t/10", "1", "t^2/10-2*t/5"])))
# m = t/20, l = 3x + 5y - 16, h = t^2/5: the same along another line, from (0, 16/5) to (4, 4/5); G = l/20 < 1.
ASKEW = moves(3, (0, 1, sheared("t", "t", ["3*t/20", "t/4", "1", "t^2/5-4*t/5"])))
# With h = (t^2 - t^3)/10 it is G = (l - 3 t^2)/10 and theta = 1/5 + 3t/5 > 0 for t > -1/3. The slice of F, x + y = 4 + 3 t^2, leaves out the notch, where x + y < 4,
# and its edges, but touches v at t = 0.
TOUCH = sheared("t", "t", ["t/10", "t/10", "1", "t^2/10-t^3/10-2*t/5"])
TOUCHES = moves(3, ("-1/4", "1/4", TOUCH))
CUT = moves(3, ("-1/4", 0, TOUCH), (0, "1/4", TOUCH))
# For a cube, p = 0, q = t, m = t, l = x - y, h = -t^2/2: G = l, and theta of the top is -1; its slice is the diagonal from (0, 0) to (2, 2) all the time and ends on
# no edge. theta of the bottom is 1.
DIAGONAL = moves(3, (0, 1, sheared("0", "t", ["t", "-t", "1", "-t^2/2"])))
# The cube on the other diagonal: q = -t, l = x + y - 2.
OTHER = moves(3, (0, 1, sheared("0", "-t", ["t", "t", "1", "-t^2/2-2*t"])))
# The cube on the middle line: p = -t, l = x - 1. There tetrahedra touch the cube's edges with their tips at (1, 0, 2), (1, 2, 2), so the slice ends on no edge
# again. The tetrahedra's faces that look up have n = (+-3, ., 1) and g = -+3 + x - 1 of one sign, as x is from 1/2 to 3/2.
MIDDLE = moves(3, (0, 1, sheared("-t", "0", ["t", "0", "1", "-t^2/2-t"])))


def with_tips():
    vertices = [(x, y, z) for z in (0, 2) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
    faces = [[3, 2, 1, 0], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]]
    for tip, y in ((0, -1), (2, 3)):
        k = len(vertices)
        vertices += [(1, tip, 2), ("1/2", y, "3/2"), ("3/2", y, "3/2"), (1, y, 3)]
        tetrahedron = [[k, k + 1, k + 2], [k, k + 2, k + 3], [k, k + 3, k + 1], [k + 1, k + 3, k + 2]]
        faces += tetrahedron if y > 0 else [f[::-1] for f in tetrahedron]
    return off(vertices, faces)


CASES = [
    (tower([TOP]), CORNERWISE, "no", ENTERS + "vertex 8"),
    (tower([TOP]), ASKEW, "no", ENTERS + "vertex 8"),
    # The top cut along the slice: it goes along flat edges.
    (tower([[8, 9, 4], [8, 4, 5, 6], [8, 6, 7]]), CORNERWISE, "no", ENTERS + "vertex 8"),
    (tower([TOP]), TOUCHES, "no", ENTERS + "vertex 8, time 0"),
    (tower([TOP]), CUT, "no", ENTERS + "vertex 8, time 0"),
    # The top cut along the line that the slice is at t = 0.
    (tower([[8, 9, 4], [8, 4, 5, 6], [8, 6, 7]]), TOUCHES, "no", ENTERS + "vertex 8, time 0"),
    # Past t = 0 no slice is at v, and no run comes to a vertex that is not convex: the convex edges at these have g > 0 of both facets, or g < 0.
    (tower([TOP]), moves(3, ("1/8", "1/4", TOUCH)), "yes", None),
    (cube([[4, 5, 6, 7]]), DIAGONAL, "no", THETA + "face 5 at vertex "),
    (cube([[4, 5, 6, 7]]), OTHER, "no", THETA + "face 5 at vertex "),
    (cube([[4, 5, 6], [4, 6, 7]]), DIAGONAL, "no", THETA + "face 5 at vertex "),
    (cube([[4, 5, 7], [5, 6, 7]]), OTHER, "no", THETA + "face 5 at vertex "),
    (with_tips(), MIDDLE, "no", THETA + "face 5 at vertex "),
]


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    for number, (solid, motion, answer, reason) in enumerate(CASES):
        files = graze.write(f"{number}.off", solid), graze.write(f"{number}.json", motion)
        done = graze.call("envelope", *files)
        if checks.equal(done.returncode, 0, number, done.stderr):
            said = summary(done.stdout)
            checks.equal(said["decomposable"], answer, "case", number, said)
            checks.holds(reason is None or said["why"].startswith(reason), "case", number, said, reason)
    checks.finish()


if __name__ == "__main__":
    main()
