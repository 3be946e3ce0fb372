#!/usr/bin/env python3
"""Draws how often codes err, against the distance of a point to the boundary of the sweep.

    python3 cases/benchmark/picture.py RESULTS PICTURE.svg

RESULTS is results.jsonl of codes.py. A line a code and setting, over all scenes that it answered: the share of wrong
answers among the `in` and `out` points of each power of ten of their proved distance, in parts of the diagonal of the
solid's box. Points nearer than 10^-12 are at the left end; a power of ten with fewer than LEAST points has no mark,
and the line a gap.
Needs Debian's python3-matplotlib; the same results give the same bytes with one version of it.
SPDX-License-Identifier: CC0-1.0
"""
import json
import math
import sys

LEAST = 20
NEAREST = 1e-13  # where points below 10^-12 are drawn
FLOOR = 1e-5     # where no error is drawn


def shares(lines):
    """(distance, share of wrong answers) of the powers of ten, over all scenes."""
    parts = {}
    for line in lines:
        for decade in line["decades"]:
            part = parts.setdefault(decade["from"] or NEAREST, [0, 0])
            part[0] += decade["wrong"]
            part[1] += decade["points"]
    return [(at, wrong / points if points >= LEAST else math.nan) for at, (wrong, points) in sorted(parts.items())]


def draw(groups, path):
    import matplotlib  # here, so that what is drawn can be computed without it
    matplotlib.use("svg")
    matplotlib.rcParams.update({"svg.hashsalt": "graze", "svg.fonttype": "none", "font.size": 9})
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(figsize=(9, 4.2))
    marks = "os^v"
    colours = {name: f"C{k}" for k, name in enumerate(dict.fromkeys(code for code, _ in groups))}
    seen = dict.fromkeys(colours, 0)
    for (code, setting), lines in groups.items():
        points = shares(lines)
        axes.plot([x for x, _ in points], [y if math.isnan(y) else max(y, FLOOR) for _, y in points], color=colours[code], marker=marks[seen[code]], markersize=4,
                  linestyle=("-", "--", ":", "-.")[seen[code]], linewidth=1.2, label=f"{code}, {setting} ({len(lines)} scenes)")
        seen[code] += 1
    axes.set(xscale="log", yscale="log", xlabel="proved distance to the boundary of the sweep, of the diagonal: a mark for 10^k to 10^(k+1)",
             ylabel="wrong answers (at the foot: none)", ylim=(FLOOR * 0.8, 1))
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1.01, 1), frameon=False)
    figure.tight_layout()
    figure.savefig(path, format="svg", metadata={"Date": None, "Creator": None})


def by_code(path):
    """(code, setting) -> the lines with a score."""
    groups = {}
    with open(path, encoding="utf-8") as file:
        for line in map(json.loads, file):
            if "failure" not in line:
                groups.setdefault((line["code"], line["setting"]), []).append(line)
    return groups


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: picture.py RESULTS PICTURE.svg")
    draw(by_code(sys.argv[1]), sys.argv[2])


if __name__ == "__main__":
    main()
