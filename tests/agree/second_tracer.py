# suite
"""The program against the second tracer of lib/tracer.py, point by point, in plane and space.

SPDX-License-Identifier: GPL-3.0-or-later

Words, kinds, states on both sides, exact times and boundary cells must agree; every time must be in
canonical form; at least 30 % of the times must be irrational, or the scenes prove too little.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from agreement import Tally, compare  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from points import mixed  # noqa: E402
from scenes import scenes  # noqa: E402
from tracer import trace  # noqa: E402

PLANE_POINTS, SPACE_POINTS = 30, 9


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Tally()
    graze = Graze(args, checks)
    for name, solid, motion in scenes(args):
        count = PLANE_POINTS if motion.dimension == 2 else SPACE_POINTS
        points = mixed(solid, motion, args.random, count)
        answers = graze.classify(name, solid, motion, [p for _, p in points])
        for (kind, p), answer in zip(points, answers or []):
            where = (name, kind, ",".join(str(x) for x in p))
            word, contacts = trace(solid, motion, p)
            compare(checks, tally, answer, word, contacts, *where)
            tally.add(answer)
    tally.report(checks)
    checks.finish()


if __name__ == "__main__":
    main()
