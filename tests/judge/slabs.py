# suite
"""Volumes of curved sweeps with closed forms, enclosed within four hundredths; missing and excess volumes of meshes beside them.

SPDX-License-Identifier: GPL-3.0-or-later

A box [a, b] x [0, d] x [0, h] with a > 0 is turned by a quarter about the z axis. A circle about the axis meets it in one arc, if
its radius is between a and |(b, d)|, so the turn adds to the arc a quarter: the sweep's volume is h (b - a) d + h pi/4 (b^2 + d^2 - a^2).
A block moved by (x, y, z) has the volume of the block and |x|, |y|, |z| times the areas of its facets. Where the mesh is in the sweep,
the missing volume is the difference of both volumes.
"""
import math

from judged import Checks, Judge, block, options
from exact import Fraction as F, to_double

from motion import legs  # noqa: E402
from solids import prism  # noqa: E402

SHARE = 0.04  # of the volume
SHARE_OF_ANY = 0.12  # of boxes of any shape
WITHIN = ("--within", "3e-2r")
QUARTER = '{"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"rotate": {"axis": [0, 0, 1], "tan_half": "t"}}}]}'


class Text:
    def __init__(self, text):
        self.words = text

    def text(self):
        return self.words


def volume_of_turn(a, b, d, h):
    return to_double(h * (b - a) * d) + to_double(h * (b * b + d * d - a * a)) * math.pi / 4


def near(radius, angle):
    """A place of the plane to 2^-30."""
    return tuple(F(round(radius * f(angle) * 2 ** 30), 2 ** 30) for f in (math.cos, math.sin))


def outline(n, dent):
    """The box [1, 2] x [0, 1] turned by a quarter: n chords of the outer circle, n tangents of the inner one; `dent` is how far
    a corner of the chords is drawn in. All of it is in the sweep."""
    step, first, out = math.pi / 2 / n, math.atan2(1, 2), 1 - 2.0 ** -20
    outer = [near(math.sqrt(5) * out - (dent if k == n // 2 else 0), first + k * step) for k in range(1, n)]
    inner = [near(1 / math.cos(step / 2) / out, (k + 0.5) * step) for k in reversed(range(n))]
    return [(F(1), F(0)), (F(2), F(0)), (F(2), F(1)), *outer, (F(-1), F(2)), (F(-1), F(1)), (F(0), F(1)), *inner]


def area(points):
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(points, points[1:] + points[:1])) / 2


def narrow(checks, name, report, volume, share=SHARE):
    v = report["volume"]["sweep"]
    checks.holds(v["high"] - v["low"] <= share * volume, name, "width", v)


def difference(checks, name, report, volume):
    """Missing less excess is the difference of the volumes of sweep and mesh."""
    missing, excess = report["volume"]["missing"], report["volume"]["excess"]
    true = volume - to_double(F(report["volume"]["mesh"]))
    checks.holds(missing["low"] - excess["high"] <= true <= missing["high"] - excess["low"], name, "difference", true, missing, excess)


def turned(judge, checks, dents):
    volume = volume_of_turn(F(1), F(2), F(1), F(1))
    for dent in dents:
        points, name = outline(8, dent), f"turned, 8 chords, dent {dent}"
        report = judge.ask(name, block(1, 0, 0, 2, 1, 1), Text(QUARTER), prism(points, 0, 1), *WITHIN)
        if not report:
            continue
        judge.holds(name, report, (None, None, None), volume)
        narrow(checks, name, report, volume)
        judge.differs(name, report, volume - to_double(area(points)), 0)
        if dent:
            far = report["distance"]["sweep_to_mesh"]
            checks.holds(report["volume"]["missing"]["low"] > 0.001 and far["low"] > 0.1, name, "is seen", far)


def random_turns(judge, checks, args):
    rng = args.random
    for k in args.rounds(1 if args.sanitizers else 2, "turns"):
        a, b, d, h = (F(rng.randint(4, 16), 8) for _ in range(4))
        b += a
        low = [F(rng.randint(-16, 8), 8) for _ in range(3)]
        mesh = block(*low, *(x + F(rng.randint(4, 24), 8) for x in low))
        name, volume = f"turn {k}", volume_of_turn(a, b, d, h)
        report = judge.ask(name, block(a, 0, 0, b, d, h), Text(QUARTER), mesh, *WITHIN)
        if report:
            judge.holds(name, report, (None, None, None), volume)
            narrow(checks, name, report, volume, SHARE_OF_ANY)
            difference(checks, name, report, volume)


def random_legs(judge, checks, args):
    """The mesh is another block, so that no facet of it is the sweep's."""
    rng = args.random
    for k in args.rounds(1 if args.sanitizers else 2, "legs"):
        size, by = ([F(rng.randint(2, 16), 8) for _ in range(3)] for _ in range(2))
        volume = size[0] * size[1] * size[2] + by[0] * size[1] * size[2] + size[0] * by[1] * size[2] + size[0] * size[1] * by[2]
        mesh = block(*(F(-1, 7),) * 3, *(x + y / 3 for x, y in zip(size, by)))
        name = f"leg {k}"
        report = judge.ask(name, block(0, 0, 0, *size), legs([(0, 0, 0), by]), mesh, *WITHIN)
        if report:
            judge.holds(name, report, (None, None, None), volume)
            narrow(checks, name, report, to_double(volume))
            difference(checks, name, report, to_double(volume))


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    judge = Judge(args, checks)
    if args.derived:
        turned(judge, checks, [0.25])
    if args.to_the_end:
        turned(judge, checks, [0])
    random_turns(judge, checks, args)
    random_legs(judge, checks, args)
    checks.finish()


if __name__ == "__main__":
    main()
