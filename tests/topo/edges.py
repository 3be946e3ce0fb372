#!/usr/bin/env python3
# suite
"""A vertex that is left along an edge: the second stage of first order, in space.

SPDX-License-Identifier: GPL-3.0-or-later

c runs from the corner (0, 0, 0) of the cube [0, 2]^3 as (t, k t^2, -t^2), outside for t > 0. Later it touches the side
y = 0, which covers u_y > 0, and last the side of a prism with the normal (0, 1, 1), which covers u_y + u_z < 0. At the
corner c + eps u is inside at t = sqrt(eps s) for small eps iff u_y + k s > 0 and u_z - s > 0, whatever u_x is: the side
covers u_z > 0 where u_y + k u_z > 0, and to first order only u_y > 0, u_z > 0. What is left open is u_y <= 0,
u_y + u_z >= 0, u_y + k u_z <= 0: an open wedge if k < 1, and nothing but planes that the contacts lie on, which are in the
closed sweep, if k >= 1. So P = 0 is `boundary` for k < 1, else `interior` (which may stay undecided).
"""
import json
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import Fraction as F  # noqa: E402
from program import Checks, Graze, options  # noqa: E402

CUBE = [(x, y, z) for z in (0, 2) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
PRISM = [(x, y, z) for x in (10, 12) for y, z in ((0, 0), (2, 0), (0, 2))]
FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7),
         (8, 10, 9), (11, 12, 13), (8, 9, 12, 11), (9, 10, 13, 12), (10, 8, 11, 13)]
WAY = [(F(1, 2), -1, -1), (1, -1, 1), (1, 0, 1), (1, -1, 1), (1, -1, 4), (11, 4, 4), (11, 1, 1)]


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def solid():
    lines = ["OFF", f"{len(CUBE + PRISM)} {len(FACES)} 0"]
    lines += [" ".join(map(str, v)) for v in CUBE + PRISM] + [" ".join(map(str, (len(f), *f))) for f in FACES]
    return "\n".join(lines) + "\n"


def motion(k):
    pieces = [{"t": ["0", "1/2"], "transform": {"translate": ["-t", f"-{k}*t^2", "t^2"]}}]
    ends = [(F(1, 2), k / 4, F(-1, 4)), *WAY]
    for n, (a, b) in enumerate(zip(ends, ends[1:])):
        start = F(1, 2) + n
        pieces.append({"t": [str(start), str(start + 1)], "transform": {"translate": [
            f"{F(-p)} + ({F(p) - F(q)})*(t - {start})" for p, q in zip(a, b)]}})
    return json.dumps({"dimension": 3, "pieces": pieces})


def main():
    args, checks = options(__doc__.splitlines()[0]), Checks()
    graze, origin = Graze(args, checks), [F(0)] * 3
    with tempfile.TemporaryDirectory() as folder:
        body, path = os.path.join(folder, "solid.off"), os.path.join(folder, "motion.json")
        write(body, solid())
        for k in (F(1, 2), F(999, 1000), F(1) - F(1, 2 ** 60), F(1), F(1001, 1000), F(2)):
            write(path, motion(k))
            (answer,) = graze.classify(f"k = {k}", body, path, [origin], "--topo")
            row = answer.record
            checks.equal(row["pmc"], "on", f"k = {k}")
            checks.holds(row["topo"] == "boundary" if k < 1 else row["topo"] != "boundary", f"k = {k}: {row['topo']}")
            if k < 1 and row["topo"] == "boundary":
                u = [F(x) for x in row["topo_witness"]]
                checks.holds(u[1] + u[2] > 0 > u[1] + k * u[2], f"k = {k}: the witness is in the wedge: {u}")
                (found,) = graze.classify(f"k = {k}", body, path, [u])
                checks.equal(found.record["pmc"], "out", f"k = {k}: the witness")
    checks.finish()


if __name__ == "__main__":
    main()
