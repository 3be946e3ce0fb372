#!/usr/bin/env python3
"""Every decision of the filter, taken wrongly now and then, is noticed.

SPDX-License-Identifier: GPL-3.0-or-later

--graze is a program built with -DGRAZE_FLIP_SITES (make build/tests/graze-flips). With
GRAZE_FLIP_SITE=list in the environment it prints how many decision sites it has, the number alone
on a line, and lines `site K NAME`; with GRAZE_FLIP_SITE=K it turns the answer of site K around in
one call of 10^4, and says on standard error how many calls and flips there were. A flip is noticed
when the output is another, or the program ends with status 4. The files of points are long, so
that each site is called often enough, and cover single crossings, misses, coincidences, curved
pieces, negative weights and coordinates that doubles hold badly; the last ones are made for one
site each. A site that no file notices is a failure: it has no test, or it decides nothing. Not a
suite: it takes a minute.
"""
import json
import os
import random
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", *part.split("/")) for part in ("generate", "agree/lib", "lib")]

from adversaries import Scene, places, plane_adversaries, plane_solids  # noqa: E402
from adversaries import space_adversaries, space_solids, terrain  # noqa: E402
from exact import Fraction as F  # noqa: E402
from program import Checks, Graze, options, run  # noqa: E402
from queries import Maker, written  # noqa: E402

SECONDS = 600     # of one run; the exact path alone takes the longest
FAULT = 4         # the exit status of a fault of Graze itself

# solid, motion, place, format, and how many random, lattice and hard points
FILES = [
    ("comb", "across", "", "csv", 20000, 20000, 1000),
    ("terrain", "oblique", "", "csv", 12000, 6000, 500),
    ("ridges", "screw", "", "csv", 12000, 2000, 100),
    ("star", "weight", "", "csv", 4000, 2000, 500),
    ("holed", "legs", "thirds", "csv", 6000, 2000, 200),
    ("torus", "slide", "", "jsonl", 4000, 2000, 200),
    ("comb", "across", "", "jsonl", 2000, 4000, 2000),
]


class Query:
    """One command line whose output is compared; one of `judge` has no exact path to be held to."""

    def __init__(self, name, arguments, command="classify"):
        self.name, self.arguments, self.command = name, arguments, command
        self.usual = None

    def run(self, path, site=None, *flags):
        """(status, output, messages) in bytes."""
        environment = {k: v for k, v in os.environ.items() if k != "GRAZE_FLIP_SITE"}
        if site is not None:
            environment["GRAZE_FLIP_SITE"] = str(site)
        done = run([path, self.command, "--jobs", "1", *flags, *self.arguments], SECONDS, text=False,
                   env=environment)
        return done.returncode, done.stdout, done.stderr


def plane_query(graze, name, corners, transform, points, pieces=1):
    """A polygon under one transform of t in [0, pieces]."""
    ring = ", ".join(f"{x} {y}" for x, y in corners + corners[:1])
    motion = {"dimension": 2, "pieces": [{"t": [str(k), str(k + 1)], "transform": transform}
                                         for k in range(pieces)]}
    texts = (f"POLYGON(({ring}))\n", json.dumps(motion), "".join(f"{x},{y}\n" for x, y in points))
    paths = [graze.write(name.replace(" ", "_") + suffix, text)
             for suffix, text in zip((".wkt", ".json", ".csv"), texts)]
    return Query(name, paths)


def tip(graze, rng, count):
    """A sliver goes past points that its tip meets, or misses above by hairs that doubles lose.

    One of its two sides then has a root near the tip whose place is not certain, and the other none
    there: nothing but the certainty "inside" decides on the crossing. Both sides ask at a tip
    that is met exactly, and it does not matter what one of them says.
    """
    thin, points = F(1, 2 ** 20), []
    for _ in range(count):
        t = F(rng.randrange(1, 2 ** 20), 2 ** 20)
        hair = F(rng.randrange(16, 32), 2 ** rng.randrange(44, 64))
        points.append((7 * t + rng.choice((-1, 0, 1)) * hair, 3 * thin * t + hair))
    return plane_query(graze, "tip of a sliver", [(0, 0), (4, 0), (4, thin)],
                       {"translate": ["7*t", f"{3 * thin}*t"]}, points)


def corner_rays(graze, rng, count):
    """Points that stay inside, from which the filter's first ray (choose_direction in ray.c) runs
    into the corner (2, 0): what it meets first is never certain."""
    reach = [F(rng.randrange(1, 2 ** 18), 2 ** 20) for _ in range(count)]
    points = [(2 - F(3, 2) * 4 * r, F(561523, 10 ** 7) * 4 * r) for r in reach]
    return plane_query(graze, "rays into a corner", [(0, -2), (2, 0), (0, 2), (-2, 0)],
                       {"translate": ["t/1024", "0"]}, points)


def weights(graze, rng, count, pieces=1):
    """1 + (4 t - 2)^2 is positive, but its coefficients are 5, -3, 5. For (1, 0) the control points
    are (-3/5, 4/5), (-5/3, 0), (-3/5, -4/5): far from the square, where the trajectory is at 1/2."""
    quarter = F(1, 4)
    points = [(rng.uniform(0.75, 1.25), rng.uniform(-0.25, 0.25)) for _ in range(count)]
    square = [(1 - quarter, -quarter), (1 + quarter, -quarter), (1 + quarter, quarter),
              (1 - quarter, quarter)]
    return plane_query(graze, f"a negative weight, pieces {pieces}", square,
                       {"rotate": {"tan_half": "4*t-2"}}, points, pieces)


def through_tips(graze, rng, count):
    """From outside through the tip of a hole, which rests on the outer edge, into the hole. The edge is certainly
    crossed in its interior, and the point is never inside: only the certainty "alone" decides on that."""
    points = []
    for _ in range(count):
        t = F(rng.randrange(1, 2 ** 20), 2 ** 20)
        points.append((4 + t / 8, -2 * t))
    query = plane_query(graze, "tips of a hole", [(0, 0), (8, 0), (8, 8), (0, 8)],
                        {"translate": ["t/8", "-2*t"]}, points)
    with open(query.arguments[0], "w", encoding="ascii") as file:
        file.write("POLYGON((0 0, 8 0, 8 8, 0 8, 0 0), (4 0, 6 4, 4 6, 2 4, 4 0))\n")
    query.arguments += ["--columns", "pmc"]
    return query


TURN = {"rotate": {"axis": ["2/7", "3/7", "6/7"], "tan_half": "t"}}
# Points with -0.016 < z < 0.0016 go through z = 0 three times.
THRICE = {"translate": ["0", "0", "(t-1/10)*(t-1/5)*(t-4/5)"]}


def curved(graze, name, nodes, transform, points):
    """A union of curved bodies."""
    solid = json.dumps({"dimension": 3, "solid": {"union": nodes}})
    motion = json.dumps({"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": transform}]})
    points = written(3, [("", p) for p in points])
    texts = ((".csg.json", solid), (".json", motion), (".csv", points))
    return Query(name, [graze.write(name + suffix, text) for suffix, text in texts])


def ball(x, y, radius):
    return {"ball": {"center": [str(x), str(y), "1"], "radius": radius}}


def grid(graze, name, scene, sizes):
    """Points decided by cells, of all sizes beside the boundary."""
    paths = [graze.write(name + suffix, text) for suffix, text in zip((scene.solid.suffix, ".json"), scene.texts())]
    return Query(f"grid, {name}", [*paths, "--grid", sizes, "--columns", "pmc"])


def over_the_break(graze, rng, count):
    """A crossing on one side of a break point and a grazed tip, for the exact path, on the other.

    Nothing else is met, so the states between the two follow from the crossing's direction alone:
    one that is falsified is noticed by parity against an exact location, or not at all. Now and
    then comes a point without a tip, so that no call is always at the same place in its period.
    """
    corners = [(-4, -2), (4, -2), (4, 0), (2, 0), (2, 4), (1, 4), (1, 0), (-1, 0), (-2, 1), (-3, 0),
               (-4, 0)]
    starts = [F(rng.randrange(1, 2 ** 20), 2 ** 20) for _ in range(count)]
    for name, translate, first in (("crossing, break, tip", "2*t", F(11, 10)),
                                   ("tip, break, crossing", "-2*t", F(-29, 10))):
        points = [(first + F(8, 10) * s, 1 if k % 1000 else 3) for k, s in enumerate(starts)]
        yield plane_query(graze, name, corners, {"translate": [translate, "0"]}, points, 2)


def queries(graze, rng, scale):
    """The files of FILES and those made for one site, written, and two grids."""
    plane = plane_solids(), plane_adversaries()
    space = dict(space_solids(), ridges=terrain(20, random.Random(5))), space_adversaries()
    for k, (solid, motion, place, form, *counts) in enumerate(FILES):
        solids, motions = space if solid in space[0] and motion in space[1] else plane
        made = solids[solid]
        name = " ".join(filter(None, [solid, motion, place, form]))
        scene = Scene(name, made, motions[motion], places(made.dimension)[place])
        maker = Maker(scene, rng)
        doubles, lattice, hard = (n * scale for n in counts)
        points = maker.doubles(doubles) + maker.lattice(lattice) + maker.hard(hard)
        rng.shuffle(points)
        texts = scene.texts() + (written(scene.d, [("", scene.carry(p)) for p in points]),)
        paths = [graze.write(f"flip{k}{suffix}", text)
                 for suffix, text in zip((made.suffix, ".json", ".csv"), texts)]
        yield Query(name, [*paths, "--format", form])
    yield tip(graze, rng, 40000 * scale)
    yield corner_rays(graze, rng, 12000 * scale)
    yield weights(graze, rng, 12000 * scale)
    yield weights(graze, rng, 12000 * scale, 2)
    yield through_tips(graze, rng, 12000 * scale)
    rod = {"cylinder": {"point": ["0", "0", "1"], "axis": ["0", "0", "1"], "radius": "1", "from": "0", "to": "3"}}
    points = [[F(rng.uniform(-4, 4)) for _ in range(3)] for _ in range(12000 * scale)]
    yield curved(graze, "rod", [ball(0, 0, "1"), rod], TURN, points)
    yield curved(graze, "balls", [ball(x, y, "3/4") for x in range(-4, 5, 2) for y in range(-4, 5, 2)], TURN, points)
    points = [(0, 0, F(rng.uniform(-0.002, 0.0013))) for _ in range(24000 * scale)]
    yield curved(graze, "thrice", [{"halfspace": {"normal": ["0", "0", "1"], "offset": "0"}}], THRICE, points)
    yield grid(graze, "comb", Scene("comb", plane[0]["comb"], plane[1]["parabola"], places(2)[""]), "330,290")
    yield grid(graze, "torus", Scene("torus", space[0]["torus"], space[1]["slide"], places(3)[""]), "60,50,50")
    yield from over_the_break(graze, rng, 24000 * scale)


def plate():
    """A thin plate that rises and goes on in two legs more, against itself as a mesh: most cubes of
    space are known by facets that go through them, and by velocities."""
    names = [os.path.join(HERE, "..", "judge", name) for name in ("plate.off", "corner.json", "plate.off")]
    return Query("a plate judged", [*names, "--within", "2e-2r", "--no-points", "--format", "json"], "judge")


def sites(path, query):
    """({number: name}), empty for a program built without flips."""
    listed = query.run(path, "list")[1].decode()
    count = re.search(r"^(\d+)\s*$", listed, re.M)
    names = dict(re.findall(r"^site (\d+) (.*)$", listed, re.M))
    return {k: names.get(str(k), "") for k in range(int(count[1]) if count else 0)}


def prepare(path, checks, query):
    """Unflipped, the program agrees with its own exact path; this is what flips are held to."""
    query.usual = query.run(path)[:2]
    if query.command != "classify":
        checks.equal(query.usual[0], 0, query.name, "unflipped")
        return
    exact = query.run(path, None, "--no-filter")[:2]
    checks.equal(query.usual[0], 0, query.name, "unflipped")
    checks.holds(query.usual == exact, query.name, "unflipped, with and without the filter")


def noticed(path, query, site):
    """(how the flip shows, or None; what the program says of calls)."""
    status, output, messages = query.run(path, site)
    said = re.search(r"^flip: (.*)$", messages.decode(), re.M)
    calls = said[1] if said else "calls not counted"
    if status == FAULT:
        return "status 4", calls
    if status != 0:
        return f"status {status}", calls
    return "another answer" if output != query.usual[1] else None, calls


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)   # its folder goes when it goes
    everything = list(queries(graze, args.random, max(1, int(args.scale))))
    everything.insert(-2, plate())  # the last two are for one site
    found = sites(args.graze, everything[0])
    if not checks.holds(found, "no decision sites: is this a build with -DGRAZE_FLIP_SITES?"):
        checks.finish()
    for query in everything:
        prepare(args.graze, checks, query)
    for site, name in found.items():
        how = None
        for query in everything:
            how, calls = noticed(args.graze, query, site)
            print(f"site {site} {name}: {how or 'not noticed'} in {query.name}, {calls}", flush=True)
            if how:
                break
        # an end by a signal or without end is noticed too, but it is no way to fail
        checks.holds(how in ("status 4", "another answer"), f"site {site} {name}:",
                    how or "not noticed by any file")
        if name == "direction":
            for query in everything[-2:]:
                how, calls = noticed(args.graze, query, site)
                checks.equal(how, "status 4", f"site {site} {name} in {query.name}, {calls}:")
    checks.finish()


if __name__ == "__main__":
    main()
