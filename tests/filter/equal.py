# suite
"""Output is byte for byte equal with the filter and without it: tables, JSON Lines and explanations.

SPDX-License-Identifier: GPL-3.0-or-later

The scenes are those of cases/ and of adversaries.py, the points those of the cases, of `graze
generate` and of queries.py. Exact arithmetic alone (`--no-filter`) is the second method; that it is
right is what the suites under tests/agree and tests/cases are for. The filtered side runs with two
threads. A scale of 50 makes 10^6 points, up to four times as many in a file, so that blocks of rows and threads are met.
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", *part.split("/"))
                for part in ("cases", "generate", "agree/lib", "lib")]

import casefile  # noqa: E402
from adversaries import scenes  # noqa: E402
from exact import Fraction as F  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from queries import written  # noqa: E402
from sides import Sides, ways  # noqa: E402

POINTS = 320
CASE_POINTS = 40
HEAVY_POINTS = 40


def check_cases(sides, args, many):
    """All points of all cases, and points generated in their scenes."""
    names = casefile.names()
    for k, name in args.cycle(names, F(1, many), "cases"):
        case = casefile.Case(name)
        solid, motion = case.path(case.solid), case.path("motion.json")
        given = [("case", p) for _, p in case.points]
        if k < len(names):
            sides.table(name, solid, motion, case.path("points.csv"), case.options, len(given))
            sides.records(name, solid, motion, case.path("points.csv"),
                          [k for k, _ in given], case.options)
            sides.kinds["case"] += len(given)
        made = sides.generated(name, solid, motion, case.options, case.dimension,
                               CASE_POINTS * many, args.seed + k)
        path = sides.graze.write("generated.csv", written(case.dimension, made))
        sides.table(name, solid, motion, path, case.options, len(made))
        sides.kinds.update(kind for kind, _ in made)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    sides = Sides(Graze(args, checks), checks, *ways(args.graze))
    many = min(4, max(1, int(args.scale)))
    check_cases(sides, args, many)
    for k, scene in args.cycle(scenes(), F(1, many), "scenes"):
        sides.scene(scene, args.random, (HEAVY_POINTS if scene.heavy else POINTS) * many, args.seed + k)
    sides.summary()
    checks.equal(sides.hard * 10 >= sides.judged * 8, True, "four of five points are hard ones")
    checks.finish()


if __name__ == "__main__":
    main()
