#!/usr/bin/env python3
"""Every decision of the filter, taken wrongly now and then, is noticed.

SPDX-License-Identifier: GPL-3.0-or-later

--graze is a program built with -DGRAZE_FLIP_SITES. With GRAZE_FLIP_SITE=list in the environment it
prints how many decision sites it has, the number alone on a line, and perhaps lines `site K NAME`;
with GRAZE_FLIP_SITE=K it turns the answer of site K around in one call of 10^4. A flip is noticed
when the output is another, or the program ends with status 4. The files of points are long, so
that each site is called often enough, and cover single crossings, misses, coincidences, curved
pieces, negative weights, and coordinates that doubles hold badly. A site that no file notices is a
failure: it has no test, or it decides nothing. Not a suite: it takes minutes.
"""
import os
import random
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", *part.split("/")) for part in ("generate", "agree/lib")]

from adversaries import Scene, places, plane_adversaries, plane_solids  # noqa: E402
from adversaries import space_adversaries, space_solids, terrain  # noqa: E402
from harness import Checks, Graze, options  # noqa: E402
from queries import Maker, written  # noqa: E402

SECONDS = 600     # of one run; the exact path alone takes the longest
FAULT = 4         # the exit status of a fault of Graze itself

# solid, motion, place, format, and how many random, lattice and hard points
FILES = [
    ("terrain", "oblique", "", "csv", 12000, 6000, 2000),
    ("ridges", "screw", "", "csv", 12000, 2000, 1000),
    ("comb", "across", "", "csv", 20000, 20000, 4000),
    ("star", "weight", "", "csv", 20000, 4000, 2000),
    ("cube", "weight", "", "csv", 12000, 4000, 2000),
    ("holed", "rotation", "", "csv", 12000, 2000, 2000),
    ("ridges", "oblique", "", "jsonl", 12000, 2000, 0),
    ("torus", "slide", "", "jsonl", 6000, 6000, 2000),
    ("ring", "sextic", "", "csv", 12000, 2000, 4000),
    ("ell", "nine turns", "", "csv", 2000, 200, 100),
    ("holed", "legs", "thirds", "csv", 8000, 4000, 2000),
    ("terrain", "screw", "far", "csv", 2000, 200, 200),
    ("decades", "legs", "", "csv", 6000, 4000, 2000),
    ("needles", "oblique", "", "csv", 8000, 2000, 2000),
    ("star", "parabola", "subnormal", "csv", 6000, 2000, 1000),
    ("pinch", "rotation", "boundless", "csv", 2000, 1000, 200),
]


class Query:
    """One command line whose output is compared."""

    def __init__(self, name, arguments):
        self.name, self.arguments = name, arguments
        self.usual = None

    def run(self, path, site=None, *flags):
        """(status, output); status 124 stands for a run without end."""
        environment = {k: v for k, v in os.environ.items() if k != "GRAZE_FLIP_SITE"}
        if site is not None:
            environment["GRAZE_FLIP_SITE"] = str(site)
        try:
            done = subprocess.run([path, "classify", "--jobs", "1", *flags, *self.arguments],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                  timeout=SECONDS, env=environment)
        except subprocess.TimeoutExpired:
            return 124, b""
        return done.returncode, done.stdout


def queries(graze, rng, scale):
    """The files of FILES, written."""
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


def sites(path, query):
    """({number: name}), empty for a program built without flips."""
    listed = query.run(path, "list")[1].decode()
    count = re.search(r"^(\d+)\s*$", listed, re.M)
    names = dict(re.findall(r"^site (\d+) (.*)$", listed, re.M))
    return {k: names.get(str(k), "") for k in range(int(count[1]) if count else 0)}


def prepare(path, checks, query):
    """Unflipped, the program agrees with its own exact path; this is what flips are held to."""
    query.usual = query.run(path)
    exact = query.run(path, None, "--no-filter")
    checks.equal(query.usual[0], 0, query.name, "unflipped")
    checks.true(query.usual == exact, query.name, "unflipped, with and without the filter")


def noticed(path, query, site):
    """How the flip shows, or None."""
    status, output = query.run(path, site)
    if status == FAULT:
        return "status 4"
    if status != 0:
        return f"status {status}"
    return "another answer" if output != query.usual[1] else None


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)   # its folder goes when it goes
    everything = list(queries(graze, args.random, args.scale))
    found = sites(args.graze, everything[0])
    if not checks.true(found, "no decision sites: is this a build with -DGRAZE_FLIP_SITES?"):
        checks.finish()
    for query in everything:
        prepare(args.graze, checks, query)
    for site, name in found.items():
        how = None
        for query in everything:
            how = noticed(args.graze, query, site)
            if how:
                print(f"site {site} {name}: {how} in {query.name}", flush=True)
                break
        # an end by a signal or without end is noticed too, but it is no way to fail
        checks.true(how in ("status 4", "another answer"), f"site {site} {name}:",
                    how or "not noticed by any file")
    checks.finish()


if __name__ == "__main__":
    main()
