"""graze-check tests solid and motion itself: illegal ones are refuted, legal ones verified, and what
it cannot test is not called verified.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

Of an illegal solid graze certify makes no certificate. It gets that of a small cube (square) far
from the one point asked about, with the hashes of its own files.
"""
import os
import tempfile
from fractions import Fraction

from lib_certificate import Certificate, NOT_CHECKED, Programs, REFUTED, VERIFIED, sha256, write
from harness import ONLY, Checks, options

CUBE = ([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))],
        [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])
MOVE = {3: '{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["t", "0", "0"]}}]}',
        2: '{"dimension": 2, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["t", "0"]}}]}'}


def scaled(solid, factor, shift=(0, 0, 0)):
    points, faces = solid
    return [tuple(str(factor * Fraction(c) + s) for c, s in zip(p, shift)) for p in points], list(faces)


def turned(solid):
    return solid[0], [face[::-1] for face in solid[1]]


def both(*solids):
    points, faces = [], []
    for p, f in solids:
        faces += [tuple(v + len(points) for v in face) for face in f]
        points += p
    return points, faces


def without(solid, face):
    return solid[0], [f for k, f in enumerate(solid[1]) if k != face]


def off(solid):
    points, faces = solid
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(str, p)) for p in points] + [" ".join(map(str, (len(f), *f))) for f in faces]
    return "\n".join(lines) + "\n"


def prism(outline, low, high):
    n = len(outline)
    return ([(x, y, z) for z in (low, high) for x, y in outline],
            [tuple(range(n))[::-1], tuple(range(n, 2 * n)),
             *((k, (k + 1) % n, n + (k + 1) % n, n + k) for k in range(n))])


def tetrahedron(*points):
    """Outward oriented."""
    a, b, c, d = ([Fraction(x) for x in p] for p in points)
    u, v, w = ([x - y for x, y in zip(p, a)] for p in (b, c, d))
    det = sum(u[i] * (v[(i + 1) % 3] * w[(i + 2) % 3] - v[(i + 2) % 3] * w[(i + 1) % 3]) for i in range(3))
    faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
    return list(points), faces if det > 0 else [f[::-1] for f in faces]


TETRA = tetrahedron((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
INNER = tetrahedron((0, 0, 0), (1, 0, 0), ("1/2", "1/2", "1/4"), ("1/2", "1/4", "1/2"))
REMOTE = ([(50, 0, 0), (51, 0, 0), (50, 1, 0)], [(0, 1, 2), (0, 2, 1)])
L_SHAPE = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]
STAR = [(0, 0), (4, 1), (8, 0), (7, 4), (8, 8), (4, 7), (0, 8), (1, 4)]
# A tetrahedron whose edge lies inside the top of the cube [0, 4]^3, above or below it.
ROOF = tetrahedron((1, 1, 4), (3, 1, 4), (2, "1/2", 5), (2, "3/2", 5))
CELLAR = tetrahedron((1, 1, 4), (3, 1, 4), (2, "1/2", 3), (2, "3/2", 3))

LEGAL = {
    "cube": off(CUBE),
    "tetrahedron": off(TETRA),
    "two cubes that share an edge": off(both(CUBE, scaled(CUBE, 1, (1, 1, 0)))),
    "two cubes that share a vertex": off(both(CUBE, scaled(CUBE, 1, (1, 1, 1)))),
    "a cavity": off(both(scaled(CUBE, 9), turned(scaled(CUBE, 1, (3, 3, 3))))),
    "a part in a cavity": off(both(scaled(CUBE, 9), turned(scaled(CUBE, 5, (2, 2, 2))), scaled(CUBE, 1, (3, 3, 3)))),
    "a cavity, and a part at a vertex": off(both(scaled(CUBE, 9), turned(scaled(CUBE, 1, (3, 3, 3))), scaled(CUBE, 1, (9, 9, 9)))),
    "a tip on a face": off(both(scaled(CUBE, 4), tetrahedron((1, 1, 4), (0, 0, 6), (2, 0, 6), (1, 2, 6)))),
    "an edge on a face": off(both(scaled(CUBE, 4), ROOF)),
    "edges that overlap in part": off(both(scaled(CUBE, 2), scaled(CUBE, 2, (2, 1, 2)))),
    "an L": off(prism(L_SHAPE, 0, 1)),
    "a star": off(prism(STAR, 0, 1)),
    "collinear corners": off(prism([(0, 0), (1, 0), (2, 0), (2, 2), (1, 2), (0, 2)], 0, 1)),
    "repeated positions": off(([p for f in CUBE[1] for p in (CUBE[0][v] for v in f)],
                               [tuple(range(4 * k, 4 * k + 4)) for k in range(6)])),
    "colours and comments": off(CUBE).replace("4 0 3 2 1", "# a comment\n4 0 3 2 1 255 0 0"),
}
LEGAL_2D = {
    "a corner twice": "POLYGON ((0 0, 0 0, 1 0, 1 1, 0 1, 0 0))",
    "square": "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))",
    "the other way": "POLYGON ((0 0, 0 1, 1 1, 1 0, 0 0))",
    "a hole": "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))",
    "a hole that touches a side": "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (2 0, 3 2, 1 2, 2 0))",
    "two that touch": "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((1 1, 2 1, 2 2, 1 2, 1 1)))",
    "a tip on a side": "MULTIPOLYGON (((0 0, 4 0, 4 1, 0 1, 0 0)), ((2 1, 3 2, 1 2, 2 1)))",
}
REFUSED = {
    "open": off(without(CUBE, 1)),
    "inside out": off(turned(CUBE)),
    "one face turned": off((CUBE[0], [CUBE[1][0][::-1], *CUBE[1][1:]])),
    "a face twice": off((CUBE[0], [*CUBE[1], CUBE[1][0]])),
    "a face both ways": off((CUBE[0], [*CUBE[1], CUBE[1][0], CUBE[1][0][::-1]])),
    "twice the same": off(both(CUBE, CUBE)),
    "overlapping cubes": off(both(scaled(CUBE, 2), scaled(CUBE, 2, (1, 1, 1)))),
    "a cube in a cube": off(both(scaled(CUBE, 9), scaled(CUBE, 1, (3, 3, 3)))),
    "a cavity outside": off(both(CUBE, turned(scaled(CUBE, 1, (5, 5, 5))))),
    "cubes that share a part of a face": off(both(scaled(CUBE, 2), scaled(CUBE, 2, (2, 1, 1)))),
    "cubes that share a face": off(both(CUBE, scaled(CUBE, 1, (1, 0, 0)))),
    "a remote triangle both ways": off(both(CUBE, REMOTE)),
    "a remote triangle twice both ways": off(both(CUBE, REMOTE, REMOTE)),
    "a tetrahedron inside along an edge": off(both(CUBE, INNER)),
    "a fin through a face": off(both(scaled(CUBE, 4), scaled(TETRA, 2, (1, 1, 3)))),
    "a face that is not planar": off(([(0, 0, 2), *scaled(CUBE, 4)[0][1:]], CUBE[1])),
    "a facet without area": off((CUBE[0] + [(2, 0, 0)], [*CUBE[1], (0, 1, 8), (8, 1, 0)])),
    "a facet that crosses itself": off((CUBE[0], [(0, 2, 3, 1), *CUBE[1][1:]])),
    "no facets": "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n",
    "an index too large": off(CUBE).replace("4 0 3 2 1", "4 0 3 2 8"),
    "a vertex too few": off(CUBE).replace("0 0 0\n", "", 1),
    "a facet too few": off(CUBE).replace("8 6 0", "8 7 0"),
    "a facet too much": off(CUBE).replace("8 6 0", "8 5 0"),
    "a coordinate too much": off(CUBE).replace("0 0 0\n", "0 0 0 0\n", 1),
    "no number": off(CUBE).replace("0 0 0\n", "0 0 nan\n", 1),
    "a number bomb": off(CUBE).replace("0 0 0\n", "0 0 1e1000000000\n", 1),
    "no OFF": off(CUBE)[4:],
    "two colours": off(CUBE).replace("4 0 3 2 1", "4 0 3 2 1 255 0"),
    "empty": "",
}
REFUSED_2D = {
    "open": "POLYGON ((0 0, 1 0, 1 1, 0 1))",
    "a bow tie": "POLYGON ((0 0, 1 1, 1 0, 0 1, 0 0))",
    "a bow tie with area": "POLYGON ((0 0, 2 2, 2 0, 0 1, 0 0))",
    "overlapping": "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((1 1, 3 1, 3 3, 1 3, 1 1)))",
    "a part of a side shared": "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((2 1, 3 1, 3 3, 2 3, 2 1)))",
    "nested": "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0)), ((1 1, 2 1, 2 2, 1 2, 1 1)))",
    "a hole outside": "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0), (5 5, 6 5, 6 6, 5 6, 5 5))",
    "a hole in a hole": "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1), (2 2, 3 2, 3 3, 2 3, 2 2))",
    "a corner twice and a spike": "POLYGON ((0 0, 0 0, 2 0, 1 0, 1 1, 0 1, 0 0))",
    "a spike": "POLYGON ((0 0, 2 0, 1 0, 1 1, 0 1, 0 0))",
    "no area": "POLYGON ((0 0, 1 0, 2 0, 0 0))",
    "three coordinates": "POLYGON ((0 0 0, 1 0 0, 1 1 0, 0 1 0, 0 0 0))",
    "not closed by a bracket": "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0)",
    "text behind": "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0)) x",
    "a line": "LINESTRING (0 0, 1 0)",
}
# Legal or not, but past what is tested.
NOT_TESTED = {"edges inside a face from above and below": off(both(scaled(CUBE, 4), ROOF, turned(CELLAR)))}
PIECE = '{"t": ["%s", "%s"], "transform": {"translate": ["%s", "0", "0"]}}'
MOTIONS = {
    "backwards": PIECE % ("1", "0", "t"),
    "no time": PIECE % ("0", "0", "t"),
    "a gap": PIECE % ("0", "1/3", "t") + "," + PIECE % ("1/2", "1", "t"),
    "a jump": PIECE % ("0", "1/2", "t") + "," + PIECE % ("1/2", "1", "t + 1"),
    "a pole": PIECE % ("0", "1", "1/(2*t - 1)"),
    "a double pole": PIECE % ("0", "1", "1/(2*t - 1)^2"),
    "a pole at the end": PIECE % ("0", "1", "1/(t - 1)"),
    "an irrational pole": PIECE % ("0", "1", "1/(2*t^2 - 1)"),
    "det 0 inside": '{"t": ["0", "1"], "transform": {"scale": ["2*t - 1", "1", "1"]}}',
    "det 0 at the end": '{"t": ["0", "1"], "transform": {"scale": ["1 - t", "1", "1"]}}',
    "det touches 0": '{"t": ["0", "1"], "transform": {"scale": ["(2*t - 1)^2", "1", "1"]}}',
    "det always 0": '{"t": ["0", "1"], "transform": {"scale": ["0", "1", "1"]}}',
    "division by zero": PIECE % ("0", "1", "1/(t - t)"),
    "an exponent bomb": PIECE % ("0", "1", "t^1000000000"),
    "a number bomb": PIECE % ("0", "1", "1e1000000000*t"),
    "brackets": PIECE % ("0", "1", "(" * 100000 + "t" + ")" * 100000),
    "no expression": PIECE % ("0", "1", "t t"),
    "a power of a power": PIECE % ("0", "1", "t^2^2"),
    "an unknown key": '{"t": ["0", "1"], "transform": {"translat": ["t", "0", "0"]}}',
    "two kinds": '{"t": ["0", "1"], "transform": {"translate": ["t", "0", "0"], "scale": "1"}}',
    "a key twice": '{"t": ["0", "1"], "t": ["0", "1"], "transform": {"translate": ["t", "0", "0"]}}',
    "an irrational axis": '{"t": ["0", "1"], "transform": {"rotate": {"axis": ["1", "1", "0"], "tan_half": "t"}}}',
    "no pieces": "",
    "no JSON": "{",
}


def check_legal(tally, programs, folder, dimension, name, text):
    solid = write(os.path.join(folder, "legal" + (".off" if dimension == 3 else ".wkt")), text)
    motion = write(os.path.join(folder, "motion.json"), MOVE[dimension])
    points = write(os.path.join(folder, "points.csv"), ",".join(["1/3", "1/5", "2/7"][:dimension]) + "\n")
    path = write(os.path.join(folder, "certificate"), programs.certify(solid, motion, points))
    status, out, error = programs.check(solid, motion, path)
    tally.equal((status, out), (VERIFIED, "verified: 1 rows\n"), name, error)
    status, out, error = programs.check(solid, motion, path, "--assume-legal")
    tally.equal((status, out), (VERIFIED, "verified, assuming a legal solid: 1 rows\n"), name, error)


def far_certificate(programs, folder, dimension):
    """One point that no solid here comes near."""
    solid = write(os.path.join(folder, "far" + (".off" if dimension == 3 else ".wkt")),
                  off(CUBE) if dimension == 3 else LEGAL_2D["square"])
    motion = write(os.path.join(folder, "motion.json"), MOVE[dimension])
    points = write(os.path.join(folder, "points.csv"), ",".join(["1000"] * dimension) + "\n")
    return Certificate(programs.certify(solid, motion, points))


def check_other(tally, programs, folder, certificate, name, solid, motion, wanted):
    certificate.set("solid-sha256", sha256(solid))
    certificate.set("motion-sha256", sha256(motion))
    path = write(os.path.join(folder, "certificate"), certificate.text())
    status, out, error = programs.check(solid, motion, path)
    tally.holds(status in wanted and not out and len(error.splitlines()) == 1, f"{status} {out} {error}", name)


def check_solids(tally, programs, folder, dimension, legal, refused):
    for name, text in legal.items():
        check_legal(tally, programs, folder, dimension, name, text)
    certificate = far_certificate(programs, folder, dimension)
    ending, motion = (".off" if dimension == 3 else ".wkt"), os.path.join(folder, "motion.json")
    good = write(os.path.join(folder, "good" + ending), next(iter(legal.values())))
    certificate.set("solid-sha256", sha256(good))
    path = write(os.path.join(folder, "certificate"), certificate.text())
    tally.equal(programs.check(good, motion, path)[0], VERIFIED, "the far certificate alone is right")
    for name, text in refused.items():
        bad = write(os.path.join(folder, "bad" + ending), text)
        check_other(tally, programs, folder, certificate, name, bad, motion, (REFUTED, NOT_CHECKED))
    for name, text in NOT_TESTED.items() if dimension == 3 else ():
        bad = write(os.path.join(folder, "bad" + ending), text)
        check_other(tally, programs, folder, certificate, name, bad, motion, (NOT_CHECKED,))


def check_motions(tally, programs, folder):
    certificate = far_certificate(programs, folder, 3)
    solid = os.path.join(folder, "far.off")
    for name, pieces in MOTIONS.items():
        motion = write(os.path.join(folder, "bad.json"), '{"dimension": 3, "pieces": [' + pieces + "]}")
        check_other(tally, programs, folder, certificate, name, solid, motion, (REFUTED, NOT_CHECKED))
    halves = [PIECE % ("0", "1/2", "t"), PIECE % ("1/2", "1", "t")]
    motion = write(os.path.join(folder, "two.json"), '{"dimension": 3, "pieces": [' + ",".join(halves) + "]}")
    points = write(os.path.join(folder, "points.csv"), "1000,1000,1000\n")
    cut = Certificate(programs.certify(solid, motion, points))
    jump = write(os.path.join(folder, "jump.json"), '{"dimension": 3, "pieces": [' + MOTIONS["a jump"] + "]}")
    check_other(tally, programs, folder, cut, "a jump, everything else right", solid, jump, (REFUTED,))
    check_other(tally, programs, folder, certificate, "an interval over a break point", solid, motion, (REFUTED,))


def check_usage(tally, programs, folder):
    certificate = far_certificate(programs, folder, 3)
    solid, motion = os.path.join(folder, "far.off"), os.path.join(folder, "motion.json")
    path = write(os.path.join(folder, "certificate"), certificate.text())
    for name, words in (("nothing", []), ("two files", [solid, motion]), ("five files", [solid, motion, path, path, path]),
                        ("an option", ["--force", solid, motion, path]), ("no solid", ["none.off", motion, path]),
                        ("no motion", [solid, "none.json", path]), ("no certificate", [solid, motion, "none"]),
                        ("no table", [solid, motion, path, "none"]),
                        ("another ending", [motion, motion, path])):
        status, out, _ = programs.check(*words)
        tally.holds(status != VERIFIED and not out, f"{status} {out}", name)
    status, out, _ = programs.check("--help")
    tally.holds(status == 0 and "graze-check SOLID MOTION CERTIFICATE" in out, out, "help")


def main():
    chosen = options(__doc__, ONLY)
    programs, tally = Programs(chosen.graze), Checks()
    with tempfile.TemporaryDirectory() as folder:
        check_solids(tally, programs, folder, 3, LEGAL, REFUSED)
        check_solids(tally, programs, folder, 2, LEGAL_2D, REFUSED_2D)
        check_motions(tally, programs, folder)
        check_usage(tally, programs, folder)
    tally.finish()


if __name__ == "__main__":
    main()
