#!/usr/bin/env python3
# suite
"""Two tips that pass the origin with one tangent and one curvature, on ways of a high degree: the plane is decided.

SPDX-License-Identifier: GPL-3.0-or-later

The tip of a part below moves by (t + t^n / 3, -t^2 + a t^n), perhaps turning, and draws y = -x^2 + a x^n up to higher terms;
what is below is covered. The tip of a part above moves by (s, -s^2) and covers what is above y = -x^2. With n >= 4 the
origin is interior if a x^n >= 0 on both sides, that is for a > 0 and n even; else it is on the boundary, and places
between the two curves are out as near as one likes.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import Fraction as F  # noqa: E402
from prisms import Text  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from solids import Polygon, ring  # noqa: E402

TINY = F(1, 2 ** 100)
# n, a, and whether the part below turns; pullbacks of a turn have the degree n + 6, else n.
WAYS = [(4, F(1, 5), True), (5, F(1, 5), True), (6, -TINY, True), (7, F(1, 5), True), (8, TINY, True),
        (9, F(1, 5), False), (12, TINY, False), (12, -TINY, False), (15, F(1, 5), False), (20, F(1, 5), False)]
LONGER = [(10, F(1, 5), True), (11, -F(1, 5), True), (14, F(1, 5), True)]
SCALES = (8, 30, 60)


def motion(n, a, turns):
    way = {"translate": [f"t+t^{n}/3", f"-t^2+({a})*t^{n}"]}
    if turns:
        way = {"compose": [{"rotate": {"tan_half": "(1-t^2)*t/7"}}, way]}
    end = F(4, 3), -1 + a
    return Text({"dimension": 2, "pieces": [
        {"t": [-1, 1], "transform": way},
        {"t": [1, 2], "transform": {"translate": [f"({end[0]})*(2-t)-(t-1)", f"({end[1]})*(2-t)-7*(t-1)"]}},
        {"t": [2, 4], "transform": {"translate": ["t-3", "-6-(t-3)^2"]}}]})


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    tips = Polygon([[ring((0, 0), (-1, -2), (1, -2))], [ring((0, 6), (1, 8), (-1, 8))]])
    for n, a, turns in args.once(WAYS, "ways", LONGER):
        name = f"tips {n} {a} {turns}"
        answers = graze.classify(name, tips, motion(n, a, turns), [(F(0), F(0))], "--topo")
        if not answers:
            continue
        record, want = answers[0].record, "interior" if n % 2 == 0 and a > 0 else "boundary"
        checks.equal((record["pmc"], record["topo"], record.get("topo_level")), ("on", want, "curves"), name,
                     record.get("topo_reason"))
        places = [(k, (s * F(1, 2 ** k), -F(1, 4 ** k) + a * (s * F(1, 2 ** k)) ** n / 2)) for k in SCALES for s in (1, -1)]
        found = graze.classify(name + " near", tips, motion(n, a, turns), [p for _, p in places]) or []
        out = {k for (k, _), answer in zip(places, found) if answer.record["pmc"] == "out"}
        checks.equal(out, set(SCALES) if want == "boundary" else set(), name, "the scales of the probes that are out")
    checks.finish()


if __name__ == "__main__":
    main()
