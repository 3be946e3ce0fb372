#!/usr/bin/env python3
"""Runs contact_sampled.py on contact points of the scenes of this folder and prints the table of its README.

    python3 cases/candidates/contact_report.py --graze build/graze [--count N]

Points of `graze generate` are moved to contacts of their cells by `graze contact --snap`, whose table is the truth.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import csv
import os
import subprocess
import sys
import tempfile
from collections import Counter
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
SCENES = [("ell.off", "arch.json"), ("ell.off", "turn.json"), ("plate.wkt", "shear.json")]
SAMPLES = ("100", "1000")
EPS = "1e-9"
STATUSES = ["simple", "meets", "slides", "trimmed_near", "trimmed_far"]
# Between t and the nearest time in the interior, of points trimmed far: from the first to before the second.
BANDS = [(Fraction(0), Fraction(1, 256)), (Fraction(1, 256), Fraction(1, 32)), (Fraction(1, 32), Fraction(1, 4)),
         (Fraction(1, 4), Fraction(100))]


def rows_of(path):
    with open(path, encoding="ascii") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def run(command, path):
    with open(path, "w", encoding="ascii") as file:
        subprocess.run(command, stdout=file, check=True)


def truth(options, folder, solid, motion):
    """A table of contact points alone."""
    made, moved, golden = (os.path.join(folder, n) for n in ("made.csv", "moved.csv", "golden.csv"))
    run([options.graze, "generate", solid, motion, "-n", str(options.count), "--seed", "2", "--representable", "binary64",
         "--strata", "face=2,edge=2,vertex=1,start=1,end=1,break=1,slide=1", "--quiet"], made)
    run([options.graze, "contact", solid, motion, made, "--snap", "--quiet"], moved)
    with open(moved, encoding="ascii") as file, open(golden, "w", encoding="ascii") as out:
        names = None
        for line in file:
            if not line.startswith("#") and names is None:
                names = line.rstrip("\n").split(",")
            elif not line.startswith("#") and not line.split(",")[names.index("role")]:
                continue
            out.write(line)
    return golden


def middle(time):
    """A time as a number near enough for a band."""
    if time.startswith("root"):
        return sum(map(Fraction, time[:-1].split(";")[1:])) / 2
    return Fraction(time)


def keys_of(row):
    yield "all"
    yield row["status"]
    if row["status"] == "trimmed_far":
        apart = abs(middle(row["near_in"]) - Fraction(row["time"]))
        yield next(b for b in BANDS if b[0] <= apart < b[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--count", type=int, default=600)
    options = parser.parse_args()
    counts, wrong = Counter(), Counter()
    with tempfile.TemporaryDirectory() as folder:
        for solid, motion in SCENES:
            paths = os.path.join(HERE, solid), os.path.join(HERE, motion)
            golden = truth(options, folder, *paths)
            for n in SAMPLES:
                answers = os.path.join(folder, "answers.csv")
                run([sys.executable, os.path.join(HERE, "contact_sampled.py"), *paths, golden, n, EPS], answers)
                for row, given in zip(rows_of(golden), rows_of(answers)):
                    for key in keys_of(row):
                        counts[n, key] += 1
                        for column in ("role", "trimmed", "status"):
                            wrong[n, key, column] += row[column] != given[column]
    head = [f"{column}, {n}" for n in SAMPLES for column in ("role", "trimmed", "status")]
    print("| | rows | " + " | ".join(head) + " |\n|---|--:|" + "--:|" * len(head))
    names = {b: f"near_in − t from {b[0]} to {b[1]}" for b in BANDS}
    for key in ["all", *STATUSES, *BANDS]:
        cells = [str(wrong[n, key, column]) for n in SAMPLES for column in ("role", "trimmed", "status")]
        print(f"| {names.get(key, key)} | {counts[SAMPLES[0], key]} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
