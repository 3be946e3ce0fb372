# suite
"""`graze outline --polygon`: valid polygons of doubles near the outline, on the scenes that are derived by hand.

SPDX-License-Identifier: GPL-3.0-or-later

The symmetric difference of the outline's set and a polygon lies within the distance T of the outline, a set of at most 2 T length + π T² for each
ring; so both areas differ by no more. Rings and holes have the outline's numbers. Where shapely is installed it says that the polygons are valid.
A corner on a circle is known: the bar's turn has its far corner at radius √5.
"""
import json
import math
import os
import re
import xml.dom.minidom
from itertools import product

from byhand import SCENES
from exact import Fraction as F
from outlines import Checks, Program, middle, options

from motion import build, rotation, translate  # noqa: E402
from solids import Polygon, ring  # noqa: E402

try:
    import shapely.wkt as wkt
except ImportError:
    wkt = None

NEAR = (1e-1, 1e-4)


def rings_of(text):
    """Polygons of well-known text, each a list of rings without the last point."""
    out = []
    for polygon in re.findall(r"\(\((.*?)\)\)", text[len("MULTIPOLYGON ("):].strip()):
        out.append([[tuple(map(float, p.split())) for p in ring.split(", ")] for ring in polygon.split("), (")])
    return out


def area(ring):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:])) / 2


def polygon(program, name, solid, motion, near, unsweep, ending="wkt"):
    path = os.path.join(program.folder.name, "polygon." + ending)
    files = program.write("s.wkt", solid.text()), program.write("m.json", motion.text())
    out = program.call("outline", *files, "--polygon", path, "--within", str(near), "--format", "json",
                       *(("--operation", "unsweep") if unsweep else ()))
    if out.returncode:
        return out.returncode, out.stderr, None
    with open(path, encoding="ascii") as file:
        return 0, file.read(), json.loads(out.stdout)


def check(checks, program, scene):
    for near in NEAR:
        code, text, got = polygon(program, scene.name, scene.solid, scene.motion, near, scene.unsweep)
        if scene.fine and code == 6:
            checks.holds("doubles" in text, scene.name, text)
            continue
        if not checks.equal(code, 0, scene.name, near, text):
            continue
        polygons = rings_of(text)
        checks.equal(len(polygons), scene.interior, scene.name, near, "polygons")
        checks.equal(sum(len(p) - 1 for p in polygons), sum(r["hole"] for r in got["rings"]), scene.name, near, "holes")
        rings = [r for p in polygons for r in p]
        checks.holds(all(r[0] == r[-1] for r in rings), scene.name, near, "closed rings")
        length = middle((float(got["length"]["low"]), float(got["length"]["high"])))
        bound = 2 * near * length + math.pi * near ** 2 * len(rings) + 1e-12
        checks.holds(abs(sum(map(area, rings)) - float(scene.area)) <= bound, scene.name, near, "area", sum(map(area, rings)), scene.area)
        if wkt:
            checks.holds(wkt.loads(text).is_valid, scene.name, near, "shapely: is_valid")


def forms(checks, program):
    """Four forms of one polygon, whose corners are on the circle of radius √2 or corners of squares."""
    scene, = (s for s in SCENES if s.name == FORM)
    corners = {}
    for ending in ("wkt", "geojson", "svg", "vtk"):
        code, text, _ = polygon(program, scene.name, scene.solid, scene.motion, 1e-3, False, ending)
        if not checks.equal(code, 0, ending, text):
            return
        if ending == "wkt":
            corners[ending] = [p for shell in rings_of(text) for r in shell for p in r]
        elif ending == "geojson":
            corners[ending] = [tuple(p) for shell in json.loads(text)["coordinates"] for r in shell for p in r]
        elif ending == "svg":
            path = xml.dom.minidom.parseString(text).getElementsByTagName("path")[0].getAttribute("d")
            corners[ending] = [tuple(map(float, p.split(","))) for p in re.sub("[MZ]", " ", path).split()]
        else:
            lines = text.split("\n")
            count = int(lines[4].split()[1])
            corners[ending] = [tuple(map(float, line.split()[:2])) for line in lines[5:5 + count]]
            checks.equal([int(x) for line in lines[6 + count:-1] for x in line.split()[1:]], list(range(count)), "vtk: lines")
        checks.equal(corners[ending], corners["wkt"], ending)


def side(a, b, c):
    """The sign of the turn from b to c about a, exactly."""
    (ax, ay), (bx, by), (cx, cy) = ([F(x) for x in p] for p in (a, b, c))
    turn = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    return (turn > 0) - (turn < 0)


def apart(checks, program):
    """Two bars turn by a quarter about the origin: the corners of one are at least 10 away, those of the other less than 9.9, and its arc lies under the
    chords of the first one's. So chords within 1 or 5 of the arcs would cross, and are halved until they do not: no edge meets another ring."""
    for near in (5, 1):
        code, text, _ = polygon(program, "bars", BARS, QUARTER, near, False)
        if not checks.equal(code, 0, "bars", near, text):
            continue
        polygons = rings_of(text)
        checks.equal([len(p) for p in polygons], [1, 1], "bars", near, "polygons")
        edges = [list(zip(r, r[1:])) for (r,) in polygons]
        for (a, b), (c, d) in product(*edges):
            checks.holds(side(a, b, c) * side(a, b, d) > 0 or side(c, d, a) * side(c, d, b) > 0, "bars", near, "edges that meet", a, b, c, d)
        checks.holds(max(math.hypot(*p) for p in polygons[1][0]) < 9.9, "bars", near, "the inner polygon")
        checks.holds(min(math.hypot(*p) for p in polygons[0][0]) > 9.99, "bars", near, "the outer polygon")


def flat(checks, program):
    """A triangle of height 2^-60 at rest: its corners, as doubles with the unit that the others need, are on one line."""
    low = Polygon([[ring((0, 0), (1, 0), (F(1, 2), F(1, 2 ** 60)))]])
    code, text, _ = polygon(program, "flat", low, build([(0, 1, translate([[], []]))]), 1e-3, False)
    checks.equal((code, "doubles" in text), (6, True), "flat", text)


FORM = SCENES[0].name
BARS = Polygon([[ring((10, 0), (F(101, 10), 0), (F(101, 10), F(1, 20)), (10, F(1, 20)))],
                [ring((F(32, 5), F(32, 5)), (7, 7), (F(139, 20), F(141, 20)), (F(127, 20), F(129, 20)))]])
QUARTER = build([(0, 1, rotation([0, 1]))])


def main():
    args = options(__doc__.splitlines()[0], ("--only", {"default": "", "help": "scenes whose name contains this text"}))
    checks = Checks()
    program = Program(args, checks)
    for scene in SCENES:
        if args.only in scene.name:
            check(checks, program, scene)
    forms(checks, program)
    apart(checks, program)
    flat(checks, program)
    checks.finish()


if __name__ == "__main__":
    main()
