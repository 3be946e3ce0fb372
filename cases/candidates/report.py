#!/usr/bin/env python3
"""Runs the candidates on the scenes of this folder and prints the table of its README.

    python3 cases/candidates/report.py --graze build/graze [--count N] [--reports FOLDER]

Compiles both programs into a temporary folder. With --reports the Markdown reports of `graze
validate` are left there.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
SCENES = [("arch", "ell.off", "arch.json"), ("turn", "ell.off", "turn.json"),
          ("shear", "plate.wkt", "shear.json")]
# Program, its parameter, what `on` counts as.
CANDIDATES = [("sampled", "100", "any"), ("sampled", "1000", "any"), ("sampled", "100", "out"),
              ("sampled", "1000", "out"), ("ei_double", "1e-6", "on"), ("ei_double", "1e-9", "on")]
STRATA = ["random", "near", "crossing", "face", "edge", "vertex", "slide", "start", "end", "break",
          "miss"]
BANDS = [(4, 7), (8, 15), (16, 24), (25, 32), (33, 48), (49, 1000)]


def compile_programs(folder):
    for name in ("sampled", "ei_double"):
        sources = [os.path.join(HERE, f) for f in (name + ".c", "scene.c", "motion.c")]
        subprocess.run(["cc", "-std=c11", "-D_POSIX_C_SOURCE=200809L", "-O2", "-o",
                        os.path.join(folder, name)] + sources + ["-lyajl", "-lm"], check=True)


def keep_report(path, folder):
    """Copy a report; the folder that held its tables is gone and stays unnamed."""
    with open(path, encoding="utf-8") as file:
        text = re.sub(r"^(golden|candidate): .*/", r"\1: ", file.read(), flags=re.M)
    with open(os.path.join(folder, os.path.basename(path)), "w", encoding="utf-8") as file:
        file.write(text)


def validate(options, folder, candidate, scene):
    """The report of one candidate on one scene, as read from its JSON."""
    program, parameter, on_as = candidate
    name, solid, motion = scene
    title = f"{program}-{parameter}-{name}" + (f"-on-as-{on_as}" if on_as != "on" else "")
    stem = os.path.join(folder, title)
    command = [options.graze, "validate", os.path.relpath(os.path.join(HERE, solid)),
               os.path.relpath(os.path.join(HERE, motion)), "-n", str(options.count), "--seed", "1",
               "--representable", "binary64", "--show", "3", "--output", stem, "--candidate",
               f"{program} {parameter} {{solid}} {{motion}} {{points}} {{out}}", "--on-as", on_as]
    environment = dict(os.environ, PATH=folder + os.pathsep + os.environ["PATH"])
    done = subprocess.run(command, env=environment)
    if done.returncode not in (0, 1):
        sys.exit(f"{' '.join(command)}: ended with {done.returncode}")
    if options.reports:
        keep_report(stem + ".md", options.reports)
    with open(stem + ".json", encoding="utf-8") as file:
        return json.load(file)["comparison"]


def share(groups):
    """Wrong rows of all groups, in percent."""
    rows = sum(g["rows"] for g in groups)
    wrong = sum(g["wrong"] for g in groups)
    return f"{wrong} of {rows} ({100 * wrong / rows:.1f} %)" if rows else "-"


def table(reports):
    """Lines of the table: a row a stratum and a distance, a column a candidate."""
    yield "| | " + " | ".join(f"{p} {v}, `on` as {a}" if a != "on" else f"{p} {v}"
                              for p, v, a in CANDIDATES) + " |"
    yield "|---|" + "--:|" * len(CANDIDATES)
    yield "| all | " + " | ".join(share(reports[c]) for c in CANDIDATES) + " |"
    for stratum in STRATA:
        yield f"| {stratum} | " + " | ".join(
            share([g for r in reports[c] for g in r["by"]["stratum"] if g["value"] == stratum])
            for c in CANDIDATES) + " |"
    for low, high in BANDS:
        label = f"2^-{low} to 2^-{high}" if high < 1000 else f"2^-{low} and less"
        yield f"| at {label} | " + " | ".join(
            share([g for r in reports[c] for g in r["by"]["k"] if low <= int(g["value"]) <= high])
            for c in CANDIDATES) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--graze", required=True)
    parser.add_argument("--count", type=int, default=4000, help="points of each scene")
    parser.add_argument("--reports", help="leave the reports there")
    options = parser.parse_args()
    options.graze = os.path.abspath(options.graze)
    with tempfile.TemporaryDirectory() as folder:
        compile_programs(folder)
        if options.reports:
            os.makedirs(options.reports, exist_ok=True)
        reports = {c: [validate(options, folder, c, s) for s in SCENES] for c in CANDIDATES}
    print("\n".join(table(reports)))


if __name__ == "__main__":
    main()
