#!/usr/bin/env python3
"""Holds `graze collide --closest` and `--clearance` to the distances of FCL and Bullet at 1,000 times, on the families of fcl.py and round_bodies.py.

    python3 cases/candidates/distances.py --graze build/graze [--count N] [--only FAMILY]

At none of the times may a code find a distance below the enclosure of the least one. At a clearance above a distance that it finds, the word
has an I: at that time they are nearer. Codes find distances in doubles, to TOLERANCE. Exit status 1: a contradiction.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import random
import subprocess
import sys
import tempfile

import fcl
import round_bodies

TIMES, TOLERANCE = 1000, 1e-5
SHAPES = {"fcl": "mesh", "bullet": "hull"}


def least(program, shape, paths, more):
    """The least distance at the times; overlaps count as 0, and so does a body that a boundary surrounds, for codes that see it."""
    moving, path, fixed = paths
    run = subprocess.run([program, shape, moving, fixed, *more], input=f"distance {TIMES} {path}\n", check=True, stdout=subprocess.PIPE, text=True)
    return max(0.0, float(run.stdout.splitlines()[1].split()[0].split("=")[1]))


def contradictions(graze, ours, distances):
    """Sentences."""
    low = fcl.collide(graze, ours, "--closest", "1e-9")["closest"]["low"]
    for code, distance in distances.items():
        if distance < low - TOLERANCE:
            yield f"{code} finds {distance}, the least distance is at least {low}"
        word = fcl.collide(graze, ours, "--clearance", repr(distance + TOLERANCE))["word"]
        if "I" not in word:
            yield f"{code} finds {distance}, the word at that and {TOLERANCE} is {word}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--count", type=int, default=10, help="pairs a family")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="one family")
    options = parser.parse_args()
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        programs = fcl.compile_codes(folder)
        for module in (fcl, round_bodies):
            for name in (name for name in module.FAMILIES if options.only in (None, name)):
                rng, found = random.Random(options.seed), []
                for _ in range(options.count):
                    ours, theirs, more = module.written(folder, *module.FAMILIES[name](rng))
                    found += contradictions(options.graze, ours, {code: least(programs[code], SHAPES[code], theirs, more) for code in programs})
                wrong += len(found)
                print(f"{name}: {options.count} pairs, {len(found)} contradictions", *found, sep="\n  ", flush=True)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
