#!/usr/bin/env python3
# suite
"""Times of `cusp` by the Jacobian of the envelope's own parametrisation, which PARI's gp takes symbolically.

SPDX-License-Identifier: GPL-3.0-or-later

In the plane the slice of an edge is one point y(t), and M(t) y(t) is the envelope: it has a cusp where its derivative
along the edge vanishes. In space a slice that ends on two edges is y_1 + s (y_2 - y_1), and M(t) of it a surface; where
its Jacobian vanishes at s = 0, theta is 0 there. gp finds the real roots with the slice within the edge, and their number
and places must be those of the table.
"""
import json
import os
import re
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contact"))

import oracle  # noqa: E402,F401  (it finds the library of tests/agree)
from exact import Fraction as F, to_double  # noqa: E402
from harness import bounded, run  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from reading import When, table  # noqa: E402

GP = """
roots(p) = if(poldegree(p) < 1, [], polrootsreal(p, [0, 1]));
tell(name, A, b, n, u, v, other) = {
  my(g(y) = n * A^-1 * (deriv(A, t) * y + deriv(b, t)), y = u + g(u) / (g(u) - g(v)) * (v - u), X = A * y + b, J, out = List());
  if(#u == 2,
    J = (A^-1 * deriv(X, t))~ * (v - u),
    my(z = other[1] + g(other[1]) / (g(other[1]) - g(other[2])) * (other[2] - other[1]), along = z - y,
       a = A^-1 * deriv(X, t));
    J = matdet(Mat([a, along, n~])));
  foreach(roots(numerator(J)), x, if(subst(g(u), t, x) * subst(g(v), t, x) < 0, listput(out, x)));
  print("CUSPS ", name, " ", Vec(out));
}
default(realprecision, 40);
"""
POLYGON = [(2, -1), (4, -1), (5, 1), (1, 2)]
PLANE = {
    "along": (["1-t^2", "-2*t", "2*t", "1-t^2"], "1+t^2", ["2*t", "0"]),
    "curved": (["1-t^2", "-2*t", "2*t", "1-t^2"], "1+t^2", ["3*t^2-t", "t^3-2*t"]),
    "shear": (["1", "2*t-t^2", "t^2", "4"], "1", ["t^3/2-t", "t-t^2"]),
}
TETRAHEDRON = [(0, 0, 0), (4, 1, 1), (1, 5, -1), (1, 2, 3)]
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
SPACE = {
    "turn": (["1-t^2", "-2*t", "0", "2*t", "1-t^2", "0", "0", "0", "1+t^2"], "1+t^2", ["2*t-t^2", "3*t^2", "t-2*t^2"]),
    "shear": (["2", "t", "t^2", "t-t^2", "3", "0", "0", "t", "2"], "1", ["t^3-t", "2*t^2-t", "t^2/2-t/3"]),
}


def entries(matrix, weight, shift, d):
    return [[f"({matrix[i * d + j]})/({weight})" for j in range(d)] + [shift[i]] for i in range(d)]


def normal_of(points):
    if len(points) == 2:
        (a, b), (c, e) = points
        return (e - b, a - c)
    p, q, r = points
    x, y = [[s - o for s, o in zip(z, p)] for z in (q, r)]
    return tuple(x[(k + 1) % 3] * y[(k + 2) % 3] - x[(k + 2) % 3] * y[(k + 1) % 3] for k in range(3))


def column(v):
    return "[" + ",".join(map(str, v)) + "]~"


def calls(name, motion, d):
    """Lines of gp, one for each facet and edge in it, named by both."""
    matrix, weight, shift = motion
    a = "[" + ";".join(",".join(f"({matrix[i * d + j]})/({weight})" for j in range(d)) for i in range(d)) + "]"
    b = column([f"({x})" for x in shift])
    out = []
    if d == 2:
        for k in range(4):
            u, v = POLYGON[k], POLYGON[(k + 1) % 4]
            ends = sorted((k, (k + 1) % 4))
            n = normal_of([u, v])
            out.append((f"edge {ends[0]}-{ends[1]}", f"edge {ends[0]}-{ends[1]}", n, u, v, None))
    else:
        for k, face in enumerate(FACES):
            n = normal_of([TETRAHEDRON[i] for i in face])
            sides = [(face[j], face[(j + 1) % 3]) for j in range(3)]
            for side in sides:
                other = next(s for s in sides if s != side)
                out.append((f"face {k}", "edge %d-%d" % tuple(sorted(side)), n, TETRAHEDRON[side[0]], TETRAHEDRON[side[1]],
                            [TETRAHEDRON[i] for i in other]))
    for facet, cell, n, u, v, other in out:
        tag = f"{name}/{facet}/{cell}".replace(" ", "_")
        also = "[" + ",".join(column(x) for x in other) + "]" if other else "0"
        yield facet, cell, f'tell("{tag}",{a},{b},[{",".join(map(str, n))}],{column(u)},{column(v)},{also});\n', tag


def solid_text(d):
    if d == 2:
        ring = POLYGON + POLYGON[:1]
        return "POLYGON ((" + ", ".join(f"{x} {y}" for x, y in ring) + "))\n"
    return ("OFF\n4 4 0\n" + "".join("%d %d %d\n" % v for v in TETRAHEDRON) + "".join("3 %d %d %d\n" % f for f in FACES))


def table_of(graze, checks, name, motion, d):
    pieces = {"dimension": d, "pieces": [{"t": ["0", "1"], "transform": {"matrix": entries(*motion, d)}}]}
    files = graze.write(name + (".wkt" if d == 2 else ".off"), solid_text(d)), graze.write(name + ".json", json.dumps(pieces))
    events = graze.write(name + "-events.csv", "")
    done = graze.call("envelope", *files, "--events", events)
    return table(events) if checks.equal(done.returncode, 0, name, done.stderr) else []


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    if not shutil.which("gp"):
        checks.skip("gp", "PARI's gp is not installed (Debian package pari-gp)")
        checks.finish()
    graze = Graze(args, checks)
    script, wanted = GP, {}
    for d, motions in ((2, PLANE), (3, SPACE)):
        for name, motion in motions.items():
            rows = [r for r in table_of(graze, checks, f"{name}{d}", motion, d) if r["kind"] == "cusp" and r["before"] and r["after"]]
            for facet, cell, line, tag in calls(f"{name}{d}", motion, d):
                script += line
                wanted[tag] = [When(r["time"]) for r in rows if (r["facet"], r["cell"]) == (facet, cell)]
    done = run(bounded(["gp", "-q", "-f", "-s", "1G"]), 60, input=script)
    told = dict(re.findall(r"^CUSPS (\S+) \[(.*)\]$", done.stdout, re.M))
    checks.equal(set(told), set(wanted), "gp", done.stderr[-300:], done.stdout[-300:])
    total = 0
    for tag, text in told.items():
        found = [F(x) for x in text.replace(" E", "E").split(", ") if x]
        times = wanted.get(tag, [])
        checks.equal(len(found), len(times), tag, text, [t.text for t in times])
        for x, when in zip(found, times):
            near = F(1, 10 ** 30)
            checks.holds(when.compare(x - near) > 0 > when.compare(x + near), tag, to_double(x), when.text)
            total += 1
    checks.holds(total > 4, "there are cusps", total)
    checks.finish()


if __name__ == "__main__":
    main()
