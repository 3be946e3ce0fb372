# suite
"""The outlines that byhand.py derives, without `graze outline`: areas, numbers and lengths by slices, members by `graze classify`.

SPDX-License-Identifier: GPL-3.0-or-later

It is the derivation, or the slices, that fails here. Areas by slices are good to a millionth, lengths to a few parts in 10^5.
"""
from byhand import SCENES
from exact import Fraction as F
from outlines import Checks, Program, options, to_double
from slices import TURN, Slices

AREA, LENGTH = 1e-6, 5e-4
POINTS = 100
TOUCHING = "tangent pinch"   # with one tangent: slices on both sides look alike


def agree(checks, scene, found):
    area = float(scene.area)
    checks.holds(abs(found.area - area) <= AREA * max(1, area), scene.name, "area", area, "by slices", found.area)
    if scene.fine:
        return
    if scene.name != TOUCHING:
        checks.equal([found.components, found.interior_components, found.holes], [scene.components, scene.interior, scene.holes], scene.name,
                     "components, of the interior, holes")
    for name, want, got in zip(("length", "length of the lower part"), (scene.length, scene.lower), found.lengths()):
        if want is not None:
            checks.holds(abs(got - float(want)) <= LENGTH * max(1, float(want)), scene.name, name, float(want), "by slices", got)


def members(checks, program, args, scene, found):
    """Points next to ends of slices and between them."""
    cosine, sine, radius = TURN
    points, inside = [], []
    while len(points) < POINTS:
        x = F(args.random.randint(int(found.low * 1000) - 300, int(found.high * 1000) + 300), 1000) + F(1, 999983)
        cells = found.at(to_double(x))
        ends = [end for cell in cells for end in (cell[0], cell[2])] or [0.0]
        y = F(int((args.random.choice(ends) + args.random.gauss(0, found.width / 16)) * 1000), 1000)
        points.append(((cosine * x + sine * y) / radius, (cosine * y - sine * x) / radius))
        inside.append(any(cell[0] < to_double(y) < cell[2] for cell in cells))
    words = program.pmc(scene.name, scene.solid, scene.motion, points, scene.unsweep)
    for point, held, word in zip(points, inside, words or []):
        checks.holds(word == "on" or held == (word == "in"), scene.name, point, "by slices", held, "by classify", word)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    program = Program(args, checks)
    for scene in SCENES:
        found = Slices(scene.solid, scene.motion, scene.unsweep)
        agree(checks, scene, found)
        members(checks, program, args, scene, found)
    checks.finish()


if __name__ == "__main__":
    main()
