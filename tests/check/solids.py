"""graze-check tests solid and motion itself: illegal ones are refuted, legal ones verified, and what
it cannot test is not called verified.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

Of an illegal solid graze certify makes no certificate. It gets that of a small cube (square) far
from the one point asked about, with the hashes of its own files.
"""
import os
import subprocess
import tempfile

from lib_certificate import Certificate, ENVIRONMENT, NOT_CHECKED, Programs, REFUTED, VERIFIED, run, sha256, write
from exact import Fraction
from meshes import CUBE, MOVE, SQUARE, both, off, prism, scaled, tetrahedron, turned, without
from harness import ONLY, Checks, options

TETRA = tetrahedron((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
INNER = tetrahedron((0, 0, 0), (1, 0, 0), ("1/2", "1/2", "1/4"), ("1/2", "1/4", "1/2"))
REMOTE = ([(50, 0, 0), (51, 0, 0), (50, 1, 0)], [(0, 1, 2), (0, 2, 1)])
LONG = "1/1" + "0" * 9000 + "%03d"  # no two of these denominators have a large factor in common
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
    "a corner twice": off(CUBE).replace("4 0 3 2 1", "5 0 0 3 2 1"),
    "colours and comments": off(CUBE).replace("4 0 3 2 1", "# a comment\n4 0 3 2 1 255 0 0"),
}
def beside(turn, first):
    """Two tetrahedra with a face in one plane: a spike that points at the middle of a long side, which alone separates
    the two, slanted so that their boxes meet. The corners are in another order by `turn`, the solids by `first`."""
    def lay(corners, apex):
        flat = [(Fraction(x - y), Fraction(x + y), Fraction(0)) for x, y in corners[turn:] + corners[:turn]]
        return tetrahedron(*flat, (Fraction(apex[0] - apex[1]), Fraction(apex[0] + apex[1]), Fraction(-1)))
    solids = [lay([(-10, 0), (10, 0), (0, -10)], (0, -3)), lay([(0, 1), (1, 20), (-1, 20)], (0, 14))]
    return off(both(*(solids if first else solids[::-1])))


LEGAL.update({f"faces of one plane {turn} {first}": beside(turn, first) for turn in range(3) for first in (0, 1)})
LEGAL_2D = {
    "a corner twice": "POLYGON ((0 0, 0 0, 1 0, 1 1, 0 1, 0 0))",
    "square": SQUARE,
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
    "a remote triangle one way": off(both(CUBE, ([(-50, 0, 0), (-50, 1, 0), (-50, 0, 1)], [(0, 1, 2)]))),
    "two remote triangles one way": off(both(CUBE, ([(-50, 0, 0), (-50, 1, 0), (-50, 0, 1)], [(0, 1, 2)]),
                                             ([(-60, 0, 0), (-60, 0, 1), (-60, 1, 0)], [(0, 2, 1)]))),
    "a remote square one way": off(both(CUBE, ([(-50, 0, 0), (-50, 1, 1), (-50, 1, 0), (-50, 0, 1)], [(0, 2, 1, 3)]))),
    "cubes whose corners overlap": off(both(CUBE, scaled(CUBE, 1, ("9/10", "9/10", "9/10")))),
    "a triangle without area": off(both(CUBE, ([(5, 0, 0), (6, 0, 0), (7, 0, 0)], [(0, 1, 2)]))),
    "a facet of two corners": off(CUBE).replace("4 0 3 2 1", "2 0 3"),
    "a facet that ends early": off(CUBE).replace("4 0 3 2 1", "4 0 3 2"),
    "a corner that is no number": off(CUBE).replace("4 0 3 2 1", "4 0 3 2 -1"),
    "a vertex over two lines": off(CUBE).replace("0 0 0\n", "0 0\n0\n", 1),
    "counts that are none": off(CUBE).replace("8 6 0", "8 six 0"),
    "two counts": off(CUBE).replace("8 6 0\n", "8 6\n"),
    "a denominator too large": off(CUBE).replace("0 0 0\n", f"1/1{'0' * 20000} 0 0\n", 1),
    "denominators too large together": off(both(CUBE, ([(LONG % k, k, 0) for k in range(60)], []))),
    "a remote triangle both ways": off(both(CUBE, REMOTE)),
    "a remote triangle twice both ways": off(both(CUBE, REMOTE, REMOTE)),
    "a tetrahedron inside along an edge": off(both(CUBE, INNER)),
    "a fin through a face": off(both(scaled(CUBE, 4), scaled(TETRA, 2, (1, 1, 3)))),
    "a face that is not planar": off(([(0, 0, 2), *scaled(CUBE, 4)[0][1:]], CUBE[1])),
    "a facet that is not planar, closed": off(([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 2), (1, 1, 4), (0, 1, 2)], CUBE[1])),
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
    "a side of no area left out": "POLYGON ((0 0, 2 0, 2 0, 0 0))",
    "three positions": "POLYGON ((0 0, 1 0, 0 0))",
    "a number that is none": "POLYGON ((0 0, x 0, 1 1, 0 1, 0 0))",
    "no comma": "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0) (5 5))",
    "no polygon": "MULTIPOLYGON ()",
    "a comment": "# a square\nPOLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))",
    "a string": 'POLYGON (("0" 0, 1 0, 1 1, 0 1, 0 0))',
    "a line": "LINESTRING (0 0, 1 0)",
}
# Legal or not, but past what is tested.
NOT_TESTED = {"edges inside a face from above and below": off(both(scaled(CUBE, 4), ROOF, turned(CELLAR)))}
# Legal, but not as graze-check reads solids; graze convert writes them so.
NOT_READ = {"an L", "a star", "collinear corners", "a corner twice", "colours and comments"}
PIECE = '{"t": ["%s", "%s"], "transform": {"translate": ["%s", "0", "0"]}}'
SCALE = '{"t": ["0", "1"], "transform": {"matrix": [["%s", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"]]}}'
MOTIONS = {
    "backwards": PIECE % ("1", "0", "t"),
    "no time": PIECE % ("0", "0", "t"),
    "a gap": PIECE % ("0", "1/3", "t") + "," + PIECE % ("1/2", "1", "t"),
    "a jump": PIECE % ("0", "1/2", "t") + "," + PIECE % ("1/2", "1", "t + 1"),
    "a pole": PIECE % ("0", "1", "(1)/(2*t - 1)"),
    "a double pole": PIECE % ("0", "1", "(1)/(4*t^2 - 4*t + 1)"),
    "a pole at the end": PIECE % ("0", "1", "(1)/(t - 1)"),
    "an irrational pole": PIECE % ("0", "1", "(1)/(2*t^2 - 1)"),
    "det 0 inside": SCALE % "2*t - 1",
    "det 0 at the end": SCALE % "1 - t",
    "det touches 0": SCALE % "4*t^2 - 4*t + 1",
    "det always 0": SCALE % "0",
    "division by zero": PIECE % ("0", "1", "(1)/(t - t)"),
    "an exponent bomb": PIECE % ("0", "1", "t^1000000000"),
    "a degree of ten digits": PIECE % ("0", "1", "t^10000000000"),
    "a degree past the cap": PIECE % ("0", "1", "t^301"),
    "a degree past the cap once inverted": SCALE.replace('"1"', '"t^200 + 1"', 3) % "t^200 + 1",
    "a number bomb": PIECE % ("0", "1", "1e1000000000*t"),
    "a number too long": PIECE % ("0", "1", "1" * 20001),
    "a denominator too large": PIECE % ("0", "1", " + ".join(LONG % k + "*t" for k in range(60))),
    "brackets": PIECE % ("0", "1", "(" * 100000 + "t" + ")" * 100000),
    "no expression": PIECE % ("0", "1", "t t"),
    "an empty entry": PIECE % ("0", "1", ""),
    "a sign alone": PIECE % ("0", "1", "1 -"),
    "a factor without t": PIECE % ("0", "1", "2*"),
    "an unknown variable": PIECE % ("0", "1", "2*s"),
    "a power without number": PIECE % ("0", "1", "t^"),
    "a negative power": PIECE % ("0", "1", "t^-1"),
    "a power of a power": PIECE % ("0", "1", "t^2^2"),
    "a product": PIECE % ("0", "1", "t*t"),
    "a quotient without brackets": PIECE % ("0", "1", "1/t"),
    "half a quotient": PIECE % ("0", "1", "(1)/"),
    "a bracket alone": PIECE % ("0", "1", "(1)"),
    "a bracket that is open": PIECE % ("0", "1", "(1"),
    "a bracket with nothing": PIECE % ("0", "1", "(1)/()"),
    "two terms and no end": PIECE % ("0", "1", "(1 1)/(1)"),
    "brackets and more": PIECE % ("0", "1", "(1)/(1) 1"),
    "a quotient of one bracket": PIECE % ("0", "1", "(1)/t"),
    "an open bracket": PIECE % ("0", "1", "(1)/(t"),
    "an unknown key": '{"t": ["0", "1"], "transform": {"translat": ["t", "0", "0"]}}',
    "two kinds": '{"t": ["0", "1"], "transform": {"translate": ["t", "0", "0"], "scale": "1"}}',
    "a key twice": '{"t": ["0", "1"], "t": ["0", "1"], "transform": {"translate": ["t", "0", "0"]}}',
    "a rotation": '{"t": ["0", "1"], "transform": {"rotate": {"axis": ["0", "0", "1"], "tan_half": "t"}}}',
    "an entry too few": '{"t": ["0", "1"], "transform": {"translate": ["t", "0"]}}',
    "an entry too many": '{"t": ["0", "1"], "transform": {"translate": ["t", "0", "0", "0"]}}',
    "a row too short": SCALE.replace('"0", "0", "0"]', '"0", "0"]', 1) % "1",
    "a row too long": SCALE.replace('"0", "0", "0"]', '"0", "0", "0", "0"]', 1) % "1",
    "a row too few": SCALE.replace(', ["0", "0", "1", "0"]', "") % "1",
    "a row too many": SCALE.replace("]]", '], ["0", "0", "0", "1"]]') % "1",
    "a time that is none": PIECE % ("0", "one", "t"),
    "a row that is none": PIECE.replace('], "tr', '], "row": x, "tr', 1) % ("0", "1", "t"),
    "a row that is none behind digits": PIECE.replace('], "tr', '], "row": 1x, "tr', 1) % ("0", "1", "t"),
    "a row alone": '{"t": ["0", "1"], "row": 1}',
    "a row without its transform": '{"t": ["0", "1"], "row": 1, "t": 2}',
    "a key that is none": PIECE.replace("transform", "map") % ("0", "1", "t"),
    "a backslash": PIECE % ("0", "1", "\\u0074"),
    "a line end in a string": PIECE % ("0", "1", "t\n"),
    "a string without end": '{"t": ["0", "1',
    "an object for a list": '{"t": {"0": "1"}}',
    "no pieces": "",
    "no JSON": "{",
}
# Whole motion files.
WHOLE = {
    "a comment": MOVE[3].replace(", ", ", # a comment\n", 1),
    "text behind": MOVE[3] + "1",
    "dimension 4": MOVE[3].replace("3", "4", 1),
    "the plane": MOVE[2],
    "key frames": '{"dimension": 3, "keyframes": []}',
    "nothing": "",
    "a NUL": MOVE[3].replace("t", "t\0", 1),
}


def verify(tally, programs, folder, name, solid, motion, points, what):
    path = write(os.path.join(folder, "certificate"), programs.certify(solid, motion, points))
    status, out, error = programs.check(solid, motion, path)
    tally.equal((status, out), (VERIFIED, "verified: 1 rows\n"), name, what, error)
    status, out, error = programs.check(solid, motion, path, "--assume-legal")
    tally.equal((status, out), (VERIFIED, "verified, assuming a legal solid: 1 rows\n"), name, what, error)


def check_legal(tally, programs, folder, dimension, name, text):
    ending = ".off" if dimension == 3 else ".wkt"
    solid = write(os.path.join(folder, "legal" + ending), text)
    motion = write(os.path.join(folder, "motion.json"), MOVE[dimension])
    points = write(os.path.join(folder, "points.csv"), ",".join(["1/3", "1/5", "2/7"][:dimension]) + "\n")
    converted = os.path.join(folder, "converted" + ending)
    tally.equal(run(programs.graze, "convert", solid, "-o", converted)[0], 0, name, "convert")
    verify(tally, programs, folder, name, converted, motion, points, "converted")
    if dimension == 2 or name not in NOT_READ:
        verify(tally, programs, folder, name, solid, motion, points, "as it stands")


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
    unread = {name: legal[name] for name in legal if dimension == 3 and name in NOT_READ}
    tally.equal(len(unread), 5 if dimension == 3 else 0, "what is not read is among what is legal")
    for name, text in {**NOT_TESTED, **unread}.items() if dimension == 3 else ():
        bad = write(os.path.join(folder, "bad" + ending), text)
        check_other(tally, programs, folder, certificate, name, bad, motion, (NOT_CHECKED,))


def check_motions(tally, programs, folder):
    certificate = far_certificate(programs, folder, 3)
    solid = os.path.join(folder, "far.off")
    for name, pieces in MOTIONS.items():
        motion = write(os.path.join(folder, "bad.json"), '{"dimension": 3, "pieces": [' + pieces + "]}")
        check_other(tally, programs, folder, certificate, name, solid, motion, (REFUTED, NOT_CHECKED))
    for name, text in WHOLE.items():
        check_other(tally, programs, folder, certificate, name, solid, write(os.path.join(folder, "bad.json"), text),
                    (REFUTED, NOT_CHECKED))
    check_signs(tally, programs, folder)
    halves = [PIECE % ("0", "1/2", "t"), PIECE % ("1/2", "1", "t")]
    motion = write(os.path.join(folder, "two.json"), '{"dimension": 3, "pieces": [' + ",".join(halves) + "]}")
    points = write(os.path.join(folder, "points.csv"), "1000,1000,1000\n")
    cut = Certificate(programs.certify(solid, motion, points))
    logged = write(os.path.join(folder, "logged.json"), '{"dimension": 3, "pieces": ['
                   + PIECE.replace('], "tr', '], "row": 12345678901, "tr', 1) % ("0", "1", "t") + "]}")
    verify(tally, programs, folder, "a row of a log", solid, logged, points, "read")
    jump = write(os.path.join(folder, "jump.json"), '{"dimension": 3, "pieces": [' + MOTIONS["a jump"] + "]}")
    check_other(tally, programs, folder, cut, "a jump, everything else right", solid, jump, (REFUTED,))
    gap = write(os.path.join(folder, "gap.json"), '{"dimension": 3, "pieces": [' + PIECE % ("0", "1/2", "t") + ","
                + PIECE % ("2/3", "1", "t") + "]}")
    check_other(tally, programs, folder, cut, "a gap, everything else right", solid, gap, (REFUTED,))
    check_other(tally, programs, folder, certificate, "an interval over a break point", solid, motion, (REFUTED,))


def check_signs(tally, programs, folder):
    """A motion with a pole, or with det = 0, that no row shows: the map that carries the points has none. The trajectory
    of (0, 0, 1000) stays on the z axis, far from the solid."""
    solid = write(os.path.join(folder, "aside.off"), off(scaled(CUBE, 1, (5, 5, 5))))
    uniform = SCALE.replace('"1", "0"', '"%s", "0"')
    for operation, form, entry in (("sweep", SCALE, "(1)/(2*t - 1)"), ("unsweep", SCALE, "2*t - 1"), ("sweep", uniform, "(1)/(2*t - 1)")):
        for name, x, wanted in (("without", "2", (VERIFIED,)), ("with", entry, (REFUTED,))):
            motion = write(os.path.join(folder, "signs.json"), '{"dimension": 3, "pieces": [' + form.replace("%s", x) + "]}")
            certificate = Certificate(
                f"graze-certificate 1\nsolid-sha256 {sha256(solid)}\nmotion-sha256 {sha256(motion)}\n"
                f"scene-sha256 {'0' * 64}\ndimension 3\noperation {operation}\nfolds separate\nsigns 0 1\n"
                "row 0 0 1000 O out" + (" exterior 9 1 0 0 0" if operation == "sweep" else "") + "\nO 1\ncomplete 1\n")
            path = write(os.path.join(folder, "certificate"), certificate.text())
            status, _, error = programs.check(solid, motion, path)
            tally.holds(status in wanted, f"{status} {error}", operation, name, "a sign that changes")


def check_usage(tally, programs, folder):
    certificate = far_certificate(programs, folder, 3)
    solid, motion = os.path.join(folder, "far.off"), os.path.join(folder, "motion.json")
    path = write(os.path.join(folder, "certificate"), certificate.text())
    for name, words in (("nothing", []), ("two files", [solid, motion]), ("five files", [solid, motion, path, path, path]),
                        ("no jobs", [solid, motion, path, "--jobs", "0"]), ("many jobs", [solid, motion, path, "--jobs", "1001"]), ("jobs", [solid, motion, path, "--jobs"]),
                        ("an option", ["--force", solid, motion, path]), ("no solid", ["none.off", motion, path]),
                        ("no motion", [solid, "none.json", path]), ("no certificate", [solid, motion, "none"]),
                        ("no table", [solid, motion, path, "none"]),
                        ("another ending", [motion, motion, path])):
        status, out, _ = programs.check(*words)
        tally.holds(status != VERIFIED and not out, f"{status} {out}", name)
    for words in ([solid, motion, path], ["--help"]):
        with open("/dev/full", "w", encoding="ascii") as full:
            done = subprocess.run([programs.check_program, *words], stdout=full, stderr=subprocess.DEVNULL, env=ENVIRONMENT)
        tally.equal(done.returncode, NOT_CHECKED, "nowhere to write to", words)
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
