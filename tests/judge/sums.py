# suite
"""The boundary of a sweep as CGAL has it, judged: Minkowski sums with straight legs, convex, with notches and with a hole.

SPDX-License-Identifier: GPL-3.0-or-later

All distances are 0 and the mesh has the sweep's volume. Of a convex sum that is q > 1 times as large about an inner point the
distance to the sum is greatest at a corner, as it is convex.
"""
import os
import sys

from judged import Checks, Judge, Mesh, block, options, to_triangle, volume_of

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "cases"))

from exact import Fraction as F, to_double  # noqa: E402
from motion import legs  # noqa: E402
from oracle import Oracle  # noqa: E402
from shells import shells_text  # noqa: E402
from solidfile import read_off  # noqa: E402
from solids import cross, minus, polygons, prism  # noqa: E402

WITHIN = "5e-2r"


def ball(level, radius):
    """An octahedron whose triangles are cut into four `level` times, new corners put near the sphere: |x| within 2^-10 of it."""
    corners = [(F(s if k == 0 else 0), F(s if k == 1 else 0), F(s if k == 2 else 0)) for k in range(3) for s in (1, -1)]
    faces = [(corners[x], corners[2 + y], corners[4 + z]) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    faces = [(a, b, c) if sum(map(sign, (sum(a), sum(b), sum(c)))) in (3, -1) else (a, c, b) for a, b, c in faces]

    def middle(a, b):
        m = [x + y for x, y in zip(a, b)]
        length = to_double(sum(x * x for x in m)) ** 0.5
        return tuple(F(round(to_double(x) / length * 2 ** 10), 2 ** 10) for x in m)

    for _ in range(level):
        faces = [t for a, b, c in faces for ab, bc, ca in [(middle(a, b), middle(b, c), middle(c, a))]
                 for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
    places = {p: k for k, p in enumerate(dict.fromkeys(p for f in faces for p in f))}
    return Mesh([tuple(radius * x for x in p) for p in places], [[places[p] for p in f] for f in faces])


def sign(x):
    return (x > 0) - (x < 0)


def is_convex(mesh):
    """Every vertex is on the inner side of every facet, or in its plane."""
    for f in mesh.facets:
        p, q, r = (mesh.vertices[k] for k in f[:3])
        n = cross(minus(q, p), minus(r, p))
        if any(sum(x * y for x, y in zip(n, minus(v, p))) > 0 for v in mesh.vertices):
            return False
    return True


def scenes():
    ell = prism(polygons()["ell"].parts[0][0], 0, 2)
    return [
        ("ball of 8", ball(0, 3), [(0, 0, 0), (5, 2, F(1, 3))]),
        ("ball of 32", ball(1, 3), [(0, 0, 0), (F(7, 3), 4, -1)]),
        ("ball of 128", ball(2, 3), [(0, 0, 0), (6, F(1, 7), 2)]),
        ("ball twice", ball(1, 2), [(0, 0, 0), (5, 0, 1), (5, 6, 1)]),
        ("cube askew", block(0, 0, 0, 2, 2, 2), [(4, -4, 1), (-4, 4, F(1, 2))]),
        ("cube by a corner", block(0, 0, 0, 2, 2, 2), [(0, 0, 0), (4, 4, 4), (4, 0, 4)]),
        ("cube around a hole", block(0, 0, 0, 1, 1, 1), [(0, 0, 0), (3, 0, 0), (3, 3, 0), (0, 3, 0), (0, 0, 0)]),
        ("ell along an edge", ell, [(0, 0, 0), (6, 0, 0)]),
        ("ell askew", ell, [(0, 0, 0), (5, 3, F(7, 3))]),
        ("ell into its notch", ell, [(0, 0, 0), (-3, -3, 0), (-3, -3, 5)]),
    ]


def boundary_of(oracle, solid, path):
    """CGAL's boundary of the sweep, None after a failed check."""
    lines = [shells_text(solid), str(len(path) - 1), *(" ".join(str(F(x)) for x in p + q) for p, q in zip(path, path[1:])), "0"]
    answer = oracle.ask("\n".join(lines) + "\n", as_file=True, one_form=False)
    return Mesh(*read_off(answer.text)) if answer and answer.text else None


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    judge = Judge(args, checks)
    oracle = Oracle(args, checks, "minkowski")
    for name, solid, path in args.once(scenes()):
        swept, motion = boundary_of(oracle, solid, path), legs(path)
        if not checks.holds(swept, name, "CGAL has an answer"):
            continue
        volume = volume_of(swept)
        report = judge.ask(name, solid, motion, swept, "--within", WITHIN)
        if report:
            judge.holds(name, report, (0, 0, 0), to_double(volume), report["budget"]["within"])
            checks.equal(F(report["volume"]["mesh"]), volume, name, "volume")
        if is_convex(swept):
            middle = tuple(sum(p[i] for p in swept.vertices) / len(swept.vertices) for i in range(3))
            large = swept.mapped(lambda p, m=middle: tuple(c + F(5, 4) * (x - c) for x, c in zip(p, m)))
            faces = [[[to_double(x) for x in swept.vertices[v]] for v in f] for f in swept.facets]
            far = max(min(to_triangle([to_double(x) for x in p], *f) for f in faces) for p in large.vertices)
            report = judge.ask(name + " larger", solid, motion, large, "--within", WITHIN)
            if report:
                judge.holds(name + " larger", report, (far, 0, None), to_double(volume), report["budget"]["within"])
    oracle.finish()
    checks.finish()


if __name__ == "__main__":
    main()
