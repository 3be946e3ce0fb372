#!/usr/bin/env python3
"""Runs contact_sampled.py on contact points of the scenes of this folder and prints the table of its README.

    python3 cases/candidates/contact_report.py --graze build/graze [--count N]

Points of `graze generate` are moved to contacts of their cells by `graze contact --snap`, whose table is the truth, with a
band in place of its column `stratum`; `graze compare` judges each column of the answers by status and band.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import json
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
COLUMNS = ("role", "trimmed", "status")
STATUSES = ["simple", "meets", "slides", "trimmed_near", "trimmed_far"]
# Between t and the nearest time in the interior, of points trimmed far: from the first to before the second.
BANDS = [(Fraction(0), Fraction(1, 256)), (Fraction(1, 256), Fraction(1, 32)), (Fraction(1, 32), Fraction(1, 4)),
         (Fraction(1, 4), Fraction(100))]


def run(command, path):
    with open(path, "w", encoding="ascii") as file:
        subprocess.run(command, stdout=file, check=True)


def truth(options, folder, solid, motion):
    """A table of contact points alone; the stratum of a point trimmed far is its band."""
    made, moved, golden = (os.path.join(folder, n) for n in ("made.csv", "moved.csv", "golden.csv"))
    run([options.graze, "generate", solid, motion, "-n", str(options.count), "--seed", "2", "--representable", "binary64",
         "--strata", "face=2,edge=2,vertex=1,start=1,end=1,break=1,slide=1", "--quiet"], made)
    run([options.graze, "contact", solid, motion, made, "--snap", "--quiet"], moved)
    with open(moved, encoding="ascii") as file, open(golden, "w", encoding="ascii") as out:
        names, count = None, 0
        for line in file:
            cells = line.rstrip("\n").split(",")
            if line.startswith("# complete"):
                line = f"# complete {count}\n"
            elif not line.startswith("#") and names is None:
                names = cells
            elif not line.startswith("#"):
                row = dict(zip(names, cells))
                if not row["role"]:
                    continue
                row["stratum"] = band(row)
                line = ",".join(row[n] for n in names) + "\n"
                count += 1
            out.write(line)
    return golden


def middle(time):
    """A time as a number near enough for a band."""
    if time.startswith("root"):
        return sum(map(Fraction, time[:-1].split(";")[1:])) / 2
    return Fraction(time)


def band(row):
    if row["status"] != "trimmed_far":
        return "no band"
    apart = abs(middle(row["near_in"]) - Fraction(row["time"]))
    return next(name_of(b) for b in BANDS if b[0] <= apart < b[1])


def name_of(b):
    return f"near_in - t from {b[0]} to {b[1]}"


def judged(options, folder, golden, answers, column):
    """(rows, wrong) in a column of the answers: of all, by status and by band."""
    alone = os.path.join(folder, "alone.csv")
    with open(answers, encoding="ascii") as file, open(alone, "w", encoding="ascii") as out:
        names = file.readline().rstrip("\n").split(",")
        kept = [k for k, name in enumerate(names) if name == column or name not in COLUMNS]
        for line in [",".join(names) + "\n", *file]:
            out.write(",".join(line.rstrip("\n").split(",")[k] for k in kept) + "\n")
    told = json.loads(subprocess.run([options.graze, "compare", golden, alone, "--format", "json"], stdout=subprocess.PIPE,
                                     check=False).stdout)
    found = {"all": (told["rows"], told["wrong"] + told["missing"])}
    for group in told["by"]["status"] + told["by"]["stratum"]:
        found[group["value"]] = group["rows"], group["wrong"] + group["missing"]
    return found


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
                for column in COLUMNS:
                    for key, (rows, bad) in judged(options, folder, golden, answers, column).items():
                        counts[n, column, key] += rows
                        wrong[n, column, key] += bad
    head = [f"{column}, {n}" for n in SAMPLES for column in COLUMNS]
    print("| | rows | " + " | ".join(head) + " |\n|---|--:|" + "--:|" * len(head))
    for key in ["all", *STATUSES, *map(name_of, BANDS)]:
        cells = [str(wrong[n, column, key]) for n in SAMPLES for column in COLUMNS]
        print(f"| {key} | {counts[SAMPLES[0], COLUMNS[0], key]} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
